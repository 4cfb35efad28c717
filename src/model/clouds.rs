//! Clouds: how much of the sky they cover where, how they drift, and where storms turn them.
//!
//! The sky at a place is covered where a standard normal field lies above a level; that level follows the latitude, so that the tropics'
//! belt and the tracks of storms are cloudy and the subtropics are not, and is shifted as a whole to the cover that is asked for. None of
//! it is a day's weather: it is a climate with a weather of its own, the same for everyone at an instant.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DVec3, Vec4};

/// Storms of an instant's weather.
pub const STORMS: usize = 28;
/// Texels along a side of the octahedral map of the weather: 39 km in the mean.
pub const MAP_TEXELS: u32 = 512;
/// Variance of the field that the map does not hold, of one.
pub const FINE_VARIANCE: f64 = 0.24;
/// Height of the base of water clouds, metres.
pub const BASE_M: f64 = 900.0;
/// Height of ice clouds, metres.
pub const ICE_M: f64 = 9_000.0;
/// How long a weather lasts before the next has taken its place, seconds.
const WEATHER_S: f64 = 3.0 * 86_400.0;
/// Number of the weather of 1970's start: with it named views have about the clouds that their links ask for.
const FIRST_WEATHER: i64 = 15_167;
/// Clouds go round the earth in this time, seconds, eastwards: 7.5 m/s at the equator.
const ROUND_S: f64 = 5.343_336e6;
/// Deviations by which no cover, or all of it, is as good as reached.
const MOST_SHIFT: f64 = 6.0;

/// Deviations by which the field lies above what covers half of the sky at a latitude, radians, before the shift: greatest in the
/// tropics' belt and in the tracks of storms, least about 22 degrees from the equator. Equals `cloud_belts` in `shaders/cloud_map.wgsl`.
/// The shape follows the zonal means of M. King et al. 2013 ("Spatial and temporal distribution of clouds observed by MODIS").
pub fn belts(lat: f64) -> f64 {
    let degrees = lat.to_degrees();
    let bump = |middle: f64, width: f64| libm::exp(-((degrees - middle) / width).powi(2));
    1.0 * bump(6.0, 8.0) + 1.25 * (bump(57.0, 20.0) + bump(-57.0, 20.0)) - 0.7
}

/// Share of the earth that is covered where the field is shifted by so many deviations.
fn covered(shift: f64) -> f64 {
    let steps = 360;
    let band = |step: i32| {
        let lat = (f64::from(step) + 0.5) / f64::from(steps) * 2.0 * FRAC_PI_2 - FRAC_PI_2;
        let share = 0.5 * libm::erfc(-(belts(lat) + shift) / std::f64::consts::SQRT_2);
        let area = libm::cos(lat);
        (share * area, area)
    };
    let (sum, area) = (0..steps).map(band).fold((0.0, 0.0), |(sum, area), (s, a)| (sum + s, area + a));
    sum / area
}

/// The shift, in deviations, that covers a share 0…1 of the earth.
pub fn shift(cover: f64) -> f64 {
    let (mut low, mut high) = (-MOST_SHIFT, MOST_SHIFT);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if covered(middle) < cover { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// How far clouds have drifted eastwards at an instant, radians.
pub fn drift(unix_seconds: f64) -> f64 {
    (unix_seconds / ROUND_S).rem_euclid(1.0) * TAU
}

/// The weather of an instant: two that follow each other, with the parts that each has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weather {
    /// Their numbers.
    pub numbers: [u32; 2],
    /// Weights, whose squares sum to one.
    pub weights: [f32; 2],
}

/// The weather of a UTC instant, seconds since 1970, in steps of about ten minutes.
pub fn weather(unix_seconds: f64) -> Weather {
    let age = unix_seconds / WEATHER_S;
    let part = ((age - age.floor()) * 432.0).floor() / 432.0;
    let number = (age.floor() as i64 + FIRST_WEATHER) as u32;
    let (sin, cos) = libm::sincos(part * FRAC_PI_2);
    Weather { numbers: [number, number.wrapping_add(1)], weights: [cos as f32, sin as f32] }
}

/// Storms of a weather: a unit vector in axes that drift with the clouds, and the storm's size, radians: less than zero in the
/// south, where it turns with the clock.
pub fn storms(number: u32) -> [Vec4; STORMS] {
    let mut state = number.wrapping_mul(0x9e37_79b9) ^ 0x51ed_270b;
    let mut random = move || {
        // PCG (M. O'Neill 2014).
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
        f64::from((word >> 22) ^ word) / f64::from(u32::MAX)
    };
    let first = f64::from(number & 0xffff) * 0.377;
    std::array::from_fn(|index| {
        let side = if index % 2 == 0 { 1.0 } else { -1.0 };
        let lat = side * (34.0 + 32.0 * random()).to_radians();
        // Steps of the golden ratio: evenly about the earth, however many.
        let lon = TAU * (first + (index / 2) as f64 * 0.618_034 + 0.07 * random());
        let at = DVec3::new(libm::cos(lat) * libm::cos(lon), libm::cos(lat) * libm::sin(lon), libm::sin(lat));
        // Small ones are many.
        let share = random();
        at.extend(side * (0.13 + 0.18 * share * share.sqrt())).as_vec4()
    })
}
