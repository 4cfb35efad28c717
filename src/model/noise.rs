//! Random numbers by counter: each wave's noise is a pure function of (seed, cascade, i, j), so nothing depends on the order of
//! evaluation, on the grid's size or on the platform.
//!
//! The key passes twice through SplitMix64's finaliser ([Steele et al.](crate::bibliography::Steele2014)), a bijection of 64
//! bits in which every input bit flips half of the output bits; two outputs make one
//! [Box–Muller](crate::bibliography::BoxMuller1958) pair.

/// 2^64 over the golden ratio: SplitMix64's odd increment.
const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

/// SplitMix64's finaliser.
fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// 128 random bits for a key. `i` and `j` are signed wave indices: n·dk with n < 0 for waves that travel the other way.
pub fn bits(seed: u32, cascade: u32, i: i32, j: i32) -> [u64; 2] {
    let stream = mix((u64::from(seed) << 32 | u64::from(cascade)).wrapping_add(GOLDEN));
    let key = mix(stream ^ (u64::from(i as u32) << 32 | u64::from(j as u32)));
    [mix(key.wrapping_add(GOLDEN)), mix(key.wrapping_add(GOLDEN.wrapping_mul(2)))]
}

/// Two independent standard normal numbers for a key, see [`bits`].
pub fn gaussian_pair(seed: u32, cascade: u32, i: i32, j: i32) -> [f64; 2] {
    let [r, angle] = bits(seed, cascade, i, j);
    // 53 bits each; the first in (0, 1] so that its logarithm exists, hence |ξ| ≤ sqrt(2·53·ln 2) = 8.57.
    let unit = |bits: u64| (bits >> 11) as f64 / (1u64 << 53) as f64;
    let radius = libm::sqrt(-2.0 * libm::log(1.0 - unit(r)));
    let (sin, cos) = libm::sincos(std::f64::consts::TAU * unit(angle));
    [radius * cos, radius * sin]
}

/// One random word for three: PCG3D ([Jarzynski and Olano](crate::bibliography::Jarzynski2020)), one word of it; as in
/// `shaders/lib/hash.wgsl`.
pub fn hash(p: [u32; 3]) -> u32 {
    let [mut x, mut y, mut z] = p.map(|word| word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    x = x.wrapping_add(y.wrapping_mul(z));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    [x, y, z] = [x, y, z].map(|word| word ^ (word >> 16));
    x.wrapping_add(y.wrapping_mul(z))
}

/// Gradient noise of square cells of two to a power units of the map, its mean none, and how it rises right and down, a cell: `map_noise_rise` of
/// `shaders/lib/noise.wgsl`.
pub fn map_noise(at: [u32; 2], bits: u32, salt: u32) -> [f64; 3] {
    let [x, y] = at.map(|x| f64::from(x & ((1 << bits) - 1)) / f64::from(1u32 << bits));
    let fade = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let fades = |t: f64| 30.0 * t * t * (t * (t - 2.0) + 1.0);
    let mask = u32::MAX >> bits;
    // Height of the corner's plane, and its rise.
    let corner = |i: u32, j: u32| {
        let eighth = hash([((at[0] >> bits) + i) & mask, ((at[1] >> bits) + j) & mask, salt]) >> 29;
        let way = if eighth >= 4 { -1.0 } else { 1.0 };
        let [a, b] = if eighth & 2 == 0 { [way, 0.0] } else { [0.0, way] };
        let slanted = 0.5f64.sqrt();
        let [a, b] = if eighth & 1 == 0 { [a, b] } else { [slanted * (a - b), slanted * (a + b)] };
        [a * (x - f64::from(i)) + b * (y - f64::from(j)), a, b]
    };
    let mix = |a: f64, b: f64, t: f64| a + t * (b - a);
    let corners = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
    let [top, bottom] = [0, 2].map(|row| mix(corners[row][0], corners[row + 1][0], fade(x)));
    let across = mix(corners[1][0] - corners[0][0], corners[3][0] - corners[2][0], fade(y));
    let rise = |axis: usize| {
        let [top, bottom] = [0, 2].map(|row| mix(corners[row][axis], corners[row + 1][axis], fade(x)));
        mix(top, bottom, fade(y))
    };
    [mix(top, bottom, fade(y)), rise(1) + fades(x) * across, rise(2) + fades(y) * (bottom - top)].map(|part| 0.8 * part)
}
