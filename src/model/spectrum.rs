//! How the energy of the sea is spread over wave numbers.
//!
//! Conventions: F(kx, ky) in m⁴ is a density over the *whole* plane, with its energy at the k the wave travels towards and x
//! downwind; ∫∫ F d²k = m0 = Hs²/16. Each spectrum is a [`DirectionalSpectrum`], so that others join beside [`Phillips`]
//! without a change to what consumes them.

use super::{GRAVITY, dispersion, optics, quadrature::simpson_log};

/// Integrals over all waves run from waves of 600 km to waves of 1.6 mm, rad/m; no sea has energy outside.
const K_LONGEST: f64 = 1e-5;
const K_SHORTEST: f64 = 4e3;

/// A sea's energy over the wave-number plane. All of it depends on the sea alone, never on a grid.
pub trait DirectionalSpectrum {
    /// F(kx, ky), m⁴; x is downwind. Finite and at least 0 for every finite argument, 0 at the origin and for a calm.
    fn density(&self, kx: f64, ky: f64) -> f64;

    /// The wave number of the frequency spectrum's peak, rad/m; 0 for a calm.
    fn peak_wavenumber(&self) -> f64;

    /// ∫ F k dθ, m³: variance per wave number.
    fn omnidirectional(&self, k: f64) -> f64 {
        const ANGLES: usize = 128;
        let step = std::f64::consts::TAU / ANGLES as f64;
        let ring = (0..ANGLES).map(|i| {
            let (sin, cos) = libm::sincos(step * i as f64);
            self.density(k * cos, k * sin)
        });
        ring.sum::<f64>() * step * k
    }

    /// Variance of the surface from waves in [k0, k1), m².
    fn variance_between(&self, k0: f64, k1: f64) -> f64 {
        simpson_log(k0.max(K_LONGEST), k1.min(K_SHORTEST), 1024, |k| self.omnidirectional(k))
    }

    /// Mean square slope (both axes together) from waves in [k0, k1).
    fn mss_between(&self, k0: f64, k1: f64) -> f64 {
        simpson_log(k0.max(K_LONGEST), k1.min(K_SHORTEST), 1024, |k| k * k * self.omnidirectional(k))
    }

    /// Mean square slope of the waves at or beyond wave number `k`: what a grid that ends at `k` leaves to the glitter.
    fn mss_above(&self, k: f64) -> f64 {
        self.mss_between(k, f64::INFINITY)
    }

    /// Significant height Hs = 4 sqrt(m0), m, by integration.
    fn significant_height(&self) -> f64 {
        4.0 * libm::sqrt(self.variance_between(0.0, f64::INFINITY))
    }

    /// Period of the peak, s; 0 for a calm.
    fn peak_period(&self) -> f64 {
        let k = self.peak_wavenumber();
        if k > 0.0 { std::f64::consts::TAU / dispersion::omega_deep(k) } else { 0.0 }
    }
}

/// [Phillips'](crate::bibliography::Phillips1958) equilibrium range with the cut-off renderers know from
/// [Tessendorf](crate::bibliography::Tessendorf2001), an amplitude that gives a wanted height, and a slope-true tail:
///
/// F = A k⁻⁴ exp(−1/(kL)²) cos²θ · upwind(θ) · exp(−k²ℓ²) · tail(k)
///
/// * L = U²/g. In light winds the table's height on so short a wave would be steeper than water stands, so L grows until the
///   waves below 10 kp hold no more than [`STEEPEST_SHARE`] of the slopes that Cox and Munk measured.
/// * upwind = 1 for kx > 0, else the given share (0: nothing runs against the wind).
/// * tail = 1 up to 10 kp and (k/10kp)^q beyond, with q such that ∫∫ k²F = [Cox and Munk's](crate::bibliography::CoxMunk1954)
///   mean square slope; q = 1/2 would be [Toba's](crate::bibliography::Toba1973) k⁻³·⁵. q stays in [`TAIL_EXPONENTS`].
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
/// Range of the tail exponent q: from nearly no tail to a bit above Toba's.
pub const TAIL_EXPONENTS: (f64, f64) = (-8.0, 0.75);
/// Default damping ℓ, m: takes out waves shorter than about 6 mm, where water's viscosity does.
pub const DAMPING_M: f64 = 1e-3;
/// The frequency spectrum of k⁻³ exp(−1/(kL)²) peaks at ω⁴ = (4/5) g²/L², so at kL = sqrt(4/5).
const PEAK_KL: f64 = 0.894_427_190_999_915_9;
/// ∫ k⁻¹ exp(−1/(kL)²) dk from 0 to 10 kp = E₁(1/80)/2, the slope integral below the tail.
const SLOPE_INTEGRAL_TO_TAIL: f64 = 1.908_636_007_762_743_8;

impl Phillips {
    /// The sea at wind speed `speed_mps` with significant height `hs_m`: slope-true, nothing against the wind.
    /// Speeds and heights that are negative or not finite count as a calm.
    pub fn new(speed_mps: f64, hs_m: f64) -> Self {
        let usable = |x: f64| if x.is_finite() { x.max(0.0) } else { 0.0 };
        let (speed, hs) = (usable(speed_mps), usable(hs_m));
        if speed == 0.0 || hs == 0.0 {
            return Self { a: 0.0, l: 0.0, damping_m: DAMPING_M, upwind: 0.0, k_tail: 0.0, tail: 0.0 };
        }
        let mss = optics::cox_munk_mss(speed).total;
        // Without a tail mss(<10kp) = Hs²/(8 L²) · SLOPE_INTEGRAL_TO_TAIL.
        let least_l = hs * libm::sqrt(SLOPE_INTEGRAL_TO_TAIL / (8.0 * STEEPEST_SHARE * mss));
        let l = (speed * speed / GRAVITY).max(least_l);
        let k_tail = 10.0 * PEAK_KL / l;
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
        if k2 <= 0.0 || k2.is_nan() {
            return 0.0;
        }
        let side = if kx > 0.0 { 1.0 } else { self.upwind };
        self.radial(libm::sqrt(k2)) * (kx * kx / k2) * side
    }

    fn peak_wavenumber(&self) -> f64 {
        if self.a > 0.0 { PEAK_KL / self.l } else { 0.0 }
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        // ∫cos² over each half circle is π/2.
        self.radial(k) * k * std::f64::consts::FRAC_PI_2 * (1.0 + self.upwind)
    }
}
