//! Coast tiles: shores as polygons, from which water tiles are made when they load ([`field`]).
//!
//! A Mapbox Vector Tile (<https://github.com/mapbox/vector-tile-spec/tree/master/2.1>) with the layers of [`Level`], each one feature of
//! polygons, clipped to the tile and [`BUFFER_TEXELS`] beyond it. Sides that the clipping made lie on that border, and those that a map cut
//! along the antimeridian: neither are shores. Rivers are lines, clipped alike, in the layers of [`Stream`]: they have no width but their kind's.
//!
//! Own code, since of protobuf it needs three hundred lines: the crates that read such tiles bring a protobuf library, whose memory for a
//! hostile tile is not bounded by us, and geometry types besides.

mod bends;
mod curve;
pub mod field;
pub mod inland;
mod read;
mod river;
mod sweep;
mod wire;
#[cfg(not(target_arch = "wasm32"))]
pub mod write;

use super::tile::TileId;
use crate::error::{Error, Result};

/// PMTiles' number for this kind of tile.
pub const TILE_TYPE: u8 = 1;
/// Texels of a tile's own level by which its polygons reach over its border: as far as a water tile tells distances, and two more.
pub const BUFFER_TEXELS: i32 = 10;
/// The finest grid of coordinates that is accepted, per side of a tile.
const MAX_EXTENT: u32 = 1 << 16;
/// Points of a tile, at most: each costs work at every level that is made of it.
const MAX_POINTS: usize = 1 << 18;
/// Points of a tile's rivers, at most: each may touch a whole tile's texels.
const MAX_RIVER_POINTS: usize = 1 << 14;
/// What is wrong with a tile that needs no words of its own.
const ENDS_EARLY: &str = "ends early";

/// What a polygon is the border of; GSHHG's levels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Level {
    /// Land in the ocean (1), ice fronts (5).
    Land = 1,
    /// A lake in it (2).
    Lake = 2,
    /// An island in a lake (3).
    Island = 3,
    /// A pond on such an island (4).
    Pond = 4,
}

impl Level {
    /// All of them, outer ones first.
    pub const ALL: [Self; 4] = [Self::Land, Self::Lake, Self::Island, Self::Pond];

    /// The name of the layer.
    pub fn name(self) -> &'static str {
        match self {
            Self::Land => "land",
            Self::Lake => "lake",
            Self::Island => "island",
            Self::Pond => "pond",
        }
    }
}

/// A closed line; its last point is joined to its first one.
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    /// Of what.
    pub level: Level,
    /// Right and down of the tile's corner, in units of which [`Shores::extent`] span the tile.
    pub points: Vec<[i32; 2]>,
}

/// Kinds of rivers, by the ranks of CIA's World Data Bank II.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Stream {
    /// Permanent major rivers (1).
    River = 1,
    /// Additional major rivers (2).
    Tributary = 2,
}

impl Stream {
    /// All of them, great ones first.
    pub const ALL: [Self; 2] = [Self::River, Self::Tributary];

    /// Its place among them.
    pub fn index(self) -> usize {
        self as usize - 1
    }

    /// The name of the layer.
    pub fn name(self) -> &'static str {
        match self {
            Self::River => "river",
            Self::Tributary => "tributary",
        }
    }

    /// How wide such rivers are taken to be, metres. The data bank has lines without a width: made up, about that of the Danube or the Rhine for
    /// the first, of what runs into them for the second. What is wider than a kilometre is mostly a lake's polygon.
    pub fn width_m(self) -> f64 {
        match self {
            Self::River => 400.0,
            Self::Tributary => 150.0,
        }
    }

    /// What is finer does not bend such rivers, metres: bends of less than their width would make scallops of their banks.
    fn smooth_m(self) -> f64 {
        self.width_m() / 2.5
    }
}

/// The middle of a river, or a part of it.
#[derive(Debug, Clone, PartialEq)]
pub struct River {
    /// Of what kind.
    pub stream: Stream,
    /// Two or more, as a ring's.
    pub points: Vec<[i32; 2]>,
}

/// The shores in and around a tile.
#[derive(Debug, Clone, PartialEq)]
pub struct Shores {
    /// Units along a side of the tile.
    pub extent: i32,
    /// The polygons' borders.
    pub rings: Vec<Ring>,
    /// What runs through the land.
    pub rivers: Vec<River>,
}

impl Shores {
    /// Reads a tile.
    ///
    /// # Errors
    /// [`Error::BadData`] where the bytes are no such tile: they end early, their counts or commands are impossible.
    pub fn decode(what: &str, bytes: &[u8]) -> Result<Self> {
        let bad = |why: String| Error::bad_data(what, why, "a whole Mapbox Vector Tile of coasts is needed");
        read::tile(bytes).map_err(bad)
    }

    /// Whether each side of a ring of `tile` is a shore, from its first point on: those that cut a ring off at the tile's edge are none.
    fn are_shores<'a>(&self, ring: &'a Ring, tile: TileId) -> impl Iterator<Item = bool> + 'a {
        let buffer = BUFFER_TEXELS * self.extent / super::tile::TILE_TEXELS as i32;
        let across = 1u32 << tile.z;
        let cuts = [-buffer, self.extent + buffer];
        let turns = [(tile.x == 0).then_some(0), (tile.x + 1 == across).then_some(self.extent)];
        let next = ring.points.iter().skip(1).chain(ring.points.first());
        ring.points.iter().zip(next).map(move |(a, b)| {
            let on = |axis: usize, at: i32| a[axis] == at && b[axis] == at;
            !cuts.iter().any(|at| on(0, *at) || on(1, *at)) && !turns.iter().flatten().any(|at| on(0, *at))
        })
    }
}

type Read<T> = std::result::Result<T, String>;
