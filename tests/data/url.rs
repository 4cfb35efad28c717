//! The link form of the whole view: the table of keys, round trips, and what hostile links may not do.

use ocean_globe::scene::layers::{Layer, Layers};
use ocean_globe::scene::link::fragment::LONGEST;
use ocean_globe::scene::settings::{
    Datum, Foam, FoamRule, Mesh, Quality, Settings, Spectrum, Surf, Swell, Triangles, Water, Wind,
};
use ocean_globe::scene::time::{FIRST_S, LAST_S, SceneTime};
use ocean_globe::scene::view::camera::Camera;
use ocean_globe::scene::view::named::VIEWS;
use ocean_globe::scene::view::state::ViewState;

/// Reads a fragment that has no bad pair.
fn good(text: &str) -> ViewState {
    let (state, errors) = ViewState::parse_fragment(text, None);
    assert!(errors.is_empty(), "{text}: {errors:?}");
    state
}

/// Reads a fragment that has exactly one bad pair, and checks that this pair changed nothing.
fn bad(text: &str) {
    let (state, errors) = ViewState::parse_fragment(text, None);
    assert_eq!(errors.len(), 1, "{text}: {errors:?}");
    assert_eq!(state, ViewState::default(), "{text}");
    let mut kept = other_than_default();
    let before = ViewState { unknown: Vec::new(), ..kept.clone() };
    kept.apply_fragment(text, None);
    let key = text.split('=').next().unwrap_or_default();
    let mut expected = ViewState::default();
    match key {
        "view" => expected.camera = before.camera,
        "ride" => expected.ride = before.ride,
        "wind" => expected.settings.wind = before.settings.wind,
        "bft" => expected.settings.beaufort = before.settings.beaufort,
        "spectrum" => expected.settings.spectrum = before.settings.spectrum,
        "fetch" => expected.settings.fetch_km = before.settings.fetch_km,
        "swell" => expected.settings.swell = before.settings.swell,
        "chop" => expected.settings.chop = before.settings.chop,
        "foam" => expected.settings.foam = before.settings.foam,
        "haze" => expected.settings.haze = before.settings.haze,
        "clouds" => expected.settings.clouds = before.settings.clouds,
        "water" => {
            expected.settings.water = before.settings.water;
            expected.settings.water_density_per_m = before.settings.water_density_per_m;
        }
        "surf" => expected.settings.surf = before.settings.surf,
        "time" => expected.time = before.time,
        "rate" => expected.rate = before.rate,
        "seed" => expected.settings.seed = before.settings.seed,
        "mesh" => {
            expected.settings.mesh = before.settings.mesh;
            expected.settings.triangles = before.settings.triangles;
        }
        "quality" => expected.settings.quality = before.settings.quality,
        "datum" => expected.settings.datum = before.settings.datum,
        _ => assert_eq!(key, "v"),
    }
    assert_eq!(kept, expected, "{text} keeps the last good value");
}

/// A state in which every key differs from its default.
fn other_than_default() -> ViewState {
    let mut layers = Layers::default();
    layers.set(Layer::Sky, false);
    ViewState {
        camera: Camera::from_degrees(35.6812, -14.25, 560.0, 120.0, 78.0),
        ride: true,
        settings: Settings {
            wind: Wind { speed_mps: 13.9, from_deg: 240.0 },
            beaufort: Some(7),
            spectrum: Spectrum::Phillips,
            fetch_km: Some(300.0),
            swell: Some(Swell { height_m: 2.5, period_s: 14.0, from_deg: 310.0 }),
            chop: 0.8,
            foam: Foam { amount: 0.5, lifetime_s: 10.0, rule: FoamRule::Folding },
            seed: 7,
            mesh: Mesh::Bisect,
            triangles: Triangles { pixels: 8.5, budget: 60_000 },
            surf: Surf { width: 0.5, beach_slope: 0.1 },
            datum: Datum::Geoid,
            quality: Quality::High,
            layers,
            haze: 0.15,
            clouds: Some(0.35),
            water: Water::Coastal,
            water_density_per_m: 0.3,
        },
        time: SceneTime::At(1_795_176_000.0),
        rate: 60.0,
        unknown: vec!["later=1".into()],
    }
}

