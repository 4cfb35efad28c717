//! How the energy of the sea is spread over wave numbers.
//!
//! Conventions: F(kx, ky) in m⁴ is a density over the *whole* plane, with its energy at the k the wave travels towards and x
//! downwind; ∫∫ F d²k = m0 = Hs²/16. Each spectrum is a [`DirectionalSpectrum`]; what consumes them knows no more.
//!
//! Two kinds of source: [`Phillips`] and [`Elfouhaily`] are given over wave numbers; [`PiersonMoskowitz`], [`Jonswap`] and [`Tma`]
//! are [`FrequencySpectrum`]s S(ω), which [`Directed`] brings to the plane with a [spreading](super::spreading) and the
//! dispersion of their depth. They stand here as their sources print them; [`Equilibrium`] gives JONSWAP the range that was measured
//! later, and [`SlopeTrue`] gives the short waves of any of them
//! the slopes that the sea was measured to have.

mod elfouhaily;
mod equilibrium;
mod frequency;
mod jonswap;
mod phillips;
mod pierson_moskowitz;
mod slope_true;
mod swell;
mod tma;

pub use elfouhaily::{Elfouhaily, WAVE_AGES};
pub use equilibrium::Equilibrium;
pub use frequency::{Directed, FrequencySpectrum};
pub use jonswap::{Jonswap, SMALLEST_PEAK_SPEED};
pub use phillips::{DAMPING_M, Phillips, STEEPEST_SHARE};
pub use pierson_moskowitz::PiersonMoskowitz;
pub use slope_true::{SlopeTrue, TAIL_EXPONENTS, TAIL_START};
pub use swell::{SWELL_GAMMA, SWELL_S, SwellTrain};
pub use tma::Tma;

use super::{dispersion, quadrature::simpson_log};

/// Integrals over all waves run from waves of 600 km to waves of 1.6 mm, rad/m; no sea has energy outside.
const K_LONGEST: f64 = 1e-5;
const K_SHORTEST: f64 = 4e3;
/// A wind sea with its peak beyond this, rad/m, is a ripple of 1.6 cm: no sea, but a calm.
const K_CALM: f64 = 400.0;

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
