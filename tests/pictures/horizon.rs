//! The horizon from a deck and the limb from space lie where the ellipsoid's do, and are no stairs.

use std::f64::consts::TAU;

use glam::DVec2;
use ocean_globe::cli::render::{LayerName, headless, measure, parse_state};
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::view::camera::Camera;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [160, 90];
const MESHES: [&str; 2] = ["grid", "bisect,8,20000"];
/// Equator, middle latitude, pole and antimeridian, all of them open ocean.
const PLACES: [&str; 4] = ["0,-20", "45,-30", "89.99,40", "-20,180"];

/// Whether the ray through a point of the picture meets the ellipsoid, in f64.
fn meets(camera: &Camera, pixel: DVec2) -> bool {
    camera.unproject_ecef(pixel, DVec2::from(SIZE.map(f64::from))).is_some()
}

fn centre(index: usize) -> DVec2 {
    let width = SIZE[0] as usize;
    DVec2::new((index % width) as f64 + 0.5, (index / width) as f64 + 0.5)
}

#[test]
fn horizon_and_limb_are_the_ellipsoids_to_a_pixel() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    for (view, place) in ["2,30,87", "2,200,70", "560,120,85", "30000,250,80", "3000000,10,40", "30000000,0,0"]
        .iter()
        .flat_map(|view| PLACES.map(|place| (view, place)))
    {
        for mesh in MESHES {
            let link = format!("#view={place},{view}&clouds=0&bft=0&quality=low&time=2026-06-21T12:00:00Z&mesh={mesh}");
            let state = parse_state(&link).unwrap();
            let class = measure(&mut renderer, &state, SIZE, LayerName::Class).unwrap().values;
            let (mut worst, mut edge) = (0.0f64, 0);
            for (index, class) in class.iter().enumerate() {
                let (pixel, hit) = (centre(index), meets(&state.camera, centre(index)));
                // How far off the other side of the true edge is, in eighths of a pixel, up to two pixels.
                let ring = |radius: f64| {
                    (0..32).any(|i| {
                        meets(&state.camera, pixel + radius * DVec2::from_angle(f64::from(i) * TAU / 32.0)) != hit
                    })
                };
                if class.is_nan() == hit {
                    let off = (1..=16).map(|i| f64::from(i) / 8.0).find(|radius| ring(*radius));
                    worst = worst.max(off.unwrap_or(f64::INFINITY));
                }
                edge += usize::from(hit != meets(&state.camera, pixel + DVec2::Y));
            }
            println!("{link}: {edge} pixels at the edge, {worst} pixels off");
            assert!(edge > 20, "{link}: no edge in view");
            // Single precision from space; land's triangles from a deck.
            assert!(worst <= 0.5, "{link}: {worst} pixels");
        }
    }
}

/// A pixel on the horizon or the limb shows what is beyond by its share: there the picture is no stairs.
#[test]
fn a_pixel_on_the_edge_shows_the_sea_by_its_share() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    // Far brighter than any sea, in the place of the sky.
    let beyond = 1e4;
    renderer.set_clear_colour(wgpu::Color { r: beyond, g: beyond, b: beyond, a: 1.0 });
    let [width, height] = SIZE.map(|side| side as usize);
    for (view, mesh) in ["0,-20,2,30,87", "45,-30,2,200,70.5", "-20,180,560,120,85", "-5,-130,3000000,190,40"]
        .iter()
        .flat_map(|view| MESHES.map(|mesh| (view, mesh)))
    {
        let link =
            format!("#view={view}&clouds=0&bft=0&quality=low&time=2026-06-21T12:00:00Z&layers=-land,-sky&mesh={mesh}");
        let state = parse_state(&link).unwrap();
        let luminance = measure(&mut renderer, &state, SIZE, LayerName::Luminance).unwrap().values;
        let sky = luminance[0];
        let (mut worst, mut shared) = (0.0f64, 0);
        for x in (0..width).step_by(3) {
            // The share of the pixel's column that meets the ellipsoid.
            let share = |y: usize| {
                let at = |i: u32| DVec2::new(x as f64 + 0.5, y as f64 + (f64::from(i) + 0.5) / 64.0);
                (0..64).filter(|i| meets(&state.camera, at(*i))).count() as f64 / 64.0
            };
            let Some(row) = (0..height).find(|y| share(*y) > 0.0) else { continue };
            for y in [row.saturating_sub(1), row, row + 1] {
                worst = worst.max((1.0 - luminance[y * width + x] / sky - share(y)).abs());
            }
            shared += usize::from((0.1..0.9).contains(&share(row)));
        }
        println!("{link}: {shared} shared, {worst:.3} off");
        assert!(shared > 10, "{link}: only {shared} pixels to judge");
        // Across an edge aslant by a the share runs over a pixel's width, in its column over 1 / cos a: half of 1 - cos a, a <= 37 degrees.
        assert!(worst < 0.1, "{link}: {worst}");
    }
}
