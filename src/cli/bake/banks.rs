//! Which of the bed is a bank by a relief map in hypsometric tints and lies deep in a grid: that bed has lost its bank.
//!
//! Such maps are the paler the shallower the sea is: of `etopo1.jpg` the red alone tells depths of 20 m to 3 km within a factor of two, whatever
//! the shading. ETOPO5 has lost the Great Bahama Bank about the Exumas (485 m deep for 5), Pedro Bank, the brinks of Saya de Malha and of the
//! Swain Reefs, and has slopes of 100 m and more between what it has kept of a bank and what it has not. The map cannot tell 5 m from 50; so what is
//! lost has the depth of what the grid has kept of the pale sea within a degree.

use super::picture::{Picture, display};
use super::tints::{AROUND, Nodes, quantile};
use std::collections::{HashMap, HashSet};

/// The sea no deeper than some 100 m is at least so red, of 1: half of it is no deeper than 51 m, nine tenths than 117;
const PALE: f64 = 0.62;
/// and between so red and so red there is a brink.
const BRINK: [f64; 2] = [0.54, 0.64];
/// A lost bank goes on to its shores: so red counts land for its brink.
const SHORE: f32 = 0.7;
/// How much greener than blue land is, of 1.
const LAND: f64 = 0.02;
/// Next to no corals have built banks farther from the equator, and trenches off pale coasts are narrower than the map tells, degrees.
const FARTHEST_DEG: f64 = 32.0;
/// Pale nodes that are deeper than this have lost a bank, m,
const DROWNED_M: f32 = 150.0;
/// where they are so many times as deep as the shallower quarter of the pale ones around.
const TIMES: f32 = 4.0;
/// So many nodes on each side are the bank around one,
const BANK: usize = 12;
/// of which so many at least have to be pale: narrow shelves before coasts are none.
const LEAST_PALE: usize = 120;
/// Of the 5 x 5 nodes around one, and with it, so many at least have lost a bank.
const LEAST_LOST: usize = 4;
/// A bank that has been lost has been lost as far as the map shows it, up to so many nodes on, where it is deeper than this, m.
const GROWN: usize = 6;
/// See [`GROWN`].
const GROWN_M: f32 = 60.0;
/// Slopes between what is kept and what is lost are deeper than this, m,
const SLOPE_M: f32 = 20.0;
/// so many times as deep as the bank,
const SLOPE_TIMES: f32 = 3.0;
/// and no farther from what is lost, of which there are so many, nodes.
const SLOPE_REACH: usize = 3;
/// Nodes that banks are continued by beyond what is found, under brinks.
const CONTINUED: usize = 3;
/// See [`SLOPE_REACH`].
const SLOPE_LOST: usize = 6;
/// What is lost has the depth than which this share of the kept ones around is shallower,
const SHARE: f64 = 0.35;
/// if there are so many.
const LEAST_KEPT: usize = 6;

/// What a grid has lost of its banks, and where they end by the map: its pixels are finer than nodes are apart, which brinks would show.
pub struct Banks {
    /// Elevation at each node, metres, always below 0: the bed but where a bank has been lost and up to [`CONTINUED`] nodes beyond.
    pub metres: Vec<f32>,
    /// Nodes that have been found.
    pub found: usize,
    map: Pale,
}

impl Banks {
    /// Of a bed, as elevation; the nodes' `metres` are depths, NaN where there is no sea.
    pub fn found_by(nodes: &Nodes, bed: &[f32], map: &Picture) -> Self {
        let map = Pale::of(map);
        let found = lost(nodes, &map);
        let mut metres = bed.to_vec();
        let mut known: HashMap<usize, f32> = found.iter().map(|(at, depth_m)| (*at, -depth_m)).collect();
        for _ in 0..CONTINUED {
            let next: HashSet<_> =
                known.keys().flat_map(|at| nodes.around(*at, 1)).filter(|at| !known.contains_key(at)).collect();
            let value = |at: usize| {
                let around: Vec<_> = nodes.around(at, 1).filter_map(|at| known.get(&at)).collect();
                let mean_m = around.iter().copied().sum::<f32>() / around.len() as f32;
                // What the grid has kept of the bank stays, but for what is left of its slopes.
                let is_of_it = nodes.metres[at].is_finite() && (map.has_shallows(nodes, at) || map.closes(nodes, at));
                let is_kept = is_of_it && -bed[at] < SLOPE_M.max(-SLOPE_TIMES * mean_m);
                (at, if is_kept { bed[at] } else { mean_m })
            };
            let new: Vec<_> = next.into_iter().map(value).collect();
            known.extend(new);
        }
        known.into_iter().for_each(|(at, elevation_m)| metres[at] = elevation_m);
        Self { metres, found: found.len(), map }
    }

