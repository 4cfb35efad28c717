//! One triangle over a whole picture, which reads another picture texel by texel.

use super::Gpu;
use super::pipeline::{Bind, DepthTest, Drawing};

/// A pass of one such triangle.
pub struct FullScreen {
    label: &'static str,
    layout: wgpu::BindGroupLayout,
    pipeline: Drawing,
    group: Option<wgpu::BindGroup>,
}

impl FullScreen {
    /// A shader with the entry points `vertex` and `fragment`, whose group 0 holds the picture that is read, into a target of `format`
    /// and, where there is a depth, through its test.
    pub fn new(
        gpu: &Gpu,
        label: &'static str,
        source: &str,
        format: wgpu::TextureFormat,
        depth: Option<(wgpu::TextureFormat, DepthTest)>,
    ) -> Self {
        let binds = [Bind::Texels(wgpu::TextureViewDimension::D2)];
        let layout = gpu.layout(label, wgpu::ShaderStages::FRAGMENT, &binds);
        let pipeline = gpu.drawing(label, (source, "vertex"), &[&layout], &[], format, depth);
        Self { label, layout, pipeline, group: None }
    }

    /// Takes the picture to read; before it nothing is drawn.
    pub fn set_source(&mut self, gpu: &Gpu, picture: &wgpu::TextureView) {
        self.group = Some(gpu.bind(self.label, &self.layout, &[wgpu::BindingResource::TextureView(picture)]));
    }

    /// Draws it.
    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        let Some(group) = &self.group else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, group, &[]);
        pass.draw(0..3, 0..1);
    }
}
