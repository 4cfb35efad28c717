//! Young foam lies on crests and before them, old foam where they have been.

use ocean_globe::gpu::shader;
use ocean_globe::model::waves;
use ocean_globe::scene::sea::foam::TEXELS;

use crate::foam_map::{NOON, Sea, blown, ticks};
use crate::kernel::Kernel;

/// Height of the water and its slope down the wind in a slot of a level, waves shorter than what breaks as one left out.
const KERNEL: &str = "#import waves
@group(2) @binding(0) var<storage, read> asked: array<vec2i>;
@group(2) @binding(1) var<storage, read_write> found: array<vec2f>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let level = frame.foam_levels[LEVEL];
    let slot = asked[id.x];
    let half = vec2i(FOAM_TEXELS / 2);
    let away = ((slot - level.texel + half) & vec2i(FOAM_TEXELS - 1)) - half;
    let offset = (vec2f(away) + 0.5 - level.fraction) * level.side;
    let x = wave_cells[0].axis_x;
    let y = wave_cells[0].axis_y;
    let p = offset.x * x + offset.y * y - frame.eye_altitude * cross(x, y);
    let wind = -wave_cells[0].wind.x * x - wave_cells[0].wind.y * y;
    let slope = slopes_in(OPEN_SEA, p, 1.0, level.breaking, 1.0).slope;
    found[id.x] = vec2f(displacement_in(OPEN_SEA, p, 1.0, level.breaking).z, dot(slope, wind.xy));
}";
const LEVEL: usize = 2;

/// Means of height and of slope down the wind, each in its deviations, weighted by foam.
fn under(foam: &[f64], water: &[[f64; 2]]) -> [f64; 2] {
    let all: f64 = foam.iter().sum();
    [0, 1].map(|part| {
        let count = water.len() as f64;
        let mean = water.iter().map(|w| w[part]).sum::<f64>() / count;
        let deviation = (water.iter().map(|w| (w[part] - mean).powi(2)).sum::<f64>() / count).sqrt();
        foam.iter().zip(water).map(|(foam, w)| foam * (w[part] - mean)).sum::<f64>() / (all * deviation)
    })
}

#[test]
fn young_foam_lies_on_the_lee_of_crests_and_old_foam_behind_them() {
    let sea = Sea::new(&blown(16.0));
    let definitions = format!("const WAVES: bool = true;\nconst NOISE: bool = false;\nconst LEVEL = {LEVEL};\n");
    let kernel = Kernel::<1>::new(&sea.gpu, &shader::composed(KERNEL, &definitions), "ask", &sea.layouts.each_ref());
    let slots: Vec<[i32; 2]> = (0..TEXELS * TEXELS).map(|slot| [slot % TEXELS, slot / TEXELS]).collect();
    let mut map = sea.own_map();
    let (mut young, mut old, mut water) = (Vec::new(), Vec::new(), Vec::new());
    // Four instants, between which crests of 100 m go on by half of that.
    for instant in 0..4u64 {
        let now = waves::ticks_from_unix(NOON) + instant * ticks(4.0);
        sea.bring(&mut map, now, &sea.frame.foam_eye);
        sea.run_whole(now);
        let [found] = kernel.run::<_, [f32; 2]>(&sea.gpu, &sea.groups(&map), &slots);
        water.extend(found.into_iter().map(|w| w.map(f64::from)));
        let (all, fresh) = (sea.foam(&map, LEVEL), sea.young(&map, LEVEL));
        old.extend(all.iter().zip(&fresh).map(|(all, young)| f64::from(all - young)));
        young.extend(fresh.into_iter().map(f64::from));
    }
    let [fresh, aged] = [&young, &old].map(|foam| under(foam, &water));
    let share = young.iter().sum::<f64>() / (young.iter().sum::<f64>() + old.iter().sum::<f64>());
    println!("young {fresh:.2?}, old {aged:.2?} deviations; {share:.2} of it young");
    assert!(young.iter().zip(&old).all(|(young, old)| *young >= 0.0 && *old >= -1e-6));
    // Found are 1.38 and -0.33 deviations, of some 50 crests. Foam that lies where water folds has +0.65, the side that the wave comes from;
    // all foam together lies 0.5 high.
    assert!(fresh[0] > 1.0, "young foam lies on crests: {}", fresh[0]);
    assert!(fresh[1] < -0.1, "it falls down their lee: {}", fresh[1]);
    assert!(aged[0] < 0.3 && aged[1] > 0.2, "the old stays behind them: {aged:?}");
}
