//! Which tiles of a [`World`] a renderer keeps at hand: asks for those in view, coarse ones first, and says which have come, what
//! they hold and where shaders find them. Knows no GPU: whoever has the atlases takes the [`Upload`]s and the page tables.

mod page_table;
mod residency;
mod tile_range;

pub use page_table::{PAGE_ENTRIES, PAGE_LEVELS, PAGE_SLOT_BITS, PAGE_WINDOW, PageTable};
pub use tile_range::{Range, TileRange};

use super::SharedTexels;
use super::tile::{Layer, MapPoint, Projection, TileId};
use super::world::{Outcome, World};
use crate::model::earth::Geodetic;
use crate::model::sea_bed::EQUATOR_TEXEL_M;
use residency::Residency;

/// Slots of each atlas; WebGPU promises 256 layers. 48 MiB each.
pub const ATLAS_SLOTS: u32 = 192;

/// Tiles of a layer that are asked for at once, at most: slot 0 is kept, and the roots of maps that are not in view keep theirs.
const MOST_WANTED: usize = ATLAS_SLOTS as usize - Projection::ALL.len();

/// A tile that has come, for a slot of its layer's atlas.
pub struct Upload {
    /// Which atlas.
    pub layer: Layer,
    /// Which slot.
    pub slot: u32,
    /// What goes into it.
    pub texels: SharedTexels,
}

/// The tiles at hand of all layers.
pub struct Streaming {
    layers: [Residency; Layer::COUNT],
    frame: u64,
    changed: bool,
    /// What of the last frame's tiles there may be, by layer.
    wanted: [Vec<TileId>; Layer::COUNT],
    /// Deepest levels of the archives by layer and map; 0 before they are open.
    deepest: [[u8; 3]; Layer::COUNT],
    /// How wide cells of the data of elevations are, metres; 0: not known.
    resolution_m: f64,
    /// Where shaders find the tiles.
    pub pages: PageTable,
}

impl Default for Streaming {
    fn default() -> Self {
        let layers = Layer::ALL.map(|layer| Residency::new(layer, ATLAS_SLOTS));
        Self {
            layers,
            frame: 0,
            changed: true,
            wanted: Default::default(),
            deepest: [[0; 3]; Layer::COUNT],
            resolution_m: 0.0,
            pages: PageTable::new(),
        }
    }
}

impl Streaming {
    /// How wide cells of the data of elevations are, metres; 0: not known.
    pub fn resolution_m(&self) -> f64 {
        self.resolution_m
    }

    /// Begins a frame: takes what has arrived. The tiles of the frame before stay.
    pub fn receive(&mut self, world: &mut World) -> Vec<Upload> {
        self.frame += 1;
        self.deepest = Layer::ALL.map(|layer| Projection::ALL.map(|map| world.max_zoom(layer, map).unwrap_or(0)));
        self.resolution_m = world.resolution_m(Layer::Terrain, Projection::Mercator).unwrap_or(0.0);
        let mut uploads = Vec::new();
        for arrival in world.poll() {
            let (layer, id) = (arrival.layer, arrival.id);
            let tiles = &mut self.layers[layer as usize];
            match arrival.outcome {
                Outcome::Tile(texels) => {
                    if let Some(slot) = tiles.receive(id, &texels, self.frame) {
                        self.changed = true;
                        uploads.push(Upload { layer, slot, texels });
                    }
                }
                Outcome::Absent => tiles.is_absent(id),
                Outcome::Failed(_) => tiles.has_failed(id),
            }
        }
        uploads
    }

