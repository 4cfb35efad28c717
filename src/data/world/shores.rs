//! Water tiles that have come and wait for their parents, of which they take what is far from their own shores.
//!
//! Tiles are fetched in any order and finished from the coarse ones down. A parent that nobody keeps any more is asked for silently:
//! whoever asks for tiles hears nothing of it.

use super::{Key, Outcome, World};
use crate::data::TileTexels;
use crate::data::coast::inland::Inland;
use crate::data::tile::{Layer, TileId};
use crate::data::water::OwnShores;
use crate::error::Error;
use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

/// What a tile tells by itself.
type Own = (OwnShores, Option<Arc<Inland>>);

/// See above.
#[derive(Default)]
pub(super) struct Unfinished {
    /// By level, coarse ones first.
    tiles: BTreeMap<(u8, TileId), Own>,
    silent: HashSet<Key>,
}

impl Unfinished {
    /// Takes a tile in.
    pub(super) fn add(&mut self, id: TileId, shores: OwnShores, inland: Option<Arc<Inland>>) {
        self.tiles.insert((id.z, id), (shores, inland));
    }

    /// Somebody asks for this tile: the answer is theirs.
    pub(super) fn is_wanted(&mut self, key: &Key) {
        self.silent.remove(key);
    }

    /// The answer to a request for this tile is nobody's.
    pub(super) fn asks_silently(&mut self, key: Key) {
        self.silent.insert(key);
    }

    /// Whether nobody but a child has asked for this tile, which is here now.
    pub(super) fn asked_silently(&mut self, key: &Key) -> bool {
        self.silent.remove(key)
    }
}

/// A water tile from its own shores and its parent.
pub(super) fn finished(shores: &OwnShores, id: TileId, parent: Option<&TileTexels>) -> TileTexels {
    let parent =
        parent.and_then(|parent| if let TileTexels::Water(texels) = parent { Some(&texels[..]) } else { None });
    TileTexels::Water(shores.within(id, parent))
}

impl World {
    /// Finishes the tiles whose parents are here, and asks for parents that are not on their way.
    pub(super) fn finish_shores(&mut self) {
        let waiting: Vec<_> = self.unfinished.tiles.keys().map(|(_, id)| *id).collect();
        for id in waiting {
            let key = (Layer::Water, id);
            let parent = id.parent().map(|parent| (Layer::Water, parent));
            let at_hand = parent.and_then(|parent| self.cache.get(&parent));
            match parent {
                Some(parent) if at_hand.is_none() && !self.absent.contains(&parent) => {
                    if self.given_up.contains_key(&parent) {
                        self.unfinished.tiles.remove(&(id.z, id));
                        // For as long as its parent.
                        self.given_up.extend(self.given_up.get(&parent).map(|until| (key, *until)));
                        let url = self.slot(Layer::Water, id.projection).name.clone();
                        let why = format!("water tile {id} goes without its parent, which was given up");
                        self.answer(key, Outcome::Failed(Error::Fetch { url, why }));
                    } else if !self.pending.contains_key(&parent) {
                        self.request(parent.0, parent.1);
                        self.unfinished.asks_silently(parent);
                    }
                }
                _ => {
                    if let Some((shores, inland)) = self.unfinished.tiles.remove(&(id.z, id)) {
                        self.is_here(key, finished(&shores, id, at_hand.as_deref()), inland);
                    }
                }
            }
        }
    }
}
