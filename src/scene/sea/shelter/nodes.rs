//! One node: what stands in its way, and what that makes of a sea.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::{BITS, Gains};
use crate::data::exposure::{ShoreDistances, Water, cos_lat};
use crate::data::tile::{EQUATOR_M, POLAR_LATITUDE_DEG, texels_across};
use crate::model::lakes;
use crate::model::sea_tables::SeaTables;
use crate::model::sheltered_sea::{
    DIRECTIONS, Exposure, Exposures, FARTHEST_M, LocalSea, LocalWaves, MOST_GAIN, RINGS,
};

/// Levels of tiles above that of the nodes: their texels are half as wide as nodes are apart.
const TILES_ABOVE: u32 = 7;
/// Nodes farther inland than this many of their distances tell nothing.
const INLAND: f64 = 4.0;
/// What a node on land counts beside a wet one.
pub const ON_LAND: f64 = 0.02;
/// Where nodes count for less than this there is no water that they know.
pub const LEAST_KNOWN: f64 = 0.01;
/// Where no level is known, in shaders.
const NO_LEVEL: f32 = -1e6;

/// What is known at a node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    pub(super) place: [u32; 2],
    /// Whose water it tells of.
    pub(super) water: Water,
    /// Level and margin of its lake or river, m; NaN where none is known.
    pub(super) lake: [f32; 2],
    /// Mean depth of a lake of the table, m.
    pub(super) depth_m: f32,
    /// Distances to the shores that stand there and clearances; NaN where they are not known.
    pub(super) exposures: [[f32; 2]; DIRECTIONS],
    pub(super) weight: f64,
    pub(super) gains: Gains,
}

impl Node {
    pub(super) const NONE: Self = Self {
        place: [u32::MAX; 2],
        water: Water::Ocean,
        lake: [f32::NAN; 2],
        depth_m: f32::NAN,
        exposures: [[f32::NAN; 2]; DIRECTIONS],
        weight: 0.0,
        gains: [1.0; RINGS],
    };

    pub(super) fn exposures(&self) -> Exposures {
        self.exposures.map(|[fetch_m, clearance]| {
            (!fetch_m.is_nan()).then(|| Exposure { fetch_m: fetch_m.into(), clearance: clearance.into() })
        })
    }

    /// As shaders have it: 16 bits for each gain and the weight; level and margin of a lake. Lakes have the lowest bit of the weight.
    pub(super) fn packed(&self) -> [u32; 4] {
        let [a, b, c] = self.gains.map(|gain| bits(gain / MOST_GAIN));
        let weight = bits(self.weight) & !1 | self.water as u32;
        let [level, margin] = self.lake.map(|metres| if metres.is_nan() { NO_LEVEL } else { metres }.to_bits());
        [a | b << 16, c | weight << 16, level, margin]
    }

    /// What it counts for a water.
    pub(super) fn counts(&self, water: Water) -> f64 {
        if self.water == water { self.weight } else { ON_LAND * self.weight }
    }
}

fn bits(share: f64) -> u32 {
    libm::round(share.clamp(0.0, 1.0) * 65_535.0) as u32
}

/// A sea under a wind, as places in lees and on lakes have it.
pub(super) struct Local {
    pub(super) tables: Arc<SeaTables>,
    pub(super) wind_from: f64,
    pub(super) open: LocalSea,
    /// Those over lakes, by their mean depths' bits.
    pub(super) lakes: Mutex<HashMap<u64, Arc<LocalSea>>>,
}

impl Local {
    fn of_lake(&self, depth_m: f64) -> Arc<LocalSea> {
        let mut lakes = self.lakes.lock().unwrap_or_else(PoisonError::into_inner);
        let make = || Arc::new(LocalSea::new(&self.tables, self.wind_from, depth_m));
        lakes.entry(depth_m.to_bits()).or_insert_with(make).clone()
    }

    /// Mean depth of a node's lake, m: the table's, else the usual one of a lake about as large as the water before the node is wide, to a power
    /// of 2. Exposures that a sea before this one needed do not count.
    fn depth_m(&self, node: &Node, exposures: &Exposures) -> f64 {
        let of_table = (!node.depth_m.is_nan()).then(|| node.depth_m.into());
        of_table.unwrap_or_else(|| {
            let known = exposures.iter().enumerate().filter(|(direction, _)| self.open.needs(*direction));
            let known = known.filter_map(|(_, exposure)| exposure.as_ref());
            let [count, sum_km] = known.fold([0.0, 0.0], |[n, sum], e| [n + 1.0, sum + e.fetch_m / 1000.0]);
            let across_km = 1.5 * sum_km / f64::max(count, 1.0);
            libm::exp2(libm::round(libm::log2(lakes::usual_depth_m(across_km * across_km))))
        })
    }

    /// The sea that a node's water has, and what stands in its way there. A lake has no open sea beyond its shores.
    fn of(&self, node: &Node) -> (Option<Arc<LocalSea>>, Exposures) {
        let exposures = node.exposures();
        let lake = (node.water == Water::Lake).then(|| self.of_lake(self.depth_m(node, &exposures)));
        (lake, exposures)
    }

    /// A node's gains, from exposures that hold what is needed.
    pub(super) fn gains(&self, node: &Node) -> Gains {
        let (lake, exposures) = self.of(node);
        lake.as_deref().unwrap_or(&self.open).gains(&exposures)
    }

    /// The waves of nodes, each of which counts for a share.
    pub(super) fn waves(&self, nodes: &[(f64, Node)]) -> LocalWaves {
        let mut waves = LocalWaves::default();
        for (share, node) in nodes {
            let (lake, exposures) = self.of(node);
            waves.add(*share, lake.as_deref().unwrap_or(&self.open), &exposures);
        }
        waves
    }
}

