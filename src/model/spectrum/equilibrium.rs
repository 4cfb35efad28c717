//! The waves between the peak and the ripples, as they were measured after JONSWAP.

use super::DirectionalSpectrum;

/// The range begins at this many peak wave numbers: at 1.5 times the peak's frequency.
const EQUILIBRIUM_START: f64 = 2.25;

/// A spectrum with Toba's equilibrium range beyond its peak: F' = F (k/2.25kp)^½ for k > 2.25 kp, F' = F before.
///
/// With JONSWAP's tail of ω⁻⁵ waves of 20 m have 1.8 times the energy in a gale that they have in a fresh breeze. Seas were measured to have
/// one of ω⁻⁴ from 1.5 to some 3 times the peak's frequency ([Toba](crate::bibliography::Toba1973),
/// [Donelan](crate::bibliography::Donelan1985)): 2.6 times. What lies beyond 3.2 times (10 kp), [`SlopeTrue`](super::SlopeTrue) bends to the
/// measured slopes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equilibrium<S> {
    /// A spectrum with F ∝ k⁻⁴ beyond its peak.
    pub base: S,
    /// 2.25 kp, rad/m.
    k_start: f64,
}

impl<S: DirectionalSpectrum> Equilibrium<S> {
    /// `base` with the range.
    pub fn new(base: S) -> Self {
        let k_start = EQUILIBRIUM_START * base.peak_wavenumber();
        Self { base, k_start }
    }

    /// F'/F.
    fn factor(&self, k: f64) -> f64 {
        if k > self.k_start && self.k_start > 0.0 { libm::sqrt(k / self.k_start) } else { 1.0 }
    }
}

impl<S: DirectionalSpectrum> DirectionalSpectrum for Equilibrium<S> {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        let density = self.base.density(kx, ky);
        // Where nothing is, k may be what no factor can be made of.
        if density > 0.0 { density * self.factor(libm::sqrt(kx * kx + ky * ky)) } else { 0.0 }
    }

    fn peak_wavenumber(&self) -> f64 {
        self.base.peak_wavenumber()
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        let variance = self.base.omnidirectional(k);
        if variance > 0.0 { variance * self.factor(k) } else { 0.0 }
    }

    fn peak_period(&self) -> f64 {
        self.base.peak_period()
    }
}
