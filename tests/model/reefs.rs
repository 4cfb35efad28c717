//! Coral reefs on their own.

use ocean_globe::model::reefs::{self, Reef};
use ocean_globe::model::sea_bed::smoothstep;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::settings::Settings;

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
fn crests_wind_within_some_hundred_metres() {
    // Along a coast, each 76 m: what is left of a crest's distance where the middle of its neighbours is taken off.
    let at = |k: u32| [700_000_000, 2_200_000_000 + 8_192 * k];
    let crests: Vec<f64> = (0..2_000).map(|k| Reef::new(1.0, at(k), 1.0, 0.0).crest_m).collect();
    let bends = crests.windows(3).map(|c| (c[1] - 0.5 * (c[0] + c[2])).powi(2)).sum::<f64>() / 1_998.0;
    println!("a crest is {:.1} m off the line between its neighbours", bends.sqrt());
    // The noise of 306 m curves by some 0.35 ln 2 of 750 m within a quarter of a cell; those of kilometres by less than 3 m.
    assert!((8.0..40.0).contains(&bends.sqrt()), "{}", bends.sqrt());
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
fn no_bed_breaks_off_at_a_crest() {
    // Over crests, in passes and on their sides, where without a reef the bed is that of a flat or a steep shore.
    let (mut widest, mut passes) = (0.0f64, 0);
    for (share, pass_m) in [(1.0, 0.0), (1.0, 90.0), (1.0, 1e4), (0.5, 0.0)] {
        for crest_m in [120.0, 450.0, 900.0, 2_000.0] {
            let reef = Reef { share, crest_m, shallow_m: 0.7, pass_m, wide_m: 1e4 };
            for shelf in [0.005, 0.01, 0.1] {
                let depth = |d: f64| {
                    let trusted = smoothstep(0.1 * RESOLUTION_M, RESOLUTION_M, d);
                    reef.depth_m(d, shelf * d, trusted, FAR_M)
                };
                let by_crest = (-60..60).map(|i| depth(crest_m + f64::from(i)));
                passes += usize::from(depth(crest_m - 1.0) > 10.0);
                let steps = by_crest.clone().zip(by_crest.skip(1)).map(|(a, b)| (b - a).abs());
                widest = widest.max(steps.fold(0.0, f64::max));
            }
        }
    }
    println!("steps of {widest:.2} m at most, {passes} lines in passes");
    assert!(widest < 2.0 && passes > 5, "a step of {widest} m");
}

#[test]
fn waves_run_up_a_lagoons_beach_as_low_as_they_come_to_it() {
    let mut seen = 0;
    for row in 0..200u32 {
        let at = [700_000_000, 2_300_000_000 + 53_590 * row];
        let left = |d: f64| Reef::depth_on(1.0, at, 1.0, [d, d], 0.1 * d, RESOLUTION_M, FAR_M).1;
        seen += usize::from(left(1.0) < 0.3);
        for ashore_m in [0.0, 5.0, 100.0] {
            assert!((left(-ashore_m) - left(0.01)).abs() < 0.01, "{} by {}", left(-ashore_m), left(0.01));
        }
        assert_eq!(left(-reefs::ASHORE_M - 1.0), 1.0);
    }
    assert!(seen > 100, "{seen} lagoons");
}

#[test]
fn a_ride_goes_as_high_as_a_reef_leaves_the_waves() {
    let (mut seas, settings) = (Seas::default(), Settings { beaufort: Some(5), ..Settings::default() });
    let (lat, lon) = (-0.305, -2.615);
    let mut rides = |left: f64| -> Vec<f64> {
        seas.tell_reef(lat, lon, left);
        (0..20).map(|i| seas.height_at(&settings, lat, lon, 1_782_039_600.0 + f64::from(i))).collect()
    };
    let (open, behind) = (rides(1.0), rides(0.12));
    let rms = |heights: &[f64]| heights.iter().map(|height| height * height).sum::<f64>().sqrt();
    let ratio = rms(&behind) / rms(&open);
    println!("{ratio:.3} of the open sea's height");
    // The ripples are their own.
    assert!((0.10..0.2).contains(&ratio), "{ratio}");
    // What is told of one place says nothing of another.
    assert_eq!((seas.left_by_reefs(lat, lon), seas.left_by_reefs(lat, 1.0)), (0.12, 1.0));
}

#[test]
fn no_reef_raises_the_bed_farther_out_than_it_reaches() {
    for wide_m in [-1e4, 0.0, 3_000.0] {
        for pass_m in [0.0, 1e4] {
            let reef = Reef { share: 1.0, crest_m: reefs::FARTHEST_M, shallow_m: 0.7, pass_m, wide_m };
            for plain_m in [10.0, 200.0, 1_500.0] {
                let depth_m = reef.depth_m(reefs::REACH_M, plain_m, 0.3, FAR_M);
                assert!(depth_m >= plain_m, "{depth_m} instead of {plain_m} m");
            }
        }
    }
    const { assert!(reefs::ENCLOSED_TO_M[1] < reefs::REACH_M, "no lagoon between two shores is wider") };
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