    /// Asks `world` for what `tiles` and the eye's place need, and brings the page tables up to date. True when nothing
    /// had to be asked for: all that the world has of them is here.
    pub fn want(&mut self, world: &mut World, tiles: &[TileId], eye: Geodetic) -> bool {
        let Geodetic { lat, lon, height } = eye;
        let mut complete = true;
        // Also what lies under the eye, in view or not: the eye must know its ground.
        let foot = MapPoint::from_lat_lon(lat, lon).tile(foot_level(height));
        let mut wanted: Vec<TileId> = tiles.iter().copied().chain([foot]).flat_map(lineage).collect();
        wanted.sort_unstable_by_key(|id| (id.z, id.projection as u8, id.y, id.x));
        wanted.dedup();
        for layer in Layer::ALL {
            let residency = &mut self.layers[layer as usize];
            let deepest = self.deepest[layer as usize].map(|z| z.min(PAGE_LEVELS as u8 - 1));
            // What a world may lack is not asked for again and again.
            let exists = Projection::ALL.map(|map| layer != Layer::Imagery || world.has(layer, map));
            let there = wanted.iter().filter(|id| {
                let map = id.projection as usize;
                exists[map] && id.z <= deepest[map] && !residency.lacks(id)
            });
            // The coarse ones first; what the atlas cannot hold is shown through its parents.
            let there: Vec<TileId> = there.take(MOST_WANTED).copied().collect();
            for id in &there {
                if residency.want(*id, self.frame) {
                    world.request(layer, *id);
                    complete = false;
                }
            }
            self.changed |= there != self.wanted[layer as usize];
            self.wanted[layer as usize] = there;
        }
        world.send();
        let changed = std::mem::take(&mut self.changed);
        if changed {
            self.layers.iter_mut().for_each(|tiles| tiles.show(self.frame));
        }
        self.pages.update(&self.layers, changed, lat, lon);
        complete && world.settled()
    }

    /// Deepest level of a map's tiles of a layer; 0 before its archive is open.
    pub fn deepest(&self, layer: Layer, projection: Projection) -> u8 {
        self.deepest[layer as usize][projection as usize]
    }

    /// Whether nothing finer of a layer has still to come for a tile.
    pub fn is_known(&self, layer: Layer, id: TileId) -> bool {
        self.layers[layer as usize].is_known(id, self.deepest(layer, id.projection))
    }

    /// Elevations that shaders may find in a tile when they look at map level `coarsest` or a finer one, metres; `None` before the
    /// first tile.
    pub fn elevations_m(&self, id: TileId, coarsest: u8) -> Option<Range> {
        self.layers[Layer::Terrain as usize].range(id, coarsest)
    }

    /// As [`Streaming::elevations_m`]: signed distances to the ocean's shore, metres, positive in the ocean.
    pub fn shore_m(&self, id: TileId, coarsest: u8) -> Option<Range> {
        self.layers[Layer::Water as usize].range(id, coarsest)
    }

    /// Whether a pixel in a tile may show some of a lake or a river.
    pub fn has_inland(&self, id: TileId) -> bool {
        self.layers[Layer::Water as usize].has_inland(id)
    }
}

/// How fine an eye's own ground is asked for from a height, metres: with texels of one to two thousandths of it, and in all its detail near it.
fn foot_level(altitude_m: f64) -> u8 {
    let texels = EQUATOR_TEXEL_M / (1e-3 * altitude_m.abs()).max(1.0);
    libm::log2(texels).clamp(0.0, (PAGE_LEVELS - 1) as f64) as u8
}

/// A tile and its ancestors.
fn lineage(id: TileId) -> impl Iterator<Item = TileId> {
    std::iter::successors(Some(id), |id| id.parent())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ground_below_an_eye_is_asked_for_as_fine_as_it_is_high() {
        let finest = PAGE_LEVELS as u8 - 1;
        assert_eq!([-11e3, 0.0, 2.0, 560.0].map(foot_level), [finest; 4], "in the sea, at the deck and over the coast");
        // Eyes below 50 km are told the level of inland water, by water tiles, whose finest are of level 8.
        assert!(foot_level(50e3) > 8);
        for altitude_m in [1e5, 1e6, 1.15e7, 3e7] {
            let texels_m = EQUATOR_TEXEL_M / f64::from(1u32 << foot_level(altitude_m));
            assert!((1e-3..=2e-3).contains(&(texels_m / altitude_m)), "{altitude_m} m up texels are {texels_m} m wide");
        }
    }
}
