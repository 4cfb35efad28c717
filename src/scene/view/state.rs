//! The whole view: where the eye is, how the sea is, when. What a link carries.

use crate::scene::settings::Settings;
use crate::scene::time::SceneTime;
use crate::scene::view::camera::Camera;

/// Everything that a shared link restores. Its text form is in [`crate::scene::link::fragment`].
#[derive(Clone, Debug, PartialEq)]
pub struct ViewState {
    /// The eye.
    pub camera: Camera,
    /// Whether the eye's altitude is over the moving surface instead of over the ellipsoid.
    pub ride: bool,
    /// The sea and the picture.
    pub settings: Settings,
    /// When the scene starts.
    pub time: SceneTime,
    /// Seconds of scene per second of clock, −1,000 to 1,000; 0 = paused.
    pub rate: f64,
    /// Pairs of the page's fragment that are not ours, as they were written.
    pub unknown: Vec<String>,
}

impl Default for ViewState {
    fn default() -> Self {
        Self {
            camera: Camera::default(),
            ride: false,
            settings: Settings::default(),
            time: SceneTime::Now,
            rate: 1.0,
            unknown: Vec::new(),
        }
    }
}
