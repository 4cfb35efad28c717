//! Relief that elevation data of 9 km cannot hold: ridges and valleys, made by a deterministic function of the place.
//!
//! Two broad octaves of [gradient noise on simplices](crate::bibliography::Perlin2001), folded into ridges, raise mountains between the
//! data's values; gullies are then cut down the slope that data and broader octaves have, each octave half as wide as the one before, so that
//! small ones run into larger ones as in land that water has eroded. More octaves of ridges have no sense of what is downhill: such sums look
//! like crumpled foil. A gully octave is a wave across the slope whose phase is mixed from those of four corners around a place, brought
//! to one amplitude ([phasor noise](crate::bibliography::Tricard2019)).
//!
//! Slopes are exact but for the turning of gullies with the slope that they follow; crests and floors, where it counts, lie where they are.
//!
//! The lattices are those of simplex noise in space, over the unit normal times [`RADIUS_M`]: no map's seams, one size everywhere. Places are
//! integers of [`UNITS_PER_M`], so that the GPU, which adds a small difference to the eye's place, finds the same corners.
//! `shaders/lib/relief.wgsl` is the same in single precision.

use glam::{DVec2, DVec3};

use super::noise::hash;
use super::sea_bed::smoothstep;

/// Units of a place in a metre.
pub const UNITS_PER_M: f64 = 256.0;
/// Of the sphere whose points are the places, metres.
pub const RADIUS_M: f64 = 6_378_137.0;
/// Edge of the broadest octave's lattice: two to this power units, 8 km.
pub const BROADEST_BITS: u32 = 21;
/// Octaves of gradient noise.
pub const BROAD: u32 = 2;
/// All octaves.
pub const OCTAVES: u32 = 11;

/// Who sees no smaller than this, metres, sees no relief: half of the broadest edge (`relief_shown` in `shaders/lib/relief.wgsl`), which is
/// more than raised islands need (`LIFT_SEEN` in `shaders/lib/rugged.wgsl`).
pub const WIDEST_M: f64 = 4_096.0;
/// Octaves that the ground's mesh can hold; the finer ones are seen as shading alone.
pub const MESH_FOOTPRINT_M: f64 = 8.0;

/// Brings gradient noise to about -1 to 1.
pub const NOISE_GAIN: f64 = 70.0;
/// Height of the broad octaves' noise, of the strength.
pub const BROAD_HEIGHTS: [f64; 2] = [4.6, 2.0];
/// How round ridges of the broad octaves are, of their noise.
pub const FOLD: f64 = 0.08;
/// Mean of the noise, folded and flattened.
pub const FOLD_MEAN: f64 = 0.167;
/// Waves of a gully octave in an edge.
pub const WAVES: f64 = 1.2;
/// How far corners' phases are apart, turns: at 0 the lattice shows, at 1 gullies break off.
pub const JITTER: f64 = 0.7;
/// Slopes much below this have no direction for gullies.
pub const LEVEL: f64 = 0.05;
/// Slopes between which gullies begin.
pub const GENTLE: [f64; 2] = [0.02, 0.07];
/// Strength from which on gullies are whole, metres; below a quarter of it there are none.
pub const GULLIED_M: f64 = 60.0;
/// Depth of gullies, of their edge and the slope.
pub const DEEP: f64 = 0.11;
/// Gullies are no deeper than on this slope.
pub const STEEPEST: f64 = 0.8;
/// How far smaller gullies follow the slopes of larger ones: much, and they turn about every spur; little, and all run the same way.
pub const FOLLOWS: f64 = 0.45;

/// Octaves of the valleys of volcanoes in a deep sea, from the first to the last, exclusive.
pub const CARVED_OCTAVES: [u32; 2] = [1, 4];
/// How much of the broad octaves there is not on these.
pub const CARVED_BROAD: f64 = 0.7;
/// How round their ridges are, of a wave.
pub const CARVED_CREST: f64 = 0.06;
/// Mean of such a wave, a little less than 2 / pi, as waves break off where phases cancel: measured.
pub const CARVED_MEAN: f64 = 0.59;
/// Depth of the widest valleys, of their edge and the slope, and of those that run into them.
pub const CARVED_DEEP: [f64; 2] = [1.6, 0.8];
/// No valley is deeper, of the relief's strength: that ends by the shore.
pub const CARVED_MOST: f64 = 12.0;
/// They are no deeper than on this slope.
pub const CARVED_STEEPEST: f64 = 0.55;
/// How far corners' phases are apart, turns: valleys are long.
pub const CARVED_JITTER: f64 = 0.35;

