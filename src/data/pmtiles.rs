//! PMTiles v3: one file that holds a whole tile pyramid, read by byte ranges.
//!
//! Specification: <https://github.com/protomaps/PMTiles/blob/main/spec/v3/spec.md>. Layout: a header of 127 bytes, the
//! root directory (both within the first 16 KiB), JSON metadata, leaf directories, tiles. A directory lists runs of tile
//! ids, numbered along a Hilbert curve, level after level.
//!
//! [`Archive`] reads (gzip or no compression, any depth of leaves up to [`MAX_DEPTH`], clustered or not).
//! Natively, `write::ArchiveWriter` writes clustered archives, the same bytes for the same tiles.

mod directory;
mod recent;
#[cfg(not(target_arch = "wasm32"))]
pub mod write;

pub use directory::{Entry, decode_directory, encode_directory, id_from_zxy, zxy_from_id};

use crate::error::{Error, Result};
use recent::RecentReads;
use std::collections::VecDeque;
use std::io::Read as _;
use std::ops::Range;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Length of the header, bytes.
pub const HEADER_BYTES: usize = 127;
/// The header and the root directory lie within this many bytes from the start.
pub const ROOT_LIMIT: usize = 16_384;
/// Bytes that are read first: header, root directory and metadata of each bundled archive lie within them (5,612 of the largest).
pub const HEAD_BYTES: u64 = 6_144;
/// Leaf directories that end before this many bytes from the start are read when the archive is opened.
const LEAVES_AT_ONCE: u64 = 64 << 10;
/// Root and leaves that a look-up passes at most.
pub const MAX_DEPTH: usize = 4;
/// The largest directory or metadata accepted as stored, bytes.
const MAX_STORED: u64 = 8 << 20;
/// The largest directory or metadata accepted once inflated, bytes.
const MAX_INFLATED: u64 = 64 << 20;
/// Entries of all directories that are read at once, at most.
const MAX_ENTRIES: usize = 1 << 22;
/// The largest tile accepted, bytes.
const MAX_TILE: u64 = 8 << 20;
/// Leaf directories kept in memory.
const LEAVES_KEPT: usize = 16;

/// Where the bytes of an archive come from.
#[allow(async_fn_in_trait, reason = "used with concrete sources only, so that Send follows from the source")]
pub trait ByteSource {
    /// The bytes from `offset`, `length` of them, or fewer where the archive ends before.
    ///
    /// # Errors
    /// [`Error::Io`], [`Error::Fetch`]: what the system or the server says.
    async fn read(&self, offset: u64, length: u64) -> Result<Vec<u8>>;

    /// The file or URL, for messages.
    fn name(&self) -> &str;
}

/// How bytes inside an archive are packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compression {
    /// As they are.
    None,
    /// gzip.
    Gzip,
}

impl Compression {
    fn from_byte(byte: u8) -> std::result::Result<Self, String> {
        match byte {
            1 => Ok(Self::None),
            2 => Ok(Self::Gzip),
            0 => Err("does not say how it is compressed".into()),
            3 => Err("is compressed with brotli".into()),
            4 => Err("is compressed with zstd".into()),
            other => Err(format!("has the unknown compression {other}")),
        }
    }
}

/// The fields of the header that matter for reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Header {
    /// (offset, length) of the root directory, bytes.
    pub root: (u64, u64),
    /// (offset, length) of the JSON metadata, bytes.
    pub metadata: (u64, u64),
    /// (offset, length) of all leaf directories, bytes.
    pub leaves: (u64, u64),
    /// (offset, length) of all tiles, bytes.
    pub data: (u64, u64),
    /// How directories and metadata are packed.
    pub internal_compression: Compression,
    /// How tiles are packed, beyond their own format.
    pub tile_compression: Compression,
    /// 1 is a vector tile, 2 PNG, 3 JPEG.
    pub tile_type: u8,
    /// The coarsest level.
    pub min_zoom: u8,
    /// The deepest level.
    pub max_zoom: u8,
}

