//! What is sea in a picture, seen from anywhere in any direction: the meshes against rays and the ellipsoid in f64.

use glam::DVec2;
use ocean_globe::cli::render::{LayerName, headless, instant, measure, parse_state};
use ocean_globe::data::world::World;
use ocean_globe::model::earth::{Ellipsoid, WGS84};
use ocean_globe::model::noise;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::view::camera::Camera;

const SIZE: [u32; 2] = [64, 36];
/// Of the first view: in pixels of 64 by 36 waves are so small that rays decide what is sea, and no mesh can be wrong overhead.
const FIRST_SIZE: [u32; 2] = [320, 180];
/// As far from the shore the coarsest map that a picture uses knows the sea, metres.
const OFFSHORE_M: f64 = 300_000.0;
/// Pixels that a mesh may be off at the horizon: a crest between its corners moves it by its own height, half a cell of 4 pixels.
const PIXELS_OFF: f64 = 3.0;

/// Views in which the grid was wrong once: it filled the sky with sea, and left out the corners behind an eye that looks down.
const WRONG_ONCE: [&str; 2] = ["view=12.4,-44.3,30,180,160&clouds=0", "view=-32.4089,-170.5964,42,291,13&clouds=0"];

/// A view: any place, 2 m to 30,000 km high, any heading and tilt. One wind: a sea takes longer to make than its pictures.
fn view(number: i32) -> String {
    if let Some(known) = WRONG_ONCE.get(number as usize) {
        return (*known).into();
    }
    let row = |row| noise::bits(9, 9, number, row).map(|bits| bits as f64 / 2f64.powi(64));
    let ([a, b], [c, d], [e, _]) = (row(0), row(1), row(2));
    let (lat, lon) = ((2.0 * a - 1.0).asin().to_degrees(), 360.0 * b - 180.0);
    format!("view={lat:.4},{lon:.4},{:.1},{:.1},{:.1}&clouds=0", 2.0 * 1.5e7f64.powf(c), 360.0 * d, 180.0 * e)
}

/// How many of nine rays, through a pixel and [`PIXELS_OFF`] around it, meet the ellipsoid moved outward by `lift` metres; `None` from
/// inside it.
fn meeting(eye: &Camera, lift: f64, pixel: DVec2, size: DVec2) -> Option<usize> {
    let ellipsoid = Ellipsoid { a: WGS84.a + lift, b: WGS84.b + lift };
    let around = (0..8).map(|i| PIXELS_OFF * DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 8.0));
    let rays = std::iter::once(DVec2::ZERO).chain(around);
    (eye.altitude_m > lift)
        .then(|| rays.filter(|way| eye.unproject_onto(&ellipsoid, pixel + way, size).is_some()).count())
}

/// Pixels of a mesh's sea that stand in the sky, pixels of the ellipsoid far from any land that lack it, and all of its sea.
fn wrong(renderer: &mut Renderer, world: &mut World, view: &str, mesh: &str, size: [u32; 2]) -> [usize; 3] {
    let link = format!("#{view}&time=2026-11-20T14:00:00Z&foam=0&quality=low&layers=-land&mesh={mesh}");
    let state = parse_state(&link).unwrap();
    let classes = measure(renderer, &state, size, LayerName::Class).unwrap().values;
    let eye = renderer.eye(&state, instant(&state));
    let frame = Frame::new(&state.settings, &eye, instant(&state), size);
    let margin = 1.5 * f64::from(frame.uniform.crest_height);
    let (mut counts, width) = ([0; 3], size[0]);
    let size = DVec2::from(size.map(f64::from));
    for (index, class) in (0..).zip(&classes) {
        let pixel = DVec2::new(f64::from(index % width) + 0.5, f64::from(index / width) + 0.5);
        let is_sea = *class == 1.0;
        counts[0] += usize::from(is_sea && meeting(&eye, margin, pixel, size) == Some(0));
        counts[2] += usize::from(is_sea);
        if !is_sea && meeting(&eye, -margin, pixel, size) == Some(9) {
            let at = eye.unproject(pixel, size).expect("a hit above the lower ellipsoid");
            let place = world.sample_blocking(at.lat, at.lon).unwrap();
            counts[1] +=
                usize::from(place.depth_m.is_some() && place.shore_distance_m.is_none_or(|d| d.abs() > OFFSHORE_M));
        }
    }
    counts
}

/// Looks through so many views, first those of [`WRONG_ONCE`], then random ones; at every so many on the bisected mesh as well, which takes
/// longer to come to rest.
fn look(views: i32, bisected: i32) {
    let mut renderer = headless("www/data", Radiance::Single).unwrap();
    let mut world = World::open("www/data");
    let (mut failures, mut sea) = (Vec::new(), 0);
    for number in 0..views {
        let meshes = ["grid", "bisect,8,20000"];
        for mesh in &meshes[..if number % bisected == 0 { 2 } else { 1 }] {
            let (view, size) = (view(number), if number == 0 { FIRST_SIZE } else { SIZE });
            let [sky, missing, pixels] = wrong(&mut renderer, &mut world, &view, mesh, size);
            println!("{view} {mesh}: {pixels} pixels of sea, {sky} of them in the sky, {missing} missing");
            sea += pixels;
            if sky + missing > 0 {
                failures.push(format!("{view} {mesh}: {sky} in the sky, {missing} missing"));
            }
        }
    }
    assert!(sea > 64 * 36 * 4, "{sea} pixels of sea in all");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn sea_is_where_the_ellipsoid_is_and_not_in_the_sky() {
    look(24, 10);
}

#[test]
#[ignore = "minutes: make soak"]
fn sea_is_where_the_ellipsoid_is_in_three_hundred_views_on_either_mesh() {
    look(300, 1);
}

#[test]
fn coasts_are_drawn_from_any_height() {
    let mut renderer = headless("www/data", Radiance::Single).unwrap();
    // The Canaries, where from 4.5 km on no train of waves is near enough to be seen, and surf is up to 20 km.
    for altitude_m in [1_000, 4_000, 5_000, 9_000, 19_000, 30_000] {
        let link = format!("#view=28.825,-13.79,{altitude_m},285,60&clouds=0&quality=medium&time=2026-11-20T09:00:00Z");
        let state = parse_state(&link).unwrap();
        let values = measure(&mut renderer, &state, SIZE, LayerName::Radiance).unwrap().values;
        let missing = values.iter().filter(|value| !value.is_finite()).count();
        assert_eq!(missing, 0, "of {} numbers from {altitude_m} m", values.len());
    }
}

#[test]
fn a_layer_is_not_measured_in_floats_of_16_bits() {
    let mut renderer = headless("www/data", Radiance::Half).unwrap();
    let state = parse_state("#view=0,-30,1000,0,60&clouds=0&quality=low&time=2026-11-20T12:00:00Z").unwrap();
    let refused =
        measure(&mut renderer, &state, SIZE, LayerName::Depth).expect_err("numbers of another width").to_string();
    assert!(refused.contains("32 bits") && refused.contains("Radiance::Single"), "{refused}");
}
