//! PNG pictures of exactly 256 x 256 texels, 8 bits, three or four channels: what both tile codecs stand on.

use super::tile::TILE_TEXELS;
use crate::error::{Error, Result};
use std::io::Cursor;

/// Memory that decoding one tile may take beyond its texels, bytes: rows, zlib's window and text chunks.
const DECODE_LIMIT: usize = 1 << 20;

/// Red, green and blue of the 65,536 texels of a PNG tile; an alpha channel is dropped.
///
/// # Errors
/// [`Error::BadData`] with what is wrong: not a PNG, cut short, another size, 16 bits, a palette, grey.
pub fn decode_rgb(what: &str, bytes: &[u8]) -> Result<Vec<[u8; 3]>> {
    let bad = |why: String| Error::bad_data(what, why, "the tile needs to be an 8-bit RGB PNG of 256 x 256 texels");
    let unreadable = |e: png::DecodingError| bad(format!("cannot be read as PNG ({e})"));
    let limits = png::Limits { bytes: DECODE_LIMIT };
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), limits);
    decoder.set_transformations(png::Transformations::IDENTITY);
    decoder.set_ignore_text_chunk(true);
    let mut reader = decoder.read_info().map_err(unreadable)?;
    let info = reader.info();
    let side = TILE_TEXELS as u32;
    if (info.width, info.height) != (side, side) {
        return Err(bad(format!("has {} x {} texels", info.width, info.height)));
    }
    if info.bit_depth != png::BitDepth::Eight {
        return Err(bad(format!("has {} bits per channel", info.bit_depth as u8)));
    }
    let channels = match info.color_type {
        png::ColorType::Rgb => 3,
        png::ColorType::Rgba => 4,
        other => return Err(bad(format!("has colour type {other:?}"))),
    };
    let mut texels = vec![0; TILE_TEXELS * TILE_TEXELS * channels];
    reader.next_frame(&mut texels).map_err(unreadable)?;
    Ok(texels.chunks_exact(channels).map(|texel| [texel[0], texel[1], texel[2]]).collect())
}

/// The PNG of 65,536 texels, the smallest of a few row filters; the same bytes for the same texels.
///
/// # Errors
/// [`Error::BadData`] if there are not 65,536 texels.
pub fn encode_rgb(texels: &[[u8; 3]]) -> Result<Vec<u8>> {
    let mut smallest: Option<Vec<u8>> = None;
    for filter in [png::Filter::Up, png::Filter::Adaptive, png::Filter::NoFilter] {
        let bytes = encode_filtered(texels, filter)
            .map_err(|e| Error::bad_data("tile", format!("cannot be written as PNG ({e})"), "give 65,536 texels"))?;
        if smallest.as_ref().is_none_or(|smallest| bytes.len() < smallest.len()) {
            smallest = Some(bytes);
        }
    }
    Ok(smallest.unwrap_or_default())
}

fn encode_filtered(texels: &[[u8; 3]], filter: png::Filter) -> std::result::Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, TILE_TEXELS as u32, TILE_TEXELS as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_deflate_compression(png::DeflateCompression::Level(9));
    encoder.set_filter(filter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(texels.as_flattened())?;
    writer.finish()?;
    Ok(bytes)
}
