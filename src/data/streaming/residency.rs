//! Which tiles of a layer the GPU's atlas holds, and in which slot: what is asked for, what makes room, when to ask again.

use rustc_hash::{FxHashMap, FxHashSet};

use super::tile_range::{Range, TileRange};
use crate::data::SharedTexels;
use crate::data::fetch::now_s;
use crate::data::tile::{Layer, TILE_TEXELS, TileId, lat_lon_from_map, texel_size_m};

/// Wait before a tile that could not be had is asked for again, seconds.
const RETRY_S: f64 = 31.0;

/// A pixel so many texels off an inland water shows none of it that has waves.
const SHOWN_TEXELS: f64 = 3.0;

struct Resident {
    slot: u32,
    last_used: u64,
    range: TileRange,
    /// Of the whole tile, metres.
    whole: Range,
}

/// The tiles of one layer.
pub(super) struct Residency {
    resident: FxHashMap<TileId, Resident>,
    /// The frame whose tiles shaders find.
    shown: u64,
    /// Of every tile that shaders find or that has such descendants: the range of all of these, metres.
    at_and_below: FxHashMap<TileId, Range>,
    /// Tiles that show an inland water, or have descendants that do and that shaders find.
    inland: FxHashSet<TileId>,
    /// Tiles that the archive lacks: their parents serve.
    absent: FxHashSet<TileId>,
    /// Tiles that could not be had, and when to ask again, seconds: until then their parents serve.
    failed: FxHashMap<TileId, f64>,
    free: Vec<u32>,
    layer: Layer,
}

impl Residency {
    /// No tile; slots 1 to `slots` - 1 are free, slot 0 is kept for what is shown before the first tile.
    pub(super) fn new(layer: Layer, slots: u32) -> Self {
        Self {
            resident: FxHashMap::default(),
            shown: 0,
            at_and_below: FxHashMap::default(),
            inland: FxHashSet::default(),
            absent: FxHashSet::default(),
            failed: FxHashMap::default(),
            free: (1..slots).rev().collect(),
            layer,
        }
    }

    /// Notes that `id` is wanted in frame `now`; true when it must be asked for.
    pub(super) fn want(&mut self, id: TileId, now: u64) -> bool {
        if let Some(resident) = self.resident.get_mut(&id) {
            resident.last_used = now;
            return false;
        }
        self.failed.get(&id).is_none_or(|until| *until <= now_s())
    }

    /// Takes a tile in: its slot, or `None` where every slot holds a tile that is in use.
    pub(super) fn receive(&mut self, id: TileId, texels: &SharedTexels, now: u64) -> Option<u32> {
        let slot = self.free.pop().or_else(|| self.evict(now))?;
        let range = TileRange::new(texels);
        let whole = self.metres(id)(id.z, range.whole());
        // Wanted by no frame yet, and by none if it was only looked at; but not to be driven out by the next that comes.
        let resident = Resident { slot, last_used: now - 1, range, whole };
        self.resident.insert(id, resident);
        Some(slot)
    }

    /// Notes that the archive has no such tile.
    pub(super) fn is_absent(&mut self, id: TileId) {
        self.absent.insert(id);
    }

    /// Whether the archive is known to have no such tile.
    pub(super) fn lacks(&self, id: &TileId) -> bool {
        self.absent.contains(id)
    }

    /// Notes that a tile could not be had.
    pub(super) fn has_failed(&mut self, id: TileId) {
        self.failed.insert(id, now_s() + RETRY_S);
    }

    /// Shows the tiles that are wanted in frame `now`; others at hand do not count: else what was seen before would show.
    pub(super) fn show(&mut self, now: u64) {
        self.shown = now;
        self.at_and_below.clear();
        self.inland.clear();
        for (id, resident) in &self.resident {
            if self.shows(id, resident) {
                widen(&mut self.at_and_below, *id, resident.whole);
                if resident.shows_inland(*id, id.z) {
                    self.inland.extend(super::lineage(*id));
                }
            }
        }
    }

    /// Whether shaders find a tile: roots always.
    fn shows(&self, id: &TileId, resident: &Resident) -> bool {
        id.z == 0 || resident.last_used >= self.shown
    }

    /// A tile that shaders find.
    fn shown(&self, id: &TileId) -> Option<&Resident> {
        self.resident.get(id).filter(|resident| self.shows(id, resident))
    }

    /// Tiles that shaders find, and their slots.
    pub(super) fn slots(&self) -> impl Iterator<Item = (TileId, u32)> {
        let shown = self.resident.iter().filter(|(id, resident)| self.shows(id, resident));
        shown.map(|(id, resident)| (*id, resident.slot))
    }

