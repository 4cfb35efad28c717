//! The sun's glitter as the drawing shaders have it: as much light as facets mirror, the same way there and back.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::optics::{WATER_INDEX, fresnel};

use crate::kernel::Kernel;

const KERNEL: &str = "#import frame
#import brdf
struct Asked { view: vec3f, rough_along: f32, sun: vec3f, rough_across: f32, normal: vec3f, unused: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn glitters(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    found[id.x] = glitter(a.view, a.sun, a.normal, vec3f(0.0, 0.0, 1.0), vec3f(1.0, 0.0, 0.0), vec2f(a.rough_along, a.rough_across)).radiance;
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    view: Vec3,
    rough_along: f32,
    sun: Vec3,
    rough_across: f32,
    normal: Vec3,
    unused: f32,
}

impl Asked {
    fn level(view: DVec3, sun: DVec3, rough: [f64; 2]) -> Self {
        let [rough_along, rough_across] = rough.map(|variance| variance as f32);
        let (view, sun) = (view.as_vec3(), sun.as_vec3());
        Self { view, rough_along, sun, rough_across, normal: Vec3::Z, unused: 0.0 }
    }
}

fn direction(elevation_deg: f64, azimuth: f64) -> DVec3 {
    let (sin, cos) = elevation_deg.to_radians().sin_cos();
    DVec3::new(cos * azimuth.cos(), cos * azimuth.sin(), sin)
}

/// Of Smith's shadowing: what hides a direction of a sine `z`, over slopes of the deviation `sigma`; 0 where nothing does.
fn hiding(z: f64, sigma: f64) -> f64 {
    let x = z / (sigma * (1.0 - z * z).sqrt());
    // The mean of what rises above x, by midpoints.
    let step = 0.01;
    let above =
        (0..1000).map(|n| (f64::from(n) + 0.5) * step).map(|t| t * (-0.5 * (x + t) * (x + t)).exp()).sum::<f64>();
    above * step / ((2.0 * std::f64::consts::PI).sqrt() * x)
}

/// Share of the sun's light on level water that facets of slopes with the deviation `sigma` mirror into the sky, facet by facet.
fn mirrored(sun: DVec3, sigma: f64) -> f64 {
    let flat = (sun.x * sun.x + sun.y * sun.y).sqrt();
    let hidden = hiding(sun.z, sigma);
    let (mut light, steps) = (0.0, 120);
    let slope = |n: i32| 6.0 * (2.0 * (f64::from(n) + 0.5) / f64::from(steps) - 1.0);
    let density = (12.0 / f64::from(steps)).powi(2) / std::f64::consts::TAU;
    for (x, y) in (0..steps).flat_map(|i| (0..steps).map(move |j| (slope(i), slope(j)))) {
        let normal = DVec3::new(-sigma * x, -sigma * y, 1.0);
        let lit = DVec3::new(flat, 0.0, sun.z).dot(normal);
        let cosine = lit / normal.length();
        let out = 2.0 * cosine * normal.z / normal.length() - sun.z;
        if lit > 0.0 && out > 0.0 {
            let weight = density * (-0.5 * (x * x + y * y)).exp() * lit;
            let reaching = 1.0 / (1.0 + hidden + if out < 0.999 { hiding(out, sigma) } else { 0.0 });
            light += weight * reaching * fresnel(cosine, 1.0, WATER_INDEX).unpolarised();
        }
    }
    light / sun.z
}

fn ask(asked: &[Asked]) -> Vec<f64> {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let layouts = [(); 2].map(|()| gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[]));
    let groups = layouts.each_ref().map(|layout| gpu.bind("unused", layout, &[]));
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "glitters", &layouts.each_ref());
    let [found] = kernel.run::<_, f32>(&gpu, &groups.each_ref(), asked);
    found.into_iter().map(f64::from).collect()
}

#[test]
fn the_glitter_is_the_light_that_facets_mirror() {
    // All directions over level water, by midpoints of the sine of the elevation and of azimuth.
    const STEPS: [u32; 2] = [300, 600];
    for (elevation, variance) in [(60.0, 0.02), (40.0, 0.02), (40.0, 0.05), (15.0, 0.02), (5.0, 0.01)] {
        let sun = direction(elevation, 0.7);
        let views = (0..STEPS[0]).flat_map(|i| (0..STEPS[1]).map(move |j| (i, j))).map(|(i, j)| {
            let sine = (f64::from(i) + 0.5) / f64::from(STEPS[0]);
            let azimuth = std::f64::consts::TAU * (f64::from(j) + 0.5) / f64::from(STEPS[1]);
            direction(sine.asin().to_degrees(), azimuth)
        });
        let asked: Vec<_> = views.map(|view| Asked::level(view, sun, [variance; 2])).collect();
        let sum: f64 = ask(&asked).iter().zip(&asked).map(|(found, asked)| found * f64::from(asked.view.z)).sum();
        let albedo = sum * std::f64::consts::TAU / f64::from(STEPS[0] * STEPS[1]) / sun.z;
        let facets = mirrored(sun, variance.sqrt());
        println!("sun {elevation}, variance {variance}: {albedo:.5} of the light, by facets {facets:.5}");
        // Sums of 14,400 facets here and 180,000 directions there, single precision: a thousandth at most by a low sun.
        assert!((albedo / facets - 1.0).abs() < 0.002, "sun {elevation}, variance {variance}: {albedo}, not {facets}");
    }
}

#[test]
fn the_glitter_is_the_same_there_and_back() {
    let ways = [(60.0, 5.0), (40.0, 2.0), (20.0, 50.0), (10.0, 10.0), (3.0, 8.0)];
    let rough = [0.03, 0.012];
    let pairs: Vec<[DVec3; 2]> = ways.map(|(a, b)| [direction(a, 0.3), direction(b, 3.4)]).to_vec();
    let asked: Vec<_> =
        pairs.iter().flat_map(|[a, b]| [Asked::level(*a, *b, rough), Asked::level(*b, *a, rough)]).collect();
    for ([a, b], found) in pairs.iter().zip(ask(&asked).chunks_exact(2)) {
        // Of a sun's light on level water: the radiance over the sine of its elevation.
        let [there, back] = [found[0] / b.z, found[1] / a.z];
        println!("{there:.5} {back:.5}");
        assert!(there > 1e-4 && (there / back - 1.0).abs() < 1e-4, "{there} there, {back} back");
    }
}

#[test]
fn the_glitter_straight_below_is_that_beside_it() {
    let ask_at = |sun_deg: f64| {
        let sun = direction(sun_deg, 0.4);
        let asked = [90.0, 89.98, 89.9].map(|elevation| Asked::level(direction(elevation, 2.0), sun, [0.03, 0.02]));
        ask(&asked)
    };
    for sun_deg in [40.0, 60.0, 89.0, 90.0] {
        let found = ask_at(sun_deg);
        println!("sun {sun_deg}: {found:.6?}");
        // A tenth of a degree moves the slope that is asked for by a thousandth, a hundredth of the slopes' deviation.
        assert!(found.iter().all(|other| (other / found[0] - 1.0).abs() < 0.01), "sun {sun_deg}: {found:?}");
    }
}
