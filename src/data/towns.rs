//! Where towns stand and how far their houses reach, from the bundled list of them (`scripts/make-towns.sh`; credits: `NOTICE`).

use super::sparse::cells;
use std::f64::consts::{PI, TAU};

/// Columns and rows of cells, each with one town at most, over the whole globe.
const CELLS: [u64; 2] = [65_536, 32_768];
/// Of a radius, m.
const STEP_M: f64 = 125.0;
/// Cell by cell from the north-west, as of [`cells`]: radii in steps.
const LIST: &[u8] = include_bytes!("towns.bin");

/// A town, or a part of one, as a disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Town {
    /// Geodetic latitude of its middle, radians.
    pub lat: f64,
    /// Its longitude, radians.
    pub lon: f64,
    /// How far it is built up, m: by its inhabitants, and how densely these live in its country.
    pub radius_m: f64,
}

/// All of them, from north to south.
pub fn towns() -> impl Iterator<Item = Town> {
    cells(LIST).map(|(cell, steps)| {
        let [x, y] = [cell % CELLS[0], cell / CELLS[0]].map(|i| i as f64 + 0.5);
        let [lat, lon] = [(0.5 - y / CELLS[1] as f64) * PI, (x / CELLS[0] as f64 - 0.5) * TAU];
        Town { lat, lon, radius_m: STEP_M * f64::from(steps) }
    })
}
