//! City lights, where it is night: each texel of their picture is a town of as many lamps as its pixels can show.

use glam::{DVec3, DVec4};

use super::points::{Point, Points};
use crate::data::city_lights::{CityLight, TEXELS, city_lights};
use crate::gpu::{Gpu, shader};
use crate::model::earth::{self, WGS84};
use crate::model::noise::hash;
use crate::model::sea_bed::smoothstep;
use crate::scene::frame::Frame;
use crate::scene::settings::Quality;

/// Lamps of a picture, at most.
const MOST: usize = 1 << 16;
/// Lamps of a town, at most.
const MOST_OF_TOWN: f64 = 192.0;
/// Pixels of a town for each of its lamps.
const PIXELS: f64 = 5.0;
/// Radiance that a picture of low quality shows from, of the brightest, nearer and from space: a third of all, and what makes out coasts.
const FAINTEST_OF_LOW: [f64; 2] = [0.02, 0.2];
/// Widths of pixels on the ground, m, up to which streets have lamps of their own (`TOWNS_SEEN` in `shaders/lib/built_up.wgsl`) and from which on these alone are
/// drawn, in pictures that are not of low quality;
const OWN_LAMPS_M: [f64; 2] = [150.0, 500.0];
/// and at the equator how far from the eye streets begin and end to be known to have them, m: as far as the coarser window of `src/pass/towns.rs` surely reaches.
const LAMPS_KNOWN_M: [f64; 2] = [250e3, 390e3];
/// The highest ground with lamps, m.
const HIGHEST_M: f64 = 4_500.0;
/// How far beyond the picture's edges lamps are drawn, half widths: more than a spot reaches.
const EDGE: f64 = 1.1;
/// Sines of the sun's elevation between which lamps are lit.
const DUSK: [f64; 2] = [-0.02, -0.12];

/// From here on lamps are those of a globe without relief, m: the earth may be drawn as a disc.
const SPACE_M: f64 = 500_000.0;
/// Radiance of the brightest towns in units of the sun's irradiance beyond the air: a hundred times that of ground under the picture's full
/// moon. Ten times would be theirs, but pictures of them are exposed for moonless land.
const BRIGHTNESS: f64 = 0.05;
/// Towns that add less to a pixel are not drawn; as the display's tone takes light.
const FAINTEST: f64 = 0.003;

/// The composed shader, for an eye over the ground or in space.
pub fn source(from_space: bool) -> String {
    let definitions = format!("const FROM_SPACE: bool = {from_space};\n");
    shader::composed(include_str!("../../shaders/city_lights.wgsl"), &definitions)
}

/// A texel of the picture on the ellipsoid: small, since every frame of a night looks at all of them.
struct Town {
    normal: DVec3,
    radiance: f64,
}

/// Half of a town's side along its meridian, m.
const HALF_SIDE_M: f64 = 0.5 * std::f64::consts::PI * WGS84.a / TEXELS[1] as f64;

impl Town {
    fn new(light: CityLight) -> Self {
        Self { normal: earth::normal(light.lat, light.lon), radiance: light.radiance }
    }

    fn place(&self) -> DVec3 {
        let scaled = DVec3::new(WGS84.a, WGS84.a, WGS84.b) * self.normal;
        DVec3::new(WGS84.a, WGS84.a, WGS84.b) * scaled / scaled.length()
    }

    /// Cosine of the latitude.
    fn cos_lat(&self) -> f64 {
        self.normal.truncate().length()
    }

    /// Unit vectors to the east and to the north.
    fn axes(&self) -> [DVec3; 2] {
        let east = DVec3::new(-self.normal.y, self.normal.x, 0.0) / self.cos_lat().max(1e-9);
        [east, self.normal.cross(east)]
    }

    /// Halves of its sides, m.
    fn half(&self) -> [f64; 2] {
        [HALF_SIDE_M * self.cos_lat(), HALF_SIDE_M]
    }

    fn area(&self) -> f64 {
        let [width, height] = self.half();
        4.0 * width * height
    }
}

/// The pass.
pub struct CityLights {
    towns: Vec<Town>,
    /// Those that may be in the picture, for an eye over the ground and in space.
    lamps: [Points; 2],
}

/// A town in a picture: which, how many lamps its pixels can show, and how much of its light is lit.
struct Seen {
    town: usize,
    lamps: f64,
    lit: f64,
}

impl CityLights {
    /// The pass into `formats` of colour and depth, a colour that blends; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        formats: [wgpu::TextureFormat; 2],
    ) -> Self {
        let lamps =
            [false, true].map(|space| Points::new(gpu, ("city lights", &source(space), MOST), frame, surface, formats));
        Self { towns: city_lights().map(Town::new).collect(), lamps }
    }

    /// Lights the lamps that may be in a frame; `imagery`: whether there is imagery of the land, without which no town is built up.
    pub fn prepare(&mut self, gpu: &Gpu, frame: &Frame, imagery: bool) -> &Points {
        let shown = &mut self.lamps[usize::from(is_from_space(frame))];
        shown.show(gpu, &lamps(&self.towns, frame, imagery));
        shown
    }
}

fn is_from_space(frame: &Frame) -> bool {
    frame.camera.altitude_m > SPACE_M
}

