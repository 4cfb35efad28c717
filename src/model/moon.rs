//! Where the moon stands and how much of it is lit: [Meeus](crate::bibliography::Meeus1998) chapter 47, its largest terms, and chapter 48.
//!
//! What is left out of the series adds up to 0.02° at most, nutation to 0.005°: a twentieth of the disc.

use glam::{DMat3, DVec3};

use super::sun::{CENTURY_DAYS, DELTA_T, J2000_UNIX, greenwich_mean_sidereal_time};

/// Terms of longitude (10⁻⁶ degrees) and distance (m): multiples of D, M, M′ and F, then the coefficients.
const LONGITUDE_DISTANCE: [([i8; 4], f64, f64); 26] = [
    ([0, 0, 1, 0], 6_288_774.0, -20_905_355.0),
    ([2, 0, -1, 0], 1_274_027.0, -3_699_111.0),
    ([2, 0, 0, 0], 658_314.0, -2_955_968.0),
    ([0, 0, 2, 0], 213_618.0, -569_925.0),
    ([0, 1, 0, 0], -185_116.0, 48_888.0),
    ([0, 0, 0, 2], -114_332.0, -3_149.0),
    ([2, 0, -2, 0], 58_793.0, 246_158.0),
    ([2, -1, -1, 0], 57_066.0, -152_138.0),
    ([2, 0, 1, 0], 53_322.0, -170_733.0),
    ([2, -1, 0, 0], 45_758.0, -204_586.0),
    ([0, 1, -1, 0], -40_923.0, -129_620.0),
    ([1, 0, 0, 0], -34_720.0, 108_743.0),
    ([0, 1, 1, 0], -30_383.0, 104_755.0),
    ([2, 0, 0, -2], 15_327.0, 10_321.0),
    ([0, 0, 1, 2], -12_528.0, 0.0),
    ([0, 0, 1, -2], 10_980.0, 79_661.0),
    ([4, 0, -1, 0], 10_675.0, -34_782.0),
    ([0, 0, 3, 0], 10_034.0, -23_210.0),
    ([4, 0, -2, 0], 8_548.0, -21_636.0),
    ([2, 1, -1, 0], -7_888.0, 24_208.0),
    ([2, 1, 0, 0], -6_766.0, 30_824.0),
    ([1, 0, -1, 0], -5_163.0, -8_379.0),
    ([1, 1, 0, 0], 4_987.0, -16_675.0),
    ([2, -1, 1, 0], 4_036.0, -12_831.0),
    ([2, 0, 2, 0], 3_994.0, -10_445.0),
    ([4, 0, 0, 0], 3_861.0, -11_650.0),
];

/// Terms of latitude (10⁻⁶ degrees).
const LATITUDE: [([i8; 4], f64); 13] = [
    ([0, 0, 0, 1], 5_128_122.0),
    ([0, 0, 1, 1], 280_602.0),
    ([0, 0, 1, -1], 277_693.0),
    ([2, 0, 0, -1], 173_237.0),
    ([2, 0, -1, 1], 55_413.0),
    ([2, 0, -1, -1], 46_271.0),
    ([2, 0, 0, 1], 32_573.0),
    ([0, 0, 2, 1], 17_198.0),
    ([2, 0, 1, -1], 9_266.0),
    ([0, 0, 2, -1], 8_822.0),
    ([2, -1, 0, -1], 8_216.0),
    ([2, 0, -2, -1], 4_324.0),
    ([2, 0, 1, 1], 4_200.0),
];

