//! What is at one place: elevation, depth, water class, shore distance, looked up in the tiles texel by texel.
//!
//! Between texel centres elevations are bilinear and distances to shores quadratic B-splines, lest shores be polygons whose corners lie on the
//! texels' lines; also across tile borders, and where a neighbouring tile is missing, its parent stands in. The class follows the interpolated distances, so that it changes exactly where the drawn coast is.

use super::tile::{
    Layer, MapPoint, Projection, TILE_TEXELS, TileId, lat_lon_from_map, map_from_lat_lon, texel_size_m, texels_across,
};
use super::water::{BY_RIVER, MOST_STEPS, ON_ISLAND, SATURATION_TEXELS, STEPS_PER_TEXEL, WaterClass, unpacked};
use super::{SharedTexels, TileTexels};
use crate::error::Result;
use crate::model::earth;
use crate::model::lakes::{self, Stands};
use crate::model::reefs::{self, Reef};
use crate::model::relief::{self, MESH_FOOTPRINT_M, relief};
use crate::model::rugged::{self, Around, Shores};
use crate::model::sea_bed::{Coast, Grid, grid_level, shaped_on};
use crate::model::shore_waves::Shallows;
use crate::model::towers;

/// What is at one place.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Sample {
    /// Elevation of the ground over the rest surface of the sea as it is drawn, metres: the next two together.
    pub elevation_m: f64,
    /// What the data say of it, shaped so that it meets the sharp coast, and lakes whose level is known at that.
    pub elevation_measured_m: f64,
    /// What is made up for the data's coarseness: on dry land, see [`crate::model::relief`], and of coral reefs, see [`crate::model::reefs`].
    pub relief_made_m: f64,
    /// Depth of the resting ocean, metres; `None` outside of it (the depth of lakes is not known).
    pub depth_m: Option<f64>,
    /// What covers the ground.
    pub class: WaterClass,
    /// Distance to the ocean's shore, metres, positive in the ocean. `None` where there is no water tile, and where it is
    /// more than eight texels of the coarsest tile (1,200 km at the equator, 100 km at the poles).
    pub shore_distance_m: Option<f64>,
    /// What coral reefs leave of the waves' height.
    #[serde(skip)]
    pub waves_left: f64,
    /// Slope of the ocean's beaches there, by nature and the user's wish.
    #[serde(skip)]
    pub beach: f64,
    /// Distance to the nearest shore of a lake or a river, metres, positive in it; as above.
    pub lake_distance_m: Option<f64>,
    /// The lake that covers the ground, where it is one of the table (`model::lakes`).
    pub lake: Option<&'static str>,
    /// The level of the lake or river that covers the ground, metres, where it is known: by the table, or by the terrain along its shore or
    /// course. The elevation is that, too.
    pub inland_level_m: Option<f64>,
    /// Whether its surface moves near the eye: that of a lake whose level is known, and not of a river, however wide.
    #[serde(skip)]
    pub is_moving_lake: bool,
    /// The level of the terrain tile.
    pub terrain_level: u8,
    /// The level of the water tile; `None`: no tile, the class comes from the sign of the elevation.
    pub water_level: Option<u8>,
}

impl Sample {
    /// The ocean by its shore, if it is one.
    pub fn shallows(&self) -> Option<Shallows> {
        let place = Shallows::new(self.depth_m?, self.shore_distance_m?, self.beach);
        Some(Shallows { plain_h: -self.elevation_measured_m, left: self.waves_left, ..place })
    }
}

/// What a sample needs to know about the terrain archive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Terrain {
    /// Its deepest level.
    pub deepest: u8,
    /// The real resolution of its source, metres.
    pub resolution_m: f64,
    /// How steeply the bed falls from shores, metres per metre, see [`shaped_on`].
    pub beach_slope: f64,
}

/// A way to get at a tile; `None`: the parent serves.
pub type LookUp<'a> = dyn FnMut(Layer, TileId) -> Result<Option<SharedTexels>> + 'a;