    /// Whether nothing finer of `id`, down to level `deepest`, has still to come: the tile itself or, where the archive has none,
    /// the one that serves for it is resident.
    pub(super) fn is_known(&self, id: TileId, deepest: u8) -> bool {
        let mut lineage = super::lineage(id).skip_while(|id| id.z > deepest);
        lineage.find(|id| !self.absent.contains(id)).is_some_and(|id| self.shown(&id).is_some())
    }

    /// Metres that shaders may find inside `id` when they look at level `coarsest` or a finer one: of elevation, or of distance to
    /// the ocean's shore. `None` before the first tile.
    pub(super) fn range(&self, id: TileId, coarsest: u8) -> Option<Range> {
        let serving = super::lineage(id).skip_while(|id| id.z > coarsest).find(|id| self.shown(id).is_some())?;
        let above = super::lineage(id).skip(1).take_while(|tile| tile.z >= serving.z);
        let in_metres = self.metres(id);
        let above = above.filter_map(|tile| Some(in_metres(tile.z, self.shown(&tile)?.range_in(id, tile.z))));
        above.chain(self.at_and_below.get(&id).copied()).reduce(Range::union)
    }

    /// Whether a pixel in `id` may show some of a lake or a river, as far as the tile tells that serves for it, and those below it.
    pub(super) fn has_inland(&self, id: TileId) -> bool {
        let serving = super::lineage(id).find_map(|tile| Some((tile.z, self.shown(&tile)?)));
        self.inland.contains(&id) || serving.is_none_or(|(z, resident)| resident.shows_inland(id, z))
    }

    /// Metres in `id` of a range of a tile of some level.
    fn metres(&self, id: TileId) -> impl Fn(u8, Range) -> Range {
        let sizes = (self.layer != Layer::Terrain).then(|| texel_sizes_m(id));
        move |z, range| {
            let Some([short, long]) = sizes else { return range };
            let [short, long] = [short, long].map(|texel_m| texel_m * f64::from(1u32 << (id.z - z)));
            // A texel at the edge of a tile is a mix with its neighbour, whose distances differ by a texel at most.
            let (least, greatest) = (range.least - 1.0, range.greatest + 1.0);
            Range {
                least: least * if least > 0.0 { short } else { long },
                greatest: greatest * if greatest > 0.0 { long } else { short },
            }
        }
    }

    /// Frees the slot that has gone unused longest; roots stay.
    fn evict(&mut self, now: u64) -> Option<u32> {
        let old = |(id, r): &(&TileId, &Resident)| id.z > 0 && r.last_used + 1 < now;
        let id = *self.resident.iter().filter(old).min_by_key(|(_, r)| r.last_used)?.0;
        self.resident.remove(&id).map(|r| r.slot)
    }
}

/// Adds a tile's range to its own and its ancestors' sums.
fn widen(sums: &mut FxHashMap<TileId, Range>, id: TileId, range: Range) {
    for tile in super::lineage(id) {
        sums.entry(tile).and_modify(|sum| *sum = sum.union(range)).or_insert(range);
    }
}

impl Resident {
    /// Whether this tile of level `z` may show some of a lake or a river in its descendant `id`.
    fn shows_inland(&self, id: TileId, z: u8) -> bool {
        let (first, last) = texels_in(id, z);
        self.range.inland(first, last) > -SHOWN_TEXELS
    }

    /// Of the texels of this tile of level `z` that lie in its descendant `id`, and one more on each side.
    fn range_in(&self, id: TileId, z: u8) -> Range {
        let (first, last) = texels_in(id, z);
        self.range.between(first, last)
    }
}

/// The first and the last of the texels of an ancestor of level `z` that lie in a tile, and one more on each side.
fn texels_in(id: TileId, z: u8) -> ([i64; 2], [i64; 2]) {
    let down = id.z - z;
    let texel = |column: u32| ((i64::from(column) * TILE_TEXELS as i64) >> down) & (TILE_TEXELS as i64 - 1);
    let last = |column: u32| (((i64::from(column) + 1) * TILE_TEXELS as i64 - 1) >> down) & (TILE_TEXELS as i64 - 1);
    ([texel(id.x) - 1, texel(id.y) - 1], [last(id.x) + 1, last(id.y) + 1])
}

/// Of a texel of a tile: the shortest and the longest, metres on the ground. One of a level above is twice as wide.
fn texel_sizes_m(id: TileId) -> [f64; 2] {
    let side = 2f64.powi(-i32::from(id.z));
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (0.5, 0.5)];
    let sizes = corners.map(|(x, y)| {
        let at = [(f64::from(id.x) + x) * side, (f64::from(id.y) + y) * side];
        let (lat, _) = lat_lon_from_map(id.projection, at[0], at[1]);
        texel_size_m(id.projection, id.z, lat)
    });
    [sizes.into_iter().fold(f64::INFINITY, f64::min), sizes.into_iter().fold(0.0, f64::max)]
}
