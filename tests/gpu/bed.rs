//! The bed: its shape by a shore, where a sight through the water meets it, and what is left of its light.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::optics::{WATER_INDEX, fresnel};
use ocean_globe::model::sea_bed::{Coast, Grid, grid_level, shaped_on};

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import water
const FINE = true;
const CLOUDS = false;
const MIRRORS_CLOUDS = false;
struct Asked { direction: vec3f, depth: f32, normal: vec3f, albedo: f32, kind: f32, way: f32, unused: vec2f }
@group(0) @binding(0) var<storage, read> asked: array<Asked>;
@group(0) @binding(1) var<storage, read_write> sights: array<vec4f>;
@group(0) @binding(2) var<storage, read_write> lights: array<vec4f>;
@compute @workgroup_size(64)
fn see(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    sights[id.x] = vec4f(sight_to_bed(a.direction, a.normal, vec3f(0.0, 0.0, 1.0), a.depth), 0.0);
    let down = vec3f(2.0, 1.0, 0.5);
    lights[id.x] = vec4f(bed_radiance(Bed(a.albedo * down / PI, a.way, 1.0), a.kind, down), 0.0);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    direction: Vec3,
    depth: f32,
    normal: Vec3,
    albedo: f32,
    kind: f32,
    way: f32,
    unused: [f32; 2],
}

fn seen(asked: &[Asked]) -> [Vec<[f32; 4]>; 2] {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    Kernel::<2>::new(&gpu, &shader::composed(KERNEL, ""), "see", &[]).run(&gpu, &[], asked)
}

#[test]
fn a_sight_is_refracted_to_the_bed() {
    let mut asked = Vec::new();
    for down_deg in [1.0f64, 10.0, 30.0, 60.0, 90.0] {
        for slope in [[0.0, 0.0], [0.2, -0.1], [-0.15, 0.3]] {
            let (sin, cos) = down_deg.to_radians().sin_cos();
            let direction = DVec3::new(0.8 * cos, 0.6 * cos, -sin).as_vec3();
            let normal = DVec3::new(-slope[0], -slope[1], 1.0).normalize().as_vec3();
            asked.push(Asked { direction, depth: 7.0, normal, albedo: 0.0, kind: 1.0, way: 0.0, unused: [0.0; 2] });
        }
    }
    let [sights, _] = seen(&asked);
    for (asked, sight) in asked.iter().zip(sights) {
        let (direction, normal) = (asked.direction.as_dvec3(), asked.normal.as_dvec3());
        if direction.dot(normal) >= 0.0 {
            continue; // the back of a wave
        }
        let sight = DVec3::new(sight[0].into(), sight[1].into(), sight[2].into());
        // Snell's law: the part of the direction along the surface shrinks by the index, and stays where it is.
        let along = |v: DVec3| v - v.dot(normal) * normal;
        let within = (along(sight.normalize()) - along(direction) / WATER_INDEX).length();
        assert!(within < 1e-5 && sight.dot(normal) < 0.0, "{asked:?}: {sight}");
        assert!((sight.z + 7.0).abs() < 1e-4, "{asked:?}: {sight}");
    }
}

#[test]
fn water_takes_its_part_of_the_beds_light() {
    // Per metre, one way: Jerlov's types I, IB, II, III and coastal 3 (R. Austin and T. Petzold 1984).
    let lost =
        [[0.42, 0.060, 0.012], [0.42, 0.068, 0.030], [0.42, 0.084, 0.066], [0.42, 0.113, 0.133], [0.43, 0.19, 0.40]];
    // What diffuse light from below meets of the surface: Fresnel's reflectance over all angles.
    let steps = 100_000;
    let mirrored_back: f64 = (0..steps)
        .map(|step| (f64::from(step) + 0.5) / f64::from(steps))
        .map(|cos| 2.0 * cos * fresnel(cos, WATER_INDEX, 1.0).unpolarised() / f64::from(steps))
        .sum();
    let mut asked = Vec::new();
    for kind in 0..lost.len() {
        for albedo in [0.05f32, 0.4, 1.0] {
            for way in [0.0, 3.0, 20.0] {
                let direction = Vec3::NEG_Z;
                asked.push(Asked {
                    direction,
                    depth: 1.0,
                    normal: Vec3::Z,
                    albedo,
                    kind: kind as f32,
                    way,
                    unused: [0.0; 2],
                });
            }
        }
    }
    let [_, lights] = seen(&asked);
    for (asked, light) in asked.iter().zip(lights) {
        for (part, down) in [2.0, 1.0, 0.5].into_iter().enumerate() {
            let albedo = f64::from(asked.albedo) * (-lost[asked.kind as usize][part] * f64::from(asked.way)).exp();
            // Light goes down through the surface, and back and forth below it until it has left.
            let passes =
                (1.0 - mirrored_back) * (0..200).map(|bounce| (mirrored_back * albedo).powi(bounce)).sum::<f64>();
            let wanted = albedo * passes * down / std::f64::consts::PI;
            // Reflectances of diffuse light are rounded to a thousandth.
            assert!((f64::from(light[part]) / wanted - 1.0).abs() < 4e-3, "{asked:?} {part}: {} {wanted}", light[part]);
        }
    }
}

