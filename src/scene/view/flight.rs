//! A smooth flight from one view to another: along the great circle, up and down in an arc.

use std::f64::consts::PI;

use glam::DQuat;

use crate::model::earth;
use crate::scene::view::camera::{Camera, wrap_signed};
use crate::scene::view::navigate::arc;

/// Samples of the way along the great circle.
const SAMPLES: usize = 96;

/// The flight between two cameras.
#[derive(Clone, Debug)]
pub struct Flight {
    from: Camera,
    to: Camera,
    /// Where heights are counted from, metres: a metre below the lower end, if that is near the water or in it.
    floor_m: f64,
    /// How much the logarithm of the height rises above the straight way, at the middle.
    rise: f64,
    /// The part of the great circle that is behind the eye at each of the even steps in height.
    way: [f64; SAMPLES + 1],
    duration_s: f64,
}

impl Flight {
    /// A flight that lasts two to seven seconds, by how far the views are apart.
    pub fn new(from: Camera, to: Camera) -> Self {
        let ups = [from, to].map(|camera| earth::normal(camera.lat, camera.lon));
        let ground_m = ups[0].angle_between(ups[1]) * earth::WGS84.a;
        let floor_m = (from.altitude_m.min(to.altitude_m) - 1.0).min(0.0);
        let [low, high] = [from, to].map(|camera| (camera.altitude_m - floor_m).ln());
        // High enough that both ends are seen together; no arc where one end already is.
        let peak = (ground_m * 0.5).max(1.0).ln();
        let rise = if peak > low.max(high) { peak - (low + high) / 2.0 } else { 0.0 };
        let climb = (high - low).abs() + 2.0 * rise;
        let mut flight =
            Self { from, to, floor_m, rise, way: [0.0; SAMPLES + 1], duration_s: (1.5 + 0.3 * climb).clamp(2.0, 7.0) };
        flight.measure_way();
        flight
    }

    /// Seconds from the one view to the other.
    pub fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// The part of the way in height that is behind the eye after so many seconds, 0…1: at rest at both ends.
    pub fn eased(&self, seconds: f64) -> f64 {
        let u = seconds / self.duration_s;
        let u = if u.is_nan() { 0.0 } else { u.clamp(0.0, 1.0) };
        // Smootherstep.
        u * u * u * (u * (u * 6.0 - 15.0) + 10.0)
    }

    /// The view after so many seconds: exactly the ends at and beyond the ends.
    pub fn at(&self, seconds: f64) -> Camera {
        let s = self.eased(seconds);
        if s <= 0.0 {
            return self.from;
        }
        if s >= 1.0 {
            return self.to;
        }
        let [start, end] = [self.from, self.to].map(|camera| earth::normal(camera.lat, camera.lon));
        let (axis, angle) = arc(start, end).to_axis_angle();
        let up = DQuat::from_axis_angle(axis, angle * self.way_at(s)) * start;
        let mix = |a: f64, b: f64| a + (b - a) * s;
        // A view ahead would show the sky from the top of the arc.
        let lookdown = (4.0 * s * (1.0 - s) * (self.rise / 3.0).min(1.0)).clamp(0.0, 1.0);
        Camera {
            lat: up.z.clamp(-1.0, 1.0).asin(),
            lon: up.y.atan2(up.x),
            altitude_m: self.altitude_m(s),
            heading: self.from.heading + wrap_signed(self.to.heading - self.from.heading) * s,
            tilt: mix(self.from.tilt, self.to.tilt).clamp(0.0, PI) * (1.0 - lookdown),
        }
        .normalized()
    }

    /// Height at a part of the flight, metres: even in its logarithm over the floor.
    fn altitude_m(&self, s: f64) -> f64 {
        let [from_m, to_m] = [self.from, self.to].map(|camera| camera.altitude_m - self.floor_m);
        self.floor_m + (from_m.ln() + (to_m / from_m).ln() * s + 4.0 * s * (1.0 - s) * self.rise).exp()
    }

    /// Spends the way over ground where the eye is high, so that it seems to move evenly.
    fn measure_way(&mut self) {
        for i in 0..SAMPLES {
            let middle = (i as f64 + 0.5) / SAMPLES as f64;
            self.way[i + 1] = self.way[i] + self.altitude_m(middle).max(1.0);
        }
        let whole = self.way[SAMPLES];
        self.way.iter_mut().for_each(|part| *part /= whole);
    }

    fn way_at(&self, s: f64) -> f64 {
        let position = s.clamp(0.0, 1.0) * SAMPLES as f64;
        let i = (position as usize).min(SAMPLES - 1);
        self.way[i] + (self.way[i + 1] - self.way[i]) * (position - i as f64)
    }
}
