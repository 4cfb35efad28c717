//! The sun against Meeus' worked examples and the calendar's known moments.

use glam::DVec3;
use ocean_globe::model::sun::*;

const DAY: f64 = 86_400.0;

fn declination_deg(unix: f64) -> f64 {
    equatorial(unix).1.to_degrees()
}

#[test]
fn meeus_examples() {
    // Example 25.a: 1992 October 13, 0h dynamical time; he prints five decimals.
    let (ra, dec) = equatorial_at_century(-0.072_183_436);
    assert!((ra.to_degrees() - 198.380_83).abs() < 1e-5, "{}", ra.to_degrees());
    assert!((dec.to_degrees() + 7.785_07).abs() < 1e-5, "{}", dec.to_degrees());
    // Examples 12.a and 12.b: 1987 April 10 at 0h and 19:21 UT; he prints 1e-4 s of time, 4e-7 degrees.
    for (unix, h, m, s) in [(545_011_200.0, 13.0, 10.0, 46.3668), (545_080_860.0, 8.0, 34.0, 57.0896)] {
        let deg = greenwich_mean_sidereal_time(unix).to_degrees();
        assert!((deg - 15.0 * (h + m / 60.0 + s / 3600.0)).abs() < 4e-7, "{deg}");
    }
}

#[test]
fn seasons_begin_on_the_minute() {
    // Almanac moments, UTC. The series' 0.01 degrees; half a minute of the almanac's rounding moves an equinox by 1e-4.
    for (name, unix, dec) in [
        ("March equinox 2024", 1_710_903_960.0, 0.0),
        ("June solstice 2024", 1_718_916_660.0, 23.4363),
        ("September equinox 2024", 1_727_009_040.0, 0.0),
        ("December solstice 2024", 1_734_772_800.0, -23.4363),
    ] {
        assert!((declination_deg(unix) - dec).abs() < 0.01, "{name}: {}", declination_deg(unix));
    }
    // At the ends of the range the drift of terrestrial time adds up to 0.005 degrees.
    for (name, unix) in [("1900", -2_202_157_260.0), ("2100", 4_109_231_040.0)] {
        assert!(declination_deg(unix).abs() < 0.015, "March equinox {name}: {}", declination_deg(unix));
    }
}

/// Apparent minus mean solar time, minutes.
fn equation_of_time(unix: f64) -> f64 {
    let (_, lon) = subsolar_point(unix);
    let hours = unix.rem_euclid(DAY) / 3600.0;
    (180.0 - 15.0 * hours - lon.to_degrees() + 180.0).rem_euclid(360.0) * 4.0 - 720.0
}

#[test]
fn sundials_run_fast_and_slow() {
    // 2024, noon by noon. The extremes are -14 min 13 s about February 11 and +16 min 26 s about November 3; 0.01 degrees of sun
    // and 0.9 s of UT1 make 0.06 minutes, the almanac's whole seconds the rest.
    let noon = |day: usize| equation_of_time(1_704_067_200.0 + (day as f64 + 0.5) * DAY);
    let days: Vec<f64> = (0..366).map(noon).collect();
    let least = (0..366).min_by(|&a, &b| days[a].total_cmp(&days[b])).unwrap();
    let most = (0..366).max_by(|&a, &b| days[a].total_cmp(&days[b])).unwrap();
    assert!((days[least] + 14.22).abs() < 0.08 && least.abs_diff(41) <= 1, "{} on day {least}", days[least]);
    assert!((days[most] - 16.43).abs() < 0.08 && most.abs_diff(307) <= 1, "{} on day {most}", days[most]);
}

#[test]
fn the_sun_is_where_its_subsolar_point_is() {
    let unix = 1_710_936_000.0; // 2024-03-20 12:00 UTC, the equinox day
    let sun = sun_direction_ecef(unix);
    assert!((sun.length() - 1.0).abs() < 1e-15);
    // Noon at Greenwich but for 7.4 minutes (1.9 degrees), 9 hours after the equinox (0.15 degrees).
    assert!(sun.angle_between(DVec3::X).to_degrees() < 2.0, "{sun}");
    // Six hours later it stands over the Pacific's east, 90 degrees west.
    assert!(sun_direction_ecef(unix + 6.0 * 3600.0).angle_between(-DVec3::Y).to_degrees() < 2.1);
    assert!(sun_direction_ecef(f64::NAN).is_finite() && sun_direction_ecef(f64::INFINITY).is_finite());
    for day in 0..400 {
        let (lat, lon) = subsolar_point(unix + f64::from(day) * 0.37 * DAY);
        assert!(lat.abs() < 0.41 && lon > -std::f64::consts::PI && lon <= std::f64::consts::PI);
    }
}

#[test]
fn a_page_without_a_link_opens_on_the_day_side() {
    use ocean_globe::scene::view::named;
    for step in 0..200 {
        let unix_seconds = 1.7e9 + 1.1e6 * f64::from(step);
        let eye = named::opening(unix_seconds).camera;
        let up = ocean_globe::model::earth::normal(eye.lat, eye.lon);
        // 20 degrees north of the equator, half a radian from noon, the sun at most 23.44 degrees south: 51.8 degrees at most.
        assert!(up.dot(ocean_globe::model::sun::sun_direction_ecef(unix_seconds)) > 0.6);
    }
}
