//! Shores of deep tiles bend between their points, see [`crate::model::ragged_shore`].

use super::field::{MARGIN, SIDE};
use crate::data::tile::{EQUATOR_M, Projection, TILE_TEXELS, TileId, texels_across};
use crate::model::ragged_shore::moved_m;
use std::f64::consts::TAU;

/// From this level on shores may bend between their points.
const BENT_FROM: u8 = 9;
/// Shores of texels as wide as the first do not bend, those of texels as wide as the second bend all the way, metres: so no level differs from the
/// next coarser one by more than a texel of that.
const BENT_BELOW_M: [f64; 2] = [260.0, 100.0];

/// Where a tile's grid lies on the map, for tiles whose shores bend.
pub(super) struct Bends {
    /// Texels of the level from the map's corner to the grid's.
    corner: [f64; 2],
    /// One over the texels along a side of the map.
    texel: f64,
    /// Width of a texel at the equator, metres.
    equator_m: f64,
    /// How far noise moves the shores, of what it says.
    pub(super) moves: f64,
    /// Octaves that texels of this width cannot hold are left out, metres.
    pub(super) finest_m: f64,
}

/// A latitude.
struct Row {
    cos: f64,
    sin: f64,
}

impl Bends {
    /// `None` of a tile that is too coarse, or of another map.
    pub(super) fn of(tile: TileId) -> Option<Self> {
        if tile.projection != Projection::Mercator || tile.z < BENT_FROM {
            return None;
        }
        let corner = [tile.x, tile.y].map(|tile| f64::from(tile) * TILE_TEXELS as f64 - MARGIN as f64);
        let across = texels_across(tile.z);
        let bends = Self { corner, texel: 1.0 / across, equator_m: EQUATOR_M / across, moves: 1.0, finest_m: 0.0 };
        [0.0, SIDE as f64].into_iter().any(|y| share(bends.texel_m(y)) > 0.0).then_some(bends)
    }

    /// Where a place of a shore, in texels of the grid, is drawn.
    pub(super) fn moved(&self, at: [f64; 2]) -> [f64; 2] {
        let lat = self.row(at[1]);
        let (sin, cos) = libm::sincos(((self.corner[0] + at[0]) * self.texel - 0.5) * TAU);
        let texel_m = self.equator_m * lat.cos;
        let [east_m, north_m] = moved_m([lat.cos, lat.sin], [cos, sin], texel_m.max(self.finest_m));
        let texels = self.moves * share(texel_m) / texel_m;
        [at[0] + east_m * texels, at[1] - north_m * texels]
    }

    /// Width of a texel at an ordinate of the grid, metres.
    pub(super) fn texel_m(&self, y: f64) -> f64 {
        self.equator_m * self.row(y).cos
    }

    fn row(&self, y: f64) -> Row {
        let grown = libm::exp((0.5 - (self.corner[1] + y) * self.texel) * TAU);
        let sum = grown + 1.0 / grown;
        Row { cos: 2.0 / sum, sin: (grown - 1.0 / grown) / sum }
    }
}

/// How far shores of texels of a width bend, of the whole way.
pub(super) fn share(texel_m: f64) -> f64 {
    let [none, all] = BENT_BELOW_M;
    ((none - texel_m) / (none - all)).clamp(0.0, 1.0)
}
