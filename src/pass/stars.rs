//! Stars and the Milky Way, where nothing nearer has been drawn.

use super::points::{Point, Points};
use crate::data::stars::{Glow, Star, milky_way, stars};
use crate::gpu::{Gpu, shader};
use crate::model::earth::WGS84;
use crate::scene::frame::Frame;
use crate::scene::settings::Quality;
use glam::{DMat3, DMat4, DVec3};

/// How far beyond the picture's edges stars are drawn, half widths: more than a spot reaches. And parts of the Milky Way.
const EDGE: f64 = 1.1;
const WIDE_EDGE: f64 = 1.3;
/// The faintest stars of a picture of low quality, magnitudes: a tenth of all.
const FAINTEST_OF_LOW: f64 = 4.0;
/// How far the vertical may lean from the way to the earth's middle, and some more, radians.
const FLATTENING_REACH: f64 = 0.01;

/// The composed shader of the stars.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/stars.wgsl"), "")
}

/// The composed shader of the Milky Way.
pub fn milky_way_source() -> String {
    shader::composed(include_str!("../../shaders/milky_way.wgsl"), "")
}

/// The pass.
pub struct Stars {
    catalogue: Vec<Star>,
    glow: Vec<Glow>,
    /// Those that may be in the picture.
    seen: Points,
    seen_glow: Points,
}

/// Where the sky is in a picture.
struct Sky {
    from_j2000: DMat3,
    clip_from_local: DMat4,
    /// Cosine of the angle from the nadir from which on the earth may hide something.
    behind: f64,
}

impl Sky {
    fn of(frame: &Frame) -> Self {
        // The earth hides what is nearer to the nadir than its limb; what is close to that the shader decides.
        let to_middle = WGS84.a + frame.camera.altitude_m.max(0.0);
        let behind = ((WGS84.b / to_middle).asin() - FLATTENING_REACH).cos();
        Self { from_j2000: frame.from_j2000(), clip_from_local: frame.uniform.clip_from_local.as_dmat4(), behind }
    }

    /// A direction of J2000.0 in the local frame, if it may be in the picture or beside it.
    fn seen(&self, direction: DVec3, edge: f64) -> Option<DVec3> {
        let local = self.from_j2000 * direction;
        let at = self.clip_from_local * local.extend(0.0);
        let is_in = at.w > 0.0 && at.x.abs() < edge * at.w && at.y.abs() < edge * at.w && -local.z < self.behind;
        is_in.then_some(local)
    }
}

fn point(direction: DVec3, [a, b]: [f64; 2]) -> Point {
    let [x, y, z] = direction.as_vec3().to_array();
    [x, y, z, a as f32, b as f32]
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
        let glow: Vec<Glow> = milky_way().collect();
        let seen = Points::new(gpu, ("stars", &source(), catalogue.len()), frame, surface, formats);
        let seen_glow = Points::new(gpu, ("milky way", &milky_way_source(), glow.len()), frame, surface, formats);
        Self { catalogue, glow, seen, seen_glow }
    }

    /// Turns the sky to where it stands in a frame, and picks what may be in it: a tenth. A picture of low quality has no Milky Way.
    pub fn prepare(&mut self, gpu: &Gpu, frame: &Frame) -> [&Points; 2] {
        let sky = Sky::of(frame);
        let is_low = frame.quality == Quality::Low;
        let faintest = if is_low { FAINTEST_OF_LOW } else { f64::INFINITY };
        let stars = self.catalogue.iter().filter(|star| star.magnitude < faintest).filter_map(|star| {
            let direction = sky.seen(star.direction, EDGE)?;
            Some(point(direction, [star.magnitude, star.colour_index]))
        });
        self.seen.show(gpu, &stars.collect::<Vec<_>>());
        let glow = self.glow.iter().filter(|_| !is_low).filter_map(|part| {
            let direction = sky.seen(part.direction, WIDE_EDGE)?;
            Some(point(direction, [part.brightness, 0.0]))
        });
        self.seen_glow.show(gpu, &glow.collect::<Vec<_>>());
        [&self.seen_glow, &self.seen]
    }
}
