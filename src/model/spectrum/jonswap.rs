//! The sea that grows with fetch.

use super::{FrequencySpectrum, pierson_moskowitz::fifth_power};
use crate::model::GRAVITY;

/// A sea can grow no further once its peak's waves are this much slower than the wind: ν = f_p U₁₀/g stays at or above 0.13, where
/// the [JONSWAP](crate::bibliography::Hasselmann1973) growth curves meet Pierson and Moskowitz's sea.
pub const SMALLEST_PEAK_SPEED: f64 = 0.13;
/// I₀(3.3) of m0 = α g² ω_p⁻⁴ I₀(γ), by quadrature.
const I0: f64 = 0.304_989_721_934_257_44;

/// [JONSWAP](crate::bibliography::Hasselmann1973): a growing sea with a sharp peak,
///
/// S = α g² ω⁻⁵ exp(−5/4 (ω_p/ω)⁴) γ^r, r = exp(−(ω − ω_p)²/(2 σ² ω_p²)), σ = 0.07 up to ω_p and 0.09 beyond;
///
/// with χ = g F/U₁₀² (F the fetch in metres): α = 0.076 χ^−0.22, ω_p = 22 (g²/(U₁₀ F))^⅓ = 22 (g/U₁₀) χ^−⅓, γ = 3.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jonswap {
    /// α, dimensionless.
    pub alpha: f64,
    /// Peak, rad/s.
    pub omega_p: f64,
    /// ln γ.
    ln_gamma: f64,
}

impl Jonswap {
    /// γ of the mean of the JONSWAP measurements.
    pub const GAMMA: f64 = 3.3;

    /// The shape with these parameters; γ at least 1 (which is Pierson and Moskowitz's shape).
    pub fn new(alpha: f64, omega_p: f64, gamma: f64) -> Self {
        Self { alpha, omega_p, ln_gamma: libm::log(gamma.max(1.0)) }
    }

    /// The sea of a wind in m/s at 10 m over a fetch in *metres*, both positive, however long the fetch.
    pub fn from_fetch(u10: f64, fetch_m: f64) -> Self {
        Self::from_dimensionless_fetch(u10, GRAVITY * fetch_m / (u10 * u10))
    }

    /// The sea of significant height `hs_m`, m, with its peak at the period `peak_s`, s, both positive: α = m0 ω_p⁴/(g² I₀).
    pub fn from_height(hs_m: f64, peak_s: f64) -> Self {
        let omega_p = std::f64::consts::TAU / peak_s;
        let root = hs_m / 4.0 * omega_p * omega_p / GRAVITY;
        Self::new(root * root / I0, omega_p, Self::GAMMA)
    }

    /// The longest fetch over which a wind's sea still grows, m: where ν has come down to [`SMALLEST_PEAK_SPEED`].
    pub fn longest_fetch(u10: f64) -> f64 {
        let cube_root = 22.0 / (std::f64::consts::TAU * SMALLEST_PEAK_SPEED);
        cube_root * cube_root * cube_root * u10 * u10 / GRAVITY
    }

    /// Significant height in closed form, m; for γ = 3.3.
    pub fn height(&self) -> f64 {
        4.0 * libm::sqrt(self.alpha * I0) * GRAVITY / (self.omega_p * self.omega_p)
    }

    /// γ.
    pub fn gamma(&self) -> f64 {
        libm::exp(self.ln_gamma)
    }

    fn from_dimensionless_fetch(u10: f64, chi: f64) -> Self {
        let omega_p = 22.0 * GRAVITY / u10 / libm::cbrt(chi);
        Self::new(0.076 * libm::pow(chi, -0.22), omega_p, Self::GAMMA)
    }
}

impl FrequencySpectrum for Jonswap {
    fn density(&self, omega: f64) -> f64 {
        if !(omega > 0.0 && self.omega_p > 0.0) {
            return 0.0;
        }
        let ratio_2 = (self.omega_p / omega) * (self.omega_p / omega);
        let sigma = if omega <= self.omega_p { 0.07 } else { 0.09 };
        let off = (omega / self.omega_p - 1.0) / sigma;
        // Nine widths away it is below the last bit of what it is added to, and most waves are.
        let peak = if off.abs() < 9.0 { self.ln_gamma * libm::exp(-0.5 * off * off) } else { 0.0 };
        let s = self.alpha * GRAVITY * GRAVITY * libm::exp(peak - 1.25 * ratio_2 * ratio_2) / fifth_power(omega);
        // Near ω = 0 the exponential underflows while ω⁻⁵ overflows.
        if s.is_finite() { s } else { 0.0 }
    }

    fn peak_frequency(&self) -> f64 {
        self.omega_p
    }
}
