//! The earth from space: ground and sea in one disc, where nothing on the ellipsoid has a shape that shows.

use super::kind::{ByGround, Kind};
use crate::gpu::pipeline::{Depth, DepthTest};
use crate::gpu::{Gpu, shader};

/// Triangles of the disc; equals `RIM` in `shaders/globe.wgsl`.
pub const RIM: u32 = 64;

/// The composed shader of a kind of picture, with imagery or without.
pub fn source(kind: Kind, imagery: bool) -> String {
    shader::composed(include_str!("../../shaders/globe.wgsl"), &kind.ground_definitions(imagery))
}

/// The pass.
pub struct Globe {
    pipelines: ByGround,
}

impl Globe {
    /// The pass into formats of colour and depth; `groups` are the layouts of bind groups: frame, surface, imagery.
    pub fn new(gpu: &Gpu, groups: [&wgpu::BindGroupLayout; 3], [colour, depth]: [wgpu::TextureFormat; 2]) -> Self {
        let depth = Some(Depth::single(depth, DepthTest::Nearest));
        let pipeline =
            |kind, imagery| gpu.drawing("globe", (&source(kind, imagery), "vertex"), &groups, &[], colour, depth);
        let above_water = || Kind::all().filter(|kind| !kind.under_water);
        Self { pipelines: ByGround::new(above_water, pipeline) }
    }

    /// One disc, of a kind and with imagery or without; nothing from under the water.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, kind: (Kind, bool), groups: [&wgpu::BindGroup; 3]) {
        if self.pipelines.set(pass, kind, groups) {
            pass.draw(0..3 * RIM, 0..1);
        }
    }
}
