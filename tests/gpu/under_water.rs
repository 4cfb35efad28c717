//! What water adds to a sight and takes from it, against sums along the sight.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec3};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import under_water
const FINE = true;
const CLOUDS = false;
const MIRRORS_CLOUDS = false;
struct Asked { direction: vec3f, kind: f32, distance: f32, radiance: f32, altitude: f32, unused: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> seen: array<vec4f>;
@group(2) @binding(2) var<storage, read_write> beams: array<vec4f>;
@group(2) @binding(3) var<storage, read_write> sources: array<vec4f>;
@compute @workgroup_size(64)
fn look(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let w = underwater_of(a.kind, Daylight(vec3f(1.0), vec3f(0.2), 0.0, 1.0, 1.0, vec3f(0.2)));
    seen[id.x] = vec4f(seen_through(w, vec3f(a.radiance), a.altitude, a.direction, a.distance, 1.0), w.to_sun.z);
    beams[id.x] = vec4f(w.beam, 0.0);
    // What a short piece of the sight adds.
    sources[id.x] = vec4f(veil(w, a.altitude, a.direction, 0.01, 1.0) / 0.01, 0.0);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    direction: Vec3,
    kind: f32,
    distance: f32,
    radiance: f32,
    altitude: f32,
    unused: f32,
}

/// A sight from an altitude below the surface, `up_deg` over level, over a distance in metres to something of a radiance.
fn asked(altitude: f64, up_deg: f64, kind: u8, distance: f64, radiance: f32) -> Asked {
    let (sin, cos) = up_deg.to_radians().sin_cos();
    let direction = DVec3::new(cos, 0.0, sin).as_vec3();
    let (kind, distance, altitude) = (kind.into(), distance as f32, altitude as f32);
    Asked { direction, kind, distance, radiance, altitude, unused: 0.0 }
}

/// What is seen in water 4 km deep at noon on the equator, and the beam's attenuation; radiance that a metre of each sight adds.
fn seen(asked: &[Asked]) -> [Vec<[f64; 4]>; 3] {
    const EQUINOX_NOON: f64 = 1_774_008_450.0;
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let camera = Camera::from_degrees(0.0, 0.0, -3.0, 0.0, 90.0);
    let mut frame = Frame::new(&Settings::default(), &camera, EQUINOX_NOON, [64; 2]);
    frame.uniform.eye_depth = 4000.0;
    let layouts = [kernel::frame_layout(&gpu), gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[])];
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let groups =
        [kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), gpu.bind("unused", &layouts[1], &[])];
    let kernel = Kernel::<3>::new(&gpu, &shader::composed(KERNEL, ""), "look", &layouts.each_ref());
    kernel
        .run::<_, [f32; 4]>(&gpu, &groups.each_ref(), asked)
        .map(|list| list.iter().map(|v| v.map(f64::from)).collect())
}

#[test]
fn what_is_seen_fades_with_distance_as_beer_and_lambert_say() {
    for kind in 0u8..=5 {
        let pair = |distance| [0.0, 1.0].map(|radiance| asked(-3.0, 0.0, kind, distance, radiance));
        let [all, beams, _] = seen(&[pair(1.0), pair(4.0), pair(9.0)].concat());
        for (pair, metres) in all.chunks(2).zip([1.0, 4.0, 9.0]) {
            for colour in 0..3 {
                let left = pair[1][colour] - pair[0][colour];
                let expected = (-beams[0][colour] * metres).exp();
                // The veil, which is subtracted, is up to ten times what is left, and has seven digits.
                assert!(
                    (left - expected).abs() < 1e-5 * (1.0 + pair[0][colour]),
                    "kind {kind}, {metres} m: {left}, {expected}"
                );
            }
        }
    }
}

#[test]
fn the_veil_is_the_sum_of_what_each_piece_of_a_sight_adds() {
    // Upwards to the surface, level and downwards.
    for (up_deg, length_m) in [(60.0, 10.0), (20.0, 25.0), (0.0, 60.0), (-50.0, 60.0)] {
        let rise = f64::sin(f64::to_radians(up_deg));
        let along: Vec<f64> = (0..60).map(|step| (f64::from(step) + 0.5) / 60.0 * length_m).collect();
        let pieces = along.iter().map(|along| asked(-10.0 + rise * along, up_deg, 1, 1.0, 0.0));
        let all: Vec<Asked> = std::iter::once(asked(-10.0, up_deg, 1, length_m, 0.0)).chain(pieces).collect();
        let [whole, beams, sources] = seen(&all);
        let mut sum = [0.0; 3];
        for (along, source) in along.iter().zip(&sources[1..]) {
            for colour in 0..3 {
                sum[colour] += source[colour] * (-beams[0][colour] * along).exp() * length_m / 60.0;
            }
        }
        println!("{up_deg} degrees up: {:.5?}, summed {sum:.5?}", &whole[0][..3]);
        for colour in 0..3 {
            // A midpoint sum over steps of at most a metre, over which light changes by a factor of e^0.9: 0.9^2 / 24.
            let (found, sum) = (whole[0][colour], sum[colour]);
            assert!((found - sum).abs() < 0.035 * sum.max(1e-4), "{up_deg} degrees up: {found} against {sum}");
        }
    }
}

#[test]
fn water_is_bright_above_and_dark_below_and_brightest_towards_the_sun() {
    let at = [85.0, 45.0, 0.0, -45.0, -85.0].map(|up_deg| asked(-12.0, up_deg, 1, 10.0, 0.0));
    let [veils, ..] = seen(&at);
    assert!(veils[0][3] > 0.99, "the sun stands overhead: {}", veils[0][3]);
    let blue: Vec<f64> = veils.iter().map(|veil| veil[2]).collect();
    println!("blue of ten metres at 85, 45, 0, -45, -85 degrees: {blue:.4?}");
    assert!(blue.windows(2).all(|pair| pair[0] > 1.2 * pair[1]), "{blue:?}");
    assert!(blue[0] > 20.0 * blue[4], "{blue:?}");
}

#[test]
fn the_kinds_of_water_differ_in_colour_from_blue_to_brown() {
    let far: Vec<Asked> = (0u8..=5).map(|kind| asked(-1.0, 0.0, kind, 300.0, 0.0)).collect();
    let [veils, ..] = seen(&far);
    let ratios: Vec<f64> = veils.iter().map(|v| v[1] / v[2]).collect();
    println!("green over blue: {ratios:.2?}");
    assert!(ratios.windows(2).all(|pair| pair[1] > 1.15 * pair[0]), "{ratios:?}");
    assert!(ratios[0] < 0.35 && ratios[3] > 0.8 && ratios[5] > 1.5, "{ratios:?}");
    // An estuary's water is brown: it sends red back, too.
    assert!(veils[5][0] > 0.4 * veils[5][1] && veils[1][0] < 0.05 * veils[1][1], "{veils:?}");
}
