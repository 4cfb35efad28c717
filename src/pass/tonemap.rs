//! Scene radiance to display colours: the last pass, into whatever target the caller has.

use crate::gpu::pipeline::{Bind, Drawing};
use crate::gpu::{Gpu, shader};

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/tonemap.wgsl"), "")
}

/// The pass.
pub struct Tonemap {
    layout: wgpu::BindGroupLayout,
    pipeline: Drawing,
    group: Option<wgpu::BindGroup>,
}

impl Tonemap {
    /// The pass into a target of `format`, which takes display (gamma) values.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let binds = [Bind::Texels(wgpu::TextureViewDimension::D2)];
        let layout = gpu.layout("tonemap", wgpu::ShaderStages::FRAGMENT, &binds);
        let pipeline = gpu.drawing("tonemap", (&source(), "vertex"), &[&layout], &[], format, None);
        Self { layout, pipeline, group: None }
    }

    /// Takes the scene's radiance.
    pub fn set_scene(&mut self, gpu: &Gpu, radiance: &wgpu::TextureView) {
        self.group = Some(gpu.bind("tonemap", &self.layout, &[wgpu::BindingResource::TextureView(radiance)]));
    }

    /// One triangle over the picture.
    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
