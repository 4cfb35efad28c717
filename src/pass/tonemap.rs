//! Scene radiance, as a lens has it, to display colours: the last pass, into whatever target the caller has.

use crate::gpu::full_screen::FullScreen;
use crate::gpu::pipeline::Bind;
use crate::gpu::{Gpu, shader};
use crate::model::daylight;
use crate::scene::frame::sky_filter;

/// The composed shader, with what a lens does to the picture or without.
pub fn source(lens: bool) -> String {
    let import = if lens { "#import lens\n" } else { "#import no_lens\n" };
    let [r, g, b] = daylight::BALANCE;
    let balance = format!("const BALANCE = vec3f({r}, {g}, {b});\n");
    let constants = balance + &sky_filter::constants();
    shader::composed(&(import.to_owned() + include_str!("../../shaders/tonemap.wgsl")), &constants)
}

/// The pass into a target of `format`, which takes display (gamma) values. It reads the scene's radiance, a
/// [`SkyFilter`](sky_filter::SkyFilter) and, with a lens, the radiance's glow and a sampler.
pub fn pass(gpu: &Gpu, format: wgpu::TextureFormat, lens: bool) -> FullScreen {
    use wgpu::TextureViewDimension::D2;
    let binds = [Bind::Texels(D2), Bind::Uniform, Bind::Texture(D2), Bind::Sampler];
    let binds = if lens { &binds[..] } else { &binds[..2] };
    FullScreen::new(gpu, "tonemap", &source(lens), binds, format, None)
}
