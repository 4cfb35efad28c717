//! Where a wave is: the ellipsoid in cells, each a tangent plane, and in each plane a lattice for every wave patch, whose vertices
//! have a place in the patch and a turn along the wind of their own.
//!
//! ```text
//!  one face of the circumscribed cuboid    a cell's plane, x east, y north at       a vertex that serves a point lays its
//!  +----+----+----+----+                   its centre; one lattice for each patch   patch there: turned along the wind at
//!  |    |    |    |    |                     ·-----·-----·-----·                    the vertex, from a random place in it
//!  +----+----+----+----+                      \   / \ p / \   /                         ┌───────────┐
//!  |    |    |    |    |  128 × 128 cells      \ /   \ /   \ /                         ╱     · p   ╱
//!  +----+----+----+----+  of about 78 km     ---·-----·-----·---                      ╱  V        ╱ ↗ waves travel to
//!                                               0.8 of the patch                     └───────────┘
//!  weights of two cells, of the vertices of an edge:  1 ───╮  ╭───    w1² + w2² = 1 keeps the variance of heights
//!                                                           ╲╱
//!                                                     0 ───╯  ╰───
//! ```
//! The sea at a place depends on place, time, wind and seed alone. A cell serves where its centre is nearest, and fades over
//! [`BLEND_WIDTH_M`], so cube edges, poles and the antimeridian are no special places. A point of a plane lies in one triangle of a
//! patch's lattice, and each of its vertices serves as its barycentric share exceeds [`LEAST_SHARE`]. A vertex reaches less than
//! 0.64 of the patch's length, so two points a whole patch apart have next to no vertex in common: the patch's period is gone. North
//! turns under the lattice as on the globe; energies pass from vertex to vertex with the way, so the mean direction is the wind's.
//!
//! Why so: a patch with one place for 78 km shows its period, and its direction errs by half a degree times tan(latitude). Cells of
//! 4 km would do for the longest patch alone and need 30 million frames. Rejected: one tangent plane that follows the eye (two viewers
//! would see two seas), latitude-longitude cells (they shrink at the poles), squares for triangles (four vertices to sample, not
//! three; two on average with the least share). Vertices are integers that start at the cell's centre, hashed as integers, so that
//! they are the same for every eye.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use glam::{DVec2, DVec3};

use super::earth::{self, Geodetic, WGS84};
use super::noise;
use super::sea_bed::smoothstep;
use super::waves::CASCADES;

/// Cells along the side of a face.
pub const CELLS: i32 = 128;

/// Cells that a frame can carry; equals `MAX_CELLS` in `shaders/lib/frame.wgsl`.
pub const MAX_CELLS: usize = 24;

/// A cell serves this much farther than the nearest one, metres; equals `BLEND_WIDTH` in `shaders/lib/domain.wgsl`.
pub const BLEND_WIDTH_M: f64 = 9_000.0;

/// Patches that have a lattice: the cascades, then the far sea's; equals `PATCHES` in `shaders/lib/frame.wgsl`.
pub const PATCHES: usize = CASCADES + 1;

/// The far sea's patch among them.
pub const PERLIN_PATCH: usize = CASCADES;

/// A vertex serves where its barycentric share is above this; equals `LEAST_SHARE` in `shaders/lib/domain.wgsl`. Two vertices then
/// serve on average, and blends are half a lattice step wide: their gradients add less than 1 % to the variance of slopes.
pub const LEAST_SHARE: f64 = 0.2;

/// Rows of a lattice are this share of its spacing apart: nearly equilateral, and exact in 32 bits. `ROW` in `shaders/lib/domain.wgsl`.
pub const ROW: f64 = 0.875;

/// Nearer to a pole than this, in earth radii, north blends to one fixed direction: 85 km, so that at 100 km all vertices
/// that serve have their true north. `POLAR_REACH` in `shaders/lib/domain.wgsl`.
pub const POLAR_REACH: f64 = 0.0133;

/// Distance of neighbouring vertices on a row of the lattice of a patch, metres: 0.8 of its length, in 6 significant bits, so that
/// multiples are exact in 32-bit floats.
pub fn spacing_m(patch_m: f64) -> f64 {
    let wanted = 0.8 * patch_m;
    let power_of_two = f64::from_bits(wanted.to_bits() & !((1 << 52) - 1));
    let unit = power_of_two / 32.0;
    (wanted / unit).round() * unit
}

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
    let (x, y) = (libm::tan(a), libm::tan(b));
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
    (out * side > 0.3).then(|| (libm::atan(x / (out * side)), libm::atan(y / (out * side))))
}

/// The cells around a place, nearest first: at most [`MAX_CELLS`].
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
                let (lat, lon) = (libm::atan2(n.z, libm::hypot(n.x, n.y)), libm::atan2(n.y, n.x));
                let centre = WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: 0.0 });
                cells.push(Cell { address: [face, i, j], lat, lon, centre });
            }
        }
    }
    cells.sort_by(|p, q| p.centre.distance_squared(foot).total_cmp(&q.centre.distance_squared(foot)));
    cells.truncate(MAX_CELLS);
    cells
}

/// A cell's plane under a wind. Its coordinates are metres east and north of the cell's centre.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// The cell's centre, earth-centred, metres.
    pub centre: DVec3,
    /// Its axes, earth-centred: east and north at the centre.
    pub axes: [DVec3; 2],
    /// North at (x, y) is along (−x turn, `cos_lat` − y turn): the cosine of the centre's latitude, and its sine over the radius of
    /// curvature, 1/m.
    pub cos_lat: f64,
    /// See `cos_lat`.
    pub turn: f64,
    /// The direction that stands for north at the nearer pole: the prime meridian's.
    pub polar_north: DVec2,
    /// Sine and cosine of the bearing that the wind comes from.
    pub wind: DVec2,
    /// Random bits, the same for everyone.
    pub key: u32,
}