/// The four nodes around a place, and how near each is.
pub(super) fn corners(
    level: usize,
    (x, y): (f64, f64),
    mut known: impl FnMut([u32; 2]) -> Option<Node>,
) -> Option<[(f64, Node); 4]> {
    let around = f64::from(BITS[level]).exp2();
    let (gx, gy) = (x * around, y * around);
    let (i, j) = (gx.floor(), gy.floor());
    let (fx, fy) = (gx - i, gy - j);
    let mut nodes = [(0.0, Node::NONE); 4];
    let corners = [(0, 0, (1.0 - fx) * (1.0 - fy)), (1, 0, fx * (1.0 - fy)), (0, 1, (1.0 - fx) * fy), (1, 1, fx * fy)];
    for (found, (di, dj, share)) in nodes.iter_mut().zip(corners) {
        let place = [(i as u32 + di) & ((1 << BITS[level]) - 1), j as u32 + dj];
        *found = (share, known(place)?);
    }
    Some(nodes)
}

/// The four nodes around a place, and the share that each has in its water, together 1. They are what `known` tells: `None` where it does
/// not know, `Some(None)` where they know no water.
pub(super) fn between(
    level: usize,
    (x, y): (f64, f64),
    water: Water,
    mut known: impl FnMut([u32; 2]) -> Option<Node>,
) -> Option<Option<[(f64, Node); 4]>> {
    let mut nodes = corners(level, (x, y), &mut known)?;
    nodes.iter_mut().for_each(|(share, node)| *share *= node.counts(water));
    let all: f64 = nodes.iter().map(|(weight, _)| weight).sum();
    Some((all > LEAST_KNOWN).then(|| nodes.map(|(weight, node)| (weight / all, node))))
}

/// The gains between nodes of [`between`].
pub(super) fn mean_gains(nodes: &[(f64, Node); 4]) -> Gains {
    std::array::from_fn(|ring| nodes.iter().map(|(share, node)| share * node.gains[ring]).sum())
}

/// The finest level of tiles that nodes look at, which are 2 to the power of `bits` around the map.
pub(super) fn finest(bits: u32) -> u8 {
    (bits - TILES_ABOVE) as u8
}

/// A node; `None` while a tile is on its way.
pub(super) fn found(level: usize, place: [u32; 2], local: &Local, shores: &mut ShoreDistances) -> Option<Node> {
    let around = f64::from(BITS[level]).exp2();
    let mut at = (f64::from(place[0]) / around, f64::from(place[1]) / around);
    let mut node = Node { place, ..Node::NONE };
    let open = Node { weight: 1.0, exposures: [[FARTHEST_M as f32, f32::INFINITY]; DIRECTIONS], ..node };
    if !(0.0..1.0).contains(&at.1) || cos_lat(at.1) < libm::cos(POLAR_LATITUDE_DEG.to_radians()) {
        return Some(open);
    }
    let finest = finest(BITS[level]);
    let apart_m = EQUATOR_M * cos_lat(at.1) / around;
    let distances_m = shores.distances_m(finest, at)?;
    let [ocean_m, lake_m] = distances_m;
    if ocean_m > FARTHEST_M {
        return Some(open);
    }
    // On land that of the nearest shore.
    node.water = if ocean_m > 0.0 || ocean_m >= lake_m { Water::Ocean } else { Water::Lake };
    let shore_m = distances_m[node.water as usize];
    node.weight = 1.0;
    if shore_m <= 0.0 {
        if shore_m < -INLAND * apart_m {
            return Some(Node { weight: 0.0, ..node });
        }
        node.weight = ON_LAND;
        at = into_water(shores, (finest, node.water), at, 0.3 * apart_m)?;
    }
    if node.water == Water::Lake
        && let Some(known) = shores.stands(finest, at)?
    {
        node.lake = [known.level_m as f32, known.margin_m as f32];
        node.depth_m = known.depth_m.map_or(f32::NAN, |depth_m| depth_m as f32);
    }
    for direction in (0..DIRECTIONS).filter(|direction| local.open.needs(*direction)) {
        let exposure = shores.exposure(at, direction, node.water, finest)?;
        let clearance = if node.water == Water::Lake { f32::NEG_INFINITY } else { exposure.clearance as f32 };
        node.exposures[direction] = [exposure.fetch_m as f32, clearance];
    }
    node.gains = local.gains(&node);
    Some(node)
}

/// The place in a water so far off its shore, metres, that is next to a place on land.
fn into_water(
    shores: &mut ShoreDistances,
    (z, water): (u8, Water),
    mut at: (f64, f64),
    off_m: f64,
) -> Option<(f64, f64)> {
    for _ in 0..2 {
        let texel = 1.0 / texels_across(z);
        let mut shore_m = |dx: f64, dy: f64| {
            let there = (at.0 + dx, (at.1 + dy).clamp(0.0, 1.0));
            Some(shores.distances_m(z, there)?[water as usize])
        };
        let here = shore_m(0.0, 0.0)?;
        if here > 0.5 * off_m {
            break;
        }
        let (right, down) =
            (shore_m(texel, 0.0)? - shore_m(-texel, 0.0)?, shore_m(0.0, texel)? - shore_m(0.0, -texel)?);
        let steep = libm::hypot(right, down).max(1e-9);
        let way = (off_m - here) / (EQUATOR_M * cos_lat(at.1)) / steep;
        at = ((at.0 + way * right).rem_euclid(1.0), (at.1 + way * down).clamp(0.0, 1.0));
    }
    Some(at)
}
