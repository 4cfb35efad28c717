//! The finished picture and its way onto egui's target.
//!
//! The renderer draws into a texture of its own, gamma-encoded. So egui alone can repaint (a tooltip, a slider) without drawing the sea
//! again. As large as the window in physical pixels it is copied texel for pixel, smaller it is stretched.

use std::sync::Arc;

use egui_wgpu::{CallbackResources, CallbackTrait, wgpu};

use crate::gpu::pipeline::{Bind, Drawing};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};

/// The copying pipeline and the texture it copies from.
pub struct Picture {
    pipeline: Drawing,
    layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    texture: wgpu::Texture,
    /// What the renderer draws into.
    pub view: wgpu::TextureView,
    group: Arc<wgpu::BindGroup>,
}

/// Format of the picture: gamma-encoded, 8 bits, no conversion on writing or reading.
pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// The composed shader for a target that gamma-encodes what it is given, or takes encoded values as they are.
pub fn source(target_encodes: bool) -> String {
    let definitions = format!("const TARGET_ENCODES = {target_encodes};");
    shader::composed(include_str!("../../shaders/blit.wgsl"), &definitions)
}

impl Picture {
    /// A picture of one pixel, to be copied onto a target of egui's format.
    pub fn new(gpu: &Gpu, target_format: wgpu::TextureFormat) -> Self {
        let binds = [Bind::Texture(wgpu::TextureViewDimension::D2), Bind::Sampler];
        let layout = gpu.layout("blit", wgpu::ShaderStages::FRAGMENT, &binds);
        let sampler = gpu.sampler("blit", wgpu::AddressMode::ClampToEdge, wgpu::MipmapFilterMode::Nearest);
        // egui prefers a target that takes gamma-encoded values as they are; an sRGB one encodes what it is given.
        let source = source(target_format.is_srgb());
        let pipeline = gpu.drawing("blit", (&source, "vertex"), &[&layout], &[], target_format, None);
        let (texture, view, group) = make(gpu, &layout, &sampler, [1, 1]);
        Self { pipeline, layout, sampler, texture, view, group }
    }

    /// Width and height in physical pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.texture.width(), self.texture.height()]
    }

    /// Makes the picture another size; its contents are lost.
    pub fn resize(&mut self, gpu: &Gpu, size: [u32; 2]) {
        if size != self.size() {
            (self.texture, self.view, self.group) = make(gpu, &self.layout, &self.sampler, size);
        }
    }

    /// What egui paints: this picture over the whole window.
    pub fn callback(&self) -> impl CallbackTrait + use<> {
        Copy { pipeline: self.pipeline.clone(), group: self.group.clone() }
    }
}

fn make(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    sampler: &wgpu::Sampler,
    [width, height]: [u32; 2],
) -> (wgpu::Texture, wgpu::TextureView, Arc<wgpu::BindGroup>) {
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
    let texture = gpu.texture("picture", Shape::picture(width, height), FORMAT, usage);
    let view = texture::view(&texture);
    let resources = [wgpu::BindingResource::TextureView(&view), wgpu::BindingResource::Sampler(sampler)];
    let group = gpu.bind("blit", layout, &resources);
    (texture, view, Arc::new(group))
}

struct Copy {
    pipeline: Drawing,
    group: Arc<wgpu::BindGroup>,
}

impl CallbackTrait for Copy {
    fn paint(&self, _: egui::PaintCallbackInfo, pass: &mut wgpu::RenderPass<'static>, _: &CallbackResources) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &*self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
