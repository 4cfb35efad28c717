//! Clouds over all that has been drawn: into a smaller picture first, which is laid over the whole one, or into it at once.

use crate::gpu::drawing::begin;
use crate::gpu::pipeline::{Bind, Drawing};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Of smaller pictures: pixels of the whole one along one of theirs.
const SCALES: [u32; 2] = [2, 4];

/// How they are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// From space.
    pub globe: bool,
    /// Pixels of the picture along one that is drawn: 1, 2 or 4.
    pub scale: u32,
    /// Each place in a cloud looks towards the sun.
    pub fine: bool,
}

impl Look {
    /// Every one that a frame asks for.
    pub fn all() -> [Self; 5] {
        let of = |globe, scale, fine| Self { globe, scale, fine };
        [of(false, 1, true), of(true, 1, true), of(false, 2, true), of(false, 4, false), of(true, 4, false)]
    }

    fn index(self) -> usize {
        Self::all().iter().position(|look| *look == self).unwrap_or(0)
    }
}

/// The composed shader of the clouds.
pub fn source(Look { globe, scale, fine }: Look) -> String {
    let definitions =
        format!("const GLOBE: bool = {globe};\nconst SCALE: f32 = {scale}.0;\nconst FINE: bool = {fine};\n");
    shader::composed(include_str!("../../shaders/clouds.wgsl"), &definitions)
}

/// The composed shader that lays a smaller picture over the whole one.
pub fn veil_source(scale: u32) -> String {
    shader::composed(include_str!("../../shaders/cloud_veil.wgsl"), &format!("const SCALE: f32 = {scale}.0;\n"))
}

/// The smaller picture.
struct Small {
    size: [u32; 2],
    scale: u32,
    view: wgpu::TextureView,
    read: wgpu::BindGroup,
}

/// The pass.
pub struct Clouds {
    depth_layout: wgpu::BindGroupLayout,
    veil_layout: wgpu::BindGroupLayout,
    drawings: [Drawing; 5],
    veils: [Drawing; 2],
    /// What may stand before clouds, and the group of it.
    depth: Option<(wgpu::TextureView, wgpu::BindGroup)>,
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
        let depth_layout = gpu.layout("clouds", fragment, &[Bind::Depth]);
        let veil_binds = [Bind::Depth, Bind::Texture(wgpu::TextureViewDimension::D2)];
        let veil_layout = gpu.layout("cloud veil", fragment, &veil_binds);
        let blending = wgpu::ColorTargetState {
            format,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::COLOR,
        };
        let drawings = Look::all().map(|look| {
            let groups = [frame, surface, &depth_layout];
            let target = if look.scale > 1 { FORMAT.into() } else { blending.clone() };
            gpu.drawing("clouds", (&source(look), "vertex"), &groups, &[], target, None)
        });
        let veils = SCALES.map(|scale| {
            let groups = [frame, &veil_layout];
            gpu.drawing("cloud veil", (&veil_source(scale), "vertex"), &groups, &[], blending.clone(), None)
        });
        Self { depth_layout, veil_layout, drawings, veils, depth: None, small: None, look: Look::all()[0] }
    }

    /// Takes the depth of what may stand before clouds.
    pub fn set_scene(&mut self, gpu: &Gpu, depth: &wgpu::TextureView) {
        let group = gpu.bind("clouds", &self.depth_layout, &[wgpu::BindingResource::TextureView(depth)]);
        (self.depth, self.small) = (Some((depth.clone(), group)), None);
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
        let Some((depth, depth_group)) = self.depth.as_ref().filter(|_| look.scale > 1) else { return };
        let scale = look.scale;
        if self.small.as_ref().is_none_or(|small| (small.size, small.scale) != (size, scale)) {
            let shape = Shape::picture(size[0].div_ceil(scale), size[1].div_ceil(scale));
            let view = texture::view(&gpu.texture("clouds", shape, FORMAT, wgpu::TextureUsages::RENDER_ATTACHMENT));
            let views = [depth, &view].map(wgpu::BindingResource::TextureView);
            let read = gpu.bind("cloud veil", &self.veil_layout, &views);
            self.small = Some(Small { size, scale, view, read });
        }
        let Some(small) = &self.small else { return };
        // Pixels at the rim of the part read those beside it.
        let [left, top, width, height] = area;
        let [first, last] = [[left, top], [left + width, top + height]];
        let first = first.map(|at| (at / scale).saturating_sub(2));
        let last = [0, 1].map(|axis: usize| (last[axis].div_ceil(scale) + 2).min(size[axis].div_ceil(scale)));
        let mut pass = begin(encoder, "clouds", &small.view, wgpu::Color::TRANSPARENT, None);
        pass.set_pipeline(&self.drawings[look.index()]);
        let part = [first[0], first[1], last[0] - first[0], last[1] - first[1]];
        draw_part(&mut pass, part, &[groups[0], groups[1], depth_group]);
    }

    /// Draws them over the part of a picture that they may be in (left, top, width, height). `groups`: bind groups 0 and 1.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, area: [u32; 4], [frame, surface]: [&wgpu::BindGroup; 2]) {
        match (&self.small, &self.depth) {
            (Some(small), _) if self.look.scale > 1 => {
                pass.set_pipeline(&self.veils[usize::from(small.scale == SCALES[1])]);
                draw_part(pass, area, &[frame, &small.read]);
            }
            (_, Some((_, depth))) => {
                pass.set_pipeline(&self.drawings[self.look.index()]);
                draw_part(pass, area, &[frame, surface, depth]);
            }
            _ => {}
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
