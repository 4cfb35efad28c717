//! Lakes with a mesh of their own at their level: waves as high as the CPU tells, and no step where the mesh ends.

use glam::DVec2;
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::exposure::{Found, Water};
use ocean_globe::data::tile::Layer;
use ocean_globe::model::earth::{self, WGS84};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::sea::shelter::of_patches;
use ocean_globe::scene::settings::Settings;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const WEATHER: &str = "&clouds=0&wind=8@45&time=2026-11-20T18:00:00Z&rate=0";
const EVENING: f64 = 1_795_197_600.0;

/// Gains of the patches' waves on a lake at a place, radians.
fn gains(renderer: &mut Renderer, settings: &Settings, seas: &mut Seas, lat: f64, lon: f64) -> [f64; 4] {
    let tables = seas.tables(settings);
    let world = renderer.world_mut();
    let mut look = |id| match world.tile_blocking(Layer::Water, id) {
        Ok(Some(texels)) => Found::Tile(texels),
        _ => Found::Absent,
    };
    let place = (Water::Lake, lat, lon);
    of_patches(seas.shelter.at((&tables, settings.wind_from()), place, &mut look).unwrap())
}

#[test]
fn drawn_heights_of_lakes_are_those_of_the_sample() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut seas = Seas::default();
    // Cells of the mesh 2 cm wide.
    const SIDE: u32 = 769;
    let pixels = || (24..750).step_by(120);
    // Lake Superior, Lake Titicaca and the Caspian Sea, which lies below the ocean's level; from as near as the waves let an eye come.
    for (place, level_m) in [("47.5,-87.5", 183.0), ("-15.9,-69.4", 3812.0), ("42,51", -28.0)] {
        let state = render::parse_state(&format!("#view={place},{level_m},0,0{WEATHER}")).unwrap();
        let measured = render::measure(&mut renderer, &state, [SIDE; 2], LayerName::Height).unwrap();
        let eye = renderer.eye(&state, EVENING);
        let (mut errors, mut heights) = (Vec::new(), Vec::new());
        for (row, column) in pixels().flat_map(|row| pixels().map(move |column| (row, column))) {
            let drawn_m = measured.values[row * SIDE as usize + column];
            let level = earth::Ellipsoid { a: WGS84.a + drawn_m, b: WGS84.b + drawn_m };
            let pixel = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
            let hit = eye.unproject_onto(&level, pixel, DVec2::splat(f64::from(SIDE))).unwrap();
            let at = WGS84.geodetic_from_ecef(hit).unwrap();
            let gains = gains(&mut renderer, &state.settings, &mut seas, at.lat, at.lon);
            let sample = seas.sample_in(&state.settings, (at.lat, at.lon), EVENING, f64::INFINITY, gains);
            errors.push((level_m + sample.height_m - drawn_m).abs());
            heights.push(sample.height_m.abs());
        }
        errors.sort_by(f64::total_cmp);
        let [median, most] = [errors[errors.len() / 2], errors[errors.len() * 95 / 100]];
        let highest = heights.iter().copied().fold(0.0, f64::max);
        println!("{place}: median {median:.4} m, 95 % {most:.4} m of waves up to {highest:.2} m");
        // As in the open sea; those of Titicaca are 3,800 m up, which 32 bits tell to a quarter of a millimetre.
        assert!(median < 0.005 && most < 0.012, "{place}: {median} {most}");
        assert!(highest > 0.2, "{place}: {highest}");
    }
}

/// Luminance of the middle of a picture of a lake from so high over it, and whether it has its mesh.
fn seen(renderer: &mut Renderer, over_m: f64) -> (f64, bool) {
    let link = format!("#view=47.5,-87.5,{},230,60{WEATHER}", 183.0 + over_m);
    let state = render::parse_state(&link).unwrap();
    let size = [160, 90];
    let values = render::measure(renderer, &state, size, LayerName::Radiance).unwrap().values;
    let frame: Frame = renderer.frame(&state.settings, &state.camera, EVENING, size);
    let middle = values.chunks_exact(3).skip(160 * 40).map(|rgb| 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]);
    (middle.sum::<f64>() / (160.0 * 50.0), frame.lake.is_some())
}

#[test]
fn a_lake_looks_alike_where_its_mesh_ends() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // The mesh ends where the waves are a quarter of a pixel high.
    let mut over_m = 100.0;
    while seen(&mut renderer, over_m).1 {
        over_m *= 1.05;
    }
    let [(below, has_mesh), (above, has_none)] = [over_m / 1.05, over_m].map(|over_m| seen(&mut renderer, over_m));
    println!("mesh up to {over_m:.0} m: {below:.4e} with it, {above:.4e} without");
    assert!(has_mesh && !has_none);
    // The air of 30 m of height, and what crests hide of each other.
    assert!((below / above - 1.0).abs() < 0.006, "{below} {above}");
}
