//! The bisected mesh: sound after every update, refined as asked, the same from wherever it came.

use std::collections::{HashMap, HashSet};

use ocean_globe::model::cuboid::{self, Point, Triangle};
use ocean_globe::pass::bisect::capacity_for;
use ocean_globe::scene::frame::bisection::Bisection;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::view::camera::Camera;

use crate::pool::{Pool, check, edges, frame, middle, settings, triangles};

/// What a made-up rule wishes of the edge with a middle: about `share` of eight edges.
fn wished(middle: Point, round: u32, share: u32) -> bool {
    let mixed = middle[0].wrapping_mul(0x9e37_79b1)
        ^ middle[1].wrapping_mul(0x85eb_ca77)
        ^ middle[2].wrapping_mul(0xc2b2_ae3d)
        ^ round.wrapping_mul(0x27d4_eb2f);
    let mixed = (mixed ^ mixed >> 16).wrapping_mul(0x1656_67b1);
    (mixed ^ mixed >> 13) % 64 < share
}

/// The same rule in the shader.
const RULE: &str = "fn asks(a: vec3u, b: vec3u) -> bool {
    let m = middle(a, b);
    let mixed = (m.x * 0x9e3779b1u) ^ (m.y * 0x85ebca77u) ^ (m.z * 0xc2b2ae3du) ^ (bisection.unused_a * 0x27d4eb2fu);
    let again = (mixed ^ (mixed >> 16u)) * 0x165667b1u;
    return (again ^ (again >> 13u)) % 64u < bisection.unused_b;
}
fn asks_of_the_screen(";

/// One update by the book: wishes, what follows from them, and diamonds whose old base nobody wishes to halve. Returns the
/// triangles, and how often each of the seven wishes came and each of the four patterns that can follow.
fn expected(mesh: &HashSet<Triangle>, asks: impl Fn([Point; 2]) -> bool) -> (HashSet<Triangle>, [[usize; 8]; 2]) {
    let key = |[a, b]: [Point; 2]| if a < b { [a, b] } else { [b, a] };
    let mut split: HashSet<[Point; 2]> = mesh.iter().flat_map(|t| edges(*t)).filter(|e| asks(*e)).map(key).collect();
    loop {
        let legs_without_base = mesh.iter().filter_map(|t| {
            let [base, left, right] = edges(*t).map(key);
            ((split.contains(&left) || split.contains(&right)) && !split.contains(&base)).then_some(base)
        });
        let more: Vec<_> = legs_without_base.collect();
        if more.is_empty() {
            break;
        }
        split.extend(more);
    }
    let mut patterns = [[0; 8]; 2];
    let number = |[base, left, right]: [bool; 3]| usize::from(base) + 2 * usize::from(left) + 4 * usize::from(right);
    let mut diamonds: HashMap<Point, Vec<Triangle>> = HashMap::new();
    let mut after = HashSet::new();
    for &t in mesh {
        let [base, left, right] = edges(t).map(|edge| split.contains(&key(edge)));
        patterns[0][number(edges(t).map(&asks))] += 1;
        patterns[1][number([base, left, right])] += 1;
        if !base {
            after.insert(t);
            diamonds.entry(t[0]).or_default().push(t);
            continue;
        }
        let [apex, l, r] = t;
        let m = middle([l, r]);
        let mut add = |halved: bool, t: Triangle| {
            let [apex, l, r] = t;
            let m = middle([l, r]);
            after.extend(if halved { vec![[m, apex, l], [m, r, apex]] } else { vec![t] });
        };
        add(left, [m, apex, l]);
        add(right, [m, r, apex]);
    }
    let is_complete = |apex: Point, t: &[Triangle]| {
        let base = cuboid::parents(apex)?;
        (t.len() == 4 && t.iter().all(|t| base.contains(&t[1]) != base.contains(&t[2]))).then_some(base)
    };
    for (apex, four) in diamonds {
        let Some(base) = is_complete(apex, &four).filter(|base| !asks(*base)) else { continue };
        for t in &four {
            after.remove(t);
            // The first half of a triangle has an end of the old base on its right.
            if base.contains(&t[2]) {
                let other = if t[2] == base[0] { base[1] } else { base[0] };
                after.insert([t[1], t[2], other]);
            }
        }
    }
    (after, patterns)
}

#[test]
fn any_wishes_are_met_in_all_seven_patterns_and_merges_beside_them() {
    let pool = Pool::edited(1 << 16, |text| {
        let edited = text.replace("fn asks(", RULE);
        assert_ne!(edited, text);
        edited
    });
    let mut mesh: HashSet<Triangle> = cuboid::roots().0.into_iter().collect();
    let mut met = [[0; 8]; 2];
    let mut merged = 0;
    for round in 0..60 {
        // The mesh grows to some ten thousand triangles and shrinks again.
        let share = if mesh.len() > 8_000 { 0 } else { [64, 40, 28, 12, 50][round as usize % 5] };
        let wish = Bisection { unused_a: round, unused_b: share, budget: 40_000, ..Bisection::default() };
        pool.update_with(&wish, 1);
        let (after, patterns) = expected(&mesh, |edge| wished(middle(edge), round, share));
        let found = triangles(&pool.mesh());
        assert!(
            found == after,
            "round {round}: {} of {}, {} agree",
            found.len(),
            after.len(),
            found.intersection(&after).count()
        );
        merged += mesh.iter().filter(|t| !after.contains(*t)).count();
        met.iter_mut().flatten().zip(patterns.into_iter().flatten()).for_each(|(all, here)| *all += here);
        mesh = after;
    }
    println!(
        "wishes and patterns by their edges (base 1, left 2, right 4): {met:?}; {} triangles at the end",
        mesh.len()
    );
    let [wishes, patterns] = met;
    assert!(wishes[1..].iter().all(|count| *count > 50), "wishes {wishes:?}");
    assert!([1, 3, 5, 7].iter().all(|pattern| patterns[*pattern] > 50), "patterns {patterns:?}");
    assert_eq!(patterns[2] + patterns[4] + patterns[6], 0, "a leg without its base");
    assert!(merged > 1_000);
}

#[test]
fn the_first_mesh_is_a_closed_cuboid() {
    let pool = Pool::new(8192);
    let mesh = pool.mesh();
    assert_eq!(mesh.len(), 24);
    check(&mesh);
}

#[test]
fn it_settles_to_the_same_mesh_from_everywhere() {
    let pool = Pool::new(capacity_for(20_000));
    let (settings, mut seas) = (settings(20.0, 20_000), Seas::default());
    let view = |lat, lon, altitude, heading, tilt| Camera::from_degrees(lat, lon, altitude, heading, tilt);
    for camera in [
        view(20.0, -30.0, 2e7, 0.0, 0.0),
        view(35.68, -14.25, 2.0, 206.0, 84.0),
        view(0.0, 0.0, 560.0, 90.0, 70.0),
        view(90.0, 0.0, 30_000.0, 0.0, 60.0),
        view(-35.0, 179.999, 30.0, 45.0, 85.0),
    ] {
        let frame = frame(&mut seas, &settings, &camera);
        let start = std::time::Instant::now();
        pool.update(&frame, 64);
        let here = triangles(&pool.mesh());
        let state = pool.state();
        println!("{} triangles, {state:?} {:?}", here.len(), start.elapsed());
        pool.bisect.reset(&pool.gpu);
        pool.update(&frame, 64);
        assert!(triangles(&pool.mesh()) == here);
    }
}

#[test]
fn a_mesh_at_rest_sleeps_until_it_is_woken() {
    let pools = ["LISTED", "AWAKE"].map(|rest| {
        Pool::edited(1 << 15, |text| text.replace("select(AWAKE, LISTED,", &format!("select(AWAKE, {rest},")))
    });
    // Under its budget a mesh does not depend on the order of its slots.
    let (settings, mut seas) = (settings(24.0, 20_000), Seas::default());
    let mut vertices = Vec::new();
    for (heading, resting) in [(206.0, [2, 0]), (250.0, [2, 0])] {
        let frame = frame(&mut seas, &settings, &Camera::from_degrees(35.68, -14.25, 3.0, heading, 82.0));
        pools.iter().for_each(|pool| pool.update(&frame, 64));
        let states = pools.each_ref().map(Pool::state);
        assert_eq!(states.map(|state| state.resting), resting);
        assert_eq!(states[0].vertices, states[1].vertices);
        assert!(states[0].updates < states[1].updates, "{states:?}");
        let [slept, awake] = pools.each_ref().map(|pool| triangles(&pool.mesh()));
        assert!(slept == awake, "{} triangles, {} of one that never sleeps", slept.len(), awake.len());
        println!("{} triangles after {} updates", slept.len(), states[0].updates);
        vertices.push(states[0].vertices);
    }
    assert!(vertices[0] != vertices[1] && vertices[0] > 1_000, "{vertices:?}");
}

/// A number in 0…1 of a place in a list.
fn unit(index: u32, salt: u32) -> f64 {
    let [bits, _] = ocean_globe::model::noise::bits(salt, 5, index as i32, 0);
    bits as f64 / u64::MAX as f64
}

#[test]
fn a_thousand_moves_leave_no_crack() {
    let pool = Pool::new(capacity_for(10_000));
    let (settings, mut seas) = (settings(30.0, 10_000), Seas::default());
    let mut largest = 0;
    for turn in 0..1_000 {
        // Jumps, and small steps from the last jump, down to a metre over the water and up to orbit.
        let jump = turn / 10;
        let step = f64::from(turn % 10) * 0.02;
        let camera = Camera::from_degrees(
            (unit(jump, 1) * 2.0 - 1.0).asin().to_degrees() + step,
            unit(jump, 2) * 360.0 + step,
            10f64.powf(unit(jump, 3) * 7.4) * (1.0 + step),
            unit(jump, 4) * 360.0 + 40.0 * step,
            unit(jump, 5) * 110.0,
        );
        pool.update(&frame(&mut seas, &settings, &camera), 1 + turn % 3);
        largest = largest.max(pool.mesh().len());
    }
    println!("at most {largest} triangles");
    assert!((5_000..=10_000).contains(&largest), "at most {largest} triangles");
}

#[test]
fn the_budget_is_used_and_kept_and_a_full_pool_stays_sound() {
    // A pool without room for a change of more than a few hundred triangles, and one with plenty.
    for (capacity, budget) in [(8192, 8_000), (capacity_for(20_000), 20_000)] {
        let pool = Pool::new(capacity);
        let frame =
            frame(&mut Seas::default(), &settings(2.0, budget), &Camera::from_degrees(35.68, -14.25, 3.0, 206.0, 80.0));
        for _ in 0..60 {
            pool.update(&frame, 4);
            assert!(pool.state().live <= budget);
        }
        let found = pool.mesh().len() as f64 / f64::from(budget);
        println!("{found:.3} of {budget} triangles in {capacity} slots, {:?}", pool.state());
        // Within 5 %; a full pool is allowed to be slow to fill, not to break.
        let least = if capacity == 8192 { 0.5 } else { 0.95 };
        assert!(found >= least, "{found} of the budget");
    }
}

#[test]
fn a_slow_pan_touches_few_triangles() {
    let pool = Pool::new(1 << 16);
    let settings = settings(12.0, 40_000);
    let mut seas = Seas::default();
    let mut view = |heading: f64| frame(&mut seas, &settings, &Camera::from_degrees(35.68, -14.25, 3.0, heading, 82.0));
    pool.update(&view(206.0), 64);
    let mut worst: f64 = 0.0;
    for turn in 1..=20 {
        // Six degrees a second at sixty frames a second.
        pool.update(&view(206.0 + 0.1 * f64::from(turn)), 1);
        let state = pool.state();
        worst = worst.max(f64::from(state.last_growth + state.last_merged) / f64::from(state.live));
    }
    println!("{:.2} % of the triangles change in a frame, at most", 100.0 * worst);
    // The pan uncovers 0.1 of 72 degrees at one side, hides as much at the other, and carries the margins along: a few times 0.3 %.
    assert!(worst > 0.0 && worst < 0.02, "{worst}");
}
