//! Clouds over all that has been drawn.

use crate::gpu::pipeline::{Bind, Drawing};
use crate::gpu::{Gpu, shader};

/// The composed shader, of the view from space or of another.
pub fn source(globe: bool) -> String {
    shader::composed(include_str!("../../shaders/clouds.wgsl"), &format!("const GLOBE: bool = {globe};\n"))
}

/// The pass.
pub struct Clouds {
    layout: wgpu::BindGroupLayout,
    near: Drawing,
    globe: Drawing,
    depth: Option<wgpu::BindGroup>,
}

impl Clouds {
    /// The pass into a colour that blends; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        format: wgpu::TextureFormat,
    ) -> Self {
        let layout = gpu.layout("clouds", wgpu::ShaderStages::FRAGMENT, &[Bind::Depth]);
        let target = wgpu::ColorTargetState {
            format,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::COLOR,
        };
        let [near, globe] = [false, true].map(|globe| {
            let groups = [frame, surface, &layout];
            gpu.drawing("clouds", (&source(globe), "vertex"), &groups, &[], target.clone(), None)
        });
        Self { layout, near, globe, depth: None }
    }

    /// Takes the depth of what may stand before clouds.
    pub fn set_scene(&mut self, gpu: &Gpu, depth: &wgpu::TextureView) {
        self.depth = Some(gpu.bind("clouds", &self.layout, &[wgpu::BindingResource::TextureView(depth)]));
    }

    /// One triangle over the part of the picture that clouds may be in (left, top, width, height), from space or not.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass,
        (globe, [left, top, width, height]): (bool, [u32; 4]),
        frame: &wgpu::BindGroup,
        surface: &wgpu::BindGroup,
    ) {
        let Some(depth) = self.depth.as_ref().filter(|_| width > 0 && height > 0) else { return };
        pass.set_scissor_rect(left, top, width, height);
        pass.set_pipeline(if globe { &self.globe } else { &self.near });
        for (index, group) in (0..).zip([frame, surface, depth]) {
            pass.set_bind_group(index, group, &[]);
        }
        pass.draw(0..3, 0..1);
    }
}
