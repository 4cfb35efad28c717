//! Trains of waves that are followed to a shore on a grid, against rays and Snell's law.

use std::f64::consts::TAU;

use ocean_globe::model::sea_bed::{Coast, Grid};
use ocean_globe::model::shore_waves::{Bed, Shallows, arrivals, regular};
use ocean_globe::model::{GRAVITY, dispersion};

use crate::beach;

/// A bed from depth and distance to the shore at (x, y), metres east and south of the north-western corner.
fn bed(side: usize, step: f64, at: impl Fn(f64, f64) -> (f64, f64)) -> Bed {
    let nodes = (0..side * side).map(|i| at((i % side) as f64 * step, (i / side) as f64 * step));
    let (depth_m, shore_m): (Vec<_>, Vec<_>) = nodes.unzip();
    // All of it is a plane beach's.
    let plain_m = depth_m.clone();
    Bed { side, step_m: vec![step; side], depth_m, plain_m, shore_m, face: vec![1e-9; side * side] }
}

/// The whole phase at a place, as who looks has it: R between nodes, and the regular part of the place.
fn phase(bed: &Bed, rest: &[f64], omega: f64, x: f64, y: f64, (h, d): (f64, f64)) -> f64 {
    let step = bed.step_m[0];
    let (i, j) = ((x / step) as usize, (y / step) as usize);
    let (f, g) = (x / step - i as f64, y / step - j as f64);
    let at = |i: usize, j: usize| rest[j * bed.side + i];
    let top = at(i, j) * (1.0 - f) + at(i + 1, j) * f;
    let bottom = at(i, j + 1) * (1.0 - f) + at(i + 1, j + 1) * f;
    top * (1.0 - g) + bottom * g + regular(omega, Shallows::new(h, d, 1e-9))
}

#[test]
fn crests_turn_to_a_beach_as_snell_says() {
    // A plane beach to the south whose shore lies between two rows, deep water in the north.
    let (side, slope) = (128, 0.02);
    let mut worst = [0.0f64; 3];
    for (step, period, degrees) in [(47.0, 10.0, 30.0), (67.0, 10.0, 30.0), (67.0, 7.0, 60.0), (67.0, 14.0, 15.0)] {
        let omega = TAU / period;
        let deep: f64 = f64::to_radians(degrees);
        let shore_y = step * (side as f64 - 6.4);
        let at = |_x: f64, y: f64| ((shore_y - y) * slope, shore_y - y);
        let bed = bed(side, step, at);
        let found = arrivals(&bed, omega, [deep.sin(), deep.cos()]);
        for h in [1.0, 2.0, 5.0, 10.0, 20.0] {
            let (x, y) = (0.6 * side as f64 * step, shore_y - h / slope);
            let whole = |x: f64, y: f64| phase(&bed, &found.rest, omega, x, y, at(x, y));
            // Over as many metres as a cell, to see the crest and not the interpolation.
            let reach = 0.5 * step.min(h / slope);
            let [kx, ky] = [whole(x + reach, y) - whole(x - reach, y), whole(x, y + reach) - whole(x, y - reach)]
                .map(|s| s / (2.0 * reach));
            let wanted = beach::refracted(omega, h, deep);
            let error = (kx.atan2(ky) - wanted).to_degrees().abs();
            // Along the normal the mean of k over that way, as the integral has it.
            let between = |h0: f64, h1: f64| beach::beach_phase(omega, h0, h1, slope) / ((h0 - h1) / slope);
            let k = between(h + reach * slope, (h - reach * slope).max(1e-3));
            let k_error = (kx.hypot(ky) / k.hypot(0.0) - 1.0).abs();
            println!(
                "{step} m, {period} s, {degrees}°, {h} m: {:.2}° for {:.2}°, k {:.4} for {k:.4}",
                kx.atan2(ky).to_degrees(),
                wanted.to_degrees(),
                kx.hypot(ky)
            );
            worst = [worst[0].max(error), worst[1].max(k_error), worst[2]];
            let (i, j) = ((x / step) as usize, (y / step).round() as usize);
            let way = found.way[j * side + i];
            let here = bed.depth_m[j * side + i];
            let kr = beach::refraction(deep, beach::refracted(omega, here, deep));
            worst[2] = worst[2].max((way[0].hypot(way[1]) / kr - 1.0).abs());
        }
    }
    println!("{worst:?}");
    // The upwind difference is of first order: a cell of 67 m is a sixth of the way over which these waves turn.
    assert!(worst[0] < 1.0, "{} degrees", worst[0]);
    assert!(worst[1] < 0.04, "k {}", worst[1]);
    assert!(worst[2] < 0.03, "Kr {}", worst[2]);
}

