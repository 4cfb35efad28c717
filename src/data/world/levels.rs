//! At what level lakes and rivers lie that no table knows: by the terrain along their shores and courses.
//! It is long, but one thing: the steps of this drawing, in its order.
//!
//! ```text
//!   a place's tile        its coarser tiles             the middle of that line's box     up to 3 levels finer
//!   the line at its  ───▶ the same lake, as long as ───▶ which is everyone's, whatever ───▶ the finest line that no border cuts:
//!   shore (or a cut one)  it is large enough to show    tile they began with              the lowest tenth of the terrain's cells there
//! ```
//!
//! The terrain's cells are 9 km wide: by a shore between mountains they hold half of these. So the lowest of the four values around a place of
//! the shore counts, and of these the 10th percentile: so 87 lakes whose levels are known are 21 m off in the median, one in five by over
//! 100 m (by the 20th, one in four; by the lowest, one in four).
//! A river has no level of its own but falls along its course: near a place it is about as low as the lowest cells that it passes within
//! [`RIVER_REACHES_TEXELS`], smoothly.
//!
//! It is long, but one thing: the way of the drawing above from a place to a level, in the order in which it goes; what is remembered of it stands
//! before, the terrain's cells and what they tell after.

use super::{Look, World};
use crate::data::TileTexels;
use crate::data::coast::Stream;
use crate::data::coast::inland::{Inland, Nearest};
use crate::data::exposure::{Found, Waters, cos_lat};
use crate::data::tile::{
    EQUATOR_M, Layer, Projection, TILE_TEXELS, TileId, lat_lon_from_map, map_from_lat_lon, texels_across,
};
use crate::data::water::{STEPS_PER_TEXEL, unpacked};
use crate::error::{Error, Result};
use crate::model::lakes::{self, Stands};
use crate::model::sea_bed::grid_level;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

/// Deepest level of the tiles whose lines tell of a lake.
pub const LINES_LEVEL: u8 = 8;
/// By coarser tiles, as nodes about an eye in space look at, the table alone tells: an opening view loads no more for lakes that it shows as points.
const LINES_FROM: u8 = 4;
/// A lake's line is taken from so many levels below the coarsest that shows it.
const FINER: u8 = 3;
/// Lakes farther from a place than this tell nothing of it, m; as far as nodes look for water, and more.
const REACH_M: f64 = 100_000.0;
/// Terrain deeper than this tells nothing more of a lake.
const DEEPEST_TERRAIN: u8 = 8;
/// Which part of a shore's cells is lower than the lake.
const LOWER: f64 = 0.1;
/// Cells of a tile's lines, at most.
const MOST_CELLS: usize = 1 << 14;
/// Tiles of the terrain in which these may lie: many more would not stay in the cache until the last is there.
const MOST_TILES: usize = 128;
/// Levels kept.
const MOST_KEPT: usize = 1 << 16;
/// Levels of tiles from which on there are rivers of a kind, and those within 10 texels around.
const RIVER_LEVELS: [u8; 2] = [5, 7];
/// Cells that a river passes count as far as this from a place, texels of such a tile: a cell that is in the buffer by its corner alone does not.
const RIVER_REACHES_TEXELS: [f64; 2] = [8.5, 9.0];
/// A river is about so much over the lowest of its cells, m: the rounding of the terrain.
const RIVER_OVER_M: f64 = 12.0;
/// Cells at the end of that reach count as so much higher, m, nearer ones by the fourth power of the way: a low one that comes in is no cliff.
const RIVER_RISES_M: f64 = 150.0;
/// By the ocean nothing lies lower, m: cells there are half sea. Nor so far from it, m, but in depressions.
const LEAST_BY_SEA_M: f64 = 1.0;
/// See [`LEAST_BY_SEA_M`].
const LOWLAND_M: f64 = 100_000.0;
/// What is lower is a depression rather than a lowland, m.
const DEPRESSION_M: f64 = -50.0;

/// A cell between the terrain's texels that a line passes.
#[derive(Clone, Copy)]
struct Cell {
    /// On the unit map.
    middle: [f64; 2],
    /// The lowest of its texels.
    metres: f64,
    /// How much of the lines, texels, about.
    passed: f64,
}

type Cells = Arc<Vec<Cell>>;

/// What a lake's shore tells.
#[derive(Clone)]
enum Standing {
    /// Nothing.
    Unknown,
    /// Its level, m.
    Lake(f64),
    /// It is a wide river.
    River(Cells),
}

