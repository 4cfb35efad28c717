//! The eye over the moving water: its altitude counted from the surface at its place instead of from the ellipsoid.

use crate::scene::sea::Seas;
use crate::scene::settings::Settings;
use crate::scene::view::camera::Camera;
use crate::scene::view::state::ViewState;

/// Altitudes in crest heights between which a riding eye comes to rest: from the upper one on, a wave would move the picture by less
/// than its pixels, 1/2000 of the altitude.
const LEFT_BEHIND: [f64; 2] = [1_000.0, 2_000.0];

impl Seas {
    /// Height in metres of the drawn surface over the ellipsoid under the eye.
    pub fn surface_height(&mut self, settings: &Settings, camera: &Camera, unix_seconds: f64) -> f64 {
        self.height_at(settings, camera.lat, camera.lon, unix_seconds)
    }

    /// The eye of a state at an instant: the camera, lifted onto the moving surface when it rides.
    pub fn eye(&mut self, state: &ViewState, unix_seconds: f64) -> Camera {
        let riding = f64::from(u8::from(state.ride));
        self.lifted(&state.settings, &state.camera, riding, unix_seconds)
    }

    /// A camera lifted by a part, 0…1, of the water's height below it; far up by less, and then by nothing.
    pub fn lifted(&mut self, settings: &Settings, camera: &Camera, part: f64, unix_seconds: f64) -> Camera {
        let crests = camera.altitude_m / self.drawn(settings).crest_m().max(1e-3);
        let [from, to] = LEFT_BEHIND;
        let part = part * ((to - crests) / (to - from)).clamp(0.0, 1.0);
        let lift_m = if part > 0.0 { part * self.surface_height(settings, camera, unix_seconds) } else { 0.0 };
        Camera { altitude_m: camera.altitude_m + lift_m, ..*camera }
    }
}
