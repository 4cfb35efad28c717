//! Reflection, transmission, roughness and the mix by distance: `oracles/fresnel.json` and `oracles/spectra.json`.

use ocean_globe::model::optics::*;
use serde_json::Value;

fn fresnel_file() -> Value {
    serde_json::from_str(include_str!("../oracles/fresnel.json")).unwrap()
}

fn rows(value: &Value, at_least: usize) -> &[Value] {
    let rows = value.as_array().unwrap();
    assert!(rows.len() >= at_least);
    rows
}

/// Asserts an absolute error.
fn close(got: f64, row: &Value, key: &str, tolerance: f64) {
    let want = row[key].as_f64().unwrap();
    assert!((got - want).abs() <= tolerance, "{key}: {got} against {want} in {row}");
}

fn cos_deg(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap().to_radians().cos()
}

#[test]
fn reflection_from_above() {
    let file = fresnel_file();
    for case in rows(&file["cases"], 3) {
        let n = case["n_value"].as_f64().unwrap();
        close(r0(1.0, n), case, "R0", 1e-16);
        for row in rows(&case["air_to_water"], 20) {
            // Some ten roundings on numbers up to 1.
            let got = fresnel(cos_deg(row, "angle_deg"), 1.0, n);
            close(got.s, row, "Rs", 2e-15);
            close(got.p, row, "Rp", 2e-15);
            close(got.unpolarised(), row, "R", 2e-15);
            close(schlick(cos_deg(row, "angle_deg"), r0(1.0, n)), row, "schlick", 2e-15);
            // acos loses half the digits near 0.
            let theta = cos_in_water(cos_deg(row, "angle_deg"), n).acos().to_degrees();
            close(theta, row, "theta_t_deg", 1e-6);
        }
    }
}

#[test]
fn reflection_from_below() {
    let file = fresnel_file();
    for row in rows(&file["water_to_air_n1_1.333"], 7) {
        let cos = cos_deg(row, "angle_deg");
        let got = fresnel(cos, 1.333, 1.0);
        // Near the critical angle cos_t is the root of a difference: at 48.6 degrees of 1e-4, so that 2e-16 becomes 1e-14.
        close(got.s, row, "Rs", 5e-14);
        close(got.p, row, "Rp", 5e-14);
        close(got.unpolarised(), row, "R", 5e-14);
        close(schlick_from_below(cos, 1.333, 1.0), row, "schlick_with_cos_t", 5e-14);
    }
    for row in rows(&file["reciprocity"], 4) {
        let cos = cos_deg(row, "angle_air_deg");
        close(fresnel(cos, 1.0, 1.333).unpolarised(), row, "R_air", 2e-15);
        close(fresnel(cos_in_water(cos, 1.333), 1.333, 1.0).unpolarised(), row, "R_water", 5e-15);
    }
}

#[test]
fn light_through_water() {
    let file = fresnel_file();
    for row in rows(&file["beer_lambert"], 9) {
        let (sun, view) =
            (cos_in_water(cos_deg(row, "sun_deg_air"), 1.333), cos_in_water(cos_deg(row, "view_deg_air"), 1.333));
        close(sun, row, "mu_s", 1e-15);
        close(view, row, "mu_v", 1e-15);
    }
}

#[test]
fn water_opacity() {
    assert_eq!((water_alpha(0.2, 0.0), water_alpha(0.2, -5.0), water_alpha(0.2, f64::INFINITY)), (0.0, 0.0, 1.0));
    // 1 − 1/e at one optical depth.
    assert!((water_alpha(0.2, 5.0) - 0.632_120_558_828_557_7).abs() < 1e-15);
}

#[test]
fn cox_munk_slopes() {
    let file: Value = serde_json::from_str(include_str!("../oracles/spectra.json")).unwrap();
    for row in rows(&file["cox_munk"]["rows"], 4) {
        let got = cox_munk_mss(row["W_12_5m"].as_f64().unwrap());
        // One product and one sum.
        close(got.up, row, "mss_upwind", 1e-16);
        close(got.cross, row, "mss_crosswind", 1e-16);
        close(got.total, row, "mss_total_published_fit", 1e-16);
        close(got.up + got.cross, row, "sum_of_components", 1e-16);
        let slick = cox_munk_slick_mss(row["W_12_5m"].as_f64().unwrap());
        close(slick.up, row, "slick_up", 1e-16);
        close(slick.cross, row, "slick_cross", 1e-16);
        close(slick.total, row, "slick_total", 1e-16);
    }
}

#[test]
fn mix_keeps_the_variance() {
    for step in 0..=1000 {
        let r = f64::from(step) / 1000.0;
        let mix = mix_weights(100.0 + 900.0 * r, 100.0, 1000.0);
        // Two roots squared again.
        assert!((mix.fft * mix.fft + mix.perlin * mix.perlin - 1.0).abs() < 1e-15);
        assert!((mix.perlin * mix.perlin - r * r * (3.0 - 2.0 * r)).abs() < 1e-14);
    }
    assert_eq!(mix_weights(5.0, 100.0, 1000.0), MixWeights { fft: 1.0, perlin: 0.0 });
    assert_eq!(mix_weights(5e5, 100.0, 1000.0), MixWeights { fft: 0.0, perlin: 1.0 });
    assert_eq!(mix_weights(10.0, 10.0, 10.0), MixWeights { fft: 0.0, perlin: 1.0 }, "an empty range is a step");
}
