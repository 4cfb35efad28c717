//! Where a picture of the world shows land, by the water tiles of a world that has been baked.

use std::collections::HashMap;
use std::path::Path;

use rayon::prelude::*;

use crate::data::SharedTexels;
use crate::data::TileTexels;
use crate::data::tile::{Layer, MapPoint, Projection, TILE_TEXELS, TileId, texel_size_m};
use crate::data::water::{STEPS_PER_TEXEL, unpacked};
use crate::data::world::World;
use crate::error::Result;

/// Deepest level of the water tiles that is looked at: 5 km at the equator, and the shore to a sixteenth of that.
const DEEPEST: u8 = 5;

/// The land under each pixel of an equirectangular picture.
pub struct Land {
    /// Distance to the nearest water in pixels, negative in the water, by pixel; as far as the tiles tell it.
    inland: Vec<f32>,
    width: usize,
}

type Tiles = HashMap<TileId, SharedTexels>;

impl Land {
    /// From the water archives in a folder, for a picture of `width` x `width / 2` pixels.
    ///
    /// # Errors
    /// Archives that are missing or unreadable.
    pub fn open(folder: &Path, width: usize) -> Result<Self> {
        let mut tiles = Tiles::new();
        let mut world = World::open(&folder.display().to_string());
        for projection in Projection::ALL {
            world.open_blocking(Layer::Water, projection)?;
            for z in 0..=DEEPEST.min(world.max_zoom(Layer::Water, projection).unwrap_or(0)) {
                for (x, y) in (0..1u32 << z).flat_map(|y| (0..1u32 << z).map(move |x| (x, y))) {
                    let id = TileId { projection, z, x, y };
                    if let Some(texels) = world.tile_blocking(Layer::Water, id)? {
                        tiles.insert(id, texels);
                    }
                }
            }
        }
        let height = width / 2;
        let step = std::f64::consts::TAU / width as f64;
        let pixel_m = step * 6_378_137.0;
        let rows = (0..height).into_par_iter().flat_map_iter(|row| {
            let lat = std::f64::consts::FRAC_PI_2 - (row as f64 + 0.5) * step;
            let tiles = &tiles;
            (0..width).map(move |column| {
                let lon = (column as f64 + 0.5) * step - std::f64::consts::PI;
                (inland_m(tiles, lat, lon) / pixel_m) as f32
            })
        });
        Ok(Self { inland: rows.collect(), width })
    }

    /// How far inland each pixel lies, pixels, negative in water.
    pub fn inland(&self) -> &[f32] {
        &self.inland
    }

    /// Whether there is land within a pixel of a place (radians).
    pub fn is_near(&self, lat: f64, lon: f64) -> bool {
        let height = self.inland.len() / self.width;
        let turns = |angle: f64| angle / std::f64::consts::TAU * self.width as f64;
        let row = (turns(std::f64::consts::FRAC_PI_2 - lat) as usize).min(height - 1);
        let column = (turns(lon + std::f64::consts::PI) as i64).rem_euclid(self.width as i64) as usize;
        self.inland[row * self.width + column] > -1.0
    }
}

/// Metres to the nearest water, negative in it.
fn inland_m(tiles: &Tiles, lat: f64, lon: f64) -> f64 {
    let point = MapPoint::from_lat_lon(lat, lon);
    let finest = (0..=DEEPEST).rev().find_map(|z| Some((z, tiles.get(&point.tile(z))?)));
    let Some((z, TileTexels::Water(texels))) = finest.map(|(z, tile)| (z, &**tile)) else { return f64::NEG_INFINITY };
    let (column, row) = point.texel(z);
    let ([ocean, lake], _) =
        unpacked(texels[(row as usize % TILE_TEXELS) * TILE_TEXELS + column as usize % TILE_TEXELS]);
    -f64::from(ocean.max(lake)) / STEPS_PER_TEXEL * texel_size_m(point.projection, z, lat)
}
