//! Where the sun stands: [Meeus](crate::bibliography::Meeus1998) chapter 25 (low accuracy) and chapter 12 (sidereal time).
//!
//! The series are good to 0.01°. Universal time minus the clock's UTC (below 0.9 s, 0.004° of rotation) and the drift of
//! terrestrial time from the constant used here (0.001° of sun today, up to about 0.005° by 1900 and 2200) come on top.
//! Leap seconds are not counted by Unix time and are no part of the angle. Geocentric: the sun's parallax (0.0024°) is left out.

use glam::DVec3;

/// Seconds from Unix time's epoch (1970-01-01T00:00) to J2000.0 (2000-01-01T12:00).
pub(super) const J2000_UNIX: f64 = 946_728_000.0;
/// Terrestrial time minus universal time, s: 69.2 in 2020 (IERS), taken constant.
pub(super) const DELTA_T: f64 = 69.2;
/// Julian days per Julian century.
pub(super) const CENTURY_DAYS: f64 = 36_525.0;

/// Mean sidereal time at Greenwich, radians in [0, 2π), at Unix time `unix_seconds` (taken as universal time). Meeus (12.4).
pub fn greenwich_mean_sidereal_time(unix_seconds: f64) -> f64 {
    let days = (unix_seconds - J2000_UNIX) / 86_400.0;
    let t = days / CENTURY_DAYS;
    // Whole turns go first: 360.98° per day times 10⁵ days would cost digits.
    let turns = days.rem_euclid(1.0);
    let deg = 280.460_618_37 + 360.0 * turns + 0.985_647_366_29 * days + t * t * (0.000_387_933 - t / 38_710_000.0);
    deg.rem_euclid(360.0).to_radians()
}

/// The sun's apparent right ascension in [0, 2π) and declination, radians. Meeus chapter 25.
pub fn equatorial(unix_seconds: f64) -> (f64, f64) {
    let t = (unix_seconds + DELTA_T - J2000_UNIX) / 86_400.0 / CENTURY_DAYS;
    equatorial_at_century(t)
}

/// As [`equatorial`], at `t` Julian centuries of terrestrial time after J2000.0.
pub fn equatorial_at_century(t: f64) -> (f64, f64) {
    let mean_longitude = 280.466_46 + t * (36_000.769_83 + t * 0.000_303_2);
    let m = (357.529_11 + t * (35_999.050_29 - t * 0.000_153_7)).to_radians();
    let centre = (1.914_602 - t * (0.004_817 + t * 0.000_014)) * m.sin()
        + (0.019_993 - t * 0.000_101) * (2.0 * m).sin()
        + 0.000_289 * (3.0 * m).sin();
    // Nutation in longitude and aberration, by the moon's node.
    let node = (125.04 - 1_934.136 * t).to_radians();
    let lambda = (mean_longitude + centre - 0.005_69 - 0.004_78 * node.sin()).to_radians();
    let obliquity = 23.439_291_11 - t * (0.013_004_167 + t * (1.639e-7 - t * 5.036e-7)) + 0.002_56 * node.cos();
    let (sin_e, cos_e) = obliquity.to_radians().sin_cos();
    let right_ascension = (cos_e * lambda.sin()).atan2(lambda.cos());
    (right_ascension.rem_euclid(std::f64::consts::TAU), (sin_e * lambda.sin()).asin())
}

/// The place where the sun stands in the zenith: (latitude, longitude), radians, longitude in (-π, π].
pub fn subsolar_point(unix_seconds: f64) -> (f64, f64) {
    let (right_ascension, declination) = equatorial(unix_seconds);
    let lon = right_ascension - greenwich_mean_sidereal_time(unix_seconds);
    let lon = std::f64::consts::PI - (std::f64::consts::PI - lon).rem_euclid(std::f64::consts::TAU);
    (declination, lon)
}

/// Unit vector from the earth's centre to the sun in earth-centred axes, at Unix time `unix_seconds`; 1900 to 2200.
/// A time that is not finite gives the direction at J2000.0, so that no picture turns to NaN.
pub fn sun_direction_ecef(unix_seconds: f64) -> DVec3 {
    let unix_seconds = if unix_seconds.is_finite() { unix_seconds } else { J2000_UNIX };
    let (lat, lon) = subsolar_point(unix_seconds);
    super::earth::normal(lat, lon)
}
