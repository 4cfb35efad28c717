//! Moves of the eye: each takes a camera and gives the next one.
//!
//! All moves turn the camera rigidly about the earth's centre and then correct the small difference between the ellipsoid
//! and a sphere, so that nothing special happens at a pole, at the antimeridian or at any height.
//! North stays where it is on the screen while that has a meaning; near the poles the turn carries it along.

use std::f64::consts::PI;

use glam::{DQuat, DVec2, DVec3};

use crate::model::earth::{Ellipsoid, WGS84, ecef_from_enu};
use crate::model::sea_bed::smoothstep;
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y, HIGHEST_M, LOWEST_M, wrap_signed};

/// Tilt at which a descent without any other wish ends, radians: the horizon is in the picture, the sea fills most of it.
const DECK_TILT: f64 = 78.0 * PI / 180.0;

/// Heights in metres over the ground between which a descent raises the view to [`DECK_TILT`].
const TILTING_M: [f64; 2] = [30.0, 6000.0];

/// The ellipsoid that passes through the ground at a height in metres.
pub fn ground_ellipsoid(ground_m: f64) -> Ellipsoid {
    Ellipsoid { a: WGS84.a + ground_m, b: WGS84.b + ground_m }
}

/// Turns the globe so that an earth-centred point of a ground `ground_m` high comes under a pixel; height and tilt stay.
/// `None` where the pixel shows the sky.
pub fn bring(camera: &Camera, point: DVec3, pixel: DVec2, size: DVec2, ground_m: f64) -> Option<Camera> {
    /// The ellipsoid differs from the sphere by 1/300, so each round leaves about that part of the error.
    const ROUNDS: usize = 8;
    let ground = ground_ellipsoid(ground_m);
    let mut moved = *camera;
    let axis = point.normalize_or(DVec3::Z);
    for round in 0..ROUNDS {
        let hit = moved.unproject_onto(&ground, pixel, size)?;
        moved = turned(&moved, arc(hit, point))?;
        if round + 2 < ROUNDS {
            // Turning about the point itself leaves it under the pixel.
            let keep = northness(axis.z.asin()).min(northness(moved.lat));
            let drift = wrap_signed(moved.heading - camera.heading) * keep;
            moved = turned(&moved, DQuat::from_axis_angle(axis, drift))?;
        }
    }
    Some(moved)
}

/// Moves the eye by metres of ground to the right and ahead, at most a quarter of the globe.
pub fn slide(camera: &Camera, right_m: f64, ahead_m: f64) -> Option<Camera> {
    let (sin, cos) = camera.heading.sin_cos();
    let axes = ecef_from_enu(camera.lat, camera.lon);
    let way = axes * DVec3::new(cos * right_m + sin * ahead_m, cos * ahead_m - sin * right_m, 0.0);
    let eye = camera.eye_ecef();
    let axis = eye.cross(way).try_normalize()?;
    let angle = (way.length() / WGS84.a).min(PI / 2.0);
    let moved = turned(camera, DQuat::from_axis_angle(axis, angle))?;
    let drift = wrap_signed(moved.heading - camera.heading) * northness(camera.lat).min(northness(moved.lat));
    Some(Camera { heading: moved.heading - drift, ..moved }.normalized())
}

/// Drags the sky or the space beside the globe: turns the globe by about what its centre would move.
pub fn drag_beside(camera: &Camera, delta: DVec2, size: DVec2) -> Option<Camera> {
    let metres = reach_m(camera.altitude_m) * 2.0 * (FIELD_OF_VIEW_Y / 2.0).tan() / size.y.max(1.0);
    slide(camera, -delta.x * metres, delta.y * metres)
}

/// How far the eye reaches at a height, metres: the height near the ground, the globe's own radius from far away.
pub fn reach_m(over_m: f64) -> f64 {
    let over_m = over_m.max(LOWEST_M);
    over_m * WGS84.a / (WGS84.a + over_m)
}

