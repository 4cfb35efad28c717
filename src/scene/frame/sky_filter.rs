//! The graduated filter, grey above the horizon and clear below it, with which photographers take clouds over a darker sea. It is laid over the picture that the
//! lens has made: a lens's glow is that of the sky without it.

use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};

/// Sines of the elevation over the horizon between which the filter goes from clear to grey: 2° below it to 6° above.
const EDGE: [f64; 2] = [-0.035, 0.105];

/// A graduated filter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkyFilter {
    /// Sines of the elevation that the picture's middle shows, and that its upward direction has.
    forward_up: [f64; 2],
    /// Sine of the horizon's elevation, at most 0.
    horizon: f64,
    /// Factor of the sky's light, 0…1.
    grey: f64,
}

impl SkyFilter {
    /// One through which so much of the sky's light comes, 1 all of it.
    pub fn new(camera: &Camera, grey: f64) -> Self {
        let basis = camera.basis_enu();
        let dip = libm::sqrt(2.0 * camera.altitude_m.max(0.0) / crate::model::earth::WGS84.a);
        Self { forward_up: [basis.forward.z, basis.up.z], horizon: -dip.min(1.0), grey }
    }

    /// Factor of the light that comes through at a pixel, counted from the top left, of a picture of `size` pixels.
    pub fn passed(&self, pixel: [f64; 2], size: [f64; 2]) -> f64 {
        let tan = libm::tan(0.5 * FIELD_OF_VIEW_Y);
        let right = tan * (2.0 * pixel[0] - size[0]) / size[1];
        let up = tan * (size[1] - 2.0 * pixel[1]) / size[1];
        let sine = (self.forward_up[0] + up * self.forward_up[1]) / libm::sqrt(1.0 + right * right + up * up);
        let t = ((sine - self.horizon - EDGE[0]) / (EDGE[1] - EDGE[0])).clamp(0.0, 1.0);
        1.0 + (self.grey - 1.0) * t * t * (3.0 - 2.0 * t)
    }

    /// What `shaders/tonemap.wgsl` reads: elevations of the middle and of up, where the filter begins, and its grey.
    pub fn uniform(&self) -> [f32; 4] {
        [self.forward_up[0], self.forward_up[1], self.horizon + EDGE[0], self.grey].map(|part| part as f32)
    }
}

/// What the shader is told at compile time: half a picture's height at unit distance, and the width of the filter's edge.
pub fn constants() -> String {
    let tan = libm::tan(0.5 * FIELD_OF_VIEW_Y);
    format!("const HALF_HEIGHT: f32 = {tan};\nconst FILTER_EDGE: f32 = {};\n", EDGE[1] - EDGE[0])
}
