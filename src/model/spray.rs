//! Spray in the air over a stormy sea: how far one sees through it.
//!
//! Neither extinction nor height has been measured as a function of the wind alone. Ours follow what the Beaufort scale says of
//! visibility: crests break into spindrift from grade 8, spray may affect visibility at 9, does at 11, and at 12 the air is filled with
//! foam and spray and visibility is very seriously affected.

use super::earth::WGS84;

/// Extinction at a speed of [`HURRICANE_MPS`], per metre: a visibility of 600 m by Koschmieder's law.
const HURRICANE_PER_M: f64 = 3.912 / 600.0;
/// Where the scale's grade 12 begins, m/s.
const HURRICANE_MPS: f64 = 32.7;
/// Where its grade 8 does, the first with spindrift, m/s.
const GALE_MPS: f64 = 17.2;
/// Spindrift grows with this power of the wind over a gale's.
const SPINDRIFT_POWER: f64 = 0.75;
/// Extinction grows with this power of the wind: 6.6 km at 22.6 m/s, 20 km at 19 m/s.
const POWER: f64 = 6.5;
/// Height over which spray thins out by a factor of e where there are no waves, metres.
pub const LEAST_HEIGHT_M: f64 = 2.0;
/// Optical depths along the sight to the horizon between which spray comes into a picture: less of the light is not missed.
const SHOWN: [f64; 2] = [0.002, 0.004];

/// Extinction of light by spray at the water, per metre, by the wind's speed 10 m above it in m/s.
pub fn extinction_per_m(speed_mps: f64) -> f64 {
    HURRICANE_PER_M * libm::pow((speed_mps / HURRICANE_MPS).clamp(0.0, 1.5), POWER)
}

/// How much spindrift the wind tears off breaking crests, of a hurricane's, 0…1, by its speed in m/s: none below grade 8, and much of it
/// from 10 on, where seas tumble. Nobody has measured it.
pub fn spindrift(speed_mps: f64) -> f64 {
    libm::pow(((speed_mps - GALE_MPS) / (HURRICANE_MPS - GALE_MPS)).clamp(0.0, 1.0), SPINDRIFT_POWER)
}

/// Height over which spray thins out by a factor of e, metres, by the sea's significant wave height in metres.
pub fn scale_height_m(hs_m: f64) -> f64 {
    LEAST_HEIGHT_M + hs_m.max(0.0)
}

/// How much of spray is drawn for an eye at a height over the water, 0…1, by its extinction per metre and its scale height, metres: none
/// where it would hide nothing. It hides most towards the horizon, to which a high eye looks down and a low one along the water.
pub fn shown(extinction_per_m: f64, height_m: f64, eye_m: f64) -> f64 {
    let over_horizon = eye_m.max(height_m / std::f64::consts::PI);
    let slant = (2.0 * over_horizon / (WGS84.a + over_horizon)).sqrt();
    let share = ((extinction_per_m * height_m / slant - SHOWN[0]) / (SHOWN[1] - SHOWN[0])).clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
