//! Links of any state and of any enemy: what is written reads back, and what is read is valid.

use ocean_globe::scene::layers::{Layer, Layers};
use ocean_globe::scene::link::fragment::LONGEST;
use ocean_globe::scene::settings::{Foam, FoamRule, Mesh, Quality, Settings, Spectrum, Surf, Swell, Water, Wind};
use ocean_globe::scene::time::{FIRST_S, LAST_S, SceneTime};
use ocean_globe::scene::view::camera::Camera;
use ocean_globe::scene::view::state::ViewState;
use proptest::prelude::*;

/// Whether every number of a state is finite and in the table's range.
fn is_valid(state: &ViewState) -> bool {
    let (c, s) = (state.camera, &state.settings);
    let in_range = |value: f64, low: f64, high: f64| (low..=high).contains(&value);
    let time_ok = match state.time {
        SceneTime::Now => true,
        SceneTime::At(seconds) => in_range(seconds, FIRST_S, LAST_S),
    };
    c == c.normalized()
        && in_range(c.altitude_m, -11_000.0, 4e7)
        && in_range(s.wind.speed_mps, 0.0, 60.0)
        && (0.0..360.0).contains(&s.wind.from_deg)
        && s.beaufort.is_none_or(|grade| grade <= 12)
        && s.fetch_km.is_none_or(|km| in_range(km, 1.0, 5000.0))
        && s.swell.is_none_or(|w| {
            in_range(w.height_m, 0.0, 20.0) && in_range(w.period_s, 3.0, 30.0) && (0.0..360.0).contains(&w.from_deg)
        })
        && in_range(s.chop, 0.0, 2.0)
        && in_range(s.foam.amount, 0.0, 3.0)
        && in_range(s.foam.lifetime_s, 0.1, 60.0)
        && in_range(s.haze, 0.0, 0.5)
        && s.clouds.is_none_or(|clouds| in_range(clouds, 0.0, 1.0))
        && in_range(state.rate, -1000.0, 1000.0)
        && time_ok
}

/// A small generator (xorshift64*), so that the hostile links are the same on every machine.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % sides
    }

    fn pick<'a>(&mut self, from: &[&'a str]) -> &'a str {
        from[self.roll(from.len())]
    }
}

#[test]
fn ten_thousand_hostile_fragments_leave_a_valid_state() {
    let keys = [
        "view",
        "ride",
        "wind",
        "bft",
        "spectrum",
        "fetch",
        "swell",
        "chop",
        "foam",
        "haze",
        "clouds",
        "water",
        "surf",
        "time",
        "rate",
        "seed",
        "mesh",
        "quality",
        "datum",
        "layers",
        "v",
        "",
        "globe.view",
        "%76iew",
        "VIEW",
        "__proto__",
        "view%00",
        "é",
        "🌊",
        "%",
        "%f",
    ];
    let bits = [
        "0",
        "1",
        "-1",
        "90",
        "180",
        "-180",
        "360",
        "1e7",
        "1e308",
        "1e999",
        "-1e999",
        "nan",
        "NaN",
        "inf",
        "-inf",
        "infinity",
        "-0",
        "+5",
        ".",
        "-",
        "--",
        "0x1F",
        "1_000",
        "1e",
        "4294967296",
        "99999999999999999999",
        "1e-320",
        ",",
        ",,",
        "@",
        "@@",
        "/",
        "//",
        ":",
        "T",
        "Z",
        "now",
        "2026-11-20T12:00:00Z",
        "-999999-01-01T00:00:00Z",
        "9999-12-31T23:59:59.999999999Z",
        "2026-02-30",
        "24:00",
        "+14:00",
        "phillips",
        "grid",
        "auto",
        "-sea",
        "land",
        "%",
        "%2",
        "%2C",
        "%00",
        "%FF",
        "%C3%28",
        "\u{0}",
        "\u{202e}",
        "é",
        "🌊",
        "\\",
        "\"",
        "'",
        "<script>",
        "javascript:",
        "https://evil.example/{z}",
        "../../etc",
        "=",
        "&",
        "#",
        "?",
        " ",
        "\n",
        "\t",
        "..",
        "e",
        "E5",
    ];
    let names = [None, None, None, Some("globe"), Some("globe"), Some(""), Some("%"), Some("🌊")];
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15);
    let mut kept = ViewState::default();
    let (mut reported, mut changed) = (0, 0);
    for number in 0..10_000 {
        let mut text = String::from(dice.pick(&["", "#", "##", "&", "#&"]));
        let name = names[dice.roll(names.len())];
        for _ in 0..dice.roll(8) {
            text += if name == Some("globe") { dice.pick(&["globe.", ""]) } else { "" };
            if dice.roll(4) == 0 {
                text += dice.pick(&["view=45,170,2e4,9,80", "wind=9@99", "bft=3", "chop=0.5", "swell=1,2,3", "seed=8"]);
            } else {
                text += dice.pick(&keys);
                text += dice.pick(&["=", "=", "=", "=", "", "=="]);
            }
            for _ in 0..dice.roll(3) * dice.roll(5) {
                text += dice.pick(&bits);
                text += dice.pick(&["", "", ",", "@", "/"]);
            }
            text += dice.pick(&["&", "&", "&", "&&", "#", ""]);
        }
        if number % 500 == 0 {
            text += &dice.pick(&bits).repeat(3000);
        }
        let (state, errors) = ViewState::parse_fragment(&text, name);
        reported += errors.len();
        changed += usize::from(state != ViewState { unknown: state.unknown.clone(), ..ViewState::default() });
        assert!(is_valid(&state), "{text:.300?} gives {:?}", state.camera);
        kept.apply_fragment(&text, name);
        assert!(is_valid(&kept), "{text:.300?} gives {:?}", kept.camera);
        let written = state.format_fragment(name);
        let again = ViewState::parse_fragment(&written, name).0;
        assert!(again.format_fragment(name) == written, "not stable: {text:.300} {written:.300}");
        if name.is_none() {
            assert!(written.len() <= LONGEST, "{} bytes", written.len());
        }
    }
    // The generator reaches both sides: bad pairs and good ones.
    assert!(reported > 5000 && changed > 500, "{reported} reports, {changed} changes");
}

