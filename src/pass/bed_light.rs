//! Light that waves gather on the bed, laid over the scene for an eye over the water.

use super::kind::{ByKind, Kind};
use crate::gpu::pipeline::Bind;
use crate::gpu::{Gpu, shader};

/// The kinds of pictures that it is laid over.
pub fn kinds() -> impl Iterator<Item = Kind> {
    Kind::all().filter(|kind| kind.fine && !kind.under_water && !kind.measured)
}

/// The composed shader of one of [`kinds`].
pub fn source(kind: Kind) -> String {
    shader::composed(include_str!("../../shaders/bed_light.wgsl"), &kind.definitions())
}

/// The pass.
pub struct BedLight {
    pipelines: ByKind,
    layout: wgpu::BindGroupLayout,
    read: Option<wgpu::BindGroup>,
}

impl BedLight {
    /// The pass over a colour of `format`, which blends; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(gpu: &Gpu, [frame, surface]: [&wgpu::BindGroupLayout; 2], format: wgpu::TextureFormat) -> Self {
        let binds = [Bind::Depth, Bind::Texels(wgpu::TextureViewDimension::D2)];
        let layout = gpu.layout("bed light", wgpu::ShaderStages::FRAGMENT, &binds);
        // What is there times what the shader returns.
        let product = wgpu::BlendComponent {
            src_factor: wgpu::BlendFactor::Zero,
            dst_factor: wgpu::BlendFactor::Src,
            operation: wgpu::BlendOperation::Add,
        };
        let target = wgpu::ColorTargetState {
            format,
            blend: Some(wgpu::BlendState { color: product, alpha: product }),
            write_mask: wgpu::ColorWrites::ALL,
        };
        let groups = [frame, surface, &layout];
        let pipeline = |kind| gpu.drawing("bed light", (&source(kind), "vertex"), &groups, &[], target.clone(), None);
        Self { pipelines: ByKind::new(kinds(), pipeline), layout, read: None }
    }

    /// Takes the scene's depth and the map of caustics.
    pub fn set_scene(&mut self, gpu: &Gpu, depth: &wgpu::TextureView, caustics: &wgpu::TextureView) {
        let views = [depth, caustics].map(wgpu::BindingResource::TextureView);
        self.read = Some(gpu.bind("bed light", &self.layout, &views));
    }

    /// One triangle over the picture.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, kind: Kind, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        let Some(read) = &self.read else { return };
        if self.pipelines.set(pass, kind, frame, surface) {
            pass.set_bind_group(2, read, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}
