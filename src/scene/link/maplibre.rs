//! The hash of a MapLibre page, `zoom/lat/lng[/bearing[/pitch]]`, understood on reading.
//!
//! A map's hash names the place at the centre of the picture and a zoom; our camera is an eye. The eye goes where a page
//! [`PAGE_HEIGHT_PX`] high shows the same ground at its centre at the same scale.

use glam::DVec3;

use crate::model::earth::{Geodetic, WGS84};
use crate::scene::link::number::{clamped, finite};
use crate::scene::view::camera::{Basis, Camera, FIELD_OF_VIEW_Y, HIGHEST_M, LOWEST_M};

/// Height in CSS pixels of the page that the conversion assumes; the hash does not tell.
pub const PAGE_HEIGHT_PX: f64 = 720.0;

/// Circumference of the Web Mercator square, metres, over the 512 px of a MapLibre tile.
const METRES_PER_PIXEL_AT_ZOOM_0: f64 = 40_075_016.685_578_5 / 512.0;

/// Steepest pitch that MapLibre gives a map, degrees.
const STEEPEST_PITCH_DEG: f64 = 85.0;

/// Reads a hash; `None` where it is not one.
pub fn camera_from_hash(text: &str) -> Option<Camera> {
    let parts: Vec<&str> = text.split('/').collect();
    let (&[zoom, lat, lon], rest) = parts.split_first_chunk::<3>()?;
    let (bearing, pitch) = match rest {
        [] => ("0", "0"),
        [bearing] => (*bearing, "0"),
        [bearing, pitch] => (*bearing, *pitch),
        _ => return None,
    };
    let zoom = clamped(zoom, -2.0..=30.0)?;
    let centre = Camera::from_degrees(
        clamped(lat, -90.0..=90.0)?,
        finite(lon)?,
        0.0,
        finite(bearing)?,
        clamped(pitch, 0.0..=STEEPEST_PITCH_DEG)?,
    );
    let metres_per_pixel = METRES_PER_PIXEL_AT_ZOOM_0 * centre.lat.cos().max(1e-3) * (-zoom).exp2();
    let distance_m = metres_per_pixel * PAGE_HEIGHT_PX / 2.0 / (FIELD_OF_VIEW_Y / 2.0).tan();
    camera_over(&centre, distance_m.clamp(LOWEST_M, HIGHEST_M))
}

/// The eye so far from a place on the ground that its ray through the picture's centre meets it there with the
/// heading and tilt that `centre` has.
fn camera_over(centre: &Camera, distance_m: f64) -> Option<Camera> {
    let place: DVec3 = WGS84.ecef_from_geodetic(Geodetic { height: 0.0, ..centre.geodetic() });
    let basis: Basis = centre.basis();
    let camera = Camera::from_ecef(place - basis.forward * distance_m, &basis).ok()?;
    Some(Camera { altitude_m: camera.altitude_m.clamp(LOWEST_M, HIGHEST_M), ..camera })
}
