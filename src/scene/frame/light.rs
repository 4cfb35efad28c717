//! What lights the picture, and which lights show in it.

use crate::model::{earth, moon, sun};
use crate::scene::frame::exposure::{exposure, into_sun};
use crate::scene::frame::night;
use crate::scene::frame::uniform::FrameUniform;
use crate::scene::layers::Layer;
use crate::scene::settings::Settings;
use crate::scene::view::camera::Camera;

/// Sine of the sun's elevation from which on no star is seen from the ground.
const STARS_BELOW: f32 = -0.03;
/// And from which on no lamp is lit as far as an eye sees that is not in space.
const LIGHTS_BELOW: f32 = 0.07;
/// From here on stars are seen by day, metres: where the sky is dark.
const STARS_ABOVE_M: f32 = 20_000.0;

/// Sun, moon and the exposure for them.
pub fn set_light(u: &mut FrameUniform, haze: f64, camera: &Camera, unix_seconds: f64) {
    let enu_from_ecef = earth::ecef_from_enu(camera.lat, camera.lon).transpose();
    let sun = enu_from_ecef * sun::sun_direction_ecef(unix_seconds);
    let moon = enu_from_ecef * (moon::position_ecef(unix_seconds) - camera.eye_ecef()).normalize();
    let moonlight = night::moonlight(sun, moon, camera.altitude_m);
    // To 0.007 degrees: what is tabulated for a sun lasts for a second and more of a running clock.
    let steps = f64::from(1 << 13);
    let light = if moonlight.is_some() { moon } else { sun };
    u.light = ((light * steps).round() / steps).normalize().as_vec3();
    // All radiances are of a light of 1; a picture by moonlight is exposed for so much more.
    let unit = moonlight.unwrap_or(1.0);
    let towards = into_sun(camera.basis_enu().forward.dot(sun), sun.z, camera.altitude_m);
    u.exposure = (exposure(sun.z, camera.altitude_m) * towards * unit) as f32;
    u.night = (1.0 / unit) as f32;
    u.night_ground = night::ground_share(camera.altitude_m) as f32;
    u.moon = moon.as_vec3();
    u.moon_radiance = (night::disc_radiance(sun.z, camera.altitude_m) / unit) as f32;
    u.sun = sun.as_vec3();
    u.by_day = f32::from(u8::from(moonlight.is_none()));
    u.haze = haze as f32;
}

/// Whether stars are worth drawing.
pub fn stars_show(u: &FrameUniform, settings: &Settings) -> bool {
    let wanted = [Layer::Sky, Layer::Stars].iter().all(|layer| settings.layers.shows(*layer));
    wanted && (u.sun.z < STARS_BELOW || u.eye_altitude > STARS_ABOVE_M)
}

/// Whether city lights are worth looking for.
pub fn city_lights_show(u: &FrameUniform, settings: &Settings) -> bool {
    let wanted = [Layer::Land, Layer::Lights].iter().all(|layer| settings.layers.shows(*layer));
    wanted && (u.sun.z < LIGHTS_BELOW || u.eye_altitude > STARS_ABOVE_M)
}
