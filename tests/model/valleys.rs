//! Valleys of volcanoes on their own.

use glam::DVec3;
use ocean_globe::model::earth;
use ocean_globe::model::noise;
use ocean_globe::model::relief::{self, relief};

/// Strength of the relief of a high island, metres, and how steeply it rises.
const STRENGTH_M: f64 = 250.0;
const RISES: f64 = 0.15;

/// What is made of a place `[east, north]` metres from one near Tahiti, and its slope that way.
fn carved([east, north]: [f64; 2]) -> (f64, [f64; 2]) {
    let (lat, lon) = (-17.6f64.to_radians() + north / 6.37e6, -149.4f64.to_radians() + east / 6.07e6);
    let (up, axes) = (earth::normal(lat, lon), earth::ecef_from_enu(lat, lon));
    let slope = axes * DVec3::new(RISES, 0.0, 0.0);
    // As the mesh of some metres has them.
    let found = relief(relief::place(up), up, slope, [STRENGTH_M, 1.0], 30.0);
    (found.height_m, [0, 1].map(|axis| found.slope.dot(axes.col(axis))))
}

#[test]
fn valleys_keep_the_mean_and_their_slopes_are_those_of_their_heights() {
    let places: Vec<_> = (0..6_000)
        .map(|n| noise::bits(3, 9, n, 0).map(|bits| 300_000.0 * ((bits >> 11) as f64 / (1u64 << 53) as f64 - 0.5)))
        .collect();
    let heights: Vec<_> = places.iter().map(|&at| carved(at).0).collect();
    let mean = heights.iter().sum::<f64>() / heights.len() as f64;
    let rms = (heights.iter().map(|h| (h - mean).powi(2)).sum::<f64>() / heights.len() as f64).sqrt();
    const STEP_M: f64 = 8.0;
    let (mut both, mut own, mut true_slopes) = (0.0, 0.0, 0.0);
    for &[x, y] in &places {
        let (_, slope) = carved([x, y]);
        let wanted = [
            (carved([x + STEP_M, y]).0 - carved([x - STEP_M, y]).0) / (2.0 * STEP_M),
            (carved([x, y + STEP_M]).0 - carved([x, y - STEP_M]).0) / (2.0 * STEP_M),
        ];
        for (a, b) in slope.into_iter().zip(wanted) {
            both += a * b;
            own += a * a;
            true_slopes += b * b;
        }
    }
    let (correlation, size) = (both / (own * true_slopes).sqrt(), (own / true_slopes).sqrt());
    println!(
        "{mean:.1} +- {rms:.0} m; slopes {:.2}, analytic ones {size:.2} of that, correlation {correlation:.3}",
        (true_slopes / places.len() as f64).sqrt()
    );
    // Ridges 4 km apart over 300 km: 5,600 of them, 1.3 % of the deviation, thrice that.
    assert!(mean.abs() < 0.05 * rms, "{mean} of {rms}");
    // What the turning of smaller valleys about larger ones adds is left out, as of gullies (`FOLLOWS`).
    assert!(correlation > 0.8 && (0.75..1.1).contains(&size), "{correlation} {size}");
}
