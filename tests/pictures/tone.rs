//! From radiance to display: the tone, and how long pictures are exposed.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::model::daylight::BALANCE;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::{Frame, Output};

use crate::light::{DATA, luminance, with_sun_at};

/// Display values, 0…1, of exposed radiance by AgX, in f64: B. Wrensch's matrices, a curve of T. Sobotka's kind through (0.7225, 0.78) with
/// slope 2.9, a toe of power 4 and a shoulder of power 1, and a camera's green, which sees some of what is blue.
pub fn displayed(exposed: [f64; 3]) -> [f64; 3] {
    const INSET: [[f64; 3]; 3] = [
        [0.842479062253094, 0.0784335999999992, 0.0792237451477643],
        [0.0423282422610123, 0.878468636469772, 0.0791661274605434],
        [0.0423756549057051, 0.0784336, 0.879142973793104],
    ];
    const OUTSET: [[f64; 3]; 3] = [
        [1.19687900512017, -0.0980208811401368, -0.0990297440797205],
        [-0.0528968517574562, 1.15190312990417, -0.0989611768448433],
        [-0.0529716355144438, -0.0980434501171241, 1.15107367264116],
    ];
    let times = |rows: [[f64; 3]; 3], v: [f64; 3]| rows.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum::<f64>());
    let curve = |x: f64| {
        let (across, up, power) = if x > 0.7225 { (1.0 - 0.7225, 1.0 - 0.78, 1.0) } else { (0.7225, 0.78, 4.0) };
        let scale = (f64::powf(up, -power) - f64::powf(2.9 * across, -power)).powf(-1.0 / power);
        let rise = 2.9 * (x - 0.7225);
        0.78 + rise / (1.0 + (rise.abs() / scale).powf(power)).powf(1.0 / power)
    };
    let mut balanced: [f64; 3] = std::array::from_fn(|part| BALANCE[part] * exposed[part]);
    balanced[1] += 0.13 * (balanced[2] - balanced[1]).max(0.0);
    let toned = times(INSET, balanced)
        .map(|part| curve(((part.max(1e-10).log2() + 12.47393) / (12.47393 + 4.026069)).clamp(0.0, 1.0)));
    let toned = times(OUTSET, toned);
    let grey = luminance(toned);
    toned.map(|part| (grey + 0.96 * (part - grey)).clamp(0.0, 1.0))
}

#[test]
fn no_pixel_is_black_or_burnt_but_in_the_glint() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    for elevation in [20.0, 40.0, 60.0] {
        for wind in [3, 7, 12] {
            // Away from the sun and across it, foam and sky with it.
            for heading in [90, 0] {
                let link = format!("#view=0,-30,15,{heading},84&clouds=0&wind={wind}@90&{}", with_sun_at(elevation));
                let state = render::parse_state(&link).unwrap();
                let values = render::measure(&mut renderer, &state, [160, 90], LayerName::Radiance).unwrap().values;
                let camera = state.camera;
                let exposure =
                    Frame::new(&state.settings, &camera, render::instant(&state), [160, 90]).uniform.exposure;
                for (pixel, rgb) in values.chunks_exact(3).enumerate() {
                    let shown = displayed(std::array::from_fn(|part| f64::from(exposure) * rgb[part]));
                    let here =
                        || format!("sun {elevation}, {wind} m/s, heading {heading}, pixel {pixel}: {rgb:?} {shown:?}");
                    assert!(rgb.iter().all(|part| part.is_finite() && *part >= 0.0), "{}", here());
                    assert!(shown.iter().all(|part| *part < 0.98) && luminance(shown) > 0.02, "{}", here());
                }
            }
        }
    }
}

/// Share of a picture towards a low sun that is all but white, were it exposed `factor` times as long as it is.
fn burnt(renderer: &mut Renderer, elevation: f64, factor: f64) -> f64 {
    let link = format!("#view=0,-30,6,270,89&clouds=0&bft=4&quality=low&{}", with_sun_at(elevation));
    let state = render::parse_state(&link).unwrap();
    let values = render::measure(renderer, &state, [160, 90], LayerName::Radiance).unwrap().values;
    let frame = Frame::new(&state.settings, &state.camera, render::instant(&state), [160, 90]);
    let exposure = factor * f64::from(frame.uniform.exposure);
    let white = |rgb: &&[f64]| displayed([exposure * rgb[0], exposure * rgb[1], exposure * rgb[2]])[1] > 250.0 / 255.0;
    values.chunks_exact(3).filter(white).count() as f64 / (160.0 * 90.0)
}

