//! The sky behind everything, drawn where nothing else has been.

use super::kind::{ByKind, Kind};
use crate::gpu::pipeline::{Depth, DepthTest};
use crate::gpu::{Gpu, shader};

/// The composed shader of a kind of picture.
pub fn source(kind: Kind) -> String {
    shader::composed(include_str!("../../shaders/sky.wgsl"), &kind.definitions())
}

/// The pass.
pub struct Sky {
    pipelines: ByKind,
}

impl Sky {
    /// The pass into `formats` of colour and depth; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        [colour, depth]: [wgpu::TextureFormat; 2],
    ) -> Self {
        let depth = Some(Depth::single(depth, DepthTest::Undrawn));
        let pipeline = |kind| gpu.drawing("sky", (&source(kind), "vertex"), &[frame, surface], &[], colour, depth);
        Self { pipelines: ByKind::new(Kind::all(), pipeline) }
    }

    /// One triangle over the picture.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, kind: Kind, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        if self.pipelines.set(pass, kind, frame, surface) {
            pass.draw(0..3, 0..1);
        }
    }
}
