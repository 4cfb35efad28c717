//! The moon and the turning of the stars against an independent library: `oracles/moon.json`.

use glam::DVec3;
use ocean_globe::model::moon::*;
use ocean_globe::model::sun;
use serde_json::Value;

fn oracle() -> Value {
    serde_json::from_str(include_str!("../oracles/moon.json")).unwrap()
}

fn number(row: &Value, name: &str) -> f64 {
    row[name].as_f64().unwrap_or_else(|| panic!("{name}"))
}

/// Unit vector in earth-centred axes of an apparent place at an instant.
fn place(row: &Value) -> DVec3 {
    let lon = number(row, "ra_deg").to_radians() - sun::greenwich_mean_sidereal_time(number(row, "unix"));
    let dec = number(row, "dec_deg").to_radians();
    DVec3::new(dec.cos() * lon.cos(), dec.cos() * lon.sin(), dec.sin())
}

#[test]
fn the_moon_stands_where_an_ephemeris_has_it() {
    let oracle = oracle();
    let mut worst = [0.0_f64; 3];
    for row in oracle["moon"].as_array().unwrap() {
        let unix = number(row, "unix");
        let moon = position_ecef(unix);
        let off_deg = moon.normalize().angle_between(place(row)).to_degrees();
        let far = (moon.length() / number(row, "distance_m") - 1.0).abs();
        // Half of one plus the cosine of the phase angle; the sun's distance is 389 times the moon's, which moves it by 0.15 degrees.
        let lit = 0.5 - 0.5 * moon.normalize().dot(sun::sun_direction_ecef(unix));
        let shade = (lit - number(row, "illuminated")).abs();
        for (worst, here) in worst.iter_mut().zip([off_deg, far, shade]) {
            *worst = worst.max(here);
        }
    }
    println!("at most {worst:.4?}");
    // Terms of the series that are left out, 0.02 degrees, nutation 0.005, and 0.008 for 15 s that the two clocks differ by in 2090.
    assert!(worst[0] < 0.03, "{} degrees", worst[0]);
    // Some ten terms of up to 10 km are left out, of 385,000.
    assert!(worst[1] < 2.5e-4, "{}", worst[1]);
    assert!(worst[2] < 0.5 * 0.15_f64.to_radians() + 5e-4, "{}", worst[2]);
}

#[test]
fn stars_precess() {
    for row in oracle()["precession"].as_array().unwrap() {
        let (ra, dec) = (number(row, "ra_2000_deg").to_radians(), number(row, "dec_2000_deg").to_radians());
        let star = DVec3::new(dec.cos() * ra.cos(), dec.cos() * ra.sin(), dec.sin());
        let off_deg = (ecef_from_j2000(number(row, "unix")) * star).angle_between(place(row)).to_degrees();
        // Nutation, which neither has, would be 0.005.
        assert!(off_deg < 0.002, "{off_deg} degrees: {row}");
    }
}

#[test]
fn a_half_moon_gives_a_twelfth_of_the_light_of_a_full_one() {
    let light = |phase_deg: f64| {
        let sun = DVec3::new(-phase_deg.to_radians().cos(), phase_deg.to_radians().sin(), 0.0);
        phase_brightness(DVec3::X, sun)
    };
    assert!((light(0.0) - 1.0).abs() < 1e-6);
    // Allen's table: 2.63 magnitudes at 90 degrees; a moon at 160 has a five-hundredth.
    assert!((-2.5 * light(90.0).log10() - 2.60).abs() < 0.05, "{}", light(90.0));
    assert!(light(160.0) < 3e-3 && light(180.0) < light(160.0));
}