#[test]
fn a_low_sun_does_not_burn_the_sky_about_it() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    for elevation in [5.0, 10.0] {
        // 2.9: as a picture with the sun behind it is exposed.
        let [share, away] = [1.0, 2.9].map(|factor| burnt(&mut renderer, elevation, factor));
        println!(
            "sun at {elevation} degrees: {share:.4} of the picture is white, {away:.4} as exposed away from the sun"
        );
        // The disc with its glow, some 10 degrees across, has a fiftieth of the picture, its path on the sea as much.
        assert!(share < 0.04 && share < 0.5 * away, "{share} {away}");
    }
}

/// What so many of a list in order are below.
fn quantile(of: &[u8], share: f64) -> f64 {
    f64::from(of[(share * of.len() as f64) as usize])
}

#[test]
fn clouds_in_a_low_sun_keep_their_relief_from_above() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let size = [320, 180];
    // Heaps over the Atlantic, the sun at 23 and at 10 degrees.
    for view in ["18,-40,3000,240,80&time=2026-06-21T19:30:00Z", "18,-40,9000,240,65&time=2026-06-21T20:30:00Z"] {
        let state = render::parse_state(&format!("#view={view}")).unwrap();
        let (_, target) = render::draw(&mut renderer, &state, size, Output::Picture).unwrap();
        let pixels = renderer.gpu().read_texture(&target, 0, 0).unwrap();
        // Below the sky, which is another thing.
        let below = pixels.len() / 2;
        let mut green: Vec<u8> = pixels[below..].chunks_exact(4).map(|pixel| pixel[1]).collect();
        green.sort_unstable();
        let [low, high, bright] = [0.25, 0.75, 0.95].map(|share| quantile(&green, share));
        println!("{view}: half of the clouds between {low} and {high}, a twentieth above {bright}");
        // Exposed for level ground they were 29 and 45 of 255 apart, and a tenth of them from 239 on.
        assert!(high - low > 40.0 && bright < 238.0, "{view}: {low} {high} {bright}");
    }
}

#[test]
fn clouds_that_face_the_sun_keep_their_relief_from_below() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let size = [320, 180];
    // The sun at 23, 26 and 32 degrees, beside the eye and behind it.
    for view in [
        "53.6,108.3,30,200,84&bft=5&clouds=0.4&time=2026-07-14T10:20:00Z",
        "36.9,-8.9,25,260,85&clouds=0.35&time=2026-09-12T08:30:00Z",
        "45.2,-14,3,90,86&bft=5&clouds=0.5&time=2026-05-10T17:00:00Z",
    ] {
        let state = render::parse_state(&format!("#view={view}")).unwrap();
        let (_, target) = render::draw(&mut renderer, &state, size, Output::Picture).unwrap();
        let pixels = renderer.gpu().read_texture(&target, 0, 0).unwrap();
        let sky = pixels.len() / 3;
        let mut green: Vec<u8> = pixels[..sky].chunks_exact(4).map(|pixel| pixel[1]).collect();
        green.sort_unstable();
        let [low, high, bright] = [0.25, 0.75, 0.9].map(|share| quantile(&green, share));
        // Exposed for level ground, without a filter, they were 31, 52 and 21 apart, and a tenth of them from 240 on.
        println!("{view}: half of the sky between {low} and {high}, a tenth above {bright}");
        assert!(high - low > 34.0 && bright < 237.0, "{view}: {low} {high} {bright}");
    }
}

