//! From a sea to wave amplitudes: which tiles, which waves in each, their random amplitudes and their clocks.
//!
//! # Conventions
//! x is downwind, y 90° to its left, z up: the amplitudes do not know the wind's direction, the renderer rotates the tile.
//! Element (i, j) stands at j·N + i; its wave vector is (n, m)·dk with n = i for i < N/2, else i − N; dk = 2π/patch.
//! η = Σ H e^{+ik·x} with no 1/N², H = h0(k) e^{−iωt} + conj(h0(−k)) e^{+iωt}.
//!
//! # Why three tiles
//! One tile that holds the storm's kilometre waves has texels of metres. Three tiles share the wave numbers in half-open rings
//! with independent noise, so their variances add, and their lengths have no common multiple, so their sum does not repeat
//! with any of them. Rejected: every tile carrying the whole spectrum (counts the same energy three times) and cross-fades
//! (need weights whose squares sum to one, and gain nothing in a sum of Gaussians).
//!
//! ```text
//!  k  0 ──────── 6 dk₁ ──────── 6 dk₂ ─────── 0.9 π N/patch₂
//!     | cascade 0 |   cascade 1  |  cascade 2   |  below the texels: mss_above
//! ```

use super::{dispersion, noise, spectrum::DirectionalSpectrum};

pub use super::sea::Sea;

/// How many tiles a sea is made of.
pub const CASCADES: usize = 3;
/// A ring starts this many steps of its own tile from the origin: fewer would be too coarse to look random.
const RING_START: f64 = 6.0;
/// Share of a tile's highest wave number that is used; the rest would alias under the choppy displacement.
const USED_BAND: f64 = 0.9;
/// Sub-samples per axis of a cell that the spectrum or a ring's edge does not let be taken at its middle.
const SUBSAMPLES: usize = 8;
/// Cells closer to the origin than this (in steps) are sub-sampled: one sample of k⁻⁴ is 0.1 % off at 24 steps.
const NEAR_CELLS: f64 = 24.0;

/// One tile of waves, periodic over `patch_m`, and its ring of wave numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cascade {
    /// Samples along each side, a power of two.
    pub n: usize,
    /// Side, m.
    pub patch_m: f64,
    /// Its waves have k_min ≤ |k| < k_max, rad/m.
    pub k_min: f64,
    /// See `k_min`.
    pub k_max: f64,
}

impl Cascade {
    /// Step between wave numbers, rad/m.
    pub fn dk(&self) -> f64 {
        std::f64::consts::TAU / self.patch_m
    }

    /// The signed wave index of row or column `i`.
    pub fn signed(&self, i: usize) -> i32 {
        if i < self.n / 2 { i as i32 } else { i as i32 - self.n as i32 }
    }

    /// (kx, ky) of every element, in order.
    pub fn wave_vectors(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let dk = self.dk();
        let at = move |i| f64::from(self.signed(i)) * dk;
        (0..self.n).flat_map(move |j| (0..self.n).map(move |i| (at(i), at(j))))
    }
}

/// The three tiles of a sea, the longest first, with `n` samples along each side (a power of two, at least 16).
///
/// Lengths depend on the sea alone: the first holds 8 peak wavelengths within 300 m … 6 km, and its ratios to the next are
/// ν + 0.618… and ν + 0.382… with an integer ν: numbers as far from simple fractions as there are, and so is their product.
/// ν aims at a last tile of about 6 m (2–3 cm texels at n = 256) but stays ≤ 15, as far as rings of 256 samples can overlap,
/// so that above about 20 m/s of wind the finest texel grows to 10 cm.
pub fn cascades(sea: &Sea, n: usize) -> Vec<Cascade> {
    let peak = sea.spectrum().peak_wavenumber();
    let eight_waves = if peak > 0.0 { 8.0 * std::f64::consts::TAU / peak } else { 0.0 };
    let first = eight_waves.clamp(300.0, 6000.0);
    let nu = libm::floor(libm::sqrt(first / 6.0) - 0.5).clamp(6.0, 15.0);
    let second = first / (nu + 0.618_033_988_749_894_9);
    let patches = [first, second, second / (nu + 0.381_966_011_250_105_1)];
    let highest = |patch: f64| USED_BAND * std::f64::consts::PI * n as f64 / patch;
    let edge = |i: usize| (RING_START * std::f64::consts::TAU / patches[i]).min(highest(patches[i - 1]));
    let edges = [0.0, edge(1), edge(2), highest(patches[2])];
    (0..CASCADES).map(|i| Cascade { n, patch_m: patches[i], k_min: edges[i], k_max: edges[i + 1] }).collect()
}

/// Mean square slope of the waves that no tile of `n` samples holds: the glitter below the texels.
pub fn mss_unresolved(sea: &Sea, n: usize) -> f64 {
    cascades(sea, n).last().map_or(0.0, |last| sea.spectrum().mss_above(last.k_max))
}

