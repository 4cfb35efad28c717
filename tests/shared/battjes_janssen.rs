//! The heights of a random sea that breaks on a beach, by the energy balance of J. Battjes and J. Janssen (1978), for the tests of the
//! model and of what is drawn.

use std::f64::consts::TAU;

use ocean_globe::model::{GRAVITY, dispersion};

/// Depths from three times the significant height down to half of it, m, and the rms height there, m: of waves that come straight in, `hrms0` m
/// high in deep water with a period in seconds, up a beach with a `slope` by depth.
pub fn heights(slope: impl Fn(f64) -> f64, period: f64, hrms0: f64) -> Vec<[f64; 2]> {
    let omega = TAU / period;
    let k_deep = omega * omega / GRAVITY;
    let ks = |h: f64| dispersion::shoaling(dispersion::wavenumber(omega, h), h);
    let cg = |h: f64| dispersion::group_velocity(dispersion::wavenumber(omega, h), h);
    let gamma = 0.5 + 0.4 * (33.0 * hrms0 * k_deep / TAU).tanh();
    let (step, mut h) = (0.25, 12.0);
    let mut square = (hrms0 * ks(h)).powi(2);
    let hs = 1.416 * hrms0;
    let mut found = Vec::new();
    while h > 0.5 * hs {
        let k = dispersion::wavenumber(omega, h);
        let highest = 0.88 / k * (gamma * k * h / 0.88).tanh();
        let b2 = (square / (highest * highest)).min(0.999_999);
        let (mut low, mut high) = (1e-12f64, 1.0 - 1e-12);
        for _ in 0..60 {
            let q = 0.5 * (low + high);
            if (1.0 - q) / -q.ln() < b2 { low = q } else { high = q }
        }
        // dE cg/dx = -D with E = ρg Hrms²/8, D = ρg Qb Hm²/(4 T).
        let flux = square * cg(h) - step * 2.0 * low * highest * highest / period;
        h -= step * slope(h);
        square = flux / cg(h);
        if h < 3.0 * hs {
            found.push([h, square.sqrt()]);
        }
    }
    found
}
