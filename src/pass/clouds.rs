//! Clouds over all that has been drawn: into a smaller picture first, which is laid over the whole one, or into it at once.

use crate::gpu::drawing::begin_both;
use crate::gpu::pipeline::{Bind, Drawing};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};

/// Of the smaller picture, and of how far its clouds are.
const FORMATS: [wgpu::TextureFormat; 2] = [wgpu::TextureFormat::Rgba16Float, wgpu::TextureFormat::Rg16Float];
/// How they are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// From space.
    pub globe: bool,
    /// Pixels of the picture along one that is drawn: 1, which none but pictures from space have, 2 or 4.
    pub scale: u32,
    /// Each place in a cloud looks towards the sun.
    pub fine: bool,
}

impl Look {
    /// Every one that a frame asks for.
    pub fn all() -> [Self; 4] {
        [[true, true], [true, false], [false, true], [false, false]].map(|[globe, fine]| Self::of(globe, fine))
    }

    /// Clouds have few sharp lines, and each of their pixels costs as much as many of the sea's: their picture is smaller than the whole. From
    /// space it is as fine as what lies below, unless it is a coarse one.
    pub fn of(globe: bool, fine: bool) -> Self {
        let scale = match (globe, fine) {
            (true, true) => 1,
            (false, true) => 2,
            (_, false) => 4,
        };
        Self { globe, scale, fine }
    }

    fn index(self) -> usize {
        2 * usize::from(!self.globe) + usize::from(!self.fine)
    }
}

/// The composed shader of the clouds.
pub fn source(Look { globe, scale, fine }: Look) -> String {
    let definitions =
        format!("const GLOBE: bool = {globe};\nconst SCALE: f32 = {scale}.0;\nconst FINE: bool = {fine};\n");
    shader::composed(include_str!("../../shaders/clouds.wgsl"), &definitions)
}

/// The composed shader that lays a smaller picture over the whole one.
pub fn veil_source(Look { globe, scale, .. }: Look) -> String {
    let definitions = format!("const GLOBE: bool = {globe};\nconst SCALE: f32 = {scale}.0;\n");
    shader::composed(include_str!("../../shaders/cloud_veil.wgsl"), &definitions)
}

/// The smaller picture.
struct Small {
    size: [u32; 2],
    scale: u32,
    views: [wgpu::TextureView; 2],
    read: wgpu::BindGroup,
}

/// The pass.
pub struct Clouds {
    veil_layout: wgpu::BindGroupLayout,
    drawings: [Drawing; 4],
    veils: [Drawing; 4],
    /// What may stand before clouds.
    depth: Option<wgpu::TextureView>,
    small: Option<Small>,
    look: Look,
}

impl Clouds {
    /// The pass into a colour that blends; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        format: wgpu::TextureFormat,
    ) -> Self {
        let fragment = wgpu::ShaderStages::FRAGMENT;
        let small = Bind::Texture(wgpu::TextureViewDimension::D2);
        let veil_binds = [Bind::Depth, small, small];
        let veil_layout = gpu.layout("cloud veil", fragment, &veil_binds);
        let blending = wgpu::ColorTargetState {
            format,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::COLOR,
        };
        let drawings = Look::all().map(|look| {
            let groups = [frame, surface];
            let targets = if look.scale > 1 { FORMATS.map(Into::into).to_vec() } else { vec![blending.clone()] };
            gpu.drawing_into("clouds", (&source(look), "vertex"), &groups, &[], &targets, None, 1)
        });
        let veils = Look::all().map(|look| {
            let groups = [frame, &veil_layout];
            gpu.drawing("cloud veil", (&veil_source(look), "vertex"), &groups, &[], blending.clone(), None)
        });
        Self { veil_layout, drawings, veils, depth: None, small: None, look: Look::of(true, true) }
    }

    /// Takes the depth of what may stand before clouds.
    pub fn set_scene(&mut self, depth: &wgpu::TextureView) {
        (self.depth, self.small) = (Some(depth.clone()), None);
    }

    /// Takes how clouds are drawn, and draws the smaller picture, where there is one, of the part (left, top, width, height) of a picture of
    /// `size` pixels that they may be in. `groups`: bind groups 0 and 1.
    pub fn sketch(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        (look, size, area): (Look, [u32; 2], [u32; 4]),
        groups: [&wgpu::BindGroup; 2],
    ) {
        self.look = look;
        let Some(depth) = self.depth.as_ref().filter(|_| look.scale > 1) else { return };
        let scale = look.scale;
        if self.small.as_ref().is_none_or(|small| (small.size, small.scale) != (size, scale)) {
            let shape = Shape::picture(size[0].div_ceil(scale), size[1].div_ceil(scale));
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
            let views = FORMATS.map(|format| texture::view(&gpu.texture("clouds", shape, format, usage)));
            let resources = [depth, &views[0], &views[1]].map(wgpu::BindingResource::TextureView);
            let read = gpu.bind("cloud veil", &self.veil_layout, &resources);
            self.small = Some(Small { size, scale, views, read });
        }
        let Some(small) = &self.small else { return };
        // Pixels at the rim of the part read those beside it.
        let [left, top, width, height] = area;
        let [first, last] = [[left, top], [left + width, top + height]];
        let first = first.map(|at| (at / scale).saturating_sub(2));
        let last = [0, 1].map(|axis: usize| (last[axis].div_ceil(scale) + 2).min(size[axis].div_ceil(scale)));
        let mut pass = begin_both(encoder, "clouds", &small.views);
        pass.set_pipeline(&self.drawings[look.index()]);
        let part = [first[0], first[1], last[0] - first[0], last[1] - first[1]];
        draw_part(&mut pass, part, &groups);
    }

    /// Draws them over the part of a picture that they may be in (left, top, width, height). `groups`: bind groups 0 and 1.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, area: [u32; 4], [frame, surface]: [&wgpu::BindGroup; 2]) {
        if self.look.scale == 1 {
            pass.set_pipeline(&self.drawings[self.look.index()]);
            draw_part(pass, area, &[frame, surface]);
        } else if let Some(small) = &self.small {
            pass.set_pipeline(&self.veils[self.look.index()]);
            draw_part(pass, area, &[frame, &small.read]);
        }
    }
}

/// One triangle over a part of the picture.
fn draw_part(pass: &mut wgpu::RenderPass, [left, top, width, height]: [u32; 4], groups: &[&wgpu::BindGroup]) {
    if width == 0 || height == 0 {
        return;
    }
    pass.set_scissor_rect(left, top, width, height);
    for (index, group) in (0..).zip(groups) {
        pass.set_bind_group(index, *group, &[]);
    }
    pass.draw(0..3, 0..1);
}