    /// Elevation at a place where the grid has the bed and what has been found has a bank, both metres below 0: by how pale the map is there.
    pub fn elevation_m(&self, lat_deg: f64, lon_deg: f64, bed_m: f32, bank_m: f32) -> f32 {
        let share = ((self.map.smooth(&self.map.closed, lat_deg, lon_deg) - BRINK[0]) / (BRINK[1] - BRINK[0]))
            .clamp(0.0, 1.0) as f32;
        let share = share * share * (3.0 - 2.0 * share);
        // Depths of a brink are known by their order.
        -((-bed_m).ln() * (1.0 - share) + (-bank_m).ln() * share).exp()
    }
}

/// Nodes that have lost a bank, and its depths.
fn lost(nodes: &Nodes, map: &Pale) -> Vec<(usize, f32)> {
    let depth_m = nodes.metres;
    let all = || 0..depth_m.len();
    let is_pale: Vec<_> = all().map(|at| depth_m[at].is_finite() && map.has_shallows(nodes, at)).collect();
    let bank = |at: usize| {
        let may_be = depth_m[at].is_finite() && (is_pale[at] || map.closes(nodes, at));
        if may_be { around_m(nodes, at, &is_pale, LEAST_PALE, 0.25) } else { None }
    };
    let bank: Vec<_> = all().map(bank).collect();
    let is_below =
        |at: usize, least_m: f32, times: f32| bank[at].is_some_and(|bank_m| depth_m[at] > least_m.max(times * bank_m));
    let is_deep = |at: usize| is_pale[at] && is_below(at, DROWNED_M, TIMES);
    let is_drowned =
        |at: usize| is_deep(at) && nodes.around(at, AROUND).filter(|at| is_deep(*at)).count() >= LEAST_LOST;
    let mut is_drowned: Vec<_> = all().map(is_drowned).collect();
    for _ in 0..GROWN {
        let grows = |at: usize| is_below(at, GROWN_M, SLOPE_TIMES) && nodes.around(at, 1).any(|at| is_drowned[at]);
        is_drowned = all().map(|at| is_drowned[at] || grows(at)).collect();
    }
    let is_slope = |at: usize| {
        is_below(at, SLOPE_M, SLOPE_TIMES)
            && nodes.around(at, SLOPE_REACH).filter(|at| is_drowned[*at]).count() >= SLOPE_LOST
    };
    let is_lost: Vec<_> = all().map(|at| is_drowned[at] || is_slope(at)).collect();
    let is_kept: Vec<_> = all().map(|at| is_pale[at] && !is_lost[at]).collect();
    let found = |at: usize| {
        let kept_m = around_m(nodes, at, &is_kept, LEAST_KEPT, SHARE).or(bank[at])?;
        Some((at, kept_m.min(depth_m[at])))
    };
    all().filter(|at| is_lost[*at]).filter_map(found).collect()
}

/// The depth than which a share of the nodes around one is shallower, of those that count, if there are enough.
fn around_m(nodes: &Nodes, at: usize, counts: &[bool], least: usize, share: f64) -> Option<f32> {
    let depths: Vec<_> = nodes.around(at, BANK).filter(|at| counts[*at]).map(|at| nodes.metres[at]).collect();
    (depths.len() >= least).then(|| quantile(depths, share))
}

/// How red a map's sea is, 0 to 1 as a screen shows it.
struct Pale {
    /// 0 on land.
    red: Vec<f32>,
    /// Land is a shore, and the shadows that brinks throw on a bank are filled: gaps of two pixels.
    closed: Vec<f32>,
    width: usize,
    height: usize,
    step_deg: f64,
}

impl Pale {
    fn of(map: &Picture) -> Self {
        let (width, height) = (map.width, map.height);
        let red = |pixel: &[f32; 3], land: f32| {
            let [red, green, blue] = pixel.map(display);
            if green > blue + LAND { land } else { red as f32 }
        };
        let of_next = |field: &[f32], of: fn([f32; 9]) -> f32| -> Vec<f32> {
            let next = |at: usize| {
                let (row, column) = (at / width, at % width);
                of(std::array::from_fn(|i| {
                    let row = (row + i / 3).saturating_sub(1).min(height - 1);
                    field[row * width + (column + width + i % 3 - 1) % width]
                }))
            };
            (0..field.len()).map(next).collect()
        };
        let greatest = |nine: [f32; 9]| nine.into_iter().fold(0.0, f32::max);
        let least = |nine: [f32; 9]| nine.into_iter().fold(1.0, f32::min);
        // Closing leaves brinks along pixels.
        let smooth = |nine: [f32; 9]| {
            nine.into_iter()
                .zip([1.0, 2.0, 1.0, 2.0, 4.0, 2.0, 1.0, 2.0, 1.0])
                .map(|(red, weight)| weight / 16.0 * red)
                .sum()
        };
        let shored: Vec<f32> = map.pixels.iter().map(|pixel| red(pixel, SHORE)).collect();
        Self {
            red: map.pixels.iter().map(|pixel| red(pixel, 0.0)).collect(),
            closed: of_next(&of_next(&of_next(&shored, greatest), least), smooth),
            width,
            height,
            step_deg: map.step_deg(),
        }
    }

