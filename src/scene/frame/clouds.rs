//! Clouds as an eye sees them.

use glam::{DVec2, DVec3};

use crate::model::clouds::{self, Weather};
use crate::model::overcast;
use crate::scene::frame::exposure::{for_clouds_in_view, for_sunlit_sides, into_sun, near_ground};
use crate::scene::frame::rim;
use crate::scene::frame::sky_filter::SkyFilter;
use crate::scene::frame::uniform::FrameUniform;
use crate::scene::layers::Layer;
use crate::scene::settings::{Quality, Settings};
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};

/// The clouds of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clouds {
    /// Their weather.
    pub weather: Weather,
    /// The pixels that they may be seen in: left, top, width, height.
    pub area: [u32; 4],
    /// Whether they may stand before land and sea.
    pub are_below: bool,
    /// Nodes across and down of the net over the picture at which their light is known (`shaders/lib/cloud_light.wgsl`).
    pub net: [u32; 2],
}

/// Pixels from a node of the net to the next.
const NODE_PIXELS: u32 = 3;
/// And at low quality.
const NODE_PIXELS_LOW: u32 = 8;
/// As many nodes along the longer side there are at least: a small picture has the same places as a large one.
const LEAST_ACROSS: u32 = 80;
/// Nodes for shadows along one of those for what is mirrored, which is blurred by far.
pub const MIRROR_NODES: u32 = 4;
/// Nodes of a net, at most: larger pictures have wider ones.
pub const MOST_NODES: u32 = 60_000;

/// Nodes across and down of the net over a picture of `size` pixels.
fn net(quality: Quality, size: [u32; 2]) -> [u32; 2] {
    let wished = if quality == Quality::Low { NODE_PIXELS_LOW } else { NODE_PIXELS };
    let wished = wished.min(size[0].max(size[1]) / LEAST_ACROSS).max(1);
    let nodes = |pixels: u32| size.map(|side| side.div_ceil(pixels) + 1);
    let few =
        |pixels: &u32| nodes(*pixels).iter().map(|side| u64::from(*side)).product::<u64>() <= u64::from(MOST_NODES);
    nodes((wished..).find(few).unwrap_or(u32::MAX))
}

/// Heights between which an eye leaves the clouds' shadow, metres.
const ABOVE_THEM_M: [f64; 2] = [900.0, 3_000.0];
/// Part of daylight that clouds all over the sky take, as `shaded` of `shaders/lib/cloud_light.wgsl` has it.
const TAKEN: f64 = 0.68;
/// Share of what they take that a picture is exposed for, in stops: a grey day looks like one.
const EXPOSED_FOR: f64 = 0.67;

/// Heights between which an eye comes to have its picture exposed for sunlit clouds below and beside it, metres, and where that is half of what it is before
/// space, from where clouds are but a part of what is seen.
const OVER_THEM_M: [f64; 3] = [1_000.0, 3_000.0, 80_000.0];
/// Heights between which an eye comes to have its picture exposed for the sides of clouds that face the sun, metres.
const BESIDE_THEM_M: [f64; 2] = [1_000.0, 3_000.0];
/// Share of the ground that they cover from which on it is: they are the brightest of what is seen.
const BESIDE_THEM: f64 = 0.3;
/// Least factor of that and of a view towards the sun together, unless the latter's alone is less.
const LEAST_TOGETHER: f64 = 0.4;
/// How many times more light clouds all over the ground send up than a picture is exposed for; ours, of some that leave their tops shaded.
const OVER_THEM: f64 = 0.6;

/// Share, in stops, of what a picture with clouds is exposed less for that a filter before its sky takes; the rest is taken from all of it.
const FILTERED: f64 = 0.7;

/// By the sun's height, its sine, times this, at most wholly.
const OVER_THEM_SUN: f64 = 4.0;

