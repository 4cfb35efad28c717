//! Wind grades, wave heights and wind components against `oracles/spectra.json`.

use ocean_globe::model::sea_state::*;
use serde_json::Value;

fn rows(table: &str) -> Vec<Value> {
    let file: Value = serde_json::from_str(include_str!("../oracles/spectra.json")).unwrap();
    file[table]["rows"].as_array().unwrap().clone()
}

#[test]
fn grades_hold_their_table() {
    let rows = rows("beaufort");
    assert_eq!(rows.len(), 13);
    for (grade, row) in rows.iter().enumerate() {
        let (low, high) = (row["ms"][0].as_f64().unwrap(), row["ms"][1].as_f64().unwrap_or(f64::INFINITY));
        assert_eq!((LOWER_BOUNDS[grade], UPPER_BOUNDS[grade]), (low, high));
        assert_eq!((beaufort_from_speed(low), beaufort_from_speed(high.min(90.0))), (grade, grade));
        let speed = speed_from_beaufort(grade as f64);
        let want = row["v_empirical_0p836_B1p5"].as_f64().unwrap();
        assert!((speed - want).abs() <= 4.0 * f64::EPSILON * want, "two products and a root: {speed}, want {want}");
        assert_eq!(beaufort_from_speed(speed), grade, "the speed that stands for a grade lies in it");
        let height = significant_height(speed);
        let want = row["H_seed_m"].as_f64().unwrap();
        // The cubic passes through its knots but for rounding.
        assert!((height - want).abs() <= 1e-14 * want, "grade {grade}: {height} m, want {want}");
    }
    assert_eq!((name(0), name(8), name(12), name(99)), ("calm", "gale", "hurricane", "hurricane"));
}

#[test]
fn height_rises_with_the_wind_to_its_cap() {
    let heights: Vec<f64> = (0..6000).map(|i| significant_height(f64::from(i) * 0.01)).collect();
    assert_eq!(heights[0], 0.0);
    assert!(heights.windows(2).all(|pair| pair[1] >= pair[0] && pair[1] - pair[0] < 0.01), "monotone, without a jump");
    assert!(heights[3400] < 14.0 && heights[3476..].iter().all(|&h| h == 14.0));
}

#[test]
fn hostile_speeds_are_calm() {
    for speed in [f64::NAN, -1.0, f64::NEG_INFINITY] {
        assert_eq!((beaufort_from_speed(speed), significant_height(speed)), (0, 0.0));
    }
    assert_eq!(speed_from_beaufort(-3.0), 0.0);
    assert_eq!(beaufort_from_speed(f64::INFINITY), 12);
}

#[test]
fn wind_blows_from() {
    let rows = rows("wind_convention");
    assert_eq!(rows.len(), 4);
    for row in rows {
        let from = row["from_deg"].as_f64().unwrap().to_radians();
        let speed = row["speed"].as_f64().unwrap();
        let (u, v) = wind_components(speed, from);
        // A bearing in radians is rounded by 4e-16.
        assert!((u - row["u_east"].as_f64().unwrap()).abs() < 1e-14, "{row}");
        assert!((v - row["v_north"].as_f64().unwrap()).abs() < 1e-14, "{row}");
        let to = row["to_math_angle_deg"].as_f64().unwrap().to_radians();
        assert!((u - speed * to.cos()).abs() < 1e-14 && (v - speed * to.sin()).abs() < 1e-14);
    }
}
