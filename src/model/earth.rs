//! The earth as an ellipsoid of revolution: geodetic and earth-centred coordinates, local frames, rays and horizons.
//!
//! Conventions: ECEF is right-handed, x through (lat 0, lon 0), z through the north pole, metres. Latitude is geodetic,
//! longitude east, both radians; height is metres above the ellipsoid, which is this program's rest surface of the sea.
//!
//! # Why Newton on the nearest-point equation
//! The usual closed forms and fixed-count iterations (as in PROJ) lose 0.1 m and more a few thousand kilometres from the
//! surface. The point p·e + z·k has its foot where t solves `(a p/(t+a²))² + (b z/(t+b²))² = 1`; the left side falls and is
//! convex for every t above the last pole, so Newton from the left reaches the one root from any distance, for oblate, prolate
//! and spherical shapes alike, with no branch near the poles.

use glam::{DMat3, DVec3};

use crate::error::{Error, Result};

/// An ellipsoid of revolution about the z axis. See [`Ellipsoid::new`] for checked construction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipsoid {
    /// Equatorial radius, m.
    pub a: f64,
    /// Polar radius, m.
    pub b: f64,
}

/// The earth: WGS 84 ([`Wgs84Standard`](crate::bibliography::Wgs84Standard)), a = 6378137 m, 1/f = 298.257223563.
pub const WGS84: Ellipsoid = Ellipsoid { a: 6_378_137.0, b: 6_356_752.314_245_179 };

/// A place by geodetic coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geodetic {
    /// Geodetic latitude, radians, north positive, in [-π/2, π/2].
    pub lat: f64,
    /// Longitude, radians, east positive; results lie in (-π, π].
    pub lon: f64,
    /// Height above the ellipsoid, m.
    pub height: f64,
}

impl Geodetic {
    /// From degrees and metres, the form that users write.
    pub fn from_deg(lat_deg: f64, lon_deg: f64, height: f64) -> Self {
        Self { lat: lat_deg.to_radians(), lon: lon_deg.to_radians(), height }
    }
}

/// Where a line meets the ellipsoid, as distances along it in units of the direction's length.
pub type NearFar = (f64, f64);

impl Ellipsoid {
    /// The earth, see [`WGS84`].
    pub const WGS84: Self = WGS84;

