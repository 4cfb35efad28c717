//! Stars, where nothing nearer has been drawn.

use super::points::{Point, Points};
use crate::data::stars::{Star, stars};
use crate::gpu::{Gpu, shader};
use crate::model::earth::WGS84;
use crate::scene::frame::Frame;
use crate::scene::settings::Quality;

/// How far beyond the picture's edges stars are drawn, half widths: more than a spot reaches.
const EDGE: f64 = 1.1;
/// The faintest stars of a picture of low quality, magnitudes: a fifth of all.
const FAINTEST_OF_LOW: f64 = 4.5;
/// How far the vertical may lean from the way to the earth's middle, and some more, radians.
const FLATTENING_REACH: f64 = 0.01;

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/stars.wgsl"), "")
}

/// The pass.
pub struct Stars {
    catalogue: Vec<Star>,
    /// Those that may be in the picture.
    seen: Points,
}

impl Stars {
    /// The pass into `formats` of colour and depth, a colour that blends; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        formats: [wgpu::TextureFormat; 2],
    ) -> Self {
        let catalogue: Vec<Star> = stars().collect();
        let seen = Points::new(gpu, ("stars", &source(), catalogue.len()), frame, surface, formats);
        Self { catalogue, seen }
    }

    /// Turns the stars to where they stand in a frame, and picks those that may be in it: a tenth.
    pub fn prepare(&mut self, gpu: &Gpu, frame: &Frame) -> &Points {
        let axes = frame.from_j2000();
        let clip = frame.uniform.clip_from_local.as_dmat4();
        let faintest = if frame.quality == Quality::Low { FAINTEST_OF_LOW } else { f64::INFINITY };
        // The earth hides what is nearer to the nadir than its limb; what is close to that the shader decides.
        let to_middle = WGS84.a + frame.camera.altitude_m.max(0.0);
        let behind = ((WGS84.b / to_middle).asin() - FLATTENING_REACH).cos();
        let standing = self.catalogue.iter().filter(|star| star.magnitude < faintest).filter_map(|star| {
            let direction = axes * star.direction;
            let at = clip * direction.extend(0.0);
            let is_in = at.w > 0.0 && at.x.abs() < EDGE * at.w && at.y.abs() < EDGE * at.w && -direction.z < behind;
            let [x, y, z] = direction.as_vec3().to_array();
            is_in.then_some([x, y, z, star.magnitude as f32, star.colour_index as f32])
        });
        let seen: Vec<Point> = standing.collect();
        self.seen.show(gpu, &seen);
        &self.seen
    }
}
