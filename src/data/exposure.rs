//! How far the shores are from a place in each direction, and how closely a ray passes them: marches through the distances of the water
//! tiles, each step as long as the nearest shore is far (sphere tracing).
//!
//! A ray near its place looks at fine tiles, farther out at coarser ones, whose texels are a sixteenth of the way or less: which tiles these
//! are follows from the place alone, never from what happens to be at hand, so that everyone finds the same. On Mercator's map alone,
//! where a ray is a line of constant bearing: over the 300 km that it goes at most that is the shortest way to a few kilometres.

use std::collections::HashMap;
use std::f64::consts::TAU;

use super::tile::{EQUATOR_M, Projection, TILE_TEXELS, TileId, lat_lon_from_map, texels_across};
use super::water::{STEPS_PER_TEXEL, unpacked};
use super::{SharedTexels, TileTexels};
use crate::model::lakes::{self, Stands};
use crate::model::sheltered_sea::{Exposure, FARTHEST_M, bearing};

/// What is known of a tile.
#[derive(Debug, Clone)]
pub enum Found {
    /// Its texels.
    Tile(SharedTexels),
    /// There is none: the parent serves.
    Absent,
    /// It is on its way.
    Coming,
}

/// Texels of the way from the place to a point of its ray, at least.
const TEXELS_OF_WAY: f64 = 16.0;
/// The coarsest level that is looked at: texels of 39 km at the equator.
const COARSEST: u8 = 2;
/// Share of the distance to the nearest shore that a step goes: on a ridge of the distance texels may say a little too much.
const STEP: f64 = 0.9;
/// Steps are no shorter than this share of the way, nor than a part of a texel.
const LEAST_STEP: f64 = 1.0 / 24.0;
/// Waves that are blocked by so much, m^½, are gone, whatever their length.
const GONE: f64 = 60.0;

/// Which shores stand in the way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Water {
    /// Those of the ocean.
    Ocean = 0,
    /// Those of lakes.
    Lake = 1,
}

/// What is asked of a world: its water tiles, and where inland waters stand.
pub trait Waters {
    /// A tile.
    fn tile(&mut self, id: TileId) -> Found;

    /// Where the inland water nearest to a place of Mercator's unit map stands, by tiles of level `z`; `Some(None)` where that is not known, `None`
    /// while tiles are on their way. The table's lakes, unless more is known.
    fn stands(&mut self, _z: u8, (x, y): (f64, f64)) -> Option<Option<Stands>> {
        let (lat, lon) = lat_lon_from_map(Projection::Mercator, x, y);
        Some(lakes::at(lat, lon).map(Stands::of))
    }
}

impl<F: FnMut(TileId) -> Found> Waters for F {
    fn tile(&mut self, id: TileId) -> Found {
        self(id)
    }
}

/// Distances to the shores, looked up in tiles that `look` finds, each once. The most of them are kept for later looks.
#[derive(Debug, Default)]
pub struct ShoreTiles {
    tiles: HashMap<TileId, Option<SharedTexels>>,
}

impl ShoreTiles {
    /// Forgets the tiles.
    pub fn clear(&mut self) {
        self.tiles.clear();
    }

    /// For looks that ask `look` for tiles that are not there yet.
    pub fn looking<'a>(&'a mut self, look: &'a mut dyn Waters) -> ShoreDistances<'a> {
        ShoreDistances { tiles: &mut self.tiles, look, recent: None }
    }
}

/// See [`ShoreTiles::looking`].
pub struct ShoreDistances<'a> {
    tiles: &'a mut HashMap<TileId, Option<SharedTexels>>,
    look: &'a mut dyn Waters,
    recent: Option<(TileId, Option<SharedTexels>)>,
}

/// Cosine of the latitude at a height of Mercator's unit map.
pub fn cos_lat(y: f64) -> f64 {
    1.0 / libm::cosh(TAU * (0.5 - y))
}

