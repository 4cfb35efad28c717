//! Neighbouring tiles of an archive, fetched in one request.
//!
//! An archive holds the tiles of a level along a Hilbert curve, and tiles of the same content once: what is seen together often lies
//! together.

use super::answer::{decoded, load};
use super::{Decoded, Key};
use crate::data::fetch::Source;
use crate::data::pmtiles::Archive;
use crate::error::Result;
use std::ops::Range;

/// Bytes between two tiles that are fetched for nothing rather than asked for apart: what a request costs in headers and time.
const GAP: u64 = 16 << 10;
/// Tiles of one request at most: they are decoded one after the other.
const MOST_TILES: usize = 12;
/// Bytes of one request at most.
const MOST_BYTES: u64 = 1 << 20;

/// One wish: which tile, its rank among all, and where it lies in its archive, if that is known.
pub(super) struct Wish {
    /// The archive.
    pub(super) slot: usize,
    /// The tile.
    pub(super) key: Key,
    /// Level and number of the wish: the smallest comes first.
    pub(super) rank: (u8, u64),
    /// Bytes of the archive.
    pub(super) place: Option<Range<u64>>,
}

/// Wishes that one request answers.
pub(super) struct Span {
    bytes: Range<u64>,
    /// In the order of their places; never empty.
    pub(super) wishes: Vec<Wish>,
}

impl From<Wish> for Span {
    fn from(wish: Wish) -> Self {
        Self { bytes: wish.place.clone().unwrap_or(0..0), wishes: vec![wish] }
    }
}

impl Span {
    fn takes(&self, wish: &Wish, known: impl Fn(usize, &Range<u64>) -> bool) -> bool {
        let Some(place) = &wish.place else { return false };
        self.wishes[0].slot == wish.slot
            && self.wishes[0].place.is_some()
            && place.start <= self.bytes.end + GAP
            && place.end.max(self.bytes.end) - self.bytes.start <= MOST_BYTES
            && self.wishes.len() < MOST_TILES
            && !(self.bytes.end < place.start && known(wish.slot, &(self.bytes.end..place.start)))
    }

    /// The archive.
    pub(super) fn slot(&self) -> usize {
        self.wishes[0].slot
    }

    /// What is fetched.
    pub(super) fn bytes(&self) -> &Range<u64> {
        &self.bytes
    }

    /// The rank of its first wish.
    pub(super) fn rank(&self) -> (u8, u64) {
        self.wishes.iter().map(|wish| wish.rank).min().unwrap_or_default()
    }
}

/// The requests that have no answer yet: archives, and bytes of them.
#[derive(Default)]
pub(super) struct OnTheWay(Vec<(usize, Range<u64>)>);

impl OnTheWay {
    /// How many.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Adds a request.
    pub(super) fn add(&mut self, slot: usize, bytes: Range<u64>) {
        self.0.push((slot, bytes));
    }

    /// Takes out a request that is over.
    pub(super) fn over(&mut self, slot: usize, bytes: &Range<u64>) {
        if let Some(request) = self.0.iter().position(|(other, same)| (*other, same) == (slot, bytes)) {
            self.0.swap_remove(request);
        }
    }

    /// Whether one request brings all of a place.
    pub(super) fn brings(&self, slot: usize, place: &Range<u64>) -> bool {
        self.of(slot).any(|bytes| bytes.start <= place.start && place.end <= bytes.end)
    }

    /// Whether any request brings some of a place.
    pub(super) fn brings_any_of(&self, slot: usize, place: &Range<u64>) -> bool {
        self.of(slot).any(|bytes| bytes.start < place.end && place.start < bytes.end)
    }

    fn of(&self, slot: usize) -> impl Iterator<Item = &Range<u64>> {
        self.0.iter().filter(move |(other, _)| *other == slot).map(|(_, bytes)| bytes)
    }
}

/// The requests that answer some wishes, the most urgent first. None bridges a gap in which bytes of an archive are `known`.
pub(super) fn spans(mut wishes: Vec<Wish>, known: impl Fn(usize, &Range<u64>) -> bool) -> Vec<Span> {
    wishes.sort_by_key(|wish| (wish.slot, wish.place.as_ref().map(|place| (place.start, place.end)), wish.rank));
    let mut spans: Vec<Span> = Vec::new();
    for wish in wishes {
        match spans.last_mut().filter(|span| span.takes(&wish, &known)) {
            Some(span) => {
                span.bytes.end = span.bytes.end.max(wish.place.as_ref().map_or(0, |place| place.end));
                span.wishes.push(wish);
            }
            None => spans.push(wish.into()),
        }
    }
    spans.sort_by_key(Span::rank);
    spans
}

/// Fetches a span and hands over what came of each of its tiles. Where the whole span cannot be had each tile is tried on its own, so that
/// one of them never holds up the others.
pub(super) async fn fetch(
    archive: &Archive<Source>,
    span: Span,
    mut hand_over: impl FnMut(Key, Result<Option<Decoded>>),
) {
    let places: Vec<_> = span.wishes.iter().filter_map(|wish| wish.place.clone()).collect();
    if span.wishes.len() > 1
        && let Ok(tiles) = archive.tiles(span.bytes, &places).await
    {
        for (wish, bytes) in span.wishes.iter().zip(tiles) {
            hand_over(wish.key, decoded(archive, wish.key, &bytes));
        }
        return;
    }
    for wish in span.wishes {
        hand_over(wish.key, load(archive, wish.key).await);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::tile::{Layer, Projection, TileId};

    fn wish(number: u64, slot: usize, place: Option<Range<u64>>) -> Wish {
        let key = (Layer::Water, TileId::new(Projection::Mercator, 7, number as u32, 0).unwrap());
        Wish { slot, key, rank: (7, number), place }
    }

    fn numbers(spans: &[Span]) -> Vec<Vec<u64>> {
        spans.iter().map(|span| span.wishes.iter().map(|wish| wish.rank.1).collect()).collect()
    }

    #[test]
    fn neighbours_and_twins_share_a_request_and_strangers_do_not() {
        let far = 1_000_000;
        let wishes = || {
            vec![
                wish(1, 0, Some(far..far + 100)),
                wish(2, 0, Some(0..100)),
                wish(3, 0, Some(100 + GAP..200 + GAP)),
                wish(4, 0, Some(0..100)),
                wish(5, 1, Some(100..200)),
                wish(6, 0, None),
                wish(7, 0, None),
                wish(8, 0, Some(far + 101 + GAP..far + 200 + GAP)),
            ]
        };
        let spans = spans(wishes(), |_, _| false);
        assert_eq!(numbers(&spans), [vec![1], vec![2, 4, 3], vec![5], vec![6], vec![7], vec![8]]);
        assert_eq!(spans[1].bytes, 0..200 + GAP);
        let known = |slot, gap: &Range<u64>| slot == 0 && *gap == (100..100 + GAP);
        assert_eq!(
            numbers(&super::spans(wishes(), known)),
            [vec![1], vec![2, 4], vec![3], vec![5], vec![6], vec![7], vec![8]]
        );
    }

    #[test]
    fn a_request_is_bounded_in_tiles_and_bytes() {
        let row = |length: u64| (0..40).map(|i| wish(i, 0, Some(i * length..(i + 1) * length))).collect();
        assert!(spans(row(100), |_, _| false).iter().all(|span| span.wishes.len() <= MOST_TILES));
        assert!(spans(row(200_000), |_, _| false).iter().all(|span| span.bytes.end - span.bytes.start <= MOST_BYTES));
        assert_eq!(spans(row(100), |_, _| false).len(), 40usize.div_ceil(MOST_TILES));
    }
}
