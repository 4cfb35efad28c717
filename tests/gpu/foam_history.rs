//! Foam on the GPU is the same however the time is cut into frames and wherever the eye has been.

use glam::DVec2;
use ocean_globe::model::waves;
use ocean_globe::scene::sea::foam::{FoamEye, LEVELS, TEXELS};

use crate::foam_map::{Map, NOON, Sea, blown, mean, ticks};

fn correlation(a: &[f32], b: &[f32]) -> f64 {
    let (ma, mb) = (mean(a), mean(b));
    let product = |a: &[f32], ma: f64, b: &[f32], mb: f64| {
        a.iter().zip(b).map(|(&x, &y)| (f64::from(x) - ma) * (f64::from(y) - mb)).sum::<f64>()
    };
    product(a, ma, b, mb) / (product(a, ma, a, ma) * product(b, mb, b, mb)).sqrt()
}

/// The world's texels of a level about an eye, with their slots.
fn texels(eye: &FoamEye, level: usize) -> impl Iterator<Item = ([i32; 2], usize)> + use<> {
    let [x, y] = eye.texel(level).0;
    let half = TEXELS / 2;
    let slot = |x: i32, y: i32| (y.rem_euclid(TEXELS) * TEXELS + x.rem_euclid(TEXELS)) as usize;
    (y - half..y + half).flat_map(move |y| (x - half..x + half).map(move |x| ([x, y], slot(x, y))))
}

/// Slots of level 0 about an eye with the foam that level 2 has there: nine texels are as wide as one of its, and between these the map is
/// linear, as where it is drawn.
fn spread<'a>(coarse: &'a [f32], eye: &FoamEye) -> impl Iterator<Item = (usize, f64)> + use<'a> {
    let slot = |x: i32, y: i32| (y.rem_euclid(TEXELS) * TEXELS + x.rem_euclid(TEXELS)) as usize;
    texels(eye, 0).map(move |([x, y], at)| {
        let place = (DVec2::new(f64::from(x), f64::from(y)) + 0.5) / 9.0 - 0.5;
        let (cell, f) = (place.floor().as_ivec2(), place - place.floor());
        let value = |dx: i32, dy: i32| f64::from(coarse[slot(cell.x + dx, cell.y + dy)]);
        let row = |dy: i32| value(0, dy) * (1.0 - f.x) + value(1, dy) * f.x;
        (at, row(0) * (1.0 - f.y) + row(1) * f.y)
    })
}

#[test]
fn levels_on_which_the_same_waves_break_hold_the_same_foam() {
    let sea = Sea::new(&blown(21.0));
    let [finest, _, coarse, _] = sea.frame.whitecaps.breaking_m;
    assert!(finest == coarse && coarse > 2.5, "{finest}, {coarse}");
    let mut map = sea.own_map();
    sea.bring(&mut map, waves::ticks_from_unix(NOON), &sea.frame.foam_eye);
    let [fine, coarse] = [0, 2].map(|level| sea.foam(&map, level));
    let (fine, coarse): (Vec<f32>, Vec<f32>) =
        spread(&coarse, &sea.frame.foam_eye).map(|(at, coarse)| (fine[at], coarse as f32)).unzip();
    let alike = correlation(&fine, &coarse);
    println!("{alike:.4}");
    // Between the coarse level's texels foam is interpolated over 2.25 m, from crests that are filtered over 2.8 m.
    assert!(alike > 0.9, "{alike}");
}