/// What there is of relief at a place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Relief {
    /// Metres over the data; 0 in the mean.
    pub height_m: f64,
    /// How it rises, metres a metre, along the earth's axes.
    pub slope: DVec3,
}

/// The place of a unit normal along the earth's axes, in units.
pub fn place(normal: DVec3) -> [u32; 3] {
    (normal * RADIUS_M * UNITS_PER_M).to_array().map(|x| (x.floor() as i64 + (1 << 31)) as u32)
}

/// Edge of an octave's lattice, metres.
pub fn edge_m(octave: u32) -> f64 {
    f64::from(1u32 << (BROADEST_BITS - octave)) / UNITS_PER_M
}

/// How much of an octave shows where one sees no smaller than `footprint_m`.
pub fn shown(octave: u32, footprint_m: f64) -> f64 {
    1.0 - smoothstep(0.25, 0.5, footprint_m / edge_m(octave))
}

/// Sine of a number of turns, within 0.001.
fn sine(turns: f64) -> f64 {
    let x = turns - (turns + 0.5).floor();
    let s = x * (8.0 - 16.0 * x.abs());
    s * (0.775 + 0.225 * s.abs())
}

/// The four corners of the simplex around a place: their random words, and the ways from them to it in edges.
fn corners(at: [u32; 3], octave: u32) -> [(u32, DVec3); 4] {
    let bits = BROADEST_BITS - octave;
    let whole = at.map(|x| x >> bits);
    let part = DVec3::from(at.map(|x| f64::from(x & ((1 << bits) - 1)) / f64::from(1u32 << bits)));
    let sum = whole[0] + whole[1] + whole[2];
    let (third, rest) = (sum / 3, f64::from(sum % 3));
    // Skewed cells are cubes; whole numbers are kept apart, so that nothing is lost.
    let step = (part + (rest + part.element_sum()) / 3.0).floor();
    let from_first = part - step + (rest + step.element_sum()) / 6.0;
    let first = [step.x, step.y, step.z].map(|x| x as u32);
    let first: [u32; 3] = std::array::from_fn(|i| whole[i] + third + first[i]);
    let v = from_first;
    let (xy, yz, zx) = (v.x >= v.y, v.y >= v.z, v.z > v.x);
    let rank = [u32::from(xy) + u32::from(!zx), u32::from(!xy) + u32::from(yz), u32::from(!yz) + u32::from(zx)];
    std::array::from_fn(|corner| {
        let steps = rank.map(|rank| u32::from(rank + corner as u32 >= 3));
        let p: [u32; 3] = std::array::from_fn(|i| first[i] + steps[i]);
        let way = v - DVec3::from(steps.map(f64::from)) + corner as f64 / 6.0;
        (hash([p[0], p[1], p[2] ^ (octave << 24)]), way)
    })
}

/// Gradient noise, about -1 to 1, and how it rises in an edge.
fn noise(at: [u32; 3], octave: u32) -> (f64, DVec3) {
    let (mut sum, mut rise) = (0.0, DVec3::ZERO);
    for (word, way) in corners(at, octave) {
        let t = (0.5 - way.length_squared()).max(0.0);
        let gradient =
            DVec3::new(f64::from(word & 1023), f64::from((word >> 10) & 1023), f64::from((word >> 20) & 1023)) / 511.5
                - 1.0;
        let (t2, along) = (t * t, gradient.dot(way));
        sum += t2 * t2 * along;
        rise += t2 * t2 * gradient - 8.0 * t2 * t * along * way;
    }
    (NOISE_GAIN * sum, NOISE_GAIN * rise)
}

