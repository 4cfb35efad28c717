//! Rollers: what breaks stands on the water, and hides what is behind it.

use ocean_globe::cli::render;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::Output;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [640, 360];

const CREST: &str = "view=35.6812,-14.25,4,240,80&ride=1&bft=7&foam=2&time=2026-11-26T12:00:00Z";
/// Nearly all of it is white, and its eye does not ride.
const HURRICANE: &str = "view=40,-50,9,60,78&bft=12&time=2026-02-21T15:00:00Z";

/// How far the sea's mesh is along the axis of sight, metres, by pixel; 0 where it is not.
fn distances(renderer: &mut Renderer, view: &str, layers: &str) -> Vec<f32> {
    let state = render::parse_state(&format!("#{view}&clouds=0&quality=medium{layers}")).unwrap();
    let _ = render::draw(renderer, &state, SIZE, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.places().unwrap(), 0, 0).unwrap();
    bytes.chunks_exact(16).map(|texel| f32::from_le_bytes([texel[12], texel[13], texel[14], texel[15]])).collect()
}

/// Of the pixels whose water is within 100 m, the share whose water foam makes nearer by more than 1 %, by a fifth and by half, and farther.
fn moved(renderer: &mut Renderer, view: &str) -> [f64; 4] {
    let without = distances(renderer, view, "&layers=-foam");
    let with = distances(renderer, view, "");
    let near: Vec<_> = without.iter().zip(&with).filter(|(a, b)| **a > 0.0 && **b > 0.0 && **a < 100.0).collect();
    let share = |is: &dyn Fn(f32) -> bool| near.iter().filter(|(a, b)| is(*b / *a)).count() as f64 / near.len() as f64;
    assert!(near.len() > 100_000, "{view}: {} pixels", near.len());
    let [nearer, by_fifth, by_half] = [0.99, 0.8, 0.5].map(|least| share(&|ratio| ratio < least));
    let found = [nearer, by_fifth, by_half, share(&|ratio| ratio > 1.001)];
    println!("{view}: {found:.4?} are nearer by 1 %, a fifth and a half, and farther");
    found
}

#[test]
fn what_breaks_stands_on_the_water() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let [nearer, by_fifth, _, farther] = moved(&mut renderer, CREST);
    // Twice the whitecaps of the wind's, 0.05, of which two fifths are young; they hide what is behind them, and none makes water lower.
    assert!((0.02..0.2).contains(&nearer) && by_fifth > 0.002 && farther < 0.001, "{nearer} {by_fifth} {farther}");
    // In a hurricane they are a layer of half a metre, a metre or two below the eye in places, and no rocks: of those a quarter was nearer by half.
    let [nearer, _, by_half, farther] = moved(&mut renderer, HURRICANE);
    assert!(nearer > 0.1 && by_half < 0.15 && farther < 0.001, "{nearer} {by_half} {farther}");
}
