//! The bed through the water: where a sight meets it, and what is left of its light.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::optics::{WATER_INDEX, fresnel};

use crate::kernel::Kernel;

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
    lights[id.x] = vec4f(bed_radiance(Bed(a.albedo * down / PI, a.way), a.kind, down), 0.0);
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