fn any_state() -> impl Strategy<Value = ViewState> {
    let camera = (-90.0..=90.0, -180.0..180.0, -6.0..7.6f64, 0.0..360.0, 0.0..=180.0).prop_map(
        |(lat, lon, exponent, heading, tilt)| Camera::from_degrees(lat, lon, 10f64.powf(exponent), heading, tilt),
    );
    let wind = (0.0..=60.0, 0.0..360.0).prop_map(|(speed_mps, from_deg)| Wind { speed_mps, from_deg });
    let swell = (0.0..=20.0, 3.0..=30.0, 0.0..360.0);
    let swell = swell.prop_map(|(height_m, period_s, from_deg)| Swell { height_m, period_s, from_deg });
    let rule = prop_oneof![Just(FoamRule::Folding), Just(FoamRule::Height)];
    let foam = (0.0..=3.0, 0.1..=60.0, rule).prop_map(|(amount, lifetime_s, rule)| Foam { amount, lifetime_s, rule });
    let layers = (0u32..1 << Layer::ALL.len()).prop_map(|bits| {
        let mut layers = Layers::default();
        Layer::ALL.iter().enumerate().for_each(|(i, &(layer, _))| layers.set(layer, bits >> i & 1 == 1));
        layers
    });
    let settings = (
        (wind, proptest::option::of(0u8..=12), 0usize..7, proptest::option::of(1.0..=5000.0)),
        (proptest::option::of(swell), 0.0..=2.0, foam, any::<u32>()),
        (0usize..2, 0usize..5, layers, (0u16..=500, 0u16..=1000), (0usize..7, 100u16..=300, 0u16..=3000, 10u16..=300)),
    );
    let settings =
        settings.prop_map(|((wind, beaufort, spectrum, fetch_km), (swell, chop, foam, seed), rest)| Settings {
            wind,
            beaufort,
            spectrum: Spectrum::ALL[spectrum].0,
            fetch_km,
            swell,
            chop,
            foam,
            seed,
            mesh: Mesh::ALL[rest.0].0,
            quality: Quality::ALL[rest.1].0,
            layers: rest.2,
            haze: f64::from(rest.3.0) / 1000.0,
            clouds: Some(f64::from(rest.3.1) / 1000.0).filter(|cover| *cover != 0.5),
            water: Water::ALL[rest.4.0].0,
            water_density_per_m: f64::from(rest.4.1) / 1000.0,
            surf: Surf { width: f64::from(rest.4.2) / 1000.0, beach_slope: f64::from(rest.4.3) / 1000.0 },
            ..Settings::default()
        });
    let time = proptest::option::of(FIRST_S..=LAST_S).prop_map(|at| at.map_or(SceneTime::Now, SceneTime::At));
    (camera, any::<bool>(), settings, time, -1000.0..=1000.0).prop_map(|(camera, ride, settings, time, rate)| {
        ViewState { camera, ride, settings, time, rate, unknown: Vec::new() }
    })
}

