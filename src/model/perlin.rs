//! The far sea as octaves of [Perlin's](crate::bibliography::Perlin1985) gradient noise, with the height and the slopes of a spectrum.
//!
//! Each octave takes the variance of the waves of about its length, so the patch's height variance is the spectrum's m0. What
//! slopes four octaves cannot hold are roughness: [`Octaves::rough`] is the spectrum's slope variance less the patch's own.
//!
//! # The noise
//! n(p) = Σ over lattice points l of ψ(p − l) g_l·(p − l), with ψ(d) = φ(d_x) φ(d_y), φ(t) = 1 − fade(|t|), fade the quintic
//! t³(6t² − 15t + 10), and g_l unit vectors of random, independent directions. So ⟨n(p) n(q)⟩ = ½ Σ ψ(p − l) ψ(q − l) (p − l)·(q − l).

use std::f64::consts::TAU;

use super::spectrum::DirectionalSpectrum;

/// Octaves of the noise; equals `OCTAVES` in `shaders/perlin.wgsl`.
pub const OCTAVES: usize = 4;
/// Texels along a side of the patch.
pub const TEXELS: usize = 256;
/// Lattice cells along the wind in the first octave; across the wind half as many, since crests are longer than wide.
pub const PEAK_CELLS: usize = 8;
/// The noise's strongest wave in cells.
const CELLS_PER_WAVE: f64 = 1.6;
/// Most of the spectrum's slope variance along an axis that the octaves may hold: the rest is smaller than their texels.
const STEEPEST_SHARE: f64 = 0.9;

/// The patch of a sea.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Octaves {
    /// Its side, metres.
    pub patch_m: f64,
    /// Factor on the unit noise of each octave, metres.
    pub amplitudes_m: [f64; OCTAVES],
    /// Slope variance of the texels' own central differences, along the wind and across it.
    pub slopes: [f64; 2],
    /// Slope variance of the spectrum that the texels do not hold, along the wind and across it.
    pub rough: [f64; 2],
}

/// Length of the patch in metres for a sea of a peak wavelength in metres.
pub fn patch_m(peak_wavelength_m: f64) -> f64 {
    // The first octave's waves are then as long as the peak's.
    (PEAK_CELLS as f64 / CELLS_PER_WAVE * peak_wavelength_m).clamp(120.0, 8_000.0)
}

/// Wavelength of an octave's strongest wave, metres.
pub fn wavelength_m(patch_m: f64, octave: usize) -> f64 {
    CELLS_PER_WAVE * patch_m / (PEAK_CELLS << octave) as f64
}

impl Octaves {
    /// The octaves of a spectrum whose slope variances along and across the wind are `slopes`.
    pub fn of(spectrum: &dyn DirectionalSpectrum, slopes: [f64; 2]) -> Self {
        let peak = spectrum.peak_wavenumber();
        if peak <= 0.0 {
            return Self { patch_m: patch_m(0.0), ..Self::default() };
        }
        let patch_m = patch_m(TAU / peak);
        let wavenumber = |octave: usize| TAU / wavelength_m(patch_m, octave);
        // Bands meet at the geometric mean of two octaves' wave numbers.
        let edge = |octave: usize| match octave {
            0 => 0.0,
            OCTAVES => f64::INFINITY,
            _ => wavenumber(octave) / std::f64::consts::SQRT_2,
        };
        let unit = variance();
        let mut energy: [f64; OCTAVES] = std::array::from_fn(|o| spectrum.variance_between(edge(o), edge(o + 1)));
        let slope_per_energy: [[f64; 2]; OCTAVES] =
            std::array::from_fn(|o| slope_variance(patch_m, o).map(|s| s / unit));
        let held = |energy: &[f64; OCTAVES], axis: usize| -> f64 {
            energy.iter().zip(&slope_per_energy).map(|(e, s)| e * s[axis]).sum()
        };
        // Where the noise is rougher than the waves whose energy it takes, energy moves to the longest octave.
        for octave in (1..OCTAVES).rev() {
            let excess = |axis: usize| {
                let gain = slope_per_energy[octave][axis] - slope_per_energy[0][axis];
                (held(&energy, axis) - STEEPEST_SHARE * slopes[axis]) / gain
            };
            let moved = excess(0).max(excess(1)).clamp(0.0, energy[octave]);
            energy[octave] -= moved;
            energy[0] += moved;
        }
        let own = [0, 1].map(|axis| held(&energy, axis));
        Self {
            patch_m,
            amplitudes_m: energy.map(|e| libm::sqrt(e / unit)),
            slopes: own,
            rough: [0, 1].map(|axis| (slopes[axis] - own[axis]).max(0.0)),
        }
    }
}

/// φ(t).
fn weight(t: f64) -> f64 {
    let t = t.abs().min(1.0);
    1.0 - t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// ⟨n(p) n(p + (shift, 0))⟩ of the unit noise, in cells, averaged over p.
fn covariance(shift: f64) -> f64 {
    const STEPS: usize = 32;
    let mut sum = 0.0;
    for (i, j) in (0..STEPS * STEPS).map(|s| (s % STEPS, s / STEPS)) {
        let at = |k: usize| (k as f64 + 0.5) / STEPS as f64;
        let (x, y) = (at(i), at(j));
        // Lattice points that both p and its neighbour, less than two cells away, may see.
        for (cx, cy) in (-1..=3).flat_map(|cx| [(f64::from(cx), 0.0), (f64::from(cx), 1.0)]) {
            let (dx, dy, ex) = (x - cx, y - cy, x + shift - cx);
            sum += 0.5 * weight(dx) * weight(ex) * weight(dy) * weight(dy) * (dx * ex + dy * dy);
        }
    }
    sum / (STEPS * STEPS) as f64
}

/// Variance of the unit noise, averaged over a lattice cell.
pub fn variance() -> f64 {
    covariance(0.0)
}

/// Slope variance of an octave of unit amplitude along the wind and across it, as central differences of neighbouring texels
/// give it, averaged over a cell; per metre.
pub fn slope_variance(patch_m: f64, octave: usize) -> [f64; 2] {
    [PEAK_CELLS << octave, (PEAK_CELLS << octave) / 2].map(|cells| {
        // Two texels in cells, and in metres.
        let (apart, metres) = (2.0 * cells as f64 / TEXELS as f64, 2.0 * patch_m / TEXELS as f64);
        2.0 * (variance() - covariance(apart)) / (metres * metres)
    })
}
