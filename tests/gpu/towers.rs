//! Towers of limestone on the device, as the model has them.

use bytemuck::{Pod, Zeroable};
use ocean_globe::model::towers;

use crate::kernel;

const KERNEL: &str = "#import towers
struct Found { height: f32, unused: f32, rise: vec2f }
@group(2) @binding(0) var<storage, read> asked: array<vec2u>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let towers = towers_at(asked[id.x], 0.0, false);
    found[id.x] = Found(towers.height, 0.0, towers.rise);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Found {
    height: f32,
    unused: f32,
    rise: [f32; 2],
}

#[test]
fn towers_stand_where_the_model_has_them_and_rise_as_they_are_high() {
    // Some 2 km of Halong's waters, and the seam of the map, over which cells wrap.
    let places: Vec<_> = (0..20_000u32)
        .map(|k| {
            let west = if k % 2 == 0 { 3_425_000_000 } else { u32::MAX - 100_000 };
            [k.wrapping_mul(7_919) % 200_000, k.wrapping_mul(104_729) % 200_000]
                .iter()
                .zip([west, 1_892_000_000u32])
                .map(|(x, corner)| corner.wrapping_add(*x))
                .collect::<Vec<_>>()
        })
        .map(|at| [at[0], at[1]])
        .collect();
    let found = kernel::answers::<_, Found>(KERNEL, &places);
    const CELL: f64 = (1u32 << towers::CELL_BITS) as f64;
    // An 8192nd of a cell to either side.
    const STEP: u32 = 4;
    let (mut off, mut slopes, mut errors) = (0.0f64, 0.0, 0.0);
    for (&[u, v], found) in places.iter().zip(&found) {
        off = off.max((f64::from(found.height) - towers::height([u, v])).abs());
        let rise = [[STEP, 0], [0, STEP]].map(|[x, y]| {
            let at = |sign: bool| {
                let moved = |a: u32, b: u32| if sign { a.wrapping_add(b) } else { a.wrapping_sub(b) };
                towers::height([moved(u, x), moved(v, y)])
            };
            (at(true) - at(false)) / (2.0 * f64::from(STEP) / CELL)
        });
        for (own, true_rise) in found.rise.iter().zip(rise) {
            slopes += true_rise * true_rise;
            errors += (f64::from(*own) - true_rise).powi(2);
        }
    }
    println!("heights off by {off:.1e}, rises by {:.1e} of themselves", f64::sqrt(errors / slopes));
    // Numbers of 24 bits through some twenty operations; at the feet of towers, where roots begin, differences of the model are not its slopes.
    assert!(off < 1e-4 && errors < 1e-3 * slopes, "{off} {errors} {slopes}");
}
