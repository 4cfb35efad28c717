//! Classes and distances of a water tile from the shores of its own coast tile, or of an ancestor's where the archive ends.
//!
//! Only sums, products, quotients and square roots of doubles decide the numbers, and [`libm`]: every machine gets the same.
//!
//! Each texel of the tile and of a margin learns the nearest shore from its neighbours in two sweeps (P.-E. Danielsson 1980,
//! doi:10.1016/0146-664X(80)90054-4), where its distance to the piece itself counts, which is exact. The side is told by how many borders
//! of each level lie to the left.

use super::curve::Curves;
use super::river::Rivers;
use super::sweep::{Piece, Sweep};
use super::{Level, Shores};
use crate::data::tile::{Projection, TILE_TEXELS, TileId, lat_lon_from_map};
use crate::data::water::{OwnShores, SATURATION_STEPS, STEPS_PER_TEXEL, WaterClass};
use std::f64::consts::TAU;

/// Texels around the tile: as far as distances are told, and one.
pub(super) const MARGIN: usize = 9;
/// Texels along a side of the grid.
pub(super) const SIDE: usize = TILE_TEXELS + 2 * MARGIN;
/// Distances are told this far, texels.
pub(super) const REACH: f64 = SATURATION_STEPS as f64 / STEPS_PER_TEXEL;
/// To this level scale differs within [`REACH`] by more than a hundredth somewhere on the map.
const UNEVEN: u8 = 6;

/// What `shores`, those of the ancestor of `tile` of level `z`, say of it; `None` where none of them is within reach.
pub fn field(tile: TileId, z: u8, shores: &Shores) -> Option<OwnShores> {
    let source = tile.ancestor(z)?;
    let (down, unit) = ((1u64 << (tile.z - z)) as f64, 1.0 / f64::from(shores.extent));
    let corner = [tile.x - (source.x << (tile.z - z)), tile.y - (source.y << (tile.z - z))];
    let texels = TILE_TEXELS as f64;
    let place = |point: [i32; 2]| {
        let at = |axis: usize| f64::from(point[axis]) * unit * down - f64::from(corner[axis]);
        [at(0) * texels + MARGIN as f64, at(1) * texels + MARGIN as f64]
    };
    let mut borders = vec![0u8; SIDE * (SIDE + 1)];
    let mut pieces = [Vec::new(), Vec::new()];
    let side = SIDE as f64;
    let mut curves = Curves::of(tile, down);
    let (mut points, mut are_shores) = (Vec::new(), Vec::new());
    for ring in &shores.rings {
        let draw = |a: [f64; 2], b: [f64; 2], is_shore: bool| {
            if a[1].max(b[1]) < 0.0 || a[1].min(b[1]) > side {
                return;
            }
            cross(&mut borders, ring.level, a, b);
            if is_shore && a[0].max(b[0]) >= 0.0 && a[0].min(b[0]) <= side {
                pieces[usize::from(ring.level != Level::Land)].push(Piece::new(a, b));
            }
        };
        points.clear();
        points.extend(ring.points.iter().map(|point| place(*point)));
        are_shores.clear();
        are_shores.extend(shores.are_shores(ring, source));
        match &mut curves {
            Some(curves) => curves.ring(&points, &are_shores, draw),
            None => straight(&points, &are_shores, draw),
        }
    }
    let mut rivers = Rivers::new(tile, &shores.rivers);
    for river in &shores.rivers {
        points.clear();
        points.extend(river.points.iter().map(|point| place(*point)));
        // Nothing leads from its end back to its beginning.
        are_shores.clear();
        are_shores.extend((1..=points.len()).map(|next| next < points.len()));
        let draw = |a: [f64; 2], b: [f64; 2], is_river: bool| {
            if is_river {
                rivers.add(river.stream, a, b);
            }
        };
        match &mut curves {
            Some(curves) => {
                curves.rivers(river.stream.smooth_m());
                curves.ring(&points, &are_shores, draw);
            }
            None => straight(&points, &are_shores, draw),
        }
    }
    let scale = (tile.z < UNEVEN).then(|| scales(tile));
    let classes = classes(&borders);
    let [ocean, lake] = [0, 1].map(|shore| Sweep::new(&pieces[shore], scale.as_deref()));
    let inside = |at: usize| (at / TILE_TEXELS + MARGIN) * SIDE + at % TILE_TEXELS + MARGIN;
    let texels = 0..TILE_TEXELS * TILE_TEXELS;
    // Empty where there are none.
    let banks: Vec<f64> =
        if rivers.is_empty() { Vec::new() } else { texels.clone().map(|at| rivers.texels(at)).collect() };
    let is_far = |at: usize| {
        let far = ocean.texels(inside(at)).min(lake.texels(inside(at))) >= REACH;
        far && banks.get(at).is_none_or(|bank| *bank <= -REACH)
    };
    if tile.z > z && texels.clone().all(is_far) {
        return None;
    }
    let room = texels.len();
    let mut own = OwnShores {
        steps: Vec::with_capacity(room),
        classes: Vec::with_capacity(room),
        by_river: Vec::with_capacity(banks.len()),
    };
    for at in texels {
        let (cell, mut class) = (inside(at), classes[inside(at)]);
        let mut signed = [(&ocean, WaterClass::Ocean), (&lake, WaterClass::Lake)].map(|(shores, wet)| {
            let texels = shores.texels(cell);
            if class == wet as u8 { texels } else { -texels }
        });
        if let Some(bank) = banks.get(at).copied() {
            let is_nearer = bank > signed[1];
            signed[1] = signed[1].max(bank);
            // The ocean and lakes stay what they are.
            if bank > 0.0 && [WaterClass::Land, WaterClass::Island].iter().any(|dry| *dry as u8 == class) {
                class = WaterClass::River as u8;
            }
            own.by_river.push(is_nearer && class != WaterClass::Lake as u8);
        }
        own.steps.push(signed.map(steps));
        own.classes.push(class);
    }
    Some(own)
}

