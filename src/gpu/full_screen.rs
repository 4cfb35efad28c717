//! One triangle over a whole picture, which reads other pictures.

use super::Gpu;
use super::pipeline::{Bind, Depth, Drawing};

/// A pass of one such triangle.
pub struct FullScreen {
    label: &'static str,
    layout: wgpu::BindGroupLayout,
    pipeline: Drawing,
}

impl FullScreen {
    /// A shader with the entry points `vertex` and `fragment`, whose group 0 holds `binds`, into a target of `format` and, where there
    /// is a depth, through its test.
    pub fn new(
        gpu: &Gpu,
        label: &'static str,
        source: &str,
        binds: &[Bind],
        format: wgpu::TextureFormat,
        depth: Option<Depth>,
    ) -> Self {
        let layout = gpu.layout(label, wgpu::ShaderStages::FRAGMENT, binds);
        let pipeline = gpu.drawing(label, (source, "vertex"), &[&layout], &[], format, depth);
        Self { label, layout, pipeline }
    }

    /// What is to be read.
    pub fn read(&self, gpu: &Gpu, resources: &[wgpu::BindingResource]) -> wgpu::BindGroup {
        gpu.bind(self.label, &self.layout, resources)
    }

    /// Draws it.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, group: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, group, &[]);
        pass.draw(0..3, 0..1);
    }
}
