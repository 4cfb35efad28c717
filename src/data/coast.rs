//! Coast tiles: shores as polygons, from which water tiles are made when they load ([`field`]).
//!
//! A Mapbox Vector Tile (<https://github.com/mapbox/vector-tile-spec/tree/master/2.1>) with the layers of [`Level`], each one feature of
//! polygons, clipped to the tile and [`BUFFER_TEXELS`] beyond it. Sides that the clipping made lie on that border, and those that a map cut
//! along the antimeridian: neither are shores.
//!
//! Own code, since of protobuf it needs three hundred lines: the crates that read such tiles bring a protobuf library, whose memory for a
//! hostile tile is not bounded by us, and geometry types besides.

mod bends;
mod curve;
pub mod field;
mod sweep;
mod wire;
#[cfg(not(target_arch = "wasm32"))]
pub mod write;

use super::tile::TileId;
use crate::error::{Error, Result};
use wire::{Reader, Value};

/// PMTiles' number for this kind of tile.
pub const TILE_TYPE: u8 = 1;
/// Texels of a tile's own level by which its polygons reach over its border: as far as a water tile tells distances, and two more.
pub const BUFFER_TEXELS: i32 = 10;
/// The finest grid of coordinates that is accepted, per side of a tile.
const MAX_EXTENT: u32 = 1 << 16;
/// Points of a tile, at most: each costs work at every level that is made of it.
const MAX_POINTS: usize = 1 << 18;
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

/// The shores in and around a tile.
#[derive(Debug, Clone, PartialEq)]
pub struct Shores {
    /// Units along a side of the tile.
    pub extent: i32,
    /// The polygons' borders.
    pub rings: Vec<Ring>,
}

impl Shores {
    /// Reads a tile.
    ///
    /// # Errors
    /// [`Error::BadData`] where the bytes are no such tile: they end early, their counts or commands are impossible.
    pub fn decode(what: &str, bytes: &[u8]) -> Result<Self> {
        let bad = |why: String| Error::bad_data(what, why, "a whole Mapbox Vector Tile of coasts is needed");
        read_tile(bytes).map_err(bad)
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

fn read_tile(bytes: &[u8]) -> Read<Shores> {
    let mut shores: Option<Shores> = None;
    let mut reader = Reader::new(bytes);
    while let Some((field, value)) = reader.field()? {
        let (3, Value::Bytes(layer)) = (field, value) else { continue };
        let Some((extent, rings)) = read_layer(layer)? else { continue };
        let all = shores.get_or_insert(Shores { extent, rings: Vec::new() });
        if all.extent != extent {
            return Err(format!("has layers of {} and {extent} units", all.extent));
        }
        all.rings.extend(rings);
        let points: usize = all.rings.iter().map(|ring| ring.points.len()).sum();
        if points > MAX_POINTS {
            return Err(format!("has {points} points; at most {MAX_POINTS} are read"));
        }
    }
    Ok(shores.unwrap_or(Shores { extent: 4096, rings: Vec::new() }))
}

/// Units along a side, and the rings; `None` of a layer of another name.
fn read_layer(bytes: &[u8]) -> Read<Option<(i32, Vec<Ring>)>> {
    let (mut level, mut extent, mut features) = (None, 4096, Vec::new());
    let mut reader = Reader::new(bytes);
    while let Some((field, value)) = reader.field()? {
        match (field, value) {
            (1, Value::Bytes(name)) => level = Level::ALL.into_iter().find(|level| level.name().as_bytes() == name),
            (2, Value::Bytes(feature)) => features.push(feature),
            (5, Value::Number(units)) => extent = units,
            _ => {}
        }
    }
    let Some(level) = level else { return Ok(None) };
    let units = u32::try_from(extent).ok().filter(|units| (1..=MAX_EXTENT).contains(units));
    let extent = units.ok_or_else(|| format!("has a layer of {extent} units"))? as i32;
    let mut rings = Vec::new();
    for feature in features {
        read_feature(feature, level, extent, &mut rings)?;
    }
    Ok(Some((extent, rings)))
}

fn read_feature(bytes: &[u8], level: Level, extent: i32, rings: &mut Vec<Ring>) -> Read<()> {
    let (mut kind, mut geometry) = (0, &[][..]);
    let mut reader = Reader::new(bytes);
    while let Some((field, value)) = reader.field()? {
        match (field, value) {
            (3, Value::Number(number)) => kind = number,
            (4, Value::Bytes(commands)) => geometry = commands,
            _ => {}
        }
    }
    if kind != 3 {
        return Err(format!("has a feature of type {kind} among its polygons"));
    }
    let mut reader = Reader::new(geometry);
    let (mut at, mut points) = ([0i32; 2], Vec::new());
    let most = 4 * extent.max(256);
    while let Some(command) = reader.number_if_any()? {
        let (id, count) = (command & 7, command >> 3);
        match (id, count, points.len()) {
            (1, 1, 0) => points.push(step(&mut reader, &mut at, most)?),
            (2, 1.., 1) => {
                // Two numbers of a byte or more each: a count beyond that lies.
                if count > (reader.left() / 2) as u64 {
                    return Err(format!("says that {count} points follow in {} bytes", reader.left()));
                }
                for _ in 0..count {
                    points.push(step(&mut reader, &mut at, most)?);
                }
            }
            (7, 1, 3..) => rings.push(Ring { level, points: std::mem::take(&mut points) }),
            (id, count, drawn) => return Err(format!("has command {id} for {count} after {drawn} points of a ring")),
        }
    }
    if points.is_empty() { Ok(()) } else { Err("has a ring that is not closed".into()) }
}

fn step(reader: &mut Reader<'_>, at: &mut [i32; 2], most: i32) -> Read<[i32; 2]> {
    for place in at.iter_mut() {
        let way = reader.signed()?;
        let sum = i64::from(*place).saturating_add(way);
        if sum.unsigned_abs() > most as u64 {
            return Err(format!("has a point {sum} units from its corner"));
        }
        *place = sum as i32;
    }
    Ok(*at)
}
