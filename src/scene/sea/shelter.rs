//! Where land stands in the sea's way: the waves' gains at nodes of grids that are fixed to the map, around the eye for drawing and around
//! a place for a sample.
//!
//! ```text
//!  level   nodes around the map   apart, at the equator   a window reaches
//!    0            2^15                   1.2 km                39 km          what displaces the water lies within the first window,
//!    1            2^13                   4.9 km               157 km          so that every eye finds the same heights there
//!    2            2^11                    20 km               626 km
//!    3            2^9                     78 km             2,500 km          for an eye in space
//! ```
//!
//! What stands in a node's way (`data::exposure`) is found once; wind and sea only weigh it anew. Nodes on land take the sea of their shore,
//! and count next to nothing where a wet one is near. Nodes of lakes and rivers know their level, too, by the table
//! (`model::lakes`) or by the terrain (`data::world`). Mercator's map alone: beyond 84 degrees all sea is open.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use crate::data::exposure::{ShoreDistances, ShoreTiles, Water, Waters, cos_lat};
use crate::data::fetch::now_s;
use crate::data::tile::{EQUATOR_M, POLAR_LATITUDE_DEG, Projection, map_from_lat_lon};
use crate::model::earth::WGS84;
use crate::model::lakes::OWN_RIVER_M;
use crate::model::sea_tables::SeaTables;
use crate::model::sheltered_sea::{DIRECTIONS, FARTHEST_M, LocalSea, RINGS};
use crate::model::waves::CASCADES;
pub use nodes::{LEAST_KNOWN, ON_LAND};
use nodes::{Local, Node, between, corners, finest, found, mean_gains};

mod nodes;

/// Grids of nodes.
pub const LEVELS: usize = 4;
/// Nodes around the map are 2 to this power.
pub const BITS: [u32; LEVELS] = [15, 13, 11, 9];
/// Nodes along a side of a level's window.
pub const SIDE: usize = 64;
/// The middle of a window is a multiple of this many nodes.
const SNAP: u32 = 4;
/// Nodes that wait for tiles before the others of a level wait, too.
const WAITING: usize = 32;
/// Heights of the eye from which on a level is too fine to be seen, m.
const HIGHEST_M: [f64; LEVELS] = [400_000.0, 1_600_000.0, 6_400_000.0, 25_000_000.0];

/// Gains of the rings.
pub type Gains = [f64; RINGS];

/// Those of all patches: the ripples of the last are there as soon as the wind is.
pub fn of_patches([a, b, c]: Gains) -> [f64; CASCADES] {
    [a, b, c, 1.0]
}

/// Gains where coral reefs leave so much of the waves' height.
pub fn behind_reefs([a, b, c, d]: [f64; CASCADES], left: f64) -> [f64; CASCADES] {
    [left * a, left * b, left * c, d]
}

/// A window of one level's nodes as shaders know it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Window {
    /// The middle on the map, 2^32 its side.
    pub middle: [u32; 2],
    /// Power of two of the nodes around the map.
    pub bits: u32,
    /// 0: nothing is known, 1: the nodes say it, 2: all is open sea.
    pub state: u32,
}

/// Nothing is known.
const UNKNOWN: u32 = 0;
/// The nodes say it.
const KNOWN: u32 = 1;
/// All is open sea.
const OPEN: u32 = 2;

/// The gains around an eye, and whatever has been found for them.
#[derive(Default)]
pub struct Shelter {
    windows: [Window; LEVELS],
    nodes: Vec<Node>,
    tiles: ShoreTiles,
    sea: Option<Arc<Local>>,
    /// Nodes of [`Shelter::at`].
    sampled: HashMap<(usize, [u32; 2]), Node>,
    /// What the nodes have been brought to: windows and the sea's number.
    done: Option<([Window; LEVELS], u64)>,
    seas: u64,
    revision: u64,
    is_busy: bool,
}

