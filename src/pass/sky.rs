//! The sky behind everything, drawn first over the whole picture.

use crate::gpu::{Gpu, shader};

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/sky.wgsl"), "")
}

/// The pass.
pub struct Sky {
    pipeline: wgpu::RenderPipeline,
}

impl Sky {
    /// The pass into a colour target of `format`; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        format: wgpu::TextureFormat,
    ) -> Self {
        Self { pipeline: gpu.drawing("sky", (&source(), "vertex"), &[frame, surface], &[], format, None) }
    }

    /// One triangle over the picture.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.draw(0..3, 0..1);
    }
}