/// What is at geodetic `lat`, `lon` (radians), where the nearest inland water stands somewhere; `None` without any terrain tile.
///
/// # Errors
/// Those of `look_up`.
pub fn sample(
    (lat, lon): (f64, f64),
    terrain: Terrain,
    deepest_water: Option<u8>,
    stands: Option<Stands>,
    look_up: &mut LookUp<'_>,
) -> Result<Option<Sample>> {
    let projection = Projection::for_latitude(lat);
    let mut map = Map { projection, at: map_from_lat_lon(projection, lat, lon), look_up };
    let point = MapPoint::on(projection, lat, lon);
    let Some((terrain_level, _)) = map.deepest(Layer::Terrain, point, terrain.deepest)? else { return Ok(None) };
    let Some(around) = map.grid(point, terrain_level, terrain_level)? else { return Ok(None) };
    let raw_m = around.elevation_m;
    let water = match deepest_water {
        Some(deepest) => map.deepest(Layer::Water, point, deepest)?,
        None => None,
    };
    let Some((water_level, texels)) = water else {
        let class = if raw_m < 0.0 { WaterClass::Ocean } else { WaterClass::Land };
        return Ok(Some(Sample {
            elevation_m: raw_m,
            elevation_measured_m: raw_m,
            relief_made_m: 0.0,
            depth_m: (raw_m < 0.0).then_some(-raw_m),
            class,
            shore_distance_m: None,
            waves_left: 1.0,
            beach: terrain.beach_slope,
            lake_distance_m: None,
            lake: None,
            inland_level_m: None,
            is_moving_lake: false,
            terrain_level,
            water_level: None,
        }));
    };
    let [ocean_m, lake_m] = map.shores(water_level, lat)?;
    let nearest = texel_index(point, water_level);
    let marks = if let TileTexels::Water(texels) = &*texels { unpacked(texels[nearest]).1 } else { 0 };
    let by_river = marks & BY_RIVER != 0;
    let class = match [ocean_m, lake_m].map(|shore_m| shore_m > 0.0) {
        [true, _] => WaterClass::Ocean,
        [_, true] if by_river => WaterClass::River,
        [_, true] => WaterClass::Lake,
        _ if marks & ON_ISLAND != 0 => WaterClass::Island,
        _ => WaterClass::Land,
    };
    let Some(grid) = map.grid(point, grid_level(terrain.resolution_m), terrain_level)? else { return Ok(None) };
    let measured_m = shaped_on(
        around.elevation_at(ocean_m),
        grid,
        ocean_m,
        [terrain.resolution_m, terrain.beach_slope],
        libm::sin(lat),
    );
    let stands = stands.filter(|_| class != WaterClass::Ocean && projection == Projection::Mercator);
    let shaped = |stands: Stands| lakes::shaped(measured_m, lake_m, stands.level_m, stands.margin_for(by_river));
    let elevation_measured_m = stands.map_or(measured_m, shaped);
    let is_dry = matches!(class, WaterClass::Land | WaterClass::Island);
    let relief_made_m = if is_dry && rugged::is_coarse(terrain.resolution_m) {
        let shores = Shores { ocean_m, lake_m };
        map.relief(point, [terrain.deepest, water_level], (lat, lon), elevation_measured_m, shores)?
    } else {
        0.0
    };
    let (mut relief_made_m, mut waves_left) = (relief_made_m, 1.0);
    let coast = Coast::new(grid, terrain.resolution_m, libm::sin(lat));
    let has_reefs = ocean_m > -reefs::ASHORE_M && reefs::are_in(terrain.resolution_m);
    let share =
        if has_reefs && projection == Projection::Mercator { map.reef_share(terrain.deepest, lat)? } else { 0.0 };
    if share > 0.0 {
        let (at, cos_lat) = ([point.u, point.v], libm::cos(lat));
        let wide_m = map.splined_shores(reefs::WIDE_LEVEL.min(water_level))?.map_or(ocean_m, |shores| shores[0]);
        let (depth_m, left) =
            Reef::depth_on(share, at, cos_lat, [ocean_m, wide_m], -measured_m, terrain.resolution_m, coast.far_m);
        waves_left = left;
        if class == WaterClass::Ocean {
            relief_made_m = -depth_m - measured_m;
        }
    }
    let elevation_m = elevation_measured_m + relief_made_m;
    let is_inland = matches!(class, WaterClass::Lake | WaterClass::River);
    let at_level = stands.filter(|water| is_inland && elevation_m == water.level_m);
    Ok(Some(Sample {
        elevation_m,
        elevation_measured_m,
        relief_made_m,
        depth_m: (class == WaterClass::Ocean).then_some(-elevation_m),
        class,
        shore_distance_m: map.known(ocean_m, lat),
        waves_left,
        beach: coast.beach(terrain.beach_slope),
        lake_distance_m: map.known(lake_m, lat),
        lake: at_level.and_then(|lake| lake.name),
        inland_level_m: at_level.map(|water| water.level_m),
        is_moving_lake: class == WaterClass::Lake && at_level.is_some_and(|water| !water.is_river()),
        terrain_level,
        water_level: Some(water_level),
    }))
}

