//! What an eye in the sea sees but the surface: the bed and the water.

use super::kind::{ByKind, Kind};
use crate::gpu::pipeline::{Bind, Depth, DepthTest};
use crate::gpu::texture;
use crate::gpu::{Gpu, shader};

/// The kinds of pictures that show it.
pub fn kinds() -> impl Iterator<Item = Kind> {
    Kind::all().filter(|kind| kind.under_water && !kind.measured)
}

/// The composed shader of one of [`kinds`].
pub fn source(kind: Kind) -> String {
    shader::composed(include_str!("../../shaders/deep.wgsl"), &kind.definitions())
}

/// The pass.
pub struct Deep {
    pipelines: ByKind,
    caustics: wgpu::BindGroup,
}

impl Deep {
    /// The pass into `formats` of colour and depth; `frame` and `surface` are the layouts of bind groups 0 and 1, `caustics` is the map of
    /// light on the bed.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        caustics: &wgpu::Texture,
        [colour, depth]: [wgpu::TextureFormat; 2],
    ) -> Self {
        let binds = [Bind::Texels(wgpu::TextureViewDimension::D2)];
        let layout = gpu.layout("deep", wgpu::ShaderStages::FRAGMENT, &binds);
        let map = texture::view(caustics);
        let depth = Some(Depth::single(depth, DepthTest::Nearest));
        let groups = [frame, surface, &layout];
        let pipeline = |kind| gpu.drawing("deep", (&source(kind), "vertex"), &groups, &[], colour, depth);
        Self {
            pipelines: ByKind::new(kinds(), pipeline),
            caustics: gpu.bind("deep", &layout, &[wgpu::BindingResource::TextureView(&map)]),
        }
    }

    /// One triangle over the picture.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, kind: Kind, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        if self.pipelines.set(pass, kind, frame, surface) {
            pass.set_bind_group(2, &self.caustics, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}