fn lamps(towns: &[Town], frame: &Frame, imagery: bool) -> Vec<Point> {
    let seen = seen(towns, frame, imagery && frame.is_fine());
    let wished: f64 = seen.iter().map(|seen| seen.lamps).sum();
    let share = (MOST as f64 / 2.0 / wished.max(1.0)).min(1.0);
    let enu = earth::ecef_from_enu(frame.camera.lat, frame.camera.lon).transpose();
    let up = DVec3::Z;
    let clip = frame.uniform.clip_from_local.as_dmat4();
    let eye = frame.camera.eye_ecef();
    let mut lamps = Vec::new();
    for Seen { town: index, lamps: wished, lit } in seen {
        let town = &towns[index];
        let count = (wished * share).max(1.0);
        // The last lamp comes and goes softly.
        let weight = |i: usize| (count - i as f64).min(1.0) / libm::sqrt(1.0 + i as f64);
        let many = count.ceil() as usize;
        let total: f64 = (0..many).map(weight).sum();
        let (middle, half, [east, north]) = (town.place() - eye, town.half(), town.axes());
        for i in 0..many {
            let [x, y, warm] = lamp(index, i);
            let [dx, dy] = [x * half[0], y * half[1]];
            let step = east * dx + north * dy;
            let sag = (dx * dx + dy * dy) / (2.0 * WGS84.a);
            let place = enu * (middle + step - town.normal * sag);
            let at: DVec4 = clip * place.extend(1.0);
            if at.w <= 0.0 || at.x.abs() > EDGE * at.w || at.y.abs() > EDGE * at.w {
                continue;
            }
            // To a sphere's first order; the town is small.
            let normal = (enu * (town.normal + step / WGS84.a)).normalize() - up;
            let light = BRIGHTNESS * lit * town.radiance * town.area() * weight(i) / total;
            lamps.push([normal.x as f32, normal.y as f32, normal.z as f32, light as f32, warm as f32]);
        }
    }
    lamps
}

/// Towns that may be in a frame, where `built_up` ones have lamps of their own near the eye: it is night there, they are over the horizon, and in front of the eye.
fn seen(towns: &[Town], frame: &Frame, built_up: bool) -> Vec<Seen> {
    let u = &frame.uniform;
    let enu = earth::ecef_from_enu(frame.camera.lat, frame.camera.lon);
    let (eye, forward, sun) = (frame.camera.eye_ecef(), enu * u.ray_forward.as_dvec3(), enu * u.sun.as_dvec3());
    let corner = f64::from(u.ray_right.length_squared() + u.ray_up.length_squared()).sqrt().atan();
    let horizon = |height: f64| (height.max(0.0) * (2.0 * WGS84.a + height.max(0.0))).sqrt();
    let farthest = horizon(frame.camera.altitude_m) + horizon(HIGHEST_M);
    let pixel = f64::from(u.pixel_angle);
    let from_space = is_from_space(frame);
    let is_low = frame.quality == Quality::Low;
    let faintest = if is_low { FAINTEST_OF_LOW[usize::from(from_space)] } else { 0.0 };
    let shown = BRIGHTNESS * f64::from(u.exposure * u.night);
    let of = |(index, town): (usize, &Town)| {
        let day = town.normal.dot(sun);
        if day >= DUSK[0] || town.radiance < faintest {
            return None;
        }
        let way = town.place() - eye;
        let distance = way.length();
        let sinks = (-way.dot(town.normal) / distance.max(1.0)).max(0.05);
        let footprint = pixel * distance / sinks.sqrt();
        let known = LAMPS_KNOWN_M.map(|metres| metres * frame.camera.lat.cos());
        let far = smoothstep(OWN_LAMPS_M[0], OWN_LAMPS_M[1], footprint).max(smoothstep(known[0], known[1], distance));
        let own = if built_up { far } else { 1.0 };
        let lit = own * ((DUSK[0] - day) / (DUSK[0] - DUSK[1])).min(1.0);
        let reach = 2.0 * HALF_SIDE_M;
        // From space, what turns away lies behind the limb; nearer, high ground may look over the horizon.
        if distance > farthest + reach || (from_space && way.dot(town.normal) >= 0.0) {
            return None;
        }
        let beside = (way.dot(forward) / distance).clamp(-1.0, 1.0).acos() - (reach / distance.max(reach)).asin();
        if distance > reach && beside > corner {
            return None;
        }
        let pixels =
            town.area() * (-way.dot(town.normal)).max(0.02 * distance) / distance.max(1.0).powi(3) / (pixel * pixel);
        if lit * shown * town.radiance * pixels.max(1.0) < FAINTEST {
            return None;
        }
        Some(Seen { town: index, lamps: (pixels / PIXELS).clamp(1.0, MOST_OF_TOWN), lit })
    };
    towns.iter().enumerate().filter_map(of).collect()
}

/// Where a town's lamp stands, in half sides from its middle, and how warm it is, 0 to 1: about a few quarters, most of them near.
fn lamp(town: usize, i: usize) -> [f64; 3] {
    let random = |i: usize, salt: u32| f64::from(hash([town as u32, i as u32, salt])) / 2f64.powi(32);
    let quarter = i % 5;
    let (sin, cos) = libm::sincos(std::f64::consts::TAU * random(i, 2));
    let off = 0.6 * random(i, 3) * random(i, 4);
    let [x, y] = [random(quarter, 0), random(quarter, 1)].map(|r| 1.8 * (r - 0.5));
    [x + off * cos, y + off * sin, random(i, 5)]
}