/// Index, within its tile of level `z`, of the texel that holds the point.
fn texel_index(point: MapPoint, z: u8) -> usize {
    let (column, row) = point.texel(z);
    (row as usize % TILE_TEXELS) * TILE_TEXELS + column as usize % TILE_TEXELS
}

/// The first of the four texels around a place of the map, column and row, and how far the place is on to the next.
fn cell(z: u8, (x, y): (f64, f64)) -> ((i64, i64), [f64; 2]) {
    let side = texels_across(z);
    let (gx, gy) = (x * side - 0.5, y * side - 0.5);
    ((gx.floor() as i64, gy.floor() as i64), [gx - gx.floor(), gy - gy.floor()])
}

/// What nine texels hold, by rows, as [`Map::texel`] tells it.
type NineTexels = [[[f64; 2]; 3]; 3];

/// One map, looked at from one position on it.
struct Map<'a, 'b> {
    projection: Projection,
    at: (f64, f64),
    look_up: &'a mut LookUp<'b>,
}

impl Map<'_, '_> {
    /// The deepest tile that holds the point, from level `from` upwards.
    fn deepest(&mut self, layer: Layer, point: MapPoint, from: u8) -> Result<Option<(u8, SharedTexels)>> {
        for z in (0..=from).rev() {
            if let Some(texels) = (self.look_up)(layer, point.tile(z))? {
                return Ok(Some((z, texels)));
            }
        }
        Ok(None)
    }

    /// Signed distances to the shores of ocean and lakes as a level tells them, metres.
    fn splined_shores(&mut self, z: u8) -> Result<Option<[f64; 2]>> {
        let Some((shores, between)) = self.neighbours(Layer::Water, z)? else { return Ok(None) };
        Ok(Some([0, 1].map(|which| Around::any(shores.map(|row| row.map(|shores| shores[which])), between).mean_m)))
    }

    /// What the terrain's tiles of a level have around the position, or those of `deepest`, which there are.
    fn grid(&mut self, point: MapPoint, level: u8, deepest: u8) -> Result<Option<Grid>> {
        let z = self.deepest(Layer::Terrain, point, level.min(deepest))?.map_or(deepest, |(z, _)| z);
        let ((i, j), between) = cell(z, self.at);
        let mut values = [0.0; 4];
        for (value, (di, dj)) in values.iter_mut().zip([(0, 0), (1, 0), (0, 1), (1, 1)]) {
            let Some([metres, _]) = self.texel(Layer::Terrain, z, i + di, j + dj)? else { return Ok(None) };
            *value = metres;
        }
        Ok(Some(Grid::between(values, between)))
    }

    /// Signed distances to the shores of ocean and lakes, metres: from level `z`, and for what is farther than its texels can hold from
    /// the level above, and so on. The sign stays that of level `z`.
    fn shores(&mut self, z: u8, lat: f64) -> Result<[f64; 2]> {
        let sharp = self.splined_shores(z)?.unwrap_or_default();
        let mut shores = sharp;
        for level in (0..z).rev() {
            let texel_m = texel_size_m(self.projection, level + 1, lat);
            let reach_m = MOST_STEPS.map(|most| (f64::from(most) / STEPS_PER_TEXEL - 0.1) * texel_m);
            if shores.iter().zip(reach_m).all(|(shore, reach_m)| shore.abs() < reach_m) {
                break;
            }
            let Some(coarse) = self.splined_shores(level)? else { continue };
            for (((shore, coarse), sharp), reach_m) in shores.iter_mut().zip(coarse).zip(sharp).zip(reach_m) {
                if shore.abs() >= reach_m {
                    *shore = shore.abs().max(coarse.abs()).copysign(sharp);
                }
            }
        }
        Ok(shores)
    }