impl ShoreDistances<'_> {
    /// Signed distances to the shores of ocean and lakes at a place of Mercator's unit map, metres, positive in the water; `None`
    /// while a tile is on its way.
    pub fn distances_m(&mut self, z: u8, (x, y): (f64, f64)) -> Option<[f64; 2]> {
        let texel_m = EQUATOR_M * cos_lat(y) / texels_across(z);
        Some(self.texels(z, x, y)?.map(|texels| texels * texel_m))
    }

    /// The same in texels of level `z`, bilinear.
    fn texels(&mut self, z: u8, x: f64, y: f64) -> Option<[f64; 2]> {
        let side = texels_across(z);
        let (gx, gy) = (x * side - 0.5, y * side - 0.5);
        let (i, j) = (gx.floor(), gy.floor());
        let (fx, fy) = (gx - i, gy - j);
        // Mostly all four are one tile's.
        let within = |at: f64| {
            (at >= 0.0 && at < side - 1.0).then_some(at as usize).filter(|at| at % TILE_TEXELS != TILE_TEXELS - 1)
        };
        if let (Some(i), Some(j)) = (within(i), within(j)) {
            let [x, y] = [i, j].map(|at| (at / TILE_TEXELS) as u32);
            self.turn_to(TileId { projection: Projection::Mercator, z, x, y })?;
            if let Some(TileTexels::Water(texels)) = self.recent.as_ref().and_then(|(_, texels)| texels.as_deref()) {
                let first = j % TILE_TEXELS * TILE_TEXELS + i % TILE_TEXELS;
                let at = |index: usize| unpacked(texels[index]).0.map(f64::from);
                let [a, b] = [at(first), at(first + 1)];
                let [c, d] = [at(first + TILE_TEXELS), at(first + TILE_TEXELS + 1)];
                return Some([0, 1].map(|shore| {
                    let top = a[shore] + fx * (b[shore] - a[shore]);
                    let bottom = c[shore] + fx * (d[shore] - c[shore]);
                    (top + fy * (bottom - top)) / STEPS_PER_TEXEL
                }));
            }
        }
        let mut sum = [0.0; 2];
        for (di, dj, weight) in
            [(0, 0, (1.0 - fx) * (1.0 - fy)), (1, 0, fx * (1.0 - fy)), (0, 1, (1.0 - fx) * fy), (1, 1, fx * fy)]
        {
            let own = self.texel(z, i as i64 + di, j as i64 + dj)?;
            sum = [sum[0] + weight * own[0], sum[1] + weight * own[1]];
        }
        Some(sum)
    }

    /// See [`Waters::stands`].
    pub fn stands(&mut self, z: u8, at: (f64, f64)) -> Option<Option<Stands>> {
        self.look.stands(z, at)
    }

    fn texel(&mut self, z: u8, column: i64, row: i64) -> Option<[f64; 2]> {
        let side = (TILE_TEXELS as i64) << z;
        let (column, row) = (column.rem_euclid(side), row.clamp(0, side - 1));
        let id = TileId { projection: Projection::Mercator, z, x: (column >> 8) as u32, y: (row >> 8) as u32 };
        self.turn_to(id)?;
        let index = (row & 255) as usize * TILE_TEXELS + (column & 255) as usize;
        match self.recent.as_ref().and_then(|(_, texels)| texels.as_deref()) {
            Some(TileTexels::Water(texels)) => {
                Some(unpacked(texels[index]).0.map(|steps| f64::from(steps) / STEPS_PER_TEXEL))
            }
            // Its parent serves; without any there is no shore.
            _ if z > 0 => {
                let centre = [column, row].map(|at| (at as f64 + 0.5) / side as f64);
                Some(self.texels(z - 1, centre[0], centre[1])?.map(|texels| 2.0 * texels))
            }
            _ => Some([TILE_TEXELS as f64, -(TILE_TEXELS as f64)]),
        }
    }

    /// Makes a tile the one that is looked at.
    fn turn_to(&mut self, id: TileId) -> Option<()> {
        if self.recent.as_ref().is_none_or(|(recent, _)| *recent != id) {
            self.recent = Some((id, self.tile(id)?));
        }
        Some(())
    }

    fn tile(&mut self, id: TileId) -> Option<Option<SharedTexels>> {
        if let Some(known) = self.tiles.get(&id) {
            return Some(known.clone());
        }
        let found = match self.look.tile(id) {
            Found::Tile(texels) => Some(texels),
            Found::Absent => None,
            Found::Coming => return None,
        };
        self.tiles.insert(id, found.clone());
        Some(found)
    }

    /// The exposure of a place of the unit map towards a direction, looking at tiles of level `finest` at most; `None` while one is on
    /// its way.
    pub fn exposure(&mut self, at: (f64, f64), direction: usize, water: Water, finest: u8) -> Option<Exposure> {
        let (sin, cos) = libm::sincos(bearing(direction));
        let (mut x, mut y) = at;
        let mut found = Exposure::OPEN;
        let (mut way_m, mut is_blocked) = (0.0, false);
        let mut shore_m = self.distances_m(finest, at)?[water as usize];
        let mut level = finest;
        loop {
            let metres = EQUATOR_M * cos_lat(y);
            let texel_m = metres / texels_across(level);
            let step_m = (STEP * shore_m.abs()).max(LEAST_STEP * way_m).max(0.7 * texel_m);
            way_m += step_m;
            (x, y) = ((x + sin * step_m / metres).rem_euclid(1.0), y - cos * step_m / metres);
            if way_m > FARTHEST_M || !(0.0..1.0).contains(&y) {
                return Some(found);
            }
            let fitting = libm::ceil(libm::log2(TEXELS_OF_WAY * metres / (TILE_TEXELS as f64 * way_m)));
            level = (fitting as u8).clamp(COARSEST.min(finest), finest);
            shore_m = self.distances_m(level, (x, y))?[water as usize];
            let clearance = shore_m / libm::sqrt(way_m);
            if shore_m <= 0.0 && !is_blocked {
                (is_blocked, found.fetch_m) = (true, way_m + shore_m);
            }
            if clearance < found.clearance {
                found.clearance = clearance;
                if !is_blocked {
                    found.fetch_m = way_m;
                }
            }
            if found.clearance < -GONE {
                return Some(found);
            }
        }
    }
}
