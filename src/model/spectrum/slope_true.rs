//! Heights and slopes at once: what a spectrum's short waves lack of, or have beyond, the measured roughness.

use super::{DirectionalSpectrum, K_CALM, K_SHORTEST};

/// The tail begins at this many peak wave numbers; below, a spectrum is its base's.
pub const TAIL_START: f64 = 10.0;
/// Range of the tail exponent q: from nearly no tail to one a bit above Toba's over F ∝ k⁻⁴.
pub const TAIL_EXPONENTS: (f64, f64) = (-8.0, 0.75);
/// Intervals below and above the start of the tail.
const INTERVALS: usize = 192;

/// A spectrum scaled to a height and given a tail factor so that its mean square slope is a wanted one:
///
/// F' = c F(k) up to 10 kp and c F(k) (k/10kp)^q exp(−(k² − (10kp)²) ℓ²) beyond, q within [`TAIL_EXPONENTS`].
///
/// A spectrum F ∝ k⁻⁴ has all its octaves equally steep; carried down to a centimetre that is too rough in light winds and too
/// smooth in strong ones. q = 0 leaves F alone, over F ∝ k⁻⁴ q = 1/2 would be [Toba's](crate::bibliography::Toba1973) k⁻³·⁵.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlopeTrue<S> {
    /// The spectrum as its source gives it.
    pub base: S,
    /// c, dimensionless: 0 for a calm.
    pub scale: f64,
    /// Wave number from which the tail factor applies, rad/m.
    pub k_tail: f64,
    /// Exponent q.
    pub tail: f64,
    /// ℓ, m: takes out waves shorter than about 6ℓ; 0 for none.
    pub damping_m: f64,
}

impl<S: DirectionalSpectrum> SlopeTrue<S> {
    /// `base` with significant height `hs_m`, m, and mean square slope `mss` as nearly as q allows; a calm if it has no height.
    pub fn new(base: S, hs_m: f64, mss: f64, damping_m: f64) -> Self {
        let peak = base.peak_wavenumber();
        let mut sea = Self { base, scale: 0.0, k_tail: TAIL_START * peak, tail: 0.0, damping_m };
        if !(hs_m > 0.0 && peak > 0.0 && peak < K_CALM) {
            return sea;
        }
        // Nothing lies below kp/20: exp(−1.25 · 400).
        let long = nodes(0.05 * peak, sea.k_tail).map(|(k, w)| (k, w * sea.base.omnidirectional(k)));
        let (m0_long, s_long) = long.fold((0.0, 0.0), |(m0, s), (k, e)| (m0 + e, s + e * k * k));
        // (ln(k/k_tail), energy without the tail's power, its slope variance) of the short waves.
        let short: Vec<(f64, f64, f64)> = nodes(sea.k_tail, K_SHORTEST)
            .map(|(k, w)| {
                let e = w * sea.base.omnidirectional(k) * libm::exp(-sea.damping(k));
                (libm::log(k / sea.k_tail), e, e * k * k)
            })
            .collect();
        let moments = |q: f64| {
            short.iter().fold((m0_long, s_long), |(m0, s), &(x, e, es)| {
                let tail = libm::exp(q * x);
                (m0 + e * tail, s + es * tail)
            })
        };
        let m0 = hs_m * hs_m / 16.0;
        let (mut low, mut high) = TAIL_EXPONENTS;
        // Slope per variance grows with q; 32 halvings leave 2e-9.
        for _ in 0..32 {
            let q = 0.5 * (low + high);
            let (variance, slopes) = moments(q);
            if slopes * m0 < mss * variance { low = q } else { high = q }
        }
        sea.tail = 0.5 * (low + high);
        let scale = m0 / moments(sea.tail).0;
        sea.scale = if scale.is_finite() { scale } else { 0.0 };
        sea
    }

    /// (k² − k_tail²) ℓ².
    fn damping(&self, k: f64) -> f64 {
        (k - self.k_tail) * (k + self.k_tail) * self.damping_m * self.damping_m
    }

    /// F'/F.
    fn factor(&self, k: f64) -> f64 {
        if k <= self.k_tail {
            return self.scale;
        }
        self.scale * libm::exp(self.tail * libm::log(k / self.k_tail) - self.damping(k))
    }
}

/// Wave numbers even in ln k and Simpson's weights for ∫ dk.
fn nodes(k0: f64, k1: f64) -> impl Iterator<Item = (f64, f64)> {
    let (low, high) = (libm::log(k0), libm::log(k1));
    let step = (high - low) / INTERVALS as f64;
    (0..=INTERVALS).map(move |i| {
        let k = libm::exp(low + step * i as f64);
        let simpson = if i == 0 || i == INTERVALS { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
        (k, simpson * step / 3.0 * k)
    })
}

impl<S: DirectionalSpectrum> DirectionalSpectrum for SlopeTrue<S> {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        let k = libm::sqrt(kx * kx + ky * ky);
        if !(self.scale > 0.0 && k.is_finite()) {
            return 0.0;
        }
        self.base.density(kx, ky) * self.factor(k)
    }

    fn peak_wavenumber(&self) -> f64 {
        if self.scale > 0.0 { self.base.peak_wavenumber() } else { 0.0 }
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        if self.scale > 0.0 && k.is_finite() { self.base.omnidirectional(k) * self.factor(k) } else { 0.0 }
    }

    fn peak_period(&self) -> f64 {
        if self.scale > 0.0 { self.base.peak_period() } else { 0.0 }
    }
}
