//! What stands on the ground leaves the ground as bright as it is, and stands upright in one place for every eye.

use bytemuck::{Pod, Zeroable};
use ocean_globe::model::noise;

use crate::kernel;

const KERNEL: &str = "#import plants
const EARTH_TURN: Metres = 40075016.686;
struct Asked { at: vec2u, sight: vec2f, share: f32, green: f32, size: u32, unused: u32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec4f>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let here = domes(FinePoint(a.at, vec2f(0.0)), lattice_of(a.size), a.share, a.green, a.sight, vec2f(0.0), 0.02, false);
    let tone = dome_cover(a.share, a.green) * dot(dome_tones(a.green), vec2f(1.0, 2.0 / 3.0));
    found[id.x] = vec4f(here.cover, here.tone, dome_cover(a.share, a.green), tone);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    sight: [f32; 2],
    share: f32,
    green: f32,
    size: u32,
    unused: u32,
}

const COUNT: i32 = 50_000;

/// Means over the plane: cover and tone as drawn, and as they are said to be.
fn means(sight: [f32; 2], share: f32, green: f32, size: u32) -> [f64; 4] {
    let places = (0..COUNT).map(|n| noise::bits(3, 1, n, 0)[0]).map(|bits| [bits as u32, (bits >> 32) as u32]);
    let asked: Vec<_> = places.map(|at| Asked { at, sight, share, green, size, unused: 0 }).collect();
    let found: Vec<[f32; 4]> = kernel::answers(KERNEL, &asked);
    std::array::from_fn(|part| found.iter().map(|f| f64::from(f[part])).sum::<f64>() / f64::from(COUNT))
}

#[test]
fn plants_leave_the_grounds_mean() {
    for (share, green, size) in [(0.1, 0.0, 2), (0.3, 0.5, 0), (0.7, 1.0, 1), (0.98, 1.0, 3)] {
        let [cover, tone, told_cover, told_tone] = means([0.0, 0.0], share, green, size);
        println!(
            "share {share}, green {green}: {cover:.4} covered of {told_cover:.4}, tone {tone:.4} of {told_tone:.4}"
        );
        // Numbers of 8 bits are 1/512 off a share, and three deviations of chance are 0.007 of cover and of tone.
        assert!((cover - told_cover).abs() < 0.011, "{cover} for {told_cover}");
        assert!((tone - told_tone).abs() < 0.011, "{tone} for {told_tone}");
    }
}

#[test]
fn slanted_sights_meet_more_of_what_stands_upright() {
    for turn in [[1.0, 0.0], [0.0, -1.0], [-0.6, 0.8]] {
        let cover = [0.0, 1.5, 4.0].map(|far: f32| means(turn.map(|x: f32| x * far), 0.3, 1.0, 0)[0]);
        println!("along {turn:?}: {cover:.3?} covered");
        // The shadow of a half ball, squeezed to 0.75, in light that goes 1.5 its way aside: an ellipse's half beyond the disc's, 1 and 1.25 of
        // it; 4: 1 and 2.1. Of teeth in the outline a quarter may be missing, and shadows overlap.
        assert!(cover[1] > 1.05 * cover[0] && cover[2] > 1.3 * cover[0], "{cover:?}");
        assert!(cover[1] < 1.5 * cover[0] && cover[2] < 3.2 * cover[0], "{cover:?}");
    }
}
