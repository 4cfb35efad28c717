//! The sky as an eye in space sees it: drawn where there is any, and nowhere else.

use ocean_globe::cli::render::{draw, headless, instant, parse_state};
use ocean_globe::gpu::texture::{Shape, view as view_of};
use ocean_globe::renderer::{Radiance, Renderer, TARGET_FORMAT};
use ocean_globe::scene::frame::Output;

use crate::light::DATA;

#[test]
fn beside_the_air_sun_and_moon_there_is_no_sky_to_draw() {
    let mut parts = headless(DATA, Radiance::Half).unwrap();
    let mut whole = headless(DATA, Radiance::Half).unwrap();
    // A clear colour tells what is not drawn: then all of the sky is.
    whole.set_clear_colour(wgpu::Color::BLACK);
    let size = [192, 108];
    for (view, drawn) in [
        ("16,-25,30000000&time=2026-11-20T14:20:00Z", 0.1..0.5),
        ("30,85,6000000,40,35&time=2026-06-21T14:00:00Z", 0.1..0.99),
        ("0,0,2500000,270,80&time=2026-06-21T18:30:00Z", 0.1..1.01),
        // The sun to the right of the middle, the earth below the picture; the moon as well, full.
        ("0,0,20000000,80,70&time=2026-03-20T06:00:00Z", 1.0..1.01),
        ("0,0,20000000,80,70&time=2026-11-24T18:00:00Z", 1.0..1.01),
        ("0,0,20000000,180,70&time=2026-03-20T06:00:00Z", 0.0..0.2),
    ] {
        let state = parse_state(&format!("#view={view}&quality=medium&layers=-stars")).unwrap();
        let [(frame, a), (_, b)] =
            [&mut parts, &mut whole].map(|renderer| draw(renderer, &state, size, Output::Picture).unwrap());
        let [a, b] =
            [(&parts, a), (&whole, b)].map(|(renderer, texture)| renderer.gpu().read_texture(&texture, 0, 0).unwrap());
        let off = a.iter().zip(&b).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
        let lit = b.chunks_exact(4).filter(|rgb| rgb[..3].iter().any(|x| *x > 40)).count();
        let share = f64::from(frame.sky_area[2] * frame.sky_area[3]) / f64::from(size[0] * size[1]);
        println!("{view}: {share:.2} of the sky is drawn, {lit} pixels are lit, {off} off");
        assert!(drawn.contains(&share), "{view}: {share}");
        // The glow is rounded otherwise.
        assert!(off <= 1, "{view}: {off}");
    }
}

/// The picture, by a pass over the whole globe or by those of land, bed and sea.
fn drawn_as(renderer: &mut Renderer, view: &str, as_globe: bool) -> Vec<u8> {
    const SIZE: [u32; 2] = [320, 180];
    let state = parse_state(&format!("#view={view}&quality=medium")).unwrap();
    let target = {
        let unix_seconds = instant(&state);
        let eye = renderer.eye(&state, unix_seconds);
        let mut frame = renderer.frame(&state.settings, &eye, unix_seconds, SIZE);
        assert!(frame.is_globe(), "{view}");
        if !as_globe {
            frame.highest_in_view_m = 1e9;
        }
        while !renderer.load(&frame) {
            std::thread::sleep(std::time::Duration::from_millis(2));
        }
        let gpu = renderer.gpu().clone();
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let target = gpu.texture("picture", Shape::picture(SIZE[0], SIZE[1]), TARGET_FORMAT, usage);
        renderer.settle(&frame);
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        renderer.render(&mut encoder, &frame, &view_of(&target));
        gpu.queue.submit([encoder.finish()]);
        target
    };
    renderer.gpu().read_texture(&target, 0, 0).unwrap()
}

#[test]
fn the_globe_in_one_pass_is_what_its_ground_and_sea_are() {
    let mut renderer = headless(DATA, Radiance::Whole).unwrap();
    // Pixels of 6 km, where no summit in view is as high: off Mauritania, South Africa, Iceland, the Pacific.
    for view in [
        "26,-21,1500000,180,18&clouds=0.35&time=2026-11-20T13:00:00Z",
        "-30,20,1400000,0,30&clouds=0.2&time=2026-11-20T10:00:00Z",
        "64,-20,1400000,90,20&clouds=0.2&time=2026-06-20T13:00:00Z",
        "0,-150,1400000,90,45&clouds=0.5&time=2026-06-20T22:00:00Z",
    ] {
        let [globe, ground] = [true, false].map(|globe| drawn_as(&mut renderer, view, globe));
        let off = globe.iter().zip(&ground).map(|(a, b)| f64::from(a.abs_diff(*b))).collect::<Vec<_>>();
        let mean = off.iter().sum::<f64>() / off.len() as f64;
        let far = off.iter().filter(|off| **off > 8.0).count() as f64 / off.len() as f64;
        println!("{view}: {mean:.3} of 255 apart in the mean, {far:.4} by more than 8");
        assert!(mean < 0.3 && far < 0.003, "{view}: {mean} {far}");
    }
    // Where summits are higher than pixels are wide, the ground is drawn.
    let state = parse_state("#view=28,86,1400000&time=2026-11-20T06:00:00Z").unwrap();
    let eye = renderer.eye(&state, instant(&state));
    assert!(!renderer.frame(&state.settings, &eye, instant(&state), [320, 180]).is_globe());
}
