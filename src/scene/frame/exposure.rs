//! How bright a picture is shown: by the light that falls on the place, never by its own pixels, so that a link has one exposure.

use std::f64::consts::PI;

use crate::model::daylight;

/// 2^1.1: 2^0.7, with which a grey card in the light that is metered comes out as 141 of 255, and 0.4 stops more, as a camera's meter gives sea and
/// sky: half a clear sky of a quarter and half a sea of a twentieth of white ground's light are darker than the card's 18 hundredths.
const BRIGHTER: f64 = 2.143_546_925_072_586;
/// And for an eye in space, that clouds below it are white.
const BRIGHTER_IN_SPACE: f64 = 1.3;
/// Irradiance below which a picture is not exposed for all of the light that is missing, of the sun's beyond the air: an evening looks
/// like one, and the sky about a low sun is not burnt.
const EVENING: f64 = 0.5;
/// Share of what is missing that it is exposed for, in stops.
const ADAPTED: f64 = 0.45;
/// And the least light that a picture is exposed for.
const NIGHT: f64 = 0.002_34;
/// How many times more light a picture that looks straight into the sun is exposed for; ours.
const INTO_SUN: f64 = 1.9;
/// Half of the sun's glow is left for each 0.02 of the sine that it has sunk.
const GLOW_HALVED_BY: f64 = 0.02;
/// Where half of the exposure is that of a picture from space, m.
const SPACE_M: f64 = 40_000.0;

/// Radiance of a sea, a clear sky, a cloud's sunlit side and its base, of white level ground's, as [`BRIGHTER`] has the first two; and how much of a cloud's side is
/// shaded where it stands before the sun.
const SEA: f64 = 0.05;
const CLEAR_SKY: f64 = 0.25;
const CLOUD: f64 = 0.7;
const BASES: f64 = 0.25;
const SHADED: f64 = 0.6;

/// Factor from radiance (in units of the sun's irradiance beyond the air, per steradian) to what the display's tone is made of, for an eye
/// at `altitude_m` over a place where the sine of the sun's elevation is `mu`.
///
/// Near the ground it is that of the light on level ground; from space that of a ground with the sun in its zenith, and five times that
/// where next to nothing of the disc below is lit.
pub fn exposure(mu: f64, altitude_m: f64) -> f64 {
    let dark = (1.0 - (mu + 0.85) / 0.6).clamp(0.0, 1.0);
    let [near, space] = [BRIGHTER / metered(mu), BRIGHTER_IN_SPACE * libm::pow(5.0, dark) / metered(1.0)];
    let low = near_ground(altitude_m);
    PI * libm::pow(near, low) * libm::pow(space, 1.0 - low)
}

/// Factor of the exposure of a picture whose middle is so near to the sun: `towards` is the cosine of the angle between them, `mu` the sine of
/// the sun's elevation. As photographers do who would not have the sky about a low sun burnt.
pub fn into_sun(towards: f64, mu: f64, altitude_m: f64) -> f64 {
    let glow = libm::exp2(mu.min(0.0) / GLOW_HALVED_BY) * near_ground(altitude_m);
    1.0 / (1.0 + INTO_SUN * glow * libm::pow(towards.max(0.0), 3.0))
}

/// How far a picture from so high, m, is exposed as one from near the ground, and not as one from space.
pub fn near_ground(altitude_m: f64) -> f64 {
    let high = altitude_m.max(0.0) / SPACE_M;
    1.0 / (1.0 + high * high)
}

/// Factor of the exposure for level ground that makes it one for what faces the sun, where the sine of its elevation is `mu`: a low sun that lights level ground little burns the
/// sides of clouds.
pub fn for_sunlit_sides(mu: f64) -> f64 {
    let light = metered(mu);
    light / daylight::facing_the_sun(mu).max(light)
}

/// Factor of the exposure of a picture from below clouds, as a camera that meters what it sees has it: `share` is the part of the sky that they cover, `sides` what
/// [`for_sunlit_sides`] says, `towards` the cosine of the angle between the view and the sun, `sky` the part of the picture that is sky.
///
/// All in the light that a white level ground sends back. That is the picture's mean without clouds over that with them, at most 1.
pub fn for_clouds_in_view(share: f64, sides: f64, towards: f64, sky: f64) -> f64 {
    let sunlit = CLOUD / sides * (1.0 - SHADED * 0.5 * (1.0 + towards));
    // They stand one behind another, and the sun reaches their sides until few gaps are left.
    let [hidden, lit] = [1.0 - (1.0 - share).powi(2), 1.0 - share.powi(4)];
    let cloud = lit * sunlit + (1.0 - lit) * BASES;
    let clear = sky * CLEAR_SKY + (1.0 - sky) * SEA;
    let cloudy = clear + sky * hidden * (cloud - CLEAR_SKY);
    clear / cloudy.max(clear)
}

/// Irradiance that a picture is exposed for.
fn metered(mu: f64) -> f64 {
    let light = libm::hypot(daylight::irradiance(mu), NIGHT);
    if light < EVENING { EVENING * libm::pow(light / EVENING, ADAPTED) } else { light }
}
