//! Light through crests against sums along the sight, and none through level water.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec2, Vec3};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::optics::WATER_INDEX;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import translucence
const FINE = true;
struct Asked { direction: vec3f, kind: f32, normal: vec3f, plume: f32, ahead: vec2f, unused: vec2f }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec4f>;
@compute @workgroup_size(64)
fn glow(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    found[id.x] = vec4f(crest_light(a.direction, a.normal, vec3f(0.0, 0.0, 1.0), a.ahead, a.kind, a.plume, vec3f(1.0)), 0.0);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    direction: Vec3,
    kind: f32,
    normal: Vec3,
    plume: f32,
    ahead: Vec2,
    unused: Vec2,
}

/// Of the open ocean, per metre.
const LOST: [f64; 3] = [0.42, 0.068, 0.030];

/// A sight along +x, `down` radians below level, onto a surface that rises by `rise` and is `higher` two metres on.
fn asked(down: f64, rise: f64, higher: f64) -> Asked {
    Asked {
        direction: Vec3::new(down.cos() as f32, 0.0, -down.sin() as f32),
        kind: 1.0,
        normal: Vec3::new(-rise as f32, 0.0, 1.0).normalize(),
        plume: 0.0,
        ahead: Vec2::new(2.0, higher as f32),
        unused: Vec2::ZERO,
    }
}

/// Light in a sun at a time, and the direction to it.
fn glow(unix_seconds: f64, asked: &[Asked]) -> (Vec<[f64; 3]>, DVec3) {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let frame =
        Frame::new(&Settings::default(), &Camera::from_degrees(0.0, 0.0, 10.0, 0.0, 0.0), unix_seconds, [64; 2]);
    let layouts = [kernel::frame_layout(&gpu), gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[])];
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let groups =
        [kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), gpu.bind("unused", &layouts[1], &[])];
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "glow", &layouts.each_ref());
    let [found] = kernel.run::<_, [f32; 4]>(&gpu, &groups.each_ref(), asked);
    (found.into_iter().map(|[r, g, b, _]| [r, g, b].map(f64::from)).collect(), frame.uniform.light.as_dvec3())
}

fn into_water(direction: DVec3, normal: DVec3) -> DVec3 {
    let c = direction.dot(normal).min(0.0);
    let along = (direction - c * normal) / WATER_INDEX;
    along - (1.0 - along.length_squared()).sqrt() * normal
}

fn phase(c: f64) -> f64 {
    (1.0 - 0.75f64 * 0.75) / (4.0 * std::f64::consts::PI * (1.0 + 0.75 * 0.75 - 1.5 * c).powf(1.5))
}

/// What scatters of a sun through the parabola's crest, summed along the sight, less that of level water; per unit scattering.
fn summed(asked: &Asked, sun: DVec3) -> [f64; 3] {
    let (direction, normal) = (asked.direction.as_dvec3(), asked.normal.as_dvec3());
    let (rise, higher) = (-normal.x / normal.z, f64::from(asked.ahead.y));
    let bend = (higher / 2.0 - rise) / 2.0;
    let inside = into_water(direction, normal);
    let to_sun = -into_water(-sun, DVec3::Z);
    let sum = |sight: DVec3, over: &dyn Fn(f64) -> f64, reach: f64, lost: f64| {
        // Over metres of the sight.
        let step = 0.002;
        let points = (0..(reach / step) as usize).map(|k| (k as f64 + 0.5) * step);
        let light = points.take_while(|way| over(*way) >= 0.0).map(|way| (-lost * (way + over(way) / to_sun.z)).exp());
        phase(to_sun.dot(sight)) * light.sum::<f64>() * step
    };
    let flat = inside.x.hypot(inside.y);
    let crest = |way: f64| (rise * way * flat + bend * (way * flat).powi(2)) - way * inside.z;
    let below = into_water(direction, DVec3::Z);
    LOST.map(|lost| {
        let even = sum(below, &|way| -way * below.z, 20.0 / lost, lost) * sun.z / to_sun.z;
        sum(inside, &crest, 200.0, lost) - even
    })
}

#[test]
fn crests_let_the_sun_through_as_sums_along_the_sight_say() {
    // Low in the west, and the sight to the east and, the other way round, to the sun.
    let evening = 1_774_026_000.0;
    let crests: Vec<Asked> = [(0.05, 0.5, 0.1), (0.1, 0.4, -0.3), (0.15, 0.6, 0.4), (0.3, 0.5, -0.2)]
        .into_iter()
        .flat_map(|(down, rise, higher)| {
            let away = asked(down, rise, higher);
            let turned = |v: Vec3| Vec3::new(-v.x, v.y, v.z);
            [away, Asked { direction: turned(away.direction), normal: turned(away.normal), ..away }]
        })
        .collect();
    let (found, sun) = glow(evening, &crests);
    println!("the sun is {:.1} degrees high, {sun:.3}", sun.z.asin().to_degrees());
    assert!(sun.x < -0.8 && sun.z > 0.2, "{sun}");
    let scattering = 0.95 * 0.06 / WATER_INDEX.powi(2);
    for (pair, found) in crests.chunks_exact(2).zip(found.chunks_exact(2)) {
        // The parabola is the same seen from its other side: the sum's axes are those of the sight.
        let flipped = DVec3::new(-sun.x, sun.y, sun.z);
        let wanted =
            [summed(&pair[0], sun), summed(&pair[0], flipped)].map(|light| light.map(|l| (scattering * l).max(0.0)));
        println!("away {:.5?} of {:.5?}; towards {:.5?} of {:.5?}", found[0], wanted[0], found[1], wanted[1]);
        for (found, wanted) in found.iter().zip(&wanted) {
            for part in 0..3 {
                // The mean depth stands for all depths: of red, which a metre of water halves, a tenth.
                let allowed = if part == 0 { 0.12 } else { 0.05 } * wanted[part] + 1e-4;
                assert!((found[part] - wanted[part]).abs() < allowed, "{part}: {found:?}, not {wanted:?}");
            }
        }
        assert!(found[1][1] > found[0][1] && found[1][1] > 0.001, "{found:?}");
    }
}

#[test]
fn level_water_has_no_crests() {
    let level: Vec<Asked> = [0.02, 0.1, 0.5, 1.2].map(|down| asked(down, 0.0, 0.0)).into();
    for hour in [15.0, 16.0, 17.5] {
        let (found, _) = glow(1_773_964_800.0 + 3600.0 * hour, &level);
        assert!(found.iter().flatten().all(|light| *light == 0.0), "{found:?}");
    }
}
