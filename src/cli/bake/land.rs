//! Where a picture of the world shows land, by the water tiles of a world that has been baked.

use std::collections::HashMap;
use std::path::Path;

use rayon::prelude::*;

use crate::data::fetch::Source;
use crate::data::pmtiles::Archive;
use crate::data::tile::{Layer, MapPoint, Projection, TILE_TEXELS, TileId, texel_size_m};
use crate::data::water::{self, SATURATION_TEXELS, distance_from_byte};
use crate::data::world::archive_name;
use crate::error::Result;

/// Deepest level of the water tiles that is looked at: 5 km at the equator, and the shore to a sixteenth of that.
const DEEPEST: u8 = 5;

/// The land under each pixel of an equirectangular picture.
pub struct Land {
    /// Distance to the nearest water in pixels, negative in the water, by pixel; as far as the tiles tell it.
    inland: Vec<f32>,
    width: usize,
}

type Tiles = HashMap<TileId, Vec<[u8; 4]>>;

impl Land {
    /// From the water archives in a folder, for a picture of `width` x `width / 2` pixels.
    ///
    /// # Errors
    /// Archives that are missing or unreadable.
    pub fn open(folder: &Path, width: usize) -> Result<Self> {
        let mut tiles = Tiles::new();
        for projection in Projection::ALL {
            let path = folder.join(archive_name(Layer::Water, projection));
            let archive = pollster::block_on(Archive::open(Source::new(path.display().to_string())))?;
            for z in 0..=DEEPEST.min(archive.header().max_zoom) {
                for (x, y) in (0..1u32 << z).flat_map(|y| (0..1u32 << z).map(move |x| (x, y))) {
                    let id = TileId { projection, z, x, y };
                    if let Some(bytes) = pollster::block_on(archive.tile(z, x, y))? {
                        tiles.insert(id, water::decode(&format!("water tile {id}"), &bytes)?);
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
    let mut inland_m: Option<f64> = None;
    for (z, texels) in (0..=DEEPEST).rev().filter_map(|z| Some((z, tiles.get(&point.tile(z))?))) {
        let (column, row) = point.texel(z);
        let [ocean, lake, ..] = texels[(row as usize % TILE_TEXELS) * TILE_TEXELS + column as usize % TILE_TEXELS];
        let texels = -distance_from_byte(ocean.max(lake));
        let metres = texels * texel_size_m(point.projection, z, lat);
        // The finest tile has the last word on the side; what is too far for it, coarser ones tell.
        inland_m = Some(inland_m.map_or(metres, |fine| fine.abs().max(metres.abs()).copysign(fine)));
        if texels.abs() < SATURATION_TEXELS - 0.1 {
            break;
        }
    }
    inland_m.unwrap_or(f64::NEG_INFINITY)
}
