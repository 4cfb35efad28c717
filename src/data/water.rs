//! Water tiles: what covers the ground, and how far the shores are, so that a coarse texel still gives a sharp coast.
//!
//! An 8-bit RGB PNG. Red is the signed distance to the shore of the ocean (positive in the ocean), green to the shore
//! of lakes (positive in lakes and ponds), both `128 + round(16 d)` with d in texels of the tile (true ground metres
//! over ground metres per texel), clamped to ±127/16 texels, and never 128: above 128 is in, below is out. Blue is the
//! [`WaterClass`]. Bilinear interpolation of a distance and comparison with 128 draws the shore at sub-texel precision.

use super::png_tile::{decode_rgb, encode_rgb};
use crate::error::{Error, Result};

/// Steps of a stored distance per texel.
pub const STEPS_PER_TEXEL: f64 = 16.0;
/// The stored value that would lie exactly on the shore.
pub const SHORE: u8 = 128;
/// The largest distance that a tile can state, texels; a stored ±127 means "at least this".
pub const SATURATION_TEXELS: f64 = 127.0 / 16.0;

/// What covers the ground. GSHHG's levels in brackets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
#[repr(u8)]
pub enum WaterClass {
    /// Dry land (level 1).
    Land = 0,
    /// The ocean and the seas joined to it (level 0).
    Ocean = 1,
    /// Standing water: lakes (level 2) and ponds on islands (level 4).
    Lake = 2,
    /// An island in a lake (level 3).
    Island = 3,
}

impl WaterClass {
    /// The class of a stored byte.
    pub fn from_byte(byte: u8) -> Option<Self> {
        [Self::Land, Self::Ocean, Self::Lake, Self::Island].get(usize::from(byte)).copied()
    }

    /// Whether the ground lies under water.
    pub fn is_wet(self) -> bool {
        matches!(self, Self::Ocean | Self::Lake)
    }
}

/// The stored byte of a signed distance in texels; never [`SHORE`], so that the sign survives.
pub fn byte_from_distance(texels: f64, inside: bool) -> u8 {
    let steps = (texels.abs() * STEPS_PER_TEXEL).round().clamp(1.0, 127.0) as u8;
    if inside { SHORE + steps } else { SHORE - steps }
}

/// The signed distance in texels that a byte stores.
pub fn distance_from_byte(byte: u8) -> f64 {
    (f64::from(byte) - f64::from(SHORE)) / STEPS_PER_TEXEL
}

/// The 65,536 texels of a water tile: red, green, blue as above, and a zero. `what` names the tile in errors.
///
/// # Errors
/// [`Error::BadData`] where the bytes are not an 8-bit RGB(A) PNG of 256 x 256 texels, or hold an unknown class.
pub fn decode(what: &str, bytes: &[u8]) -> Result<Vec<[u8; 4]>> {
    let texels = decode_rgb(what, bytes)?;
    if let Some(at) = texels.iter().position(|t| WaterClass::from_byte(t[2]).is_none()) {
        let why = format!("texel {at} has water class {}", texels[at][2]);
        return Err(Error::bad_data(what, why, "the classes are 0 land, 1 ocean, 2 lake, 3 island"));
    }
    Ok(texels.into_iter().map(|[r, g, b]| [r, g, b, 0]).collect())
}

/// The PNG of 65,536 texels.
///
/// # Errors
/// [`Error::BadData`] if there are not 65,536 texels.
pub fn encode(texels: &[[u8; 3]]) -> Result<Vec<u8>> {
    encode_rgb(texels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distance_survives_its_byte_and_never_loses_its_side() {
        for i in 0..2000 {
            let d = f64::from(i) * 0.005;
            for inside in [false, true] {
                let back = distance_from_byte(byte_from_distance(d, inside));
                assert_eq!(back > 0.0, inside, "{d}");
                // Half a step, or a whole one at the shore itself, where the value may not be zero.
                let tolerance = if d < 1.0 / 16.0 { 1.0 / 16.0 } else { 1.0 / 32.0 };
                let expected = d.min(SATURATION_TEXELS);
                assert!((back.abs() - expected).abs() <= tolerance + 1e-12, "{d} {back}");
            }
        }
    }
}