    /// A distance, unless even the coarsest tile says only that it is larger than it can tell.
    fn known(&self, distance_m: f64, lat: f64) -> Option<f64> {
        let reach_m = (SATURATION_TEXELS - 0.1) * texel_size_m(self.projection, 0, lat);
        (distance_m.abs() < reach_m).then_some(distance_m)
    }

    /// How far there is a coral reef about the position.
    fn reef_share(&mut self, deepest: u8, lat: f64) -> Result<f64> {
        let z = rugged::ISLAND_LEVEL.min(deepest);
        let [mean_m, _] = self.bilinear(Layer::Terrain, z, self.at)?.unwrap_or_default();
        let texel_m = texel_size_m(self.projection, z, lat);
        Ok(reefs::share([self.at.0, self.at.1], libm::sin(lat), mean_m, texel_m))
    }

    /// The made relief of dry ground at the position, metres; see [`crate::model::rugged`].
    fn relief(
        &mut self,
        point: MapPoint,
        [terrain, water]: [u8; 2],
        (lat, lon): (f64, f64),
        elevation_m: f64,
        shores: Shores,
    ) -> Result<f64> {
        let sin_lat = libm::sin(lat);
        let fade = rugged::fade(sin_lat, shores);
        let [coarsest, level] = [rugged::ISLAND_LEVEL, rugged::LEVEL].map(|z| z.min(terrain));
        let Some((z, _)) = self.deepest(Layer::Terrain, point, level)? else { return Ok(0.0) };
        let Some((shore_z, _)) = self.deepest(Layer::Water, point, rugged::SHORE_LEVEL.min(water))? else {
            return Ok(0.0);
        };
        let texel_m = |z| texel_size_m(self.projection, z, lat);
        let [data_m, shore_m, coarse_m] = [z, shore_z, coarsest].map(texel_m);
        let Some((metres, t)) = self.neighbours(Layer::Terrain, z)? else { return Ok(0.0) };
        let data = Around::of(metres.map(|row| row.map(|[elevation_m, _]| elevation_m)), t);
        let Some((metres, t)) = self.neighbours(Layer::Water, shore_z)? else { return Ok(0.0) };
        let inland = Around::any(metres.map(|row| row.map(|[ocean_m, _]| -ocean_m)), t);
        let mut mean_of = |z| Ok(self.bilinear(Layer::Terrain, z, self.at)?.unwrap_or_default()[0]);
        let wide_mean_m = mean_of(coarsest)?;
        let oceanic = rugged::oceanic(wide_mean_m, coarse_m);
        let rocky = rugged::rocky(mean_of(rugged::SHELF_LEVEL)?, data.mean_m, sin_lat);
        let (inland_m, inland_rise) = rugged::counted_inland(inland.mean_m, oceanic, rocky);
        let (lift_m, rise) = rugged::lift(oceanic.max(rocky), inland_m, elevation_m);
        let island_m = fade * lift_m;
        let Some((hills_z, _)) = self.deepest(Layer::Terrain, point, rugged::DROWNED_LEVEL.min(terrain))? else {
            return Ok(0.0);
        };
        let Some((metres, t)) = self.neighbours(Layer::Terrain, hills_z)? else { return Ok(0.0) };
        let hills = Around::of(metres.map(|row| row.map(|[elevation_m, _]| elevation_m)), t);
        let Some((broken_z, _)) = self.deepest(Layer::Water, point, rugged::DROWNED_SHORE_LEVEL.min(water))? else {
            return Ok(0.0);
        };
        let Some((metres, t)) = self.neighbours(Layer::Water, broken_z)? else { return Ok(0.0) };
        let broken_m = texel_size_m(self.projection, broken_z, lat);
        let broken = Around::any(metres.map(|row| row.map(|[ocean_m, _]| -ocean_m / broken_m)), t);
        let steep = rugged::drowned_rise(broken, hills.deviation_m, wide_mean_m, sin_lat);
        let stand = towers::height([point.u, point.v]);
        let drowned_m = rugged::drowned_lift_m(steep, shores, sin_lat, elevation_m + island_m, stand);
        let lift_m = island_m + drowned_m;
        let strength_m = fade * rugged::strength_m(data, data_m, sin_lat, [elevation_m + island_m, island_m])
            + rugged::drowned_strength_m(drowned_m, elevation_m + lift_m);
        let (up, axes) = (earth::normal(lat, lon), earth::ecef_from_enu(lat, lon));
        let way = |rise_m: [f64; 2], texel_m: f64| self.projection.east_north(rise_m, lon) / texel_m;
        let slope = way(data.rise_m, data_m) + fade * rise * inland_rise * way(inland.rise_m, shore_m);
        let carved = rugged::carved(oceanic.max(rocky), sin_lat, fade, strength_m);
        let found = relief(relief::place(up), up, axes * slope.extend(0.0), [strength_m, carved], MESH_FOOTPRINT_M);
        Ok(lift_m + rugged::bounded(elevation_m + lift_m, found.height_m).0)
    }

