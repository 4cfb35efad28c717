//! The eye: where it is and where it looks.
//!
//! Tilt 0 looks straight down, 90° at the horizon, 180° straight up; heading is clockwise from north. East-north-up
//! components of the three axes (h heading, t tilt):
//! ```text
//!   right   = ( cos h,        −sin h,        0     )
//!   up      = ( cos t sin h,   cos t cos h,  sin t )      up on the screen
//!   forward = ( sin t sin h,   sin t cos h, −cos t )      right × forward = up
//! ```
//! Defined everywhere: at a pole the longitude says which way "north" is.
//! Pixels count from the top left corner of the picture; `size` is its width and height in the same unit.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};

use crate::error::Result;
use crate::model::earth::{self, Ellipsoid, Geodetic, WGS84};

/// Full vertical field of view, radians.
pub const FIELD_OF_VIEW_Y: f64 = PI / 4.0;

/// Lowest altitude that the user can reach, metres over the ground or the sea.
pub const LOWEST_M: f64 = 1.0;

/// Lowest altitude over the bed of the sea, metres.
pub const OVER_BED_M: f64 = 0.5;

/// Highest altitude, metres.
pub const HIGHEST_M: f64 = 4e7;

/// An eye over the WGS84 ellipsoid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Geodetic latitude, radians, −π/2 to π/2.
    pub lat: f64,
    /// Longitude, radians, `[−π, π)`.
    pub lon: f64,
    /// Height over the rest surface of the sea, metres, which is drawn on the ellipsoid: under a [geoid](crate::scene::settings::Datum) links
    /// and readings have that surface's height besides.
    pub altitude_m: f64,
    /// Compass direction of the view, radians clockwise from north, `[0, 2π)`.
    pub heading: f64,
    /// Angle from straight down, radians: 0 down, π/2 horizon, π up.
    pub tilt: f64,
}

/// Right, up and forward: orthonormal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// To the right on the screen.
    pub right: DVec3,
    /// Up on the screen.
    pub up: DVec3,
    /// Into the screen.
    pub forward: DVec3,
}

impl Default for Camera {
    fn default() -> Self {
        Self::from_degrees(20.0, -30.0, 2e7, 0.0, 0.0)
    }
}

impl Camera {
    /// A camera from degrees and metres; longitude and heading wrap, latitude and tilt are clamped.
    pub fn from_degrees(lat_deg: f64, lon_deg: f64, altitude_m: f64, heading_deg: f64, tilt_deg: f64) -> Self {
        let tilt = tilt_deg.to_radians();
        Self {
            lat: lat_deg.to_radians(),
            lon: lon_deg.to_radians(),
            altitude_m,
            heading: heading_deg.to_radians(),
            tilt,
        }
        .normalized()
    }

    /// The same view with latitude and tilt clamped and longitude and heading wrapped into their ranges.
    pub fn normalized(self) -> Self {
        Self {
            lat: self.lat.clamp(-PI / 2.0, PI / 2.0),
            lon: wrap_signed(self.lon),
            altitude_m: self.altitude_m,
            heading: wrap_positive(self.heading),
            tilt: self.tilt.clamp(0.0, PI),
        }
    }

    /// The eye as a geodetic position.
    pub fn geodetic(&self) -> Geodetic {
        Geodetic { lat: self.lat, lon: self.lon, height: self.altitude_m }
    }

    /// The eye, earth-centred, metres.
    pub fn eye_ecef(&self) -> DVec3 {
        WGS84.ecef_from_geodetic(self.geodetic())
    }

    /// The axes of the view in the east-north-up frame of the eye.
    pub fn basis_enu(&self) -> Basis {
        let (sin_h, cos_h) = libm::sincos(self.heading);
        let (sin_t, cos_t) = libm::sincos(self.tilt);
        Basis {
            right: DVec3::new(cos_h, -sin_h, 0.0),
            up: DVec3::new(cos_t * sin_h, cos_t * cos_h, sin_t),
            forward: DVec3::new(sin_t * sin_h, sin_t * cos_h, -cos_t),
        }
    }

    /// The axes of the view, earth-centred.
    pub fn basis(&self) -> Basis {
        let ecef_from_enu = earth::ecef_from_enu(self.lat, self.lon);
        let enu = self.basis_enu();
        Basis { right: ecef_from_enu * enu.right, up: ecef_from_enu * enu.up, forward: ecef_from_enu * enu.forward }
    }

