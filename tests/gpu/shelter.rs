//! The lee of an island as it is drawn: the heights that the CPU tells, as low as the model has them, and the same for every eye.

use glam::DVec2;
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::exposure::{Found, Water};
use ocean_globe::data::tile::Layer;
use ocean_globe::model::earth::{self, WGS84};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::sea::shelter::of_patches;
use ocean_globe::scene::settings::Settings;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const WEATHER: &str = "&clouds=0&wind=12@45&time=2026-11-20T12:00:00Z&rate=0";
const NOON: f64 = 1_795_176_000.0;

/// Gains of the patches' waves at a place, radians, and how much higher all waves are.
fn gains(renderer: &mut Renderer, settings: &Settings, seas: &mut Seas, lat: f64, lon: f64) -> ([f64; 4], f64) {
    let tables = seas.tables(settings);
    let world = renderer.world_mut();
    let mut look = |id| match world.tile_blocking(Layer::Water, id) {
        Ok(Some(texels)) => Found::Tile(texels),
        _ => Found::Absent,
    };
    let found = seas.shelter.at((&tables, settings.wind_from()), (Water::Ocean, lat, lon), &mut look).unwrap();
    (of_patches(found), tables.height_gain(of_patches(found)))
}

/// Heights of the water in a picture straight down, of a place in degrees from so high up.
fn heights(renderer: &mut Renderer, [lat, lon]: [f64; 2], altitude_m: f64, size: [u32; 2]) -> Vec<f64> {
    let state = render::parse_state(&format!("#view={lat},{lon},{altitude_m},0,0{WEATHER}")).unwrap();
    render::measure(renderer, &state, size, LayerName::Height).unwrap().values
}

#[test]
fn drawn_heights_in_a_lee_are_those_of_the_sample() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut seas = Seas::default();
    // Beside Tenerife, and behind an island that is alone within 1,000 km.
    for place in ["28.0,-16.8", "28.6,-16.45", "-16.03,-5.83"] {
        let state = render::parse_state(&format!("#view={place},0.5,0,0{WEATHER}")).unwrap();
        let drawn = render::measure(&mut renderer, &state, [257, 257], LayerName::Height).unwrap().values;
        let eye = renderer.eye(&state, NOON);
        let mut errors = Vec::new();
        for (row, column) in (8..250).step_by(40).flat_map(|row| (8..250).step_by(40).map(move |column| (row, column)))
        {
            let drawn_m = drawn[row * 257 + column];
            let level = earth::Ellipsoid { a: WGS84.a + drawn_m, b: WGS84.b + drawn_m };
            let pixel = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
            let hit = eye.unproject_onto(&level, pixel, DVec2::splat(257.0)).unwrap();
            let at = WGS84.geodetic_from_ecef(hit).unwrap();
            let (gains, _) = gains(&mut renderer, &state.settings, &mut seas, at.lat, at.lon);
            let sample = seas.sample_in(&state.settings, (at.lat, at.lon), NOON, f64::INFINITY, gains);
            errors.push((sample.height_m - drawn_m).abs());
        }
        errors.sort_by(f64::total_cmp);
        let [median, most] = [errors[errors.len() / 2], errors[errors.len() * 95 / 100]];
        println!("{place}: median {median:.4} m, 95 % {most:.4} m");
        // As in the open sea (`surface_sample`), and a quarter of a thousandth for gains of 16 bits.
        assert!(median < 0.005 && most < 0.012, "{place}: {median} {most}");
    }
}

#[test]
fn a_drawn_lee_is_as_low_as_the_model_has_it() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut seas = Seas::default();
    let settings = render::parse_state(&format!("#{WEATHER}")).unwrap().settings;
    let hs_m = seas.tables(&settings).sea.hs_m;
    // From 400 m a picture is some 600 by 350 m of sea, and cells of the mesh are 8 m: they hold all waves that have height. Eight of them, a
    // kilometre apart across the wind, hold two hundred waves, whose height is good to 6 %.
    let mut drawn = |[lat, lon]: [f64; 2]| {
        let places = (0..8).map(|i| 0.009 * (f64::from(i) - 3.5)).map(|way| [lat - way, lon + way]);
        let (mut values, mut energy) = (Vec::new(), 0.0);
        for place in places {
            values.extend(heights(&mut renderer, place, 400.0, [320, 180]));
            let (_, gain) = gains(&mut renderer, &settings, &mut seas, place[0].to_radians(), place[1].to_radians());
            energy += gain * gain / 8.0;
        }
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let height = 4.0 * (values.iter().map(|h| (h - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt();
        (height, energy.sqrt())
    };
    let (open_m, open_gain) = drawn([29.5, -14.9]);
    assert!(open_gain > 0.98, "{open_gain}");
    let open = open_m / hs_m;
    println!("open sea: {open_m:.2} m, {open:.3} of the sea's");
    assert!((open - 1.0).abs() < 0.15, "{open}");
    for place in [[28.0, -16.8], [27.5, -17.3]] {
        let (height_m, gain) = drawn(place);
        println!("{place:?}: {:.3} of the open sea's {open_m:.2} m, the model {gain:.3}", height_m / open_m);
        // Both heights are good to 6 %, and cells of 8 m lose the lee's shortest waves, 5 % of its height.
        assert!((height_m / open_m / gain - 1.0).abs() < 0.15, "{place:?}: {} {gain}", height_m / open_m);
    }
}

#[test]
fn two_eyes_see_the_same_heights_in_a_lee() {
    let mut first = render::headless(DATA, Radiance::Single).unwrap();
    let mut second = render::headless(DATA, Radiance::Single).unwrap();
    // The second one has been elsewhere, so that its nodes and tiles came in another order; both look down on the same water.
    heights(&mut second, [27.5, -15.9], 60_000.0, [64, 64]);
    heights(&mut second, [28.1, -16.95], 5_000.0, [64, 64]);
    let [a, b] = [&mut first, &mut second].map(|renderer| heights(renderer, [28.0, -16.8], 300.0, [128, 128]));
    assert_eq!(a, b);
}

#[test]
fn lakes_are_drawn_at_their_level() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Waves have a test of their own (`lake`).
    let calm = WEATHER.replace("wind=12@45", "bft=0");
    assert_ne!(calm, WEATHER);
    // Place, level, height of the eye over the ellipsoid, metres: near, and from 10 km.
    for (place, level_m, altitude_m) in [
        ("47.7,-87.5", 183.0, 400.0),
        ("42,50.5", -28.0, 10_000.0),
        ("46.45,6.5", 372.0, 600.0),
        ("-15.8,-69.4", 3812.0, 4_000.0),
        ("31.5,35.48", -430.0, 100.0),
    ] {
        let state = render::parse_state(&format!("#view={place},{altitude_m},0,0{calm}")).unwrap();
        let told_m = render::measure(&mut renderer, &state, [65, 65], LayerName::Height).unwrap().values[32 * 65 + 32];
        // Beside a height the texture holds the distance.
        let texels = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
        let middle = bytemuck::pod_read_unaligned::<[f32; 4]>(&texels[16 * (32 * 65 + 32)..][..16]);
        let drawn_m = altitude_m - f64::from(middle[1]);
        assert!((told_m - level_m).abs() < 1e-3, "{place}: {told_m}");
        println!("{place}: drawn at {drawn_m:.2} m, the table's {level_m}");
        // Distances are in 32 bits; cells of a kilometre bend by 2 cm less than the earth.
        assert!((drawn_m - level_m).abs() < 0.1 + 1e-5 * altitude_m, "{place}: {drawn_m}");
    }
}