/// From the earth's centre to the moon's, metres, in equatorial axes of date.
fn equatorial_m(unix_seconds: f64) -> DVec3 {
    let t = (unix_seconds + DELTA_T - J2000_UNIX) / 86_400.0 / CENTURY_DAYS;
    let mean_longitude = 218.316_447_7 + t * (481_267.881_234_21 - t * 0.001_578_6);
    let arguments = [
        297.850_192_1 + t * (445_267.111_403_4 - t * 0.001_881_9),
        357.529_109_2 + t * 35_999.050_290_9,
        134.963_396_4 + t * (477_198.867_505_5 + t * 0.008_741_4),
        93.272_095_0 + t * (483_202.017_523_3 - t * 0.003_653_9),
    ]
    .map(|deg: f64| deg.rem_euclid(360.0).to_radians());
    // The orbit's eccentricity dwindles, and with it what depends on the sun's anomaly.
    let eccentricity = 1.0 - t * (0.002_516 + t * 7.4e-6);
    let angle = |multiples: [i8; 4]| multiples.iter().zip(arguments).map(|(n, x)| f64::from(*n) * x).sum::<f64>();
    let weight = |multiples: [i8; 4]| if multiples[1] == 0 { 1.0 } else { eccentricity };
    let (mut longitude, mut distance, mut latitude) = (0.0, 385_000_560.0, 0.0);
    for (multiples, sine, cosine) in LONGITUDE_DISTANCE {
        longitude += weight(multiples) * sine * libm::sin(angle(multiples));
        distance += weight(multiples) * cosine * libm::cos(angle(multiples));
    }
    for (multiples, sine) in LATITUDE {
        latitude += weight(multiples) * sine * libm::sin(angle(multiples));
    }
    let (lambda, beta) = ((mean_longitude + 1e-6 * longitude).to_radians(), (1e-6 * latitude).to_radians());
    let obliquity = (23.439_291_11 - 0.013_004_167 * t).to_radians();
    let ((sin_l, cos_l), (sin_b, cos_b)) = (libm::sincos(lambda), libm::sincos(beta));
    distance * (about_x(obliquity) * DVec3::new(cos_b * cos_l, cos_b * sin_l, sin_b))
}

/// From the earth's centre to the moon's, metres, in earth-centred axes, at Unix time `unix_seconds`; 1900 to 2200. A time that is not
/// finite gives the place at J2000.0.
pub fn position_ecef(unix_seconds: f64) -> DVec3 {
    let unix_seconds = if unix_seconds.is_finite() { unix_seconds } else { J2000_UNIX };
    about_z(-greenwich_mean_sidereal_time(unix_seconds)) * equatorial_m(unix_seconds)
}

/// Light of the moon over that of a full one, by the direction to it and that to the sun from the same eye, unit vectors
/// ([Allen](crate::bibliography::Allen1973): 10^(-0.4 (0.026 α + 4e-9 α⁴)), α in degrees).
pub fn phase_brightness(to_moon: DVec3, to_sun: DVec3) -> f64 {
    // The sun is so far that it stands in the same direction from the moon.
    let phase_deg = libm::acos((-to_moon.dot(to_sun)).clamp(-1.0, 1.0)).to_degrees();
    libm::pow(10.0, -0.4 * (0.026 * phase_deg + 4e-9 * libm::pow(phase_deg, 4.0)))
}

/// From equatorial axes of J2000.0 to earth-centred axes at an instant: precession ([Meeus](crate::bibliography::Meeus1998) chapter 21)
/// and the earth's turn. For stars; without nutation and aberration, 0.01° together.
pub fn ecef_from_j2000(unix_seconds: f64) -> DMat3 {
    let unix_seconds = if unix_seconds.is_finite() { unix_seconds } else { J2000_UNIX };
    let t = (unix_seconds - J2000_UNIX) / 86_400.0 / CENTURY_DAYS;
    let angle = |a: f64, b: f64, c: f64| (t * (a + t * (b + t * c)) / 3600.0).to_radians();
    let zeta = angle(2306.2181, 0.30188, 0.017998);
    let z = angle(2306.2181, 1.09468, 0.018203);
    let theta = angle(2004.3109, -0.42665, -0.041833);
    about_z(z - greenwich_mean_sidereal_time(unix_seconds)) * about_y(-theta) * about_z(zeta)
}

/// Rotations with `libm`, which are the same everywhere to the last bit.
fn about_x(angle: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(angle);
    DMat3::from_cols(DVec3::X, DVec3::new(0.0, cos, sin), DVec3::new(0.0, -sin, cos))
}

fn about_y(angle: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(angle);
    DMat3::from_cols(DVec3::new(cos, 0.0, -sin), DVec3::Y, DVec3::new(sin, 0.0, cos))
}

fn about_z(angle: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(angle);
    DMat3::from_cols(DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z)
}
