//! The fully grown sea.

use super::FrequencySpectrum;
use crate::model::GRAVITY;

/// [Pierson and Moskowitz's](crate::bibliography::PiersonMoskowitz1964) sea, grown to its end under one wind:
///
/// S = α g² ω⁻⁵ exp(−β (ω₀/ω)⁴), ω₀ = g/U, α = 0.0081, β = 0.74, with U at 19.5 m above the sea.
///
/// β belongs to ω₀; counted from the peak ω_p = (4β/5)^¼ ω₀ the factor is 5/4. m0 = α U⁴/(4 β g²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PiersonMoskowitz {
    /// Wind speed at 19.5 m, m/s.
    pub speed_19_5: f64,
}

impl PiersonMoskowitz {
    /// α.
    pub const ALPHA: f64 = 0.0081;
    /// β.
    pub const BETA: f64 = 0.74;
    /// (4β/5)^¼ = ω_p/ω₀.
    const PEAK: f64 = 0.877_163_247_330_195_6;

    /// The sea of significant height `hs_m`, m: under the wind that grows no higher one.
    pub fn from_height(hs_m: f64) -> Self {
        let m0 = hs_m * hs_m / 16.0;
        let u2 = libm::sqrt(4.0 * Self::BETA * m0 / Self::ALPHA) * GRAVITY;
        Self { speed_19_5: libm::sqrt(u2) }
    }

    /// The sea whose peak is at the angular frequency `omega_p`, rad/s, positive.
    pub fn from_peak(omega_p: f64) -> Self {
        Self { speed_19_5: Self::PEAK * GRAVITY / omega_p }
    }

    /// Significant height in closed form, m.
    pub fn height(&self) -> f64 {
        let u2 = self.speed_19_5 * self.speed_19_5;
        4.0 * libm::sqrt(Self::ALPHA / (4.0 * Self::BETA)) * u2 / GRAVITY
    }
}

impl FrequencySpectrum for PiersonMoskowitz {
    fn density(&self, omega: f64) -> f64 {
        if !(omega > 0.0 && self.speed_19_5 > 0.0) {
            return 0.0;
        }
        let ratio_2 = (GRAVITY / (self.speed_19_5 * omega)) * (GRAVITY / (self.speed_19_5 * omega));
        let s = Self::ALPHA * GRAVITY * GRAVITY * libm::exp(-Self::BETA * ratio_2 * ratio_2) / fifth_power(omega);
        // Near ω = 0 the exponential underflows while ω⁻⁵ overflows.
        if s.is_finite() { s } else { 0.0 }
    }

    fn peak_frequency(&self) -> f64 {
        if self.speed_19_5 > 0.0 { Self::PEAK * GRAVITY / self.speed_19_5 } else { 0.0 }
    }
}

/// x⁵.
pub(super) fn fifth_power(x: f64) -> f64 {
    let x2 = x * x;
    x2 * x2 * x
}
