//! Decoded tiles, the least recently used of which goes first.

use super::Key;
use crate::data::SharedTexels;
use crate::data::coast::inland::Inland;
use std::collections::HashMap;
use std::sync::Arc;

/// A tile, and when it was last used.
struct Tile {
    used: u64,
    texels: SharedTexels,
    inland: Option<Arc<Inland>>,
}

/// A bounded map of decoded tiles.
pub(super) struct Cache {
    tiles: HashMap<Key, Tile>,
    clock: u64,
    limit: usize,
}

impl Cache {
    /// A cache of at most `limit` tiles.
    pub(super) fn new(limit: usize) -> Self {
        Self { tiles: HashMap::new(), clock: 0, limit }
    }

    /// The tile, marked as used.
    pub(super) fn get(&mut self, key: &Key) -> Option<SharedTexels> {
        self.clock += 1;
        let tile = self.tiles.get_mut(key)?;
        tile.used = self.clock;
        Some(tile.texels.clone())
    }

    /// The lakes and rivers of a tile that is there and holds any.
    pub(super) fn inland(&self, key: &Key) -> Option<Arc<Inland>> {
        self.tiles.get(key)?.inland.clone()
    }

    /// Adds a tile and drops the least recently used one where there are too many.
    pub(super) fn put(&mut self, key: Key, texels: SharedTexels, inland: Option<Arc<Inland>>) {
        self.clock += 1;
        self.tiles.insert(key, Tile { used: self.clock, texels, inland });
        if self.tiles.len() > self.limit
            && let Some(oldest) = self.tiles.iter().min_by_key(|(_, tile)| tile.used).map(|(key, _)| *key)
        {
            self.tiles.remove(&oldest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::TileTexels;
    use crate::data::tile::{Layer, Projection, TileId};

    #[test]
    fn the_least_recently_used_tile_goes_first() {
        let key = |x| (Layer::Terrain, TileId::new(Projection::Mercator, 4, x, 0).unwrap());
        let texels: SharedTexels = Arc::new(TileTexels::Terrain(Vec::new()));
        let mut cache = Cache::new(2);
        cache.put(key(0), texels.clone(), None);
        cache.put(key(1), texels.clone(), None);
        assert!(cache.get(&key(0)).is_some());
        cache.put(key(2), texels, None);
        assert!(cache.get(&key(0)).is_some() && cache.get(&key(1)).is_none() && cache.get(&key(2)).is_some());
    }
}