/// What has been found. All of it is forgotten when tiles that were given up may be asked for again: something may have been found without them.
#[derive(Default)]
pub(super) struct Levels {
    lakes: HashMap<(TileId, usize), Standing>,
    rivers: HashMap<(TileId, Stream), Cells>,
    /// Which line of another tile a tile's line is, while further tiles are on their way.
    same: HashMap<(TileId, usize, TileId), Option<usize>>,
    /// The last places that were sampled out of the cache, by how, and the level of their lines.
    last: [Option<Last>; 2],
}

/// A place on the unit map, the level of its lines and how its water stands.
type Last = ((f64, f64), u8, Option<Stands>);

/// The waters of a world, for what asks for their tiles and levels.
pub struct WorldWaters<'a> {
    world: &'a mut World,
    look: Look,
    /// The first error of a tile, which counts as absent.
    pub failed: Option<Error>,
}

impl<'a> WorldWaters<'a> {
    /// Those of a world, whose tiles are got at in a way.
    pub fn new(world: &'a mut World, look: Look) -> Self {
        Self { world, look, failed: None }
    }
}

impl Waters for WorldWaters<'_> {
    fn tile(&mut self, id: TileId) -> Found {
        (self.look)(self.world, Layer::Water, id).unwrap_or_else(|error| {
            self.failed.get_or_insert(error);
            Found::Absent
        })
    }

    fn stands(&mut self, z: u8, at: (f64, f64)) -> Option<Option<Stands>> {
        self.world.stands_by(z, at, self.look).unwrap_or_else(|error| {
            self.failed.get_or_insert(error);
            Some(None)
        })
    }
}

impl World {
    /// [`World::look`] as a way to get at tiles.
    ///
    /// # Errors
    /// None.
    pub fn look_or_parent(&mut self, layer: Layer, id: TileId) -> Result<Found> {
        Ok(self.look(layer, id))
    }

    /// What the cache and the archives say of a tile; one that they do not know is on its way, but not asked for.
    ///
    /// # Errors
    /// None.
    pub fn look_at_hand(&mut self, layer: Layer, id: TileId) -> Result<Found> {
        Ok(self.known(layer, id).unwrap_or(Found::Coming))
    }

    /// At what level the inland water nearest to a place of Mercator's unit map lies, by lines of level `z`; `Some(None)` where none is near or its
    /// level is not known, `None` while tiles are on their way.
    ///
    /// # Errors
    /// What `look` reports.
    pub fn stands_by(&mut self, z: u8, at: (f64, f64), look: Look) -> Result<Option<Option<Stands>>> {
        let (lat, lon) = lat_lon_from_map(Projection::Mercator, at.0, at.1);
        let of_table = lakes::at(lat, lon).map(Stands::of);
        if z < LINES_FROM {
            return Ok(Some(of_table));
        }
        let Some((id, inland)) = self.lines(z, at, look)? else { return Ok(None) };
        let Some(inland) = inland else { return Ok(Some(of_table)) };
        match inland.nearest([at.0, at.1], EQUATOR_M * cos_lat(at.1), REACH_M) {
            Some(Nearest::River(index)) => {
                let Some(level) = self.river_level_m(inland.rivers[index].stream, at, look)? else { return Ok(None) };
                Ok(Some(level.map(Stands::river)))
            }
            Some(Nearest::Lake(line)) if of_table.is_none() => {
                let Some(standing) = self.standing((id, &inland, line), look)? else { return Ok(None) };
                Ok(Some(match standing {
                    Standing::Unknown => None,
                    Standing::Lake(level_m) => Some(Stands::lake(level_m)),
                    Standing::River(cells) => falling_m(&cells, at, Stream::River).map(Stands::river),
                }))
            }
            _ => Ok(Some(of_table)),
        }
    }

    /// The same at geodetic `lat` and `lon`, radians, by the finest lines.
    pub(super) fn stands_at(&mut self, lat: f64, lon: f64, look: Look) -> Result<Option<Option<Stands>>> {
        if Projection::for_latitude(lat) != Projection::Mercator {
            return Ok(Some(None));
        }
        self.stands_by(LINES_LEVEL, map_from_lat_lon(Projection::Mercator, lat, lon), look)
    }

