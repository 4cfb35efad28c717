//! Where a wave is: the ellipsoid divided into cells, each with its own wind-aligned frame and its own place in the tiles.
//!
//! ```text
//!   one face of the circumscribed cuboid          a point near a border belongs to both cells;
//!   +----+----+----+----+                         weights w1² + w2² = 1 keep the variance of heights
//!   |  ↗ |  ↗ |  → |  → |                         w 1 ────╮    ╭────
//!   +----+----+----+----+   128 × 128 cells,               ╲  ╱
//!   |  ↗ | ↗  |  ↗ |  → |   about 78 km wide                ╳
//!   +----+----+----+----+   ↗ waves travel to            ╱  ╲
//!                                                 w 0 ───╯    ╰──── distance to cell 1 − distance to cell 2
//! ```
//! Membership depends on distances to cell centres alone, so cube edges, poles and the antimeridian are no special places,
//! and the sea at a place does not depend on where the eye came from. Rejected: one tangent plane that follows the eye
//! (two viewers would see two seas), and latitude-longitude cells (they shrink at the poles).

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::{DVec2, DVec3};

use crate::model::earth::{self, Geodetic, WGS84};
use crate::model::noise;
use crate::model::sea_bed::smoothstep;

/// Cells along the side of a face.
pub const CELLS: i32 = 128;

/// Cells that a frame can carry; equals `MAX_NODES` in `shaders/lib/frame.wgsl`.
pub const MAX_NODES: usize = 24;

/// A cell serves this much farther than the nearest one, metres; equals `BLEND_WIDTH` in `shaders/lib/waves.wgsl`.
pub const BLEND_WIDTH_M: f64 = 9_000.0;

/// Cells that serve a point (earth-centred, metres) with their weights, whose squares sum to one; the rest are left out.
pub fn blend(cells: &[Cell], point: DVec3) -> Vec<(&Cell, f64)> {
    let distance = |cell: &Cell| cell.centre.distance(point);
    let nearest = cells.iter().map(distance).fold(f64::INFINITY, f64::min);
    let weight = |cell| smoothstep(0.0, 1.0, 1.0 - (distance(cell) - nearest) / BLEND_WIDTH_M);
    let serving: Vec<_> = cells.iter().map(|cell| (cell, weight(cell))).filter(|(_, w)| *w > 0.0).collect();
    let norm = serving.iter().map(|(_, w)| w * w).sum::<f64>().sqrt();
    serving.into_iter().map(|(cell, w)| (cell, w / norm)).collect()
}

/// One cell of the wave domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Which one: face, column, row.
    pub address: [i32; 3],
    /// Geodetic latitude and longitude of its centre, radians.
    pub lat: f64,
    /// See `lat`.
    pub lon: f64,
    /// Its centre on the ellipsoid, earth-centred, metres.
    pub centre: DVec3,
}

/// Unit vector of a face's point (α, β), angles from the face's axis: the equiangular cube.
fn direction(face: i32, a: f64, b: f64) -> DVec3 {
    let (x, y) = (a.tan(), b.tan());
    let side = if face % 2 == 0 { 1.0 } else { -1.0 };
    match face / 2 {
        0 => DVec3::new(side, x, y),
        1 => DVec3::new(x, side, y),
        _ => DVec3::new(x, y, side),
    }
    .normalize()
}

/// (α, β) of a direction seen from a face, if it lies on the face's half of space.
fn angles(face: i32, n: DVec3) -> Option<(f64, f64)> {
    let side = if face % 2 == 0 { 1.0 } else { -1.0 };
    let (out, x, y) = match face / 2 {
        0 => (n.x, n.y, n.z),
        1 => (n.y, n.x, n.z),
        _ => (n.z, n.x, n.y),
    };
    (out * side > 0.3).then(|| ((x / (out * side)).atan(), (y / (out * side)).atan()))
}

/// The cells around a place, nearest first: at most [`MAX_NODES`].
pub fn cells_near(lat: f64, lon: f64) -> Vec<Cell> {
    let normal = earth::normal(lat, lon);
    let foot = WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 });
    let width = FRAC_PI_2 / f64::from(CELLS);
    let mut cells = Vec::new();
    for face in 0..6 {
        let Some((a, b)) = angles(face, normal) else { continue };
        let column = ((a + FRAC_PI_4) / width).floor() as i32;
        let row = ((b + FRAC_PI_4) / width).floor() as i32;
        for i in (column - 2).max(0)..=(column + 2).min(CELLS - 1) {
            for j in (row - 2).max(0)..=(row + 2).min(CELLS - 1) {
                let middle = |k: i32| (f64::from(k) + 0.5) * width - FRAC_PI_4;
                let n = direction(face, middle(i), middle(j));
                let (lat, lon) = (n.z.clamp(-1.0, 1.0).asin(), n.y.atan2(n.x));
                let centre = WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 });
                cells.push(Cell { address: [face, i, j], lat, lon, centre });
            }
        }
    }
    cells.sort_by(|p, q| p.centre.distance_squared(foot).total_cmp(&q.centre.distance_squared(foot)));
    cells.truncate(MAX_NODES);
    cells
}

impl Cell {
    /// Axes of the cell's wave tiles, earth-centred: x where the waves travel to, y to its left.
    ///
    /// `wind_from` is the compass bearing that the wind comes from, radians clockwise from the cell's north.
    pub fn axes(&self, wind_from: f64) -> (DVec3, DVec3) {
        let enu = earth::ecef_from_enu(self.lat, self.lon);
        let (sin, cos) = wind_from.sin_cos();
        (enu * DVec3::new(-sin, -cos, 0.0), enu * DVec3::new(cos, -sin, 0.0))
    }

    /// Where the cell's centre lies in tile number `tile` of length `patch_m`: a random place, the same for everyone.
    pub fn offset(&self, seed: u32, tile: u32, patch_m: f64) -> DVec2 {
        let key = self.address[0] * 65_536 + self.address[1] * 256 + self.address[2];
        let [u, v] = noise::bits(seed, 1_000 + tile, key, 0);
        let unit = |bits: u64| (bits >> 11) as f64 / (1u64 << 53) as f64;
        DVec2::new(unit(u), unit(v)) * patch_m
    }
}
