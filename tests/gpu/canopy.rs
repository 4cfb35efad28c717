//! Woods cover the share of the ground that they are told, are as bright as it in the mean, and every sight meets the crown that stands first in its way.

use bytemuck::{Pod, Zeroable};
use ocean_globe::model::lace::quantile;

use crate::kernel;

/// The height at which a sight meets the first crown, and that of the highest hit among all crowns of 19 by 19 cells about its place.
const KERNEL: &str = "#import canopy
const EARTH_TURN: Metres = 40075016.686;
struct Asked { at: vec2u, sight: vec2f, woods: f32, pointed: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<array<f32, 4>>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let seen = canopy(FinePoint(a.at, vec2f(0.0)), a.woods, a.pointed, a.sight, vec2f(0.5, 0.2), 0.05, false);
    let turned = vec2u(a.at.x - a.at.y, a.at.y + a.at.x);
    let shift = 32u - CROWN_LEVEL;
    let f = vec2f(turned & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    let moves = by_turn(vec2f(CROWN_TURN), a.sight) / sqrt(2.0);
    var highest = 0.0;
    for (var k = 0u; k < 361u; k++) {
        let crown = crown_of(turned >> vec2u(shift), vec2f(vec2u(k % 19u, k / 19u)) - 9.0, a.woods, a.pointed);
        highest = max(highest, crown_met(f, moves, crown, mix(CROWN_TALL.x, CROWN_TALL.y, a.pointed)));
    }
    found[id.x] = array(seen.tone, seen.height, highest, seen.shade);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    sight: [f32; 2],
    woods: f32,
    pointed: f32,
}

const SIDE: u32 = 128;

/// A square of the map 46 cells wide, a third of a cell from point to point.
fn square(sight: [f32; 2], woods: f32, pointed: f32) -> Vec<[f32; 4]> {
    let place = |i: u32| [i % SIDE, i / SIDE].map(|x| (1 << 29) + x * 263);
    let asked: Vec<_> = (0..SIDE * SIDE).map(|i| Asked { at: place(i), sight, woods, pointed }).collect();
    kernel::answers(KERNEL, &asked)
}

#[test]
fn a_sight_meets_the_first_crown_in_its_way() {
    // From straight down to 20° below the horizontal, where it goes 2.7 cells while it sinks by one.
    for (sight, woods, pointed) in
        [([0.0, 0.0], 1.0, 0.0), ([1.0, -0.3], 0.6, 0.0), ([-1.9, 1.7], 1.0, 0.0), ([-0.4, 1.4], 0.7, 1.0)]
    {
        let found = square(sight, woods, pointed);
        let worst = found.iter().map(|f| (f[1] - f[2]).abs()).fold(0.0_f32, f32::max);
        let covered = found.iter().filter(|f| f[2] > 0.0).count();
        println!("{sight:?}, {woods}, {pointed}: {worst:.6} off at most, {covered} of {} points covered", found.len());
        // Places are known to 1/1024 of a cell, which matters where a sight only just touches a crown.
        assert!(worst < 1e-3, "{sight:?}: {worst}");
        assert!(covered > found.len() / 3);
    }
}

#[test]
fn a_wood_is_as_bright_as_the_ground_it_covers() {
    for pointed in [0.0, 1.0] {
        let found = square([0.0, 0.0], 1.0, pointed);
        let mean = |part: usize| found.iter().map(|f| f64::from(f[part])).sum::<f64>() / found.len() as f64;
        println!("pointed {pointed}: tone {:.4}, in shade {:.3}", mean(0), mean(3));
        // Tones of 2000 crowns deviate by 0.3 each.
        assert!(mean(0).abs() < 0.05, "{}", mean(0));
    }
}

const SHARES: &str = "#import canopy
const EARTH_TURN: Metres = 40075016.686;
@group(2) @binding(0) var<storage, read> asked: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    found[id.x] = woods_at(asked[id.x].x, asked[id.x].yzw);
}";

/// However much of the noise shows, woods cover their share: the noise is normal, as sums of octaves are, here each of its quantiles.
#[test]
fn woods_cover_their_share_in_pixels_of_any_width() {
    const DEVIATION: f64 = 0.25;
    const COUNT: usize = 4_096;
    let normal: Vec<f64> = (0..COUNT).map(|k| quantile((k as f64 + 0.5) / COUNT as f64)).collect();
    for shown in [0.0, 0.3, 0.7, 1.0_f64] {
        for share in [0.0, 0.1, 0.35, 0.5, 0.8, 1.0] {
            let asked: Vec<[f32; 4]> = normal
                .iter()
                .map(|n| {
                    [share, shown.sqrt() * DEVIATION * n, DEVIATION, shown * DEVIATION * DEVIATION].map(|x| x as f32)
                })
                .collect();
            let found: Vec<f32> = kernel::answers(SHARES, &asked);
            let mean = found.iter().map(|x| f64::from(*x)).sum::<f64>() / COUNT as f64;
            println!("{shown} shown: {mean:.4} for {share}");
            // The logistic distribution is 0.0095 off the normal one at most, twice where one blurs the other.
            assert!((mean - share).abs() < 0.015, "{shown}, {share}: {mean}");
        }
    }
}
