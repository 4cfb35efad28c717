//! What a shoaling bottom does to a wave: height, direction, phase, breaking.
//!
//! A wave of frequency ω keeps it from deep water to the beach. The depth contours are straight and parallel; directions are measured
//! from their normal, radians.

use super::{
    dispersion::{self, shoaling, wavenumber},
    quadrature::simpson,
};

/// The highest single wave per depth: [McCowan's](crate::bibliography::McCowan1894) solitary wave.
pub const BREAKER_INDEX: f64 = 0.78;
/// Direction over a depth of `h` (m) of a wave of `omega` (rad/s) that has the direction `deep` in deep water: k sin θ is constant
/// (Snell's law).
pub fn refracted(omega: f64, h: f64, deep: f64) -> f64 {
    let k_deep = omega * omega / super::GRAVITY;
    libm::asin((k_deep / wavenumber(omega, h) * libm::sin(deep)).clamp(-1.0, 1.0))
}

/// Refraction coefficient Kr = sqrt(cos θ₀/cos θ): height per height in deep water, from the rays' divergence alone.
pub fn refraction(deep: f64, here: f64) -> f64 {
    libm::sqrt(libm::cos(deep) / libm::cos(here))
}

/// Height over a depth of `h` (m) per height in deep water, Ks Kr, before the wave breaks.
pub fn height_ratio(omega: f64, h: f64, deep: f64) -> f64 {
    shoaling(wavenumber(omega, h), h) * refraction(deep, refracted(omega, h, deep))
}

/// Green's law: height over depth `h2` per height over depth `h1`, (h1/h2)^¼; the limit of shoaling for waves much longer than deep.
pub fn green_ratio(h1: f64, h2: f64) -> f64 {
    libm::sqrt(libm::sqrt(h1 / h2))
}

/// Depth (m) in which a wave of deep-water height `height` (m), frequency `omega` (rad/s) and direction `deep` grows beyond 0.78 of the
/// depth: where it breaks. In (0, one deep-water wavelength]; that length if it breaks before.
pub fn breaking_depth(height: f64, omega: f64, deep: f64) -> f64 {
    let (mut low, mut high) = (0.0, std::f64::consts::TAU * super::GRAVITY / (omega * omega));
    // 60 halvings end at f64's own step.
    for _ in 0..60 {
        let h = 0.5 * (low + high);
        if height * height_ratio(omega, h, deep) > BREAKER_INDEX * h { low = h } else { high = h }
    }
    high
}

/// Phase ∫k dx (rad) of a wave of `omega` (rad/s) that runs straight up a plane beach of `slope` from depth `h0` to depth `h` (m, both
/// positive): (Y(k₀h₀) − Y(kh))/slope with Y(y) = y + ∫₀^y 2u/sinh 2u du. Never k(h)·x: that counts the wave number of the shore
/// from the start.
pub fn beach_phase(omega: f64, h0: f64, h: f64, slope: f64) -> f64 {
    let kh = |h: f64| wavenumber(omega, h) * h;
    // 2u/sinh 2u = 2n − 1, with group_ratio's care for both ends; smooth, so that Simpson's 2e3 steps leave 1e-13.
    let rest = simpson(kh(h), kh(h0), 2000, |u| 2.0 * dispersion::group_ratio(u, 1.0) - 1.0);
    (kh(h0) - kh(h) + rest) / slope
}
