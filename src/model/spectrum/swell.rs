//! Waves of a far storm.

use super::{Directed, DirectionalSpectrum, FrequencySpectrum, Jonswap};
use crate::model::{dispersion, quadrature::simpson_log, spreading::Cos2s};

/// γ of a swell's peak: dispersion has sorted the waves on their way, so that it is narrower than any wind sea's
/// ([Goda](crate::bibliography::Goda2010) advises 3…10).
pub const SWELL_GAMMA: f64 = 7.0;
/// s of a swell's cos^2s spread: [Goda's](crate::bibliography::Goda2010) 75 for a swell from far away, ±9° about its mean.
pub const SWELL_S: f64 = 75.0;
/// The swell has left its short waves behind: beyond kp its energy falls like exp(−((k − kp)/(3kp))²).
const CUT: f64 = 3.0;
/// No energy at or beyond this many peak wave numbers: exp(−25) of it. Nor below 0.04 of them: exp(−781).
const END: f64 = 16.0;

/// The frequency spectrum of a swell: a JONSWAP peak without its tail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SwellPeak {
    jonswap: Jonswap,
    depth_m: f64,
}

impl FrequencySpectrum for SwellPeak {
    fn density(&self, omega: f64) -> f64 {
        let x = omega / self.jonswap.omega_p;
        let k = x * x;
        if !(k > 0.04 && k < END) {
            return 0.0;
        }
        let short = (k - 1.0).max(0.0) / CUT;
        self.jonswap.density(omega) * libm::exp(-short * short)
    }

    fn peak_frequency(&self) -> f64 {
        self.jonswap.omega_p
    }

    fn depth_m(&self) -> f64 {
        self.depth_m
    }
}

/// A swell on the plane, its energy to be added to the wind sea's. Its height is that of the place, whatever the depth there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SwellTrain {
    waves: Directed<SwellPeak, Cos2s>,
    /// Direction of travel as (cos, sin) in the frame of the spectra.
    toward: (f64, f64),
    /// Square of the wave number from which there is no energy: spares most of a grid the rest.
    end_2: f64,
}

impl SwellTrain {
    /// A swell of significant height `height_m` (m) and peak period `period_s` (s) over water of `depth_m` (m, or infinite), that
    /// travels TO the angle `toward` (radians, counter-clockwise from downwind). `None` without height or period.
    pub fn new(height_m: f64, period_s: f64, toward: f64, depth_m: f64) -> Option<Self> {
        let usable = |x: f64| x.is_finite() && x > 0.0;
        if !(usable(height_m) && usable(period_s) && toward.is_finite()) {
            return None;
        }
        let omega_p = std::f64::consts::TAU / period_s;
        let unit = SwellPeak { jonswap: Jonswap::new(1.0, omega_p, SWELL_GAMMA), depth_m };
        let part = |from: f64, to: f64| simpson_log(from * omega_p, to * omega_p, 128, |omega| unit.density(omega));
        // The peak's kink stands on a boundary.
        let m0 = part(0.21, 1.0) + part(1.0, 3.99);
        let alpha = height_m * height_m / 16.0 / m0;
        let frequency = SwellPeak { jonswap: Jonswap::new(alpha, omega_p, SWELL_GAMMA), depth_m };
        let (sin, cos) = libm::sincos(toward);
        let end = dispersion::wavenumber(libm::sqrt(END) * omega_p, depth_m);
        let waves = Directed { frequency, spreading: Cos2s::new(SWELL_S) };
        Some(Self { waves, toward: (cos, sin), end_2: end * end })
    }
}

impl DirectionalSpectrum for SwellTrain {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        if kx * kx + ky * ky > self.end_2 {
            return 0.0;
        }
        let (cos, sin) = self.toward;
        self.waves.density(cos * kx + sin * ky, cos * ky - sin * kx)
    }

    fn peak_wavenumber(&self) -> f64 {
        self.waves.peak_wavenumber()
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        self.waves.omnidirectional(k)
    }

    fn peak_period(&self) -> f64 {
        self.waves.peak_period()
    }
}
