//! The growing sea over a shelf.

use super::{FrequencySpectrum, Jonswap, frequency::group_ratio};
use crate::model::{GRAVITY, dispersion};

/// [TMA](crate::bibliography::Bouws1985): a JONSWAP sea that has run onto water of a depth h. Its energy is
/// [Kitaigorodskii's](crate::bibliography::Kitaigorodskii1975) share of the deep sea's, the one that keeps F(k) ∝ k⁻⁴:
///
/// S = S_JONSWAP φ, φ = tanh²(kh)/(1 + 2kh/sinh 2kh), with the exact k(ω, h).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tma {
    /// The sea before the shelf.
    pub deep: Jonswap,
    depth_m: f64,
    peak: f64,
}

impl Tma {
    /// A sea over water of `depth_m`, m, positive.
    pub fn new(deep: Jonswap, depth_m: f64) -> Self {
        let mut sea = Self { deep, depth_m, peak: deep.omega_p };
        // φ rises with ω at most like ω², which moves the peak up by at most 3 % for γ = 3.3 and 15 % for γ = 1.
        let (mut low, mut high) = (deep.omega_p, 1.2 * deep.omega_p);
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        for _ in 0..24 {
            let (a, b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
            if sea.density(a) < sea.density(b) { low = a } else { high = b }
        }
        sea.peak = 0.5 * (low + high);
        sea
    }

    /// φ of a wave number in rad/m over a depth in metres: 0 in no water, 1 in deep water.
    pub fn share(k: f64, depth_m: f64) -> f64 {
        let kh = k * depth_m;
        if kh.is_nan() || kh <= 0.0 {
            return 0.0;
        }
        Self::share_of(kh, libm::tanh(kh))
    }

    fn share_of(kh: f64, tanh: f64) -> f64 {
        // To the last bit, and most waves are shorter than that.
        if kh > 20.0 {
            return 1.0;
        }
        tanh * tanh / (2.0 * group_ratio(kh, tanh))
    }
}

impl FrequencySpectrum for Tma {
    fn density(&self, omega: f64) -> f64 {
        self.density_of_wave(omega, dispersion::wavenumber(omega, self.depth_m))
    }

    fn peak_frequency(&self) -> f64 {
        self.peak
    }

    fn depth_m(&self) -> f64 {
        self.depth_m
    }

    fn density_of_wave(&self, omega: f64, k: f64) -> f64 {
        if k.is_nan() || k <= 0.0 {
            return 0.0;
        }
        // The dispersion has it: tanh kh = ω²/(g k).
        self.deep.density(omega) * Self::share_of(k * self.depth_m, omega * omega / (GRAVITY * k))
    }
}