/// Draws the sides as they are.
fn straight(points: &[[f64; 2]], are_shores: &[bool], mut draw: impl FnMut([f64; 2], [f64; 2], bool)) {
    let next = points.iter().skip(1).chain(points.first());
    points.iter().zip(next).zip(are_shores).for_each(|((a, b), is_shore)| draw(*a, *b, *is_shore));
}

/// Signed steps, never zero.
fn steps(texels: f64) -> i16 {
    let steps = (texels.abs() * STEPS_PER_TEXEL).round().clamp(1.0, f64::from(SATURATION_STEPS)) as i16;
    if texels > 0.0 { steps } else { -steps }
}

/// Marks, in each row, the first texel whose centre lies to the right of a side.
fn cross(borders: &mut [u8], level: Level, a: [f64; 2], b: [f64; 2]) {
    let (top, bottom) = if a[1] <= b[1] { (a, b) } else { (b, a) };
    // Rows whose middles lie in [top, bottom).
    let first = (top[1] - 0.5).ceil().max(0.0) as usize;
    let end = (bottom[1] - 0.5).ceil().clamp(0.0, SIDE as f64) as usize;
    if first >= end {
        return;
    }
    let slope = (bottom[0] - top[0]) / (bottom[1] - top[1]);
    for row in first..end {
        let x = top[0] + (row as f64 + 0.5 - top[1]) * slope;
        let column = (x - 0.5).ceil().clamp(0.0, SIDE as f64) as usize;
        borders[row * (SIDE + 1) + column] ^= 1 << level as u8;
    }
}

fn classes(borders: &[u8]) -> Vec<u8> {
    let mut classes = Vec::with_capacity(SIDE * SIDE);
    for row in borders.chunks_exact(SIDE + 1) {
        let mut within = 0;
        for border in &row[..SIDE] {
            within ^= border;
            let is_in = |level: Level| within & 1 << level as u8 != 0;
            let class = if !is_in(Level::Land) {
                WaterClass::Ocean
            } else if !is_in(Level::Lake) {
                WaterClass::Land
            } else if is_in(Level::Island) && !is_in(Level::Pond) {
                WaterClass::Island
            } else {
                WaterClass::Lake
            };
            classes.push(class as u8);
        }
    }
    classes
}

/// Ground metres of a texel of each row of the grid, over those at the equator. Mercator's alone.
fn scales(tile: TileId) -> Vec<f64> {
    let of = |row: usize| {
        let (x, y) = tile.texel_centre(0.0, row as f64 - MARGIN as f64);
        // sech of Mercator's ordinate is the cosine of the latitude.
        match tile.projection {
            Projection::Mercator => 1.0 / libm::cosh((0.5 - y) * TAU),
            polar => libm::cos(lat_lon_from_map(polar, x, y).0),
        }
    };
    (0..SIDE).map(of).collect()
}
