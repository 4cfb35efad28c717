//! The world for programs that can wait: what they ask for is loaded now.

use super::answer::{deepest, load};
use super::slot::Opening;
use super::{Decoded, World, shores, slot_index};
use crate::data::SharedTexels;
use crate::data::exposure::Found;
use crate::data::fetch::Source;
use crate::data::pmtiles::Archive;
use crate::data::sample::Sample;
use crate::data::tile::{Layer, Projection, TileId};
use crate::error::Result;
use std::sync::Arc;

impl World {
    /// What is at geodetic `lat`, `lon` (radians), loading what it needs now.
    ///
    /// # Errors
    /// What opening or reading the archives reports; an error of [`sample_by`](Self::sample_by) if there is no terrain at all.
    pub fn sample_blocking(&mut self, lat: f64, lon: f64) -> Result<Sample> {
        let found = self.sample_by(lat, lon, Self::look_blocking)?;
        Ok(found.expect("tiles that are waited for are not on their way"))
    }

    /// A tile, loaded now if need be, its archive opened before.
    ///
    /// # Errors
    /// What opening or reading the archive reports.
    pub fn look_blocking(&mut self, layer: Layer, id: TileId) -> Result<Found> {
        self.open_blocking(layer, id.projection)?;
        Ok(self.tile_blocking(layer, id)?.map_or(Found::Absent, Found::Tile))
    }

    /// Opens an archive now, unless it is open.
    ///
    /// # Errors
    /// What opening it reports.
    pub fn open_blocking(&mut self, layer: Layer, projection: Projection) -> Result<()> {
        let slot = &mut self.slots[slot_index(layer, projection)];
        if slot.archive().is_none() {
            slot.opening = Opening::Open(Arc::new(pollster::block_on(Archive::open(Source::new(slot.name.clone())))?));
        }
        Ok(())
    }

    /// A tile of an archive that is open, loaded now if need be, and of water its ancestors with it; `None` where there is none.
    ///
    /// # Errors
    /// What reading the archive reports.
    pub fn tile_blocking(&mut self, layer: Layer, id: TileId) -> Result<Option<SharedTexels>> {
        let key = (layer, id);
        if let Some(texels) = self.cache.get(&key) {
            return Ok(Some(texels));
        }
        let is_known = |archive: &&Arc<Archive<Source>>| id.z <= deepest(archive) && !self.absent.contains(&key);
        let Some(archive) = self.slot(layer, id.projection).archive().filter(is_known).cloned() else {
            return Ok(None);
        };
        let (texels, inland) = match pollster::block_on(load(&archive, key))? {
            None => {
                self.note_absent(key);
                return Ok(None);
            }
            Some(Decoded::Whole(texels)) => (texels, None),
            Some(Decoded::Near(shores, inland)) => {
                let parent = id.parent().map(|parent| self.tile_blocking(layer, parent)).transpose()?.flatten();
                (shores::finished(&shores, id, parent.as_deref()), inland)
            }
        };
        let texels = Arc::new(texels);
        self.cache.put(key, texels.clone(), inland);
        Ok(Some(texels))
    }
}
