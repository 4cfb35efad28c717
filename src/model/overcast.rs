//! How much of the sky over a place is in cloud: the field of `shaders/cloud_map.wgsl` in f64, at one place, without what the map leaves to
//! finer noise. It lights nothing; a picture is exposed by it.

use glam::DVec3;

use super::clouds::{FINE_VARIANCE, Weather, belts, shift, storms};
use super::noise::hash;

/// Standard deviation of gradient noise before it is brought to 1; that of `shaders/lib/cloud_noise.wgsl`.
const NOISE_DEVIATION: f64 = 0.191;
/// Radians over which a storm turns clouds.
const STORM_WIDTH: f64 = 0.17;

/// What the gradient of a lattice point adds at an offset from it.
fn gradient(cell: [i32; 3], salt: u32, offset: DVec3) -> f64 {
    let [x, y, z] = cell.map(|c| c as u32);
    let word = hash([x.wrapping_add(salt.wrapping_mul(0x9e37_79b9)), y, z.wrapping_add(salt)]);
    let part = |shift: u32| f64::from((word >> shift) & 1023) / 511.5 - 1.0;
    DVec3::new(part(22), part(12), part(2)).dot(offset)
}

/// Gradient noise of mean 0 and variance 1; cells of length 1.
fn noise(p: DVec3, salt: u32) -> f64 {
    let low = p.floor();
    let f = p - low;
    let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let mut sum = 0.0;
    for corner in 0..8 {
        let step = [corner & 1, (corner >> 1) & 1, corner >> 2];
        let [sx, sy, sz] = step.map(f64::from);
        let weight = |s: f64, u: f64| if s > 0.0 { u } else { 1.0 - u };
        let cell = [low.x as i32 + step[0], low.y as i32 + step[1], low.z as i32 + step[2]];
        sum += weight(sx, u.x) * weight(sy, u.y) * weight(sz, u.z) * gradient(cell, salt, f - DVec3::new(sx, sy, sz));
    }
    sum / NOISE_DEVIATION
}

/// Octaves from `first` cells a radian on; normal.
fn octaves(p: DVec3, first: f64, count: u32, salt: u32) -> f64 {
    let (mut sum, mut squares, mut frequency, mut amplitude) = (0.0, 0.0, first, 1.0);
    for i in 0..count {
        sum += amplitude * noise(p * frequency, salt + i);
        squares += amplitude * amplitude;
        frequency *= 2.03;
        amplitude *= 0.78;
    }
    sum / f64::sqrt(squares)
}

/// The level of water clouds of one weather towards a unit vector.
fn weathered(towards: DVec3, number: u32) -> f64 {
    let p = storms(number).iter().fold(towards, |p, storm| {
        let middle = storm.truncate().as_dvec3();
        let away = 2.0 * (1.0 - p.dot(middle)) / (STORM_WIDTH * STORM_WIDTH);
        let (sin, cos) = libm::sincos(f64::from(storm.w) * libm::exp(-away));
        cos * p + sin * middle.cross(p) + (1.0 - cos) * middle.dot(p) * middle
    });
    let salt = 64 * (number & 0xffff);
    let bent = p + 0.09 * DVec3::from([10, 20, 30].map(|part| octaves(p, 3.0, 3, salt + part)));
    octaves(bent, 4.0, 6, salt)
}

/// The level of the weather's water clouds over a place, before the shift; `towards` is a unit vector in axes that drift with the clouds.
pub fn level(towards: DVec3, weather: &Weather) -> f64 {
    let of = |which: usize| match f64::from(weather.weights[which]) {
        weight if weight > 0.0 => weight * weathered(towards, weather.numbers[which]),
        _ => 0.0,
    };
    f64::sqrt(1.0 - FINE_VARIANCE) * (of(0) + of(1)) + belts(libm::asin(towards.z.clamp(-1.0, 1.0)))
}

/// Share of the sky over a place that is in cloud, 0 to 1, over some tens of kilometres; `cover` is the earth's.
pub fn share(towards: DVec3, weather: &Weather, cover: f64) -> f64 {
    0.5 * libm::erfc(-(level(towards, weather) + shift(cover)) / f64::sqrt(2.0 * FINE_VARIANCE))
}