#[test]
fn waves_come_into_a_window_as_they_have_turned_before_it() {
    // A bed of 1 in 100, so that a window of 5 km begins in water half as deep as these waves feel.
    let (side, step, slope, omega) = (80, 67.0, 0.01, TAU / 15.0);
    let deep = 30f64.to_radians();
    let shore_y = step * (side as f64 - 6.4);
    let bed = bed(side, step, |_x, y| ((shore_y - y) * slope, shore_y - y));
    let found = arrivals(&bed, omega, [deep.sin(), deep.cos()]);
    for j in [0, 20, 50, 65] {
        let at = j * side + side * 3 / 5;
        let [east, south] = found.way[at];
        let wanted = beach::refracted(omega, bed.depth_m[at], deep);
        let (angle, size) = (east.atan2(south), east.hypot(south) / beach::refraction(deep, wanted));
        println!(
            "{:.1} m: {:.2}° for {:.2}°, {size:.3} of Kr",
            bed.depth_m[at],
            angle.to_degrees(),
            wanted.to_degrees()
        );
        // The grid's, as above.
        assert!((angle - wanted).to_degrees().abs() < 1.0 && (size - 1.0).abs() < 0.03, "{angle} {wanted} {size}");
    }
}

#[test]
fn waves_go_on_in_deep_water() {
    let bed = bed(64, 67.0, |_, _| (3000.0, 1e5));
    let omega = TAU / 8.0;
    let (sin, cos) = 0.7f64.sin_cos();
    let found = arrivals(&bed, omega, [sin, cos]);
    let k = omega * omega / GRAVITY;
    let at = |i: f64, j: f64| found.rest[(j * 64.0 + i) as usize] - k * 67.0 * (i * sin + j * cos);
    // A plane wave is what the difference has without error.
    assert!((at(60.0, 61.0) - at(3.0, 7.0)).abs() < 1e-6);
    assert!(found.way.iter().all(|way| (way[0].hypot(way[1]) - 1.0).abs() < 1e-6));
}

#[test]
fn waves_come_round_an_island() {
    // Round, 600 m in radius, on a bed that falls one in thirty; waves to the south.
    let (side, step) = (128, 67.0);
    let centre = 0.5 * side as f64 * step;
    let at = |x: f64, y: f64| {
        let d = (x - centre).hypot(y - centre) - 600.0;
        ((d / 30.0).clamp(-1.0, 60.0), d)
    };
    let bed = bed(side, step, at);
    let found = arrivals(&bed, TAU / 10.0, [0.0, 1.0]);
    let node = |x: f64, y: f64| (y / step).round() as usize * side + (x / step).round() as usize;
    let way = |x: f64, y: f64| found.way[node(centre + x, centre + y)];
    let height = |x: f64, y: f64| way(x, y)[0].hypot(way(x, y)[1]);
    let lee = height(0.0, 1200.0);
    println!(
        "before {:.2}, beside {:.2}, in the lee {lee:.3}, far behind {:.2}",
        height(0.0, -1200.0),
        height(1200.0, 0.0),
        height(0.0, 3500.0)
    );
    assert!(height(0.0, -1200.0) > 0.8 && height(-2500.0, 1000.0) > 0.8);
    assert!(lee < 0.6, "a lee of {lee}");
    assert!(height(300.0, 1100.0) > 0.02, "but not none");
    // On its back waves run to the shore from both sides.
    let right = way(350.0, 900.0);
    assert!(right[0] < 0.0 && way(-350.0, 900.0)[0] > 0.0, "{right:?}");
    // East and west are alike.
    for (x, y) in [(900.0, 0.0), (700.0, 900.0), (400.0, 1500.0)] {
        let [east, west] = [way(x, y), way(-x, y)];
        assert!((east[0] + west[0]).abs() < 0.05 && (east[1] - west[1]).abs() < 0.05, "{east:?} {west:?}");
    }
}

