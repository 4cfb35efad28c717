//! How high land is by the colours of a relief map: where a grid has lost heights, they are better than nothing.
//!
//! What height a colour stands for is learnt from the grid itself: the median of all places of that colour (of its chromaticity, for shading and
//! compression change how bright it is). ETOPO5 has lost the heights of some coasts, in blocks of a degree or two, where it has 5 to 40 m: the
//! Riviera, Crete, Cyprus, Jamaica, the coasts of Antalya, Malaga, Biscay. There, and nowhere else, the colours tell.

use super::picture::{Picture, display};

/// Bins of a chromaticity, a side, and what part of red or green they cover.
const BINS: usize = 64;
/// See [`BINS`].
const RANGE: [f64; 2] = [0.2, 0.6];
/// Places that have to have a colour for a height of it.
const LEAST_PLACES: usize = 50;
/// Farther from the equator ice hides the colours, degrees.
const FARTHEST_DEG: f64 = 66.0;
/// A place may have lost its height where it has less than this but no depression, m,
const LOST_M: std::ops::Range<f32> = 0.0..45.0;
/// and its colour so much more.
const LACKS_M: f32 = 150.0;
/// It has where this part of the land around, of 5 x 5 nodes, may have as well: a valley among mountains, whose colours mix, has not,
const LOST_AROUND: f64 = 0.4;
/// and no fewer than so many.
const LEAST_AROUND: usize = 5;
/// So many nodes on each side are those around one.
pub const AROUND: usize = 2;
/// Colours that are this far off half of the heights that are known tell none, m.
const MOST_OFF_M: f32 = 300.0;

/// Nodes of a grid from the south pole on: heights of land or depths of the sea, metres; NaN elsewhere.
pub struct Nodes<'a> {
    /// Row by row.
    pub metres: &'a [f32],
    /// Of a row.
    pub width: usize,
    /// Of the first of a row, degrees.
    pub west_deg: f64,
    /// From one to the next, degrees.
    pub step_deg: f64,
}

impl Nodes<'_> {
    fn height(&self) -> usize {
        self.metres.len() / self.width
    }

    /// Latitude of a row, degrees.
    pub fn lat_deg(&self, row: usize) -> f64 {
        row as f64 * self.step_deg - 90.0
    }

    /// Longitude of a column, degrees.
    pub fn lon_deg(&self, column: usize) -> f64 {
        self.west_deg + column as f64 * self.step_deg
    }

    /// The nearest node's.
    fn nearest(&self, lat_deg: f64, lon_deg: f64) -> f32 {
        let row = ((lat_deg + 90.0) / self.step_deg).round() as usize;
        let column = ((lon_deg - self.west_deg) / self.step_deg).round().rem_euclid(self.width as f64) as usize;
        self.metres[row.min(self.height() - 1) * self.width + column % self.width]
    }

    /// Those around one, so many on each side, and itself.
    pub fn around(&self, at: usize, reach: usize) -> impl Iterator<Item = usize> + use<> {
        let (width, height) = (self.width, self.height());
        let (row, column) = (at / width, at % width);
        let rows = row.saturating_sub(reach)..=(row + reach).min(height - 1);
        rows.flat_map(move |row| (0..=2 * reach).map(move |i| row * width + (column + width + i - reach) % width))
    }

    /// Nodes that have lost their heights, and these by the colours of a map.
    ///
    /// # Errors
    /// Why the map is none in hypsometric tints: its colours do not tell the heights that are known.
    pub fn found_by(&self, map: &Picture) -> Result<Vec<(usize, f32)>, String> {
        let colours = Colours::of(map, self);
        let told: Vec<f32> = (0..self.metres.len())
            .map(|at| {
                let lat_deg = self.lat_deg(at / self.width);
                let is_land = self.metres[at].is_finite() && lat_deg.abs() < FARTHEST_DEG;
                let lon_deg = self.lon_deg(at % self.width);
                if is_land { colours.height_m(map, lat_deg, lon_deg) } else { f32::NAN }
            })
            .collect();
        let off = |at: usize| (told[at] - self.metres[at]).abs();
        let off: Vec<f32> = (0..told.len()).map(off).filter(|metres| metres.is_finite()).collect();
        let off = if off.is_empty() { f32::INFINITY } else { median(off) };
        if off > MOST_OFF_M {
            return Err(format!("has colours that tell no heights: half of the land's are {off:.0} m off and more"));
        }
        let may_be = |at: usize| LOST_M.contains(&self.metres[at]) && told[at] - self.metres[at] > LACKS_M;
        let is_lost = |at: &usize| {
            let around = || self.around(*at, AROUND).filter(|at| self.metres[*at].is_finite());
            let lost = around().filter(|at| may_be(*at)).count();
            may_be(*at) && lost >= LEAST_AROUND && lost as f64 >= LOST_AROUND * around().count() as f64
        };
        Ok((0..told.len()).filter(is_lost).map(|at| (at, told[at])).collect())
    }
}

/// Heights by chromaticity, metres; NaN where none is known.
struct Colours(Vec<f32>);

