//! Coral reefs on the device, as the model has them.

use bytemuck::{Pod, Zeroable};
use ocean_globe::model::reefs::{self, Reef};

use crate::kernel;

const KERNEL: &str = "#import reefs
struct Asked { at: vec2u, share: f32, cos_lat: f32, shore: f32, wide: f32, plain: f32, far: f32 }
struct Found { depth: f32, left: f32, share: f32, unused: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let reef = reef_at(a.share, a.at, a.cos_lat, a.wide, false);
    let trusted = frame.terrain_resolution;
    let depth = reef_depth(reef, a.shore, a.plain, smoothstep(0.1 * trusted, trusted, a.shore), a.far);
    let share = reef_share(MapPoint(MERCATOR, a.at), sqrt(1.0 - a.cos_lat * a.cos_lat), -0.8 * a.far, 78000.0 * a.cos_lat);
    found[id.x] = Found(depth, reef_waves(reef, a.shore), share, 0.0);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    share: f32,
    cos_lat: f32,
    shore: f32,
    wide: f32,
    plain: f32,
    far: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Found {
    depth: f32,
    left: f32,
    share: f32,
    unused: f32,
}

const RESOLUTION_M: f32 = 9_277.0;

#[test]
fn reefs_are_those_of_the_model() {
    let part = |k: u32, salt: u32| (k.wrapping_mul(2_654_435_761).rotate_left(salt) >> 8) as f32 / 16_777_216.0;
    let asked: Vec<_> = (0..20_000u32)
        .map(|k| {
            // All along the tropics, over the map's seam too, and about Tahiti.
            let at = if k % 2 == 0 {
                [k.wrapping_mul(429_496_731), 2_000_000_000 + 30_000 * (k % 9_000)]
            } else {
                [365_000_000 + 911 * k, 2_360_000_000 + 577 * k]
            };
            let lat = std::f64::consts::PI * (1.0 - 2.0 * f64::from(at[1]) / 4_294_967_296.0);
            let (d, wide) = (3_500.0 * part(k, 0) * part(k, 0), 400.0 * (part(k, 3) - 0.2));
            let share = (1.4 * part(k, 7)).min(1.0);
            Asked {
                at,
                share,
                cos_lat: (1.0 / lat.cosh()) as f32,
                shore: d,
                wide: d - wide,
                plain: 0.4 * d.powf(0.67),
                far: 1_500.0 * part(k, 11),
            }
        })
        .collect();
    let found = kernel::answers_in::<_, Found>(KERNEL, &asked, |frame| frame.terrain_resolution = RESOLUTION_M);
    let (mut depths, mut waves, mut shares, mut made) = (0.0f64, 0.0f64, 0.0f64, 0);
    for (asked, found) in asked.iter().zip(&found) {
        let [share, cos_lat, shore, wide, plain, far] =
            [asked.share, asked.cos_lat, asked.shore, asked.wide, asked.plain, asked.far].map(f64::from);
        let (depth, left) = Reef::depth_on(share, asked.at, cos_lat, [shore, wide], plain, RESOLUTION_M.into(), far);
        let place = asked.at.map(|x| f64::from(x) / 4_294_967_296.0);
        let there = reefs::share(place, (1.0 - cos_lat * cos_lat).sqrt(), -0.8 * far, 78_000.0 * cos_lat);
        made += usize::from((depth - plain).abs() > 1.0);
        depths = depths.max((f64::from(found.depth) - depth).abs() / (1.0 + depth));
        waves = waves.max((f64::from(found.left) - left).abs());
        shares = shares.max((f64::from(found.share) - there).abs());
    }
    println!("{made} of {}; depths off by {depths:.1e}, waves by {waves:.1e}, shares by {shares:.1e}", asked.len());
    // Ways to passes are quotients of noises in 24 bits, some 1e-5 of a cell of kilometres; a side of a pass falls by 20 m within 110 m.
    assert!(made > 5_000 && depths < 1e-3 && waves < 1e-3 && shares < 1e-4, "{depths} {waves} {shares}");
}

const BED: &str = "#import sea_bed
const FINE = true;
const CLOUDS = false;
const MIRRORS_CLOUDS = false;
struct Asked { at: vec2u, corals: vec2f }
struct Found { below: vec4f, above: vec4f }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let point = MapPoint(MERCATOR, a.at);
    let below = bed_look(pattern_place(point, vec2f(0.0)), 3.0, 20.0, a.corals, Footprint(1.0, vec2f(0.0))).albedo;
    let above = covered_bed(point, with_coral_sand(BED_ALBEDO, 3.0, a.corals.y), 3.0, 20.0, a.corals, 1.0);
    found[id.x] = Found(vec4f(below, 0.0), vec4f(above, 0.0));
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct AskedBed {
    at: [u32; 2],
    corals: [f32; 2],
}

#[test]
fn the_bed_of_a_reef_is_the_same_from_above_and_from_within_the_water() {
    let means = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|corals| {
        let place = |k: u32| [2_000_000_000 + 8_011 * (k % 128), 1_900_000_000 + 8_017 * (k / 128)];
        let asked: Vec<_> = (0..128 * 128).map(|k| AskedBed { at: place(k), corals }).collect();
        let found = kernel::answers::<_, [[f32; 4]; 2]>(BED, &asked);
        [0, 1].map(|side| found.iter().map(|found| f64::from(found[side][1])).sum::<f64>() / found.len() as f64)
    });
    println!("green, from below and above: {means:.3?}");
    // Noises of a metre are whole from below and of some in the mean from above.
    assert!(means.iter().all(|[below, above]| (below / above - 1.0).abs() < 0.1), "{means:?}");
    assert!(means[2][0] < 0.6 * means[1][0], "corals are dark: {means:?}");
}
