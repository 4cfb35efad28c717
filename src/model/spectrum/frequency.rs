//! Frequency spectra, and how they come to the wave-number plane.

use super::DirectionalSpectrum;
use crate::model::{GRAVITY, dispersion, quadrature::simpson_log, spreading::Spreading};

/// A sea's energy over angular frequencies, as its source measured it.
pub trait FrequencySpectrum {
    /// S(ω), m²·s, one-sided: ∫₀^∞ S dω = m0. Finite and at least 0 for every ω; 0 for ω ≤ 0. S(f) = 2π S(ω).
    fn density(&self, omega: f64) -> f64;

    /// ω of the highest point, rad/s.
    fn peak_frequency(&self) -> f64;

    /// Depth of the water under these waves, m; infinite if the spectrum knows none.
    fn depth_m(&self) -> f64 {
        f64::INFINITY
    }

    /// S where the wave number `k` (rad/m) of `omega` is known already: spares the dispersion's inverse.
    fn density_of_wave(&self, omega: f64, _k: f64) -> f64 {
        self.density(omega)
    }

    /// m_n = ∫ ωⁿ S dω, m²/sⁿ, for n from −1 to 2. What is cut off, above 10⁵ ω_p, is 1e-10 of m2 in an ω⁻⁵ tail.
    fn moment(&self, n: i32) -> f64 {
        let p = self.peak_frequency();
        let part = |omega: f64| libm::pow(omega, f64::from(n)) * self.density(omega);
        // Nothing lies below 0.3 ω_p: exp(−154). A JONSWAP peak has its kink on a boundary and 18 steps per σ.
        [(0.3, 1.0, 320), (1.0, 3.0, 280), (3.0, 1e5, 1200)]
            .map(|(from, to, intervals)| simpson_log(from * p, to * p, intervals, part))
            .iter()
            .sum()
    }
}

/// A frequency spectrum on the plane: F = S(ω) D(θ; ω/ω_p) (dω/dk)/k, ω and the group velocity dω/dk those of gravity waves over
/// the spectrum's own depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Directed<F, D> {
    /// Energy over frequencies.
    pub frequency: F,
    /// Its spread over directions.
    pub spreading: D,
}

impl<F: FrequencySpectrum, D: Spreading> Directed<F, D> {
    /// ω, rad/s, and S dω/dk, m³, of a wave number.
    fn ring(&self, k: f64) -> (f64, f64) {
        let depth = self.frequency.depth_m();
        // From kh = 20 on, tanh and n are those of deep water to the last bit.
        let (omega, group) = if k * depth < 20.0 {
            let (kh, tanh) = (k * depth, libm::tanh(k * depth));
            let omega = libm::sqrt(GRAVITY * k * tanh);
            (omega, group_ratio(kh, tanh) * omega / k)
        } else {
            let omega = dispersion::omega_deep(k);
            (omega, 0.5 * GRAVITY / omega)
        };
        let variance = self.frequency.density_of_wave(omega, k) * group;
        (omega, if variance.is_finite() { variance } else { 0.0 })
    }
}

/// n = cg/c from kh and its tanh t: sinh 2kh = 2t/(1 − t²). As exact as [`dispersion::group_ratio`], and cheaper.
pub(super) fn group_ratio(kh: f64, tanh: f64) -> f64 {
    0.5 * (1.0 + kh * (1.0 - tanh * tanh) / tanh)
}

impl<F: FrequencySpectrum, D: Spreading> DirectionalSpectrum for Directed<F, D> {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        let k = libm::sqrt(kx * kx + ky * ky);
        if !(k > 0.0 && k.is_finite()) {
            return 0.0;
        }
        let (omega, variance) = self.ring(k);
        // Far below the peak nothing is left, and k⁻¹ could overflow.
        if variance <= f64::MIN_POSITIVE {
            return 0.0;
        }
        variance / k * self.spreading.density(omega / self.frequency.peak_frequency(), kx / k, ky / k)
    }

    fn peak_wavenumber(&self) -> f64 {
        dispersion::wavenumber(self.frequency.peak_frequency(), self.frequency.depth_m())
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        if k > 0.0 && k.is_finite() { self.ring(k).1 } else { 0.0 }
    }

    fn peak_period(&self) -> f64 {
        let p = self.frequency.peak_frequency();
        if p > 0.0 { std::f64::consts::TAU / p } else { 0.0 }
    }
}