    fn has_shallows(&self, nodes: &Nodes, at: usize) -> bool {
        self.at_node(&self.red, nodes, at) >= PALE
    }

    /// Whether a node may be of a bank that is beside it.
    fn closes(&self, nodes: &Nodes, at: usize) -> bool {
        self.at_node(&self.closed, nodes, at) >= PALE
    }

    fn at_node(&self, field: &[f32], nodes: &Nodes, at: usize) -> f64 {
        let (lat_deg, lon_deg) = (nodes.lat_deg(at / nodes.width), nodes.lon_deg(at % nodes.width));
        if lat_deg.abs() < FARTHEST_DEG { self.smooth(field, lat_deg, lon_deg) } else { 0.0 }
    }

    /// Of 3 x 3 pixels, by quadratic B-splines: smooth, and compression has its noise.
    fn smooth(&self, field: &[f32], lat_deg: f64, lon_deg: f64) -> f64 {
        let (y, x) = ((90.0 - lat_deg) / self.step_deg - 0.5, (lon_deg + 180.0) / self.step_deg - 0.5);
        let (row, column) = (y.round(), x.round());
        let spline = |t: f64| [0.5 * (0.5 - t).powi(2), 0.75 - t * t, 0.5 * (0.5 + t).powi(2)];
        let (down, along) = (spline(y - row), spline(x - column));
        let mut sum = 0.0;
        for (j, down) in down.into_iter().enumerate() {
            let row = (row as i64 + j as i64 - 1).clamp(0, self.height as i64 - 1) as usize;
            for (i, along) in along.into_iter().enumerate() {
                let column = (column as i64 + i as i64 - 1).rem_euclid(self.width as i64) as usize;
                sum += down * along * f64::from(field[row * self.width + column]);
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The Atlantic, 3,000 m deep, with a bank that is 10 m deep in the west, lost in the east with a slope between; a shelf farther north of 60 m
    /// in the west and 200 in the east, as pale as a shelf is; and a bank that the map alone has, of which nothing is kept.
    #[test]
    fn a_lost_bank_is_as_deep_as_what_is_kept_of_it_and_a_shelf_is_kept() {
        let (width, height) = (360, 181);
        let (bank, shelf, unknown) = (60..70, 85..95, 105..117);
        let is_pale = |row: usize, column: usize| {
            bank.contains(&row) && (40..68).contains(&column)
                || (shelf.contains(&row) || unknown.contains(&row)) && (40..80).contains(&column)
        };
        let depth_m = |row: usize, column: usize| match column {
            _ if unknown.contains(&row) || !is_pale(row, column) => 3_000.0,
            40..60 if bank.contains(&row) => 10.0,
            60..62 if bank.contains(&row) => 100.0,
            _ if bank.contains(&row) => 500.0,
            40..60 => 60.0,
            _ => 200.0,
        };
        let metres: Vec<f32> = (0..width * height).map(|at| depth_m(at / width, at % width)).collect();
        // The map's rows run from the north, its pixels lie about the nodes.
        let pixel = |at: usize| {
            let (row, column) = (at / (2 * width), at % (2 * width));
            let (lat_deg, lon_deg) = (90.0 - (row as f64 + 0.5) / 2.0, (column as f64 + 0.5) / 2.0);
            if is_pale((lat_deg + 90.0).round() as usize, lon_deg.round() as usize % width) {
                [0.40, 0.68, 0.88]
            } else {
                [0.02, 0.2, 0.7]
            }
        };
        let map = Picture { pixels: (0..2 * width * width).map(pixel).collect(), width: 2 * width, height: width };
        let nodes = Nodes { metres: &metres, width, west_deg: -180.0, step_deg: 1.0 };
        let found = lost(&nodes, &Pale::of(&map));
        let is_lost = |at: &usize| bank.contains(&(at / width)) && (60..68).contains(&(at % width));
        assert_eq!(
            found.iter().map(|(at, _)| *at).collect::<Vec<_>>(),
            (0..metres.len()).filter(is_lost).collect::<Vec<_>>()
        );
        assert!(found.iter().all(|(_, depth_m)| *depth_m == 10.0));
        // The brink lies between two rows of nodes, where the map has it.
        let bed: Vec<f32> = metres.iter().map(|depth_m| -depth_m).collect();
        let banks = Banks::found_by(&nodes, &bed, &map);
        assert_eq!(banks.found, found.len());
        let depth_m = |lat_deg: f64| {
            -banks.elevation_m(lat_deg, -116.0, -3_000.0, banks.metres[(lat_deg + 90.0).round() as usize * width + 64])
        };
        assert!(
            (depth_m(-21.6) - 10.0).abs() < 0.1 && (depth_m(-19.6) - 3_000.0).abs() < 1.0,
            "{}, {}",
            depth_m(-21.6),
            depth_m(-19.6)
        );
        assert!((20.0..2_000.0).contains(&depth_m(-20.9)), "{}", depth_m(-20.9));
    }
}