    /// The camera at an earth-centred point with given axes; roll, which this camera cannot have, is dropped.
    ///
    /// # Errors
    /// [`crate::error::Error::BadValue`] for an eye that is not finite or near the earth's centre.
    pub fn from_ecef(eye: DVec3, basis: &Basis) -> Result<Self> {
        let at = WGS84.geodetic_from_ecef(eye)?;
        let enu_from_ecef = earth::ecef_from_enu(at.lat, at.lon).transpose();
        let forward = (enu_from_ecef * basis.forward).normalize_or(DVec3::NEG_Z);
        let right = enu_from_ecef * basis.right;
        let tilt = forward.truncate().length().atan2(-forward.z);
        let ahead = forward.truncate();
        // Straight down or up only the right axis, which is level, knows the heading.
        let heading = if ahead.length() > 1e-4 { ahead.x.atan2(ahead.y) } else { (-right.y).atan2(right.x) };
        Ok(Self { lat: at.lat, lon: at.lon, altitude_m: at.height, heading, tilt }.normalized())
    }

    /// Unit direction, earth-centred, of the ray through a pixel.
    pub fn ray(&self, pixel: DVec2, size: DVec2) -> DVec3 {
        let half = size / 2.0;
        let slope = (pixel - half) / half.y.max(0.5) * (FIELD_OF_VIEW_Y / 2.0).tan();
        let axes = self.basis();
        (axes.forward + axes.right * slope.x - axes.up * slope.y).normalize()
    }

    /// The first point of the ellipsoid under a pixel; `None` where the ray misses it.
    pub fn unproject(&self, pixel: DVec2, size: DVec2) -> Option<Geodetic> {
        let place = WGS84.geodetic_from_ecef(self.unproject_ecef(pixel, size)?).ok()?;
        Some(Geodetic { height: 0.0, ..place })
    }

    /// As [`Camera::unproject`], earth-centred, metres.
    pub fn unproject_ecef(&self, pixel: DVec2, size: DVec2) -> Option<DVec3> {
        self.unproject_onto(&WGS84, pixel, size)
    }

    /// As [`Camera::unproject_ecef`] for another ellipsoid, such as one as high as the ground.
    pub fn unproject_onto(&self, ellipsoid: &Ellipsoid, pixel: DVec2, size: DVec2) -> Option<DVec3> {
        let (eye, ray) = (self.eye_ecef(), self.ray(pixel, size));
        let (near, far) = ellipsoid.ray_hit(eye, ray)?;
        Some(eye + ray * if near >= 0.0 { near } else { far })
    }

    /// The pixel of a place; `None` where it is behind the eye. Places hidden by the globe have pixels too.
    pub fn project(&self, place: Geodetic, size: DVec2) -> Option<DVec2> {
        self.project_ecef(WGS84.ecef_from_geodetic(place), size)
    }

    /// As [`Camera::project`] for an earth-centred point, metres.
    pub fn project_ecef(&self, point: DVec3, size: DVec2) -> Option<DVec2> {
        let axes = self.basis();
        let offset = point - self.eye_ecef();
        let ahead = offset.dot(axes.forward);
        if ahead <= 1e-9 * offset.length() {
            return None;
        }
        let slope = DVec2::new(offset.dot(axes.right), -offset.dot(axes.up)) / ahead;
        Some(size / 2.0 + slope / (FIELD_OF_VIEW_Y / 2.0).tan() * (size.y / 2.0))
    }

    /// Metres across the ground under one pixel at the centre of the picture, seen square on; `None` in the sky.
    pub fn metres_per_pixel(&self, size: DVec2) -> Option<f64> {
        let distance_m = self.unproject_ecef(size / 2.0, size)?.distance(self.eye_ecef());
        Some(distance_m * 2.0 * (FIELD_OF_VIEW_Y / 2.0).tan() / size.y.max(1.0))
    }
}

/// An angle wrapped into `[−π, π)`.
pub fn wrap_signed(angle: f64) -> f64 {
    if (-PI..PI).contains(&angle) {
        return angle;
    }
    // rem_euclid rounds up to TAU for a tiny negative number.
    let wrapped = (angle + PI).rem_euclid(TAU) - PI;
    if wrapped < PI { wrapped } else { -PI }
}

/// An angle wrapped into `[0, 2π)`.
pub fn wrap_positive(angle: f64) -> f64 {
    let wrapped = angle.rem_euclid(TAU);
    if wrapped < TAU { wrapped } else { 0.0 }
}
