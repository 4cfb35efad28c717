//! Phillips' spectrum as renderers use it, with a true height and true slopes.

use super::{DirectionalSpectrum, K_CALM, K_SHORTEST, TAIL_EXPONENTS, TAIL_START};
use crate::model::{optics, quadrature::simpson_log};

/// [Phillips'](crate::bibliography::Phillips1958) equilibrium range with the cut-off renderers know from
/// [Tessendorf](crate::bibliography::Tessendorf2001), an amplitude that gives a wanted height, and a slope-true tail:
///
/// F = A k⁻⁴ exp(−1/(kL)²) D(k, θ) · upwind(θ) · exp(−k²ℓ²) · tail(k)
///
/// * L puts the frequency spectrum's peak where it is wanted. A height on too short a wave would be steeper than water stands, so L
///   grows until the waves below 10 kp hold no more than [`STEEPEST_SHARE`] of the slopes that Cox and Munk measured.
/// * upwind = 1 for kx > 0, else the given share (0: nothing runs against the wind).
/// * tail = 1 up to 10 kp and (k/10kp)^q beyond, with q such that ∫∫ k²F = [Cox and Munk's](crate::bibliography::CoxMunk1954)
///   mean square slope; q = 1/2 would be [Toba's](crate::bibliography::Toba1973) k⁻³·⁵. q stays in [`TAIL_EXPONENTS`].
/// * D = cos²θ up to 10 kp; beyond, ever more waves run every way before the wind alike, (10kp/k) cos²θ + (1 − 10kp/k)/2: with cos²θ
///   alone the slopes along the wind would be three times those across, where Cox and Munk measured 1.3 times.
/// * A from Hs by the integral of all of this; without ℓ and tail it is Hs²/(4πL²) (downwind half) or Hs²/(8πL²) (both).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phillips {
    /// Amplitude A, dimensionless; 0 for a calm.
    pub a: f64,
    /// Length L of the cut-off, m.
    pub l: f64,
    /// Length ℓ of the small-wave damping, m; 0 for none.
    pub damping_m: f64,
    /// Energy of waves against the wind per energy of waves with it, 0…1.
    pub upwind: f64,
    /// Wave number from which the tail factor applies, rad/m.
    pub k_tail: f64,
    /// Exponent q of the tail factor.
    pub tail: f64,
}

/// Most of the slope variance that waves up to 10 kp may hold.
pub const STEEPEST_SHARE: f64 = 0.8;
/// Default damping ℓ, m: takes out waves shorter than about 6 mm, where water's viscosity does.
pub const DAMPING_M: f64 = 1e-3;
/// The frequency spectrum of k⁻³ exp(−1/(kL)²) peaks at ω⁴ = (4/5) g²/L², so at kL = sqrt(4/5).
const PEAK_KL: f64 = 0.894_427_190_999_915_9;
/// ∫ k⁻¹ exp(−1/(kL)²) dk from 0 to 10 kp = E₁(1/80)/2, the slope integral below the tail.
const SLOPE_INTEGRAL_TO_TAIL: f64 = 1.908_636_007_762_743_8;

impl Phillips {
    /// No waves.
    pub const CALM: Self = Self { a: 0.0, l: 0.0, damping_m: DAMPING_M, upwind: 0.0, k_tail: 0.0, tail: 0.0 };

