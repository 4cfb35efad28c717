//! The model of whitecaps: any cut of time gives the same foam, and thresholds give the foam that is wanted.

use std::f64::consts::TAU;

use ocean_globe::model::foam::{self, Fold, GROWTH_S, LIFETIME_S};
use ocean_globe::model::sea_state::whitecap_fraction;
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::waves;
use ocean_globe::scene::sea::foam::{LEVELS, Whitecaps};
use ocean_globe::scene::settings::{self, FoamRule};

#[test]
fn foam_does_not_depend_on_the_frame_rate() {
    // A crest that breaks wholly for half a second, then decay for 4 s, at 60, 30, 15 and 3.75 frames a second.
    let run = |step: &dyn Fn(f64, f64, f64) -> f64, fps: f64| {
        let mut foam = 0.1;
        for frame in 0..(4.5 * fps).round() as usize {
            let breaking = if (frame as f64) < 0.5 * fps - 1e-9 { 1.0 } else { 0.0 };
            foam = step(foam, breaking, 1.0 / fps);
        }
        foam
    };
    let exact = |foam: f64, breaking: f64, dt: f64| foam::evolve(foam, breaking, dt, LIFETIME_S);
    let euler = |foam: f64, breaking: f64, dt: f64| {
        foam + (breaking - foam) * dt / if breaking > foam { GROWTH_S } else { LIFETIME_S }
    };
    // Closed form, and what rates may differ by: rounding.
    let want = (1.0 - 0.9 * (-0.5 / GROWTH_S).exp()) * (-4.0 / LIFETIME_S).exp();
    let spread = |step: &dyn Fn(f64, f64, f64) -> f64| {
        [60.0, 30.0, 16.0, 4.0].map(|fps| (run(step, fps) - want).abs()).into_iter().fold(0.0, f64::max)
    };
    assert!(spread(&exact) < 1e-12);
    assert!(spread(&euler) > 0.01, "the check lets explicit Euler pass");
    // Any cut of a step, and no lifetime at all.
    for (foam, breaking, dt, lifetime) in [(0.9, 0.2, 3.0, 0.5), (0.1, 0.8, 0.7, 60.0), (0.4, 0.4, 1.0, 3.5)] {
        let whole = foam::evolve(foam, breaking, dt, lifetime);
        let halves = foam::evolve(foam::evolve(foam, breaking, 0.3 * dt, lifetime), breaking, 0.7 * dt, lifetime);
        assert!((whole - halves).abs() < 1e-15);
    }
    assert_eq!(foam::relaxed(0.7, 0.2, 0.0, 0.0), 0.2);
    assert_eq!(foam::relaxed(0.7, 0.2, 0.0, 3.5), 0.7);
}

#[test]
fn thresholds_rise_with_the_foam_that_is_wanted() {
    let sea = waves::Sea::from_wind(12.0, 0, 1.0);
    let (spectrum, patches) = (sea.spectrum(), waves::cascades(256));
    let texels_m = [0.25, 2.25];
    let folds_of = |wanted, lifetime_s| {
        foam::Simulation::new(&spectrum, f64::INFINITY, &patches, texels_m).folds(1.0, [0.2, 1.0], wanted, lifetime_s)
    };
    let folds = |wanted| folds_of(wanted, LIFETIME_S);
    let by_share = [0.001, 0.01, 0.03, 0.1].map(folds);
    for pair in by_share.windows(2) {
        assert!((0..2).all(|level| pair[0][level].threshold < pair[1][level].threshold), "{pair:?}");
    }
    assert_eq!(folds(0.0), [Fold::NEVER; 2]);
    // Foam that lives longer needs fewer crests that break.
    let long = folds_of(0.03, 10.0);
    assert!((0..2).all(|level| long[level].threshold < by_share[2][level].threshold));
}

#[test]
fn foam_on_high_water_covers_the_share_that_is_wanted() {
    for speed in [8.0, 14.0, 20.0] {
        let foam = settings::Foam { rule: FoamRule::Height, ..settings::Foam::default() };
        let sea = SeaTables::new(waves::Sea::from_wind(speed, 0, 1.0), 128);
        let whitecaps = Whitecaps::new(foam, &sea);
        let deviation = sea.sea.hs_m / 4.0;
        let [from, to] = whitecaps.heights_m;
        // The ramp's mean over a Gaussian height: midpoints of 1/1000 deviation err by 1e-7.
        let share: f64 = (-8000..8000)
            .map(|i| (f64::from(i) + 0.5) / 1000.0)
            .map(|x| {
                ((x * deviation - from) / (to - from)).clamp(0.0, 1.0) * (-0.5 * x * x).exp() / TAU.sqrt() / 1000.0
            })
            .sum();
        println!("{speed} m/s: {share:.5} of {:.5}", whitecap_fraction(speed));
        assert!((share / whitecap_fraction(speed) - 1.0).abs() < 1e-3, "{speed} m/s: {share}");
        assert_eq!(whitecaps.folds, [Fold::NEVER; LEVELS]);
        // Beyond the map: a log-normal share of the height, whose mean does not depend on its contrast.
        for contrast in [0.0f64, 0.4, 0.8] {
            let mean: f64 = (-8000..8000)
                .map(|i| (f64::from(i) + 0.5) / 1000.0)
                .map(|x| {
                    let share = whitecaps.share * (contrast * x - 0.5 * contrast * contrast).exp();
                    share.min(1.0) * (-0.5 * x * x).exp() / TAU.sqrt() / 1000.0
                })
                .sum();
            // What the cap at 1 takes from the tail.
            assert!((mean / whitecaps.share - 1.0).abs() < 0.02, "{speed} m/s {contrast}: {mean}");
        }
    }
}
