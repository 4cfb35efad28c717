//! PMTiles directories and tile ids.

use super::bad_archive;
use crate::error::Result;

/// One line of a directory: a run of tiles that share their bytes, or (with `run_length` 0) a leaf directory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Entry {
    /// The first tile id.
    pub id: u64,
    /// Bytes from the start of the section (tiles or leaves).
    pub offset: u64,
    /// Length in bytes.
    pub length: u32,
    /// How many consecutive ids this entry answers for; 0: it is a leaf directory.
    pub run_length: u32,
}

/// The tile id: all tiles of the coarser levels, plus the place on the Hilbert curve of this level. `None` off the map.
pub fn id_from_zxy(z: u8, x: u32, y: u32) -> Option<u64> {
    if z > 31 || x >> z != 0 || y >> z != 0 {
        return None;
    }
    let coarser = ((1u64 << (2 * z)) - 1) / 3;
    let (mut x, mut y, mut along) = (x, y, 0u64);
    for bit in (0..z).rev() {
        let s = 1u32 << bit;
        let (right, lower) = (u32::from(x & s != 0), u32::from(y & s != 0));
        along += (u64::from(s) * u64::from(s)) * u64::from((3 * right) ^ lower);
        (x, y) = rotate(s, x, y, right, lower);
    }
    Some(coarser + along)
}

/// (z, x, y) of a tile id, `None` beyond level 31.
pub fn zxy_from_id(id: u64) -> Option<(u8, u32, u32)> {
    let (mut z, mut rest) = (0u8, id);
    while rest >= 1u64 << (2 * z) {
        rest -= 1u64 << (2 * z);
        z += 1;
        if z > 31 {
            return None;
        }
    }
    let (mut x, mut y) = (0u32, 0u32);
    for bit in 0..z {
        let s = 1u32 << bit;
        let right = (rest >> 1) as u32 & 1;
        let lower = (rest as u32 ^ right) & 1;
        (x, y) = rotate(s, x, y, right, lower);
        x += s * right;
        y += s * lower;
        rest >>= 2;
    }
    Some((z, x, y))
}

fn rotate(s: u32, x: u32, y: u32, right: u32, lower: u32) -> (u32, u32) {
    if lower != 0 {
        return (x, y);
    }
    // Only the bits below s matter: the others are used up, or not set yet.
    let flip = |v: u32| if right == 1 { (s - 1).wrapping_sub(v) & (s - 1) } else { v };
    let (x, y) = (flip(x), flip(y));
    (y, x)
}

/// Reads an inflated directory.
///
/// # Errors
/// [`crate::error::Error::BadData`]: cut short, numbers that overflow, more entries than bytes, ids that do not rise.
pub fn decode_directory(what: &str, bytes: &[u8]) -> Result<Vec<Entry>> {
    let bad = |why: &str| bad_archive(what, format!("has a broken directory: {why}"));
    let mut rest = bytes;
    let mut next = || varint(&mut rest).ok_or_else(|| bad("it ends early or a number overflows"));
    let count = next()?;
    // Every entry takes at least four bytes, so a lying count costs no memory.
    if count > bytes.len() as u64 / 4 {
        return Err(bad("it cannot hold as many entries as it says"));
    }
    let mut entries = vec![Entry { id: 0, offset: 0, length: 0, run_length: 0 }; count as usize];
    let mut id = 0u64;
    for (i, entry) in entries.iter_mut().enumerate() {
        let step = next()?;
        if i > 0 && step == 0 {
            return Err(bad("its ids do not rise"));
        }
        id = id.checked_add(step).ok_or_else(|| bad("an id overflows"))?;
        entry.id = id;
    }
    for entry in &mut entries {
        entry.run_length = u32::try_from(next()?).map_err(|_| bad("a run is too long"))?;
    }
    for entry in &mut entries {
        entry.length = u32::try_from(next()?).map_err(|_| bad("a length is too large"))?;
        if entry.length == 0 {
            return Err(bad("an entry has no bytes"));
        }
    }
    let mut follows = None;
    for entry in &mut entries {
        let stored = next()?;
        entry.offset = match (stored, follows) {
            (0, Some(end)) => end,
            (0, None) => return Err(bad("its first offset is missing")),
            (offset, _) => offset - 1,
        };
        follows = Some(entry.offset.checked_add(u64::from(entry.length)).ok_or_else(|| bad("an offset overflows"))?);
    }
    Ok(entries)
}

/// The bytes of a directory, before compression. Ids must rise.
pub fn encode_directory(entries: &[Entry]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut put = |mut value: u64| {
        while value >= 0x80 {
            bytes.push(value as u8 | 0x80);
            value >>= 7;
        }
        bytes.push(value as u8);
    };
    put(entries.len() as u64);
    let mut previous = 0;
    for entry in entries {
        put(entry.id - previous);
        previous = entry.id;
    }
    entries.iter().for_each(|entry| put(u64::from(entry.run_length)));
    entries.iter().for_each(|entry| put(u64::from(entry.length)));
    let mut follows = None;
    for entry in entries {
        put(if follows == Some(entry.offset) { 0 } else { entry.offset + 1 });
        follows = Some(entry.offset + u64::from(entry.length));
    }
    bytes
}

/// The entry that answers for `id`: a run that contains it, or the leaf where it would be.
pub(super) fn find(entries: &[Entry], id: u64) -> Option<Entry> {
    let after = entries.partition_point(|entry| entry.id <= id);
    let entry = *entries.get(after.checked_sub(1)?)?;
    (entry.run_length == 0 || id - entry.id < u64::from(entry.run_length)).then_some(entry)
}

fn varint(rest: &mut &[u8]) -> Option<u64> {
    let mut value = 0u64;
    for shift in (0..64).step_by(7) {
        let (&byte, tail) = rest.split_first()?;
        *rest = tail;
        if shift == 63 && byte > 1 {
            return None;
        }
        value |= u64::from(byte & 0x7f) << shift;
        if byte & 0x80 == 0 {
            return Some(value);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_those_of_the_specification() {
        // The examples of the specification, section 4.1.1 "Tile ID".
        for (zxy, id) in [
            ((0, 0, 0), 0),
            ((1, 0, 0), 1),
            ((1, 0, 1), 2),
            ((1, 1, 1), 3),
            ((1, 1, 0), 4),
            ((2, 0, 0), 5),
            ((12, 3423, 1763), 19_078_479),
        ] {
            assert_eq!(id_from_zxy(zxy.0, zxy.1, zxy.2), Some(id), "{zxy:?}");
            assert_eq!(zxy_from_id(id), Some(zxy));
        }
        assert_eq!(id_from_zxy(3, 8, 0), None);
        for id in 0..21_845 {
            let (z, x, y) = zxy_from_id(id).unwrap();
            assert_eq!(id_from_zxy(z, x, y), Some(id));
        }
    }

    #[test]
    fn directories_round_trip() {
        let entry = |id, offset, length, run_length| Entry { id, offset, length, run_length };
        let entries = [entry(0, 0, 10, 1), entry(1, 10, 300, 5), entry(9, 0, 10, 1), entry(1 << 40, 310, 70_000, 0)];
        assert_eq!(decode_directory("x", &encode_directory(&entries)).unwrap(), entries);
        assert_eq!(find(&entries, 5).unwrap().id, 1);
        assert_eq!(find(&entries, 6), None);
        assert_eq!(find(&entries, 1 << 41).unwrap().length, 70_000);
    }
}