    /// The same for readouts: as the table has it while tiles are on their way. Without `may_ask` none is asked for, and the finest lines are
    /// those of the cache.
    pub(super) fn stands_now(&mut self, lat: f64, lon: f64, may_ask: bool) -> Option<Stands> {
        if Projection::for_latitude(lat) != Projection::Mercator {
            return None;
        }
        let at = map_from_lat_lon(Projection::Mercator, lat, lon);
        let (look, finest): (Look, _) = if may_ask {
            (Self::look_or_parent, Some(LINES_LEVEL))
        } else {
            let is_here = |z: &u8| self.cache.get(&(Layer::Water, tile_at(*z, at))).is_some();
            (Self::look_at_hand, (0..=LINES_LEVEL).rev().find(is_here))
        };
        let last = self.levels.last[usize::from(may_ask)];
        if let Some((_, _, stands)) = last.filter(|(place, z, _)| *place == at && Some(*z) == finest) {
            return stands;
        }
        let found = finest.and_then(|z| Some((z, self.stands_by(z, at, look).ok().flatten()?)));
        let Some((z, stands)) = found else { return lakes::at(lat, lon).map(Stands::of) };
        self.levels.last[usize::from(may_ask)] = Some((at, z, stands));
        stands
    }

    /// Whether the last of `World::stands_now`'s answers to who may ask was about this place, and was no makeshift while tiles are on their way.
    pub fn knows_level(&self, lat: f64, lon: f64) -> bool {
        Projection::for_latitude(lat) != Projection::Mercator
            || self.levels.last[1].is_some_and(|(at, ..)| at == map_from_lat_lon(Projection::Mercator, lat, lon))
    }

    /// The lines of the deepest tile there is at a place down to level `z`; `None` while it is on its way.
    fn lines(&mut self, z: u8, at: (f64, f64), look: Look) -> Result<Option<(TileId, Option<Arc<Inland>>)>> {
        let stored = self.slot(Layer::Water, Projection::Mercator).archive().map(|archive| archive.header().max_zoom);
        let mut id = tile_at(z.min(stored.unwrap_or(0)), at);
        loop {
            match look(self, Layer::Water, id)? {
                Found::Coming => return Ok(None),
                Found::Tile(_) => return Ok(Some((id, self.cache.inland(&(Layer::Water, id))))),
                Found::Absent => match id.parent() {
                    Some(parent) => id = parent,
                    None => return Ok(Some((id, None))),
                },
            }
        }
    }