/// Where the eye is among the clouds, and how much less light it has there, or more above them; returns those that it sees, where there are any, and the filter that they
/// are taken with.
pub fn set_clouds(
    u: &mut FrameUniform,
    settings: &Settings,
    camera: &Camera,
    unix_seconds: f64,
    size: [u32; 2],
) -> (Option<Clouds>, SkyFilter) {
    let mut grey = 1.0;
    let drift = clouds::drift(unix_seconds);
    let (sin, cos) = libm::sincos(drift);
    let eye = camera.eye_ecef();
    u.cloud_eye = DVec3::new(cos * eye.x + sin * eye.y, cos * eye.y - sin * eye.x, eye.z).as_vec3();
    let (sin, cos) = libm::sincos(camera.lon - drift);
    u.cloud_meridian = DVec2::new(cos, sin).as_vec2();
    let cover = settings.cloud_cover();
    u.cloud_shift = clouds::shift(cover) as f32;
    let shown = cover > 0.0 && settings.layers.shows(Layer::Clouds) && settings.layers.shows(Layer::Sky);
    let weather = clouds::weather(unix_seconds);
    if shown {
        let towards = u.cloud_eye.as_dvec3().normalize();
        let share = overcast::share(towards, &weather, cover);
        let risen = |from: f64, to: f64| ((camera.altitude_m - from) / (to - from)).clamp(0.0, 1.0);
        let below = 1.0 - risen(ABOVE_THEM_M[0], ABOVE_THEM_M[1]);
        let [from, to, half] = OVER_THEM_M;
        let sunlit = (OVER_THEM_SUN * f64::from(u.sun.z)).clamp(0.0, 1.0);
        let over = sunlit * risen(from, to) / (1.0 + (camera.altitude_m / half).powi(2));
        // No sun burns where clouds hide it.
        let sun = u.sun.as_dvec3();
        let into = into_sun(camera.basis_enu().forward.dot(sun), sun.z, camera.altitude_m);
        let forward = camera.basis_enu().forward;
        let sky = (0.5 + forward.z / FIELD_OF_VIEW_Y).clamp(0.0, 1.0);
        // Towards the sun their shaded sides are seen, for which `into` is enough, and by night no sun shines on any.
        let darkest = (LEAST_TOGETHER / into).min(1.0);
        let seen = for_clouds_in_view(share, for_sunlit_sides(sun.z), forward.dot(sun), sky).max(darkest);
        let seen = libm::pow(seen, below * sunlit);
        grey = libm::pow(seen, FILTERED);
        u.exposure *= libm::pow(seen, 1.0 - FILTERED) as f32;
        u.exposure *= libm::pow(overcast_exposure(share) * libm::pow(into, -share * share), below) as f32;
        u.exposure /= (1.0 + OVER_THEM * over * share * share) as f32;
        // Towards the sun their shaded sides are seen, for which `into` is enough.
        let sides = for_sunlit_sides(sun.z).max(LEAST_TOGETHER / into).min(1.0);
        let beside =
            (share / BESIDE_THEM).min(1.0) * risen(BESIDE_THEM_M[0], BESIDE_THEM_M[1]) * near_ground(camera.altitude_m);
        u.exposure *= libm::pow(sides, beside) as f32;
    }
    let net = net(settings.quality, size);
    u.cloud_net = net[0] | net[1] << 16;
    let clouds = shown.then(|| Clouds {
        net,
        weather,
        area: area(camera, size),
        are_below: camera.altitude_m >= clouds::BASE_M,
    });
    (clouds, SkyFilter::new(camera, grey))
}

/// How much longer a picture is exposed below clouds that cover a share of the sky: for two thirds of the light that they take, in stops.
fn overcast_exposure(share: f64) -> f64 {
    libm::pow(1.0 - TAKEN * share * share, -EXPOSED_FOR)
}

/// The pixels that clouds may be seen in. Below their base that is the sky; above their top, what is nearer to the nadir than their own
/// horizon.
fn area(camera: &Camera, size: [u32; 2]) -> [u32; 4] {
    if camera.altitude_m < clouds::BASE_M {
        return rim::above(camera, size, 0.0);
    }
    rim::around(camera, size, clouds::ICE_M)
}
