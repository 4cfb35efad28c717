//! The terrain pyramids: elevation tiles of a [`Ground`].

use crate::data::pmtiles::write::ArchiveWriter;
use crate::data::terrarium;
use crate::data::tile::{Projection, TILE_TEXELS, TileId, lat_lon_from_map, texel_size_m};
use crate::error::Result;
use rayon::prelude::*;

/// Tiles baked at a time, 64 KiB each before they are written.
const BATCH: usize = 64;
/// Samples along one side of a texel at most.
const MAX_SAMPLES: usize = 16;
/// Texels of one row with one neighbour on each side.
const PADDED: usize = TILE_TEXELS + 2;

/// Where the ground lies.
pub trait Ground: Sync {
    /// Elevation at a place (degrees), of the sea's bed or of the land, metres.
    fn at(&self, lat_deg: f64, lon_deg: f64, ocean: bool) -> f32;

    /// Whether the ocean is there.
    fn is_ocean(&self, lat_deg: f64, lon_deg: f64) -> bool;

    /// How far its values are apart, degrees.
    fn step_deg(&self) -> f64;

    /// Whether all that lies within so many degrees of a place is as it is there, so that one look at it tells the mean.
    fn is_level(&self, _lat_deg: f64, _lon_deg: f64, _within_deg: f64) -> bool {
        false
    }

    /// Whether a tile below the first level has any of it.
    fn reaches(&self, _tile: TileId) -> bool {
        true
    }
}

/// How deep, and where.
pub struct Depth {
    /// The deepest level.
    pub max_zoom: u8,
    /// Down to this level every tile is there; below only those with an ocean's shore in them.
    pub full_zoom: u8,
    /// Below `full_zoom`, a tile is made only if its texels differ from what half as many would draw by this mean, metres.
    pub worth_m: f64,
}

/// Makes one terrain archive's tiles.
pub fn add_tiles(
    writer: &mut ArchiveWriter,
    projection: Projection,
    ground: &dyn Ground,
    depth: &Depth,
    mut progress: impl FnMut(u8, usize, usize),
) -> Result<()> {
    let mut level = vec![TileId::root(projection)];
    for z in 0..=depth.max_zoom {
        let mut next = Vec::new();
        for (batch, tiles) in level.chunks(BATCH).enumerate() {
            let worth_m = (z > depth.full_zoom).then_some(depth.worth_m);
            let made: Vec<_> = tiles.par_iter().map(|tile| terrain_tile(*tile, ground, worth_m)).collect();
            for (tile, bytes) in tiles.iter().zip(made) {
                if let Some(bytes) = bytes? {
                    writer.add(z, tile.x, tile.y, &bytes)?;
                    next.extend(tile.children().into_iter().flatten().filter(|child| ground.reaches(*child)));
                }
            }
            progress(z, (batch * BATCH + tiles.len()).min(level.len()), level.len());
        }
        level = next;
    }
    Ok(())
}