/// Multiplies the height over the ground by a ratio, keeping the place under a pixel where it is.
///
/// The lower the eye comes, the more it looks ahead, and back on the way up: wheel alone leads from orbit to the deck.
pub fn zoom(camera: &Camera, ratio: f64, pixel: DVec2, size: DVec2, ground_m: f64) -> Camera {
    let over_m = (camera.altitude_m - ground_m).max(LOWEST_M);
    let wanted_m = over_m * if ratio.is_finite() { ratio.max(0.0) } else { 1.0 };
    let next_m = wanted_m.clamp(LOWEST_M, (HIGHEST_M - ground_m).max(LOWEST_M));
    let raise = deck_tilt(next_m) - deck_tilt(over_m);
    // Never past the deck's tilt on the way down, never below the ground's on the way up.
    let tilt = if raise > 0.0 { camera.tilt.max((camera.tilt + raise).min(DECK_TILT)) } else { camera.tilt + raise };
    let tilt = tilt.clamp(0.0, if next_m > over_m { steepest(next_m) } else { PI });
    let next = Camera { altitude_m: ground_m + next_m, tilt, ..*camera };
    let held = camera.unproject_onto(&ground_ellipsoid(ground_m), pixel, size);
    held.and_then(|point| bring(&next, point, pixel, size, ground_m)).unwrap_or(next)
}

/// Turns the view by a heading and a tilt, radians.
///
/// Looking down, the eye circles the place at the centre of the picture; looking ahead, it turns on the spot; in between it
/// does a part of either.
pub fn turn(camera: &Camera, heading: f64, tilt: f64, size: DVec2, ground_m: f64) -> Camera {
    let limit = steepest(camera.altitude_m - ground_m).max(camera.tilt);
    let tilt = (camera.tilt + tilt).clamp(0.0, limit);
    let on_spot = Camera { heading: camera.heading + heading, tilt, ..*camera }.normalized();
    let circling = 1.0 - smoothstep(55f64.to_radians(), 75f64.to_radians(), camera.tilt.max(tilt));
    let centre = size / 2.0;
    let held = camera.unproject_onto(&ground_ellipsoid(ground_m), centre, size);
    let around = held.filter(|_| circling > 0.0).and_then(|point| bring(&on_spot, point, centre, size, ground_m));
    let Some(around) = around else { return on_spot };
    let (axis, angle) = arc(on_spot.eye_ecef(), around.eye_ecef()).to_axis_angle();
    let moved = turned(&on_spot, DQuat::from_axis_angle(axis, angle * circling)).unwrap_or(on_spot);
    Camera { heading: on_spot.heading, ..moved }
}

/// The camera lifted to [`LOWEST_M`] over the ground where it is lower, and held below [`HIGHEST_M`].
pub fn above_ground(camera: &Camera, ground_m: f64) -> Camera {
    let lowest_m = (ground_m + LOWEST_M).min(HIGHEST_M);
    Camera { altitude_m: camera.altitude_m.clamp(lowest_m, HIGHEST_M), ..*camera }
}

/// The largest tilt at a height in metres over the ground: all the sky from the ground, no more than the limb from space.
pub fn steepest(over_m: f64) -> f64 {
    let limb = (WGS84.a / (WGS84.a + over_m.max(0.0))).asin();
    let low = 1.0 - smoothstep(1e4f64.ln(), 1e6f64.ln(), over_m.max(1.0).ln());
    limb + (PI - limb) * low
}

/// The part of the tilt that the height gives.
fn deck_tilt(over_m: f64) -> f64 {
    let [low, high] = TILTING_M.map(f64::ln);
    DECK_TILT * (1.0 - smoothstep(low, high, over_m.max(LOWEST_M).ln()))
}

/// How much north on the screen is held at a latitude: 1 in most of the world, 0 near the poles.
fn northness(lat: f64) -> f64 {
    1.0 - smoothstep(60f64.to_radians(), 80f64.to_radians(), lat.abs())
}

/// The camera carried by a turn about the earth's centre; height and tilt stay what they were.
pub fn turned(camera: &Camera, turn: DQuat) -> Option<Camera> {
    let at = WGS84.geodetic_from_ecef(turn * camera.eye_ecef()).ok()?;
    // The right axis is level at every tilt; the forward axis has no heading when it points down.
    let right = ecef_from_enu(at.lat, at.lon).transpose() * (turn * camera.basis().right);
    Some(Camera { lat: at.lat, lon: at.lon, heading: (-right.y).atan2(right.x), ..*camera }.normalized())
}

/// The shortest turn about the centre from one point's direction to another's, exact for the smallest angles.
pub fn arc(from: DVec3, to: DVec3) -> DQuat {
    let cross = from.cross(to);
    // Opposite points have no shortest turn; any axis does.
    let axis = cross.try_normalize().unwrap_or(DVec3::Z);
    DQuat::from_axis_angle(axis, cross.length().atan2(from.dot(to)))
}
