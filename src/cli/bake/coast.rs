//! The coast archive: shores simplified for each level, cut into tiles.

use super::shorelines::{BITS, Shoreline};
use super::simplify::simplified;
use crate::data::coast::write::{doubled_area, encode};
use crate::data::coast::{BUFFER_TEXELS, Level, Ring};
use crate::data::pmtiles::write::{ArchiveWriter, gzip};
use crate::data::tile::{EQUATOR_M, Projection, TILE_TEXELS, TileId};
use crate::error::Result;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// How deep and how exact.
pub struct Detail {
    /// The deepest level.
    pub max_zoom: u8,
    /// How far shores may be off at the deepest level, metres.
    pub tolerance_m: f64,
}

/// Shores may be off by this much of a texel at levels above the deepest.
const TOLERANCE_TEXELS: f64 = 0.2;
/// What is smaller is left out there, square texels.
const LEAST_TEXELS: f64 = 0.3;
/// From this level on islands are left out only where they vanish: eight of its texels are as far as distances shape the sea's bed, and an
/// island that tiles of one level know and those of the next coarser one do not would stand on a cliff.
const ALL_ISLANDS_FROM: u8 = 6;

/// 2^8 texels along a side of a tile.
const TILE_BITS: u32 = TILE_TEXELS.trailing_zeros();

/// Units along a side of a tile of a level: of the deepest one 19 m at the equator for level 8.
fn extent_bits(deepest: bool) -> u32 {
    if deepest { 13 } else { 12 }
}

/// Makes the tiles of Mercator's map: those that have a shore in them or within the buffer, and all above them.
pub fn add_tiles(
    writer: &mut ArchiveWriter,
    shores: Vec<Shoreline>,
    detail: &Detail,
    mut progress: impl FnMut(u8, usize, usize),
) -> Result<()> {
    let mut shores = shores;
    let mut needed: BTreeSet<TileId> = BTreeSet::new();
    for z in (0..=detail.max_zoom).rev() {
        let deepest = z == detail.max_zoom;
        let unit_bits = BITS - u32::from(z) - extent_bits(deepest);
        shores = shores.into_par_iter().filter_map(|line| at_level(line, z, deepest, detail)).collect();
        let rings: Vec<Ring> = shores
            .par_iter()
            .flat_map_iter(|line| {
                let across = 1 << (BITS - unit_bits);
                let points = rounded(&line.points, unit_bits);
                let buffer = BUFFER_TEXELS << (extent_bits(deepest) - TILE_BITS);
                // What lies near one end of the map lies beyond the other, too.
                [-across, 0, across].into_iter().filter_map(move |shift| {
                    let reaches = |x: i32| (-buffer..=across + buffer).contains(&(x + shift));
                    if points.len() < 3 || !points.iter().any(|point| reaches(point[0])) {
                        return None;
                    }
                    let moved = points.iter().map(|[x, y]| [x + shift, *y]).collect();
                    Some(Ring { level: line.level, points: moved })
                })
            })
            .collect();
        let extent = 1 << extent_bits(deepest);
        let cut = Cut { z, extent, needed: &needed };
        let tiles = cut.tiles(TileId::root(Projection::Mercator), rings);
        let all = tiles.len();
        needed = tiles.keys().flat_map(|tile| (0..z).filter_map(|above| tile.ancestor(above))).collect();
        for (done, (tile, rings)) in tiles.into_iter().enumerate() {
            writer.add(tile.z, tile.x, tile.y, &gzip(&encode(extent as u32, &rings))?)?;
            progress(z, done + 1, all);
        }
    }
    Ok(())
}

/// A line as a level has it, from the next deeper one's; `None` where it is too small.
fn at_level(line: Shoreline, z: u8, deepest: bool, detail: &Detail) -> Option<Shoreline> {
    let texel = f64::from(1u32 << (BITS - u32::from(z))) / TILE_TEXELS as f64;
    let is_least = line.level != Level::Land || z < ALL_ISLANDS_FROM;
    if is_least && !deepest && (doubled_area(&line.points).abs() as f64) < 2.0 * LEAST_TEXELS * texel * texel {
        return None;
    }
    let unit_m = EQUATOR_M / f64::from(1u32 << BITS);
    let coarse = if deepest { 0.0 } else { TOLERANCE_TEXELS * texel };
    let tolerance = |point: [i32; 2]| {
        // The cosine of the latitude: so much shorter is a unit on the ground.
        let cos_lat = 1.0 / ((0.5 - f64::from(point[1]) / f64::from(1u32 << BITS)) * std::f64::consts::TAU).cosh();
        (detail.tolerance_m / (unit_m * cos_lat)).max(coarse)
    };
    let across = 1 << BITS;
    let fixed = |[x, _]: [i32; 2]| x == 0 || x == across;
    Some(Shoreline { level: line.level, points: simplified(&line.points, tolerance, fixed) })
}