const SHAPE: &str = "#import shore_shape
struct Asked { cells: vec4f, at: vec2f, elevation: f32, shore: f32, sin_lat: f32, unused: vec3f }
struct Found { coast: vec4f, elevation: f32, level: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let c = a.cells;
    let grid = mix(mix(grid_value(c.x), grid_value(c.y), a.at.x), mix(grid_value(c.z), grid_value(c.w), a.at.x), a.at.y);
    let coast = coast_of(grid, a.sin_lat);
    found[id.x] = Found(vec4f(coast.a, coast.m, coast.cliff, profile_depth(coast, abs(a.shore))), shaped_elevation(a.elevation, coast, a.shore), f32(grid_level()));
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Ground {
    cells: [f32; 4],
    at: [f32; 2],
    elevation: f32,
    shore: f32,
    sin_lat: f32,
    unused: [f32; 7],
}

#[test]
fn shores_are_shaped_as_in_the_model() {
    let mut asked = Vec::new();
    // A shelf, low land, an island out of a deep sea, a fjord that the grid takes for land, a polder, a bank.
    for cells in [
        [-15f32, 2.0, -22.0, -1.0],
        [-3.0, 4.0, 1.0, 8.0],
        [-2_400.0, 310.0, -1_900.0, 720.0],
        [640.0, 900.0, 350.0, 1_100.0],
        [-4.0, -3.0, -1.0, 2.0],
        [-4.0, -6.0, -3.0, -5.0],
    ] {
        for (at, sin_lat) in [([0.25, 0.5], 0.1), ([0.9, 0.1], 0.87), ([0.0, 1.0], -0.9), ([0.5, 0.5], -0.98)] {
            let elevation = Grid::between(cells.map(f64::from), at.map(f64::from)).elevation_m as f32;
            for shore in [0.01f32, 0.3, 2.0, 17.0, 140.0, 880.0, 1_700.0, 4_600.0, 9_200.0, 30_000.0] {
                asked.extend([shore, -shore].map(|shore| Ground {
                    cells,
                    at,
                    elevation,
                    shore,
                    sin_lat,
                    unused: [0.0; 7],
                }));
            }
        }
    }
    for (resolution_m, slope) in [(9_277.0, 0.03), (9_277.0, 0.1), (90.0, 0.03)] {
        let found = kernel::answers_in::<_, [f32; 8]>(SHAPE, &asked, |frame| {
            (frame.terrain_resolution, frame.shore.x) = (resolution_m as f32, slope as f32);
        });
        for (asked, found) in asked.iter().zip(&found) {
            let grid = Grid::between(asked.cells.map(f64::from), asked.at.map(f64::from));
            let (shore, sin_lat) = (f64::from(asked.shore), f64::from(asked.sin_lat));
            let coast = Coast::new(grid, resolution_m, sin_lat);
            let elevation = shaped_on(asked.elevation.into(), grid, shore, [resolution_m, slope], sin_lat);
            let wanted = [
                coast.a,
                coast.m,
                coast.cliff,
                coast.profile_m(shore.abs()),
                elevation,
                grid_level(resolution_m).into(),
            ];
            for (what, (wanted, found)) in wanted.iter().zip(found).enumerate() {
                // Powers in 32 bits lose some 1e-6 each, WGSL allows 2^-21 times the logarithm; the third step of Newton's leaves 4e-6.
                let error = (f64::from(*found) - wanted).abs();
                assert!(
                    error <= 3e-5 * wanted.abs() + 2e-6,
                    "{what}: {found} for {wanted}, {asked:?}, {resolution_m} m"
                );
            }
        }
    }
}

const MEADOWS: &str = "#import bed_cover
struct Asked { place: vec2f, depth: f32, fading: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    found[id.x] = bed_cover(a.place, a.depth, meadows_to(a.fading), vec2f(0.0), vec3f(0.0), 1.0).grass;
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Meadow {
    place: [f32; 2],
    depth: f32,
    fading: f32,
}

#[test]
fn seagrass_grows_as_deep_as_light_lets_it() {
    // Green light, per metre, of the clear ocean, a shelf, a coast and an estuary.
    for fading in [0.068, 0.113, 0.19, 0.5] {
        // C. Duarte 1991: the decimal logarithm of the depth is 0.26 less 1.07 that of the attenuation.
        let deepest = 10f64.powf(0.26 - 1.07 * f64::log10(fading));
        let share = |depth: f64| {
            let places = (0..16_384).map(|k| [k % 128, k / 128].map(|k| 32.0 * k as f32));
            let asked: Vec<_> =
                places.map(|place| Meadow { place, depth: depth as f32, fading: fading as f32 }).collect();
            let found = kernel::answers::<_, f32>(MEADOWS, &asked);
            found.iter().map(|&grass| f64::from(grass)).sum::<f64>() / found.len() as f64
        };
        let [half, most, beyond] = [0.5, 0.8, 1.01].map(|part| share(part * deepest));
        println!(
            "{fading} a metre, to {deepest:.1} m: {half:.3} at half of that, {most:.3} at 0.8, {beyond:.5} beyond"
        );
        // In the shallows there is none, either: half of what an estuary lets it grow to lies within their edge.
        assert!(half > 0.03 && most < 0.6 * half && beyond < 1e-4, "{fading}: {half} {most} {beyond}");
    }
}
