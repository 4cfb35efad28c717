//! The sea of `oracles/fft.json`: JONSWAP at 10 m/s over 100 km, gamma 3.3, cos^2s with s = 6 towards +x, deep water.

use std::f64::consts::PI;

use ocean_globe::model::spectrum::DirectionalSpectrum;
use ocean_globe::model::{GRAVITY, dispersion};

pub struct OracleSea;

impl OracleSea {
    pub fn peak_omega() -> f64 {
        22.0 * (GRAVITY * GRAVITY / (10.0 * 1e5)).cbrt()
    }

    /// S(omega), m² s, one-sided.
    pub fn frequency(omega: f64) -> f64 {
        let peak = Self::peak_omega();
        let alpha = 0.076 * (GRAVITY * 1e5 / 100.0f64).powf(-0.22);
        let sigma = if omega <= peak { 0.07 } else { 0.09 };
        let r = (-(omega - peak).powi(2) / (2.0 * sigma * sigma * peak * peak)).exp();
        alpha * GRAVITY * GRAVITY / omega.powi(5) * (-1.25 * (peak / omega).powi(4)).exp() * 3.3f64.powf(r)
    }

    /// D(theta), per radian: 2^11 6!² / (pi 12!) cos^12(theta/2).
    pub fn spreading(theta: f64) -> f64 {
        2048.0 * 720.0 * 720.0 / (PI * 479_001_600.0) * (theta / 2.0).cos().powi(12)
    }
}

impl DirectionalSpectrum for OracleSea {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        let k = kx.hypot(ky);
        if k < 1e-6 {
            return 0.0;
        }
        let omega = dispersion::omega_deep(k);
        Self::frequency(omega) * Self::spreading(ky.atan2(kx)) * GRAVITY / (2.0 * omega) / k
    }

    fn peak_wavenumber(&self) -> f64 {
        Self::peak_omega().powi(2) / GRAVITY
    }
}
