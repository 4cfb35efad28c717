//! The imagery pyramids: the land's colour from a picture of the world.

use super::land::Land;
use super::picture::{Picture, display};
use crate::data::pmtiles::write::ArchiveWriter;
use crate::data::tile::{Projection, TILE_TEXELS, TileId, lat_lon_from_map};
use crate::error::{Error, Result};
use jpeg_encoder::{ColorType, Encoder, SamplingFactor};
use rayon::prelude::*;

/// Tiles baked at a time.
const BATCH: usize = 32;
/// Samples along one side of a texel at most.
const MAX_SAMPLES: usize = 48;
/// Texels of land that count as few: an island of six by six.
const FEW: usize = 36;

/// How deep, and how good.
pub struct Depth {
    /// The deepest level.
    pub max_zoom: u8,
    /// Down to this level every tile with land in it is made.
    pub full_zoom: u8,
    /// A deeper tile is made only if its land differs from what half as many texels would draw by this mean, steps of 255.
    pub worth: f64,
    /// Of the JPEGs, 1 to 100.
    pub quality: u8,
}

/// Makes one imagery archive's tiles.
pub fn add_tiles(
    writer: &mut ArchiveWriter,
    projection: Projection,
    (picture, land): (&Picture, &Land),
    depth: &Depth,
    mut progress: impl FnMut(u8, usize, usize),
) -> Result<()> {
    let mut level = vec![TileId::root(projection)];
    for z in 0..=depth.max_zoom {
        let mut next = Vec::new();
        for (batch, tiles) in level.chunks(BATCH).enumerate() {
            let made: Vec<_> = tiles.par_iter().map(|tile| imagery_tile(*tile, picture, land, depth)).collect();
            for (tile, bytes) in tiles.iter().zip(made) {
                if let Some(bytes) = bytes? {
                    writer.add(z, tile.x, tile.y, &bytes)?;
                    next.extend(tile.children().into_iter().flatten());
                }
            }
            progress(z, (batch * BATCH + tiles.len()).min(level.len()), level.len());
        }
        level = next;
    }
    Ok(())
}

/// The JPEG of a tile; `None` where it has no land, the root apart, or adds too little to its parent.
fn imagery_tile(tile: TileId, picture: &Picture, land: &Land, depth: &Depth) -> Result<Option<Vec<u8>>> {
    let place = |column: f64, row: f64| {
        let (x, y) = tile.texel_centre(column, row);
        lat_lon_from_map(
            tile.projection,
            x,
            if tile.projection == Projection::Mercator { y.clamp(0.0, 1.0) } else { y },
        )
    };
    // Beside the tile, too: filters look over its edge.
    let is_land = |column: i64, row: i64| {
        let (lat, lon) = place(column as f64, row as f64);
        land.is_near(lat, lon)
    };
    let side = TILE_TEXELS as i64;
    let places = (0..side * side).map(|at| is_land(at % side, at / side)).collect::<Vec<_>>();
    if tile.z > 0 && !places.contains(&true) {
        return Ok(None);
    }
    let mut texels = vec![[0.0f32; 3]; TILE_TEXELS * TILE_TEXELS];
    for (at, texel) in texels.iter_mut().enumerate() {
        *texel = mean(picture, |dx, dy| place((at % TILE_TEXELS) as f64 + dx, (at / TILE_TEXELS) as f64 + dy));
    }
    let bytes: Vec<[u8; 3]> =
        texels.iter().map(|texel| texel.map(|part| (255.0 * display(part)).round() as u8)).collect();
    if tile.z > depth.full_zoom && detail(&bytes, &places) < depth.worth {
        return Ok(None);
    }
    encode(&bytes, depth.quality).map(Some)
}

/// Linear mean of the picture over a texel, of which `place` tells latitude and longitude, radians, at offsets from its centre in texels.
fn mean(picture: &Picture, place: impl Fn(f64, f64) -> (f64, f64)) -> [f32; 3] {
    let step = picture.step_deg().to_radians();
    let (lat, lon) = place(0.0, 0.0);
    // How many pixels a texel covers along its sides.
    let across = |(lat2, lon2): (f64, f64), (lat1, lon1): (f64, f64)| {
        let around = (lon2 - lon1 + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
        (lat2 - lat1).hypot(around) / step
    };
    let samples = |covered: f64| ((1.5 * covered).ceil() as usize).clamp(1, MAX_SAMPLES);
    let [columns, rows] =
        [samples(across(place(0.5, 0.0), place(-0.5, 0.0))), samples(across(place(0.0, 0.5), place(0.0, -0.5)))];
    let mut sum = [0.0; 3];
    for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
        let offset = |i: usize, all: usize| (i as f64 + 0.5) / all as f64 - 0.5;
        let (lat, lon) = match columns * rows {
            1 => (lat, lon),
            _ => place(offset(i, columns), offset(j, rows)),
        };
        let column = (lon + std::f64::consts::PI) / step - 0.5;
        let row = (std::f64::consts::FRAC_PI_2 - lat) / step - 0.5;
        sum.iter_mut().zip(picture.at(column, row)).for_each(|(sum, part)| *sum += part);
    }
    sum.map(|part| part / (columns * rows) as f32)
}

/// How far, in the mean, the texels of the land lie from the bilinear picture of half as many a side, steps of 255; where there are few, in
/// the mean of [`FEW`].
fn detail(texels: &[[u8; 3]], land: &[bool]) -> f64 {
    let half = TILE_TEXELS / 2;
    let coarse = |i: usize, j: usize, part: usize| {
        let at = 2 * j.min(half - 1) * TILE_TEXELS + 2 * i.min(half - 1);
        let four = [at, at + 1, at + TILE_TEXELS, at + TILE_TEXELS + 1];
        four.iter().map(|at| f64::from(texels[*at][part])).sum::<f64>() / 4.0
    };
    let mut sum = 0.0;
    for (at, texel) in texels.iter().enumerate().filter(|(at, _)| land[*at]) {
        let (column, row) = (at % TILE_TEXELS, at / TILE_TEXELS);
        // A fine texel's centre lies a quarter of the way from its coarse one to the next on its side.
        let beside = |k: usize| if k.is_multiple_of(2) { (k / 2).saturating_sub(1) } else { k / 2 + 1 };
        let (i, j, i2, j2) = (column / 2, row / 2, beside(column), beside(row));
        for (part, value) in texel.iter().enumerate() {
            let along = |j| 0.75 * coarse(i, j, part) + 0.25 * coarse(i2, j, part);
            sum += (f64::from(*value) - (0.75 * along(j) + 0.25 * along(j2))).abs();
        }
    }
    sum / (3 * land.iter().filter(|is_land| **is_land).count().max(FEW)) as f64
}

/// The JPEG of 65,536 texels, colours as sharp as brightness.
fn encode(texels: &[[u8; 3]], quality: u8) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, quality);
    encoder.set_sampling_factor(SamplingFactor::R_4_4_4);
    encoder.set_optimized_huffman_tables(true);
    let side = TILE_TEXELS as u16;
    let written = encoder.encode(texels.as_flattened(), side, side, ColorType::Rgb);
    written.map_err(|e| Error::bad_data("imagery tile", format!("cannot be written as JPEG ({e})"), "report this"))?;
    Ok(bytes)
}
