//! The water pyramids: which tiles are needed, level by level, and making them.

use super::mask::{MIXED, Mask, Raster};
use super::water_tile::water_tile;
use crate::data::pmtiles::write::ArchiveWriter;
use crate::data::tile::{
    MERCATOR_LATITUDE_LIMIT, Projection, TILE_TEXELS, TileId, lat_lon_from_map, map_from_lat_lon, texels_across,
};
use crate::error::Result;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// A tile is needed where a shore lies in it or within this many of its texels.
const NEAR_TEXELS: f64 = 9.0;

/// How deep, and where.
pub struct Detail {
    /// The deepest level of the Mercator archive.
    pub max_zoom: u8,
    /// The deepest level of the polar archives.
    pub polar_zoom: u8,
    /// From this level on, a quarter of a tile gets a deeper tile only if it draws at least `worth_km2` wrongly.
    pub sparse_zoom: u8,
    /// See `sparse_zoom`; the ground that a deeper tile must put right, km², one value for each level from
    /// `sparse_zoom` on; the last one serves all further levels.
    pub worth_km2: Vec<f64>,
}

/// Makes one water archive's tiles.
pub fn add_tiles(
    writer: &mut ArchiveWriter,
    projection: Projection,
    mask: &mut Mask,
    reduced: &Raster,
    detail: &Detail,
    mut progress: impl FnMut(u8, usize, usize),
) -> Result<()> {
    let deepest = if projection == Projection::Mercator { detail.max_zoom } else { detail.polar_zoom };
    let near_shore = match projection {
        Projection::Mercator => tiles_near_shores(reduced, deepest),
        polar => every_tile(polar, deepest),
    };
    let mut level = BTreeSet::from([TileId::root(projection)]);
    for z in 0..=deepest {
        let mut next = BTreeSet::new();
        let mut done = 0;
        for row in by_row(&level) {
            let window = window(row[0], mask, reduced)?;
            let raster = window.as_ref().unwrap_or(reduced);
            let made: Vec<_> = row.par_iter().map(|tile| water_tile(*tile, raster)).collect();
            for (tile, made) in row.iter().zip(made) {
                let made = made?;
                writer.add(tile.z, tile.x, tile.y, &made.bytes)?;
                for (child, wrong_km2) in tile.children().into_iter().flatten().zip(made.wrong_km2) {
                    let wanted = near_shore.get(usize::from(z) + 1).is_some_and(|near| near.contains(&child));
                    let worth = z.checked_sub(detail.sparse_zoom).map_or(0.0, |from| {
                        let last = detail.worth_km2.len().saturating_sub(1);
                        detail.worth_km2.get(last.min(usize::from(from))).copied().unwrap_or(0.0)
                    });
                    if wanted && wrong_km2 >= worth {
                        next.insert(child);
                    }
                }
            }
            done += row.len();
            progress(z, done, level.len());
        }
        level = next;
    }
    Ok(())
}

/// Rows of tiles: a row shares a window of the mask.
fn by_row(tiles: &BTreeSet<TileId>) -> Vec<Vec<TileId>> {
    let mut sorted: Vec<_> = tiles.iter().copied().collect();
    sorted.sort_by_key(|tile| (tile.y, tile.x));
    sorted.chunk_by(|a, b| a.y == b.y).map(<[TileId]>::to_vec).collect()
}

/// The part of the mask that a row of tiles needs, or `None` where the reduced mask is fine enough.
fn window(tile: TileId, mask: &mut Mask, reduced: &Raster) -> Result<Option<Raster>> {
    let cell_deg = 360.0 / texels_across(tile.z) / super::grid::CELLS_PER_TEXEL as f64;
    if tile.projection != Projection::Mercator || cell_deg > 0.75 * reduced.step_deg() {
        return Ok(None);
    }
    let margin = super::grid::MARGIN as f64;
    let latitude_deg = |row: f64| {
        let (x, y) = tile.texel_centre(0.0, row);
        lat_lon_from_map(tile.projection, x, y).0.to_degrees()
    };
    mask.window(latitude_deg(TILE_TEXELS as f64 + margin), latitude_deg(-margin - 1.0)).map(Some)
}

fn every_tile(projection: Projection, deepest: u8) -> Vec<BTreeSet<TileId>> {
    let mut levels = vec![BTreeSet::from([TileId::root(projection)])];
    for _ in 0..deepest {
        let next = levels.last().into_iter().flatten().flat_map(|tile| tile.children().into_iter().flatten()).collect();
        levels.push(next);
    }
    levels
}

/// For each level the Mercator tiles that have a shore in or near them, and all tiles above those.
fn tiles_near_shores(reduced: &Raster, deepest: u8) -> Vec<BTreeSet<TileId>> {
    let tiles = 2f64.powi(i32::from(deepest));
    let count = 1i64 << deepest;
    let reach = NEAR_TEXELS / TILE_TEXELS as f64;
    let wide = reduced.step_deg() / 360.0 * tiles;
    let width = reduced.width;
    let mut near = BTreeSet::new();
    for row in 0..reduced.cells.len() / width {
        let (lat_deg, _) = reduced.centre_deg(row, 0);
        if lat_deg.to_radians().abs() > MERCATOR_LATITUDE_LIMIT {
            continue;
        }
        let cells = &reduced.cells[row * width..][..width];
        let above = reduced.cells.get((row + 1) * width..(row + 2) * width).unwrap_or(cells);
        let mut last = None;
        for column in 0..width {
            let cell = cells[column];
            if cell & MIXED == 0 && cell == cells[(column + 1) % width] & !MIXED && cell == above[column] & !MIXED {
                continue;
            }
            let (lat_deg, lon_deg) = reduced.centre_deg(row, column);
            let (x, y) = map_from_lat_lon(Projection::Mercator, lat_deg.to_radians(), lon_deg.to_radians());
            // The shore lies in the cell or at its edge.
            let (reach_x, reach_y) = (reach + wide, reach + wide / lat_deg.to_radians().cos());
            let range = |at: f64, reach: f64| ((at - reach).floor() as i64, (at + reach).floor() as i64);
            let reached = (range(x * tiles, reach_x), range(y * tiles, reach_y));
            if last != Some(reached) {
                last = Some(reached);
                let ((west, east), (north, south)) = reached;
                for row in north.max(0)..=south.min(count - 1) {
                    near.extend((west..=east).filter_map(|column| {
                        TileId::new(Projection::Mercator, deepest, column.rem_euclid(count) as u32, row as u32)
                    }));
                }
            }
        }
    }
    (0..=deepest).map(|z| near.iter().filter_map(|tile| tile.ancestor(z)).collect()).collect()
}