#[test]
fn every_key_is_written_in_the_order_of_the_table() {
    let text = other_than_default().format_fragment(None);
    assert_eq!(
        text,
        "view=35.6812,-14.25,560,120,78&ride=1&wind=13.9@240&bft=7&spectrum=phillips&fetch=300&swell=2.5,14,310\
         &chop=0.8&foam=0.5,10&haze=0.15&clouds=0.35&water=coastal,0.3&surf=0.5,0.1&time=2026-11-20T12:00:00Z&rate=60&seed=7&mesh=bisect,8.5,60000&quality=high&datum=geoid&layers=-sky&later=1"
    );
    assert_eq!(good(&text), other_than_default());
}

#[test]
fn the_defaults_are_those_of_the_table_and_are_not_written() {
    let state = ViewState::default();
    assert_eq!(state.format_fragment(None), "");
    assert_eq!(good(""), state);
    assert_eq!(good("#"), state);
    let table = "#view=20,-30,2e7,0,0&ride=0&wind=8@250&spectrum=jonswap&chop=1&foam=1,3.5&haze=0.08&water=auto&surf=1,0.03&time=now&rate=1&seed=0\
                 &quality=auto&datum=ellipsoid&v=1&layers=";
    assert_eq!(good(table), state);
    let s = state.settings;
    assert!(s.beaufort.is_none() && s.fetch_km.is_none() && s.swell.is_none());
    assert!(Layer::ALL.iter().all(|&(layer, _)| s.layers.shows(layer)));
}

#[test]
fn storms_bring_clouds_unless_a_link_says_how_many() {
    let cover = |text: &str| good(text).settings.cloud_cover();
    // Up to a gale as ever: old links look as they did.
    for link in ["", "bft=0", "bft=8", "wind=20.7@250"] {
        assert_eq!(cover(link), 0.45, "{link}");
    }
    let storms = [8, 9, 10, 11, 12].map(|grade| cover(&format!("bft={grade}")));
    assert!(storms.is_sorted_by(|less, more| less < more), "{storms:?}");
    assert!(storms[4] > 0.97, "{storms:?}");
    for said in ["0", "0.2", "0.45"] {
        let state = good(&format!("bft=12&clouds={said}"));
        assert_eq!(state.settings.cloud_cover().to_string(), said);
        assert_eq!(good(&state.format_fragment(None)).settings.cloud_cover().to_string(), said, "after a round trip");
    }
}

#[test]
fn numbers_are_clamped_and_angles_wrap() {
    let camera = |text: &str| good(text).camera;
    assert_eq!(camera("view=95,0,10"), Camera::from_degrees(90.0, 0.0, 10.0, 0.0, 0.0));
    assert_eq!(camera("view=-91,0,10").lat, -std::f64::consts::FRAC_PI_2);
    assert!((camera("view=0,190,10").lon.to_degrees() + 170.0).abs() < 1e-12);
    assert!((camera("view=0,-540,10").lon.to_degrees() + 180.0).abs() < 1e-12);
    assert!(camera("view=0,1e300,10").lon.is_finite());
    assert_eq!(camera("view=0,0,1e9").altitude_m, 4e7);
    assert_eq!(camera("view=0,0,-20000").altitude_m, -11_000.0);
    assert!((camera("view=0,0,10,-90").heading.to_degrees() - 270.0).abs() < 1e-12);
    assert_eq!(camera("view=0,0,10,0,200").tilt, std::f64::consts::PI);
    assert_eq!(camera("view=0,0,10,0,-5").tilt, 0.0);
    let s = |text: &str| good(text).settings;
    assert_eq!(s("wind=80@370").wind, Wind { speed_mps: 60.0, from_deg: 10.0 });
    assert_eq!(s("wind=-3@-10").wind, Wind { speed_mps: 0.0, from_deg: 350.0 });
    assert_eq!(s("wind=5").wind, Wind { speed_mps: 5.0, from_deg: 250.0 });
    assert_eq!((s("bft=13").beaufort, s("bft=-1").beaufort), (Some(12), Some(0)));
    assert_eq!((s("fetch=0").fetch_km, s("fetch=1e5").fetch_km), (Some(1.0), Some(5000.0)));
    assert_eq!(s("swell=30,1,400").swell, Some(Swell { height_m: 20.0, period_s: 3.0, from_deg: 40.0 }));
    assert_eq!(s("swell=-1,40,0").swell, Some(Swell { height_m: 0.0, period_s: 30.0, from_deg: 0.0 }));
    assert_eq!((s("chop=-1").chop, s("chop=3").chop), (0.0, 2.0));
    assert_eq!(s("foam=9,0").foam, Foam { amount: 3.0, lifetime_s: 0.1, rule: FoamRule::Folding });
    assert_eq!(s("foam=-1,99").foam, Foam { amount: 0.0, lifetime_s: 60.0, rule: FoamRule::Folding });
    assert_eq!(s("foam=2").foam, Foam { amount: 2.0, ..Foam::default() });
    assert_eq!(s("foam=1,3.5,height").foam, Foam { rule: FoamRule::Height, ..Foam::default() });
    assert_eq!((good("rate=5000").rate, good("rate=-5000").rate, good("rate=0").rate), (1000.0, -1000.0, 0.0));
    assert_eq!((s("seed=4294967296").seed, s("seed=-1").seed, s("seed=4294967295").seed), (u32::MAX, 0, u32::MAX));
    assert!(good("ride=1").ride && good("ride=7").ride && !good("ride=-2").ride);
    assert_eq!(good("time=1800-01-01T00:00:00Z").time, SceneTime::At(FIRST_S));
    assert_eq!(good("time=9000-01-01T00:00:00Z").time, SceneTime::At(LAST_S));
}