    /// How the lake stands that has a line in a tile.
    fn standing(&mut self, (id, inland, line): (TileId, &Arc<Inland>, usize), look: Look) -> Result<Option<Standing>> {
        if let Some(known) = self.levels.lakes.get(&(id, line)) {
            return Ok(Some(known.clone()));
        }
        // Up, as long as it shows.
        let (mut top, mut lines, mut own) = (id, inland.clone(), line);
        while let Some(parent) = top.parent() {
            let Some(above) = self.lines_of(parent, look)? else { return Ok(None) };
            let Some(above) = above else { break };
            let Some(same) = self.levels.same((top, own, parent), || above.coarser(&lines, own)) else { break };
            (top, lines, own) = (parent, above, same);
        }
        // And down at its middle.
        let mut found = lines.lakes[own].is_whole.then(|| (top, lines.clone(), own));
        let [low, high] = lines.lakes[own].corners;
        let middle = (0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]));
        let mut last = (top, lines, own);
        for z in top.z + 1..=LINES_LEVEL.min(top.z + FINER) {
            let below = tile_at(z, middle);
            let Some(finer) = self.lines_of(below, look)? else { return Ok(None) };
            let Some(finer) = finer else { break };
            let (above, lines, own) = &last;
            let Some(same) = self.levels.same((*above, *own, below), || finer.finer(lines, *own)) else { break };
            if finer.lakes[same].is_whole {
                found = Some((below, finer.clone(), same));
            }
            last = (below, finer, same);
        }
        let mut standing = Standing::Unknown;
        if let Some((of, lines, line)) = found {
            let shore = &lines.lakes[line].points;
            let closed = shore.iter().chain(shore.first());
            let Some(cells) = self.cells(of, [closed.copied().collect()].into_iter(), look)? else { return Ok(None) };
            standing = if lines.lakes[line].is_river() {
                Standing::River(Arc::new(cells))
            } else {
                lowest(cells).map_or(Standing::Unknown, Standing::Lake)
            };
        }
        if self.levels.lakes.len() >= MOST_KEPT {
            self.levels.lakes.clear();
        }
        self.levels.lakes.insert((id, line), standing.clone());
        Ok(Some(standing))
    }

    /// The level of a river at a place, or what runs into one.
    fn river_level_m(&mut self, stream: Stream, at: (f64, f64), look: Look) -> Result<Option<Option<f64>>> {
        let id = tile_at(RIVER_LEVELS[stream.index()], at);
        let cells = match self.levels.rivers.get(&(id, stream)) {
            Some(cells) => cells.clone(),
            None => {
                let Some(lines) = self.lines_of(id, look)? else { return Ok(None) };
                let courses: Vec<_> = lines.iter().flat_map(|lines| &lines.rivers).collect();
                let courses = courses.into_iter().filter(|course| course.stream.index() <= stream.index());
                let Some(cells) = self.cells(id, courses.map(|course| course.points.clone()), look)? else {
                    return Ok(None);
                };
                let cells = Arc::new(cells);
                if self.levels.rivers.len() >= MOST_KEPT {
                    self.levels.rivers.clear();
                }
                self.levels.rivers.insert((id, stream), cells.clone());
                cells
            }
        };
        Ok(Some(falling_m(&cells, at, stream)))
    }

    /// Lines of one tile: `Some(None)` where it does not exist or holds a picture.
    fn lines_of(&mut self, id: TileId, look: Look) -> Result<Option<Option<Arc<Inland>>>> {
        Ok(match look(self, Layer::Water, id)? {
            Found::Coming => None,
            Found::Absent => Some(None),
            Found::Tile(_) => Some(self.cache.inland(&(Layer::Water, id))),
        })
    }

    /// The cells between the terrain's texels that lines of a tile pass, each once, and the lowest texel of each; none where they are strewn over
    /// more than [`MOST_TILES`]. Lines are looked at every quarter of a texel from each of their points on: of a cell that one passes by a corner
    /// alone where it is cut and how dense its points are may decide.
    fn cells(
        &mut self,
        of: TileId,
        lines: impl Iterator<Item = Vec<[f64; 2]>>,
        look: Look,
    ) -> Result<Option<Vec<Cell>>> {
        let Some(terrain) = self.terrain_at(0.0) else { return Ok(None) };
        let z = grid_level(terrain.resolution_m).min(terrain.deepest).min(DEEPEST_TERRAIN);
        let side = texels_across(z);
        let mut all = BTreeMap::new();
        'lines: for line in lines {
            for (a, b) in line.iter().zip(line.iter().skip(1)) {
                let [a, b] = [a, b].map(|at| at.map(|at| at * side - 0.5));
                let way = [b[0] - a[0], b[1] - a[1]];
                let steps = (4.0 * way[0].abs().max(way[1].abs())).ceil().clamp(1.0, 4096.0) as u32;
                let step_texels = libm::hypot(way[0], way[1]) / f64::from(steps);
                for step in 0..=steps {
                    if all.len() >= MOST_CELLS {
                        break 'lines;
                    }
                    let part = f64::from(step) / f64::from(steps);
                    let cell = [0, 1].map(|axis| (a[axis] + part * way[axis]).floor() as i64);
                    // The last point is the next piece's first.
                    *all.entry(cell).or_insert(0.0) += if step < steps { step_texels } else { 0.0 };
                }
            }
        }
        let tiles: HashSet<_> = all.keys().map(|cell| cell.map(|at| at.div_euclid(TILE_TEXELS as i64))).collect();
        if tiles.len() > MOST_TILES {
            return Ok(Some(Vec::new()));
        }
        let mut cells = Vec::with_capacity(all.len());
        for ([i, j], passed) in all {
            let middle = [i, j].map(|at| (at as f64 + 1.0) / side);
            let mut lowest = f64::INFINITY;
            for (di, dj) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let Some(metres) = self.terrain_texel(z, i + di, j + dj, look)? else { return Ok(None) };
                lowest = lowest.min(metres);
            }
            if lowest < LEAST_BY_SEA_M {
                let Some(ocean_m) = self.ocean_m(of.z, middle, look)? else { return Ok(None) };
                let near_m = 2.0 * EQUATOR_M * cos_lat(middle[1]) / side;
                if ocean_m > -near_m || (ocean_m > -LOWLAND_M && lowest > DEPRESSION_M) {
                    lowest = LEAST_BY_SEA_M;
                }
            }
            if lowest.is_finite() {
                cells.push(Cell { middle, metres: lowest, passed });
            }
        }
        Ok(Some(cells))
    }

    /// A texel of the terrain, or of what serves for it; infinite without any.
    fn terrain_texel(&mut self, z: u8, column: i64, row: i64, look: Look) -> Result<Option<f64>> {
        let side = (TILE_TEXELS as i64) << z;
        let at = [column.rem_euclid(side), row.clamp(0, side - 1)];
        for up in 0..=z {
            let [column, row] = at.map(|at| (at >> up) as usize);
            let [x, y] = [column, row].map(|at| (at / TILE_TEXELS) as u32);
            match look(self, Layer::Terrain, TileId { projection: Projection::Mercator, z: z - up, x, y })? {
                Found::Coming => return Ok(None),
                Found::Tile(texels) => {
                    if let TileTexels::Terrain(metres) = &*texels {
                        return Ok(Some(metres[row % TILE_TEXELS * TILE_TEXELS + column % TILE_TEXELS].into()));
                    }
                }
                Found::Absent => {}
            }
        }
        Ok(Some(f64::INFINITY))
    }

    /// Distance to the ocean's shore at a place as tiles of a level tell it, m, positive in it.
    fn ocean_m(&mut self, z: u8, at: [f64; 2], look: Look) -> Result<Option<f64>> {
        for z in (0..=z).rev() {
            let id = tile_at(z, (at[0], at[1]));
            match look(self, Layer::Water, id)? {
                Found::Coming => return Ok(None),
                Found::Tile(texels) => {
                    if let TileTexels::Water(texels) = &*texels {
                        let side = texels_across(z);
                        let [i, j] = at.map(|at| (at.clamp(0.0, 1.0) * side).min(side - 1.0) as usize % TILE_TEXELS);
                        let steps = f64::from(unpacked(texels[j * TILE_TEXELS + i]).0[0]);
                        return Ok(Some(steps / STEPS_PER_TEXEL * EQUATOR_M * cos_lat(at[1]) / side));
                    }
                }
                Found::Absent => {}
            }
        }
        Ok(Some(f64::NEG_INFINITY))
    }
}