#[test]
fn the_display_has_the_tone_of_agx() {
    // A grey card in the light that the exposure is metered for.
    let card = 255.0 * displayed([0.18 * 2f64.powf(0.7); 3])[1];
    println!("grey card {card:.1}");
    assert!((card - 141.0).abs() < 5.0, "{card}");
    // Ever brighter, up to white.
    let ramp: Vec<f64> = (-120..=40).map(|step| displayed([2f64.powf(f64::from(step) / 10.0); 3])[0]).collect();
    assert!(ramp.windows(2).all(|pair| pair[1] > pair[0]) && ramp[0] < 0.01 && ramp[ramp.len() - 1] > 0.98);
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let size = [64, 36];
    for view in ["36.5,-9.5,15,290,86&bft=3&time=2026-06-21T19:50:00Z", "20,-40,9e6&time=2026-06-21T14:30:00Z"] {
        let state = render::parse_state(&format!("#view={view}&clouds=0&quality=low&rate=0")).unwrap();
        let measured = render::measure(&mut renderer, &state, size, LayerName::Radiance).unwrap();
        let (frame, target) = render::draw(&mut renderer, &state, size, Output::Picture).unwrap();
        let bytes = renderer.gpu().read_texture(&target, 0, 0).unwrap();
        let mut darkest = 255;
        for (pixel, (rgba, radiance)) in bytes.chunks_exact(4).zip(measured.values.chunks_exact(3)).enumerate() {
            let exposed = std::array::from_fn(|part| radiance[part] * f64::from(frame.uniform.exposure));
            for (byte, wanted) in rgba.iter().zip(displayed(exposed)) {
                // Half a step of noise, half a step of rounding, and what 32 bits lose in the curve.
                assert!((f64::from(*byte) - 255.0 * wanted).abs() < 1.1, "{view}, {pixel}: {byte} of {wanted}");
            }
            darkest = darkest.min(*rgba[..3].iter().max().unwrap());
        }
        println!("{view}: exposure {:.2}, darkest pixel {darkest}", frame.uniform.exposure);
    }
}

#[test]
fn radiance_is_that_of_what_pictures_show() {
    let [mut measuring, mut surfaces, mut drawing] =
        [Radiance::Whole, Radiance::Single, Radiance::Half].map(|kept| render::headless(DATA, kept).unwrap());
    // What is blended: heaps of cloud behind a filter, stars, lamps.
    for (view, size, greyest) in [
        ("45.2,-14,3,90,86&bft=5&clouds=0.5&time=2026-05-10T17:00:00Z", [160, 90], 0.8),
        ("53.6,108.3,400,200,110&bft=5&clouds=0.4&time=2026-07-14T10:20:00Z", [80, 120], 0.8),
        ("18,-62.5,4,250,120&bft=3&clouds=0&time=2026-11-10T04:10:00Z", [160, 90], 1.0),
        ("22.24,114.18,900,0,80&clouds=0&time=2026-11-17T14:10:00Z", [160, 90], 1.0),
    ] {
        let state = render::parse_state(&format!("#view={view}&quality=low&rate=0")).unwrap();
        let [measured, bare] = [&mut measuring, &mut surfaces]
            .map(|renderer| render::measure(renderer, &state, size, LayerName::Radiance).unwrap());
        let (frame, target) = render::draw(&mut drawing, &state, size, Output::Picture).unwrap();
        let bytes = drawing.gpu().read_texture(&target, 0, 0).unwrap();
        let exposure = f64::from(frame.uniform.exposure) * f64::from(frame.uniform.night);
        let mut least = 1.0f64;
        for (pixel, (rgba, radiance)) in bytes.chunks_exact(4).zip(measured.values.chunks_exact(3)).enumerate() {
            let at = [pixel as u32 % size[0], pixel as u32 / size[0]].map(|part| f64::from(part) + 0.5);
            let passed = frame.sky_filter.passed(at, size.map(f64::from));
            least = least.min(passed);
            let exposed = std::array::from_fn(|part| radiance[part] * exposure * passed);
            for (byte, wanted) in rgba.iter().zip(displayed(exposed)) {
                // Half a step of noise, half a step of rounding, and what 16 bits lose before the curve, several times where much is blended.
                assert!((f64::from(*byte) - 255.0 * wanted).abs() < 1.5, "{view}, {pixel}: {byte} of {wanted}");
            }
        }
        let other = |(whole, bare): &(&f64, &f64)| (*whole - *bare).abs() > 0.05 * *bare;
        let blended = measured.values.iter().zip(&bare.values).filter(other).count() / 3;
        println!("{view}: {blended} pixels have something blended, the filter lets {least:.2} through");
        assert!(blended > 20 && least <= greyest, "{view}: {blended} {least}");
    }
}

