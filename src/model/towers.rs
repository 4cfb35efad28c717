//! Towers of limestone (Halong's, Phang Nga's), which stand on drowned hills of the tropics ([`super::rugged`]).
//!
//! There rain dissolves limestone along its joints, and what is left between these are towers with steep walls, of all heights beside each other. The map is
//! divided into square cells, in each of which one stands somewhere: an ellipse as seen from above, turned, long and high by chance, whose outline noise
//! makes uneven. Where several are at a place its ground is about as high as the highest of them; between them lies a low one. All numbers are ours.
//!
//! Places are those of Mercator's map: there are no towers beyond [`LATITUDES`]. `shaders/lib/towers.wgsl` is the same in single precision.

use super::noise::{hash, map_noise};
use super::sea_bed::smoothstep;

/// A cell is two to this power units of the map wide: 306 m at the equator.
pub const CELL_BITS: u32 = 15;
/// How far towers stand from the middles of their cells at most, both ways together, of these.
pub const ASIDE: f64 = 0.7;
/// Radii of the narrowest and the widest, of a cell.
pub const WIDE: [f64; 2] = [0.4, 0.8];
/// Squares of the lengths over the breadths of the roundest and the longest.
pub const LONG: [f64; 2] = [1.0, 1.9];
/// Heights of the lowest and the highest.
pub const TALL: [f64; 2] = [0.3, 1.0];
/// How much noises over a half and an eighth of a cell change the square of the way from a tower's middle, of its radius'.
pub const ROUGH: [f64; 2] = [0.7, 0.25];
/// Widths of pixels between which the finer one is no longer seen, metres.
pub const ROUGH_SEEN_M: [f64; 2] = [10.0, 20.0];
/// How high the ground between towers is, of the highest.
pub const FLOOR: f64 = 0.3;
/// Height of the highest that stands alone, metres.
pub const HIGH_M: f64 = 280.0;
/// They are level far beyond this from their shores, metres.
pub const WALL_M: f64 = 35.0;
/// Between their shores and this far inland they begin to rise, metres.
pub const FOOT_M: f64 = 10.0;
/// Sines of 21.5 and 22.5 degrees, between which they end.
pub const LATITUDES: [f64; 2] = [0.3665, 0.3827];

/// How far there are any.
pub fn share(sin_lat: f64) -> f64 {
    1.0 - smoothstep(LATITUDES[0], LATITUDES[1], sin_lat.abs())
}

/// How high towers stand at a place of Mercator's map, in units of 2^-32 of its side: 0 to 1, and a little more where two of the highest meet.
pub fn height(at: [u32; 2]) -> f64 {
    let mask = u32::MAX >> CELL_BITS;
    let part = |x: u32| f64::from(x & ((1 << CELL_BITS) - 1)) / f64::from(1u32 << CELL_BITS);
    let rough = ROUGH[0] * map_noise(at, CELL_BITS - 1, 91)[0] + ROUGH[1] * map_noise(at, CELL_BITS - 3, 92)[0];
    let mix = |[from, to]: [f64; 2], t: f64| from + t * (to - from);
    let mut sum = 0.0;
    for k in 0..9u32 {
        let step = [k % 3, k / 3];
        let cell = [0, 1].map(|axis| (at[axis] >> CELL_BITS).wrapping_add(step[axis]).wrapping_sub(1) & mask);
        let word = hash([cell[0], cell[1], 93]);
        let bytes = [0, 8, 16, 24].map(|shift| f64::from((word >> shift) & 255) / 255.0);
        // Of a byte its four lowest bits.
        let rest = |axis: u32| f64::from((word >> (8 * axis)) & 15) / 16.0;
        let off = [0, 1].map(|axis| part(at[axis]) - f64::from(step[axis]) + 0.5 - ASIDE * (bytes[axis] - 0.5));
        let (radius, long) = (mix(WIDE, bytes[2]), mix(LONG, rest(2)));
        let turned = [rest(0) - 0.5, rest(1) - 0.499];
        let way = turned.map(|x| x / turned[0].hypot(turned[1]));
        let along = off[0] * way[0] + off[1] * way[1];
        let across = off[1] * way[0] - off[0] * way[1];
        let q = (along * along / long + across * across * long) / (radius * radius) + rough;
        let left = (1.0 - q * q.abs()).max(0.0);
        sum += (mix(TALL, bytes[3]) * left * left.sqrt()).powi(4);
    }
    sum.sqrt().sqrt()
}

/// How high the ground stands on drowned hills as steep as any, metres, `inland_m` from the shore, where towers stand so high.
pub fn ground_m(inland_m: f64, towers: f64) -> f64 {
    let x = inland_m.max(0.0);
    let walls = smoothstep(0.0, FOOT_M, x) * x / (1.0 + (x / WALL_M).powi(2)).sqrt() / WALL_M;
    HIGH_M * walls * (FLOOR + (1.0 - FLOOR) * towers)
}
