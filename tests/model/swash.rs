//! Run-up and swash against rows worked out by hand, and against the motion that they come from.

use std::f64::consts::TAU;

use ocean_globe::model::swash::{Arriving, CRESTS, RunUp, Sheet, crests, foreshore};
use ocean_globe::model::{GRAVITY, swash};

#[test]
fn run_up_is_stockdons() {
    // 1.1 (0.35 · 0.1 · 27.4885 + 27.4885/2 · √(0.563 · 0.01 + 0.004)), with √(H₀L₀) = √(4 · 188.855) = 27.4850: 2.5420 m by the design's row.
    let steep = RunUp::new(4.0, TAU / 11.0, 0.1).fiftieth();
    assert!((steep - 2.5420).abs() < 5e-4, "{steep}");
    // A flat beach, Iribarren's number 0.08: 0.043 √(2 · 9.80665 · 64/2π) = 0.043 · 14.1348.
    let flat = RunUp::new(2.0, TAU / 8.0, 0.01).fiftieth();
    assert!((flat - 0.6078).abs() < 5e-4, "{flat}");
    // No step between the two: 5 % more slope is less than 12 % more run-up anywhere, where the formulas themselves are 39 % apart.
    let mut beta = 0.02;
    while beta < 0.12 {
        let [low, high] = [beta, 1.05 * beta].map(|beta| RunUp::new(1.5, TAU / 6.0, beta).fiftieth());
        assert!(high > 0.999 * low && high < 1.12 * low, "{beta}: {low}, {high}");
        beta *= 1.05;
    }
    assert_eq!(RunUp::new(0.0, 1.0, 0.08).fiftieth(), 0.0);
    assert!(foreshore(0.078) == 0.078 && foreshore(0.3) == swash::STEEPEST);
}

/// A sheet of 0.5 m on a slope of 0.1: u₀ = √9.80665 = 3.13156 m/s, gβ = 0.980665 m/s².
const SHEET: fn() -> Sheet = || Sheet::new(0.5, 0.1);

#[test]
fn a_sheet_flies_as_a_ball_does() {
    let sheet = SHEET();
    assert!((sheet.reach() - 5.0).abs() < 1e-12, "R/β: {}", sheet.reach());
    assert!((sheet.flight() - 6.386_60).abs() < 1e-5, "{}", sheet.flight());
    assert!((sheet.front(3.193_299) - 5.0).abs() < 1e-9 && sheet.front(sheet.flight()).abs() < 1e-12);
    // After a second: 3.13156 - 0.49033.
    assert!((sheet.front(1.0) - 2.641_23).abs() < 1e-5, "{}", sheet.front(1.0));
    // 1 m behind the front, after a second: (1/3)²/g.
    assert!((sheet.film(1.641_23, 1.0) - 0.011_33).abs() < 1e-5);
    assert_eq!(sheet.film(2.7, 1.0), 0.0);
    // The place where the front is has been left by the water just now, on the way back.
    let back = sheet.front(5.0);
    assert!(sheet.left_for(back, 5.0).unwrap().abs() < 1e-9);
    assert!((sheet.left_for(back, 9.0).unwrap() - 4.0).abs() < 1e-9);
    assert_eq!(sheet.left_for(5.1, 3.0), None);
}

#[test]
fn a_sheet_loses_no_water() {
    // ∂h/∂t = -∂(hu)/∂x with u = (2x/t + u₀ - gβt + ...)/3, Shen and Meyer's: here through the whole volume, which changes by what passes the line.
    let sheet = SHEET();
    let volume = |t: f64| {
        let n = 4_000;
        let step = sheet.front(t) / f64::from(n);
        (0..n).map(|i| sheet.film((f64::from(i) + 0.5) * step, t) * step).sum::<f64>()
    };
    // In closed form: ∫(front - x)²/(9 g t²) dx = front³/(27 g t²).
    for t in [0.5, 2.0, 4.0] {
        let wanted = sheet.front(t).powi(3) / (27.0 * GRAVITY * t * t);
        assert!((volume(t) / wanted - 1.0).abs() < 1e-6, "{t}: {} for {wanted}", volume(t));
    }
}

#[test]
fn crests_come_when_the_sum_does_and_stay_the_same() {
    let trains: Vec<Arriving> = [0.82, 0.9, 0.97, 1.03, 1.08, 1.16, 1.22, 1.35]
        .iter()
        .zip([0.3, 2.0, 5.1, 1.2, 4.0, 0.2, 3.3, 5.9])
        .map(|(&omega, phase)| Arriving { omega, amplitude: 0.1, phase })
        .collect();
    let mean = trains.iter().map(|train| train.omega).sum::<f64>() / 8.0;
    let at = |seconds: f64| -> Vec<Arriving> {
        trains.iter().map(|train| Arriving { phase: train.phase + train.omega * seconds, ..*train }).collect()
    };
    // One train alone: its crests are a period apart and as high as twice its amplitude.
    let [first, second, ..] = crests(&[Arriving { omega: 1.0, amplitude: 0.4, phase: 0.7 }], 1.0);
    assert!(
        (first.age - 0.7).abs() < 1e-9 && (second.age - 0.7 - TAU).abs() < 1e-9 && (first.height - 0.8).abs() < 1e-9
    );
    let mut compared = 0;
    for second in 0..200 {
        let now = f64::from(second);
        for crest in crests(&at(now), mean) {
            // High ones; between two groups there is no telling.
            if crest.height < 0.35 {
                continue;
            }
            let there = at(now - crest.age);
            let [cosines, sines] = [0.0, 0.25 * TAU]
                .map(|turn| there.iter().map(|train| train.amplitude * libm::cos(train.phase - turn)).sum::<f64>());
            // Between two looks the frequency changes by its spread times a quarter of a period, which bends the phase by up to 0.1.
            assert!(libm::atan2(sines, cosines).abs() < 0.12, "{now}: {crest:?} is none, {cosines} {sines}");
            // A second later it is a second older, unless newer ones have pushed it out.
            let later = crests(&at(now + 1.0), mean);
            let same = later.iter().map(|later| (later.age - crest.age - 1.0).abs()).fold(f64::INFINITY, f64::min);
            assert!(
                same < 0.15 || crest.age + 1.0 > (CRESTS as f64 - 1.0) * 5.0,
                "{now}: {crest:?} has gone, {later:?}"
            );
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}