fn rounded(points: &[[i32; 2]], bits: u32) -> Vec<[i32; 2]> {
    let half = (1 << bits) >> 1;
    let mut rounded: Vec<_> = points.iter().map(|point| point.map(|x| (x + half) >> bits)).collect();
    rounded.dedup();
    while rounded.len() > 1 && rounded.first() == rounded.last() {
        rounded.pop();
    }
    rounded
}

/// Cutting a level's rings into its tiles.
struct Cut<'a> {
    z: u8,
    extent: i32,
    /// Tiles to make whatever is in them, and those above.
    needed: &'a BTreeSet<TileId>,
}

impl Cut<'_> {
    /// The tiles of the level in `id`, from all rings that reach it, in units of the level from the map's corner.
    fn tiles(&self, id: TileId, rings: Vec<Ring>) -> BTreeMap<TileId, Vec<Ring>> {
        let (low, high) = self.box_of(id);
        let rings: Vec<_> = rings.into_iter().filter_map(|ring| clipped(ring, low, high)).collect();
        if !self.needed.contains(&id) && rings.iter().all(|ring| !has_shore(ring, low, high)) {
            return BTreeMap::new();
        }
        match id.children().filter(|_| id.z < self.z) {
            Some(children) => children.into_par_iter().map(|child| self.tiles(child, rings.clone())).reduce(
                BTreeMap::new,
                |mut all, part| {
                    all.extend(part);
                    all
                },
            ),
            None => {
                let corner = [id.x, id.y].map(|tile| tile as i32 * self.extent);
                let inside = |ring: Ring| {
                    let points = ring.points.iter().map(|[x, y]| [x - corner[0], y - corner[1]]).collect();
                    Ring { level: ring.level, points }
                };
                BTreeMap::from([(id, rings.into_iter().map(inside).filter(|r| doubled_area(&r.points) != 0).collect())])
            }
        }
    }

    /// The corners of a tile with the buffer of the level around it.
    fn box_of(&self, id: TileId) -> ([i32; 2], [i32; 2]) {
        let buffer = BUFFER_TEXELS * self.extent / TILE_TEXELS as i32;
        let side = self.extent << (self.z - id.z);
        let corner = |more: i32| [id.x, id.y].map(|tile| (tile as i32 + more) * side);
        (corner(0).map(|x| x - buffer), corner(1).map(|x| x + buffer))
    }
}

/// Whether any side of a ring is a shore rather than the border of the box.
fn has_shore(ring: &Ring, low: [i32; 2], high: [i32; 2]) -> bool {
    let next = ring.points.iter().skip(1).chain(ring.points.first());
    ring.points
        .iter()
        .zip(next)
        .any(|(a, b)| !(0..2).any(|axis| a[axis] == b[axis] && (a[axis] == low[axis] || a[axis] == high[axis])))
}

/// What of a ring lies in a box (I. Sutherland and G. Hodgman 1974, doi:10.1145/360767.360802); parts are joined along its border.
fn clipped(ring: Ring, low: [i32; 2], high: [i32; 2]) -> Option<Ring> {
    let level = ring.level;
    let mut points = ring.points;
    for axis in 0..2 {
        for (limit, sign) in [(low[axis], 1), (high[axis], -1)] {
            let inside = |point: &[i32; 2]| sign * (point[axis] - limit) >= 0;
            let within = points.iter().filter(|point| inside(point)).count();
            if within == 0 {
                return None;
            }
            if within == points.len() {
                continue;
            }
            let mut kept: Vec<[i32; 2]> = Vec::with_capacity(points.len() + 8);
            let mut before = points[points.len() - 1];
            for point in points {
                if inside(&before) != inside(&point) {
                    kept.push(at_border(before, point, axis, limit));
                }
                if inside(&point) {
                    kept.push(point);
                }
                before = point;
            }
            kept.dedup();
            points = kept;
        }
    }
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    (points.len() >= 3).then_some(Ring { level, points })
}

/// Where a side meets a border; the same from both ends.
fn at_border(a: [i32; 2], b: [i32; 2], axis: usize, limit: i32) -> [i32; 2] {
    let (a, b) = if a <= b { (a, b) } else { (b, a) };
    let other = 1 - axis;
    let part = f64::from(limit - a[axis]) / f64::from(b[axis] - a[axis]);
    let mut point = [limit; 2];
    point[other] = a[other] + (part * f64::from(b[other] - a[other])).round() as i32;
    point
}

/// The vector layers of the archive, for whoever reads it.
pub fn layers() -> serde_json::Value {
    let layer = |level: Level| serde_json::json!({ "id": level.name(), "fields": {} });
    Level::ALL.map(layer).to_vec().into()
}