/// The difference of two angles in degrees, across the wrap.
fn apart_deg(a: f64, b: f64) -> f64 {
    let difference = (a - b).abs() % 360.0;
    difference.min(360.0 - difference)
}

proptest! {
    #[test]
    fn a_state_survives_the_way_through_its_link(state in any_state(), named in any::<bool>()) {
        let name = named.then_some("globe");
        let text = state.format_fragment(name);
        let (read, errors) = ViewState::parse_fragment(&text, name);
        prop_assert!(errors.is_empty(), "{}: {:?}", text, errors);
        prop_assert!(is_valid(&read));
        prop_assert_eq!(read.format_fragment(name), text.clone(), "writing again gives the same text");
        // Unseen from the eye: 1/1000 of the height, or 1 cm.
        let (a, b) = (state.camera, read.camera);
        let unseen_m = (a.altitude_m * 1.001e-3).max(0.01);
        prop_assert!((a.lat - b.lat).to_degrees().abs() * 111_700.0 <= unseen_m, "{}", text);
        prop_assert!(apart_deg(a.lon.to_degrees(), b.lon.to_degrees()) * 111_700.0 <= unseen_m, "{}", text);
        prop_assert!((a.altitude_m - b.altitude_m).abs() <= unseen_m, "{}", text);
        prop_assert!(apart_deg(a.heading.to_degrees(), b.heading.to_degrees()) <= 0.005 + 1e-9);
        prop_assert!((a.tilt - b.tilt).to_degrees().abs() <= 0.005 + 1e-9);
        let (s, t) = (&state.settings, &read.settings);
        prop_assert!((s.wind.speed_mps - t.wind.speed_mps).abs() <= 0.0005 + 1e-9);
        prop_assert!(apart_deg(s.wind.from_deg, t.wind.from_deg) <= 0.005 + 1e-9);
        prop_assert!((s.chop - t.chop).abs() <= 0.0005 + 1e-9 && (s.foam.amount - t.foam.amount).abs() <= 0.0005 + 1e-9);
        prop_assert_eq!(s.foam.rule, t.foam.rule);
        prop_assert!((s.foam.lifetime_s - t.foam.lifetime_s).abs() <= 0.0005 + 1e-9);
        prop_assert_eq!(s.fetch_km.is_some(), t.fetch_km.is_some());
        prop_assert!((s.fetch_km.unwrap_or(0.0) - t.fetch_km.unwrap_or(0.0)).abs() <= 0.0005 + 1e-9);
        prop_assert_eq!(s.swell.is_some(), t.swell.is_some());
        if let (Some(w), Some(x)) = (s.swell, t.swell) {
            prop_assert!((w.height_m - x.height_m).abs() <= 0.0005 + 1e-9 && apart_deg(w.from_deg, x.from_deg) <= 0.005 + 1e-9);
            prop_assert!((w.period_s - x.period_s).abs() <= 0.0005 + 1e-9);
        }
        prop_assert_eq!((s.beaufort, s.spectrum, s.seed, s.haze, s.water), (t.beaufort, t.spectrum, t.seed, t.haze, t.water));
        prop_assert_eq!(s.clouds, t.clouds);
        prop_assert_eq!((s.water_density_per_m, s.surf), (t.water_density_per_m, t.surf));
        prop_assert_eq!((s.mesh, s.quality, s.layers, state.ride), (t.mesh, t.quality, t.layers, read.ride));
        prop_assert!((state.rate - read.rate).abs() <= 5e-7 + 1e-9);
        match (state.time, read.time) {
            (SceneTime::At(a), SceneTime::At(b)) => prop_assert!((a - b).abs() <= 0.0005 + 1e-6),
            (a, b) => prop_assert_eq!(a, b),
        }
    }
}