/// A patch as one vertex of its lattice lays it under a point.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// Which vertex.
    pub vertex: [i32; 2],
    /// Its weight; squares sum to one.
    pub weight: f64,
    /// The point in the patch, metres, not reduced to one period.
    pub at: DVec2,
    /// The patch's axes in the plane: x where the waves travel to, y to its left.
    pub axes: [DVec2; 2],
}

impl Plane {
    /// The plane of a cell, in the sea that `seed` chooses, under a wind from bearing `wind_from` (radians clockwise from north).
    pub fn new(cell: &Cell, seed: u32, wind_from: f64) -> Self {
        let enu = earth::ecef_from_enu(cell.lat, cell.lon);
        let axes = [enu.x_axis, enu.y_axis];
        let (sin, cos) = libm::sincos(cell.lat);
        let (a, b) = (WGS84.a, WGS84.b);
        let radius = a * a / (a * a * cos * cos + b * b * sin * sin).sqrt();
        // Northward on the prime meridian is −x at the north pole, +x at the south pole.
        let polar_north = DVec2::new(axes[0].x, axes[1].x) * -cell.lat.signum();
        let (wind_sin, wind_cos) = libm::sincos(wind_from);
        let [face, i, j] = cell.address;
        Self {
            centre: cell.centre,
            axes,
            cos_lat: cos,
            turn: sin / radius,
            polar_north,
            wind: DVec2::new(wind_sin, wind_cos),
            key: (noise::bits(seed, 1_000, face * 65_536 + i * 256 + j, 0)[0] >> 32) as u32,
        }
    }

    /// A point (earth-centred, metres) in the plane.
    pub fn point(&self, ecef: DVec3) -> DVec2 {
        DVec2::new((ecef - self.centre).dot(self.axes[0]), (ecef - self.centre).dot(self.axes[1]))
    }

    /// The unit vector that is north at a place of the plane.
    pub fn north_at(&self, place: DVec2) -> DVec2 {
        let v = DVec2::new(-place.x * self.turn, self.cos_lat - place.y * self.turn);
        let from_pole = v.length();
        let north = v / from_pole.max(1e-9);
        if from_pole >= POLAR_REACH {
            return north;
        }
        let blended = self.polar_north.lerp(north, smoothstep(0.0, POLAR_REACH, from_pole));
        // Where north runs against it, there is no direction in between.
        if blended.length() < 1e-3 { self.polar_north } else { blended.normalize() }
    }

    /// The placements of patch number `patch`, `patch_m` long, under a point of the plane.
    pub fn placements(&self, patch: usize, patch_m: f64, point: DVec2) -> impl Iterator<Item = Placement> + use<> {
        let (plane, spacing) = (*self, spacing_m(patch_m));
        around(point / spacing).into_iter().filter(|(_, weight)| *weight > 0.0).map(move |(vertex, weight)| {
            let place = spacing * vertex_at(vertex);
            let north = plane.north_at(place);
            let east = DVec2::new(north.y, -north.x);
            let axes = [-plane.wind.x * east - plane.wind.y * north, plane.wind.y * east - plane.wind.x * north];
            let arm = point - place;
            let at = DVec2::new(arm.dot(axes[0]), arm.dot(axes[1])) + patch_m * plane.offset(patch, vertex);
            Placement { vertex, weight, at, axes }
        })
    }

    /// Where a vertex stands in a patch, in patch lengths.
    fn offset(&self, patch: usize, [i, j]: [i32; 2]) -> DVec2 {
        let key = self.key.wrapping_add((patch as u32).wrapping_mul(0x9E37_79B9));
        let bits = noise::hash([i as u32, j as u32, key]);
        DVec2::new(f64::from(bits >> 16), f64::from(bits & 0xFFFF)) / 65_536.0 - 0.5
    }
}

/// A vertex of a lattice in its plane, in spacings.
fn vertex_at([i, j]: [i32; 2]) -> DVec2 {
    DVec2::new(f64::from(i) + 0.5 * f64::from(j), ROW * f64::from(j))
}

/// The vertex near a point (in spacings) that the GPU counts from, and the way from it to the point.
pub fn anchor(point: DVec2) -> ([i32; 2], DVec2) {
    let j = (point.y / ROW).round();
    let vertex = [(point.x - 0.5 * j).round() as i32, j as i32];
    (vertex, point - vertex_at(vertex))
}

/// The vertices around a point (in spacings) with their weights.
pub fn around(point: DVec2) -> [([i32; 2], f64); 3] {
    let v = point.y / ROW;
    let u = point.x - 0.5 * v;
    let (i, j) = (u.floor() as i32, v.floor() as i32);
    let (f, g) = (u - u.floor(), v - v.floor());
    let shares = if f + g < 1.0 {
        [([i, j], 1.0 - f - g), ([i + 1, j], f), ([i, j + 1], g)]
    } else {
        [([i + 1, j + 1], f + g - 1.0), ([i, j + 1], 1.0 - f), ([i + 1, j], 1.0 - g)]
    };
    let weights = shares.map(|(_, share)| (share - LEAST_SHARE).max(0.0));
    let norm = weights.iter().map(|w| w * w).sum::<f64>().sqrt();
    std::array::from_fn(|k| (shares[k].0, weights[k] / norm))
}