impl Levels {
    /// A line as another tile has it, found once.
    fn same(&mut self, of: (TileId, usize, TileId), find: impl FnOnce() -> Option<usize>) -> Option<usize> {
        if self.same.len() >= MOST_KEPT {
            self.same.clear();
        }
        *self.same.entry(of).or_insert_with(find)
    }
}

/// The level at a place of a river that passes cells, m, of which those within the reach of its kind count.
fn falling_m(cells: &[Cell], at: (f64, f64), stream: Stream) -> Option<f64> {
    let reach = RIVER_REACHES_TEXELS[stream.index()] / texels_across(RIVER_LEVELS[stream.index()]);
    let near = || {
        cells.iter().filter_map(|Cell { middle, metres, .. }| {
            let off = [middle[0] - at.0, middle[1] - at.1].map(|way| way / reach);
            let share = 1.0 - off[0] * off[0] - off[1] * off[1];
            let far = off[0] * off[0] + off[1] * off[1];
            (share > 0.0).then_some((share * share, metres + RIVER_RISES_M * far * far))
        })
    };
    let lowest = near().map(|(_, metres)| metres).fold(f64::INFINITY, f64::min);
    let [sum, all] = near().fold([0.0; 2], |[sum, all], (share, metres)| {
        let counts = share * libm::exp((lowest - metres) / RIVER_OVER_M);
        [sum + counts * metres, all + counts]
    });
    (all > 0.0).then(|| sum / all)
}

/// What [`LOWER`] of a shore, by its length, is not higher than, m.
fn lowest(mut cells: Vec<Cell>) -> Option<f64> {
    cells.sort_by(|a, b| a.metres.total_cmp(&b.metres));
    let mut left = LOWER * cells.iter().map(|cell| cell.passed).sum::<f64>();
    let at = cells.iter().find(|cell| {
        left -= cell.passed;
        left <= 0.0
    });
    at.or(cells.last()).map(|cell| cell.metres)
}

/// The tile of a level at a place of Mercator's unit map.
fn tile_at(z: u8, at: (f64, f64)) -> TileId {
    let across = f64::from(1u32 << z);
    let tile = |at: f64| (at.clamp(0.0, 1.0) * across).min(across - 1.0) as u32;
    TileId { projection: Projection::Mercator, z, x: tile(at.0.rem_euclid(1.0)), y: tile(at.1) }
}
