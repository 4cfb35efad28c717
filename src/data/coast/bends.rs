//! Shores of deep tiles bend between their points, see [`crate::model::ragged_shore`].

use crate::data::tile::{EQUATOR_M, Projection, TILE_TEXELS, TileId, texels_across};
use crate::model::ragged_shore::moved_m;
use std::f64::consts::TAU;

/// From this level on shores bend between their points: texels of 153 m at the equator.
const BENT_FROM: u8 = 10;

/// Where a tile's texels lie, for those whose shores bend.
pub(super) struct Bends {
    /// Of each row: cosine and sine of the latitude, and how wide a texel is, metres.
    rows: Vec<[f64; 3]>,
    /// Of each column: cosine and sine of the longitude.
    columns: Vec<[f64; 2]>,
}

impl Bends {
    /// `None` of a tile that is too coarse, or of another map.
    pub(super) fn of(tile: TileId) -> Option<Self> {
        let texel_m = EQUATOR_M / texels_across(tile.z);
        if tile.projection != Projection::Mercator || tile.z < BENT_FROM {
            return None;
        }
        let row = |row: usize| {
            let turn = (0.5 - tile.texel_centre(0.0, row as f64).1) * TAU;
            let cos_lat = 1.0 / libm::cosh(turn);
            [cos_lat, libm::tanh(turn), texel_m * cos_lat]
        };
        let column = |column: usize| {
            let (sin, cos) = libm::sincos((tile.texel_centre(column as f64, 0.0).0 - 0.5) * TAU);
            [cos, sin]
        };
        Some(Self { rows: (0..TILE_TEXELS).map(row).collect(), columns: (0..TILE_TEXELS).map(column).collect() })
    }

    /// A texel's signed distances to both shores, texels, once these are bent.
    pub(super) fn moved(&self, at: usize, signed: [f64; 2]) -> [f64; 2] {
        let ([cos_lat, sin_lat, texel_m], [cos, sin]) = (self.rows[at / TILE_TEXELS], self.columns[at % TILE_TEXELS]);
        let normal = [cos_lat * cos, cos_lat * sin, sin_lat];
        signed.map(|texels| texels + moved_m(normal, texel_m, texels * texel_m) / texel_m)
    }
}
