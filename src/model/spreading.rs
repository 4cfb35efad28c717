//! How the energy of a frequency is spread over directions.
//!
//! D(θ), 1/rad, with ∫ D dθ = 1 over the full circle and θ from the direction the waves travel to on average. A direction is given
//! by its cosine and sine, a frequency by x = ω/ω_p.

use std::f64::consts::{PI, TAU};

/// A spread over directions that may depend on the frequency.
pub trait Spreading {
    /// D at frequency `x` = ω/ω_p in the direction (`cos`, `sin`), 1/rad; finite and at least 0.
    fn density(&self, x: f64, cos: f64, sin: f64) -> f64;
}

/// D = Q cos^2s(θ/2), Q = 2^(2s−1) Γ(s+1)²/(π Γ(2s+1)), the same at every frequency
/// ([Longuet-Higgins, Cartwright and Smith](crate::bibliography::LonguetHiggins1963)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cos2s {
    s: f64,
    q: f64,
}

impl Cos2s {
    /// With exponent `s`; below 0 or not a number counts as 0, all directions alike.
    pub fn new(s: f64) -> Self {
        let s = s.max(0.0);
        Self { s, q: cos_2s_factor(s) }
    }
}

impl Spreading for Cos2s {
    fn density(&self, _x: f64, cos: f64, _sin: f64) -> f64 {
        cos_2s(self.s, self.q, cos)
    }
}

/// Q. The gamma functions pass f64's range at s = 85, their logarithms never.
fn cos_2s_factor(s: f64) -> f64 {
    let ln = 2.0 * libm::lgamma(s + 1.0) - libm::lgamma(2.0 * s + 1.0);
    libm::exp((2.0 * s - 1.0) * std::f64::consts::LN_2 + ln) / PI
}

/// Q cos^2s(θ/2), with cos²(θ/2) = (1 + cos θ)/2.
fn cos_2s(s: f64, q: f64, cos: f64) -> f64 {
    q * libm::pow((0.5 + 0.5 * cos).clamp(0.0, 1.0), s)
}

/// [Donelan's](crate::bibliography::Donelan1985) D = β/(2 tanh βπ) sech²(βθ), β = 2.61 x^1.3 below x = 0.95 and 2.28 x^−1.3 below
/// 1.6; beyond, [Banner's](crate::bibliography::Banner1990) β = 10^(−0.4 + 0.8393 exp(−0.567 ln x²)). Narrowest at the peak, and
/// closed in form: what the seas are drawn with.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct DonelanBanner;

impl DonelanBanner {
    /// β at a frequency.
    pub fn beta(x: f64) -> f64 {
        // Banner's exp(−0.567 ln x²) = x^−1.134, and 10^y = exp(y ln 10).
        if x < 0.95 {
            2.61 * libm::pow(x.max(0.0), 1.3)
        } else if x < 1.6 {
            2.28 * libm::pow(x, -1.3)
        } else {
            libm::exp(std::f64::consts::LN_10 * (-0.4 + 0.8393 * libm::pow(x, -1.134)))
        }
    }
}

impl Spreading for DonelanBanner {
    fn density(&self, x: f64, cos: f64, sin: f64) -> f64 {
        let beta = Self::beta(x);
        // β/tanh(βπ) tends to 1/π.
        if beta < 1e-8 {
            return 1.0 / TAU;
        }
        let e = libm::exp(-2.0 * beta * libm::fabs(libm::atan2(sin, cos)));
        // sech² y = 4 e^−2y/(1 + e^−2y)²; tanh βπ = (1 − e^−2βπ)/(1 + e^−2βπ).
        let end = libm::exp(-TAU * beta);
        0.5 * beta * (1.0 + end) / (1.0 - end) * 4.0 * e / ((1.0 + e) * (1.0 + e))
    }
}

/// The share of a wave and its opposite that travels in the direction with cosine `cos` to the wind, for spectra that do not tell the
/// two apart: t² (3 − 2t), t = (1 + cos θ)/2. It and that of the opposite direction add up to 1.
pub fn downwind_share(cos: f64) -> f64 {
    let t = (0.5 + 0.5 * cos).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
