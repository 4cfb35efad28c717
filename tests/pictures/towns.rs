//! Towns on the land: houses where there is a town, no house on the water, none of their light by day, and as bright from afar as from near.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [320, 180];

fn measured(renderer: &mut Renderer, fragment: &str, layer: LayerName) -> Vec<f64> {
    render::measure(renderer, &render::parse_state(fragment).unwrap(), SIZE, layer).unwrap().values
}

/// Albedo of a view's pixels.
fn albedo(renderer: &mut Renderer, view: &str) -> Vec<[f64; 3]> {
    measured(renderer, &format!("#view={view}&time=2026-06-21T16:30:00Z&clouds=0"), LayerName::Albedo)
        .as_chunks()
        .0
        .to_vec()
}

fn mean(albedo: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|part| albedo.iter().map(|texel| texel[part]).sum::<f64>() / albedo.len() as f64)
}

/// How much of green there is over red and blue, of all of it.
fn greenness([r, g, b]: [f64; 3]) -> f64 {
    (g - 0.5 * (r + b)) / g
}

#[test]
fn brooklyn_is_built_up_and_the_catskills_are_not() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let renderer = &mut renderer;
    // Ten metres a pixel, so that roofs are told from streets.
    let town = albedo(renderer, "40.645,-73.95,2500,0,0");
    let country = albedo(renderer, "42.2,-74.3,2500,0,0");
    let brightness = |texel: &[f64; 3]| (texel[0] + texel[1] + texel[2]) / 3.0;
    let deviation = |albedo: &[[f64; 3]]| {
        let middle = albedo.iter().map(brightness).sum::<f64>() / albedo.len() as f64;
        let square = albedo.iter().map(|texel| (brightness(texel) / middle - 1.0).powi(2)).sum::<f64>();
        (square / albedo.len() as f64).sqrt()
    };
    let [of_town, of_country] = [&town, &country].map(|all| (greenness(mean(all)), deviation(all)));
    println!("greenness, deviation: town {of_town:.3?}, country {of_country:.3?}; {:.3?}", mean(&town));
    assert!(of_town.0 < 0.12, "{}", of_town.0);
    assert!(of_country.0 > 0.25, "{}", of_country.0);
    // Roofs from 0.07 to 0.32, streets of 0.085, shadows of a third.
    assert!(of_town.1 > 0.35, "{}", of_town.1);
}

#[test]
fn a_town_is_as_bright_from_afar_as_from_near() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // The same 4.5 km of Brooklyn, where it has no park: pixels of 1.4 lots, and of eight.
    let near = mean(&albedo(&mut renderer, "40.645,-73.95,5000,0,0"));
    let far = albedo(&mut renderer, "40.645,-73.95,30000,0,0");
    let [width, height] = SIZE.map(|side| side as usize);
    let within = |at: &usize| {
        let [x, y] = [at % width, at / width].map(|at| at as f64 + 0.5);
        (x - width as f64 / 2.0).abs() < width as f64 / 12.0 && (y - height as f64 / 2.0).abs() < height as f64 / 12.0
    };
    let far: Vec<_> = (0..far.len()).filter(within).map(|at| far[at]).collect();
    let far = mean(&far);
    println!("near {near:.4?}, far {far:.4?}");
    let each = [0, 1, 2].map(|part| far[part] / near[part]);
    // What is hidden of walls and in shadows is one number for all towns: by the sun's height it differs by so much.
    assert!(each.iter().all(|ratio| (ratio - 1.0).abs() < 0.12), "{each:?}");
}

#[test]
fn lamps_of_streets_are_lit_by_night_alone() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut luminance = |rest: &str| {
        let link = format!("#view=40.645,-73.95,600,0,0&clouds=0{rest}");
        measured(&mut renderer, &link, LayerName::Luminance)
    };
    let [day, dark_day] = ["", "&layers=-lights"].map(|rest| luminance(&format!("&time=2026-06-21T16:30:00Z{rest}")));
    assert!(day.iter().zip(&dark_day).all(|(lit, unlit)| lit == unlit), "lamps by day");
    let [night, unlit] = ["", "&layers=-lights"].map(|rest| luminance(&format!("&time=2026-11-10T03:00:00Z{rest}")));
    let share = |all: &[f64], least: f64| all.iter().filter(|l| **l > least).count() as f64 / all.len() as f64;
    let brightest = unlit.iter().copied().fold(0.0, f64::max);
    let lit = share(&night, 3.0 * brightest);
    println!("{lit:.3} of the pixels are three times brighter than the brightest without lamps, {brightest:.4}");
    assert!((0.02..0.5).contains(&lit), "{lit}");
}
