//! Spindrift: storms tear it off the crests of the sea that is drawn, and it whitens what is behind.

use glam::DVec3;
use ocean_globe::cli::render;
use ocean_globe::gpu::texture;
use ocean_globe::model::earth::{Geodetic, WGS84, ecef_from_enu};
use ocean_globe::pass::spindrift::Plume;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::{Frame, Output};
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::view::camera::Camera;

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
    if !frame.has_spindrift() {
        return (Vec::new(), frame);
    }
    let bytes = renderer.gpu().copy_buffer(renderer.plumes().unwrap()).unwrap();
    (bytemuck::pod_collect_to_vec(&bytes), frame)
}

#[test]
fn storms_tear_spindrift_off_crests() {
    let (mut renderer, mut seas) = (renderer(), Seas::default());
    let found = [4, 7, 8, 10, 12].map(|grade| {
        let (plumes, frame) = plumes(&mut renderer, grade);
        let state = render::parse_state(&link(grade)).unwrap();
        let Camera { lat, lon, altitude_m, .. } = frame.camera;
        let (eye, axes) =
            (WGS84.ecef_from_geodetic(Geodetic { lat, lon, height: altitude_m }), ecef_from_enu(lat, lon));
        let place =
            |plume: &Plume| WGS84.geodetic_from_ecef(eye + axes * DVec3::from(plume.base.map(f64::from))).unwrap();
        let strength = |plume: &Plume| f64::from(plume.strength);
        for plume in &plumes {
            let is_lit = plume.light.iter().all(|light| light.is_finite() && *light >= 0.0);
            assert!((0.0..=1.0).contains(&plume.strength) && is_lit, "{plume:?}");
        }
        let all: f64 = plumes.iter().map(strength).sum();
        let height = plumes.iter().map(|plume| strength(plume) * place(plume).height).sum::<f64>() / all;
        // Of the strongest of either square, how far off the model's surface they leave it, metres.
        let half = plumes.len() / 2;
        let errors = [&plumes[..half], &plumes[half..]].map(|square| {
            let mut sorted: Vec<&Plume> = square.iter().collect();
            sorted.sort_by(|a, b| b.strength.total_cmp(&a.strength));
            let mut errors: Vec<f64> = Vec::new();
            for plume in sorted.into_iter().take(30) {
                let place = place(plume);
                let at = Camera { lat: place.lat, lon: place.lon, ..frame.camera };
                let model = seas.surface_height(&state.settings, &at, render::instant(&state));
                errors.push((place.height - model).abs());
            }
            errors.sort_by(f64::total_cmp);
            [errors.len() / 2, errors.len() * 9 / 10].map(|index| errors.get(index).copied().unwrap_or(0.0))
        });
        let hs = frame.sea.sea.hs_m;
        println!("grade {grade}: {all:.1} plumes, {:.2} Hs high, off the model by {errors:.3?} m", height / hs);
        (all, height / hs, errors, hs)
    });
    let [breeze, near_gale, gale, storm, hurricane] = found.map(|(all, ..)| all);
    // The Beaufort scale has the first spindrift at grade 8; it goes with the wind over that, 0.12, 0.6 and 1 of a hurricane's, and with the young foam,
    // of which there is a third, two thirds and once as much.
    assert!(breeze == 0.0 && near_gale == 0.0 && gale > 0.0, "{found:?}");
    assert!(storm > 5.0 * gale && hurricane > 1.6 * storm, "{found:?}");
    for (_, height, [near, wide], hs) in &found[2..] {
        // Crests are half as high as waves are, more or less.
        assert!((0.25..1.0).contains(height), "{found:?}");
        // As in the test of an eye that rides the sea. Of the farther ones the mesh, whose cells are up to 22 m wide in so small a picture, leaves the
        // long waves; a crest of half the height at a place of no wave would be 0.5 Hs off.
        assert!(near[1] < 0.15 + 0.03 * hs && wide[0] < 0.2 * hs, "{found:?}");
    }
}

#[test]
fn spindrift_whitens_what_is_behind() {
    let mut renderer = renderer();
    let state = render::parse_state(&link(12)).unwrap();
    let (frame, target) = render::draw(&mut renderer, &state, SIZE, Output::Picture).unwrap();
    assert!(frame.has_spindrift());
    let with = renderer.gpu().read_texture(&target, 0, 0).unwrap();
    let mut bare = frame.clone();
    bare.uniform.spindrift = 0.0;
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
