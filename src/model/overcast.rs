//! How much of the sky over a place is in cloud: the field of `shaders/cloud_map.wgsl` in f64, at one place, without what the map leaves to
//! finer noise. It lights nothing; a picture is exposed by it.

use std::f64::consts::TAU;

use glam::DVec3;

use super::clouds::{FINE_VARIANCE, Weather, belts, shift, storms};
use super::noise::hash;

/// Standard deviation of gradient noise before it is brought to 1; that of `shaders/lib/cloud_noise.wgsl`.
const NOISE_DEVIATION: f64 = 0.191;

// Those of `shaders/cloud_map.wgsl`.
const STORM_WINDS: f64 = 2.1;
const STORM_EYE: f64 = 0.12;
const STORM_REACH: f64 = 1.5;
const STORM_LEFT: f64 = 0.72;
const FRONT_PART: f64 = 0.85;
const FRONT_WIDE: f64 = 2.2;
const FRONT_TURN: f64 = 0.43;
const FRONT_WIDTH: f64 = 0.176;
const FRONT_NEAR: f64 = 0.12;
const FRONT_EDGE: f64 = 0.5;
const FRONT_UNEVEN: f64 = 0.04;
const BENT: f64 = 0.045;
const LONG: DVec3 = DVec3::new(1.0, 1.0, 1.3);
const CLUSTERS: [f64; 3] = [0.75, 11.0, 0.25];

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

/// Octaves from `first` cells a radian on, of a place that storms have moved; normal.
fn octaves(at: DVec3, moved: DVec3, first: f64, count: u32, salt: u32) -> f64 {
    let (mut sum, mut squares, mut frequency, mut amplitude, mut left) = (0.0, 0.0, first, 1.0, moved);
    for i in 0..count {
        sum += amplitude * noise((at + left) * frequency, salt + i);
        squares += amplitude * amplitude;
        frequency *= 2.03;
        amplitude *= 0.80;
        left *= STORM_LEFT;
    }
    sum / f64::sqrt(squares)
}

/// Those of a place that nothing moves.
fn still_octaves(at: DVec3, first: f64, salt: u32) -> f64 {
    octaves(at, DVec3::ZERO, first, 3, salt)
}

/// The level `ahead` turns from a front's rear edge, at a distance from the storm's middle.
fn front(ahead: f64, away: f64) -> f64 {
    let width = FRONT_WIDTH / (TAU * libm::hypot(away, FRONT_NEAR));
    let edge = FRONT_EDGE * width;
    let last = libm::exp((edge - 1.0) / width);
    let t = (ahead / edge).min(1.0);
    let clouds = (last + (1.0 - last) * t * t * (3.0 - 2.0 * t)) * libm::exp((edge - ahead).min(0.0) / width);
    let mean = 0.5 * edge + width;
    (clouds - mean) / f64::sqrt(13.0 / 35.0 * edge + 0.5 * width - mean * mean)
}

/// What fronts add at a latitude in the mean over weathers.
fn fronts_mean(sin_lat: f64) -> f64 {
    let degrees = libm::asin(sin_lat.abs().min(1.0)).to_degrees();
    let bump = |middle: f64, width: f64| libm::exp(-((degrees - middle) / width).powi(2));
    0.18 * bump(26.0, 12.0) - 0.31 * bump(70.0, 20.0)
}

/// The level of water clouds of one weather towards a unit vector.
fn weathered(towards: DVec3, number: u32) -> f64 {
    let salt = 64 * (number & 0xffff);
    let uneven = FRONT_UNEVEN * still_octaves(towards, 5.0, salt + 50);
    let (mut p, mut fronts, mut left) = (towards, -fronts_mean(towards.z), 1.0);
    for storm in storms(number) {
        let (middle, size) = (storm.truncate().as_dvec3(), f64::from(storm.w));
        let away = (2.0 * (1.0 - p.dot(middle)) / (size * size)).max(0.0);
        let within = (away + STORM_EYE * STORM_EYE) / (away + STORM_REACH * STORM_REACH);
        let wound = 0.5 * STORM_WINDS * libm::log(within) * libm::exp(-away / 8.0);
        let (sin, cos) = libm::sincos(size.signum() * wound);
        p = cos * p + sin * middle.cross(p) + (1.0 - cos) * middle.dot(p) * middle;
        let east = DVec3::new(-middle.y, middle.x, 0.0).normalize();
        let turn = libm::atan2(size.signum() * p.dot(middle.cross(east)), p.dot(east)) / TAU;
        let ahead = (turn + FRONT_TURN + uneven).rem_euclid(1.0);
        let part = FRONT_PART * libm::exp(-away / FRONT_WIDE);
        fronts += left * part * front(ahead, size.abs() * away.sqrt());
        left *= f64::sqrt(1.0 - part * part);
    }
    p += BENT * DVec3::from([10, 20, 30].map(|part| still_octaves(p, 3.0, salt + part)));
    let moved = p - towards;
    let [most, cells, width] = CLUSTERS;
    let clustered = most * libm::exp(-(towards.z / width).powi(2));
    let water = f64::sqrt(1.0 - clustered * clustered) * octaves(LONG * towards, LONG * moved, 4.0, 6, salt)
        + clustered * octaves(towards, moved, cells, 5, salt + 8);
    fronts + left * water
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
