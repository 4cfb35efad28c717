//! What the renderer draws into: formats, and the textures whose size is the picture's.

use crate::gpu::Gpu;
use crate::gpu::texture::{self, Shape};

/// Format of the target that [`Renderer::render`](super::Renderer::render) draws into: display (gamma) values.
pub const TARGET_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
pub(super) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// What the scene's radiance is stored in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Radiance {
    /// 16-bit floats, for pictures.
    Half,
    /// 32-bit floats, for measured layers.
    Single,
}

impl Radiance {
    pub(super) fn format(self) -> wgpu::TextureFormat {
        match self {
            Self::Half => wgpu::TextureFormat::Rgba16Float,
            Self::Single => wgpu::TextureFormat::Rgba32Float,
        }
    }
}

/// The textures whose size is the picture's.
pub(super) struct Targets {
    pub(super) size: [u32; 2],
    /// Sky and land, as the sea sees them.
    pub(super) scene: wgpu::TextureView,
    pub(super) scene_depth: wgpu::TextureView,
    /// Everything.
    pub(super) radiance: wgpu::Texture,
    pub(super) depth: wgpu::TextureView,
}

impl Targets {
    pub(super) fn new(gpu: &Gpu, size: [u32; 2], format: wgpu::TextureFormat) -> Self {
        use wgpu::TextureUsages as T;
        let picture = Shape::picture(size[0], size[1]);
        let depth = |label| texture::view(&gpu.texture(label, picture, DEPTH_FORMAT, T::RENDER_ATTACHMENT));
        Self {
            size,
            scene: texture::view(&gpu.texture("scene", picture, format, T::RENDER_ATTACHMENT)),
            scene_depth: depth("scene depth"),
            radiance: gpu.texture("radiance", picture, format, T::RENDER_ATTACHMENT | T::COPY_SRC),
            depth: depth("depth"),
        }
    }
}

/// A render pass over one colour target; the depth, where there is one, begins infinitely far and is kept or not.
pub(super) fn begin<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    label: &str,
    colour: &wgpu::TextureView,
    clear: wgpu::Color,
    depth: Option<(&wgpu::TextureView, wgpu::StoreOp)>,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: colour,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(clear), store: wgpu::StoreOp::Store },
        })],
        depth_stencil_attachment: depth.map(|(view, store)| wgpu::RenderPassDepthStencilAttachment {
            view,
            // Reversed depth: 0 is infinitely far.
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}
