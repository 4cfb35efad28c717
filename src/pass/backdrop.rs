//! Sky and land where no sea has been drawn over them: only these pixels of the scene are copied.

use crate::gpu::full_screen::FullScreen;
use crate::gpu::pipeline::{Bind, Depth, DepthTest};
use crate::gpu::{Gpu, shader};

/// The composed shader; `smooth`: ridges are no stairs.
pub fn source(smooth: bool) -> String {
    shader::composed(include_str!("../../shaders/backdrop.wgsl"), &format!("const SMOOTH: bool = {smooth};\n"))
}

/// The pass into formats of colour and depth with so many samples a pixel, the sea's; it reads the scene's colour and depth.
pub fn pass(gpu: &Gpu, [colour, format]: [wgpu::TextureFormat; 2], samples: u32) -> FullScreen {
    let scene = [Bind::Texels(wgpu::TextureViewDimension::D2), Bind::Depth];
    let depth = Depth { format, test: DepthTest::Undrawn, samples };
    FullScreen::new(gpu, "backdrop", &source(samples > 1), &scene, colour, Some(depth))
}
