//! The bed around a piece of coast, for the waves that come to it: always from the same tiles, whatever else is at hand, so that waves do not
//! shift while tiles come.

use super::World;
use crate::data::exposure::Found;
use crate::data::tile::{Layer, Projection, TILE_TEXELS, TileId, lat_lon_from_map, texel_size_m};
use crate::data::water::{STEPS_PER_TEXEL, unpacked};
use crate::data::{SharedTexels, TileTexels};
use crate::model::reefs::{self, Reef};
use crate::model::rugged::{self, Around};
use crate::model::sea_bed::{Coast, Grid, grid_level, shaped_on};
use crate::model::shore_waves::Bed;

/// Level of Mercator's tiles that have a window each, whose water tiles it is made of: the deepest.
pub const SHORE_LEVEL: u8 = super::DEEPEST_SHORES;
/// Nodes along a side of a window: as many as two tiles are wide, half a tile beyond its own on each side, every fourth texel.
pub const SHORE_SIDE: usize = 2 * TILE_TEXELS / 4;

/// A tile that serves for a place, if any does, and whether that is still to be seen.
enum Served {
    By(TileId, SharedTexels),
    Nothing,
    Later,
}

impl World {
    /// How steeply beds fall from shores, metres per metre.
    pub fn beach_slope(&self) -> f64 {
        self.beach_slope
    }

    /// The bed of the window of a tile of [`SHORE_LEVEL`]; `None` while tiles are on their way, which are asked for.
    pub fn shore_bed(&mut self, [x, y]: [u32; 2]) -> Option<Bed> {
        let map = Projection::Mercator;
        let levels = [Layer::Water, Layer::Terrain].map(|layer| self.max_zoom(layer, map));
        let [Some(water_level), Some(terrain_level)] = levels else { return None };
        let resolution_m = self.resolution_m(Layer::Terrain, map).unwrap_or(0.0);
        let across = 1u32 << SHORE_LEVEL;
        let mut at_hand = true;
        let mut water = Vec::with_capacity(9);
        let mut terrain = Vec::with_capacity(9);
        let mut coarse = Vec::with_capacity(9);
        let (mut wide, mut wide_water) = (Vec::with_capacity(9), Vec::with_capacity(9));
        let coarse_level = grid_level(resolution_m).min(terrain_level);
        for (dy, dx) in (0..3).flat_map(|dy| (0..3).map(move |dx| (dy, dx))) {
            let (column, row) = ((x + across + dx - 1) % across, (y + dy).saturating_sub(1).min(across - 1));
            let id = TileId { projection: map, z: SHORE_LEVEL, x: column, y: row };
            for (layer, level, found) in [
                (Layer::Water, water_level, &mut water),
                (Layer::Terrain, terrain_level, &mut terrain),
                (Layer::Terrain, coarse_level, &mut coarse),
                (Layer::Terrain, rugged::ISLAND_LEVEL.min(terrain_level), &mut wide),
                (Layer::Water, reefs::WIDE_LEVEL.min(water_level), &mut wide_water),
            ] {
                match self.served(layer, id.ancestor(level.min(SHORE_LEVEL))?) {
                    Served::By(tile, texels) => found.push(Some((tile, texels))),
                    Served::Nothing => found.push(None),
                    Served::Later => at_hand = false,
                }
            }
        }
        if !at_hand {
            return None;
        }
        let side = f64::from(across);
        let node = |i: usize| (i as f64 * 4.0) / TILE_TEXELS as f64 - 0.5;
        let (mut step_m, mut depth_m, mut shore_m) = (Vec::new(), Vec::new(), Vec::new());
        let (mut face, mut plain_m) = (Vec::new(), Vec::new());
        for j in 0..SHORE_SIDE {
            let map_y = ((f64::from(y) + node(j)) / side).clamp(0.0, 1.0);
            let (lat, _) = lat_lon_from_map(map, 0.5, map_y);
            let sin_lat = libm::sin(lat);
            let step = 4.0 * texel_size_m(map, SHORE_LEVEL, lat);
            step_m.push(step);
            for i in 0..SHORE_SIDE {
                let map_x = (f64::from(x) + node(i)) / side;
                let tile = |k: usize| usize::from(k >= SHORE_SIDE / 4) + usize::from(k >= 3 * SHORE_SIDE / 4);
                let at = tile(j) * 3 + tile(i);
                let shore = water[at].as_ref().map_or(f64::INFINITY, |(id, texels)| {
                    let (distances, at) = around(*id, texels, map_x, map_y);
                    between(distances, at) * texel_size_m(map, id.z, lat)
                });
                let elevation = terrain[at].as_ref().map_or(0.0, |(id, texels)| {
                    let (values, at) = around(*id, texels, map_x, map_y);
                    Grid::between(values, at).elevation_at(shore)
                });
                let grid = coarse[at].as_ref().map_or(Grid::level(elevation), |(id, texels)| {
                    let (values, at) = around(*id, texels, map_x, map_y);
                    Grid::between(values, at)
                });
                shore_m.push(shore);
                let coast = Coast::new(grid, resolution_m, sin_lat);
                face.push(coast.beach(self.beach_slope));
                let plain = -shaped_on(elevation, grid, shore, [resolution_m, self.beach_slope], sin_lat);
                plain_m.push(plain);
                let share = wide[at].as_ref().filter(|_| reefs::are_in(resolution_m)).map_or(0.0, |(id, texels)| {
                    let (values, at) = around(*id, texels, map_x, map_y);
                    reefs::share([map_x, map_y], sin_lat, between(values, at), texel_size_m(map, id.z, lat))
                });
                let wide_m = wide_water[at]
                    .as_ref()
                    .map_or(shore, |(id, texels)| splined(*id, texels, map_x, map_y) * texel_size_m(map, id.z, lat));
                let point = [map_x, map_y].map(|x| (x.rem_euclid(1.0) * 4_294_967_296.0) as u32);
                depth_m.push(
                    Reef::depth_on(share, point, libm::cos(lat), [shore, wide_m], plain, resolution_m, coast.far_m).0,
                );
            }
        }
        Some(Bed { side: SHORE_SIDE, step_m, depth_m, shore_m, face, plain_m })
    }

