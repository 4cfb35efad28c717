//! How far the banks of rivers are: lines that are as wide as their kind.
//!
//! ```text
//!   share of a texel     wide rivers: signed distance to the bank, as of lakes
//!   1      ____
//!         /    \         narrow ones: the share of a texel that they cover, filtered by a Gaussian, stands for the distance: half a texel
//!   0 ___/      \___     in where it is all, half a texel out where it is none. So a river that is narrower than the texels neither breaks up
//!                        into beads nor swells to their width (`inland_share` in shaders/lib/shore_pixels.wgsl reads it).
//! ```

use super::field::{MARGIN, REACH};
use super::{River, Stream};
use crate::data::tile::{EQUATOR_M, TILE_TEXELS, TileId, texels_across};
use std::f64::consts::{SQRT_2, TAU};

/// Deviation of the Gaussian, texels: a quadratic B-spline between texels then takes a seventh of the share of a line at most.
const FILTER: f64 = 0.8;
/// Rivers of fewer texels than the first are narrow, of more than the second wide.
const WIDE_TEXELS: [f64; 2] = [1.5, 3.0];
/// From the first of these distances to the middle of a narrow river, texels, to the second the share gives way to the distance itself.
const BEYOND: [f64; 2] = [1.1, 2.25];

/// What the Gaussian has beyond that is added to the rest.
const WHOLE: f64 = 1.15;

/// Looks at texels for a tile's rivers, at most: a hostile tile shall not take seconds, and one of the world's takes a fiftieth.
const MOST_LOOKS: usize = 1 << 27;

type Place = [f64; 2];

/// The rivers of a tile, texel by texel.
pub(super) struct Rivers {
    /// Texels that pieces may still look at.
    left: usize,
    /// Of each kind that there is: squares of distances to the middle, texels.
    squares: [Option<Vec<f64>>; Stream::ALL.len()],
    /// Width of the ground that a texel of each row shows, metres.
    texel_m: Vec<f64>,
}

impl Rivers {
    pub(super) fn new(tile: TileId, rivers: &[River]) -> Self {
        let across = texels_across(tile.z);
        let texel_m = |row: usize| {
            let (_, y) = tile.texel_centre(0.0, row as f64);
            EQUATOR_M / across / libm::cosh((0.5 - y) * TAU)
        };
        let none = |stream: Stream| {
            let is_any = rivers.iter().any(|river| river.stream == stream);
            is_any.then(|| vec![f64::INFINITY; TILE_TEXELS * TILE_TEXELS])
        };
        Self { left: MOST_LOOKS, squares: Stream::ALL.map(none), texel_m: (0..TILE_TEXELS).map(texel_m).collect() }
    }

    /// Lays a piece of a river, in texels of the grid with its margin.
    pub(super) fn add(&mut self, stream: Stream, from: Place, to: Place) {
        let narrowest_m = self.texel_m[0].min(self.texel_m[TILE_TEXELS - 1]);
        let reach = REACH + 1.0 + 0.5 * stream.width_m() / narrowest_m;
        let Some(squares) = &mut self.squares[stream.index()] else { return };
        let from = from.map(|x| x - MARGIN as f64);
        let way = [0, 1].map(|axis| to[axis] - MARGIN as f64 - from[axis]);
        let length = way[0] * way[0] + way[1] * way[1];
        let inverse = if length > 0.0 { 1.0 / length } else { 0.0 };
        let side = TILE_TEXELS as f64;
        let texels = |low: f64, high: f64| (low.clamp(0.0, side) as usize)..(high.ceil().clamp(0.0, side) as usize);
        let (top, bottom) = (from[1].min(from[1] + way[1]), from[1].max(from[1] + way[1]));
        for row in texels(top - reach, bottom + reach) {
            let y = row as f64 + 0.5 - from[1];
            // What of the piece is within reach of the row.
            let part = |y: f64| (y / way[1]).clamp(0.0, 1.0);
            let [a, b] = if way[1].abs() < 1e-9 { [0.0, 1.0] } else { [part(y - reach), part(y + reach)] };
            let (left, right) = (way[0] * a, way[0] * b);
            let columns = texels(from[0] + left.min(right) - reach, from[0] + left.max(right) + reach);
            let Some(looks) = self.left.checked_sub(columns.len()) else { return };
            self.left = looks;
            for column in columns {
                let x = column as f64 + 0.5 - from[0];
                let along = ((x * way[0] + y * way[1]) * inverse).clamp(0.0, 1.0);
                let (x, y) = (x - along * way[0], y - along * way[1]);
                let square = &mut squares[row * TILE_TEXELS + column];
                *square = square.min(x * x + y * y);
            }
        }
    }

    /// Whether there is none.
    pub(super) fn is_empty(&self) -> bool {
        self.squares.iter().all(Option::is_none)
    }

    /// Signed distance to the nearest bank, texels, positive in a river; minus infinity where none is within reach.
    pub(super) fn texels(&self, at: usize) -> f64 {
        let texel_m = self.texel_m[at / TILE_TEXELS];
        let of = |stream: Stream| {
            let square = self.squares[stream.index()].as_ref().map_or(f64::INFINITY, |squares| squares[at]);
            if square == f64::INFINITY { -square } else { signed(square.sqrt(), stream.width_m() / texel_m) }
        };
        Stream::ALL.map(of).into_iter().fold(f64::NEG_INFINITY, f64::max)
    }
}

/// What stands for the distance to the bank of a river, all in texels: at a distance from the middle of one of a width.
fn signed(away: f64, width: f64) -> f64 {
    let between = |[low, high]: [f64; 2], x: f64| ((x - low) / (high - low)).clamp(0.0, 1.0);
    let true_one = 0.5 * width - away;
    let wide = between(WIDE_TEXELS, width);
    let beyond = between(BEYOND, away);
    if wide == 1.0 || beyond == 1.0 {
        return true_one;
    }
    let within = |x: f64| libm::erf(x / (FILTER * SQRT_2));
    let share = 0.5 * WHOLE * (within(away + 0.5 * width) - within(away - 0.5 * width));
    let narrow = share - 0.5;
    narrow + (true_one - narrow) * wide.max(beyond)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_river_covers_as_much_of_wide_texels_as_it_is_wide() {
        for width in [0.05, 0.2, 0.5, 1.0, 1.4] {
            for middle in [0.0, 0.13, 0.25, 0.5] {
                let texels = (-10..=10).map(|i| (signed((f64::from(i) - middle).abs(), width) + 0.5).clamp(0.0, 1.0));
                let covered: f64 = texels.sum();
                // Where texels lie about its middle, the cut ends of the Gaussian hold more or less than is added for them.
                assert!((covered / width - 1.0).abs() < 0.15, "{covered} of {width} at {middle}");
            }
        }
    }

    #[test]
    fn far_from_it_and_where_it_is_wide_the_distance_is_the_banks() {
        for (away, width) in [(0.0, 3.0), (1.7, 3.2), (3.0, 0.1), (2.6, 1.0), (7.0, 12.0)] {
            assert_eq!(signed(away, width), 0.5 * width - away);
        }
        // Neither jumps on the way.
        for width in [0.1, 1.0, 1.6, 2.9, 3.1] {
            let steps = (0..400).map(|i| signed(f64::from(i) * 0.01, width));
            let (mut before, mut falls) = (signed(0.0, width), true);
            for step in steps {
                falls &= step <= before && before - step < 0.03;
                before = step;
            }
            assert!(falls, "{width}");
        }
    }
}
