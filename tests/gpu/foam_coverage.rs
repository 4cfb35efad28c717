//! Whitecaps on the GPU cover as much of the sea as is measured there.

use ocean_globe::model::foam::Fold;
use ocean_globe::model::sea_state::whitecap_fraction;
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::waves;
use ocean_globe::scene::sea::foam::{LEVELS, TEXELS_M, Whitecaps};
use ocean_globe::scene::settings::{self, Settings};

use crate::foam_map::{NOON, Sea, blown, ticks};

/// Mean foam of each level under a wind, over places and instants.
fn coverage(settings: &Settings) -> [f64; LEVELS] {
    let sea = Sea::new(settings);
    let uniform = sea.frame.uniform;
    // The finest levels are smaller than a group of waves, in which whitecaps come: those are looked at in three and four places, laid out
    // by their fractions.
    let elsewhere = |levels: [usize; 4], first: usize| {
        let mut elsewhere = uniform;
        for (index, own) in elsewhere.foam_levels.iter_mut().enumerate() {
            *own = uniform.foam_levels[levels[index]];
            let turn = 2.4 * (first + index) as f64;
            let out = 350.0 + 300.0 * (first + index) as f64;
            own.fraction[0] -= (out * turn.cos() / TEXELS_M[levels[index]]) as f32;
            own.fraction[1] -= (out * turn.sin() / TEXELS_M[levels[index]]) as f32;
        }
        elsewhere
    };
    let levels = [[0; 4], [1, 1, 2, 3], [1, 2, 2, 2]];
    let mut maps = [0, 1, 2].map(|map| sea.map(&elsewhere(levels[map], 4 * map)));
    let (mut sums, mut counts) = ([0.0; LEVELS], [0.0; LEVELS]);
    // By the steps of a replay of the usual lifetime, which are as long as crests are still met often enough (`foam::ungrown`): two
    // lifetimes coarsely and one finely leave a twentieth of the beginning; then five instants two seconds apart. `foam_history.rs` holds
    // such steps to those of 1/8 s and of 1/60 s.
    const FINE_S: f64 = 0.25;
    let (fine, eye) = (ticks(FINE_S), &sea.frame.foam_eye);
    let lifetime = (settings.foam.lifetime_s / FINE_S).ceil() as usize;
    let mut now = waves::ticks_from_unix(NOON);
    let steps = vec![2 * fine; lifetime].into_iter().chain(vec![fine; lifetime + 32]);
    for (index, step) in steps.enumerate() {
        now += step;
        sea.run(now);
        for (map, levels) in maps.iter_mut().zip(levels) {
            sea.step_as(map, levels, now, eye);
            if (index + 1).checked_sub(2 * lifetime).is_some_and(|since| since.is_multiple_of(8)) {
                for (foam, level) in sea.means(map).into_iter().zip(levels) {
                    sums[level] += foam;
                    counts[level] += 1.0;
                }
            }
        }
    }
    std::array::from_fn(|level| sums[level] / counts[level])
}

fn check_coverage(speed: f64) {
    let settings = blown(speed);
    let start = std::time::Instant::now();
    let found = coverage(&settings);
    let want = whitecap_fraction(speed);
    let whitecaps = Whitecaps::new(settings.foam, &SeaTables::of(&settings));
    println!(
        "{speed} m/s: {want:.4}: {:.2?} of it, {:?}, {:.1} s",
        found.map(|f| f / want),
        whitecaps.folds,
        start.elapsed().as_secs_f64()
    );
    for (level, found) in found.into_iter().enumerate() {
        if whitecaps.folds[level] != Fold::NEVER {
            assert!(found > want / 1.5 && found < want * 1.5, "{speed} m/s level {level}: {found} of {want}");
        }
    }
}

#[test]
fn whitecaps_cover_what_is_measured_at_8_mps() {
    check_coverage(8.0);
}

#[test]
fn whitecaps_cover_what_is_measured_at_12_mps() {
    check_coverage(12.0);
}

#[test]
fn whitecaps_cover_what_is_measured_at_16_mps() {
    check_coverage(16.0);
}

#[test]
fn whitecaps_cover_what_is_measured_at_20_mps() {
    check_coverage(20.0);
}

#[test]
fn long_lived_foam_covers_no_more_since_fewer_crests_break() {
    let foam = settings::Foam { lifetime_s: 10.0, ..settings::Foam::default() };
    let found = coverage(&Settings { foam, ..blown(16.0) });
    let want = whitecap_fraction(16.0);
    println!("10 s: {:.2?} of {want:.4}", found.map(|f| f / want));
    assert!(found.into_iter().all(|found| found > want / 1.5 && found < want * 1.5), "{found:?} of {want}");
}