/// Radiance of a pixel's surroundings as a camera has it there: a tenth on either side.
fn spread(scene: &[[f64; 3]], [width, height]: [usize; 2], pixel: usize) -> [f64; 3] {
    let (x, y) = (pixel % width, pixel / width);
    let parts = [0.1, 0.8, 0.1];
    let mut sum = [0.0; 3];
    for (j, down) in parts.iter().enumerate() {
        for (i, right) in parts.iter().enumerate() {
            let beside = [(x + i).clamp(1, width) - 1, (y + j).clamp(1, height) - 1];
            for (part, light) in sum.iter_mut().zip(scene[beside[1] * width + beside[0]]) {
                *part += right * down * light;
            }
        }
    }
    sum
}

#[test]
fn a_lens_spreads_the_points_of_the_sun_on_the_water() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let size = [160, 90];
    let link = format!("#view=0,-30,8,270,80&clouds=0&bft=4&quality=medium&rate=0&{}", with_sun_at(30.0));
    let state = render::parse_state(&link).unwrap();
    let (_, target) = render::draw(&mut renderer, &state, size, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(&target, 0, 0).unwrap();
    let scene = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    let value = |texel: &[u8], part: usize| half::f16::from_le_bytes([texel[2 * part], texel[2 * part + 1]]).to_f64();
    let scene: Vec<[f64; 3]> = scene.chunks_exact(8).map(|t| std::array::from_fn(|part| value(t, part))).collect();
    let mut lit = 0;
    for (pixel, rgba) in bytes.chunks_exact(4).enumerate() {
        let shown = spread(&scene, size.map(|side| side as usize), pixel);
        // The glow adds to what is left of that: no less is shown, but for a step of noise and rounding.
        let least = 255.0 * luminance(displayed(shown.map(|part| 0.97 * part)));
        let byte = luminance(std::array::from_fn(|part| f64::from(rgba[part])));
        assert!(byte > least - 1.1, "{pixel}: {byte} of {least}");
        let alone = 255.0 * luminance(displayed(scene[pixel]));
        lit += usize::from(byte > alone + 40.0);
    }
    println!("{lit} pixels are much lighter for the points beside them");
    // The glow alone, which is even over many pixels, makes none so.
    assert!(lit > 40, "{lit}");
}

/// What the filter of a link's picture lets through in the middle of its uppermost row.
fn let_through(link: &str) -> f64 {
    let state = render::parse_state(link).unwrap();
    let frame = Frame::new(&state.settings, &state.camera, render::instant(&state), [160, 90]);
    frame.sky_filter.passed([80.0, 0.5], [160.0, 90.0])
}

#[test]
fn the_sky_is_filtered_by_day_where_clouds_are_and_from_waves_of_any_height() {
    let link = |altitude: f64, clouds: f64, day: &str, hour: &str| {
        format!("#view=45.2,-14,{altitude},90,86&clouds={clouds}&time=2026-{day}T{hour}:00Z")
    };
    let day = let_through(&link(3.0, 0.5, "05-10", "17:00"));
    println!("by day {day:.2} comes through");
    assert!((0.3..0.8).contains(&day), "{day}");
    // On a crest, in a trough, which may lie lower than the resting sea, and as high as clouds' bases.
    for altitude in [-2.0, 0.0, 1.0, 600.0] {
        let there = let_through(&link(altitude, 0.5, "05-10", "17:00"));
        assert!((there - day).abs() < 0.01, "{there} from {altitude} m");
    }
    for (none, why) in [
        (link(3.0, 0.0, "05-10", "17:00"), "no clouds"),
        (link(3.0, 0.5, "05-10", "01:00"), "the sun is down"),
        (link(20_000.0, 0.5, "05-10", "17:00"), "clouds lie below"),
    ] {
        assert!((let_through(&none) - 1.0).abs() < 1e-6, "{why}");
    }
    // Into a low sun the whole picture is exposed for it.
    let into = let_through("#view=45.2,-14,3,280,86&clouds=0.5&time=2026-05-10T19:00:00Z");
    assert!(into > 0.85, "{into}");
}
