//! Waves that run up a beach, and foam that fades: the refraction, breaking, phase and Green rows of `oracles/dispersion.json`, the
//! solver's steps, and the foam rows of `oracles/fresnel.json`.

use ocean_globe::model::quadrature::simpson;
use ocean_globe::model::{GRAVITY, dispersion, foam, surf};
use serde_json::Value;
use std::f64::consts::TAU;

/// Direction over a depth of `h` (m) of a wave of `omega` (rad/s) that has the direction `deep` in deep water, radians from the normal of
/// straight contours: k sin θ is constant (Snell's law).
pub fn refracted(omega: f64, h: f64, deep: f64) -> f64 {
    let k_deep = omega * omega / GRAVITY;
    (k_deep / dispersion::wavenumber(omega, h) * deep.sin()).clamp(-1.0, 1.0).asin()
}

/// Refraction coefficient Kr = sqrt(cos θ₀/cos θ): height per height in deep water, from the rays' divergence alone.
pub fn refraction(deep: f64, here: f64) -> f64 {
    (deep.cos() / here.cos()).sqrt()
}

/// Phase ∫k dx (rad) of a wave of `omega` (rad/s) that runs straight up a plane beach of `slope` from depth `h0` to depth `h` (m, both
/// positive): (Y(k₀h₀) − Y(kh))/slope with Y(y) = y + ∫₀^y 2u/sinh 2u du. Never k(h)·x: that counts the wave number of the shore
/// from the start.
pub fn beach_phase(omega: f64, h0: f64, h: f64, slope: f64) -> f64 {
    let kh = |h: f64| dispersion::wavenumber(omega, h) * h;
    // 2u/sinh 2u = 2n − 1, with group_ratio's care for both ends; smooth, so that Simpson's 2e3 steps leave 1e-13.
    let rest = simpson(kh(h), kh(h0), 2000, |u| 2.0 * dispersion::group_ratio(u, 1.0) - 1.0);
    (kh(h0) - kh(h) + rest) / slope
}

/// Roundings of some tens of f64 operations.
const ROUNDING: f64 = 1e-13;

fn file() -> Value {
    serde_json::from_str(include_str!("../oracles/dispersion.json")).unwrap()
}

fn rows(value: &Value, count: usize) -> &[Value] {
    let rows = value.as_array().unwrap();
    assert_eq!(rows.len(), count);
    rows
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap()
}

/// Asserts a relative error.
fn close(got: f64, row: &Value, key: &str, relative: f64) {
    let want = number(row, key);
    assert!((got / want - 1.0).abs() < relative, "{key}: {got} against {want} in {row}");
}

#[test]
fn refraction_turns_waves_to_the_beach() {
    for row in rows(&file()["refraction"], 4) {
        let (omega, h) = (TAU / number(row, "T_s"), number(row, "h_m"));
        let deep = number(row, "theta0_deg").to_radians();
        let here = refracted(omega, h, deep);
        close(here.to_degrees(), row, "theta_deg", ROUNDING);
        close(refraction(deep, here), row, "Kr", ROUNDING);
        let shoaled = dispersion::shoaling(dispersion::wavenumber(omega, h), h);
        close(shoaled, row, "Ks", ROUNDING);
        close(shoaled * refraction(deep, here), row, "KsKr", ROUNDING);
    }
}

#[test]
fn waves_break_where_the_depth_says() {
    for row in rows(&file()["breaking"], 3) {
        let (height, omega) = (number(row, "H0_m"), TAU / number(row, "T_s"));
        assert_eq!(number(row, "theta0_deg"), 0.0);
        // McCowan's solitary wave is 0.78 of the depth high. The closed form's own error is half a per cent.
        close(surf::breaking_depth(height, omega * omega / GRAVITY, 0.78), row, "h_break_m", 0.01);
    }
}

#[test]
fn phase_is_the_integral_of_k() {
    for row in rows(&file()["phase_integral_plane_beach"], 4) {
        let (omega, h0, h) = (TAU / number(row, "T_s"), number(row, "h0_m"), number(row, "h_x_m"));
        let slope = number(row, "slope");
        assert!((h0 - slope * number(row, "x_m") - h).abs() < 1e-12);
        close(beach_phase(omega, h0, h, slope), row, "phase_int_rad", 1e-12);
        close(dispersion::wavenumber(omega, h), row, "local_k", ROUNDING);
        // The mistake: k of the place times the way.
        let naive = |x: f64| dispersion::wavenumber(omega, h0 - slope * x) * x;
        let x = number(row, "x_m");
        close(naive(x), row, "naive_k_times_x_rad", ROUNDING);
        assert!((naive(x) / number(row, "phase_int_rad") - 1.0).abs() > 0.5);
        // Its local wave number, and ours, by central differences of 1 mm: 1e-13 of 300 rad over 2 mm, and (1 mm/h)² of the curve.
        let step = 1e-3;
        let local = (naive(x + step) - naive(x - step)) / (2.0 * step);
        close(local, row, "naive_local_wavenumber_d_dx", 1e-4);
        let phase = |x: f64| beach_phase(omega, h0, h0 - slope * x, slope);
        close((phase(x + step) - phase(x - step)) / (2.0 * step), row, "local_k", 1e-6);
    }
}

