//! How much of the earth clouds cover, how they drift and how one weather follows another.

use glam::DVec3;
use ocean_globe::model::clouds::{FINE_VARIANCE, Weather, belts, drift, shift, storms, weather};
use ocean_globe::model::overcast;

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

#[test]
fn storms_and_their_fronts_leave_each_latitude_its_cover() {
    // Means over weathers and longitudes, where the closed form has but the belts: what fronts add is taken off again.
    const COVERS: [f64; 3] = [0.2, 0.45, 0.7];
    let shifts = COVERS.map(shift);
    let normal = |x: f64| 0.5 * libm::erfc(-x / std::f64::consts::SQRT_2);
    for lat in [-57f64, -22.0, 6.0, 26.0, 48.0, 70.0].map(f64::to_radians) {
        let (sin_lat, cos_lat) = lat.sin_cos();
        let mut found = [0.0; 3];
        let (weathers, places) = (30, 12);
        for number in 0..weathers {
            let weather = Weather { numbers: [7_000 + number, 0], weights: [1.0, 0.0] };
            for place in 0..places {
                let lon = std::f64::consts::TAU * f64::from(place) / f64::from(places) + 0.1 * f64::from(number);
                let towards = DVec3::new(cos_lat * lon.cos(), cos_lat * lon.sin(), sin_lat);
                let level = overcast::level(towards, &weather);
                for (sum, shift) in found.iter_mut().zip(shifts) {
                    *sum += normal((level + shift) / FINE_VARIANCE.sqrt()) / f64::from(weathers * places);
                }
            }
        }
        let wanted = shifts.map(|shift| normal(belts(lat) + shift));
        println!("{:.0} degrees: found {found:.3?}, wanted {wanted:.3?}", lat.to_degrees());
        let off = |(found, wanted): (&f64, f64)| (found - wanted).abs();
        assert!(found.iter().zip(wanted).map(off).all(|off| off < 0.08), "{lat}: {found:?} {wanted:?}");
    }
}