#[test]
fn every_name_of_the_table_is_read() {
    let names = ["phillips", "pierson-moskowitz", "jonswap", "tma", "elfouhaily", "sines", "gerstner"];
    for (name, (spectrum, known)) in names.iter().zip(Spectrum::ALL) {
        assert_eq!((*name, good(&format!("spectrum={name}")).settings.spectrum), (known, spectrum));
    }
    for (name, quality) in ["auto", "low", "medium", "high", "ultra"].iter().zip(Quality::ALL) {
        assert_eq!(good(&format!("quality={name}")).settings.quality, quality.0);
    }
    assert_eq!(good("mesh=grid").settings.mesh, Mesh::Grid);
    let bisected = |text| (good(text).settings.mesh, good(text).settings.triangles);
    let default = Triangles::default();
    assert_eq!(bisected("mesh=bisect"), (Mesh::Bisect, default));
    assert_eq!(bisected("mesh=bisect,9"), (Mesh::Bisect, Triangles { pixels: 9.0, ..default }));
    assert_eq!(bisected("mesh=bisect,1e9,5"), (Mesh::Bisect, Triangles { pixels: 64.0, budget: 1_000 }));
    assert_eq!(["haze=-1", "haze=0.123", "haze=9"].map(|text| good(text).settings.haze), [0.0, 0.123, 0.5]);
    assert_eq!(
        ["clouds=-1", "clouds=0.123", "clouds=9"].map(|text| good(text).settings.clouds),
        [0.0, 0.123, 1.0].map(Some)
    );
    let layers = good("layers=-sea,-sky,land").settings.layers;
    assert!(!layers.shows(Layer::Sea) && !layers.shows(Layer::Sky) && layers.shows(Layer::Land));
    let (state, errors) = ViewState::parse_fragment("layers=-sea,-krakens", None);
    assert_eq!((errors.len(), state.settings.layers.shows(Layer::Sea)), (1, false));
}

#[test]
fn time_is_iso_8601_utc() {
    let at = |text: &str| good(&format!("time={text}")).time;
    let noon = SceneTime::At(1_795_176_000.0);
    for text in [
        "2026-11-20T12:00:00Z",
        "2026-11-20T12:00Z",
        "2026-11-20T12:00:00.000Z",
        "2026-11-20T12:00:00",
        "2026-11-20t12:00:00z",
        "2026-11-20T13:00:00+01:00",
        "2026-11-20T13%3A00%3A00%2B01%3A00",
    ] {
        assert_eq!(at(text), noon, "{text}");
    }
    assert_eq!(at("2026-11-20"), SceneTime::At(1_795_132_800.0));
    assert_eq!(at("1969-12-31T23:59:59.25Z"), SceneTime::At(-0.75));
    assert_eq!(at("NOW"), SceneTime::Now);
    assert_eq!(SceneTime::At(-0.75).to_string(), "1969-12-31T23:59:59.25Z");
    assert_eq!((SceneTime::At(FIRST_S).to_string(), SceneTime::At(LAST_S).to_string()), {
        ("1900-01-01T00:00:00Z".to_owned(), "2200-12-31T23:59:59Z".to_owned())
    });
    assert_eq!(SceneTime::At(f64::MAX).to_string(), "2200-12-31T23:59:59Z");
}