/// Against rays, which no grid holds: d(k t)/ds = grad k along the unit vector t of a ray.
#[test]
fn waves_turn_to_a_round_island_as_rays_do() {
    // 600 m in radius, on a bed that falls one in thirty to 60 m; waves to the south.
    let (side, step, omega, slope) = (128, 67.0, TAU / 10.0, 1.0 / 30.0);
    let centre = 0.5 * side as f64 * step;
    let from_shore = |[x, y]: [f64; 2]| (x - centre).hypot(y - centre) - 600.0;
    let depth = |d: f64| (d * slope).clamp(-1.0, 60.0);
    let bed = bed(side, step, |x, y| (depth(from_shore([x, y])), from_shore([x, y])));
    let found = arrivals(&bed, omega, [0.0, 1.0]);
    let k = |at: [f64; 2]| dispersion::wavenumber(omega, depth(from_shore(at)));
    // Down the gradient of depth, by differences of a metre.
    let gradient =
        |[x, y]: [f64; 2]| [0.5 * (k([x + 1.0, y]) - k([x - 1.0, y])), 0.5 * (k([x, y + 1.0]) - k([x, y - 1.0]))];
    let (mut off, mut most_turned) = (Vec::new(), 0.0f64);
    for ray in -36..=36 {
        let mut at = [centre + 45.0 * f64::from(ray), 0.0];
        let mut wave = [0.0, k(at)];
        // To the height of the middle, before rays cross; until the swell feels the last two metres.
        while at[1] < centre && from_shore(at) * slope > 2.0 {
            let middle: [f64; 2] = std::array::from_fn(|axis| at[axis] + wave[axis] / wave[0].hypot(wave[1]));
            let rise = gradient(middle);
            wave = std::array::from_fn(|axis| wave[axis] + 2.0 * rise[axis]);
            let length = wave[0].hypot(wave[1]);
            at = std::array::from_fn(|axis| middle[axis] + wave[axis] / length);
            let node = at.map(|part| (part / step).round());
            if (at[0] - node[0] * step).hypot(at[1] - node[1] * step) < 2.0 && depth(from_shore(at)) < 30.0 {
                let way = found.way[node[1] as usize * side + node[0] as usize];
                let angle = wave[0].atan2(wave[1]);
                off.push((way[0].atan2(way[1]) - angle).to_degrees());
                most_turned = most_turned.max(angle.to_degrees().abs());
            }
        }
    }
    let mean = off.iter().map(|off| off.abs()).sum::<f64>() / off.len() as f64;
    let most = off.iter().fold(0.0, |most: f64, off| most.max(off.abs()));
    println!("{} places, turned by up to {most_turned:.1}°: {mean:.2}° off, {most:.2}° at most", off.len());
    assert!(off.len() > 60 && most_turned > 25.0, "{} {most_turned}", off.len());
    // The upwind difference is of first order, as on a straight beach, where that costs half a degree.
    assert!(mean < 0.5 && most < 2.0, "{mean} {most}: {off:.2?}");
}

#[test]
fn shoaling_of_the_design() {
    let h = 5.0;
    let omega = TAU / 10.0;
    let deep = 30f64.to_radians();
    let here = beach::refracted(omega, h, deep);
    assert!((here.to_degrees() - 12.5198).abs() < 1e-3);
    assert!((dispersion::shoaling(dispersion::wavenumber(omega, h), h) - 1.110733).abs() < 1e-6);
    assert!((beach::refraction(deep, here) - 0.941871).abs() < 1e-6);
    let ks = |h: f64| dispersion::shoaling(dispersion::wavenumber(TAU / 20.0, h), h);
    assert!((ks(1.0) / ks(2.0) - 1.1862).abs() < 1e-4);
}

#[test]
fn crests_come_to_deans_beach_at_their_own_pace() {
    // Straight on to a coast 50 m deep a cell off; phases between places near the shore, against the integral of k over that way.
    let coast = Coast::new(Grid::level(-50.0), 9_277.0, 0.0);
    let (side, step) = (128, 40.0);
    let shore_y = step * (f64::from(side) - 6.4);
    let water = |y: f64| Shallows::new(coast.profile_m((shore_y - y).max(0.0)), shore_y - y, coast.m);
    let wet =
        |_x: f64, y: f64| if y < shore_y { (water(y).h, shore_y - y) } else { (-0.07 * (y - shore_y), shore_y - y) };
    let bed = Bed { face: vec![coast.m; (side * side) as usize], ..bed(side as usize, step, wet) };
    for period in [5.0, 8.0, 12.0] {
        let omega = TAU / period;
        let found = arrivals(&bed, omega, [0.0, 1.0]);
        let rest = |y: f64| {
            let (row, x) = ((y / step) as usize, side as usize / 2);
            let at = |row: usize| found.rest[row * side as usize + x];
            at(row) + (at(row + 1) - at(row)) * (y / step - row as f64)
        };
        let mut worst = 0.0f64;
        for d in [6.0, 12.0, 25.0, 50.0, 100.0, 200.0, 400.0] {
            let (far, near) = (shore_y - 2.0 * d, shore_y - d);
            let drawn = rest(near) + regular(omega, water(near)) - rest(far) - regular(omega, water(far));
            let steps = 4_000;
            let k = |i: i32| {
                let y = far + (near - far) * (f64::from(i) + 0.5) / f64::from(steps);
                dispersion::wavenumber(omega, water(y).h)
            };
            let wanted = (0..steps).map(k).sum::<f64>() * d / f64::from(steps);
            println!("{period} s, {d} m: {drawn:.3} for {wanted:.3} rad");
            worst = worst.max((drawn / wanted - 1.0).abs());
        }
        // Nodes 40 m apart hold what is smooth: a plane beach's phase alone is a quarter off here.
        assert!(worst < 0.04, "{period} s: {worst}");
    }
}
