//! The sky behind everything, drawn where nothing else has been.

use crate::gpu::pipeline::{DepthTest, Drawing};
use crate::gpu::{Gpu, shader};

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/sky.wgsl"), "")
}

/// The pass.
pub struct Sky {
    pipeline: Drawing,
}

impl Sky {
    /// The pass into `formats` of colour and depth; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        [colour, depth]: [wgpu::TextureFormat; 2],
    ) -> Self {
        let depth = Some((depth, DepthTest::Undrawn));
        Self { pipeline: gpu.drawing("sky", (&source(), "vertex"), &[frame, surface], &[], colour, depth) }
    }

    /// One triangle over the picture.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.draw(0..3, 0..1);
    }
}
