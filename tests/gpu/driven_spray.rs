//! Spray that storms drive: as much of it as undriven, whatever pixels are wide, and none where there is no storm or no open water.

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::{lace, noise};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::foam_lace::lace_groups;
use crate::kernel::Kernel;

const KERNEL: &str = "#import driven_spray
struct Asked { at: vec2f, pixel: f32, grazing: f32, distance: f32, from_shore: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec2f>;
@compute @workgroup_size(64)
fn driven(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let own = asked[id.x];
    found[id.x] = driven_spray(own.at, vec2f(own.pixel), own.grazing, own.distance, own.from_shore);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [f32; 2],
    pixel: f32,
    grazing: f32,
    distance: f32,
    from_shore: f32,
}

/// Extinction of a hurricane's spray, per metre.
const SPRAY: f32 = 0.0065;

/// Spray before many places of a sea of which so much breaks, at a time of the wave clock: how dense it is, of the usual, and the sheet's optical depth.
fn driven(breaking: f32, clock: u32, asked: Asked) -> Vec<[f32; 2]> {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let camera = Camera::from_degrees(10.0, -30.0, 10.0, 0.0, 0.0);
    let mut frame = Frame::new(&Settings::default(), &camera, 1.7e9, [64; 2]);
    (frame.uniform.whitecaps, frame.uniform.spray, frame.uniform.clock) = (breaking, SPRAY, clock);
    let (layouts, groups) = lace_groups(&gpu, &frame);
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "driven", &layouts.each_ref());
    // Over ten kilometres: a hundred tiles of the gusts.
    let place = |n| noise::bits(7, 6, n, 0).map(|bits| 10_000.0 * ((bits >> 40) as f32 / (1u32 << 24) as f32 - 0.5));
    let all: Vec<_> = (0..65_536).map(|n| Asked { at: place(n), ..asked }).collect();
    let [found] = kernel.run::<_, [f32; 2]>(&gpu, &groups.each_ref(), &all);
    found
}

const AT_SEA: Asked = Asked { at: [0.0; 2], pixel: 0.05, grazing: 0.1, distance: 200.0, from_shore: 1e4 };
const STORM: f32 = 0.2;

fn mean(found: &[[f32; 2]]) -> f64 {
    found.iter().map(|[gust, _]| f64::from(*gust)).sum::<f64>() / found.len() as f64
}

#[test]
fn gusts_leave_as_much_spray_as_there_is_whatever_pixels_are_wide() {
    for pixel in [0.05, 5.0, 50.0, 500.0] {
        let found = driven(STORM, 1_000_000, Asked { pixel, ..AT_SEA });
        let mean = mean(&found);
        let spread = found.iter().map(|[gust, _]| (f64::from(*gust) - mean).powi(2)).sum::<f64>() / found.len() as f64;
        println!("pixels of {pixel} m: mean {mean:.3}, deviation {:.3}", spread.sqrt());
        // A log-normal number of deviation .7 whose level ends at 3.5 deviations. Of the two levels, which a tile has, some hundred cells are independent.
        assert!((mean - 1.0).abs() < 0.08, "{pixel} m: {mean}");
        assert!(pixel > 1.0 || spread.sqrt() > 0.5, "no gusts: {}", spread.sqrt());
    }
}

#[test]
fn the_wave_clock_begins_anew_without_a_jump_of_the_gusts() {
    // A sixtieth of a second, in which gusts go a third of a metre.
    let tick = (1u32 << 20) / 60;
    let off = |from, to| {
        let pairs = driven(STORM, from, AT_SEA).into_iter().zip(driven(STORM, to, AT_SEA));
        pairs.map(|([a, _], [b, _])| (a - b).abs()).fold(0.0, f32::max)
    };
    let [anew, usual] = [off(u32::MAX - tick / 2, tick / 2), off(1 << 30, (1 << 30) + tick)];
    println!("gusts change by {anew:.4} where the clock begins anew, by {usual:.4} else");
    // Other places change most at other times.
    assert!(anew < 2.0 * usual && usual > 0.0, "{anew} {usual}");
}

#[test]
fn spray_is_not_driven_in_a_breeze_nor_at_a_shore() {
    for (breaking, from_shore) in [(0.005, 1e4), (STORM, 0.0)] {
        let found = driven(breaking, 1_000_000, Asked { from_shore, ..AT_SEA });
        assert!(found.iter().all(|place| *place == [1.0, 0.0]), "{breaking}, {from_shore} m from a shore");
    }
}

#[test]
fn no_sheet_is_deeper_than_the_way_to_the_water() {
    // A crest at the eye's height, seen along the level.
    let near = Asked { grazing: 0.0, distance: 5.0, ..AT_SEA };
    let most = driven(STORM, 1_000_000, near).iter().map(|[gust, sheet]| sheet / gust).fold(0.0, f32::max);
    assert!((most / (SPRAY * 5.0) - 1.0).abs() < 1e-4, "{most}");
}

const ON_CRESTS: &str = "#import driven_spray
@group(2) @binding(0) var<storage, read> asked: array<vec2f>;
@group(2) @binding(1) var<storage, read_write> found: array<vec2f>;
@compute @workgroup_size(64)
fn lie(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    found[id.x] = spray_on_crests(vec2f(1.0), asked[id.x].x, asked[id.x].y);
}";

#[test]
fn spray_lies_on_crests_and_there_is_as_much_of_it() {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let mut frame =
        Frame::new(&Settings::default(), &Camera::from_degrees(10.0, -30.0, 10.0, 0.0, 0.0), 1.7e9, [64; 2]);
    frame.uniform.whitecaps = STORM;
    let (layouts, groups) = lace_groups(&gpu, &frame);
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(ON_CRESTS, ""), "lie", &layouts.each_ref());
    const HEIGHTS: usize = 1000;
    for kept in [1.0, 0.5, 0.0] {
        // The height of the water is normal; pixels show `kept` of it.
        let height = |k: usize| [quantile((k as f64 + 0.5) / HEIGHTS as f64), kept];
        let asked: Vec<[f32; 2]> = (0..HEIGHTS).map(height).collect();
        let [found] = kernel.run::<_, [f32; 2]>(&gpu, &groups.each_ref(), &asked);
        let [near, sheet] = [0, 1].map(|part| found.iter().map(|f| f64::from(f[part])).sum::<f64>() / HEIGHTS as f64);
        let crest = f64::from(found[HEIGHTS * 9 / 10][1] / found[HEIGHTS / 10][1]);
        println!("{kept} of the height: {near:.4} and {sheet:.4} in the mean, crests {crest:.2} times troughs");
        // Heights of more than three deviations, of which there are few, count as three.
        assert!((near - 1.0).abs() < 0.01 && (sheet - 1.0).abs() < 0.02, "{near} {sheet}");
        // Tenths of the water lie over and under 1.28 deviations.
        assert!((crest - (2.0 * 1.28 * 0.7 * f64::from(kept)).exp()).abs() < 0.05 * crest, "{crest}");
    }
}

fn quantile(share: f64) -> f32 {
    lace::quantile(share) as f32
}
