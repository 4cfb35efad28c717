//! What the renderer draws into: formats, and the textures whose size is the picture's.

use crate::gpu::Gpu;
use crate::gpu::drawing::{Colour, begin};
use crate::gpu::full_screen::FullScreen;
use crate::gpu::texture::{self, Shape};
use crate::pass::bloom::{Bloom, Glow};
use crate::pass::{backdrop, tonemap};
use crate::scene::frame::sky_filter::SkyFilter;

/// Format of the target that [`Renderer::render`](super::Renderer::render) draws into: display (gamma) values.
pub const TARGET_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
pub(super) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// What the radiance of pictures is stored in.
pub(super) const PICTURE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// Samples of a pixel where edges are smooth.
pub(super) const SAMPLES: u32 = 4;

/// What the scene's radiance is stored in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Radiance {
    /// 16-bit floats, for pictures.
    Half,
    /// 32-bit floats of surfaces and clear air alone, for measured layers: without what is blended with them, which is clouds, stars, lamps, spindrift,
    /// the light that waves gather on a bed, and a surface that cuts through the picture.
    Single,
    /// All of a picture's radiance, one sample a pixel: 32-bit floats where the device blends those, else as [`Radiance::Half`].
    Whole,
}

impl Radiance {
    pub(super) fn format(self, gpu: &Gpu) -> wgpu::TextureFormat {
        let single = match self {
            Self::Half => false,
            Self::Single => true,
            Self::Whole => gpu.device.features().contains(wgpu::Features::FLOAT32_BLENDABLE),
        };
        if single { wgpu::TextureFormat::Rgba32Float } else { PICTURE_FORMAT }
    }

    /// Whether the radiance has what is blended, too.
    pub(super) fn blends(self) -> bool {
        self != Self::Single
    }
}

/// The passes over whole pictures.
pub(super) struct Passes {
    /// With one sample of a pixel, and with [`SAMPLES`].
    backdrops: [FullScreen; 2],
    bloom: Bloom,
    /// The tone alone.
    plain: FullScreen,
    /// And through a lens, which glows.
    glowing: FullScreen,
    /// What darkens the sky.
    sky_filter: wgpu::Buffer,
}

impl Passes {
    /// Those of scenes whose radiance is stored as `radiance`.
    pub(super) fn new(gpu: &Gpu, radiance: wgpu::TextureFormat) -> Self {
        use wgpu::BufferUsages as U;
        Self {
            backdrops: [1, SAMPLES].map(|samples| backdrop::pass(gpu, [radiance, DEPTH_FORMAT], samples)),
            bloom: Bloom::new(gpu),
            plain: tonemap::pass(gpu, TARGET_FORMAT, false),
            glowing: tonemap::pass(gpu, TARGET_FORMAT, true),
            sky_filter: gpu.empty_buffer("sky filter", U::UNIFORM | U::COPY_DST, 16),
        }
    }

    /// The scene where the sea has left it.
    pub(super) fn draw_backdrop(&self, pass: &mut wgpu::RenderPass, targets: &Targets) {
        self.backdrops[usize::from(targets.samples.is_some())].draw(pass, &targets.backdrop);
    }

    /// Takes what darkens the sky of the next picture.
    pub(super) fn filter(&self, gpu: &Gpu, filter: &SkyFilter) {
        gpu.queue.write_buffer(&self.sky_filter, 0, bytemuck::cast_slice(&filter.uniform()));
    }

    /// From radiance to the display, through a lens, which glows, if that is asked for.
    pub(super) fn draw_tone(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        targets: &Targets,
        glows: bool,
        target: &wgpu::TextureView,
    ) {
        let glow = targets.glow.as_ref().filter(|_| glows);
        if let Some((glow, _)) = glow {
            self.bloom.draw(encoder, glow);
        }
        let (tone, group) = glow.map_or((&self.plain, &targets.plain), |(_, group)| (&self.glowing, group));
        tone.draw(&mut begin(encoder, "tonemap", target, wgpu::Color::BLACK, None), group);
    }
}

/// The textures whose size is the picture's.
pub(super) struct Targets {
    /// What the backdrop reads, and the tone alone and with a lens.
    pub(super) backdrop: wgpu::BindGroup,
    pub(super) plain: wgpu::BindGroup,
    /// `None` for measurements.
    pub(super) glow: Option<(Glow, wgpu::BindGroup)>,
    pub(super) size: [u32; 2],
    /// Colour with [`SAMPLES`] of a pixel, where edges are smooth; the depth has as many then.
    samples: Option<wgpu::TextureView>,
    /// Sky and land, as the sea sees them.
    pub(super) scene: wgpu::TextureView,
    pub(super) scene_depth: wgpu::TextureView,
    /// Everything.
    pub(super) radiance: wgpu::Texture,
    pub(super) depth: wgpu::TextureView,
}

impl Targets {
    pub(super) fn new(gpu: &Gpu, size: [u32; 2], format: wgpu::TextureFormat, samples: u32, passes: &Passes) -> Self {
        use wgpu::TextureUsages as T;
        let picture = Shape::picture(size[0], size[1]);
        let smooth = samples > 1;
        let drawn = Shape { samples, ..picture };
        let depth = |label, shape| texture::view(&gpu.texture(label, shape, DEPTH_FORMAT, T::RENDER_ATTACHMENT));
        let scene = texture::view(&gpu.texture("scene", picture, format, T::RENDER_ATTACHMENT));
        let scene_depth = depth("scene depth", picture);
        let radiance = gpu.texture("radiance", picture, format, T::RENDER_ATTACHMENT | T::COPY_SRC);
        let view = texture::view(&radiance);
        let glow = (format == PICTURE_FORMAT).then(|| {
            let glow = passes.bloom.glow(gpu, size, &view);
            let group = passes.bloom.read_with(gpu, &passes.glowing, &view, &passes.sky_filter, &glow);
            (glow, group)
        });
        Self {
            backdrop: passes.backdrops[usize::from(smooth)]
                .read(gpu, &[&scene, &scene_depth].map(wgpu::BindingResource::TextureView)),
            plain: passes
                .plain
                .read(gpu, &[wgpu::BindingResource::TextureView(&view), passes.sky_filter.as_entire_binding()]),
            glow,
            size,
            scene,
            scene_depth,
            radiance,
            depth: depth("depth", drawn),
            samples: smooth.then(|| texture::view(&gpu.texture("samples", drawn, format, T::RENDER_ATTACHMENT))),
        }
    }

    /// What the sea is drawn into: `radiance` is the view of [`Targets::radiance`].
    pub(super) fn sea<'a>(&'a self, radiance: &'a wgpu::TextureView) -> Colour<'a> {
        self.samples.as_ref().map_or(Colour::from(radiance), |view| Colour { view, mean: Some(radiance) })
    }

    /// Samples of a pixel of the sea.
    pub(super) fn samples(&self) -> u32 {
        if self.samples.is_some() { SAMPLES } else { 1 }
    }
}
