//! How much of the earth clouds cover, how they drift and how one weather follows another.

use ocean_globe::model::clouds::{belts, drift, shift, storms, weather};

/// Share of the earth under clouds, over random places on the sphere: their latitudes' sines are even.
fn covered(shift: f64) -> f64 {
    let count = 20_000;
    let share = |index: i32| {
        let sin: f64 = (f64::from(index) + 0.5) / f64::from(count) * 2.0 - 1.0;
        // The normal distribution function by the trapezoidal rule.
        let (top, steps) = (belts(sin.asin()) + shift, 400);
        let step = (top + 8.0).max(0.0) / f64::from(steps);
        let density = |x: f64| (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt();
        (0..steps).map(|i| density(-8.0 + (f64::from(i) + 0.5) * step) * step).sum::<f64>()
    };
    (0..count).step_by(20).map(share).sum::<f64>() / f64::from(count / 20)
}

#[test]
fn the_shift_covers_what_is_asked_for() {
    for cover in [0.02, 0.2, 0.45, 0.7, 0.95] {
        let found = covered(shift(cover));
        assert!((found - cover).abs() < 1e-3, "{cover}: {found}");
    }
    // All and nothing, within what a deviation of six leaves.
    assert!(covered(shift(0.0)) < 1e-6 && covered(shift(1.0)) > 1.0 - 1e-6);
}

#[test]
fn clouds_are_where_weather_is() {
    let [tropics, subtropics, storm_track] = [5f64, 23.0, 55.0].map(|lat| belts(lat.to_radians()));
    assert!(tropics > subtropics + 0.5 && storm_track > subtropics + 0.8, "{tropics} {subtropics} {storm_track}");
}

#[test]
fn one_weather_gives_way_to_the_next() {
    let day = 86_400.0;
    let start = 6_900.0 * 3.0 * day;
    let [first, later, next] = [start, start + 2.9 * day, start + 3.0 * day].map(weather);
    for weather in [first, later, next] {
        let squares: f32 = weather.weights.iter().map(|weight| weight * weight).sum();
        assert!((squares - 1.0).abs() < 1e-6, "{weather:?}");
    }
    assert_eq!(first.weights, [1.0, 0.0]);
    // What comes has nearly all before it has all.
    assert!(later.weights[1] > 0.99 && next.numbers[0] == later.numbers[1] && next.weights == [1.0, 0.0]);
    let [some, others] = first.numbers.map(storms);
    assert!(some.iter().zip(&others).all(|(one, other)| one.truncate().distance(other.truncate()) > 1e-3));
    assert!(some.iter().all(|storm| (storm.truncate().length() - 1.0).abs() < 1e-5));
    // 7.5 m/s at the equator.
    let metres = (drift(start + 1_000.0) - drift(start)) * 6_378_137.0;
    assert!((metres - 7_500.0).abs() < 5.0, "{metres}");
}