impl Header {
    /// Reads the header.
    ///
    /// # Errors
    /// [`Error::BadData`]: too short, another format or version, sections that overflow.
    pub fn parse(what: &str, bytes: &[u8]) -> Result<Self> {
        let bad = |why: String| bad_archive(what, why);
        let Some(head) = bytes.get(..HEADER_BYTES) else {
            return Err(bad(format!("ends after {} bytes", bytes.len())));
        };
        if &head[..7] != b"PMTiles" {
            return Err(bad("does not start with `PMTiles`".into()));
        }
        if head[7] != 3 {
            return Err(bad(format!("has version {}", head[7])));
        }
        let word = |at: usize| u64::from_le_bytes(std::array::from_fn(|i| head[at + i]));
        let section = |at: usize, name: &str| {
            let (offset, length) = (word(at), word(at + 8));
            let end = offset.checked_add(length).ok_or_else(|| bad(format!("has an impossible {name} section")))?;
            if end > 1 << 53 { Err(bad(format!("has an impossible {name} section"))) } else { Ok((offset, length)) }
        };
        let (min_zoom, max_zoom) = (head[100], head[101]);
        if min_zoom > max_zoom || max_zoom > super::tile::MAX_ZOOM {
            return Err(bad(format!("has levels {min_zoom} to {max_zoom}")));
        }
        Ok(Self {
            root: section(8, "root")?,
            metadata: section(24, "metadata")?,
            leaves: section(40, "leaf")?,
            data: section(56, "tile")?,
            internal_compression: Compression::from_byte(head[97]).map_err(bad)?,
            tile_compression: Compression::from_byte(head[98]).map_err(bad)?,
            tile_type: head[99],
            min_zoom,
            max_zoom,
        })
    }
}

/// An archive that is open for reading.
#[derive(Debug)]
pub struct Archive<S> {
    source: S,
    header: Header,
    metadata: serde_json::Map<String, serde_json::Value>,
    root: Vec<Entry>,
    /// The most recently used leaf last; keyed by offset.
    leaves: Mutex<VecDeque<(u64, Arc<Vec<Entry>>)>>,
    recent: Mutex<RecentReads>,
}

impl<S: ByteSource> Archive<S> {
    /// Reads the header, the root directory and the metadata.
    ///
    /// # Errors
    /// What the source reports, and [`Error::BadData`] where the bytes are no PMTiles v3 archive.
    pub async fn open(source: S) -> Result<Self> {
        let what = source.name().to_owned();
        let mut start = source.read(0, HEAD_BYTES).await?;
        let header = Header::parse(&what, &start)?;
        // The rest of the usual order, root directory, metadata and few leaves, in one request.
        let end = |sections: &[(u64, u64)]| sections.iter().map(|(at, length)| at + length).max().unwrap_or(0);
        let all = end(&[header.root, header.metadata, header.leaves]);
        let at_once = header.leaves.1 > 0 && all <= LEAVES_AT_ONCE;
        let end = if at_once { all } else { end(&[header.root, header.metadata]) };
        if start.len() as u64 == HEAD_BYTES && (HEAD_BYTES..=LEAVES_AT_ONCE).contains(&end) {
            start.extend(read_exactly(&source, HEAD_BYTES, end - HEAD_BYTES).await?);
        }
        let packing = header.internal_compression;
        let section = async |(offset, length): (u64, u64), name: &str| {
            if length > MAX_STORED {
                return Err(bad_archive(&what, format!("has a {name} of {length} bytes")));
            }
            let stored = match start.get(offset as usize..offset.saturating_add(length) as usize) {
                Some(bytes) => bytes.to_vec(),
                None => read_exactly(&source, offset, length).await?,
            };
            unpack(&what, packing, stored, MAX_INFLATED)
        };
        let mut root = decode_directory(&what, &section(header.root, "root directory").await?)?;
        if at_once && root.iter().all(|entry| entry.run_length == 0) {
            // With all leaves at hand every tile's place is known, and neighbours are fetched together.
            let mut entries = Vec::new();
            for leaf in root {
                let at = within(&what, header.leaves, leaf)?;
                entries.extend(decode_directory(&what, &section((at, leaf.length.into()), "leaf directory").await?)?);
                // Root entries may all name one leaf.
                if entries.len() > MAX_ENTRIES {
                    return Err(bad_archive(&what, format!("has more than {MAX_ENTRIES} tiles in its directories")));
                }
            }
            root = entries;
        }
        let metadata = match header.metadata.1 {
            0 => serde_json::Map::new(),
            _ => serde_json::from_slice(&section(header.metadata, "metadata").await?)
                .map_err(|e| bad_archive(&what, format!("has metadata that are no JSON object ({e})")))?,
        };
        Ok(Self { source, header, metadata, root, leaves: Mutex::default(), recent: Mutex::default() })
    }

