//! Coral reefs on their own.

use ocean_globe::model::reefs::{self, Reef};

const RESOLUTION_M: f64 = 9_277.0;
const FAR_M: f64 = 1_500.0;

/// A place's corner of the map, and what is each 20 m off a straight shore that runs along the map's columns, as far as 3 km: depth and what is left of waves.
fn across(row: u32) -> Vec<[f64; 2]> {
    let at = |i: u32| [700_000_000 + 2_144 * i, 2_300_000_000 + 53_590 * row];
    (0..150)
        .map(|i| {
            let d = 20.0 * f64::from(i);
            // As on a rocky shore without a reef.
            let plain_m = 0.35 * d.powf(2.0 / 3.0);
            let (depth_m, left) = Reef::depth_on(1.0, at(i), 1.0, [d, d], plain_m, RESOLUTION_M, FAR_M);
            [depth_m, left]
        })
        .collect()
}

#[test]
fn crests_lie_awash_before_lagoons_and_fall_to_the_deep_sea() {
    // A coast of 100 km, each 500 m.
    let lines: Vec<_> = (0..200).map(across).collect();
    let crests: Vec<_> = lines
        .iter()
        .map(|line| line.iter().rposition(|[depth_m, _]| *depth_m < 2.0).map_or(0.0, |i| 20.0 * i as f64))
        .collect();
    // Nearer to the shore it is the shore's own; and in passes waves come in over deep water, what is shallow there is the lagoon's shore.
    let has_crest: Vec<_> = crests
        .iter()
        .zip(&lines)
        .filter(|(crest, line)| **crest > 150.0 && line[(**crest / 20.0) as usize][1] > 0.9)
        .collect();
    let share = has_crest.len() as f64 / lines.len() as f64;
    let mean_m = has_crest.iter().map(|(crest, _)| **crest).sum::<f64>() / has_crest.len() as f64;
    let farthest_m = crests.iter().fold(0.0f64, |a, &b| a.max(b));
    println!("{share:.2} of the coast has a crest, {mean_m:.0} m off in the mean, {farthest_m:.0} m at most");
    assert!((0.75..0.99).contains(&share) && (400.0..1_200.0).contains(&mean_m) && farthest_m < 2_500.0);
    for (crest, line) in has_crest {
        let at = |d: f64| line[((d / 20.0) as usize).min(149)];
        let lagoon_m = line[..(crest / 20.0) as usize].iter().map(|[depth_m, _]| *depth_m).fold(0.0, f64::max);
        assert!(lagoon_m < 23.0, "a lagoon of {lagoon_m} m");
        // 30 m deep at most 400 m out of it, also where it goes farther out beside the line; and no wave is much higher nearer to the shore.
        assert!(at(crest + 400.0)[0] > 30.0, "{:?} at {crest} m", at(crest + 400.0));
        assert!(line[1..].windows(2).all(|pair| pair[1][1] >= pair[0][1] - 0.6), "waves grow towards the shore");
        assert_eq!(at(crest + 400.0)[1], 1.0);
    }
    let behind = lines.iter().zip(&crests).filter(|(_, crest)| **crest > 300.0).map(|(line, _)| line[5][1]);
    let calm = behind.clone().sum::<f64>() / behind.count() as f64;
    println!("{calm:.2} of the waves' height is left in lagoons");
    assert!((0.1..0.4).contains(&calm), "{calm}");
}

#[test]
fn without_a_reef_the_bed_is_the_shores_own() {
    for d in [-5.0, 0.0, 3.0, 50.0, 700.0, 2_000.0, 20_000.0] {
        assert_eq!(Reef::depth_on(0.0, [7, 9], 1.0, [d, d], 12.0, RESOLUTION_M, FAR_M), (12.0, 1.0));
    }
    // At the waterline, and where data are trusted, with one too.
    for d in [0.0, 4.9, RESOLUTION_M, 20_000.0] {
        assert_eq!(Reef::depth_on(1.0, [7, 9], 1.0, [d, d], 12.0, RESOLUTION_M, 12.0).0, 12.0, "{d}");
    }
    // Less and less of one is none by and by.
    let deep = |share: f64, d: f64| Reef::depth_on(share, [700_000_000; 2], 1.0, [d, d], 40.0, RESOLUTION_M, FAR_M).0;
    for d in [30.0, 200.0, 600.0, 900.0] {
        let steps: Vec<_> = (0..=1_000).map(|i| deep(f64::from(i) / 1_000.0, d)).collect();
        let widest = steps.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
        assert!(widest < 2.0, "a step of {widest} m, {d} m off the shore");
    }
}

#[test]
fn they_stand_in_warm_clear_seas_out_of_deep_water() {
    let share = |lat_deg: f64, lon_deg: f64, mean_m: f64| {
        let lat = lat_deg.to_radians();
        let y = 0.5 - lat.tan().asinh() / std::f64::consts::TAU;
        reefs::share([lon_deg / 360.0 + 0.5, y], lat.sin(), mean_m, 78_000.0 * lat.cos())
    };
    for (name, lat, lon) in [
        ("Tahiti", -17.7, -149.4),
        ("Rarotonga", -21.2, -159.8),
        ("Mauritius", -20.2, 57.5),
        ("Oahu", 21.4, -158.0),
        ("Mayotte", -12.8, 45.1),
    ] {
        assert_eq!(share(lat, lon, -900.0), 1.0, "{name}");
        // As it would be on a shelf.
        assert_eq!(share(lat, lon, -60.0), 0.0, "{name}");
    }
    for (name, lat, lon) in [
        ("Madeira", 32.7, -17.0),
        ("Pico", 38.5, -28.4),
        ("Galapagos", -0.5, -90.5),
        ("Santiago", 15.1, -23.6),
        ("Gran Canaria", 28.0, -15.6),
        ("Nuku Hiva", -8.9, -140.1),
        ("Ascension", -7.9, -14.4),
    ] {
        assert_eq!(share(lat, lon, -900.0), 0.0, "{name}");
    }
}
