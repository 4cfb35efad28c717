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

/// The depth of a render pass.
#[derive(Clone, Copy, Debug)]
pub enum DepthUse<'a> {
    /// It begins infinitely far, and is kept or not.
    Begun(&'a wgpu::TextureView, wgpu::StoreOp),
    /// That which another pass has found; it stays.
    Found(&'a wgpu::TextureView),
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

/// A render pass into two targets, transparent at first.
pub fn begin_both<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    label: &str,
    views: &'a [wgpu::TextureView; 2],
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &views.each_ref().map(|view| Some(transparent(view))),
        ..Default::default()
    })
}

fn transparent(view: &wgpu::TextureView) -> wgpu::RenderPassColorAttachment<'_> {
    let ops = wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT), store: wgpu::StoreOp::Store };
    wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops }
}

/// A render pass that finds what is nearest in each pixel: into two targets, whose texels count where the depth is not infinitely far.
pub fn begin_places<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    label: &str,
    views: &'a [wgpu::TextureView; 2],
    depth: &wgpu::TextureView,
) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &views.each_ref().map(|view| Some(transparent(view))),
        depth_stencil_attachment: Some(begun(depth, wgpu::StoreOp::Store)),
        ..Default::default()
    })
}

/// A depth that begins infinitely far. It is reversed: 0 is infinitely far.
fn begun(view: &wgpu::TextureView, store: wgpu::StoreOp) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    let depth_ops = Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store });
    wgpu::RenderPassDepthStencilAttachment { view, depth_ops, stencil_ops: None }
}

/// A render pass over one colour target, and through a depth where there is one.
pub fn begin<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    label: &str,
    colour: impl Into<Colour<'a>>,
    clear: wgpu::Color,
    depth: Option<DepthUse>,
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
        depth_stencil_attachment: depth.map(|depth| match depth {
            DepthUse::Begun(view, store) => begun(view, store),
            // What is only tested against is not written.
            DepthUse::Found(view) => {
                wgpu::RenderPassDepthStencilAttachment { view, depth_ops: None, stencil_ops: None }
            }
        }),
        ..Default::default()
    })
}
