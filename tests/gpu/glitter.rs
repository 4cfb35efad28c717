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

#[test]
fn the_glint_is_as_bright_and_as_wide_as_cox_and_munk_have_it() {
    // Over winds' slopes alike on both axes; peaks and half widths in azimuth at the depression of the peak, from an integration of its own
    // over the same facets (design values 0.073 and 27, 0.040 and 35, 0.194 and 11.5 degrees).
    for (sun_deg, wind, peak, half_deg) in
        [(60.0, 5.0, 0.0709, 27.2), (60.0, 10.0, 0.0385, 35.3), (40.0, 5.0, 0.1903, 11.0)]
    {
        let (sun, variance) = (direction(sun_deg, 0.0), 0.5 * (0.003 + 0.00508 * wind));
        // The eye looks towards the sun: it stands on the other side.
        let towards = |elevation: f64, off_deg: f64| {
            Asked::level(direction(elevation, std::f64::consts::PI + off_deg.to_radians()), sun, [variance; 2])
        };
        let elevations: Vec<f64> = (1..180).map(|k| 0.5 * f64::from(k)).collect();
        let ahead = ask(&elevations.iter().map(|elevation| towards(*elevation, 0.0)).collect::<Vec<_>>());
        let (at, found) = ahead.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).unwrap();
        let azimuths: Vec<f64> = (0..900).map(|k| 0.1 * f64::from(k)).collect();
        let across = ask(&azimuths.iter().map(|off| towards(elevations[at], *off)).collect::<Vec<_>>());
        let half = azimuths[across.iter().position(|light| *light < 0.5 * found).unwrap()];
        println!(
            "sun {sun_deg}, {wind} m/s: {found:.4} per sr at {} degrees, half of it {half:.1} degrees aside",
            elevations[at]
        );
        assert!((found / peak - 1.0).abs() < 0.01, "{found}, not {peak}");
        // Steps of a tenth of a degree, and as much again by the step of half a degree in elevation.
        assert!((half - half_deg).abs() < 0.5, "{half}, not {half_deg}");
    }
    // From space, the sun behind the eye: a ring around the brightest place where the slopes that mirror are half as frequent.
    let variance = 0.5 * (0.003 + 0.00512 * 7.0);
    let arcs: Vec<f64> = (0..200).map(|k| 0.1 * f64::from(k)).collect();
    let same = |arc: &f64| Asked::level(direction(90.0 - arc, 1.0), direction(90.0 - arc, 1.0), [variance; 2]);
    let light = ask(&arcs.iter().map(same).collect::<Vec<_>>());
    let half = arcs[light.iter().position(|here| *here < 0.5 * light[0]).unwrap()];
    let wanted = (0.693_f64 * 2.0 * variance).sqrt().atan().to_degrees();
    println!("from space half of it {half:.1} degrees off, {wanted:.1} by the slopes alone");
    // Slanted water shows more of its facets: by a fourteenth at nine degrees, which moves the half by a fourteenth of that.
    assert!((half - wanted).abs() < 0.7, "{half}, not {wanted}");
}
