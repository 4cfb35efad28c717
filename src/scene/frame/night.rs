//! What lights a night. An eye that has got used to the dark sees by a light of a four-hundred-thousandth of the sun's; a picture that is
//! exposed for a twilight, as all later ones are, shows the moon's as so much brighter.

use glam::DVec3;

use crate::model::moon;

/// Light of a full moon in a picture, of the sun's: 4,000 times what it is (0.25 lux of 128,000).
const FULL: f64 = 0.008;
/// Sines of the sun's elevation between which the moon takes over: there the sun's last light is less than the night's own.
const TAKES_OVER: [f64; 2] = [-0.15, -0.24];
/// Sines of the moon's elevation between which it rises.
const RISES: [f64; 2] = [-0.01, 0.03];
/// Heights between which the moon's light is lost: from space the sun lights the picture, by day and by night, m.
const LOST_M: [f64; 2] = [30_000.0, 100_000.0];
/// Less than this counts as none.
const LEAST: f64 = 2e-4;
/// Radiance of a full moon's disc in units of the sun's irradiance: 2e-6 of it over 6.4e-5 sr.
const DISC: f64 = 0.03;
/// And how much brighter it is by night, less than its light: else it would be all glare.
const DISC_BY_NIGHT: f64 = 8.0;

fn smoothstep([from, to]: [f64; 2], x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// The moon's light in the picture, of the sun's, where it is the moon that lights it; `sun` and `moon` are unit vectors, z up at the eye,
/// which is `altitude_m` high.
pub fn moonlight(sun: DVec3, moon: DVec3, altitude_m: f64) -> Option<f64> {
    let seen = smoothstep(TAKES_OVER, sun.z) * smoothstep(RISES, moon.z) * (1.0 - smoothstep(LOST_M, altitude_m));
    Some(FULL * seen * moon::phase_brightness(moon, sun)).filter(|light| *light > LEAST)
}

/// Radiance of a full moon's disc in units of the sun's irradiance.
pub fn disc_radiance(sun_z: f64, altitude_m: f64) -> f64 {
    DISC * libm::pow(DISC_BY_NIGHT, smoothstep(TAKES_OVER, sun_z) * (1.0 - smoothstep(LOST_M, altitude_m)))
}

/// Share of the light that the dark side of the globe is given to be made out which is there for an eye at a height.
pub fn ground_share(altitude_m: f64) -> f64 {
    0.1 + 0.9 * smoothstep([1e4, 4e5], altitude_m)
}
