//! The glow around what is much brighter than the rest: light that a lens or an eye scatters. A pyramid of halves, summed from the
//! coarsest up.

use crate::gpu::drawing::begin;
use crate::gpu::full_screen::FullScreen;
use crate::gpu::pipeline::Bind;
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};

/// Halves of the picture.
const LEVELS: usize = 6;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// The composed shaders: a half of a picture, and the sum of a level and the coarser ones.
pub fn sources() -> [String; 2] {
    [include_str!("../../shaders/bloom_down.wgsl"), include_str!("../../shaders/bloom_up.wgsl")]
        .map(|text| shader::composed(text, ""))
}

/// The passes.
pub struct Bloom {
    down: FullScreen,
    up: FullScreen,
    clamped: wgpu::Sampler,
}

/// The glow of pictures of one size.
pub struct Glow {
    /// Targets and what is read, in the order of the passes.
    downs: Vec<(wgpu::TextureView, wgpu::BindGroup)>,
    ups: Vec<(wgpu::TextureView, wgpu::BindGroup)>,
    /// The glow, half as wide and high as the picture.
    pub view: wgpu::TextureView,
}

impl Bloom {
    /// The passes.
    pub fn new(gpu: &Gpu) -> Self {
        let picture = Bind::Texture(wgpu::TextureViewDimension::D2);
        let [down, up] = sources();
        Self {
            down: FullScreen::new(gpu, "bloom down", &down, &[picture, Bind::Sampler], FORMAT, None),
            up: FullScreen::new(gpu, "bloom up", &up, &[picture, picture, Bind::Sampler], FORMAT, None),
            clamped: gpu.sampler("clamped", wgpu::AddressMode::ClampToEdge, wgpu::MipmapFilterMode::Nearest),
        }
    }

    /// The textures of pictures of `size`, which are read from `radiance`.
    pub fn glow(&self, gpu: &Gpu, size: [u32; 2], radiance: &wgpu::TextureView) -> Glow {
        let views = |label| -> Vec<wgpu::TextureView> {
            let half = |level: usize| size.map(|side| (side >> (level + 1)).max(1));
            let shape = |level| Shape::picture(half(level)[0], half(level)[1]);
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
            (0..LEVELS).map(|level| texture::view(&gpu.texture(label, shape(level), FORMAT, usage))).collect()
        };
        let (halves, glows) = (views("bloom half"), views("bloom"));
        let read = |pass: &FullScreen, pictures: &[&wgpu::TextureView]| {
            let pictures = pictures.iter().map(|view| wgpu::BindingResource::TextureView(view));
            let resources: Vec<_> = pictures.chain([wgpu::BindingResource::Sampler(&self.clamped)]).collect();
            pass.read(gpu, &resources)
        };
        let downs = (0..LEVELS)
            .map(|level| {
                let whole = if level == 0 { radiance } else { &halves[level - 1] };
                (halves[level].clone(), read(&self.down, &[whole]))
            })
            .collect();
        let ups = (0..LEVELS - 1)
            .rev()
            .map(|level| {
                let coarser = if level == LEVELS - 2 { &halves[level + 1] } else { &glows[level + 1] };
                (glows[level].clone(), read(&self.up, &[&halves[level], coarser]))
            })
            .collect();
        Glow { downs, ups, view: glows[0].clone() }
    }

    /// What a pass reads that shows a picture with its glow.
    pub fn read_with(
        &self,
        gpu: &Gpu,
        shown: &FullScreen,
        radiance: &wgpu::TextureView,
        filter: &wgpu::Buffer,
        glow: &Glow,
    ) -> wgpu::BindGroup {
        let [radiance, glow] = [radiance, &glow.view].map(wgpu::BindingResource::TextureView);
        shown.read(gpu, &[radiance, filter.as_entire_binding(), glow, wgpu::BindingResource::Sampler(&self.clamped)])
    }

    /// The passes of a frame.
    pub fn draw(&self, encoder: &mut wgpu::CommandEncoder, glow: &Glow) {
        for (pass, steps) in [(&self.down, &glow.downs), (&self.up, &glow.ups)] {
            for (target, group) in steps {
                pass.draw(&mut begin(encoder, "bloom", target, wgpu::Color::BLACK, None), group);
            }
        }
    }
}
