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
    // Four metres a pixel, so that roofs are told from streets.
    let town = albedo(renderer, "40.645,-73.95,1000,0,0");
    let country = albedo(renderer, "42.2,-74.3,1000,0,0");
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
    // Roofs from 0.09 to 0.38, pavements of 0.16, roads of 0.085, crowns of 0.05, shadows of a third.
    assert!(of_town.1 > 0.35, "{}", of_town.1);
}

#[test]
fn no_house_stands_on_a_steep_slope() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let link = "#view=32.63,-16.9,500,340,76&time=2026-06-20T12:30:00Z&clouds=0";
    let [albedo, normals, class] =
        [LayerName::Albedo, LayerName::Normal, LayerName::Class].map(|layer| measured(&mut renderer, link, layer));
    // Funchal: pixels of roofs and walls that are brighter than any ground there, of those of land between two slopes.
    let bright = |from: f64, to: f64| {
        let pixels = albedo.chunks_exact(3).zip(normals.chunks_exact(3)).zip(&class);
        let on_it = pixels.filter(|((_, n), class)| {
            let slope = n[0].hypot(n[1]) / n[2];
            **class == 0.0 && slope >= from && slope < to
        });
        let (all, bright) = on_it.fold((0, 0), |(all, bright), ((albedo, _), _)| {
            (all + 1, bright + usize::from(0.2126 * albedo[0] + 0.7152 * albedo[1] + 0.0722 * albedo[2] > 0.3))
        });
        f64::from(bright as u32) / f64::from(all)
    };
    let [gentle, steep] = [bright(0.0, 0.16), bright(0.35, 9.0)];
    println!("{gentle:.4} of gentle slopes are bright, {steep:.4} of steep ones");
    // Where slopes were those of the measured ground alone, .009 of the steep ones.
    assert!(gentle > 0.004 && steep < 0.000_5, "{gentle} {steep}");
}

#[test]
fn wide_pixels_are_as_bright_as_the_houses_in_them() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // A kilometre of Brooklyn in pixels of a quarter of a lot, and of two and a half.
    let mut mean = |size, layer, hour: &str| {
        let link = format!("#view=40.645,-73.95,900,0,0&time=2026-06-21T{hour}:00Z&clouds=0");
        let values = render::measure(&mut renderer, &render::parse_state(&link).unwrap(), size, layer).unwrap().values;
        values.iter().sum::<f64>() / values.len() as f64
    };
    // Roofs and walls have the mean of all towns; tones of blocks, of which there are some seventy, differ by 2.5 % (a fifth over the root of that). The light that walls and shadows
    // take is one number, for a sun 70 and 35 degrees high.
    for (layer, hour, bound) in [
        (LayerName::Albedo, "16:30", 0.06),
        (LayerName::Luminance, "16:30", 0.12),
        (LayerName::Luminance, "12:45", 0.2),
    ] {
        let [near, far] = [SIZE, [32, 18]].map(|size| mean(size, layer, hour));
        println!("{layer:?} at {hour}: {near:.4} in narrow pixels, {far:.4} in wide ones");
        assert!((far / near - 1.0).abs() < bound, "{}", far / near);
    }
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
    // A third of the ground are streets, all of them lit, less what houses hide; windows are few from above.
    assert!((0.1..0.4).contains(&lit), "{lit}");
    // And none shines on the water.
    let mut of_harbour = |rest: &str, layer| {
        let link = format!("#view=40.70,-74.02,1500,0,0&clouds=0&time=2026-11-10T03:00:00Z{rest}");
        measured(&mut renderer, &link, layer)
    };
    let sea = of_harbour("", LayerName::Class);
    let [night, unlit] = ["", "&layers=-lights"].map(|rest| of_harbour(rest, LayerName::Luminance));
    // Pixels that the shore crosses show some of the land.
    let [width, height] = SIZE.map(|side| side as usize);
    let around = |at: usize| {
        let (x, y) = (at % width, at / width);
        let columns = x.saturating_sub(2)..(x + 3).min(width);
        (y.saturating_sub(2)..(y + 3).min(height)).flat_map(move |y| columns.clone().map(move |x| y * width + x))
    };
    let afloat = (0..sea.len()).filter(|at| around(*at).all(|at| sea[at] == 1.0));
    let (count, worst) = afloat.fold((0, 0.0f64), |(n, worst), at| (n + 1, worst.max((night[at] - unlit[at]).abs())));
    println!("{count} pixels of the harbour differ by {worst:.2e} with lamps");
    assert!(count > 10_000 && worst < 0.1 * brightest, "{count}, {worst}");
}
