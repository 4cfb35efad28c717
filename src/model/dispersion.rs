//! How fast waves of each length run: gravity waves over any depth, and gravity-capillary waves.
//!
//! Letters: k wave number rad/m, ω angular frequency rad/s, h depth m (infinite is allowed), cg group velocity m/s,
//! n = cg/c. All functions use `libm`, since the frequencies feed the waves.

use super::GRAVITY;

/// Surface tension over density of sea water, m³/s²: 0.0738 N/m ([Nayar et al.](crate::bibliography::Nayar2014), 20 °C,
/// 35 g/kg) over 1024.8 kg/m³.
pub const SEA_TENSION: f64 = 0.0738 / 1024.8;

/// ω of gravity waves in deep water, ω² = g k.
pub fn omega_deep(k: f64) -> f64 {
    libm::sqrt(GRAVITY * k.max(0.0))
}

/// ω of gravity waves over depth `h`, ω² = g k tanh(k h).
pub fn omega_finite(k: f64, h: f64) -> f64 {
    libm::sqrt(GRAVITY * k.max(0.0) * tanh_kh(k, h))
}

/// ω of gravity-capillary waves over depth `h` (infinity for deep water), ω² = (g k + γ k³) tanh(k h), with
/// γ = surface tension / density in m³/s² (sea: [`SEA_TENSION`]).
pub fn omega_capillary(k: f64, h: f64, gamma: f64) -> f64 {
    let k = k.max(0.0);
    libm::sqrt((GRAVITY + gamma * k * k) * k * tanh_kh(k, h))
}

/// k of a gravity wave of frequency `omega` over depth `h`; 0 unless both are positive.
///
/// [Eckart's](crate::bibliography::Eckart1952) start x₀/√tanh x₀ (x₀ = ω² h/g) is within 5 %; three Newton steps on
/// x tanh x = x₀ bring 1.7e-14, the fourth is for the rounding.
pub fn wavenumber(omega: f64, h: f64) -> f64 {
    if !(omega > 0.0 && h > 0.0) {
        return 0.0;
    }
    let k_deep = omega * omega / GRAVITY;
    let x0 = k_deep * h;
    // tanh x is 1 in f64 from x = 19.1 on.
    if x0 > 20.0 {
        return k_deep;
    }
    let mut x = x0 / libm::sqrt(libm::tanh(x0));
    for _ in 0..4 {
        let tanh = libm::tanh(x);
        x -= (x * tanh - x0) / (tanh + x * (1.0 - tanh * tanh));
    }
    x / h
}

/// n = cg/c = (1 + 2kh/sinh 2kh)/2: 1 in shallow water, 1/2 in deep water.
pub fn group_ratio(k: f64, h: f64) -> f64 {
    let x = 2.0 * k * h;
    // Below 1e-4 the first series term is exact to 1e-18; above 700 sinh overflows and the term is 0 long before.
    if x < 1e-4 {
        1.0 - x * x / 12.0
    } else if x < 700.0 {
        0.5 * (1.0 + x / libm::sinh(x))
    } else {
        0.5
    }
}

/// Group velocity of gravity waves over depth `h`, cg = n ω/k; in the limit k = 0 it is sqrt(g h).
pub fn group_velocity(k: f64, h: f64) -> f64 {
    if k > 0.0 { group_ratio(k, h) * omega_finite(k, h) / k } else { libm::sqrt(GRAVITY * h) }
}

/// Shoaling coefficient Ks = sqrt(cg₀/cg), with cg₀ = g/(2ω) in deep water: the height over depth `h` per deep-water height.
pub fn shoaling(k: f64, h: f64) -> f64 {
    libm::sqrt(GRAVITY / (2.0 * omega_finite(k, h)) / group_velocity(k, h))
}

/// How much longer than high the orbits of the water at the surface are, coth kh; 1 in deep water, and for no wave. At most a million: as if no water
/// were less than a millionth of 1/k deep.
pub fn orbit_ratio(k: f64, h: f64) -> f64 {
    if k > 0.0 { 1.0 / tanh_kh(k, h).max(1e-6) } else { 1.0 }
}

fn tanh_kh(k: f64, h: f64) -> f64 {
    // 0 · ∞ would be NaN: a wave of no wave number over no bottom has ω = 0 either way.
    if k > 0.0 { libm::tanh(k * h.max(0.0)) } else { 0.0 }
}
