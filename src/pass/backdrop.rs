//! Sky and land where no sea has been drawn over them: only these pixels of the scene are copied.

use crate::gpu::pipeline::{Bind, DepthTest, Drawing};
use crate::gpu::{Gpu, shader};

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/backdrop.wgsl"), "")
}

/// The pass.
pub struct Backdrop {
    layout: wgpu::BindGroupLayout,
    pipeline: Drawing,
    group: Option<wgpu::BindGroup>,
}

impl Backdrop {
    /// The pass into formats of colour and depth, the sea's.
    pub fn new(gpu: &Gpu, [colour, depth]: [wgpu::TextureFormat; 2]) -> Self {
        let binds = [Bind::Texels(wgpu::TextureViewDimension::D2)];
        let layout = gpu.layout("backdrop", wgpu::ShaderStages::FRAGMENT, &binds);
        let depth = Some((depth, DepthTest::Undrawn));
        let pipeline = gpu.drawing("backdrop", (&source(), "vertex"), &[&layout], &[], colour, depth);
        Self { layout, pipeline, group: None }
    }

    /// Takes the scene's radiance.
    pub fn set_scene(&mut self, gpu: &Gpu, scene: &wgpu::TextureView) {
        self.group = Some(gpu.bind("backdrop", &self.layout, &[wgpu::BindingResource::TextureView(scene)]));
    }

    /// One triangle over the picture.
    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
