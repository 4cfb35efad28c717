//! How far a ray that land blocks would have to be moved to pass: what the rays beside it tell.
//!
//! ```text
//!   ══════════════╗ end       A place in thin land is near a shore, however far the land's end is: what a single ray meets does not tell
//!    \    |    /   .            how long the land is. Rays of other directions, blocked as near as it, do: the ray has to be turned past
//!     \   |   /  .             the last of them, and so moved by √r sin α over the root of the land's distance r.
//!      \  |  / .    α to the ray that passes
//!         place
//! ```

use std::f64::consts::PI;

use super::{DIRECTIONS, Exposure, Exposures};

/// Angle between two directions.
const APART: f64 = 2.0 * PI / DIRECTIONS as f64;
/// Directions up to a quarter of a turn.
const QUARTER: usize = DIRECTIONS / 4;
/// Land is the same land to a direction and the next where its distances differ by less than this factor: a straight shore's differ by up to 1.9
/// within 75 degrees.
const SAME_LAND: f64 = 2.0;

/// An exposure in a direction with the clearance that its neighbours tell, if that is less. Land that one direction alone meets is as wide as this
/// one says.
pub(super) fn behind_barrier(exposures: &Exposures, direction: usize, exposure: Exposure) -> Exposure {
    if exposure.clearance >= 0.0 || exposure.clearance == f64::NEG_INFINITY {
        return exposure;
    }
    let ends = [1, DIRECTIONS - 1].map(|step| end(exposures, direction, step, exposure));
    let [(left, to_left), (right, to_right)] = ends;
    if left + right < 3 {
        return exposure;
    }
    let moved = libm::sqrt(exposure.fetch_m.max(0.0)) * libm::sin(to_left.min(to_right));
    Exposure { clearance: exposure.clearance.min(-moved), ..exposure }
}

/// The end of the land in a direction, looked for by steps of so many directions: how many directions away the first is that it does not block, and
/// by which angle it ends, at most a quarter of a turn.
fn end(exposures: &Exposures, direction: usize, step: usize, exposure: Exposure) -> (usize, f64) {
    let mut last_m = exposure.fetch_m;
    for count in 1..QUARTER {
        match exposures[(direction + step * count) % DIRECTIONS] {
            Some(next) if next.clearance < 0.0 && next.fetch_m.max(last_m) < SAME_LAND * next.fetch_m.min(last_m) => {
                last_m = next.fetch_m;
            }
            // Between the last ray that it blocks and this one, which passes it by so much.
            Some(next) if next.clearance >= 0.0 => {
                let passes = libm::asin((next.clearance / libm::sqrt(next.fetch_m.max(1.0))).min(1.0));
                return (count, APART * count as f64 - passes.min(APART));
            }
            // Other land, or a direction that is not known.
            _ => return (count, APART * (count - 1) as f64),
        }
    }
    (QUARTER, APART * QUARTER as f64)
}
