//! How much light falls on level ground by day and in twilight, in closed form: what a light meter would say. Uses `libm`: a picture is
//! exposed alike everywhere, to the last bit.

/// Optical depths of the air straight up at 550 nm: what scatters (molecules and a sea's aerosol), and ozone.
const SCATTERING: f64 = 0.10 + 0.08;
const ABSORPTION: f64 = 0.03;
/// Share of what is taken out of the beam and scattered that comes down.
const FORWARD: f64 = 0.62;
/// Light of the sky with the sun on the horizon, of the sun's beyond the air, and how fast it goes as the sun sinks: half of it each
/// 0.02 of the sine.
const AT_SUNSET: f64 = 0.016;
const HALVED_BY: f64 = 0.02;

/// What makes level ground grey in the light of sun and sky, the sun at 45 degrees: factors of red, green and blue that leave its luminance.
/// Cameras set to daylight do the same.
pub const BALANCE: [f64; 3] = [0.963, 1.0013, 1.0972];

/// Relative optical air mass by the sine of the sun's elevation, at least 0
/// ([Kasten and Young](crate::bibliography::KastenYoung1989)).
fn air_mass(mu: f64) -> f64 {
    let elevation_deg = libm::asin(mu.clamp(0.0, 1.0)).to_degrees();
    1.0 / (mu.max(0.0) + 0.50572 * libm::pow(elevation_deg + 6.07995, -1.6364))
}

/// Share of the sun's light above the air that comes down, in its beam or scattered out of it.
fn passed(mu: f64) -> f64 {
    let m = air_mass(mu);
    let (scattered, absorbed) = (libm::exp(-SCATTERING * m), libm::exp(-ABSORPTION * m));
    absorbed * (scattered + FORWARD * (1.0 - scattered))
}

/// Light of a sky whose sun is at the horizon.
fn dusk(mu: f64) -> f64 {
    AT_SUNSET * libm::exp2(-mu.abs() / HALVED_BY)
}

/// Irradiance of level ground by sun and sky at about 550 nm, in units of the sun's beyond the air, by the sine of the sun's elevation.
pub fn irradiance(mu: f64) -> f64 {
    mu.max(0.0) * passed(mu) + dusk(mu)
}

/// Irradiance of what faces the sun, likewise: of its beam, and of the sky that lies before it.
pub fn facing_the_sun(mu: f64) -> f64 {
    let m = air_mass(mu);
    let beam = if mu > 0.0 { libm::exp(-(SCATTERING + ABSORPTION) * m) } else { 0.0 };
    let sky = irradiance(mu) - mu.max(0.0) * beam;
    beam + 0.5 * (1.0 + mu.max(0.0)) * sky
}