    /// The tile, or its nearest ancestor that there is. What is not at hand is asked for, without an answer to anybody.
    fn served(&mut self, layer: Layer, id: TileId) -> Served {
        for id in (0..=id.z).rev().filter_map(|z| id.ancestor(z)) {
            match self.look(layer, id) {
                Found::Tile(texels) => return Served::By(id, texels),
                Found::Absent => {}
                Found::Coming => return Served::Later,
            }
        }
        Served::Nothing
    }
}

/// The four texels of a tile around a place of the map, as far as the tile goes, metres of elevation or texels to the ocean's shore, and where
/// between them it is.
fn around(id: TileId, texels: &TileTexels, x: f64, y: f64) -> ([f64; 4], [f64; 2]) {
    let across = f64::from(1u32 << id.z);
    let within = |at: f64, tile: u32| {
        let at = (at * across - f64::from(tile)).rem_euclid(across) * TILE_TEXELS as f64 - 0.5;
        let at = at.clamp(0.0, TILE_TEXELS as f64 - 1.0);
        let low = (at as usize).min(TILE_TEXELS - 2);
        (low, at - low as f64)
    };
    let ((i, f), (j, g)) = (within(x, id.x), within(y, id.y));
    let texel = |i, j| texel(texels, i, j);
    ([texel(i, j), texel(i + 1, j), texel(i, j + 1), texel(i + 1, j + 1)], [f, g])
}

/// What [`around`] has of one texel.
fn texel(texels: &TileTexels, i: usize, j: usize) -> f64 {
    match texels {
        TileTexels::Terrain(texels) => f64::from(texels[j * TILE_TEXELS + i]),
        TileTexels::Water(texels) => f64::from(unpacked(texels[j * TILE_TEXELS + i]).0[0]) / STEPS_PER_TEXEL,
        TileTexels::Imagery(_) => 0.0,
    }
}

/// The same between nine texels, as far as the tile goes, as shaders and samples have shores.
fn splined(id: TileId, texels: &TileTexels, x: f64, y: f64) -> f64 {
    let across = f64::from(1u32 << id.z);
    let within = |at: f64, tile: u32| {
        let at = (at * across - f64::from(tile)).rem_euclid(across) * TILE_TEXELS as f64;
        let at = at.clamp(0.0, TILE_TEXELS as f64 - 1e-6);
        (at as usize, at - at.floor() - 0.5)
    };
    let ((i, f), (j, g)) = (within(x, id.x), within(y, id.y));
    let beside = |at: usize| [at.saturating_sub(1), at, (at + 1).min(TILE_TEXELS - 1)];
    Around::any(beside(j).map(|j| beside(i).map(|i| texel(texels, i, j))), [f, g]).mean_m
}

/// Between four values.
fn between([a, b, c, d]: [f64; 4], [f, g]: [f64; 2]) -> f64 {
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    mix(mix(a, b, f), mix(c, d, f), g)
}