#[test]
fn limits_of_shoaling() {
    let file = file();
    for row in rows(&file["greens_law"], 4) {
        // Green's law is the limit of long waves: k₀h of 4e-8 at most, of which a quarter is lacking.
        let ks = |h: f64| dispersion::shoaling(dispersion::wavenumber(1e-5, h), h);
        close(ks(number(row, "h2")) / ks(number(row, "h1")), row, "ratio", 2e-8);
    }
    for row in rows(&file["universal"], 8) {
        // Ks tends to (4 k₀h)^−¼, Green's law counted from deep water, and is larger by a quarter of k₀h.
        let k0h = number(row, "k0h");
        if k0h < 0.5 {
            let ks = dispersion::shoaling(dispersion::wavenumber((GRAVITY * k0h).sqrt(), 1.0), 1.0);
            close(ks, row, "green_law_asymptote_Ks", 0.3 * k0h);
        }
    }
    let row = &file["Ks_minimum"];
    let ks = |k0h: f64| dispersion::shoaling(dispersion::wavenumber((GRAVITY * k0h).sqrt(), 1.0), 1.0);
    close(ks(number(row, "k0h")), row, "Ks", ROUNDING);
    close(dispersion::wavenumber(GRAVITY.sqrt(), 1.0), row, "kh", ROUNDING);
    assert!((1..400).all(|i| ks(f64::from(i) * 0.01) >= number(row, "Ks") - 1e-15), "nowhere less");
}

#[test]
fn eckart_and_four_steps() {
    // The starts that the oracle compares, and what each Newton step leaves: the reason for `wavenumber`'s four.
    let file = file();
    let table = file["approximations_max_rel_err_k"].as_object().unwrap();
    assert_eq!(table.len(), 3);
    let eckart = |x0: f64| x0 / x0.tanh().sqrt();
    let guo = |x0: f64| x0 * (1.0 - (-x0.powf(1.25)).exp()).powf(-0.4);
    for name in ["eckart", "guo2002"] {
        let start = |x0: f64| if name == "eckart" { eckart(x0) } else { guo(x0) };
        let mut worst = [0.0f64; 4];
        for i in 0..=4000 {
            let x0 = 1e-6 * 5e7f64.powf(f64::from(i) / 4000.0);
            let exact = dispersion::wavenumber((GRAVITY * x0).sqrt(), 1.0);
            let mut x = start(x0);
            for error in &mut worst {
                *error = error.max((x / exact - 1.0).abs());
                let tanh = x.tanh();
                x -= (x * tanh - x0) / (tanh + x * (1.0 - tanh * tanh));
            }
        }
        for (steps, got) in worst.iter().enumerate().take(3) {
            // The worst of a grid of depths against the worst of another: near a flat top.
            close(*got, &table[name], &format!("{steps}_newton"), 1e-3);
        }
        // At the end both are the rounding of two solutions.
        assert!(worst[3] < 1e-13, "{name}: {}", worst[3]);
    }
}

#[test]
fn foam_fades_by_the_clock() {
    let fresnel: Value = serde_json::from_str(include_str!("../oracles/fresnel.json")).unwrap();
    for row in rows(&fresnel["foam_decay"], 6) {
        let (tau, steps) = (number(row, "tau_s"), row["steps"].as_u64().unwrap());
        let dt = 10.0 / steps as f64;
        let stepped = |one: &dyn Fn(f64) -> f64| (0..steps).fold(1.0, |foam, _| one(foam));
        // 2,400 roundings.
        close(stepped(&|foam| foam::relaxed(foam, 0.0, dt, tau)), row, "after_10s_exact", 1e-12);
        close(foam::relaxed(1.0, 0.0, 10.0, tau), row, "after_10s_exact", ROUNDING);
        let half = number(row, "half_life_s");
        assert!((foam::relaxed(1.0, 0.0, half, tau) - 0.5).abs() < 1e-15);
        // The mistake, which depends on the frame rate.
        let euler = stepped(&|foam| foam - foam * dt / tau);
        close(euler, row, "after_10s_explicit_euler", 1e-12);
        assert!((euler / number(row, "after_10s_exact") - 1.0).abs() > 1e-3);
    }
    assert_eq!(foam::relaxed(0.3, 0.1, f64::INFINITY, foam::LIFETIME_S), 0.1);
    assert_eq!(foam::relaxed(0.3, 0.1, 0.0, foam::LIFETIME_S), 0.3);
}
