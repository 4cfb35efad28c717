//! Spindrift: storms tear it off the crests of the sea that is drawn, and it whitens what is behind.

use glam::DVec3;
use ocean_globe::cli::render;
use ocean_globe::gpu::texture;
use ocean_globe::model::earth::{Geodetic, WGS84, ecef_from_enu};
use ocean_globe::pass::spindrift::Plume;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::{Frame, Output};
use ocean_globe::scene::sea::Seas;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [320, 180];

fn renderer() -> Renderer {
    render::headless(DATA, Radiance::Half).unwrap()
}

fn link(grade: u32) -> String {
    format!("#view=40,-50,9,60,78&bft={grade}&clouds=0.3&time=2026-02-21T15:00:00Z&quality=medium")
}

/// The plumes of a picture, with its frame.
fn plumes(renderer: &mut Renderer, grade: u32) -> (Vec<Plume>, Frame) {
    let state = render::parse_state(&link(grade)).unwrap();
    let (frame, _) = render::draw(renderer, &state, SIZE, Output::Picture).unwrap();
    if !frame.shows_spindrift {
        return (Vec::new(), frame);
    }
    let bytes = renderer.gpu().copy_buffer(renderer.plumes().unwrap()).unwrap();
    (bytemuck::pod_collect_to_vec(&bytes), frame)
}

#[test]
fn storms_tear_spindrift_off_crests() {
    let (mut renderer, mut seas) = (renderer(), Seas::default());
    let found = [4, 6, 8, 10, 12].map(|grade| {
        let (plumes, frame) = plumes(&mut renderer, grade);
        let state = render::parse_state(&link(grade)).unwrap();
        let eye = Geodetic { lat: frame.camera.lat, lon: frame.camera.lon, height: frame.camera.altitude_m };
        let (foot, axes) = (WGS84.ecef_from_geodetic(eye), ecef_from_enu(eye.lat, eye.lon));
        let (mut strength, mut height, mut errors) = (0.0, 0.0, Vec::new());
        for plume in &plumes {
            let share = f64::from(plume.strength);
            assert!((0.0..=1.0).contains(&share) && plume.light.iter().all(|light| *light >= 0.0), "{plume:?}");
            let place = WGS84.geodetic_from_ecef(foot + axes * DVec3::from(plume.base.map(f64::from))).unwrap();
            strength += share;
            height += share * place.height;
            if share > 0.1 && errors.len() < 40 {
                let at = ocean_globe::scene::view::camera::Camera { lat: place.lat, lon: place.lon, ..frame.camera };
                errors.push((place.height - seas.surface_height(&state.settings, &at, render::instant(&state))).abs());
            }
        }
        errors.sort_by(f64::total_cmp);
        let middle = errors.get(errors.len() / 2).copied();
        let hs = frame.sea.sea.hs_m;
        println!(
            "grade {grade}: {strength:.1} plumes, {:.2} Hs high, {middle:?} m off the model",
            height / strength / hs
        );
        (strength, height / strength / hs, middle, hs)
    });
    let [breeze, strong, gale, storm, hurricane] = found.map(|(strength, ..)| strength);
    // The Beaufort scale has the first spindrift at grade 8.
    assert!(breeze == 0.0 && strong < 0.02 * gale && gale > 0.5, "{found:?}");
    assert!(storm > 4.0 * gale && hurricane > 1.5 * storm, "{found:?}");
    for (_, height, error, hs) in &found[2..] {
        // Crests are half as high as waves.
        assert!(*height > 0.25 && *height < 1.0, "{found:?}");
        // As the ride's test: cells of the mesh, and what the filters take.
        assert!(error.is_some_and(|error| error < 0.15 + 0.03 * hs), "{found:?}");
    }
}

#[test]
fn spindrift_whitens_what_is_behind() {
    let mut renderer = renderer();
    let state = render::parse_state(&link(12)).unwrap();
    let (frame, target) = render::draw(&mut renderer, &state, SIZE, Output::Picture).unwrap();
    assert!(frame.shows_spindrift);
    let with = renderer.gpu().read_texture(&target, 0, 0).unwrap();
    let mut bare = frame.clone();
    bare.shows_spindrift = false;
    let mut encoder = renderer.gpu().device.create_command_encoder(&Default::default());
    renderer.render(&mut encoder, &bare, &texture::view(&target));
    renderer.gpu().queue.submit([encoder.finish()]);
    let without = renderer.gpu().read_texture(&target, 0, 0).unwrap();
    let changes: Vec<i32> =
        with.chunks_exact(4).zip(without.chunks_exact(4)).map(|(a, b)| i32::from(a[1]) - i32::from(b[1])).collect();
    let share =
        |of: &dyn Fn(i32) -> bool| changes.iter().filter(|change| of(**change)).count() as f64 / changes.len() as f64;
    let [lighter, darker] = [share(&|change| change > 4), share(&|change| change < -12)];
    println!("{:.1} % of the picture are lighter, {:.1} % darker", 100.0 * lighter, 100.0 * darker);
    // Most of the sea near the eye is dark beside drops in daylight; before white foam they may be in a cloud's shadow.
    assert!(lighter > 0.03 && darker < 0.2 * lighter, "{lighter} {darker}");
}
