//! Waves that run up a beach, and the wet sand.

use std::f64::consts::TAU;

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::data::world::World;
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::swash::RunUp;
use ocean_globe::model::wave_trains::{TRAINS, trains};
use ocean_globe::renderer::{Radiance, Renderer};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [192, 96];
/// Of a pixel, from 60 m above.
const PIXEL_M: f64 = 0.52;

fn layer(renderer: &mut Renderer, settings: &str, layer: LayerName) -> Vec<f64> {
    // A pixel is half a metre, the sea on the left.
    let link = format!("#view=52.1,4.2619,60,0,0&clouds=0&surf=1{settings}");
    render::measure(renderer, &render::parse_state(&link).unwrap(), SIZE, layer).unwrap().values
}

/// Metres from each pixel to the nearest of the ocean; below 0 in it.
fn inland_m(classes: &[f64]) -> Vec<f64> {
    let place = |i: usize| [i % SIZE[0] as usize, i / SIZE[0] as usize].map(|x| x as f64);
    let ocean: Vec<[f64; 2]> = (0..classes.len()).filter(|i| classes[*i] == 1.0).map(place).collect();
    let to_ocean =
        |[x, y]: [f64; 2]| ocean.iter().map(|sea| (sea[0] - x).hypot(sea[1] - y)).fold(f64::INFINITY, f64::min);
    (0..classes.len()).map(|i| if classes[i] == 1.0 { -1.0 } else { PIXEL_M * to_ocean(place(i)) }).collect()
}

#[test]
fn waves_run_up_a_beach_and_leave_it_wet() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut at = |settings: &str, name| layer(&mut renderer, settings, name);
    let sea = |second: u32| format!("&wind=10@290&time=2026-06-20T12:00:0{second}Z");
    let inland = inland_m(&at(&sea(0), LayerName::Class));
    let pictures = [0, 2, 4].map(|second| at(&sea(second), LayerName::Luminance));
    let between =
        |from: f64, to: f64| -> Vec<usize> { (0..inland.len()).filter(|&i| (from..to).contains(&inland[i])).collect() };
    let mean = |picture: &[f64], from, to| {
        let pixels = between(from, to);
        pixels.iter().map(|&i| picture[i]).sum::<f64>() / pixels.len() as f64
    };
    // By Stockdon a fiftieth of the waves of this sea come so far up the beach, at the trains' mean frequency. Sand is damp to 0.8 of that, dry from
    // 1.1 times on, and nothing grows before 1.6 times.
    let place = World::open(DATA).sample_blocking(f64::to_radians(52.1), f64::to_radians(4.2619)).unwrap();
    let tables = SeaTables::of(&render::parse_state(&format!("#view=52.1,4.2619,60,0,0{}", sea(0))).unwrap().settings);
    let omega = trains(&tables).unwrap().iter().map(|train| train.omega / TRAINS as f64).sum();
    let up_m = RunUp::new(tables.sea.hs_m, omega, place.beach).fiftieth() / place.beach;
    println!("{:.2} m, {:.2} s, slope {:.4}: {up_m:.1} m up", tables.sea.hs_m, TAU / omega, place.beach);
    assert!((0.055..0.07).contains(&place.beach), "fine sand off a flat shelf: {}", place.beach);
    let wet_over_dry = mean(&pictures[0], 0.48 * up_m, 0.67 * up_m) / mean(&pictures[0], 1.1 * up_m, 1.29 * up_m);
    println!("wet sand is {wet_over_dry:.3} times as bright as dry sand");
    // Wet sand has 0.6 of the reflectance of dry sand (WET_SAND of land.wgsl), and a sixth of it may still shine.
    assert!((0.55..0.75).contains(&wet_over_dry), "{wet_over_dry}");
    // Sheets come and go, below the line that they reach and nowhere else.
    let changed = |a: usize, b: usize, from, to| {
        let pixels = between(from, to);
        let differs = |i: &&usize| (pictures[a][**i] - pictures[b][**i]).abs() > 0.04 * pictures[a][**i];
        pixels.iter().filter(differs).count() as f64 / pixels.len() as f64
    };
    for (a, b) in [(0, 1), (1, 2), (0, 2)] {
        let shares = [changed(a, b, 0.0, 0.57 * up_m), changed(a, b, 1.9 * up_m, 1e3)];
        println!("{shares:.3?} of the pixels have changed by the water, and inland");
        assert!(shares[0] > 0.1 && shares[1] == 0.0, "{shares:?}");
    }
    assert_eq!(at(&sea(4), LayerName::Luminance), pictures[2], "the same instant is the same picture");
    // A calm sends none up, nor does the quality for slow machines draw any.
    let low = at(&(sea(0) + "&quality=low"), LayerName::Luminance);
    let even = mean(&low, 1.0, 3.0) / mean(&low, 5.0, 7.0);
    assert!((0.97..1.03).contains(&even), "{even}");
}
