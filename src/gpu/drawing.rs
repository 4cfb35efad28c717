//! The beginning of a render pass.

/// What a render pass draws into.
#[derive(Clone, Copy, Debug)]
pub struct Colour<'a> {
    /// One sample of a pixel, or several.
    pub view: &'a wgpu::TextureView,
    /// Where the mean of several goes, instead of themselves.
    pub mean: Option<&'a wgpu::TextureView>,
}

impl<'a> From<&'a wgpu::TextureView> for Colour<'a> {
    fn from(view: &'a wgpu::TextureView) -> Self {
        Self { view, mean: None }
    }
}

/// A render pass over what a target holds.
pub fn resume<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    label: &str,
    view: &'a wgpu::TextureView,
) -> wgpu::RenderPass<'a> {
    let ops = wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store };
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops,
        })],
        ..Default::default()
    })
}

/// A render pass over one colour target; the depth, where there is one, begins infinitely far and is kept or not.
pub fn begin<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    label: &str,
    colour: impl Into<Colour<'a>>,
    clear: wgpu::Color,
    depth: Option<(&wgpu::TextureView, wgpu::StoreOp)>,
) -> wgpu::RenderPass<'a> {
    let Colour { view, mean } = colour.into();
    let store = if mean.is_some() { wgpu::StoreOp::Discard } else { wgpu::StoreOp::Store };
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: mean,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(clear), store },
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