impl Colours {
    fn of(map: &Picture, nodes: &Nodes) -> Self {
        let mut heights = vec![Vec::new(); BINS * BINS];
        for row in 0..map.height {
            let lat_deg = 90.0 - (row as f64 + 0.5) * map.step_deg();
            if lat_deg.abs() >= FARTHEST_DEG {
                continue;
            }
            for column in 0..map.width {
                let metres = nodes.nearest(lat_deg, (column as f64 + 0.5) * map.step_deg() - 180.0);
                if metres > 0.0 {
                    heights[bin(map, row, column)].push(metres);
                }
            }
        }
        Self(heights.into_iter().map(|all| if all.len() < LEAST_PLACES { f32::NAN } else { median(all) }).collect())
    }

    /// Bilinear between the map's pixels, of those whose colour stands for a height.
    fn height_m(&self, map: &Picture, lat_deg: f64, lon_deg: f64) -> f32 {
        let (y, x) = ((90.0 - lat_deg) / map.step_deg() - 0.5, (lon_deg + 180.0) / map.step_deg() - 0.5);
        let (mut sum, mut whole) = (0.0, 0.0);
        for (row, column) in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)] {
            let (row, column) = (y.floor() + row, x.floor() + column);
            let weight = (1.0 - (y - row).abs()) * (1.0 - (x - column).abs());
            let at = (row.clamp(0.0, map.height as f64 - 1.0), column.rem_euclid(map.width as f64));
            let metres = self.0[bin(map, at.0 as usize, at.1 as usize)];
            if metres.is_finite() {
                sum += weight as f32 * metres;
                whole += weight as f32;
            }
        }
        if whole > 0.6 { sum / whole } else { f32::NAN }
    }
}

/// That of the mean of 3 x 3 pixels: compression mixes colours over as many.
fn bin(map: &Picture, row: usize, column: usize) -> usize {
    let mut sum = [0.0; 3];
    for row in row.saturating_sub(1)..=(row + 1).min(map.height - 1) {
        for i in 0..3 {
            let pixel = map.pixels[row * map.width + (column + map.width + i - 1) % map.width];
            sum.iter_mut().zip(pixel).for_each(|(sum, light)| *sum += display(light));
        }
    }
    let whole: f64 = sum.iter().sum::<f64>() + 0.03;
    let [red, green] = [sum[0], sum[1]].map(|part| {
        let share = (part / whole - RANGE[0]) / (RANGE[1] - RANGE[0]);
        (share * BINS as f64).clamp(0.0, BINS as f64 - 1.0) as usize
    });
    red * BINS + green
}

/// Of at least one value.
fn median(values: Vec<f32>) -> f32 {
    quantile(values, 0.5)
}

/// The value than which such a share, below 1, of at least one are lower.
pub fn quantile(mut values: Vec<f32>, share: f64) -> f32 {
    let at = (values.len() as f64 * share) as usize;
    *values.select_nth_unstable_by(at, f32::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ramp of heights from west to east in each band of latitude, mapped in tints; a block of it is lost. A low plain is none, nor is a basin below
    /// the sea's level whose colour is that of mountains.
    #[test]
    fn what_is_lost_is_told_by_colours_and_plains_stay_plains() {
        let (width, height) = (360, 181);
        let height_m = |column: usize| if column < 100 { 10.0 } else { 10.0 * (column - 99) as f32 };
        let mut metres: Vec<f32> = (0..width * height).map(|at| height_m(at % width)).collect();
        let lost = |row: usize, column: usize| (90..96).contains(&row) && (150..160).contains(&column);
        for row in 0..height {
            for column in 0..width {
                if lost(row, column) {
                    metres[row * width + column] = 12.0;
                }
                if (120..124).contains(&row) && (200..204).contains(&column) {
                    metres[row * width + column] = -300.0;
                }
                // The sea.
                if column == 350 {
                    metres[row * width + column] = f32::NAN;
                }
            }
        }
        let tint = |column: usize| {
            let share = height_m(column) / 2_600.0;
            [0.25 + 0.6 * share, 0.6 - 0.4 * share, 0.15]
        };
        let map = Picture { pixels: (0..width * 180).map(|at| tint(at % width)).collect(), width, height: 180 };
        // A pixel's middle lies half a degree east of its node.
        let nodes = Nodes { metres: &metres, width, west_deg: -179.5, step_deg: 1.0 };
        let found = nodes.found_by(&map).unwrap();
        assert!(found.len() >= 40, "{}", found.len());
        for (at, told) in &found {
            let (row, column) = (at / width, at % width);
            assert!(lost(row, column), "{row}, {column} was not lost");
            // A bin of red is a twelfth of the ramp's range.
            assert!((told - height_m(column)).abs() < 120.0, "{told} m for {}", height_m(column));
        }
        // A picture of one colour has the median everywhere, 650 m off half of the ramp.
        let grey = Picture { pixels: vec![[0.3; 3]; width * 180], width, height: 180 };
        assert!(nodes.found_by(&grey).unwrap_err().contains("tell no heights"));
    }
}