impl Shelter {
    /// Brings the nodes around an eye at geodetic `lat` and `lon`, radians, and a height in metres up to date for a sea under a wind from
    /// bearing `wind_from`, for at most so many seconds. True when they are and have been before this call.
    pub fn advance(
        &mut self,
        (tables, wind_from): (&Arc<SeaTables>, f64),
        (lat, lon, altitude_m): (f64, f64, f64),
        budget_s: f64,
        look: &mut dyn Waters,
    ) -> bool {
        let local = self.local(tables, wind_from);
        let mut windows = windows(lat, lon, altitude_m);
        let asked = windows;
        if let Some((of, seas)) = &self.done
            && *seas == self.seas
            && of == &asked
        {
            self.is_busy = false;
            return true;
        }
        self.done = None;
        self.nodes.resize(LEVELS * SIDE * SIDE, Node::NONE);
        let until_s = now_s() + budget_s;
        let mut tiles = std::mem::take(&mut self.tiles);
        let mut shores = tiles.looking(look);
        let (mut waits, mut is_late) = (false, false);
        // Coarse ones first: they stand in for the others.
        for level in (0..LEVELS).rev().filter(|level| asked[*level].state == KNOWN) {
            match is_open(&mut shores, &asked[level]) {
                Some(true) => windows[level].state = OPEN,
                Some(false) => {
                    let (missing, late) = self.fill(level, &windows[level], (&local, &mut shores), until_s);
                    waits |= missing;
                    is_late |= late;
                }
                None => (waits, windows[level].state) = (true, UNKNOWN),
            }
        }
        self.tiles = tiles;
        self.windows = windows;
        self.revision += 1;
        self.is_busy = is_late;
        if !waits && !is_late {
            self.tiles.clear();
            self.done = Some((asked, self.seas));
        }
        false
    }

    /// The sea as places have it, made anew for another sea or wind.
    fn local(&mut self, tables: &Arc<SeaTables>, wind_from: f64) -> Arc<Local> {
        let is_same = |local: &&Arc<Local>| {
            let of = &local.tables;
            local.wind_from == wind_from && (Arc::ptr_eq(of, tables) || of.has_waves_of(tables))
        };
        if let Some(local) = self.sea.as_ref().filter(is_same) {
            return local.clone();
        }
        let open = LocalSea::new(tables, wind_from, f64::INFINITY);
        let local = Arc::new(Local { tables: tables.clone(), wind_from, open, lakes: Mutex::default() });
        self.sea = Some(local.clone());
        self.seas += 1;
        self.sampled.clear();
        for node in &mut self.nodes {
            let known = (0..DIRECTIONS).all(|i| !local.open.needs(i) || !node.exposures[i][0].is_nan());
            if known && node.weight > 0.0 {
                node.gains = local.gains(node);
            } else if node.weight > 0.0 {
                node.place = [u32::MAX; 2];
            }
        }
        local
    }

    /// Finds the nodes of a window that are not there. Whether some wait for tiles, and whether the time was over.
    fn fill(
        &mut self,
        level: usize,
        window: &Window,
        (local, shores): (&Local, &mut ShoreDistances),
        until_s: f64,
    ) -> (bool, bool) {
        let shift = 32 - window.bits;
        let first = window.middle.map(|at| (at >> shift).wrapping_sub(SIDE as u32 / 2));
        let mask = (1u32 << window.bits) - 1;
        let place_of = |row: u32, column: u32| [first[0].wrapping_add(column) & mask, first[1].wrapping_add(row)];
        let side = 0..SIDE as u32;
        // Nodes of another window's places would tell shaders of these.
        for place in side.clone().flat_map(|row| side.clone().map(move |column| place_of(row, column))) {
            let node = &mut self.nodes[slot(level, place)];
            if node.place != place {
                // Beyond the map's rims there is nothing.
                *node = if place[1] > mask { Node { place, ..Node::NONE } } else { Node::NONE };
            }
        }
        let mut waiting = 0;
        for row in side.clone() {
            for column in side.clone() {
                let place = place_of(row, column);
                let node = &mut self.nodes[slot(level, place)];
                if node.place == place {
                    continue;
                }
                match found(level, place, local, shores) {
                    Some(known) => *node = known,
                    None => {
                        waiting += 1;
                        if waiting == WAITING {
                            return (true, false);
                        }
                    }
                }
            }
            if now_s() > until_s {
                return (waiting > 0, true);
            }
        }
        (waiting > 0, false)
    }

