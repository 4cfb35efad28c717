//! Floor 1: foreign bytes become typed grids.
//!
//! Tile addresses ([`tile`]), the tile codecs ([`terrarium`], [`water`] with [`coast`], [`imagery`]), the archive format that holds them
//! ([`pmtiles`]), where bytes come from ([`fetch`]: the only place that differs between
//! the web and native), and all of it together as one world that loads piece by piece ([`world`]).
//!
//! Every reader here treats its input as hostile: sizes are bounded before memory is taken, arithmetic is checked, and
//! what is wrong comes back as [`crate::error::Error`], never as a panic.

pub mod city_lights;
pub mod coast;
pub mod exposure;
pub mod fetch;
pub mod geoid;
pub mod imagery;
#[cfg(not(target_arch = "wasm32"))]
pub mod netcdf;
pub mod pmtiles;
mod png_tile;
pub mod sample;
mod sparse;
pub mod stars;
pub mod streaming;
pub mod terrarium;
pub mod tile;
pub mod towns;
pub mod water;
pub mod world;

use std::sync::Arc;

/// The decoded texels of one tile: 256 x 256, row 0 = north (row 0 = largest p.y in the polar pyramids).
#[derive(Debug, Clone, PartialEq)]
pub enum TileTexels {
    /// Elevation in metres over the rest surface of the sea, 65,536 values.
    Terrain(Vec<f32>),
    /// Distances to the shores and classes, 65,536 values; see [`water::packed`] for what the bytes mean.
    Water(Vec<[u8; 4]>),
    /// Red, green, blue (sRGB) of the land and 255, 65,536 values; see [`imagery`].
    Imagery(Vec<[u8; 4]>),
}

/// A decoded tile that several readers share.
pub type SharedTexels = Arc<TileTexels>;
