//! Where the eye is and where it looks: the view, the ellipsoid about it, its place on the map squares.

use glam::{DMat3, DVec2, DVec3, Mat4, Vec2, Vec4};

use crate::data::tile::{MERCATOR_LATITUDE_LIMIT, MapPoint, POLAR_LATITUDE_DEG, Projection};
use crate::model::earth::{self, WGS84};
use crate::model::relief;
use crate::scene::frame::uniform::{FrameUniform, NEAR_M};
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};

/// Over which the air thins out by a factor of e, metres.
const AIR_HEIGHT_M: f64 = 8_000.0;

/// The picture's axes and its projection.
pub fn set_view(u: &mut FrameUniform, camera: &Camera, size: [u32; 2]) {
    let axes = camera.basis_enu();
    let half = libm::tan(FIELD_OF_VIEW_Y / 2.0);
    let aspect = f64::from(size[0]) / f64::from(size[1]);
    u.ray_right = (axes.right * half * aspect).as_vec3();
    u.ray_up = (axes.up * half).as_vec3();
    u.ray_forward = axes.forward.as_vec3();
    // Reversed depth, infinite far plane: clip = (x / aspect / half, y / half, near, distance along the view axis).
    let (right, up, forward) = (axes.right / (half * aspect), axes.up / half, axes.forward);
    let row = |v: DVec3, w: f64| Vec4::new(v.x as f32, v.y as f32, v.z as f32, w as f32);
    u.clip_from_local =
        Mat4::from_cols(row(right, 0.0), row(up, 0.0), row(DVec3::ZERO, NEAR_M), row(forward, 0.0)).transpose();
    u.viewport = Vec2::new(size[0] as f32, size[1] as f32);
    u.pixel_angle = (2.0 * half / f64::from(size[1])) as f32;
}

/// The ellipsoid as the quadric C + 2 g·P + P'QP about the eye, scaled to metres (F ≈ height near the surface).
pub fn set_earth(u: &mut FrameUniform, camera: &Camera, hs_m: f64, chop: f64) {
    let (a, b) = (WGS84.a, WGS84.b);
    let enu = earth::ecef_from_enu(camera.lat, camera.lon);
    let scale = 0.5 * a;
    let diagonal = DMat3::from_diagonal(scale / DVec3::new(a * a, a * a, b * b));
    let q = enu.transpose() * diagonal * enu;
    let (sin, cos) = libm::sincos(camera.lat);
    let nu = (a * a * cos * cos + b * b * sin * sin).sqrt();
    // The foot's gradient is exactly along its normal; the height adds Q·h·up. F(eye) follows without cancellation.
    let gradient_at = |h: f64| DVec3::new(0.0, 0.0, scale / nu) + q * DVec3::new(0.0, 0.0, h);
    let constant_at = |h: f64| 2.0 * h * scale / nu + h * h * q.z_axis.z;
    let h = camera.altitude_m;
    let crest = 1.1 * hs_m;
    let above = if h < 40.0 * crest { (1.3 * crest + 0.6 - h).max(0.0) } else { 0.0 };
    // From below, the grid is that of the mirrored eye above the surface.
    let rise = above.max(-2.0 * h);
    u.eye_altitude = h as f32;
    u.air_sink = -libm::expm1(-h.max(0.0) / AIR_HEIGHT_M) as f32;
    u.semi_major = a as f32;
    u.quadric_diagonal = DVec3::new(q.x_axis.x, q.y_axis.y, q.z_axis.z).as_vec3();
    u.quadric_mixed = DVec3::new(q.y_axis.x, q.z_axis.x, q.z_axis.y).as_vec3();
    u.quadric_constant = constant_at(h) as f32;
    u.quadric_gradient = gradient_at(h).as_vec3();
    u.projector_rise = rise as f32;
    u.projector_constant = constant_at(h + rise) as f32;
    u.projector_gradient = gradient_at(h + rise).as_vec3();
    // Horizontal displacements are about as large as crests are high, times λ.
    u.rim_reach = if h < 40.0 * crest { (2.0 * crest * chop.max(0.5)) as f32 } else { 0.0 };
    u.crest_height = crest.max(0.05) as f32;
    u.sin_lat = sin as f32;
    u.cos_lat = cos as f32;
    u.foot_nu = nu as f32;
}