    /// An ellipsoid from its equatorial and polar radius, m.
    ///
    /// # Errors
    /// [`Error::BadValue`] unless both are positive and finite.
    pub fn new(a: f64, b: f64) -> Result<Self> {
        for (what, value) in [("equatorial radius", a), ("polar radius", b)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::bad_value(what, value, "give a positive number of metres"));
            }
        }
        Ok(Self { a, b })
    }

    /// An ellipsoid from its equatorial radius in metres and inverse flattening 1/f; 0 stands for a sphere, as in EPSG.
    ///
    /// # Errors
    /// As [`Ellipsoid::new`].
    pub fn from_inverse_flattening(a: f64, inverse_flattening: f64) -> Result<Self> {
        let f = if inverse_flattening == 0.0 { 0.0 } else { inverse_flattening.recip() };
        Self::new(a, a * (1.0 - f))
    }

    /// First eccentricity squared, e² = (a² − b²)/a²; 0 for a sphere, negative for a prolate shape.
    pub fn e2(&self) -> f64 {
        (self.a - self.b) * (self.a + self.b) / (self.a * self.a)
    }

    /// Radius of curvature in the prime vertical N, m, at geodetic latitude `lat`.
    pub fn prime_vertical_radius(&self, lat: f64) -> f64 {
        self.a / (1.0 - self.e2() * libm::sin(lat).powi(2)).sqrt()
    }

    /// The earth-centred position of a place, m.
    pub fn ecef_from_geodetic(&self, place: Geodetic) -> DVec3 {
        let up = normal(place.lat, place.lon);
        let n = self.prime_vertical_radius(place.lat);
        let polar = self.b / self.a;
        DVec3::new(n, n, n * polar * polar) * up + up * place.height
    }

    /// The place at an earth-centred position. At the poles, where longitude has no meaning, it is that of `atan2(y, x)`.
    ///
    /// Within 1e-6 m and 1e-12 rad from −11 km to 40,000 km. Inside the evolute (for WGS 84: within 43 km of the centre), where
    /// several normals meet, it is the nearest of their feet.
    ///
    /// # Errors
    /// [`Error::BadValue`] for a position that is not finite (or so far that its squares are not), and where two or more
    /// nearest feet are equally near: the disc (oblate), segment (prolate) or point (sphere) about the centre.
    pub fn geodetic_from_ecef(&self, ecef: DVec3) -> Result<Geodetic> {
        let refuse = |remedy: &str| Err(Error::bad_value("position", format!("{ecef:?}"), remedy));
        if !ecef.is_finite() {
            return refuse("give finite earth-centred metres");
        }
        let (a, b) = (self.a, self.b);
        let (p, z) = (libm::hypot(ecef.x, ecef.y), ecef.z);
        let (ap, bz) = (a * p, b * z.abs());
        // s = t + min(a², b²) keeps its digits near the pole of the equation, where t would cancel.
        let difference = (a - b) * (a + b);
        let (da, db) = (difference.max(0.0), (-difference).max(0.0));
        // Either term alone reaches 1 here, so the root lies to the right and Newton climbs to it without overshooting.
        let mut s = (ap - da).max(bz - db);
        if !(s > 0.0 && s.is_finite()) {
            return refuse("give a point away from the earth's centre, where the nearest place is unique");
        }
        // Outside the evolute the start is within a factor sqrt(2): 6 steps double the digits past f64. Deep inside, a step
        // multiplies s by 1.5, and the rest are for that.
        for _ in 0..100 {
            let (u, v) = (ap / (s + da), bz / (s + db));
            let step = (u * u + v * v - 1.0) / (2.0 * (u * u / (s + da) + v * v / (s + db)));
            if step.is_nan() || step <= 0.0 {
                break; // on an axis the start is the root; elsewhere rounding has the last word
            }
            s += step;
        }
        // The foot's normal is (p/(t+a²), z/(t+b²)); cross-multiplied so that neither pole divides by zero.
        let lat = libm::atan2(z * (s + da), p * (s + db));
        let (sin, cos) = libm::sincos(lat);
        // h = r·n − a²/N: stationary in lat, so it keeps the full precision of the input.
        let height = p * cos + z * sin - a * (1.0 - self.e2() * sin * sin).sqrt();
        let lon = libm::atan2(ecef.y, ecef.x);
        let lon = if lon <= -std::f64::consts::PI { std::f64::consts::PI } else { lon };
        Ok(Geodetic { lat, lon, height })
    }

    /// Where the ray `origin + t·dir` meets the surface: `(near, far)` with near ≤ far, in units of `dir`'s length.
    ///
    /// `None` if the line misses, if both hits lie behind the origin, or if the input is not usable (zero or not finite).
    /// From inside, near is negative and far is the way out.
    ///
    /// Stretching z by a/b makes the ellipsoid a sphere of radius a. The half chord then comes from the point of closest
    /// approach c as `(a − |c|)(a + |c|)`, never from b² − 4ac, which would lose the hit of a ray that grazes the limb. What
    /// remains is the input's own rounding: the radius at which the ray passes is known to about 1 nm × |origin|/a.
    pub fn ray_hit(&self, origin: DVec3, dir: DVec3) -> Option<NearFar> {
        let stretch = DVec3::new(1.0, 1.0, self.a / self.b);
        let (o, d) = (origin * stretch, dir * stretch);
        let length = d.length();
        if !(o.is_finite() && length.is_finite() && length > 0.0) {
            return None;
        }
        let d = d / length;
        let middle = -o.dot(d);
        let half_chord_2 = difference_of_squares(self.a, o + middle * d);
        if half_chord_2 < 0.0 {
            return None;
        }
        let half_chord = half_chord_2.sqrt();
        let (near, far) = (middle - half_chord, middle + half_chord);
        (far >= 0.0).then_some((near / length, far / length))
    }

    /// Distance from an eye `height` metres above the equator to its horizon, m, along the line of sight and looking along the
    /// equator: sqrt(h(2a + h)). 0 at or below the surface. Elsewhere the radius of curvature differs by at most 0.7 %, so the
    /// distance by half of that. No refraction.
    pub fn horizon_distance(&self, height: f64) -> f64 {
        if height > 0.0 { (height * (2.0 * self.a + height)).sqrt() } else { 0.0 }
    }
}

/// radius² − |v|², with the largest component subtracted first and exactly, so that a point near an axis loses nothing.
fn difference_of_squares(radius: f64, v: DVec3) -> f64 {
    let mut m = v.abs().to_array();
    m.sort_by(f64::total_cmp);
    (radius - m[2]) * (radius + m[2]) - m[1] * m[1] - m[0] * m[0]
}

/// The ellipsoid's outward unit normal at a place: up.
pub fn normal(lat: f64, lon: f64) -> DVec3 {
    let ((sin_lat, cos_lat), (sin_lon, cos_lon)) = (libm::sincos(lat), libm::sincos(lon));
    DVec3::new(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat)
}

/// The local frame at a place: columns east, north, up in earth-centred axes. At the poles the given longitude decides.
///
/// ```text
///        north (y)
///          |          direction_in_ecef = ecef_from_enu(lat, lon) * direction_in_enu
///   up (z) o── east (x)
/// ```
pub fn ecef_from_enu(lat: f64, lon: f64) -> DMat3 {
    let ((sin_lat, cos_lat), (sin_lon, cos_lon)) = (libm::sincos(lat), libm::sincos(lon));
    DMat3::from_cols(
        DVec3::new(-sin_lon, cos_lon, 0.0),
        DVec3::new(-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat),
        DVec3::new(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat),
    )
}
