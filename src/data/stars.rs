//! The stars of the naked eye and the Milky Way, from the bundled catalogue and map (`scripts/make-stars.sh`; credits: `NOTICE`).

use glam::DVec3;

/// Six bytes each, the brightest first: right ascension (2^16 = a turn), declination (±32767 = ±90°), 30 (magnitude + 2),
/// 100 (B−V + 0.5), little-endian.
const CATALOGUE: &[u8] = include_bytes!("stars.bin");

/// A star.
#[derive(Clone, Copy, Debug)]
pub struct Star {
    /// Unit vector in equatorial axes of J2000.0, to 0.003°.
    pub direction: DVec3,
    /// Visual magnitude, to 0.02.
    pub magnitude: f64,
    /// Colour index B−V, to 0.005.
    pub colour_index: f64,
}

/// All of them, the brightest first.
pub fn stars() -> impl Iterator<Item = Star> {
    CATALOGUE.chunks_exact(6).map(|bytes| {
        let ra = f64::from(u16::from_le_bytes([bytes[0], bytes[1]])) / 65_536.0 * std::f64::consts::TAU;
        let dec = f64::from(i16::from_le_bytes([bytes[2], bytes[3]])) / 32_767.0 * std::f64::consts::FRAC_PI_2;
        let ((sin_ra, cos_ra), (sin_dec, cos_dec)) = (libm::sincos(ra), libm::sincos(dec));
        Star {
            direction: DVec3::new(cos_dec * cos_ra, cos_dec * sin_ra, sin_dec),
            magnitude: f64::from(bytes[4]) / 30.0 - 2.0,
            colour_index: f64::from(bytes[5]) / 100.0 - 0.5,
        }
    })
}

/// A digit, 0 to 15, for each of [`PLACES`]; two to a byte, the first one low.
const MILKY_WAY: &[u8] = include_bytes!("milky_way.bin");
/// Places of the map, evenly over the sky along a spiral: each stands for 2.5 square degrees.
const PLACES: usize = 16_384;
/// From one place of the spiral to the next, degrees of right ascension: the golden angle.
const SPIRAL_DEG: f64 = 137.507_764_050_037_85;

/// A part of the Milky Way.
#[derive(Clone, Copy, Debug)]
pub struct Glow {
    /// Unit vector in equatorial axes of J2000.0.
    pub direction: DVec3,
    /// Brightness, of that of its brightest parts: in equal steps of magnitude, as its outlines are drawn.
    pub brightness: f64,
}

/// Those of its parts that shine.
pub fn milky_way() -> impl Iterator<Item = Glow> {
    (0..PLACES).filter_map(|i| {
        let digit = MILKY_WAY[i / 2] >> (4 * (i % 2)) & 15;
        let sin_dec = 1.0 - (2 * i + 1) as f64 / PLACES as f64;
        let cos_dec = (1.0 - sin_dec * sin_dec).sqrt();
        let (sin_ra, cos_ra) = libm::sincos((i as f64 * SPIRAL_DEG).to_radians());
        let direction = DVec3::new(cos_dec * cos_ra, cos_dec * sin_ra, sin_dec);
        (digit > 0).then(|| Glow { direction, brightness: f64::from(digit) / 15.0 })
    })
}