/// Energy of each cell: ∫ F over [n ± ½] × [m ± ½] dk where |k| lies in the ring, m². 0 at the origin and at row and column
/// N/2, which have no partner −k.
pub fn cell_energies(spectrum: &impl DirectionalSpectrum, cascade: &Cascade) -> Vec<f64> {
    let (dk, n) = (cascade.dk(), cascade.n);
    let inside = |k: f64| k >= cascade.k_min && k < cascade.k_max;
    let cell = |(index, (kx, ky)): (usize, (f64, f64))| {
        let (i, j) = (index % n, index / n);
        if (i, j) == (0, 0) || i == n / 2 || j == n / 2 {
            return 0.0;
        }
        let k = libm::sqrt(kx * kx + ky * ky);
        let reach = dk * std::f64::consts::FRAC_1_SQRT_2;
        if k + reach < cascade.k_min || k - reach >= cascade.k_max {
            return 0.0;
        }
        let whole = k - reach >= cascade.k_min && k + reach < cascade.k_max;
        if whole && k > NEAR_CELLS * dk {
            return spectrum.density(kx, ky) * dk * dk;
        }
        let offset = |s: usize| ((s as f64 + 0.5) / SUBSAMPLES as f64 - 0.5) * dk;
        let mut sum = 0.0;
        for (a, b) in (0..SUBSAMPLES * SUBSAMPLES).map(|s| (s % SUBSAMPLES, s / SUBSAMPLES)) {
            let (x, y) = (kx + offset(a), ky + offset(b));
            if inside(libm::sqrt(x * x + y * y)) {
                sum += spectrum.density(x, y);
            }
        }
        sum * (dk * dk) / (SUBSAMPLES * SUBSAMPLES) as f64
    };
    cascade.wave_vectors().enumerate().map(cell).collect()
}

/// h0(k) = ½ (ξr + iξi) √E as [re, im], m. Noise is keyed by the signed index, so that a finer grid holds the same waves.
pub fn initial_amplitudes(sea: &Sea, cascade_index: usize, cascade: &Cascade) -> Vec<[f64; 2]> {
    let energies = cell_energies(&sea.spectrum(), cascade);
    let amplitude = |(index, energy): (usize, f64)| {
        if energy <= 0.0 {
            return [0.0; 2];
        }
        let (i, j) = (cascade.signed(index % cascade.n), cascade.signed(index / cascade.n));
        let half = 0.5 * libm::sqrt(energy);
        noise::gaussian_pair(sea.seed, cascade_index as u32, i, j).map(|xi| half * xi)
    };
    energies.into_iter().enumerate().map(amplitude).collect()
}

/// ω of every element, rad/s: gravity and surface tension in deep water.
pub fn angular_frequencies(cascade: &Cascade) -> Vec<f64> {
    let omega = |(kx, ky): (f64, f64)| {
        dispersion::omega_capillary(libm::sqrt(kx * kx + ky * ky), f64::INFINITY, dispersion::SEA_TENSION)
    };
    cascade.wave_vectors().map(omega).collect()
}

/// Ticks of the wave clock in a second, 2²⁰: about a microsecond each.
pub const TICKS_PER_SECOND: f64 = 1_048_576.0;

/// A frequency as the part of a cycle per tick in units of 2⁻⁶⁴: its product with the tick count, wrapping, is the phase at any
/// date, with no loss for late dates. Rounding costs 5e-5 of a cycle in 57 years, the same for everyone.
pub fn cycles_per_tick(omega: f64) -> u64 {
    // 2⁶⁴/2²⁰ = 2⁴⁴.
    libm::round(omega / std::f64::consts::TAU * 17_592_186_044_416.0) as i64 as u64
}

/// Ticks since 1970 at a Unix time in seconds, two's complement before 1970; 0 for a time that is not finite.
pub fn ticks_from_unix(unix_seconds: f64) -> u64 {
    // `as` saturates at ±292,000 years and takes NaN to 0.
    let ticks = unix_seconds * TICKS_PER_SECOND;
    if ticks.is_finite() { libm::round(ticks) as i64 as u64 } else { 0 }
}

/// The phase ωt at a tick, in units of 2⁻³² cycle.
pub fn phase_u32(cycles_per_tick: u64, ticks: u64) -> u32 {
    (cycles_per_tick.wrapping_mul(ticks) >> 32) as u32
}

/// 64-bit FNV-1a over the amplitudes narrowed to f32, little-endian: two platforms with the same hash draw the same sea.
pub fn hash(h0: &[[f64; 2]]) -> u64 {
    let bytes = h0.iter().flatten().flat_map(|&x| (x as f32).to_le_bytes());
    bytes.fold(0xCBF2_9CE4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3))
}