    /// The header.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The JSON metadata.
    pub fn metadata(&self) -> &serde_json::Map<String, serde_json::Value> {
        &self.metadata
    }

    /// Where a tile lies in the archive, bytes; `None` where only a leaf directory can tell, or a broken archive says nothing of use.
    pub fn place(&self, z: u8, x: u32, y: u32) -> Option<Range<u64>> {
        let entry = directory::find(&self.root, id_from_zxy(z, x, y)?).filter(|entry| entry.run_length > 0)?;
        let length = u64::from(entry.length);
        let offset = within(self.source.name(), self.header.data, entry).ok()?;
        (length <= MAX_TILE).then_some(offset..offset + length)
    }

    /// The bytes of some tiles from one read of all of `span`, inflated where the archive packs them. `places` lie within it.
    ///
    /// # Errors
    /// As [`Archive::tile`].
    pub async fn tiles(&self, span: Range<u64>, places: &[Range<u64>]) -> Result<Vec<Vec<u8>>> {
        let bytes = self.read_tiles(&span).await?;
        let part = |place: &Range<u64>| {
            let [from, to] = [place.start, place.end].map(|at| (at - span.start) as usize);
            unpack(self.source.name(), self.header.tile_compression, bytes[from..to].to_vec(), MAX_TILE)
        };
        places.iter().map(part).collect()
    }

    /// The bytes of a tile, inflated where the archive packs them; `None` where the archive has no such tile.
    ///
    /// # Errors
    /// What the source reports, and [`Error::BadData`] where the directories are broken.
    pub async fn tile(&self, z: u8, x: u32, y: u32) -> Result<Option<Vec<u8>>> {
        let what = self.source.name();
        let Some(id) = id_from_zxy(z, x, y) else { return Ok(None) };
        let mut leaf: Option<Arc<Vec<Entry>>> = None;
        for _ in 0..MAX_DEPTH {
            let entries = leaf.as_deref().map_or(&self.root[..], |leaf| &leaf[..]);
            let Some(entry) = directory::find(entries, id) else { return Ok(None) };
            if entry.run_length > 0 {
                let length = u64::from(entry.length);
                if length > MAX_TILE {
                    return Err(bad_archive(what, format!("has a tile {z}/{x}/{y} of {length} bytes")));
                }
                let offset = within(what, self.header.data, entry)?;
                let stored = self.read_tiles(&(offset..offset + length)).await?;
                return unpack(what, self.header.tile_compression, stored, MAX_TILE).map(Some);
            }
            leaf = Some(self.leaf(entry).await?);
        }
        Err(bad_archive(what, format!("has directories nested deeper than {MAX_DEPTH}")))
    }

    /// Whether these bytes are at hand without asking the source.
    pub fn has(&self, place: &Range<u64>) -> bool {
        self.recent().has(place)
    }

