//! Writing a PMTiles v3 archive: clustered, identical tiles stored once, the same bytes for the same tiles.
//!
//! Tiles wait in a file next to the archive; the archive appears under its name only when it is whole.

use super::{Entry, HEADER_BYTES, ROOT_LIMIT, encode_directory, id_from_zxy, zxy_from_id};
use crate::error::{Error, Result};
use flate2::{Compression, GzBuilder};
use std::collections::{BTreeMap, HashMap};
use std::fs::{self, File};
use std::io::{BufReader, BufWriter, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

/// Collects tiles in any order, then writes the archive.
#[derive(Debug)]
pub struct ArchiveWriter {
    path: PathBuf,
    spool_path: PathBuf,
    spool: Option<BufWriter<File>>,
    spooled: u64,
    /// Where the bytes of a tile wait, by tile id: (offset in the spool, length).
    tiles: BTreeMap<u64, (u64, u32)>,
    /// Contents by their hash: candidates for being the same bytes.
    contents: HashMap<u64, Vec<(u64, u32)>>,
}

impl ArchiveWriter {
    /// Starts an archive that will appear at `path`.
    ///
    /// # Errors
    /// [`Error::Io`] where the folder cannot be written to.
    pub fn create(path: &Path) -> Result<Self> {
        let spool_path = with_suffix(path, ".tiles.part");
        let file = File::options().read(true).write(true).create(true).truncate(true).open(&spool_path);
        let spool = Some(BufWriter::new(file.map_err(|e| failed(&spool_path, e))?));
        let (tiles, contents) = (BTreeMap::new(), HashMap::new());
        Ok(Self { path: path.to_owned(), spool_path, spool, spooled: 0, tiles, contents })
    }

    /// Adds a tile; the last one wins where it is added twice.
    ///
    /// # Errors
    /// [`Error::BadData`] off the map or for an empty tile, [`Error::Io`].
    pub fn add(&mut self, z: u8, x: u32, y: u32, bytes: &[u8]) -> Result<()> {
        let impossible =
            |why| Error::bad_data(format!("tile {z}/{x}/{y}"), why, "tiles lie on the map and are not empty");
        let id = id_from_zxy(z, x, y).ok_or_else(|| impossible("lies off the map"))?;
        let length =
            u32::try_from(bytes.len()).ok().filter(|n| *n > 0).ok_or_else(|| impossible("has no usable length"))?;
        let hash = fnv1a(bytes);
        let known = self.contents.get(&hash).into_iter().flatten().copied().collect::<Vec<_>>();
        for (offset, known_length) in known {
            if known_length == length && self.spooled_bytes(offset, length)? == bytes {
                self.tiles.insert(id, (offset, length));
                return Ok(());
            }
        }
        if let Some(spool) = &mut self.spool {
            spool.write_all(bytes).map_err(|e| failed(&self.spool_path, e))?;
        }
        self.tiles.insert(id, (self.spooled, length));
        self.contents.entry(hash).or_default().push((self.spooled, length));
        self.spooled += u64::from(length);
        Ok(())
    }

    /// Writes the archive and puts it in place. Returns its size in bytes. What the tiles are, the metadata's `format` tells: `jpg`,
    /// `pbf` (packed with gzip by whoever adds them), else PNG.
    ///
    /// # Errors
    /// [`Error::BadData`] without tiles, [`Error::Io`].
    pub fn finish(mut self, metadata: &serde_json::Value) -> Result<u64> {
        let Some((levels, centre_zoom)) = self.levels() else {
            return Err(Error::bad_data(self.path.display().to_string(), "has no tiles", "add at least one"));
        };
        let (packing, tile_type) = match metadata["format"].as_str() {
            Some("jpg") => (1, 3),
            Some("pbf") => (2, 1),
            _ => (1, 2),
        };
        let (entries, order) = self.cluster();
        let (root, leaves) = pack_directories(&entries)?;
        let metadata = gzip(metadata.to_string().as_bytes())?;
        let data_length: u64 = order.iter().map(|(_, length)| u64::from(*length)).sum();
        let mut at = HEADER_BYTES as u64;
        let mut section = |length: u64| {
            at += length;
            [at - length, length]
        };
        let sections = [
            section(root.len() as u64),
            section(metadata.len() as u64),
            section(leaves.len() as u64),
            section(data_length),
        ];
        let mut header = Vec::with_capacity(HEADER_BYTES);
        header.extend(b"PMTiles\x03");
        sections.as_flattened().iter().for_each(|word| header.extend(word.to_le_bytes()));
        for count in [self.tiles.len() as u64, entries.len() as u64, order.len() as u64] {
            header.extend(count.to_le_bytes());
        }
        // Clustered, gzip directories, how tiles are packed, their type; then bounds in 1e-7 degrees: the whole world.
        header.extend([1, 2, packing, tile_type, levels.0, levels.1]);
        [-1_800_000_000i32, -900_000_000, 1_800_000_000, 900_000_000]
            .iter()
            .for_each(|b| header.extend(b.to_le_bytes()));
        header.push(centre_zoom);
        header.extend([0; 8]);

        let part = with_suffix(&self.path, ".part");
        let write = |e| failed(&part, e);
        let mut out = BufWriter::new(File::create(&part).map_err(write)?);
        for bytes in [&header, &root, &metadata, &leaves] {
            out.write_all(bytes).map_err(write)?;
        }
        for (offset, length) in order {
            let bytes = self.spooled_bytes(offset, length)?;
            out.write_all(&bytes).map_err(write)?;
        }
        let file = out.into_inner().map_err(|e| write(e.into_error()))?;
        file.sync_all().map_err(write)?;
        fs::rename(&part, &self.path).map_err(|e| failed(&self.path, e))?;
        Ok(at)
    }

    /// ((coarsest, deepest level), level to start at); `None` without tiles.
    fn levels(&self) -> Option<((u8, u8), u8)> {
        let level = |id: &u64| zxy_from_id(*id).map(|(z, ..)| z);
        let (first, last) = (level(self.tiles.keys().next()?)?, level(self.tiles.keys().next_back()?)?);
        Some(((first, last), first))
    }

    /// The directory entries in the order of ids, and the contents in the order in which they are stored.
    fn cluster(&self) -> (Vec<Entry>, Vec<(u64, u32)>) {
        let mut entries: Vec<Entry> = Vec::new();
        let mut order = Vec::new();
        let mut placed: HashMap<u64, u64> = HashMap::new();
        let mut end = 0u64;
        for (&id, &(spooled_at, length)) in &self.tiles {
            let offset = *placed.entry(spooled_at).or_insert_with(|| {
                order.push((spooled_at, length));
                end += u64::from(length);
                end - u64::from(length)
            });
            match entries.last_mut() {
                Some(last) if last.id + u64::from(last.run_length) == id && last.offset == offset => {
                    last.run_length += 1
                }
                _ => entries.push(Entry { id, offset, length, run_length: 1 }),
            }
        }
        (entries, order)
    }

    fn spooled_bytes(&mut self, offset: u64, length: u32) -> Result<Vec<u8>> {
        let path = &self.spool_path;
        let Some(spool) = &mut self.spool else { return Ok(Vec::new()) };
        spool.flush().map_err(|e| failed(path, e))?;
        let mut file = BufReader::with_capacity(length as usize, spool.get_ref());
        let mut bytes = vec![0; length as usize];
        file.seek(SeekFrom::Start(offset)).map_err(|e| failed(path, e))?;
        file.read_exact(&mut bytes).map_err(|e| failed(path, e))?;
        spool.seek(SeekFrom::End(0)).map_err(|e| failed(path, e))?;
        Ok(bytes)
    }
}

impl Drop for ArchiveWriter {
    fn drop(&mut self) {
        self.spool = None;
        // Both are gone already where all went well; a leftover does no harm beyond its size.
        let _ = fs::remove_file(&self.spool_path);
        let _ = fs::remove_file(with_suffix(&self.path, ".part"));
    }
}

/// The root directory, and the leaf directories where the root alone would not fit into the first 16 KiB.
fn pack_directories(entries: &[Entry]) -> Result<(Vec<u8>, Vec<u8>)> {
    let fits = |root: &[u8]| HEADER_BYTES + root.len() <= ROOT_LIMIT;
    let root = gzip(&encode_directory(entries))?;
    if fits(&root) {
        return Ok((root, Vec::new()));
    }
    let mut leaf_entries = 4096;
    loop {
        let (mut pointers, mut leaves) = (Vec::new(), Vec::new());
        for chunk in entries.chunks(leaf_entries) {
            let leaf = gzip(&encode_directory(chunk))?;
            pointers.push(Entry {
                id: chunk[0].id,
                offset: leaves.len() as u64,
                length: leaf.len() as u32,
                run_length: 0,
            });
            leaves.extend(leaf);
        }
        let root = gzip(&encode_directory(&pointers))?;
        if fits(&root) {
            return Ok((root, leaves));
        }
        leaf_entries *= 2;
    }
}

/// Bytes packed with gzip, the same for the same bytes.
///
/// # Errors
/// [`Error::Io`] where memory lacks.
pub fn gzip(bytes: &[u8]) -> Result<Vec<u8>> {
    // A fixed time and system, so that the same input gives the same bytes everywhere.
    let mut encoder = GzBuilder::new().mtime(0).operating_system(255).write(Vec::new(), Compression::best());
    let packed = encoder.write_all(bytes).and_then(|()| encoder.finish());
    packed.map_err(|e| Error::io("gzip", e, "this needs memory only: free some"))
}

fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3))
}

fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    name.into()
}

fn failed(path: &Path, error: std::io::Error) -> Error {
    Error::io(path.display().to_string(), error, "check that the folder exists, is writable and has room")
}
