//! Wave speeds against 40-digit arithmetic: the dispersion, universal and capillary rows of `oracles/dispersion.json`.

use ocean_globe::model::{GRAVITY, dispersion::*};
use serde_json::Value;

fn rows(table: &str) -> Vec<Value> {
    let file: Value = serde_json::from_str(include_str!("../oracles/dispersion.json")).unwrap();
    assert_eq!(file["meta"]["g"].as_f64().unwrap(), GRAVITY);
    let rows = file[table].as_array().unwrap().clone();
    assert!(rows.len() >= 6);
    rows
}

/// Asserts a relative error.
fn close(got: f64, row: &Value, key: &str, relative: f64) {
    let want = row[key].as_f64().unwrap();
    assert!((got / want - 1.0).abs() < relative, "{key}: {got} against {want} in {row}");
}

#[test]
fn waves_over_a_bottom() {
    // Four Newton steps end at f64's own rounding, which sinh and tanh of kh up to some hundred multiply by a few.
    const ROUNDING: f64 = 1e-14;
    for row in rows("dispersion") {
        let (omega, h) = (row["omega"].as_f64().unwrap(), row["h_m"].as_f64().unwrap());
        let k = wavenumber(omega, h);
        close(k, &row, "k", ROUNDING);
        close(omega_finite(k, h), &row, "omega", ROUNDING);
        close(group_ratio(k, h), &row, "n", ROUNDING);
        close(group_velocity(k, h), &row, "cg", ROUNDING);
        close(shoaling(k, h), &row, "Ks", ROUNDING);
        close(omega_deep(row["k_inf"].as_f64().unwrap()), &row, "omega", ROUNDING);
    }
}

#[test]
fn all_depths_in_one_curve() {
    for row in rows("universal") {
        let k0h = row["k0h"].as_f64().unwrap();
        let h = 7.0;
        let k = wavenumber((GRAVITY * k0h / h).sqrt(), h);
        // At k0h = 1e-6 the Newton function subtracts numbers that agree to their last three digits in kh.
        close(k * h, &row, "kh", 1e-13);
        close(group_ratio(k, h), &row, "n", 1e-13);
        close(shoaling(k, h), &row, "Ks", 1e-13);
    }
}

#[test]
fn capillary_waves() {
    let (mut waves, mut minima) = (0, 0);
    for row in rows("capillary") {
        let gamma = row["sigma"].as_f64().unwrap() / row["rho"].as_f64().unwrap();
        // A handful of f64 operations.
        const ROUNDING: f64 = 2e-15;
        if let Some(k) = row["k"].as_f64() {
            close(omega_capillary(k, f64::INFINITY, gamma), &row, "omega", ROUNDING);
            waves += 1;
        } else {
            let k = row["k_m"].as_f64().unwrap();
            close(omega_capillary(k, f64::INFINITY, gamma) / k, &row, "c_min", ROUNDING);
            close(omega_capillary(k, f64::INFINITY, gamma), &row, "omega_m", ROUNDING);
            minima += 1;
        }
    }
    assert_eq!((waves, minima), (4, 2));
}

#[test]
fn limits_are_finite() {
    assert_eq!(omega_capillary(0.0, f64::INFINITY, SEA_TENSION), 0.0);
    assert_eq!(omega_finite(0.0, f64::INFINITY), 0.0);
    assert_eq!(wavenumber(0.0, 10.0), 0.0);
    assert_eq!(wavenumber(1.0, 0.0), 0.0);
    assert_eq!(wavenumber(f64::NAN, 10.0), 0.0);
    assert_eq!(wavenumber(1.0, f64::INFINITY), 1.0 / GRAVITY);
    assert_eq!(group_velocity(0.0, 10.0), (GRAVITY * 10.0).sqrt());
    assert_eq!(group_ratio(1.0, f64::INFINITY), 0.5);
    // x = 2kh = 9e-5 and 1.1e-4, on both sides of the series: 1 - x^2/12 to an ulp.
    assert!((group_ratio(1.0, 4.5e-5) - (1.0 - 6.75e-10)).abs() < 3e-16);
    assert!((group_ratio(1.0, 5.5e-5) - (1.0 - 1.21e-8 / 12.0)).abs() < 3e-16);
}