#[test]
fn foam_that_no_crest_renews_decays_with_its_lifetime() {
    let sea = Sea::new(&blown(16.0));
    let mut map = sea.own_map();
    let (start, eye) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    sea.bring(&mut map, start, &eye);
    let before = sea.foam(&map, 1);
    let mut calm = sea.frame.uniform;
    for own in &mut calm.foam_levels {
        own.threshold = -1e3;
    }
    sea.gpu.queue.write_buffer(&map.uniform, 0, bytemuck::bytes_of(&calm));
    sea.step(&mut map, start + ticks(0.7), &eye);
    sea.step(&mut map, start + ticks(2.0), &eye);
    let after = sea.foam(&map, 1);
    let want = (-2.0 / sea.lifetime_s).exp();
    let mut seen = 0;
    for (before, after) in before.into_iter().zip(after).filter(|(before, _)| *before > 0.01) {
        seen += 1;
        // Each of the two steps rounds its factor and its product to 24 bits, 3e-7 in all. The bound is that of a 16-bit map.
        let ratio = f64::from(after / before);
        assert!((ratio / want - 1.0).abs() < 2.0 * 2f64.powi(-10), "{before} to {after}: {ratio} of {want}");
    }
    assert!(seen > 1000, "{seen} texels had foam");
}

#[test]
fn frames_of_60_and_of_15_a_second_make_the_same_foam() {
    let sea = Sea::new(&blown(16.0));
    let (start, eye) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    let mut maps = [sea.own_map(), sea.own_map()];
    let begun = start - ticks(1.0);
    for map in &mut maps {
        sea.bring(map, begun, &eye);
    }
    // Two seconds: whatever is white has been born or has grown old meanwhile.
    for frame in 1..=120u64 {
        let now = begun + frame * ticks(1.0) / 60;
        sea.run(now);
        sea.step(&mut maps[0], now, &eye);
        if frame % 4 == 0 {
            sea.step(&mut maps[1], now, &eye);
        }
    }
    for level in 0..LEVELS {
        let [fast, slow] = [0, 1].map(|map| sea.foam(&maps[map], level));
        let (difference, alike) = (mean(&slow) / mean(&fast) - 1.0, correlation(&fast, &slow));
        println!("level {level}: {:+.2} %, correlation {alike:.4}", 100.0 * difference);
        assert!(difference.abs() < 0.05, "level {level}: {difference}");
        assert!(alike > 0.97, "level {level}: {alike}");
    }
}

#[test]
fn foam_stays_where_it_is_when_the_eye_moves() {
    let sea = Sea::new(&blown(16.0));
    let (now, eye) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    let mut map = sea.own_map();
    sea.bring(&mut map, now, &eye);
    let start: Vec<Vec<f32>> = (0..LEVELS).map(|level| sea.foam(&map, level)).collect();
    // 10 m sideways, then forth and back to the same place another way.
    let moved = |x: f64, y: f64| FoamEye { at: eye.at + DVec2::new(x, y), ..eye };
    let mut last = eye;
    for stop in [moved(0.0, 10.0), moved(7.3, 10.0), moved(7.3, -3.0), moved(0.0, 10.0)] {
        assert_eq!(sea.bring(&mut map, now, &stop), 1, "time stands still: one step that takes no time");
        last = stop;
    }
    for (level, start) in start.iter().enumerate() {
        let here = sea.foam(&map, level);
        // What every level on the way has held.
        let reach = |at: &FoamEye, [x, y]: [i32; 2]| {
            let [ex, ey] = at.texel(level).0;
            (-TEXELS / 2..TEXELS / 2).contains(&(x - ex)) && (-TEXELS / 2..TEXELS / 2).contains(&(y - ey))
        };
        let stops = [eye, moved(0.0, 10.0), moved(7.3, 10.0), moved(7.3, -3.0)];
        let (mut known, mut foamy, mut fresh) = (0, 0, 0);
        for (world, slot) in texels(&last, level) {
            if stops.iter().all(|stop| reach(stop, world)) {
                known += 1;
                foamy += usize::from(start[slot] > 0.1);
                // A step that takes no time copies each value. The bound is that of a 16-bit map, rounded to in each of four.
                let error = (here[slot] - start[slot]).abs();
                assert!(
                    error <= 4.0 * 2f32.powi(-10) * start[slot],
                    "level {level} {world:?}: {} was {}",
                    here[slot],
                    start[slot]
                );
            } else {
                fresh += 1;
            }
        }
        println!("level {level}: {known} texels known, {foamy} white, {fresh} new");
        assert!(known > 40_000 && foamy > 500, "level {level}: {known}, {foamy}");
        assert!(fresh > 0, "level {level}: the eye has moved");
    }
}

