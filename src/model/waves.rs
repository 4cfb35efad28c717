//! From a sea to wave amplitudes: which patches, which waves in each, their random amplitudes and their clocks.
//!
//! # Conventions
//! x is downwind, y 90° to its left, z up: the amplitudes do not know the wind's direction, the renderer rotates the patch.
//! Element (i, j) stands at j·N + i; its wave vector is (n, m)·dk with n = i for i < N/2, else i − N; dk = 2π/patch.
//! η = Σ H e^{+ik·x} with no 1/N², H = h0(k) e^{−iωt} + conj(h0(−k)) e^{+iωt}.

pub use super::cascade::{CASCADES, Cascade, PATCHES_M, Patch, cascades};
use super::quadrature::simpson_log;
pub use super::sea::Sea;
use super::{dispersion, noise, spectrum::DirectionalSpectrum};

/// Sub-samples per axis of a cell that a ring's edge cuts or that lies closer to the origin than [`NEAREST_CELLS`].
const SUBSAMPLES: usize = 8;
/// Within so many steps of the origin cells are sub-sampled as finely as cut ones: a spectrum's rise may fall into one cell.
const NEAREST_CELLS: f64 = 8.0;
/// Cells closer to the origin than this are sub-sampled half as finely: one sample of k⁻⁴ is 0.1 % off at 24 steps.
const NEAR_CELLS: f64 = 24.0;

/// The cells of a patch's wave numbers, [n ± ½]dkx × [m ± ½]dky, with the spectrum's energy in each.
pub struct Cells<'a, S> {
    spectrum: &'a S,
    patch: Patch,
    squares: [f64; 2],
    area: f64,
    /// Half of a cell's diagonal, rad/m.
    reach: f64,
    /// How often the spectrum has been evaluated.
    pub evaluations: usize,
}

impl<'a, S: DirectionalSpectrum> Cells<'a, S> {
    /// The cells of a patch.
    pub fn new(spectrum: &'a S, patch: impl Into<Patch>) -> Self {
        let patch = patch.into();
        let (dk, squares) = (patch.dk(), [patch.k_min * patch.k_min, patch.k_max * patch.k_max]);
        let (area, reach) = (dk[0] * dk[1], 0.5 * libm::sqrt(dk[0] * dk[0] + dk[1] * dk[1]));
        Self { spectrum, patch, squares, area, reach, evaluations: 0 }
    }

    /// ∫ F over a cell where |k| lies in the ring, m². 0 at the origin and at the row and the column at half of the samples, which
    /// have no partner −k.
    pub fn energy(&mut self, index: usize) -> f64 {
        let (patch, reach) = (self.patch, self.reach);
        let (at, dk) = (patch.wave_vector(index), patch.dk());
        let step = dk[0].max(dk[1]);
        let k = libm::sqrt(at.0 * at.0 + at.1 * at.1);
        if patch.is_alone(index) || k + reach < patch.k_min || k - reach >= patch.k_max {
            return 0.0;
        }
        let whole = k - reach >= patch.k_min && k + reach < patch.k_max;
        if whole && k > NEAR_CELLS * step {
            self.evaluations += 1;
            self.spectrum.density(at.0, at.1) * self.area
        } else if whole && k > NEAREST_CELLS * step {
            self.over(at, SUBSAMPLES / 2)
        } else {
            self.over(at, SUBSAMPLES)
        }
    }

    /// The energy around (kx, ky) by `parts` × `parts` samples.
    fn over(&mut self, (kx, ky): (f64, f64), parts: usize) -> f64 {
        let dk = self.patch.dk();
        let offset = |s: usize, dk: f64| ((s as f64 + 0.5) / parts as f64 - 0.5) * dk;
        let mut sum = 0.0;
        for (a, b) in (0..parts * parts).map(|s| (s % parts, s / parts)) {
            let (x, y) = (kx + offset(a, dk[0]), ky + offset(b, dk[1]));
            let k2 = x * x + y * y;
            if k2 >= self.squares[0] && k2 < self.squares[1] {
                sum += self.spectrum.density(x, y);
            }
        }
        self.evaluations += parts * parts;
        sum * self.area / (parts * parts) as f64
    }
}

/// The energies of all cells of a patch, in order, see [`Cells::energy`].
pub fn cell_energies(spectrum: &impl DirectionalSpectrum, patch: impl Into<Patch>) -> Vec<f64> {
    let patch = patch.into();
    let mut cells = Cells::new(spectrum, patch);
    (0..patch.count()).map(|index| cells.energy(index)).collect()
}

/// h0(k) = ½ (ξr + iξi) √E as [re, im], m. Noise is keyed by the signed index, so that a finer grid holds the same waves.
pub fn initial_amplitudes(sea: &Sea, cascade_index: usize, patch: impl Into<Patch>) -> Vec<[f64; 2]> {
    let patch = patch.into();
    let mut h0 = amplitudes(&cell_energies(&sea.drawn_spectrum(), patch), sea.seed, cascade_index, patch);
    for mode in sea.modes().iter().filter(|mode| mode.cascade == cascade_index) {
        let element = mode.element(patch.samples[0]);
        h0[element] = [h0[element][0] + mode.h0[0], h0[element][1] + mode.h0[1]];
    }
    h0
}

/// As [`initial_amplitudes`] for any energies E, m², one for each element of the patch.
pub fn amplitudes(energies: &[f64], seed: u32, cascade_index: usize, patch: impl Into<Patch>) -> Vec<[f64; 2]> {
    let patch = patch.into();
    energies.iter().enumerate().map(|(index, &energy)| amplitude(energy, seed, cascade_index, &patch, index)).collect()
}

/// One element of [`amplitudes`].
pub fn amplitude(energy: f64, seed: u32, cascade_index: usize, patch: &Patch, index: usize) -> [f64; 2] {
    if energy <= 0.0 {
        return [0.0; 2];
    }
    let [i, j] = patch.signed(index);
    let half = 0.5 * libm::sqrt(energy);
    noise::gaussian_pair(seed, cascade_index as u32, i, j).map(|xi| half * xi)
}

/// ω of every element, rad/s: gravity and surface tension over water `depth_m` deep (infinity: deep water).
pub fn angular_frequencies(patch: impl Into<Patch>, depth_m: f64) -> Vec<f64> {
    patch.into().wave_vectors().map(|k| angular_frequency(k, depth_m)).collect()
}

/// ω of a wave (kx, ky), rad/m, as [`angular_frequencies`].
pub fn angular_frequency((kx, ky): (f64, f64), depth_m: f64) -> f64 {
    dispersion::omega_capillary(libm::sqrt(kx * kx + ky * ky), depth_m, dispersion::SEA_TENSION)
}

/// Mean level of the sea under a choppy displacement of λ = `chop` over water `depth_m` deep, m: −λ Σ k coth kh E over the waves up to `k_max`.
/// Negative, since the displacement X = x + λD widens the troughs: ⟨ηJ⟩ = λ⟨η∇·D⟩ per area at rest, and ∇·D = −k coth kh H. The drawn surface has it
/// subtracted, so that its mean stays the ellipsoid. Single waves have −λ Σ k a²/2 of their own.
pub fn chop_level_m(spectrum: &impl DirectionalSpectrum, depth_m: f64, k_max: f64, chop: f64) -> f64 {
    // No sea has energy below 1e-5 rad/m; 1024 steps of Simpson's rule are good to 1e-6 across a tail's kink.
    -chop * simpson_log(1e-5, k_max, 1024, |k| k * dispersion::orbit_ratio(k, depth_m) * spectrum.omnidirectional(k))
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
