//! Imagery tiles: the colour of the land as a picture of 256 x 256 texels, sRGB, JPEG or PNG.
//!
//! A tile's colours go on over its shores and lakes, so that no water bleeds into what filters them. JPEG is decoded by the same code natively
//! and in browsers, without instructions of one processor alone, so that both draw the same bytes.

use super::png_tile::decode_rgb;
use super::tile::TILE_TEXELS;
use crate::error::{Error, Result};
use std::io::Cursor;
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

const PNG_SIGNATURE: &[u8] = b"\x89PNG";

/// The 65,536 texels of an imagery tile, red, green, blue (sRGB) and 255. `what` names the tile in errors.
///
/// # Errors
/// [`Error::BadData`] with what is wrong: neither JPEG nor an 8-bit RGB(A) PNG, cut short, another size.
pub fn decode(what: &str, bytes: &[u8]) -> Result<Vec<[u8; 4]>> {
    if bytes.starts_with(PNG_SIGNATURE) {
        return Ok(decode_rgb(what, bytes)?.into_iter().map(|[r, g, b]| [r, g, b, 255]).collect());
    }
    let (size, texels) = decode_jpeg(what, bytes, TILE_TEXELS, "the tile needs to be a JPEG of 256 x 256 texels")?;
    if size != [TILE_TEXELS; 2] {
        let why = format!("has {} x {} texels", size[0], size[1]);
        return Err(Error::bad_data(what, why, "the tile needs to be a JPEG of 256 x 256 texels"));
    }
    Ok(texels.as_chunks().0.iter().map(|[r, g, b]: &[u8; 3]| [*r, *g, *b, 255]).collect())
}

/// Width and height, and red, green and blue of each texel of a JPEG whose sides are at most `longest`. `remedy` ends the errors.
///
/// # Errors
/// [`Error::BadData`] with what is wrong: not a JPEG, cut short, too large.
pub fn decode_jpeg(what: &str, bytes: &[u8], longest: usize, remedy: &str) -> Result<([usize; 2], Vec<u8>)> {
    let unreadable =
        |e: zune_jpeg::errors::DecodeErrors| Error::bad_data(what, format!("cannot be read as JPEG ({e:?})"), remedy);
    let options = DecoderOptions::default()
        .set_max_width(longest)
        .set_max_height(longest)
        .set_strict_mode(true)
        .set_use_unsafe(false)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
    decoder.decode_headers().map_err(unreadable)?;
    let Some((width, height)) = decoder.dimensions() else {
        return Err(Error::bad_data(what, "has no size", remedy));
    };
    let texels = decoder.decode().map_err(unreadable)?;
    if texels.len() != 3 * width * height {
        return Err(Error::bad_data(what, format!("has {} bytes for {width} x {height} texels", texels.len()), remedy));
    }
    Ok(([width, height], texels))
}
