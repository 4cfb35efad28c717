//! Elevation tiles: Terrarium (elevation = R · 256 + G + B / 256 - 32,768 metres), and Mapbox' encoding for reading
//! (elevation = (R · 65,536 + G · 256 + B) / 10 - 10,000 metres).
//!
//! Terrarium: <https://github.com/tilezen/joerd/blob/master/docs/formats.md>.

use super::png_tile::{decode_rgb, encode_rgb};
use crate::error::Result;

/// How an elevation tile packs metres into colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Encoding {
    /// R · 256 + G + B / 256 - 32,768.
    #[default]
    Terrarium,
    /// (R · 65,536 + G · 256 + B) / 10 - 10,000.
    Mapbox,
}

/// Elevations in metres of the 65,536 texels of a PNG tile. `what` names the tile in errors.
///
/// # Errors
/// [`crate::error::Error::BadData`] where the bytes are not an 8-bit RGB(A) PNG of 256 x 256 texels.
pub fn decode(what: &str, bytes: &[u8], encoding: Encoding) -> Result<Vec<f32>> {
    let metres = |[r, g, b]: [u8; 3]| {
        let (r, g, b) = (f32::from(r), f32::from(g), f32::from(b));
        match encoding {
            Encoding::Terrarium => r * 256.0 + g + b / 256.0 - 32_768.0,
            Encoding::Mapbox => (r * 65_536.0 + g * 256.0 + b) * 0.1 - 10_000.0,
        }
    };
    Ok(decode_rgb(what, bytes)?.into_iter().map(metres).collect())
}

/// The Terrarium PNG of 65,536 elevations in metres, rounded to 1/256 m and clamped to ±32,767 m.
///
/// # Errors
/// [`crate::error::Error::BadData`] if there are not 65,536 values.
pub fn encode(elevations_m: &[f32]) -> Result<Vec<u8>> {
    let colour = |metres: &f32| {
        let steps = ((metres.clamp(-32_767.0, 32_767.0) + 32_768.0) * 256.0).round() as u32;
        [(steps >> 16) as u8, (steps >> 8) as u8, steps as u8]
    };
    encode_rgb(&elevations_m.iter().map(colour).collect::<Vec<_>>())
}
