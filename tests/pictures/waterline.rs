//! Pictures that the surface cuts through, or all but: the near water from above, the surface from below, and the water on the lens.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::LENS_M;

use crate::under_water::{DATA, Film, NOON, SHALLOWS, SIZE, half, state};

#[test]
fn what_shines_through_near_water_is_no_sky() {
    // A sky of a green that no water has, and that shines far through it. Where an eye close over the water looks into it most of the bed lies
    // below the picture.
    let mut film = Film::new();
    film.renderer.set_clear_colour(wgpu::Color { r: 0.0, g: 3.0, b: 0.0, a: 1.0 });
    for (view, wind) in [("0.15,250,86", 3), ("0.6,120,86", 5), ("0.5,30,100", 3)] {
        let state = state(&format!("#view={SHALLOWS},{view}&ride=1&wind={wind}@90&{NOON}&layers=-sky"));
        let (_, picture) = film.draw(&state, render::instant(&state));
        let is_sky = |pixel: &[u8]| i32::from(pixel[1]) > i32::from(pixel[2]) + 40;
        let rows: Vec<usize> = picture
            .chunks_exact(4 * SIZE[0] as usize)
            .map(|row| row.chunks_exact(4).filter(|pixel| is_sky(pixel)).count())
            .collect();
        // Down from the first row that is water alone there is nothing else.
        let first = rows.iter().position(|&count| count == 0).expect("water");
        let below: usize = rows[first..].iter().sum();
        println!("{view}: water from row {first} on, {below} pixels of sky in it");
        assert!(first > 20 && first < 170, "{view}: {first}");
        assert_eq!(below, 0, "{view}: the sky shines through the water");
    }
}

/// Green radiance of a picture.
fn green(renderer: &mut Renderer, link: &str, size: [u32; 2]) -> Vec<f64> {
    let measured = render::measure(renderer, &state(link), size, LayerName::Radiance).unwrap();
    measured.values.chunks_exact(3).map(|pixel| pixel[1]).collect()
}

#[test]
fn a_pixel_of_the_surface_from_below_is_the_mean_of_what_it_shows() {
    const COARSE: [u32; 2] = [160, 60];
    const FINER: usize = 4;
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    for (view, most) in [("-0.4,250,100", 0.18), ("-1.6,200,110", 0.085)] {
        let link = format!("#view={SHALLOWS},{view}&wind=4@90&{NOON}");
        let coarse = green(&mut renderer, &link, COARSE);
        let fine = green(&mut renderer, &link, COARSE.map(|side| side * FINER as u32));
        let [columns, rows] = COARSE.map(|side| side as usize);
        let (mut off, mut whole) = (0.0, 0.0);
        // The upper half: all of it is the surface.
        for (x, y) in (0..rows / 2).flat_map(|y| (0..columns).map(move |x| (x, y))) {
            let row = |j: usize| &fine[((y * FINER + j) * columns + x) * FINER..][..FINER];
            let mean = (0..FINER).flat_map(row).sum::<f64>() / (FINER * FINER) as f64;
            off += (coarse[y * columns + x] - mean).powi(2);
            whole += mean * mean;
        }
        let off = (off / whole).sqrt();
        println!("{view}: {off:.3} off");
        // Waves that are longer than two pixels of the coarse picture are alike in both, but not their means over curved mirrors: with slopes that hide
        // nothing of a grazed pixel it is twice as much.
        assert!(off < most, "{view}: {off}");
    }
}

#[test]
fn water_climbs_up_the_lens_as_high_as_surface_tension_bears_it() {
    // Calm water at the eye's height; with no layer at all the picture from above is the clear colour, and the one from below water.
    const SIZE: [u32; 2] = [640, 720];
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    renderer.set_clear_colour(wgpu::Color { r: 1.0, g: 0.0, b: 0.0, a: 1.0 });
    let state = state(&format!("#view={SHALLOWS},0,120,90&ride=1&wind=0@0&{NOON}&layers=-land,-sea,-sky"));
    render::picture(&mut renderer, &state, SIZE).unwrap();
    let radiance = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    let part = |x: u32, y: u32, colour: u32| {
        let at = (8 * (y * SIZE[0] + x) + 2 * colour) as usize;
        half(u16::from_le_bytes([radiance[at], radiance[at + 1]]))
    };
    let is_air = |x: u32, y: u32| part(x, y, 0) > 0.5 * part(x, 0, 0);
    let climbed = |x: u32| (0..SIZE[1] / 2).rev().take_while(|&y| !is_air(x, y)).count() as f64;
    let mean = (0..SIZE[0]).map(climbed).sum::<f64>() / f64::from(SIZE[0]);
    // The root of surface tension over weight, at the lens.
    let capillary_m = (0.073 / (1025.0 * 9.81_f64)).sqrt();
    let pixel_m = LENS_M * 2.0 * f64::to_radians(22.5).tan() / f64::from(SIZE[1]);
    let height = capillary_m / pixel_m;
    println!("{mean:.2} pixels of {height:.2}");
    // From 0.7 of it on, above the critical angle, the air shows through more and more; a pixel on either side is an edge.
    assert!(mean > 0.7 * height - 1.0 && mean < height + 1.0, "{mean} of {height}");
    // From a dark rim along the line to a bright one above.
    let brightness = |y: u32| (0..SIZE[0]).map(|x| part(x, y, 1)).sum::<f64>() / f64::from(SIZE[0]);
    let rows: Vec<f64> = (0..(0.7 * height) as u32).map(|up| brightness(SIZE[1] / 2 - 1 - up)).collect();
    println!("{rows:.4?}, some way below {:.4}", brightness(SIZE[1] / 2 + 30));
    assert!(rows.windows(2).all(|pair| pair[1] > pair[0]), "{rows:?}");
    assert!(rows[0] < 0.8 * brightness(SIZE[1] / 2 + 30), "{rows:?}");
}
