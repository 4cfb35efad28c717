//! What stands on the ground leaves the ground as bright as it is.

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::noise;

use crate::kernel::Kernel;

const LEVEL: u32 = 22;

const KERNEL: &str = "#import plants
struct Asked { at: vec2u, share: f32, radius: f32 }
@group(0) @binding(0) var<storage, read> asked: array<Asked>;
@group(0) @binding(1) var<storage, read_write> found: array<vec4f>;
@compute @workgroup_size(64)
fn look(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let here = caps(a.at, 22u, a.share, a.radius);
    found[id.x] = vec4f(here.height, here.rise, 0.0);
}";

/// What the shaders that import it declare.
const DECLARED: &str = "alias Metres = f32;
const PI = 3.141592653589793;
const EARTH_TURN: Metres = 40075016.686;";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    share: f32,
    radius: f32,
}

fn caps(asked: &[Asked]) -> Vec<[f64; 3]> {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let [found] = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, DECLARED), "look", &[]).run(&gpu, &[], asked);
    found.into_iter().map(|[height, right, down, _]: [f32; 4]| [height, right, down].map(f64::from)).collect()
}

fn places(count: i32) -> impl Iterator<Item = [u32; 2]> {
    (0..count).map(|n| noise::bits(3, 1, n, 0)[0]).map(|bits| [bits as u32, (bits >> 32) as u32])
}

#[test]
fn plants_leave_the_grounds_mean() {
    const COUNT: i32 = 100_000;
    for (share, radius) in [(0.14, 0.22), (0.4, 0.4), (0.85, 0.66), (0.98, 0.68)] {
        let asked: Vec<_> = places(COUNT).map(|at| Asked { at, share, radius }).collect();
        let heights: Vec<_> = caps(&asked).into_iter().map(|[height, ..]| height).collect();
        let mean = heights.iter().sum::<f64>() / f64::from(COUNT);
        let least = heights.iter().copied().fold(f64::MAX, f64::min);
        let stands = heights.iter().filter(|height| **height > least + 1e-4).count() as f64 / f64::from(COUNT);
        println!(
            "share {share}, radius {radius}: mean {mean:.4}, {stands:.3} of the ground is covered, bare ground {least:.3}"
        );
        // Of the mean height that is taken off 2 %, and a chance of 3 deviations, .3 each.
        assert!(mean.abs() < 0.02 * -least + 3.0 * 0.3 / f64::from(COUNT).sqrt(), "{mean}");
        // Discs that did not overlap; where most of the ground is covered, by chance alone.
        let area = f64::from(share) * std::f64::consts::PI * f64::from(radius * radius) * (1.0 + 0.45 + 0.2025) / 3.0;
        assert!(stands < area + 0.01 && stands > 1.0 - (-area).exp() - 0.01, "{stands} covered, discs of {area}");
    }
}

#[test]
fn crowns_rise_as_their_slopes_say() {
    const STEP: u32 = 1 << (32 - LEVEL - 7);
    let [share, radius] = [0.8, 0.6];
    let pairs = |by: [u32; 2]| -> Vec<_> {
        places(500)
            .flat_map(|at| [at, [at[0].wrapping_add(by[0]), at[1].wrapping_add(by[1])]])
            .map(|at| Asked { at, share, radius })
            .collect()
    };
    for (way, by) in [[STEP, 0], [0, STEP]].into_iter().enumerate() {
        let found = caps(&pairs(by));
        let mut odd = 0;
        for pair in found.chunks_exact(2) {
            let [here, there] = [pair[0], pair[1]];
            let rise = (there[0] - here[0]) * 128.0;
            let told = 0.5 * (here[1 + way] + there[1 + way]);
            odd += usize::from((rise - told).abs() > 0.05);
        }
        // But where a cap begins between the two: outlines of 3 cells' length a cell, a 128th of a cell wide.
        assert!(odd < 25, "{odd} of 500 rise otherwise");
    }
}