    /// Whether any of these bytes is at hand.
    pub fn has_any_of(&self, place: &Range<u64>) -> bool {
        self.recent().has_any_of(place)
    }

    /// Gives up bytes that turned out to be no good: the next look at them asks the source again.
    pub fn forget(&self, place: &Range<u64>) {
        self.recent().forget(place);
    }

    async fn read_tiles(&self, span: &Range<u64>) -> Result<Vec<u8>> {
        if let Some(bytes) = self.recent().get(span) {
            return Ok(bytes);
        }
        let bytes = read_exactly(&self.source, span.start, span.end - span.start).await?;
        self.recent().keep(span.start, &bytes);
        Ok(bytes)
    }

    fn recent(&self) -> MutexGuard<'_, RecentReads> {
        self.recent.lock().unwrap_or_else(PoisonError::into_inner)
    }

    async fn leaf(&self, entry: Entry) -> Result<Arc<Vec<Entry>>> {
        let what = self.source.name();
        let offset = within(what, self.header.leaves, entry)?;
        if let Some(found) = self.kept_leaf(offset, None) {
            return Ok(found);
        }
        if u64::from(entry.length) > MAX_STORED {
            return Err(bad_archive(what, format!("has a leaf directory of {} bytes", entry.length)));
        }
        let stored = read_exactly(&self.source, offset, u64::from(entry.length)).await?;
        let bytes = unpack(what, self.header.internal_compression, stored, MAX_INFLATED)?;
        let leaf = Arc::new(decode_directory(what, &bytes)?);
        Ok(self.kept_leaf(offset, Some(leaf.clone())).unwrap_or(leaf))
    }

    /// Looks a leaf up and marks it as used; with `new`, adds it where it is not there yet.
    fn kept_leaf(&self, offset: u64, new: Option<Arc<Vec<Entry>>>) -> Option<Arc<Vec<Entry>>> {
        let mut leaves = self.leaves.lock().unwrap_or_else(PoisonError::into_inner);
        let found = leaves.iter().position(|(at, _)| *at == offset).and_then(|i| leaves.remove(i));
        let kept = found.map(|(_, leaf)| leaf).or(new)?;
        leaves.push_back((offset, kept.clone()));
        if leaves.len() > LEAVES_KEPT {
            leaves.pop_front();
        }
        Some(kept)
    }
}

fn bad_archive(what: &str, why: String) -> Error {
    Error::bad_data(what, why, "a whole, undamaged PMTiles version 3 archive is needed")
}

/// The absolute offset of an entry's bytes, which must lie within their section.
fn within(what: &str, (start, length): (u64, u64), entry: Entry) -> Result<u64> {
    let end = entry.offset.checked_add(u64::from(entry.length));
    if end.is_none_or(|end| end > length) {
        return Err(bad_archive(what, format!("has an entry at {} that lies outside its section", entry.offset)));
    }
    Ok(start + entry.offset)
}

async fn read_exactly(source: &impl ByteSource, offset: u64, length: u64) -> Result<Vec<u8>> {
    let bytes = source.read(offset, length).await?;
    if bytes.len() as u64 != length {
        let why = format!("is cut short: {} of {length} bytes at offset {offset}", bytes.len());
        return Err(bad_archive(source.name(), why));
    }
    Ok(bytes)
}

fn unpack(what: &str, packing: Compression, stored: Vec<u8>, limit: u64) -> Result<Vec<u8>> {
    if packing == Compression::None {
        return Ok(stored);
    }
    let mut bytes = Vec::new();
    let mut inflated = flate2::read::GzDecoder::new(&stored[..]).take(limit + 1);
    inflated.read_to_end(&mut bytes).map_err(|e| bad_archive(what, format!("has broken gzip data ({e})")))?;
    if bytes.len() as u64 > limit {
        return Err(bad_archive(what, format!("has gzip data that inflate to more than {limit} bytes")));
    }
    Ok(bytes)
}