    /// The nine texels around the position, by rows, and where in the middle one it is, -1/2 to 1/2.
    fn neighbours(&mut self, layer: Layer, z: u8) -> Result<Option<(NineTexels, [f64; 2])>> {
        let place = [self.at.0, self.at.1].map(|x| x * texels_across(z));
        let [column, row] = place.map(|x| x.floor() as i64);
        let mut texels = [[[0.0; 2]; 3]; 3];
        for (texels, j) in texels.iter_mut().zip(-1..) {
            for (texel, i) in texels.iter_mut().zip(-1..) {
                let Some(value) = self.texel(layer, z, column + i, row + j)? else { return Ok(None) };
                *texel = value;
            }
        }
        Ok(Some((texels, place.map(|x| x - x.floor() - 0.5))))
    }

    /// The value at a place of the map between the four texels around it, as those of [`Map::texel`].
    fn bilinear(&mut self, layer: Layer, z: u8, at: (f64, f64)) -> Result<Option<[f64; 2]>> {
        let ((i, j), [fx, fy]) = cell(z, at);
        let mut sum = [0.0; 2];
        for (di, dj, weight) in
            [(0, 0, (1.0 - fx) * (1.0 - fy)), (1, 0, fx * (1.0 - fy)), (0, 1, (1.0 - fx) * fy), (1, 1, fx * fy)]
        {
            let Some(value) = self.texel(layer, z, i + di, j + dj)? else { return Ok(None) };
            sum = [sum[0] + weight * value[0], sum[1] + weight * value[1]];
        }
        Ok(Some(sum))
    }

    /// The value of one world texel, from its own tile or, where that is missing, interpolated from the levels above:
    /// [elevation, 0] or [ocean shore, lake shore], metres.
    fn texel(&mut self, layer: Layer, z: u8, column: i64, row: i64) -> Result<Option<[f64; 2]>> {
        let side = (TILE_TEXELS as i64) << z;
        let column = match self.projection {
            Projection::Mercator => column.rem_euclid(side),
            _ => column.clamp(0, side - 1),
        };
        let row = row.clamp(0, side - 1);
        let tile = TileId { projection: self.projection, z, x: (column >> 8) as u32, y: (row >> 8) as u32 };
        let centre = ((column as f64 + 0.5) / side as f64, (row as f64 + 0.5) / side as f64);
        let index = (row & 255) as usize * TILE_TEXELS + (column & 255) as usize;
        match (self.look_up)(layer, tile)?.as_deref() {
            Some(TileTexels::Terrain(texels)) => Ok(Some([f64::from(texels[index]), 0.0])),
            Some(TileTexels::Water(texels)) => {
                let (shores, _) = unpacked(texels[index]);
                let (lat, _) = lat_lon_from_map(self.projection, centre.0, centre.1);
                let texel_m = texel_size_m(self.projection, z, lat);
                Ok(Some(shores.map(|steps| f64::from(steps) / STEPS_PER_TEXEL * texel_m)))
            }
            Some(TileTexels::Imagery(_)) => Ok(None),
            None if z > 0 => self.bilinear(layer, z - 1, centre),
            None => Ok(None),
        }
    }
}
