//! Lakes with a mesh of their own at their level: waves as high as `sample` tells, and no step where the mesh ends.

use glam::DVec2;
use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::world::World;
use ocean_globe::model::earth::{self, WGS84};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::measured_place::{MeasuredPlaces, Question};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const WEATHER: &str = "&wind=8@45&time=2026-11-20T18:00:00Z&rate=0";
const EVENING: f64 = 1_795_197_600.0;
const SUPERIOR: &str = "47.5,-87.5,190";

/// A measured layer of a link.
fn layer(renderer: &mut Renderer, link: &str, size: [u32; 2], name: LayerName) -> Vec<f64> {
    render::measure(renderer, &render::parse_state(link).unwrap(), size, name).unwrap().values
}

/// What `sample` says of the surface at a place in degrees.
fn sampled(world: &mut World, places: &mut MeasuredPlaces, link: &str, at: (f64, f64)) -> serde_json::Value {
    let asked = Question::of_link(link, at, None, 0.0).unwrap();
    places.at(world, &asked, World::look_blocking).unwrap().unwrap()["surface"].clone()
}

#[test]
fn drawn_heights_of_lakes_are_those_of_the_sample() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let (mut world, mut places) = (World::open(DATA), MeasuredPlaces::default());
    // Cells of the mesh 2 cm wide.
    const SIDE: u32 = 769;
    let pixels = || (24..750).step_by(120);
    // Lake Superior, Lake Titicaca and the Caspian Sea, which lies below the ocean's level; from as near as the waves let an eye come.
    for (place, level_m) in [("47.5,-87.5", 183.0), ("-15.9,-69.4", 3812.0), ("42,51", -28.0)] {
        let link = format!("#view={place},{level_m},0,0{WEATHER}");
        let drawn = layer(&mut renderer, &link, [SIDE; 2], LayerName::Height);
        let eye = renderer.eye(&render::parse_state(&link).unwrap(), EVENING);
        let (mut errors, mut heights) = (Vec::new(), Vec::new());
        for (row, column) in pixels().flat_map(|row| pixels().map(move |column| (row, column))) {
            let drawn_m = drawn[row * SIDE as usize + column];
            let level = earth::Ellipsoid { a: WGS84.a + drawn_m, b: WGS84.b + drawn_m };
            let pixel = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
            let hit = eye.unproject_onto(&level, pixel, DVec2::splat(f64::from(SIDE))).unwrap();
            let at = WGS84.geodetic_from_ecef(hit).unwrap();
            let told = sampled(&mut world, &mut places, &link, (at.lat.to_degrees(), at.lon.to_degrees()));
            let told_m = told["height_m"].as_f64().unwrap();
            errors.push((told_m - drawn_m).abs());
            heights.push((told_m - level_m).abs());
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

#[test]
fn coarse_pictures_and_those_without_land_have_no_waves_on_lakes() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let size = [64, 64];
    let low = format!("#view={SUPERIOR},0,0{WEATHER}&quality=low");
    let heights = layer(&mut renderer, &low, size, LayerName::Height);
    assert!(heights.iter().all(|height_m| (height_m - 183.0).abs() < 1e-3), "{heights:?}");
    let (mut world, mut places) = (World::open(DATA), MeasuredPlaces::default());
    assert!(sampled(&mut world, &mut places, &low, (47.5, -87.5)).is_null());
    let bare = format!("#view={SUPERIOR},0,0{WEATHER}&layers=-land");
    let classes = layer(&mut renderer, &bare, size, LayerName::Class);
    assert!(classes.iter().all(|class| *class != 2.0), "{classes:?}");
}

/// Mean luminance of the lower half of a picture of a lake from so high over it, and how much the heights that it shows differ, metres.
fn seen(renderer: &mut Renderer, lake: (&str, f64), weather: &str, over_m: f64) -> (f64, f64) {
    let link = format!("#view={},{},230,60{WEATHER}{weather}", lake.0, lake.1 + over_m);
    let size = [160, 90];
    let values = layer(renderer, &link, size, LayerName::Radiance);
    let lower = values.chunks_exact(3).skip(160 * 45).map(|rgb| 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]);
    let heights = layer(renderer, &link, size, LayerName::Height);
    let [least, greatest] =
        [f64::min as fn(f64, f64) -> f64, f64::max].map(|f| heights[160 * 45..].iter().copied().reduce(f).unwrap());
    (lower.sum::<f64>() / (160.0 * 45.0), greatest - least)
}

#[test]
fn a_lake_looks_alike_where_its_mesh_ends() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Lake Superior, and Lake Tahoe, which lies higher than clouds do over the sea.
    for lake in [("47.5,-87.5", 183.0), ("39.1,-120.03", 1897.0)] {
        for weather in ["&clouds=0", "&clouds=0.9"] {
            // The mesh ends where the waves are a quarter of a pixel high.
            let [mut low_m, mut high_m] = [100.0_f64, 4_000.0];
            while high_m / low_m > 1.01 {
                let middle_m = (low_m * high_m).sqrt();
                let has_waves = seen(&mut renderer, lake, weather, middle_m).1 > 0.01;
                *(if has_waves { &mut low_m } else { &mut high_m }) = middle_m;
            }
            let [(below, waves_m), (above, none_m)] =
                [low_m, high_m].map(|over_m| seen(&mut renderer, lake, weather, over_m));
            println!(
                "{lake:?}{weather}: up to {low_m:.0} m, waves of {waves_m:.2} m: {:.4} of what is seen without",
                below / above
            );
            assert!(waves_m > 0.01 && none_m < 0.01, "{lake:?}: {waves_m} {none_m}");
            // A hundredth of the height, and what crests hide of each other.
            assert!((below / above - 1.0).abs() < 0.006, "{lake:?}{weather}: {below} {above}");
        }
    }
}
