//! What the hands do, made smooth: a drag that swings out, a wheel that eases, keys that start and stop softly.
//!
//! Everything decays exponentially in time, so the motion does not depend on the number of frames.

use glam::{DQuat, DVec2, DVec3};

use crate::model::earth::WGS84;
use crate::scene::view::camera::{Camera, LOWEST_M};
use crate::scene::view::navigate::{
    above_ground, arc, bring, drag_beside, ground_ellipsoid, reach_m, slide, turn, turned, zoom,
};

/// Time in seconds after which a released globe has slowed to 1/e.
const SWING_S: f64 = 0.35;

/// Time in seconds after which 1/e of a wheel step is still to come.
const WHEEL_S: f64 = 0.09;

/// Time in seconds over which the speed of a drag is measured.
const MEASURE_S: f64 = 0.06;

/// Time in seconds in which keys reach 1 − 1/e of their speed.
const KEYS_S: f64 = 0.12;

/// Reaches of the eye per second that a released globe may move at most.
const FASTEST_SWING: f64 = 3.0;

/// Keys held down, each component −1 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Keys {
    /// To the right and ahead.
    pub slide: DVec2,
    /// Up.
    pub rise: f64,
    /// Heading to the right and tilt up.
    pub turn: DVec2,
}

/// What the eye is held by while a pointer is down.
#[derive(Clone, Copy, Debug)]
struct Grab {
    /// The grabbed point of the ground, earth-centred; `None` in the sky.
    point: Option<DVec3>,
    pixel: DVec2,
}

/// The motion of the eye that is under way.
#[derive(Clone, Debug, Default)]
pub struct Navigator {
    grab: Option<Grab>,
    /// Turn of the eye about the earth's centre, radians per second along the axis.
    spin: DVec3,
    /// Logarithm of the height ratio still to come.
    zoom_left: f64,
    zoom_pixel: DVec2,
    keys: Keys,
}

impl Navigator {
    /// Takes hold of the place under a pixel; stops everything that moves.
    pub fn grab(&mut self, camera: &Camera, pixel: DVec2, size: DVec2, ground_m: f64) {
        self.stop();
        self.grab = Some(Grab { point: camera.unproject_onto(&ground_ellipsoid(ground_m), pixel, size), pixel });
    }

    /// Moves the eye so that what was grabbed is under the pixel; `seconds` since the last move measures the speed.
    pub fn drag(&mut self, camera: &mut Camera, pixel: DVec2, size: DVec2, ground_m: f64, seconds: f64) {
        let Some(grab) = &mut self.grab else { return };
        let delta = pixel - std::mem::replace(&mut grab.pixel, pixel);
        let held = grab.point.and_then(|point| bring(camera, point, pixel, size, ground_m));
        let Some(moved) = held.or_else(|| drag_beside(camera, delta, size)) else { return };
        if seconds > 0.0 {
            let (axis, angle) = arc(camera.eye_ecef(), moved.eye_ecef()).to_axis_angle();
            let keep = (-seconds / MEASURE_S).exp();
            self.spin = self.spin * keep + axis * (angle / seconds) * (1.0 - keep);
        }
        *camera = moved;
    }

    /// Lets go: the globe swings on with the speed it has. `held_s`: seconds since it last moved.
    pub fn release(&mut self, camera: &Camera, held_s: f64) {
        self.grab = None;
        let fastest = FASTEST_SWING * reach_m(camera.altitude_m) / WGS84.a;
        self.spin = (self.spin * (-held_s / MEASURE_S).exp()).clamp_length_max(fastest);
    }

    /// Whether a pointer holds the globe.
    pub fn is_grabbed(&self) -> bool {
        self.grab.is_some()
    }

    /// Asks for a change of height by a factor, towards the place under a pixel.
    pub fn zoom_by(&mut self, ratio: f64, pixel: DVec2) {
        if ratio > 0.0 && ratio.is_finite() {
            self.zoom_left = (self.zoom_left + ratio.ln()).clamp(-20.0, 20.0);
            self.zoom_pixel = pixel;
        }
    }