/// The earth as far as the water goes whose surface is so high over the ellipsoid, metres, for a grid among waves as high as `hs_m`: an ellipsoid
/// about it with the same normals. Distances on it are true to a part of 6e-4 at the level of the highest lake.
pub fn set_water_level(u: &mut FrameUniform, camera: &Camera, level_m: f64, hs_m: f64, chop: f64) {
    // The tables of the air are those of the sea's picture, and laid out by its crests (`floor_cosine` of shaders/lib/air_coordinates.wgsl).
    let (air_sink, crest_height) = (u.air_sink, u.crest_height);
    set_earth(u, &Camera { altitude_m: camera.altitude_m - level_m, ..*camera }, hs_m, chop);
    (u.air_sink, u.crest_height, u.water_level) = (air_sink, crest_height, level_m as f32);
}

/// The reference points of the three map squares: the eye's foot where the square holds it, else its nearest anchor.
pub fn set_map(u: &mut FrameUniform, camera: &Camera) {
    let (lat, lon) = (camera.lat, camera.lon);
    u.relief_eye = relief::place(earth::normal(lat, lon));
    let anchor = lat.clamp(-MERCATOR_LATITUDE_LIMIT + 0.01, MERCATOR_LATITUDE_LIMIT - 0.01);
    let fixed = |projection, lat: f64, lon: f64| {
        let p = MapPoint::on(projection, lat, lon);
        [p.u, p.v]
    };
    u.mercator_sin = libm::sin(anchor) as f32;
    u.mercator_sin_delta = (libm::sin(lat) - libm::sin(anchor)) as f32;
    u.mercator_fixed = fixed(Projection::Mercator, anchor, lon);
    u.meridian = DVec2::new(libm::cos(lon), libm::sin(lon)).as_vec2();
    u.bed_origin = bed_origin(lat, lon).as_vec2();
    let foot = DVec3::new(libm::cos(lat), 0.0, libm::sin(lat));
    let polar = |side: f64, projection| {
        let near = lat * side > 80f64.to_radians();
        let point = if near { DVec2::new(foot.x / (1.0 + side * foot.z), 0.0) } else { DVec2::ZERO };
        let reference = if near { foot } else { DVec3::new(0.0, 0.0, side) };
        let at = if near { lat } else { side * std::f64::consts::FRAC_PI_2 };
        (point.as_vec2(), (foot - reference).as_vec3(), fixed(projection, at, lon))
    };
    (u.north_point, u.north_delta, u.north_fixed) = polar(1.0, Projection::North);
    (u.south_point, u.south_delta, u.south_fixed) = polar(-1.0, Projection::South);
}

/// Side of the square of the bed's pattern, metres; equals `BED_SIDE` in `shaders/lib/bed_cover.wgsl`.
pub const BED_SIDE_M: f64 = 4096.0;

/// Where a place lies in the pattern of the bed: metres on Mercator's map, whose unit is that of the equator, or around a pole, in a square that
/// repeats.
fn bed_origin(lat: f64, lon: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(lat);
    let on_map = if libm::fabs(lat) > POLAR_LATITUDE_DEG.to_radians() {
        let from_pole = 2.0 * WGS84.a * cos / (1.0 + libm::fabs(sin));
        from_pole * DVec2::new(libm::cos(lon), libm::sin(lon))
    } else {
        // A turn has a whole number of squares.
        let squares = (std::f64::consts::TAU * WGS84.a / BED_SIDE_M).round();
        squares * BED_SIDE_M / std::f64::consts::TAU * DVec2::new(lon, libm::atanh(sin))
    };
    DVec2::new(on_map.x.rem_euclid(BED_SIDE_M), on_map.y.rem_euclid(BED_SIDE_M))
}
