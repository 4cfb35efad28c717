//! Scene radiance to display colours: the last pass, into whatever target the caller has.

use crate::gpu::full_screen::FullScreen;
use crate::gpu::{Gpu, shader};

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/tonemap.wgsl"), "")
}

/// The pass into a target of `format`, which takes display (gamma) values.
pub fn pass(gpu: &Gpu, format: wgpu::TextureFormat) -> FullScreen {
    FullScreen::new(gpu, "tonemap", &source(), format, None)
}