    /// Ends all motion where it is.
    pub fn stop(&mut self) {
        *self = Self::default();
    }

    /// Moves the eye on by some seconds; `true` while there is more to come. An eye that moves stays above a ground `ground_m` high; one at rest is
    /// left where it is.
    pub fn step(&mut self, camera: &mut Camera, keys: Keys, size: DVec2, ground_m: f64, seconds: f64) -> bool {
        let seconds = seconds.clamp(0.0, 1.0);
        let before = *camera;
        self.swing(camera, seconds);
        self.wheel(camera, size, ground_m, seconds);
        self.press(camera, keys, size, ground_m, seconds);
        if before != *camera {
            *camera = above_ground(camera, ground_m);
        }
        before != *camera || self.zoom_left != 0.0 || self.spin != DVec3::ZERO || self.keys != Keys::default()
    }

    fn swing(&mut self, camera: &mut Camera, seconds: f64) {
        if self.grab.is_some() || self.spin == DVec3::ZERO {
            return;
        }
        let left = (-seconds / SWING_S).exp();
        let way = self.spin * SWING_S * (1.0 - left);
        if let Some(moved) =
            way.try_normalize().and_then(|axis| turned(camera, DQuat::from_axis_angle(axis, way.length())))
        {
            *camera = moved;
        }
        self.spin *= left;
        // The rest of the way is less than a pixel of a large screen.
        if self.spin.length() * SWING_S * WGS84.a < 2e-4 * reach_m(camera.altitude_m) {
            self.spin = DVec3::ZERO;
        }
    }

    fn wheel(&mut self, camera: &mut Camera, size: DVec2, ground_m: f64, seconds: f64) {
        if self.zoom_left == 0.0 {
            return;
        }
        let left = self.zoom_left * (-seconds / WHEEL_S).exp();
        let left = if left.abs() < 1e-3 { 0.0 } else { left };
        *camera = zoom(camera, (self.zoom_left - left).exp(), self.zoom_pixel, size, ground_m);
        self.zoom_left = left;
    }

    fn press(&mut self, camera: &mut Camera, keys: Keys, size: DVec2, ground_m: f64, seconds: f64) {
        /// Reaches of the eye per second that the arrow keys move.
        const SLIDE: f64 = 0.5;
        /// Change of the logarithm of the height per second.
        const RISE: f64 = 1.2;
        /// Radians per second that the view turns.
        const TURN: f64 = 0.7;
        let left = (-seconds / KEYS_S).exp();
        let ease = |now: f64, wanted: f64| {
            let next = wanted + (now - wanted) * left;
            if wanted == 0.0 && next.abs() < 1e-2 { 0.0 } else { next }
        };
        let ease_2 = |now: DVec2, wanted: DVec2| DVec2::new(ease(now.x, wanted.x), ease(now.y, wanted.y));
        self.keys = Keys {
            slide: ease_2(self.keys.slide, keys.slide),
            rise: ease(self.keys.rise, keys.rise),
            turn: ease_2(self.keys.turn, keys.turn),
        };
        let over_m = (camera.altitude_m - ground_m).max(LOWEST_M);
        if self.keys.slide != DVec2::ZERO {
            let metres = self.keys.slide * SLIDE * reach_m(over_m) * seconds;
            *camera = slide(camera, metres.x, metres.y).unwrap_or(*camera);
        }
        if self.keys.rise != 0.0 {
            *camera = zoom(camera, (self.keys.rise * RISE * seconds).exp(), size / 2.0, size, ground_m);
        }
        if self.keys.turn != DVec2::ZERO {
            let angle = self.keys.turn * TURN * seconds;
            *camera = turn(camera, angle.x, angle.y, size, ground_m);
        }
    }
}