#[test]
fn a_replay_makes_the_foam_that_time_would_have_made() {
    let sea = Sea::new(&blown(16.0));
    let (now, eye) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    let all = |map: &Map| -> Vec<Vec<f32>> { (0..LEVELS).map(|level| sea.foam(map, level)).collect() };
    let mut map = sea.own_map();
    let steps = sea.bring(&mut map, now, &eye);
    let replayed = all(&map);
    // Again, on a map of its own that comes from an hour later: no history is left, so it is rebuilt, to the last bit.
    let mut again = sea.own_map();
    assert!(sea.bring(&mut again, now + ticks(3600.0), &eye) > 10);
    let later = all(&again);
    assert_eq!(sea.bring(&mut again, now, &eye), steps);
    assert!(all(&again) == replayed, "two replays differ, or a jump leaves traces");
    // In frames of 1/8 s, from further back than a replay goes.
    let mut run = sea.own_map();
    for frame in (0..=120u64).rev() {
        let instant = now - frame * ticks(0.125);
        sea.run(instant);
        sea.step(&mut run, instant, &eye);
    }
    for (level, (run, replayed)) in all(&run).iter().zip(&replayed).enumerate() {
        let (difference, alike) = (mean(replayed) / mean(run) - 1.0, correlation(run, replayed));
        let other = correlation(&later[level], replayed);
        println!(
            "level {level}: {:+.1} %, correlation {alike:.3}, with another hour's {other:.3}; {steps} steps",
            100.0 * difference
        );
        // It forgets e⁻³ = 5 %. Its steps of 1/4 s meet by chance the crests of level 0, which break for some 0.15 s: two in five are
        // missed, the others count more, and half as much again where crests break longer than that.
        assert!(difference.abs() < 0.12, "level {level}: {difference}");
        assert!(alike > if level == 0 { 0.85 } else { 0.95 }, "level {level}: {alike}");
        assert!(other.abs() < 0.3, "level {level}: foam of another hour correlates by {other}");
    }
}

#[test]
fn an_eye_that_comes_down_finds_the_foam_of_the_coarser_levels_and_at_rest_its_own() {
    let sea = Sea::new(&blown(16.0));
    let (now, low) = (waves::ticks_from_unix(NOON), sea.frame.foam_eye);
    let high = FoamEye { finest: 2, ..low };
    let mut map = sea.own_map();
    sea.bring(&mut map, now, &high);
    assert_eq!(sea.follow(&mut map, now, &low, true), 1, "one step that takes no time");
    let [seen, coarse] = [0, 2].map(|level| sea.foam(&map, level));
    let (mut foamy, mut worst) = (0, 0.0_f64);
    for (at, want) in spread(&coarse, &low) {
        foamy += usize::from(want > 0.1);
        worst = worst.max((f64::from(seen[at]) - want).abs());
    }
    println!("{foamy} white texels, {worst:.1e} at most from the coarser level");
    // Places in texels of up to some 100 are exact to 2^-17 of one.
    assert!(foamy > 100 && worst < 2e-5, "{foamy} white, {worst}");
    // At rest, with time standing still, the replay: the map of an eye that has always been here.
    let steps = sea.bring(&mut map, now, &low);
    let mut own = sea.own_map();
    assert_eq!(sea.bring(&mut own, now, &low), steps);
    assert!(sea.foam(&map, 0) == sea.foam(&own, 0), "the way down has left traces");
    assert_eq!(sea.bring(&mut map, now, &low), 0, "at rest");
}
