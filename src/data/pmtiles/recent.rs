//! What was read of an archive a moment ago: a tile whose bytes came with its neighbours', or as another tile's, is not asked for twice.

use std::collections::VecDeque;
use std::ops::Range;

/// Bytes kept of each archive.
const BYTES_KEPT: usize = 4 << 20;

/// Reads, the one whose use is longest ago first.
#[derive(Debug, Default)]
pub(super) struct RecentReads(VecDeque<(u64, Vec<u8>)>);

impl RecentReads {
    /// The bytes of a range that lies within one read, which counts as used.
    pub(super) fn get(&mut self, range: &Range<u64>) -> Option<Vec<u8>> {
        let read = self.0.remove(self.holder(range)?)?;
        let bytes = read.1[(range.start - read.0) as usize..(range.end - read.0) as usize].to_vec();
        self.0.push_back(read);
        Some(bytes)
    }

    /// Whether a range lies within one read.
    pub(super) fn has(&self, range: &Range<u64>) -> bool {
        self.holder(range).is_some()
    }

    /// Whether any read holds a byte of a range.
    pub(super) fn has_any_of(&self, range: &Range<u64>) -> bool {
        self.0.iter().any(|read| overlaps(read, range))
    }

    /// Adds the bytes from `start`.
    pub(super) fn keep(&mut self, start: u64, bytes: &[u8]) {
        if bytes.len() <= BYTES_KEPT {
            self.0.push_back((start, bytes.to_vec()));
            while self.0.iter().map(|(_, bytes)| bytes.len()).sum::<usize>() > BYTES_KEPT {
                self.0.pop_front();
            }
        }
    }

    /// Forgets every read with bytes of a range: they were no good.
    pub(super) fn forget(&mut self, range: &Range<u64>) {
        self.0.retain(|read| !overlaps(read, range));
    }

    fn holder(&self, range: &Range<u64>) -> Option<usize> {
        self.0.iter().position(|(start, bytes)| *start <= range.start && range.end <= start + bytes.len() as u64)
    }
}

fn overlaps((start, bytes): &(u64, Vec<u8>), range: &Range<u64>) -> bool {
    range.start < start + bytes.len() as u64 && *start < range.end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_serve_what_lies_within_them_until_they_are_forgotten_or_too_many() {
        let mut recent = RecentReads::default();
        recent.keep(100, &[1, 2, 3, 4]);
        recent.keep(104, &[5]);
        assert_eq!(recent.get(&(101..103)), Some(vec![2, 3]));
        // Two reads together are none.
        assert!(!recent.has(&(103..105)) && !recent.has(&(99..101)) && recent.has(&(104..105)));
        assert!(recent.has_any_of(&(104..200)) && !recent.has_any_of(&(105..200)) && !recent.has_any_of(&(90..100)));
        recent.forget(&(98..101));
        assert!(recent.get(&(101..103)).is_none() && recent.has(&(104..105)));

        recent.keep(1000, &vec![7; BYTES_KEPT - 2]);
        recent.get(&(104..105));
        // The larger one was used longer ago.
        recent.keep(0, &[8, 8]);
        assert!(recent.has(&(104..105)) && recent.has(&(0..2)) && !recent.has(&(1000..1001)));
        recent.keep(0, &vec![9; BYTES_KEPT + 1]);
        assert!(!recent.has(&(5..6)));
    }
}