#[test]
fn a_bad_pair_is_reported_and_leaves_the_last_good_value() {
    for text in [
        "view=1,2",
        "view=1,2,3,4,5,6",
        "view=a,2,3",
        "view=NaN,0,10",
        "view=0,inf,10",
        "view=0,0,1e999",
        "view=",
        "ride=yes",
        "wind=@250",
        "wind=8@west",
        "wind=nan@0",
        "bft=4.5",
        "bft=gale",
        "spectrum=pink",
        "fetch=",
        "swell=1,2",
        "swell=1,2,inf",
        "chop=--1",
        "foam=1,2,3",
        "foam=1,2,height,4",
        "haze=thick",
        "clouds=many",
        "water=wine",
        "time=tomorrow",
        "time=2026-13-01T00:00:00Z",
        "time=2026-11-20T25:00:00Z",
        "rate=fast",
        "seed=0.5",
        "seed=0x10",
        "mesh=torus",
        "mesh=grid,8",
        "mesh=bisect,fine",
        "mesh=bisect,8,0.5",
        "mesh=bisect,8,5000,1",
        "quality=best",
        "v=2",
    ] {
        bad(text);
    }
    // A good pair before a bad one of the same key is the last good one.
    let (state, errors) = ViewState::parse_fragment("chop=1.5&chop=x&seed=3", None);
    assert_eq!((state.settings.chop, state.settings.seed, errors.len()), (1.5, 3, 1));
}

#[test]
fn applying_a_link_sets_what_it_does_not_name_to_the_default() {
    let mut state = other_than_default();
    assert!(state.apply_fragment("seed=9", None).is_empty());
    assert_eq!(state, good("seed=9"));
}

#[test]
fn as_many_digits_as_the_view_needs() {
    let text = |altitude_m: f64| {
        let camera = Camera::from_degrees(12.345_678_901_234, -98.765_432_109_876, altitude_m, 12.345_67, 76.543_21);
        ViewState { camera, ..ViewState::default() }.format_fragment(None)
    };
    assert_eq!(text(1.234_56), "view=12.3456789,-98.7654321,1.23,12.35,76.54");
    assert_eq!(text(561.234), "view=12.34568,-98.76543,561.2,12.35,76.54");
    assert_eq!(text(23_456_789.0), "view=12.3,-98.8,23460000,12.35,76.54");
    // A step is at most 1 cm at 1 m.
    let read = good(&text(1.0)).camera;
    assert!((read.lat.to_degrees() - 12.345_678_901_234).abs() * 111_700.0 < 0.01);
}

#[test]
fn rounding_never_leaves_the_range() {
    for (lon, heading) in [(179.999_999_999, 359.999_999), (-179.999_999_999, 0.001), (-180.0, 359.994)] {
        let camera = Camera::from_degrees(0.0, lon, 100.0, heading, 0.0);
        let text = ViewState { camera, ..ViewState::default() }.format_fragment(None);
        assert!(!text.contains(",180,") && !text.contains(",360"), "{text}");
        assert_eq!(good(&text).format_fragment(None), text);
    }
}

#[test]
fn unknown_pairs_stay_as_they_were_written() {
    let text = "seed=5&flavour=s%C3%A9l&x&layer=a%26b";
    assert_eq!(good("x&flavour=s%C3%A9l&seed=5&layer=a%26b").unknown, ["x", "flavour=s%C3%A9l", "layer=a%26b"]);
    let written = good(text).format_fragment(None);
    assert_eq!(written, text);
}

