//! The stars of the naked eye, from the bundled catalogue (`scripts/make-stars.sh`; credits: `NOTICE`).

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
