//! Rollers: what breaks stands on the water, and hides what is behind it.

use ocean_globe::cli::render;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::Output;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [640, 360];

/// How far the sea's mesh is along the axis of sight, metres, by pixel; 0 where it is not.
fn distances(renderer: &mut Renderer, layers: &str) -> Vec<f32> {
    // A sea whose waves break, but no storm, which has spindrift over its crests.
    let link = "#view=35.6812,-14.25,4,240,80&clouds=0&ride=1&bft=7&foam=2&time=2026-11-26T12:00:00Z&quality=medium";
    let state = render::parse_state(&format!("{link}{layers}")).unwrap();
    let _ = render::draw(renderer, &state, SIZE, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.places().unwrap(), 0, 0).unwrap();
    bytes.chunks_exact(16).map(|texel| f32::from_le_bytes([texel[12], texel[13], texel[14], texel[15]])).collect()
}

#[test]
fn what_breaks_stands_on_the_water() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let without = distances(&mut renderer, "&layers=-foam");
    let with = distances(&mut renderer, "");
    // Of the water within 100 m.
    let near: Vec<_> = without.iter().zip(&with).filter(|(a, b)| **a > 0.0 && **b > 0.0 && **a < 100.0).collect();
    let share = |is: fn(f32) -> bool| near.iter().filter(|(a, b)| is(*b / *a)).count() as f64 / near.len() as f64;
    let (nearer, far_nearer, farther) =
        (share(|ratio| ratio < 0.99), share(|ratio| ratio < 0.8), share(|ratio| ratio > 1.001));
    println!("{:.1} % of {} pixels are nearer, {:.1} % by a fifth", 100.0 * nearer, near.len(), 100.0 * far_nearer);
    println!("{:.2} % are farther", 100.0 * farther);
    // Twice the whitecaps of the wind's, 0.05, of which two fifths are young; they hide what is behind them, and none makes water lower.
    assert!((0.02..0.2).contains(&nearer) && far_nearer > 0.002 && farther < 0.001, "{nearer} {far_nearer} {farther}");
}
