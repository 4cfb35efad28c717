//! The sun's sparkle is as bright as the glitter whose facets it counts, and lies on the water.

use bytemuck::{Pod, Zeroable};
use glam::DVec2;
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::noise;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import sparkle
struct Asked { at: vec2f, across: f32, chance: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec2f>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let facets = facets_at(asked[id.x].at, asked[id.x].across, 0.2);
    found[id.x] = vec2f(sparkle(facets, asked[id.x].chance), facets.chance);
}";

const NOON: f64 = 1_795_176_000.0;

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [f32; 2],
    across: f32,
    chance: f32,
}

/// Sparkle and the facets' chances, as an eye at a place sees them at an instant. Places are metres east and north of the eye's.
fn sparkle(lat: f64, unix_seconds: f64, asked: impl Fn(&Frame) -> Vec<Asked>) -> Vec<[f32; 2]> {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let frame =
        Frame::new(&Settings::default(), &Camera::from_degrees(lat, -30.0, 10.0, 0.0, 0.0), unix_seconds, [64; 2]);
    let layouts = [kernel::frame_layout(&gpu), gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[])];
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let groups =
        [kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), gpu.bind("unused", &layouts[1], &[])];
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "ask", &layouts.each_ref());
    let [found] = kernel.run::<_, [f32; 2]>(&gpu, &groups.each_ref(), &asked(&frame));
    found
}

/// Places within 300 m of an eye, evenly.
fn places(count: i32) -> impl Iterator<Item = DVec2> {
    let part = |bits: u64| 600.0 * (bits as u32 as f64 / f64::from(u32::MAX) - 0.5);
    (0..count).map(move |n| noise::bits(11, 3, n, 0)[0]).map(move |bits| DVec2::new(part(bits), part(bits >> 32)))
}

#[test]
fn sparkle_leaves_the_glitter_as_bright_as_it_is() {
    const PLACES: i32 = 160_000;
    // From a hundredth of a facet in a pixel to a hundred.
    for (across, chance) in [(0.01, 0.05), (0.03, 0.3), (0.1, 0.3), (0.3, 0.3), (0.3, 1.0)] {
        let ask = |_: &Frame| {
            places(PLACES).map(|at| Asked { at: at.as_vec2().to_array(), across, chance }).collect::<Vec<_>>()
        };
        let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
        for frame in 0..12 {
            // Twelve instants of the clocks of the squares, of which each is at another.
            for [factor, _] in sparkle(26.0, NOON + 0.29 * f64::from(frame), ask) {
                sum += f64::from(factor);
                squares += f64::from(factor * factor);
                count += 1.0;
            }
        }
        let mean = sum / count;
        let deviation = (squares / count - mean * mean).sqrt();
        println!("{across} m, chance {chance}: mean {mean:.4}, deviation {deviation:.3}");
        // Four deviations of the mean of as many; pixels that share a square are few.
        assert!((mean - 1.0).abs() < 0.002 + 4.0 * deviation / count.sqrt(), "{across} m, {chance}: {mean}");
        let facets = f64::from(across * across / 0.2 / (0.015 * 0.015)).max(1.0);
        let lit = facets * f64::from(chance) * 0.5;
        // Poisson's, while a few facets turn to the eye and away together: an exponential number by 1 - cos, a mean square of
        // 2 by 3/2. On half of the water they are four times as rare, and brightest in the middle, by 6x(1 - x) on both axes: 1.2² more.
        let square = |lit: f64, own: f64| {
            let lit = lit.max(0.5);
            (1.0 + 1.0 / lit) * (1.0 + (own - 1.0) / (1.0 + lit).powi(2))
        };
        let wanted = (0.5 * square(lit, 3.0) + 0.5 * square(0.25 * lit, 3.0 * 1.44) - 1.0).sqrt();
        assert!((deviation / wanted - 1.0).abs() < 0.1, "{across} m, {chance}: {deviation}, not {wanted}");
    }
}

#[test]
fn from_afar_the_glitter_is_its_mean() {
    let found = sparkle(26.0, NOON, |_| vec![Asked { at: [40.0, 3.0], across: 0.8, chance: 0.1 }; 64]);
    assert!(found.iter().all(|[factor, _]| *factor == 1.0), "{found:?}");
}

#[test]
fn sparkle_lies_on_the_water_whatever_eye_sees_it() {
    // Some 4 m to the north.
    let eyes = [26.0, 26.000_036];
    let [first, second] = eyes.map(|lat| {
        sparkle(lat, NOON, |frame| {
            let at = |place: DVec2| (place - frame.foam_eye.at).as_vec2().to_array();
            let start =
                Frame::new(&Settings::default(), &Camera::from_degrees(26.0, -30.0, 10.0, 0.0, 0.0), NOON, [64; 2]);
            assert_eq!(frame.foam_eye.frame, start.foam_eye.frame);
            places(4_000).map(|place| Asked { at: at(start.foam_eye.at + place), across: 0.05, chance: 0.3 }).collect()
        })
    });
    // Large facets are brighter towards their middle, by up to 3e-3 of their mean within the rounding below.
    let alike = |a: &[f32; 2], b: &[f32; 2]| a[1] == b[1] && (a[0] - b[0]).abs() <= 0.05 * a[0] + 0.01;
    let same = first.iter().zip(&second).filter(|(first, second)| alike(first, second)).count();
    println!("{same} of 4000 alike");
    // The rest lies within a rounding of 300 m, 2e-5 m, of the edge of a square 3 cm wide.
    assert!(same > 3_970, "{same}");
    let other = first.iter().zip(first.iter().skip(1)).filter(|(one, next)| one[1] == next[1]).count();
    assert!(other < 10, "{other} neighbours have the same facets");
}