    /// The windows, and the nodes of each.
    pub fn packed(&self) -> ([Window; LEVELS], Vec<[u32; 4]>) {
        (self.windows, self.nodes.iter().map(Node::packed).collect())
    }

    /// Nodes that have been found around the eye.
    pub fn found(&self) -> usize {
        self.nodes.iter().filter(|node| node.place != Node::NONE.place).count()
    }

    /// A number that changes with what [`Shelter::packed`] says.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Whether more is left to find than the last call had time for.
    pub fn is_busy(&self) -> bool {
        self.is_busy
    }

    /// The gains of a water at geodetic `lat` and `lon`, radians, as far as they are known around the eye: those that shaders find there.
    pub fn around(&self, water: Water, lat: f64, lon: f64) -> Gains {
        let Some(at) = place(lat, lon) else { return [1.0; RINGS] };
        for (level, window) in self.windows.iter().enumerate() {
            if window.state == OPEN {
                return [1.0; RINGS];
            }
            let known = |place: [u32; 2]| {
                Some(
                    self.nodes
                        .get(slot(level, place))
                        .filter(|node| node.place == place)
                        .copied()
                        .unwrap_or(Node::NONE),
                )
            };
            if window.state == KNOWN
                && let Some(nodes) = between(level, at, water, known).flatten()
            {
                return mean_gains(&nodes);
            }
        }
        [1.0; RINGS]
    }

    /// The level of the lake around a place, m, as shaders find it there; `None` where none is known, and of a river.
    pub fn lake_level_m(&self, lat: f64, lon: f64) -> Option<f64> {
        let at = place(lat, lon)?;
        for level in (0..LEVELS).filter(|level| self.windows[*level].state == KNOWN) {
            let known = |place: [u32; 2]| {
                let node = self.nodes.get(slot(level, place)).filter(|node| node.place == place);
                Some(node.copied().unwrap_or(Node::NONE))
            };
            let Some(nodes) = corners(level, at, known) else { continue };
            let has_level = |(share, node): &(f64, Node)| *share * node.weight > 0.0 && !node.lake[0].is_nan();
            let [sum, all, margins] =
                nodes.iter().filter(|known| has_level(known)).fold([0.0; 3], |sum, (share, node)| {
                    let counts = share * node.weight;
                    let [level, margin] = node.lake.map(|x| counts * f64::from(x));
                    [sum[0] + level, sum[1] + counts, sum[2] + margin]
                });
            if all > 0.0 {
                return (margins < OWN_RIVER_M * all).then_some(sum / all);
            }
        }
        None
    }

    /// Significant height of a sea's waves on a water there, m, as far as that is known.
    pub fn hs_m(&self, sea: &SeaTables, water: Water, lat: f64, lon: f64) -> f64 {
        sea.sea.hs_m * sea.height_gain(of_patches(self.around(water, lat, lon)))
    }

    /// The gains of a water at a place whatever the eye sees; `None` while a tile that `look` asks for is on its way.
    pub fn at(
        &mut self,
        sea: (&Arc<SeaTables>, f64),
        place: (Water, f64, f64),
        look: &mut dyn Waters,
    ) -> Option<Gains> {
        Some(self.nodes_at(sea, place, look)?.map_or([1.0; RINGS], |nodes| mean_gains(&nodes)))
    }

    /// Period of the peak of the waves of a water at a place, s; as [`Shelter::at`].
    pub fn peak_period_at(
        &mut self,
        sea: (&Arc<SeaTables>, f64),
        place: (Water, f64, f64),
        look: &mut dyn Waters,
    ) -> Option<f64> {
        let nodes = self.nodes_at(sea, place, look)?;
        let waves = nodes.map(|nodes| self.local(sea.0, sea.1).waves(&nodes));
        Some(waves.map_or(sea.0.peak_period_s, |waves| waves.peak_period(&sea.0.sea.spectrum())))
    }