/// The PNG of a tile; with `worth_m`, `None` where it has no shore or adds less than that to its parent.
fn terrain_tile(tile: TileId, ground: &dyn Ground, worth_m: Option<f64>) -> Result<Option<Vec<u8>>> {
    // Texel centres with one neighbour on each side; degrees and whether the ocean is there.
    let places: Vec<_> = (0..PADDED * PADDED)
        .map(|at| place(tile, (at % PADDED) as f64 - 1.0, (at / PADDED) as f64 - 1.0, ground))
        .collect();
    if worth_m.is_some() && places.iter().all(|place| place.2 == places[0].2) {
        return Ok(None);
    }
    let mut metres = Vec::with_capacity(TILE_TEXELS * TILE_TEXELS);
    for row in 0..TILE_TEXELS {
        for column in 0..TILE_TEXELS {
            let at = (row + 1) * PADDED + column + 1;
            let (lat_deg, lon_deg, ocean) = places[at];
            let texel_m = texel_size_m(tile.projection, tile.z, lat_deg.to_radians());
            let samples = ((texel_m / (ground.step_deg() * 111_300.0)).round() as usize).clamp(1, MAX_SAMPLES);
            let samples = if ground.is_level(lat_deg, lon_deg, texel_m / 111_300.0) { 1 } else { samples };
            let mut mean = 0.0;
            for i in 0..samples * samples {
                let offset = |i: usize| (i as f64 + 0.5) / samples as f64 - 0.5;
                let (lat_deg, lon_deg, ocean) = match samples {
                    1 => (lat_deg, lon_deg, ocean),
                    _ => place(tile, column as f64 + offset(i % samples), row as f64 + offset(i / samples), ground),
                };
                mean += ground.at(lat_deg, lon_deg, ocean);
            }
            mean /= (samples * samples) as f32;
            // Interpolation between an ocean texel and the land beside it must not draw the land below the sea: next to
            // land the bed is kept shallow; from there on the shore's distance shapes it (`model::sea_bed`).
            let beside_land = || {
                let rows = [at - PADDED, at, at + PADDED];
                rows.iter().any(|at| places[at - 1..=at + 1].iter().any(|place| !place.2))
            };
            if ocean && beside_land() {
                mean = mean.max(-7.0 - 0.01 * texel_m as f32);
            }
            metres.push(coarser_far_from_sea_level(mean));
        }
    }
    if worth_m.is_some_and(|worth_m| detail_m(&metres) < worth_m) {
        return Ok(None);
    }
    terrarium::encode(&metres).map(Some)
}

/// How far, in the mean, the texels lie from the bilinear surface of half as many per side, metres.
fn detail_m(metres: &[f32]) -> f64 {
    let half = TILE_TEXELS / 2;
    let coarse = |i: usize, j: usize| {
        let at = 2 * j.min(half - 1) * TILE_TEXELS + 2 * i.min(half - 1);
        (metres[at] + metres[at + 1] + metres[at + TILE_TEXELS] + metres[at + TILE_TEXELS + 1]) / 4.0
    };
    let mut sum = 0.0;
    for (at, fine) in metres.iter().enumerate() {
        let (column, row) = (at % TILE_TEXELS, at / TILE_TEXELS);
        // A fine texel's centre lies a quarter of the way from its coarse one to the next on its side.
        let beside = |k: usize| if k.is_multiple_of(2) { (k / 2).saturating_sub(1) } else { k / 2 + 1 };
        let (i, j, i2, j2) = (column / 2, row / 2, beside(column), beside(row));
        let along = |j| 0.75 * coarse(i, j) + 0.25 * coarse(i2, j);
        sum += f64::from((fine - (0.75 * along(j) + 0.25 * along(j2))).abs());
    }
    sum / metres.len() as f64
}

/// (latitude, longitude, is ocean) at a place in texels from the centre of the tile's first texel; degrees.
fn place(tile: TileId, column: f64, row: f64, ground: &dyn Ground) -> (f64, f64, bool) {
    let (x, y) = tile.texel_centre(column, row);
    let y = if tile.projection == Projection::Mercator { y.clamp(0.0, 1.0) } else { y };
    let (lat, lon) = lat_lon_from_map(tile.projection, x, y);
    let (lat_deg, lon_deg) = (lat.to_degrees(), lon.to_degrees());
    (lat_deg, lon_deg, ground.is_ocean(lat_deg, lon_deg))
}

/// Metres in steps of at most 1/16 of the height: half a metre within 2 m of sea level, 1 m to 32 m, then doubling up
/// to 32 m, so that the archive stays small. Keeps the sign.
fn coarser_far_from_sea_level(metres: f32) -> f32 {
    let step = match metres.abs() {
        shore if shore < 2.0 => 0.5,
        height => [32.0, 64.0, 128.0, 256.0, 512.0]
            .iter()
            .fold(1.0, |step, limit| if height < *limit { step } else { 2.0 * step }),
    };
    let rounded = (metres / step).round() * step;
    if rounded == 0.0 { 0.25f32.copysign(metres) } else { rounded }
}
