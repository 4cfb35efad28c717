//! The bisected mesh: sound after every update, refined as asked, the same from wherever it came.

use std::collections::{HashMap, HashSet};

use ocean_globe::model::cuboid::{self, Point, Triangle};
use ocean_globe::scene::bisection::Bisection;
use ocean_globe::scene::camera::Camera;

mod pool;
use pool::{Pool, check, edges, frame, middle, settings, triangles};

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
/// triangles, and how often each of the seven patterns came.
fn expected(mesh: &HashSet<Triangle>, asks: impl Fn([Point; 2]) -> bool) -> (HashSet<Triangle>, [usize; 8]) {
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
    let mut patterns = [0; 8];
    let mut diamonds: HashMap<Point, Vec<Triangle>> = HashMap::new();
    let mut after = HashSet::new();
    for &t in mesh {
        let [base, left, right] = edges(t).map(|edge| split.contains(&key(edge)));
        patterns[usize::from(base) + 2 * usize::from(left) + 4 * usize::from(right)] += 1;
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
    let mut met = [0; 8];
    let mut merged = 0;
    for round in 0..60 {
        // The mesh grows to some ten thousand triangles and shrinks again.
        let share = if mesh.len() > 5_000 { 3 } else { [64, 40, 28, 12, 50][round as usize % 5] };
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
        met.iter_mut().zip(patterns).for_each(|(all, here)| *all += here);
        mesh = after;
    }
    println!("patterns by their edges (base 1, left 2, right 4): {met:?}; {} triangles at the end", mesh.len());
    assert!(met[1] > 50 && met[3] > 50 && met[5] > 50 && met[7] > 50, "patterns {met:?}");
    assert_eq!(met[2] + met[4] + met[6], 0, "a leg without its base");
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
    let pool = Pool::new(1 << 16);
    let settings = settings(10.0, 40_000);
    let view = |lat, lon, altitude, heading, tilt| Camera::from_degrees(lat, lon, altitude, heading, tilt);
    for camera in [
        view(20.0, -30.0, 2e7, 0.0, 0.0),
        view(35.68, -14.25, 2.0, 206.0, 84.0),
        view(0.0, 0.0, 560.0, 90.0, 70.0),
        view(90.0, 0.0, 30_000.0, 0.0, 60.0),
        view(-35.0, 179.999, 30.0, 45.0, 85.0),
    ] {
        let frame = frame(&settings, &camera);
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
