//! One water tile: classes and signed distances from the mask, and how well it draws its coast.

use super::distance::{NOWHERE, nearest_shore, squared};
use super::grid::{CELLS_PER_TEXEL, Grid, MARGIN, SIDE};
use super::mask::{MIXED, Raster};
use crate::data::tile::{EQUATOR_M, Projection, TILE_TEXELS, TileId, lat_lon_from_map, texel_size_m};
use crate::data::water::{self, SHORE, WaterClass, byte_from_distance};
use crate::error::Result;

/// A wrong shore of a lake counts this much of one of the ocean: the sea is what is looked at from near.
const LAKE_WEIGHT: f64 = 0.25;

/// A water tile, ready to be stored.
pub struct WaterTile {
    /// The PNG.
    pub bytes: Vec<u8>,
    /// For each quarter of the tile (in the order of [`TileId::children`]) the ground, km², that its own distances put
    /// on the wrong side of a shore; at lakes a quarter of it.
    pub wrong_km2: [f64; 4],
}

/// Makes a water tile from the mask.
pub fn water_tile(tile: TileId, raster: &Raster) -> Result<WaterTile> {
    let grid = Grid::new(tile);
    let classes = classes(tile, &grid, raster);
    let mut texels = vec![[0u8; 3]; TILE_TEXELS * TILE_TEXELS];
    let mut wrong_km2 = [0.0; 4];
    for (channel, (wet, weight)) in [(WaterClass::Ocean, 1.0), (WaterClass::Lake, LAKE_WEIGHT)].into_iter().enumerate()
    {
        let inside: Vec<bool> = classes.iter().map(|class| *class == wet as u8).collect();
        let (nearest, shores) = nearest_shore(&inside, SIDE, (MARGIN - 1) * CELLS_PER_TEXEL);
        for (index, texel) in texels.iter_mut().enumerate() {
            let cell = |i: usize| (i + MARGIN) * CELLS_PER_TEXEL + CELLS_PER_TEXEL / 2;
            let (column, row) = (cell(index % TILE_TEXELS), cell(index / TILE_TEXELS));
            let at = row * SIDE + column;
            let distance = match nearest[at] {
                NOWHERE => f64::INFINITY,
                (x, y) => {
                    let metres = ground_m(grid.normal(2 * column, 2 * row), grid.normal(x as usize, y as usize));
                    metres / texel_m(tile, index % TILE_TEXELS, index / TILE_TEXELS)
                }
            };
            texel[channel] = byte_from_distance(coarser_far_away(distance), inside[at]);
        }
        if shores > 0 {
            let wrong = wrong_area(tile, &texels, channel, &inside, &nearest);
            wrong_km2.iter_mut().zip(wrong).for_each(|(sum, wrong)| *sum += weight * wrong);
        }
    }
    for (index, texel) in texels.iter_mut().enumerate() {
        let cell = |i: usize| (i + MARGIN) * CELLS_PER_TEXEL + CELLS_PER_TEXEL / 2;
        texel[2] = classes[cell(index / TILE_TEXELS) * SIDE + cell(index % TILE_TEXELS)];
    }
    Ok(WaterTile { bytes: water::encode(&texels)?, wrong_km2 })
}

fn classes(tile: TileId, grid: &Grid, raster: &Raster) -> Vec<u8> {
    let mut classes = Vec::with_capacity(SIDE * SIDE);
    if tile.projection == Projection::Mercator {
        let columns: Vec<_> = (0..SIDE).map(|column| raster.column(grid.lat_lon_deg(column, 0).1)).collect();
        for row in 0..SIDE {
            let from = raster.row(grid.lat_lon_deg(0, row).0) * raster.width;
            classes.extend(columns.iter().map(|column| raster.cells[from + column] & !MIXED));
        }
    } else {
        for at in 0..SIDE * SIDE {
            let (lat_deg, lon_deg) = grid.lat_lon_deg(at % SIDE, at / SIDE);
            classes.push(raster.class(lat_deg, lon_deg));
        }
    }
    classes
}

/// Ground metres per texel at a texel's centre.
fn texel_m(tile: TileId, column: usize, row: usize) -> f64 {
    let (x, y) = tile.texel_centre(column as f64, row as f64);
    texel_size_m(tile.projection, tile.z, lat_lon_from_map(tile.projection, x, y).0)
}

/// Metres along the ground between two places, from their geodetic normals, on the sphere of the equatorial radius that
/// [`texel_size_m`] also uses.
fn ground_m(a: [f64; 3], b: [f64; 3]) -> f64 {
    let chord = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
    EQUATOR_M / std::f64::consts::PI * (chord / 2.0).min(1.0).asin()
}

/// Far from the shore a distance is stored in larger steps: there it shapes the sea bed but draws no line, and the
/// archive shrinks.
fn coarser_far_away(texels: f64) -> f64 {
    let step = match texels {
        near if near < 2.0 => return near,
        middle if middle < 4.0 => 2.0 / 16.0,
        _ => 4.0 / 16.0,
    };
    (texels / step).round() * step
}

/// For each quarter of the tile, the area in km² of the cells whose side of the shore the interpolated bytes get wrong.
/// Cells on the shore itself do not count: the mask is no finer than they are.
fn wrong_area(tile: TileId, texels: &[[u8; 3]], channel: usize, inside: &[bool], nearest: &[(i16, i16)]) -> [f64; 4] {
    let mut wrong = [0.0; 4];
    for row in 1..TILE_TEXELS - 1 {
        let cell_km = texel_m(tile, TILE_TEXELS / 2, row) / CELLS_PER_TEXEL as f64 / 1000.0;
        for column in 1..TILE_TEXELS - 1 {
            let byte = |dx: usize, dy: usize| {
                f64::from(texels[(row + dy - 1) * TILE_TEXELS + column + dx - 1][channel]) - f64::from(SHORE)
            };
            // Farther than this from any shore, no cell of the texel can be on the wrong side.
            if byte(1, 1).abs() > 24.0 {
                continue;
            }
            let quarter = usize::from(row >= TILE_TEXELS / 2) * 2 + usize::from(column >= TILE_TEXELS / 2);
            for (j, i) in [(0, 0), (0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1), (2, 2)] {
                let at = ((row + MARGIN) * CELLS_PER_TEXEL + j) * SIDE + (column + MARGIN) * CELLS_PER_TEXEL + i;
                if nearest[at] != NOWHERE && squared(at % SIDE, at / SIDE, nearest[at]) <= 1 {
                    continue;
                }
                // The neighbour on the cell's side, at a third of the way.
                let (dx, dy) = (if i == 0 { 0 } else { 2 }, if j == 0 { 0 } else { 2 });
                let (fx, fy) = (if i == 1 { 0.0 } else { 1.0 / 3.0 }, if j == 1 { 0.0 } else { 1.0 / 3.0 });
                let along = |dy| byte(1, dy) * (1.0 - fx) + byte(dx, dy) * fx;
                let drawn = along(1) * (1.0 - fy) + along(dy) * fy;
                if (drawn > 0.0) != inside[at] {
                    wrong[quarter] += cell_km * cell_km;
                }
            }
        }
    }
    wrong
}