#[test]
fn with_a_name_the_pages_own_pairs_are_untouched() {
    let page = "#intro&tab=2&globe.seed=5&other.seed=6&globe.new=1&globes.seed=8&seed=7";
    let (mut state, errors) = ViewState::parse_fragment(page, Some("globe"));
    assert!(errors.is_empty());
    assert_eq!(state.settings.seed, 5);
    state.settings.chop = 0.5;
    let written = state.format_fragment(Some("globe"));
    assert_eq!(written, "intro&tab=2&other.seed=6&globes.seed=8&seed=7&globe.chop=0.5&globe.seed=5&globe.new=1");
    let (again, _) = ViewState::parse_fragment(&written, Some("globe"));
    assert_eq!(again.format_fragment(Some("globe")), written);
    // A name that would break the pair is encoded.
    let odd = ViewState { rate: 0.0, ..ViewState::default() }.format_fragment(Some("a=b&c"));
    assert_eq!(odd, "a%3Db%26c.rate=0");
    assert_eq!(ViewState::parse_fragment(&odd, Some("a=b&c")).0.rate, 0.0);
}

#[test]
fn a_map_pages_hash_opens_here() {
    let state = good("#4/48.2/16.37");
    assert!(
        (state.camera.lat.to_degrees() - 48.2).abs() < 1e-9 && (state.camera.lon.to_degrees() - 16.37).abs() < 1e-9
    );
    // 720 px of 512-px tiles at zoom 4 and this latitude, seen over 45 degrees.
    let expected = 40_075_016.7 / 512.0 / 16.0 * 48.2f64.to_radians().cos() * 360.0 / 22.5f64.to_radians().tan();
    assert!((state.camera.altitude_m / expected - 1.0).abs() < 1e-3, "{}", state.camera.altitude_m);
    assert!((good("5/48.2/16.37").camera.altitude_m / state.camera.altitude_m - 0.5).abs() < 1e-3);
    // With bearing and pitch the named place stays in the middle of the picture.
    for text in ["12/35.5/-14/40", "12/35.5/-14/40/60", "9/35.5/-14/-40/85", "12/35.5/-14/40/60/extra"] {
        let (state, errors) = ViewState::parse_fragment(text, None);
        if text.ends_with("extra") {
            assert_eq!((errors.len(), state), (1, ViewState::default()));
            continue;
        }
        let size = glam::DVec2::new(1280.0, 720.0);
        let middle = state.camera.unproject(size / 2.0, size).expect("ground");
        assert!(
            (middle.lat.to_degrees() - 35.5).abs() < 1e-6 && (middle.lon.to_degrees() + 14.0).abs() < 1e-6,
            "{text}"
        );
    }
    for text in ["99/0/0", "-99/91/1e9", "3/90/0/0/60", "0/-90/0"] {
        let camera = good(text).camera;
        assert!((1.0..=4e7).contains(&camera.altitude_m) && camera == camera.normalized(), "{text}: {camera:?}");
    }
    assert_eq!(ViewState::parse_fragment("nan/nan/nan", None).1.len(), 1);
    assert_eq!(good("a/b/c").unknown, ["a/b/c"], "a path is not a map");
    let (named, _) = ViewState::parse_fragment("globe=4/48.2/16.37&x=4/1/1", Some("globe"));
    assert_eq!((named.camera, named.unknown), (state.camera, vec!["x=4/1/1".to_owned()]));
}

#[test]
fn at_most_two_kilobytes_are_read_and_written() {
    let long = format!("seed=4&{}&chop=0.5", "a=".to_owned() + &"z".repeat(LONGEST));
    let (state, errors) = ViewState::parse_fragment(&long, None);
    assert_eq!((state.settings.seed, state.settings.chop, state.unknown.len(), errors.len()), (4, 1.0, 0, 1));
    let many = (0..1000).map(|i| format!("k{i}=v")).collect::<Vec<_>>().join("&");
    let (state, _) = ViewState::parse_fragment(&many, None);
    assert!(!state.unknown.is_empty() && state.format_fragment(None).len() <= LONGEST);
    let crowded = ViewState { unknown: vec!["u=".to_owned() + &"y".repeat(2030)], ..other_than_default() };
    let written = crowded.format_fragment(None);
    assert!(written.len() <= LONGEST && written.contains("layers=-sky") && !written.contains("yyy"));
}

#[test]
fn the_named_views_are_good_links_in_their_shortest_form() {
    for view in VIEWS {
        let state = good(view.fragment);
        assert_eq!(state.format_fragment(None), view.fragment, "{}", view.id);
        assert_ne!(state.time, SceneTime::Now, "{} looks the same for everyone", view.id);
    }
}
