//! The earth from space: ground and sea in one disc, where nothing on the ellipsoid has a shape that shows.

use super::kind::{ByKind, Kind};
use crate::gpu::pipeline::{Depth, DepthTest};
use crate::gpu::{Gpu, shader};

/// Triangles of the disc; equals `RIM` in `shaders/globe.wgsl`.
pub const RIM: u32 = 64;

/// The composed shader of a kind of picture.
pub fn source(kind: Kind) -> String {
    shader::composed(include_str!("../../shaders/globe.wgsl"), &kind.definitions())
}

/// The pass.
pub struct Globe {
    pipelines: ByKind,
}

impl Globe {
    /// The pass into formats of colour and depth; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        [colour, depth]: [wgpu::TextureFormat; 2],
    ) -> Self {
        let depth = Some(Depth::single(depth, DepthTest::Nearest));
        let pipeline = |kind| gpu.drawing("globe", (&source(kind), "vertex"), &[frame, surface], &[], colour, depth);
        let above_water = Kind::all().filter(|kind| !kind.under_water);
        Self { pipelines: ByKind::new(above_water, pipeline) }
    }

    /// One disc; nothing from under the water.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, kind: Kind, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        if self.pipelines.set(pass, kind, frame, surface) {
            pass.draw(0..3 * RIM, 0..1);
        }
    }
}
