//! What a pixel keeps of the sea's mesh is what the mesh has there, as far as the words hold it.

use bytemuck::{Pod, Zeroable};
use glam::{DVec3, Vec2, Vec3};

use crate::kernel;

const KERNEL: &str = "#import places
struct Asked { rest: vec3f, height: f32, grid: vec3f, incoming: f32, ahead: vec2f, ways: vec2f, pixel: vec2u, reefs: f32, unused: u32 }
struct Found { rest: vec3f, height: f32, moved: vec3f, incoming: f32, grid: vec3f, reefs: f32, ahead: vec2f, ways: vec2f, own: vec3f, own_height: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    // The middle of the pixel sees what the mesh has there.
    let device = vec2f(2.0, -2.0) * ((vec2f(a.pixel) + 0.5) / frame.viewport - 0.5);
    let towards = frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up;
    let up = normal_delta(a.rest) + vec3f(0.0, 0.0, 1.0);
    let moved = towards * length(a.rest);
    // Where waves are smaller than pixels none moves the mesh.
    let height = select(a.height, 0.0, waves_are_pixels(length(moved)));
    let rest = moved - height * up;
    let seen = unpacked(packed(Patch(rest, moved, height, a.incoming, vec3f(0.0), vec4f(a.grid, a.reefs), a.ahead, a.ways.x, a.ways.y)), a.pixel);
    found[id.x] = Found(seen.rest - rest, seen.height, seen.moved, seen.incoming, seen.grid.xyz, seen.grid.w, seen.ahead, vec2f(seen.right, seen.down), moved, height);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    rest: Vec3,
    height: f32,
    grid: Vec3,
    incoming: f32,
    ahead: Vec2,
    ways: Vec2,
    pixel: [u32; 2],
    reefs: f32,
    unused: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Found {
    rest: Vec3,
    height: f32,
    moved: Vec3,
    incoming: f32,
    grid: Vec3,
    reefs: f32,
    ahead: Vec2,
    ways: Vec2,
    own: Vec3,
    own_height: f32,
}

/// Half a step of the mantissa of 16-bit floats, and of 32-bit ones.
const HALF: f64 = 1.0 / 2048.0;
/// See [`HALF`].
const SINGLE: f64 = 1.0 / 16_777_216.0;

#[test]
fn a_pixel_keeps_what_the_mesh_has_there() {
    let asked: Vec<Asked> = (0..256u32)
        .map(|i| {
            let part = |salt: u32| ocean_globe::model::noise::hash([i, salt, 7]) as f32 / u32::MAX as f32;
            // From beside the eye to beyond the horizon, from the deepest sea to the highest land.
            let away = 2.0 * 10f32.powf(5.0 * part(0));
            Asked {
                rest: Vec3::new(0.0, away, -10.0),
                height: 20.0 * (part(1) - 0.5),
                grid: Vec3::new(8000.0 * part(2) - 10_000.0 * part(3), 10_000.0 * part(3), part(4)),
                incoming: 10.0 * part(5),
                ahead: Vec2::new(0.4 + 3.0 * part(6), 4.0 * part(7) - 2.0),
                ways: Vec2::new(1e-3 * away, 1e-3 * away * 10f32.powf(3.0 * part(8))),
                pixel: [(64.0 * part(9)) as u32, (64.0 * part(10)) as u32],
                reefs: part(11),
                unused: 0,
            }
        })
        .collect();
    let found: Vec<Found> = kernel::answers(KERNEL, &asked);
    assert!(found.iter().filter(|found| found.own_height != 0.0).count() > 50);
    for (asked, found) in asked.iter().zip(&found) {
        let close = |name: &str, a: f32, b: f32, bound: f64| {
            assert!((f64::from(a) - f64::from(b)).abs() <= bound, "{name}: {a}, {b} of {asked:?}");
        };
        let way = found.own.as_dvec3().length();
        assert_eq!(found.rest, Vec3::ZERO);
        // The distance along the axis and back is rounded a few times.
        let moved: DVec3 = found.moved.as_dvec3() - found.own.as_dvec3();
        assert!(moved.length() <= 4.0 * SINGLE * way, "{moved} of {way} m");
        close("height", found.height, found.own_height, 8.0 * SINGLE * way + 1e-5);
        close("incoming", found.incoming, asked.incoming, HALF * f64::from(asked.incoming) + 1e-7);
        close("reefs", found.reefs, asked.reefs, 0.5 / 255.0 + 1e-6);
        for axis in 0..3 {
            close("grid", found.grid[axis], asked.grid[axis], HALF * f64::from(asked.grid[axis].abs()) + 1e-7);
        }
        for axis in 0..2 {
            close("ahead", found.ahead[axis], asked.ahead[axis], HALF * f64::from(asked.ahead[axis].abs()) + 1e-7);
            // Logarithms to the base 2, in steps of 1/102.4: half of one of the way.
            let share = 2f64.powf(0.5 / 102.4 + 1e-5) - 1.0;
            close("way", found.ways[axis], asked.ways[axis], share * f64::from(asked.ways[axis]));
        }
    }
}
