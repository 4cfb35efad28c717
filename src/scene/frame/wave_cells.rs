//! The wave domain about an eye, as the GPU sees it: the cells that serve what is seen, with the lattices' vertices next to the eye.
//!
//! Integers carry the place on earth: a lattice vertex near the eye and the way from it, at most some kilometres, are exact to a
//! fraction of a millimetre in 32 bits.

use crate::model::earth::{self, WGS84};
use crate::model::sea_tables::SeaTables;
use crate::model::wave_domain::{self, Cell, MAX_CELLS, PERLIN_PATCH, Plane};
use crate::scene::frame::uniform::{FrameUniform, WaveAnchor, WaveCell};
use crate::scene::sea::foam::{self, FoamEye};
use crate::scene::settings::Settings;
use crate::scene::view::camera::Camera;

/// The cells that may serve what the eye sees, nearest first, how many they are, and the eye in the foam map.
pub fn around(
    u: &FrameUniform,
    settings: &Settings,
    camera: &Camera,
    sea: &SeaTables,
) -> ([WaveCell; MAX_CELLS], u32, FoamEye) {
    let eye = camera.eye_ecef();
    let enu_from_ecef = earth::ecef_from_enu(camera.lat, camera.lon).transpose();
    let mut cells = wave_domain::cells_near(camera.lat, camera.lon);
    // A cell can serve a point no farther than the horizon only if it is not much farther from the eye's foot than the nearest.
    let foot = Camera { altitude_m: 0.0, ..*camera }.eye_ecef();
    let reach = 1.2 * WGS84.horizon_distance(camera.altitude_m.max(20.0)) + 10_000.0;
    let nearest = cells.first().map_or(0.0, |cell| cell.centre.distance(foot));
    cells.retain(|cell| cell.centre.distance(foot) < nearest + 2.0 * reach + wave_domain::BLEND_WIDTH_M);
    let patch_m = |patch: usize| if patch == PERLIN_PATCH { sea.perlin.patch_m } else { sea.cascades[patch].patch_m };
    let seen_from_eye = |cell: &Cell| {
        let plane = Plane::new(cell, sea.sea.seed, settings.wind_from());
        let eye_in_plane = plane.point(eye);
        let anchor = |patch: usize| {
            let spacing = wave_domain::spacing_m(patch_m(patch));
            let (vertex, way) = wave_domain::anchor(eye_in_plane / spacing);
            WaveAnchor { vertex, eye: (spacing * way).as_vec2() }
        };
        WaveCell {
            origin: (enu_from_ecef * (plane.centre - eye)).as_vec3(),
            cos_lat: plane.cos_lat as f32,
            axis_x: (enu_from_ecef * plane.axes[0]).as_vec3(),
            turn: plane.turn as f32,
            axis_y: (enu_from_ecef * plane.axes[1]).as_vec3(),
            key: plane.key,
            wind: plane.wind.as_vec2(),
            polar_north: plane.polar_north.as_vec2(),
            anchors: std::array::from_fn(anchor),
        }
    };
    let mut wave_cells = [WaveCell::default(); MAX_CELLS];
    for (slot, cell) in wave_cells.iter_mut().zip(&cells) {
        *slot = seen_from_eye(cell);
    }
    let foam_eye = cells.first().map_or_else(FoamEye::default, |cell| FoamEye {
        frame: (cell.address, settings.wind_from().to_bits()),
        at: Plane::new(cell, sea.sea.seed, settings.wind_from()).point(eye),
        cells: cells.iter().filter(|cell| cell.centre.distance(foot) < nearest + foam::SERVED_M).count() as u32,
        finest: foam::finest_level((camera.altitude_m - f64::from(u.crest_height)) * f64::from(u.pixel_angle)),
    });
    (wave_cells, cells.len() as u32, foam_eye)
}