    /// The sea at wind speed `speed_mps` with significant height `hs_m`, m: slope-true, nothing against the wind, the frequency
    /// spectrum's peak at wave number `peak` (rad/m) where that is not too steep for the wind's slopes.
    /// What is not positive and finite counts as a calm.
    pub fn new(speed_mps: f64, hs_m: f64, peak: f64) -> Self {
        let usable = |x: f64| x.is_finite() && x > 0.0;
        if ![speed_mps, hs_m, peak].into_iter().all(usable) {
            return Self::CALM;
        }
        let (hs, mss) = (hs_m, optics::cox_munk_mss(speed_mps).total);
        // Without a tail mss(<10kp) = Hs²/(8 L²) · SLOPE_INTEGRAL_TO_TAIL.
        let least_l = hs * libm::sqrt(SLOPE_INTEGRAL_TO_TAIL / (8.0 * STEEPEST_SHARE * mss));
        let l = (PEAK_KL / peak).max(least_l);
        if l.is_nan() || PEAK_KL / l >= K_CALM {
            return Self::CALM;
        }
        let k_tail = TAIL_START * PEAK_KL / l;
        let mut sea = Self { a: 1.0, l, damping_m: DAMPING_M, upwind: 0.0, k_tail, tail: 0.0 };
        let wanted = mss / (hs * hs / 16.0);
        let (mut low, mut high) = TAIL_EXPONENTS;
        // Slope per variance grows with q; 40 halvings leave 1e-11 of the range.
        for _ in 0..40 {
            sea.tail = 0.5 * (low + high);
            let (variance, slopes) = sea.moments();
            if slopes < wanted * variance { low = sea.tail } else { high = sea.tail }
        }
        sea.scaled_to(hs)
    }

    /// The textbook form: exactly the given L (m), damping ℓ (m, 0 for none), upwind share, no tail factor, scaled to `hs_m`.
    pub fn plain(l: f64, damping_m: f64, upwind: f64, hs_m: f64) -> Self {
        Self { a: 1.0, l, damping_m, upwind, k_tail: f64::INFINITY, tail: 0.0 }.scaled_to(hs_m)
    }

    fn scaled_to(self, hs_m: f64) -> Self {
        let (variance, _) = self.moments();
        Self { a: self.a * hs_m * hs_m / 16.0 / variance, ..self }
    }

    /// Variance and mean square slope at the present amplitude.
    fn moments(&self) -> (f64, f64) {
        let (k0, k1) = (0.1 / self.l, K_SHORTEST);
        let variance = |k: f64| self.omnidirectional(k);
        // exp(−100) below k0; the tail's kink sits on a boundary, so Simpson keeps its order.
        let split = self.k_tail.clamp(k0, k1);
        let sum = |f: &dyn Fn(f64) -> f64| simpson_log(k0, split, 256, f) + simpson_log(split, k1, 256, f);
        (sum(&variance), sum(&|k| k * k * variance(k)))
    }

    /// A k⁻⁴ exp(−1/(kL)²) exp(−k²ℓ²) tail(k): F without its direction, m⁴.
    fn radial(&self, k: f64) -> f64 {
        if !(self.a > 0.0 && k > 0.0) {
            return 0.0;
        }
        let (kl, kd) = (k * self.l, k * self.damping_m);
        let tail = if k > self.k_tail { libm::pow(k / self.k_tail, self.tail) } else { 1.0 };
        let k2 = k * k;
        let f = self.a * libm::exp(-1.0 / (kl * kl) - kd * kd) * tail / (k2 * k2);
        // Near k = 0 the exponential underflows to 0 while k⁻⁴ overflows: that is no energy, not NaN.
        if f.is_finite() { f } else { 0.0 }
    }
}

impl DirectionalSpectrum for Phillips {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        let k2 = kx * kx + ky * ky;
        if !(k2 > 0.0 && k2.is_finite()) {
            return 0.0;
        }
        let side = if kx > 0.0 { 1.0 } else { self.upwind };
        let k = libm::sqrt(k2);
        // Share of the waves that run every way before the wind alike; both forms hold π/2 of a half circle.
        let even = if k > self.k_tail { 1.0 - self.k_tail / k } else { 0.0 };
        self.radial(k) * ((1.0 - even) * (kx * kx / k2) + 0.5 * even) * side
    }

    fn peak_wavenumber(&self) -> f64 {
        if self.a > 0.0 { PEAK_KL / self.l } else { 0.0 }
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        // ∫cos² over each half circle is π/2.
        self.radial(k) * k * std::f64::consts::FRAC_PI_2 * (1.0 + self.upwind)
    }
}
