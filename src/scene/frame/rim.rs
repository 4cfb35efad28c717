//! Parts of a picture: the box of what stands over the earth up to a height, and the rows above a horizon.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use crate::model::earth::WGS84;
use crate::scene::frame::uniform::FrameUniform;
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};

/// How much farther than the mean sphere's a box reaches, radians: the ellipsoid's flattening, and that the vertical is not the way
/// to the earth's middle.
pub const MARGIN: f64 = 0.012;
/// Directions along a rim that are looked at: between two of them it bends by less than a pixel of any picture.
const RIM: u32 = 256;
/// How high the air is, metres: `TOP` of the shaders.
pub const AIR_M: f64 = 100_000.0;
/// How far below the ellipsoid what covers it may lie, metres: that of `is_inside_limb`.
const INSIDE_M: f64 = 500.0;
/// How far from its middle the disc of sun or moon may show, radians, with a margin.
const DISC: f64 = 0.01;

/// Left, top, width and height of the pixels, of a picture of `size`, that may show what is so high over the earth at most, metres, for an eye that is higher.
pub fn around(camera: &Camera, size: [u32; 2], height_m: f64) -> [u32; 4] {
    let dip = libm::acos(((WGS84.b + height_m) / (WGS84.b + camera.altitude_m)).min(1.0));
    if dip < 2.0 * MARGIN { [0, 0, size[0], size[1]] } else { within(camera, size, dip - MARGIN) }
}

/// The rows whose pixels see anything above the horizon of an earth so much lower, metres: left, top, width and height. A row is highest in its middle where it looks
/// up, at its ends where it looks down.
pub fn above(camera: &Camera, size: [u32; 2], lower_m: f64) -> [u32; 4] {
    let [width, height] = size.map(f64::from);
    let axes = camera.basis_enu();
    let half = libm::tan(FIELD_OF_VIEW_Y / 2.0);
    let dip = libm::acos(((WGS84.b - lower_m) / (WGS84.b + camera.altitude_m.max(0.0))).min(1.0));
    let sees_sky = |row: &u32| {
        let middle = axes.forward + axes.up * half * (1.0 - 2.0 * (f64::from(*row) + 0.5) / height);
        let end = middle + axes.right * half * width / height;
        (middle.normalize().z).max(end.normalize().z) > -libm::sin(dip) - MARGIN
    };
    let first = (0..size[1]).find(sees_sky).unwrap_or(size[1]);
    let last = (first..size[1]).rev().find(sees_sky).map_or(first, |row| row + 1);
    [0, first, size[0], last - first]
}

/// As [`above`], of all that land and sea may leave of the sky: `is_inside_limb` of the shaders' ellipsoid says of the others that they do not.
pub fn beside_limb(u: &FrameUniform, camera: &Camera, size: [u32; 2]) -> [u32; 4] {
    let limb_m = WGS84.horizon_distance(camera.altitude_m.max(0.0));
    above(camera, size, INSIDE_M + limb_m * f64::from(u.pixel_angle))
}

/// As [`around`], of the pixels that may show any of the sky but its stars to an eye in space: beside the air it is black, but for the discs of sun and
/// moon.
pub fn of_sky(u: &FrameUniform, camera: &Camera, size: [u32; 2]) -> [u32; 4] {
    let axes = camera.basis_enu();
    let half = libm::tan(FIELD_OF_VIEW_Y / 2.0);
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    // Tangents of the farthest pixels, and of what of a disc reaches in from beside them.
    let shows = |disc: DVec3| {
        let ahead = axes.forward.dot(disc);
        let reach = 2.0 * DISC * (1.0 + half * half * (1.0 + aspect * aspect));
        let within = |axis: DVec3, half: f64| axis.dot(disc).abs() < ahead * (half + reach);
        ahead > 0.0 && within(axes.right, half * aspect) && within(axes.up, half)
    };
    if [u.sun, u.moon].into_iter().any(|disc| shows(disc.as_dvec3())) {
        return [0, 0, size[0], size[1]];
    }
    around(camera, size, AIR_M)
}

/// The box around all pixels that look at least `dip` radians below level.
fn within(camera: &Camera, size: [u32; 2], dip: f64) -> [u32; 4] {
    let extent = DVec2::from(size.map(f64::from));
    let axes = camera.basis_enu();
    let half = libm::tan(FIELD_OF_VIEW_Y / 2.0);
    let (sin, cos) = libm::sincos(dip);
    let (mut least, mut greatest) = (extent, DVec2::ZERO);
    for step in 0..RIM {
        let (y, x) = libm::sincos(TAU * f64::from(step) / f64::from(RIM));
        let direction = DVec3::new(cos * x, cos * y, -sin);
        let ahead = axes.forward.dot(direction);
        // Some of the rim is behind the eye: its picture has no end.
        if ahead < 1e-3 {
            return [0, 0, size[0], size[1]];
        }
        let across = DVec2::new(axes.right.dot(direction), -axes.up.dot(direction)) / (ahead * 2.0 * half) * extent.y;
        let pixel = (0.5 * extent + across).clamp(DVec2::ZERO, extent);
        (least, greatest) = (least.min(pixel), greatest.max(pixel));
    }
    let (first, beyond) = (least.floor().as_uvec2(), greatest.ceil().as_uvec2());
    [first.x, first.y, beyond.x.saturating_sub(first.x), beyond.y.saturating_sub(first.y)]
}