    /// The nodes around a place with their shares, those of the finest level that knows the water. `Some(None)`: there is none, or no land.
    fn nodes_at(
        &mut self,
        (tables, wind_from): (&Arc<SeaTables>, f64),
        (water, lat, lon): (Water, f64, f64),
        look: &mut dyn Waters,
    ) -> Option<Option<[(f64, Node); 4]>> {
        let local = self.local(tables, wind_from);
        let Some(at) = place(lat, lon).filter(|_| tables.sea.hs_m > 0.0) else { return Some(None) };
        let mut tiles = std::mem::take(&mut self.tiles);
        let mut shores = tiles.looking(look);
        let mut nodes = Some(None);
        for level in 0..LEVELS {
            let known = |place: [u32; 2]| {
                let node = match self.sampled.get(&(level, place)) {
                    Some(node) => *node,
                    None => found(level, place, &local, &mut shores)?,
                };
                self.sampled.insert((level, place), node);
                Some(node)
            };
            nodes = between(level, at, water, known);
            if !matches!(nodes, Some(None)) {
                break;
            }
        }
        self.tiles = tiles;
        nodes
    }
}

/// A place on the map where there are nodes.
fn place(lat: f64, lon: f64) -> Option<(f64, f64)> {
    (lat.abs() < POLAR_LATITUDE_DEG.to_radians()).then(|| map_from_lat_lon(Projection::Mercator, lat, lon))
}

/// The windows around an eye.
fn windows(lat: f64, lon: f64, altitude_m: f64) -> [Window; LEVELS] {
    let (x, y) = map_from_lat_lon(Projection::Mercator, lat, lon);
    let height_m = altitude_m.max(0.0);
    let horizon_m = 5_000.0 + libm::sqrt(height_m * (2.0 * WGS84.a + height_m));
    std::array::from_fn(|level| {
        let around = f64::from(BITS[level]).exp2() / f64::from(SNAP);
        let snapped = |at: f64| ((at * around).round() as u32).wrapping_mul(SNAP << (32 - BITS[level]));
        // What the level before shows all of needs no coarser one.
        let shown_m = level.checked_sub(1).map_or(0.0, |finer| 0.7 * reach_m(finer, y));
        let state = if altitude_m < HIGHEST_M[level] && horizon_m > shown_m { KNOWN } else { UNKNOWN };
        Window { middle: [snapped(x), snapped(y)], bits: BITS[level], state }
    })
}

/// How far a level's window reaches at a height of the map, m.
fn reach_m(level: usize, y: f64) -> f64 {
    0.5 * SIDE as f64 / f64::from(BITS[level]).exp2() * EQUATOR_M * cos_lat(y)
}

/// Whether no node of a window has land in its way: by the tiles that its nodes look at, of which its corners lie in all, since coarse ones know
/// no small island.
fn is_open(shores: &mut ShoreDistances, window: &Window) -> Option<bool> {
    let [x, y] = window.middle.map(|at| f64::from(at) / 32f64.exp2());
    let reach = SIDE as f64 / f64::from(window.bits).exp2();
    // Distances are ground metres; towards the equator the window is wider.
    let widest = cos_lat((y - reach).clamp(0.0, 1.0)).max(cos_lat((y + reach).clamp(0.0, 1.0))).max(cos_lat(y));
    let away_m = 0.75 * reach * EQUATOR_M * widest + FARTHEST_M;
    for (dx, dy) in [(0.0, 0.0), (-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5)] {
        let place = ((x + dx * reach).rem_euclid(1.0), (y + dy * reach).clamp(0.0, 1.0));
        if shores.distances_m(finest(window.bits), place)?[0] <= away_m {
            return Some(false);
        }
    }
    Some(true)
}

/// Where a node is kept.
fn slot(level: usize, place: [u32; 2]) -> usize {
    let [x, y] = place.map(|at| at as usize % SIDE);
    (level * SIDE + y) * SIDE + x
}
