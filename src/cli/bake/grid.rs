//! The cells that a water tile is made from: three by three per texel, with a margin, each at its true place on earth.

use crate::data::tile::{Projection, TILE_TEXELS, TileId, lat_lon_from_map, texels_across};

/// Cells along one side of a texel; odd, so that the middle one has the texel's centre.
pub const CELLS_PER_TEXEL: usize = 3;
/// Texels around the tile that are looked at too: the reach of a stored distance, and some more because scale varies.
pub const MARGIN: usize = 10;
/// Cells along one side of the whole grid.
pub const SIDE: usize = (TILE_TEXELS + 2 * MARGIN) * CELLS_PER_TEXEL;

/// The cells of one tile. Positions are counted in half cells from the centre of cell (0, 0).
pub struct Grid {
    tile: TileId,
    /// On Mercator, for each half row (sine, cosine, degrees) of latitude, for each half column those of longitude.
    latitudes: Vec<(f64, f64, f64)>,
    longitudes: Vec<(f64, f64, f64)>,
}

fn angle(radians: f64) -> (f64, f64, f64) {
    (radians.sin(), radians.cos(), radians.to_degrees())
}

impl Grid {
    /// The grid around a tile.
    pub fn new(tile: TileId) -> Self {
        let mut grid = Self { tile, latitudes: Vec::new(), longitudes: Vec::new() };
        if tile.projection == Projection::Mercator {
            let place = |half| grid.map(half, half);
            let at = (0..2 * SIDE).map(|half| (place(half as f64).0, place(half as f64).1));
            let lat_lon: Vec<_> = at.map(|(x, y)| lat_lon_from_map(Projection::Mercator, x, y)).collect();
            grid.latitudes = lat_lon.iter().map(|(lat, _)| angle(*lat)).collect();
            grid.longitudes = lat_lon.iter().map(|(_, lon)| angle(*lon)).collect();
        }
        grid
    }

    /// Place on the unit map.
    fn map(&self, half_column: f64, half_row: f64) -> (f64, f64) {
        let cells = (TILE_TEXELS * CELLS_PER_TEXEL) as f64;
        let side = texels_across(self.tile.z) * CELLS_PER_TEXEL as f64;
        let margin = (MARGIN * CELLS_PER_TEXEL) as f64;
        let along = |tile: u32, half: f64| (f64::from(tile) * cells - margin + 0.5 + half / 2.0) / side;
        (along(self.tile.x, half_column), along(self.tile.y, half_row))
    }

    /// (latitude, longitude) in degrees of a cell.
    pub fn lat_lon_deg(&self, column: usize, row: usize) -> (f64, f64) {
        match self.tile.projection {
            Projection::Mercator => (self.latitudes[2 * row].2, self.longitudes[2 * column].2),
            polar => {
                let (x, y) = self.map(2.0 * column as f64, 2.0 * row as f64);
                let (lat, lon) = lat_lon_from_map(polar, x, y);
                (lat.to_degrees(), lon.to_degrees())
            }
        }
    }

    /// The geodetic normal of a place, a unit vector.
    pub fn normal(&self, half_column: usize, half_row: usize) -> [f64; 3] {
        let ((sin_lat, cos_lat, _), (sin_lon, cos_lon, _)) = match self.tile.projection {
            Projection::Mercator => (self.latitudes[half_row], self.longitudes[half_column]),
            polar => {
                let (x, y) = self.map(half_column as f64, half_row as f64);
                let (lat, lon) = lat_lon_from_map(polar, x, y);
                (angle(lat), angle(lon))
            }
        };
        [cos_lat * cos_lon, cos_lat * sin_lon, sin_lat]
    }
}
