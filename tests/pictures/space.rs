//! The sky as an eye in space sees it: drawn where there is any, and nowhere else.

use ocean_globe::cli::render::{draw, headless, parse_state};
use ocean_globe::renderer::Radiance;
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
