//! The coast archive: shores and rivers simplified for each level, cut into tiles.

use super::clip::{self, Bounds};
use super::rivers::Course;
use super::shorelines::{BITS, Shoreline};
use super::simplify::simplified;
use crate::data::coast::write::{doubled_area, encode};
use crate::data::coast::{BUFFER_TEXELS, Level, Ring, River, Stream};
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

/// The lines of a level or of a tile.
#[derive(Clone)]
struct Lines {
    rings: Vec<Ring>,
    rivers: Vec<River>,
}

/// Makes the tiles of Mercator's map: those that have a shore or a river in them or within the buffer, and all above them.
pub fn add_tiles(
    writer: &mut ArchiveWriter,
    (shores, rivers): (Vec<Shoreline>, Vec<Course>),
    detail: &Detail,
    mut progress: impl FnMut(u8, usize, usize),
) -> Result<()> {
    let (mut shores, mut rivers) = (shores, rivers);
    let mut needed: BTreeSet<TileId> = BTreeSet::new();
    for z in (0..=detail.max_zoom).rev() {
        let deepest = z == detail.max_zoom;
        let unit_bits = BITS - u32::from(z) - extent_bits(deepest);
        shores = shores.into_par_iter().filter_map(|line| at_level(line, z, deepest, detail)).collect();
        rivers =
            rivers.into_par_iter().map(|line| line.simplified(|point| tolerance(point, z, deepest, detail))).collect();
        let rings = shores.par_iter().flat_map_iter(|line| {
            let points = around(rounded(&line.points, unit_bits, true), unit_bits, deepest, 3);
            points.map(|points| Ring { level: line.level, points })
        });
        let shown = rivers.par_iter().filter(|line| line.is_at(z, deepest));
        let shown = shown.flat_map_iter(|line| {
            let points = around(rounded(&line.points, unit_bits, false), unit_bits, deepest, 2);
            points.map(|points| River { stream: line.stream, points })
        });
        let lines = Lines { rings: rings.collect(), rivers: shown.collect() };
        let extent = 1 << extent_bits(deepest);
        let cut = Cut { z, extent, needed: &needed };
        let tiles = cut.tiles(TileId::root(Projection::Mercator), lines);
        let all = tiles.len();
        needed = tiles.keys().flat_map(|tile| (0..z).filter_map(|above| tile.ancestor(above))).collect();
        for (done, (tile, Lines { rings, rivers })) in tiles.into_iter().enumerate() {
            writer.add(tile.z, tile.x, tile.y, &gzip(&encode(extent as u32, &rings, &rivers))?)?;
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
    let across = 1 << BITS;
    let fixed = |[x, _]: [i32; 2]| x == 0 || x == across;
    let tolerance = |point: [i32; 2]| tolerance(point, z, deepest, detail);
    Some(Shoreline { level: line.level, points: simplified(&line.points, tolerance, fixed) })
}

/// How far a line may be off at a point, in units of the whole map.
fn tolerance(point: [i32; 2], z: u8, deepest: bool, detail: &Detail) -> f64 {
    let texel = f64::from(1u32 << (BITS - u32::from(z))) / TILE_TEXELS as f64;
    let unit_m = EQUATOR_M / f64::from(1u32 << BITS);
    // The cosine of the latitude: so much shorter is a unit on the ground.
    let cos_lat = 1.0 / ((0.5 - f64::from(point[1]) / f64::from(1u32 << BITS)) * std::f64::consts::TAU).cosh();
    (detail.tolerance_m / (unit_m * cos_lat)).max(if deepest { 0.0 } else { TOLERANCE_TEXELS * texel })
}

/// A line of some points or more where the map shows it: what lies near one end of the map lies beyond the other, too.
fn around(points: Vec<[i32; 2]>, unit_bits: u32, deepest: bool, least: usize) -> impl Iterator<Item = Vec<[i32; 2]>> {
    let across = 1 << (BITS - unit_bits);
    let buffer = BUFFER_TEXELS << (extent_bits(deepest) - TILE_BITS);
    [-across, 0, across].into_iter().filter_map(move |shift| {
        let reaches = |x: i32| (-buffer..=across + buffer).contains(&(x + shift));
        if points.len() < least || !points.iter().any(|point| reaches(point[0])) {
            return None;
        }
        Some(points.iter().map(|[x, y]| [x + shift, *y]).collect())
    })
}

fn rounded(points: &[[i32; 2]], bits: u32, closed: bool) -> Vec<[i32; 2]> {
    let half = (1 << bits) >> 1;
    let mut rounded: Vec<_> = points.iter().map(|point| point.map(|x| (x + half) >> bits)).collect();
    rounded.dedup();
    while closed && rounded.len() > 1 && rounded.first() == rounded.last() {
        rounded.pop();
    }
    rounded
}

/// Cutting a level's lines into its tiles.
struct Cut<'a> {
    z: u8,
    extent: i32,
    /// Tiles to make whatever is in them, and those above.
    needed: &'a BTreeSet<TileId>,
}

impl Cut<'_> {
    /// The tiles of the level in `id`, from all lines that reach it, in units of the level from the map's corner.
    fn tiles(&self, id: TileId, Lines { rings, rivers }: Lines) -> BTreeMap<TileId, Lines> {
        let bounds = self.box_of(id);
        let rings: Vec<_> = rings.into_iter().filter_map(|ring| clip::ring(ring, bounds)).collect();
        let rivers: Vec<_> = rivers.iter().flat_map(|river| clip::river(river, bounds)).collect();
        let is_empty = rivers.is_empty() && rings.iter().all(|ring| !has_shore(ring, bounds));
        if !self.needed.contains(&id) && is_empty {
            return BTreeMap::new();
        }
        let lines = Lines { rings, rivers };
        match id.children().filter(|_| id.z < self.z) {
            Some(children) => children.into_par_iter().map(|child| self.tiles(child, lines.clone())).reduce(
                BTreeMap::new,
                |mut all, part| {
                    all.extend(part);
                    all
                },
            ),
            None => {
                let corner = [id.x, id.y].map(|tile| tile as i32 * self.extent);
                let inside = |points: &[[i32; 2]]| points.iter().map(|[x, y]| [x - corner[0], y - corner[1]]).collect();
                let rings = lines.rings.iter().map(|ring| Ring { level: ring.level, points: inside(&ring.points) });
                let rivers =
                    lines.rivers.iter().map(|river| River { stream: river.stream, points: inside(&river.points) });
                let rings = rings.filter(|ring| doubled_area(&ring.points) != 0).collect();
                BTreeMap::from([(id, Lines { rings, rivers: rivers.collect() })])
            }
        }
    }

    /// The corners of a tile with the buffer of the level around it.
    fn box_of(&self, id: TileId) -> Bounds {
        let buffer = BUFFER_TEXELS * self.extent / TILE_TEXELS as i32;
        let side = self.extent << (self.z - id.z);
        let corner = |more: i32| [id.x, id.y].map(|tile| (tile as i32 + more) * side);
        (corner(0).map(|x| x - buffer), corner(1).map(|x| x + buffer))
    }
}

/// Whether any side of a ring is a shore rather than the border of the box.
fn has_shore(ring: &Ring, (low, high): Bounds) -> bool {
    let next = ring.points.iter().skip(1).chain(ring.points.first());
    ring.points
        .iter()
        .zip(next)
        .any(|(a, b)| !(0..2).any(|axis| a[axis] == b[axis] && (a[axis] == low[axis] || a[axis] == high[axis])))
}

/// The vector layers of the archive, for whoever reads it.
pub fn layers() -> serde_json::Value {
    let names = Level::ALL.map(Level::name).into_iter().chain(Stream::ALL.map(Stream::name));
    names.map(|name| serde_json::json!({ "id": name, "fields": {} })).collect()
}
