//! Where towns stand and how far their houses reach, from the bundled list of them (`scripts/make-towns.sh`; credits: `NOTICE`).

use std::f64::consts::{PI, TAU};

/// Columns and rows of cells, each with one town at most, over the whole globe.
const CELLS: [u64; 2] = [65_536, 32_768];
/// Of a radius, m.
const STEP_M: f64 = 125.0;
/// Cell by cell from the north-west: cells from the last one with a town to the next (base 128, little-endian), and its radius in steps.
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
    let mut bytes = LIST.iter().copied();
    let mut next = 0;
    std::iter::from_fn(move || {
        let mut gap = 0;
        for shift in (0..).step_by(7) {
            let byte = bytes.next()?;
            gap |= u64::from(byte & 127) << shift;
            if byte < 128 {
                break;
            }
        }
        let radius_m = STEP_M * f64::from(bytes.next()?);
        let cell = next + gap;
        next = cell + 1;
        let [x, y] = [cell % CELLS[0], cell / CELLS[0]].map(|i| i as f64 + 0.5);
        Some(Town { lat: (0.5 - y / CELLS[1] as f64) * PI, lon: (x / CELLS[0] as f64 - 0.5) * TAU, radius_m })
    })
}
