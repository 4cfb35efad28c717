//! The geoid: the bundled grid, and what links, samples and measured layers make of it.

use ocean_globe::cli::sample::{SampleArgs, sample};
use ocean_globe::data::geoid::height_m;
use ocean_globe::scene::settings::Datum;
use ocean_globe::scene::view::state::ViewState;

const WORLD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

fn at(lat_deg: f64, lon_deg: f64) -> f64 {
    height_m(lat_deg.to_radians(), lon_deg.to_radians())
}

#[test]
fn heights_are_egm96s() {
    // The test values that NGA publishes with the model (outf477.dat), of its harmonics.
    for (lat, lon, wanted_m) in [
        (38.628155, 269.779155, -31.628),
        (-14.621217, 305.021114, -2.969),
        (46.874319, 102.448729, -43.575),
        (-23.617446, 133.874712, 15.871),
        (38.625473, 359.9995, 50.066),
        (-0.466744, 0.0023, 17.329),
    ] {
        // The grid of 15' is 0.06 m off these places, the bundled one's rounding 0.05 m, its interpolation 0.07 m rms.
        assert!((at(lat, lon) - wanted_m).abs() < 0.25, "{lat} {lon}: {} of {wanted_m}", at(lat, lon));
    }
    // Extremes of the grid of 15', south of India and in New Guinea, and the poles.
    for (lat, lon, wanted_m, within_m) in [
        (4.75, 78.75, -106.991, 0.3),
        (-8.25, 147.25, 85.391, 0.7),
        (90.0, 12.0, 13.606, 0.06),
        (-90.0, -40.0, -29.534, 0.06),
    ] {
        assert!((at(lat, lon) - wanted_m).abs() < within_m, "{lat} {lon}: {} of {wanted_m}", at(lat, lon));
    }
}

#[test]
fn heights_have_no_seam_and_are_finite_everywhere() {
    for (lat, lon) in (-90..=90).flat_map(|lat| (-20..20).map(move |i| (f64::from(lat), 9.0 * f64::from(i)))) {
        let here = at(lat, lon);
        assert!((-108.0..86.0).contains(&here), "{lat} {lon}: {here}");
        assert!((here - at(lat, lon + 360.0)).abs() < 1e-6 && (here - at(lat, lon - 720.0)).abs() < 1e-6);
        // 11 m on: slopes are below 3e-4.
        assert!((here - at(lat, lon + 1e-4)).abs() < 0.01 && (here - at((lat + 1e-4).min(90.0), lon)).abs() < 0.01);
    }
    for lon in [-180.0, -90.0, 0.0, 77.0] {
        assert!((at(89.9999, lon) - at(90.0, 0.0)).abs() < 0.01 && (at(-89.9999, lon) - at(-90.0, 0.0)).abs() < 0.01);
    }
    assert_eq!(
        [height_m(f64::NAN, 0.0), height_m(0.0, f64::INFINITY), height_m(f64::MAX, 0.0)].map(f64::is_finite),
        [true; 3]
    );
}

#[test]
fn a_links_altitude_is_over_the_ellipsoid_and_the_cameras_over_the_sea() {
    let parse = |text: &str| {
        let (state, errors) = ViewState::parse_fragment(text, None);
        assert!(errors.is_empty(), "{text}: {errors:?}");
        state
    };
    // The Azores, where the sea is some 57 m over the ellipsoid; the key's place among others does not matter.
    let rest_m = at(38.5, -28.6);
    assert!((55.0..60.0).contains(&rest_m));
    for text in ["view=38.5,-28.6,560,300,78&datum=geoid", "datum=geoid&view=38.5,-28.6,560,300,78"] {
        let state = parse(text);
        assert_eq!(state.settings.datum, Datum::Geoid);
        assert!((state.camera.altitude_m - (560.0 - rest_m)).abs() < 1e-9);
        assert_eq!(state.format_fragment(None), "view=38.5,-28.6,560,300,78&datum=geoid");
    }
    // 2 m over the waves are 2 m, wherever the sea is.
    let ridden = parse("view=38.5,-28.6,2,300,78&ride=1&datum=geoid");
    assert_eq!((ridden.camera.altitude_m, ridden.format_fragment(None).contains("-28.6,2,300")), (2.0, true));
    assert_eq!(parse("datum=ellipsoid").format_fragment(None), "");
    assert_eq!(parse("datum=geoid").format_fragment(None), "datum=geoid");
    let (_, errors) = ViewState::parse_fragment("datum=msl", None);
    assert!(errors[0].to_string().contains("ellipsoid, geoid"), "{errors:?}");
    // A bad view leaves the camera where it was, in a text that goes on.
    let mut state = parse("view=38.5,-28.6,560&datum=geoid");
    let camera = state.camera;
    assert_eq!(state.apply_fragment("view=nowhere&datum=geoid", None).len(), 1);
    assert_eq!(state.camera, camera);
}

#[test]
fn links_on_the_geoid_say_the_same_when_they_are_written_again() {
    for i in 0..2_000 {
        let turn = |factor: f64| (f64::from(i) * factor).fract();
        let altitude_m = 1.0 * 1e7f64.powf(turn(0.618_034));
        let (lat, lon) = (180.0 * turn(0.414_214) - 90.0, 360.0 * turn(0.732_051) - 180.0);
        let text = format!("view={lat},{lon},{}&datum=geoid", altitude_m + at(lat, lon));
        let once = ViewState::parse_fragment(&text, None).0.format_fragment(None);
        let twice = ViewState::parse_fragment(&once, None).0;
        assert_eq!(twice.format_fragment(None), once, "{text}");
        // Wrong by a thousandth of the height or 1 cm, and by what the geoid's slope makes of the place's.
        let off_m = (twice.camera.altitude_m - altitude_m).abs();
        assert!(off_m < 0.0011 * altitude_m.max(10.0), "{text}: {off_m} m off");
    }
}

#[test]
fn samples_tell_heights_over_both() {
    let args = |state: &str| SampleArgs {
        at: "38.0,-28.0".into(),
        state: state.into(),
        time: Some("2026-11-20T12:00:00Z".into()),
        data: WORLD.into(),
    };
    let [on_geoid, on_ellipsoid] = ["#datum=geoid", ""].map(|state| sample(&args(state)).unwrap());
    let number = |object: &serde_json::Value, name: &str| object[name].as_f64().unwrap_or_else(|| panic!("{name}"));
    let geoid_m = at(38.0, -28.0);
    for found in [&on_geoid, &on_ellipsoid] {
        assert_eq!(number(found, "geoid_m"), geoid_m);
        assert_eq!(number(found, "elevation_over_geoid_m"), number(found, "elevation_m"));
        assert_eq!(number(found, "elevation_over_ellipsoid_m"), number(found, "elevation_m") + geoid_m);
        let surface = &found["surface"];
        let over_both = number(surface, "height_over_ellipsoid_m") - number(surface, "height_over_geoid_m");
        assert!((over_both - geoid_m).abs() < 1e-9 && number(surface, "height_over_geoid_m").abs() < 4.0);
    }
    // What is drawn: the same waves, higher by the geoid.
    let rise = number(&on_geoid["surface"], "height_m") - number(&on_ellipsoid["surface"], "height_m");
    assert!((rise - geoid_m).abs() < 1e-9, "{rise}");
}