/// A wave across a slope: cosine and sine of its phase, and how the phase rises in an edge, radians. `side` is the way in which it goes,
/// across the slope; `jitter`: how far corners' phases are apart, turns.
fn gully(at: [u32; 3], octave: u32, side: DVec3, jitter: f64) -> (DVec2, DVec3) {
    let (mut sum, mut weights) = (DVec2::ZERO, 0.0);
    let (mut rise_cosine, mut rise_sine) = (DVec3::ZERO, DVec3::ZERO);
    for (word, way) in corners(at, octave) {
        let t = (0.5 - way.length_squared()).max(0.0);
        let turns = WAVES * side.dot(way) + jitter * (f64::from(word >> 16) / 65536.0 - 0.5);
        let wave = DVec2::new(sine(turns + 0.25), sine(turns));
        let t3 = t * t * t;
        sum += t3 * t * wave;
        weights += t3 * t;
        rise_cosine -= 8.0 * t3 * wave.x * way;
        rise_sine -= 8.0 * t3 * wave.y * way;
    }
    let power = sum.length_squared() + 0.02 * weights * weights;
    let phase_rise = std::f64::consts::TAU * WAVES * side + (sum.x * rise_sine - sum.y * rise_cosine) / power;
    (sum / power.sqrt(), phase_rise)
}

/// The relief at a place where the data rise by `slope` (metres a metre, along the earth's axes) and hold a relief of their own of
/// `strength_m`, as one sees it who sees no smaller than `footprint_m`; `up` is the unit normal. `carved`: how far the place is one of a volcano's, 0 to 1,
/// with deep valleys down the data's own slope, away from the summit, and sharp ridges between them.
pub fn relief(at: [u32; 3], up: DVec3, slope: DVec3, [strength_m, carved]: [f64; 2], footprint_m: f64) -> Relief {
    let mut found = Relief::default();
    if strength_m <= 0.0 {
        return found;
    }
    let level = |rise: DVec3| rise - rise.dot(up) * up;
    for octave in 0..BROAD {
        let weight =
            strength_m * (1.0 - CARVED_BROAD * carved) * shown(octave, footprint_m) * BROAD_HEIGHTS[octave as usize];
        let (n, rise) = noise(at, octave);
        // Ridges where the noise crosses zero, rounded; wide floors of valleys where it is far from it.
        let fold = (n * n + FOLD * FOLD).sqrt();
        found.height_m += weight * (FOLD_MEAN - fold / (1.0 + fold));
        found.slope += level(-weight / edge_m(octave) * n / (fold * (1.0 + fold) * (1.0 + fold)) * rise);
    }
    let mut downhill = slope;
    let steepness = slope.length() / (1.0 + (slope.length() / CARVED_STEEPEST).powi(2)).sqrt();
    for octave in CARVED_OCTAVES[0]..CARVED_OCTAVES[1] {
        let edge = edge_m(octave);
        let (wave, phase_rise) = gully(at, octave, up.cross(downhill) / downhill.length().hypot(LEVEL), CARVED_JITTER);
        let bow = ((0.5 - 0.5 * wave.x).max(0.0) + CARVED_CREST * CARVED_CREST).sqrt();
        let room_m = CARVED_DEEP[usize::from(octave > CARVED_OCTAVES[0])] * edge * steepness;
        let deep = carved * shown(octave, footprint_m) * room_m / (1.0 + room_m / (CARVED_MOST * strength_m));
        found.height_m += deep * (CARVED_MEAN - bow);
        let rise = level(-deep / edge * 0.25 * wave.y / bow * phase_rise);
        found.slope += rise;
    }
    downhill += found.slope;
    // Where it is nearly level no gully shows; none begins abruptly.
    let gullied =
        smoothstep(GENTLE[0], GENTLE[1], downhill.length()) * smoothstep(0.25 * GULLIED_M, GULLIED_M, strength_m);
    for octave in BROAD..OCTAVES {
        let (edge, shown) = (edge_m(octave), shown(octave, footprint_m));
        let steep = downhill.length();
        let (wave, phase_rise) = gully(at, octave, up.cross(downhill) / steep.hypot(LEVEL), JITTER);
        let there = if octave < CARVED_OCTAVES[1] { 1.0 - carved } else { 1.0 };
        let deep = there * gullied * shown * DEEP * edge * steep / (1.0 + (steep / STEEPEST).powi(2)).sqrt();
        found.height_m += deep * wave.x;
        let rise = level(-deep / edge * wave.y * phase_rise);
        found.slope += rise;
        downhill += FOLLOWS * rise;
    }
    found
}
