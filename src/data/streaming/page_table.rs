//! Page tables: which slots of the atlases serve for a place, level by level, in windows around the eye.
//!
//! A level of a map has at most [`PAGE_WINDOW`]² entries: those of all its tiles, or of the tiles around the eye's own, each at its
//! column and row modulo [`PAGE_WINDOW`]. An entry holds 16 bits for each layer: the slot in the low 12 and the level of the tile in it in the
//! high 4; terrain in the low half of the first word, water in its high half, imagery in the low half of the second one. Levels below the
//! deepest of these tiles have no entries: shaders do not ask for them.

use super::residency::Residency;
use crate::data::tile::{Layer, MapPoint, Projection};

/// Levels of the page tables; equals `PAGE_LEVELS` in `shaders/lib/map_texels.wgsl`.
pub const PAGE_LEVELS: usize = 14;
/// Tiles along a side of a level's page table; equals `PAGE_WINDOW` there.
pub const PAGE_WINDOW: usize = 64;
/// Entries of a level.
pub const PAGE_ENTRIES: usize = PAGE_WINDOW * PAGE_WINDOW;
/// Bits of a slot's number in an entry; the level of its tile has the other four of its 16. Equals `PAGE_SLOT_BITS` there.
pub const PAGE_SLOT_BITS: u32 = 12;
const _: () = assert!(super::ATLAS_SLOTS <= 1 << PAGE_SLOT_BITS && PAGE_LEVELS <= 16 && Layer::COUNT <= 4);

/// First tiles of each level's window in each map.
type Corners = [[[u32; 2]; PAGE_LEVELS]; 3];

/// The tables of all maps and levels, and which of them the GPU has yet to get.
pub struct PageTable {
    /// By map, level, row and column: what serves for the layers.
    entries: Vec<[u32; 2]>,
    /// Tables (map · [`PAGE_LEVELS`] + level) that have changed since they were last taken.
    changed: Vec<usize>,
    corners: Option<Corners>,
    /// The deepest level of any tile that is wanted and at hand, by map.
    deepest: [u8; 3],
}

impl PageTable {
    /// No tile anywhere.
    pub(super) fn new() -> Self {
        let entries = vec![[0; 2]; Projection::ALL.len() * PAGE_LEVELS * PAGE_ENTRIES];
        Self { entries, changed: Vec::new(), corners: None, deepest: [0; 3] }
    }

    /// The deepest level that a map's tables reach, in bytes: the first is Mercator's.
    pub fn deepest(&self) -> u32 {
        u32::from_le_bytes([self.deepest[0], self.deepest[1], self.deepest[2], 0])
    }

    /// Hands over the tables that have changed: their numbers and their entries.
    pub fn take_changed(&mut self) -> impl Iterator<Item = (usize, &[[u32; 2]])> {
        let entries = &self.entries;
        std::mem::take(&mut self.changed)
            .into_iter()
            .map(|table| (table, &entries[table * PAGE_ENTRIES..][..PAGE_ENTRIES]))
    }

    /// Brings the tables up to date with the eye's place (radians), and with the tiles that are shown where these have `changed`.
    pub(super) fn update(&mut self, layers: &[Residency; Layer::COUNT], changed: bool, lat: f64, lon: f64) {
        let corners = corners(lat, lon);
        let last = self.corners.replace(corners);
        for (map, projection) in Projection::ALL.into_iter().enumerate() {
            let tiles = || {
                let all = layers.iter().enumerate();
                let all = all.flat_map(|(layer, tiles)| tiles.slots().map(move |(id, slot)| (layer, id, slot)));
                all.filter(|(_, id, _)| id.projection == projection)
            };
            if changed {
                self.deepest[map] = tiles().map(|(_, id, _)| id.z).max().unwrap_or(0).min(PAGE_LEVELS as u8 - 1);
            }
            let levels = ..=usize::from(self.deepest[map]);
            if !changed && last.is_some_and(|last| last[map][levels] == corners[map][levels]) {
                continue;
            }
            let mut level_tiles: [Vec<_>; PAGE_LEVELS] = Default::default();
            for tile in tiles().filter(|(_, id, _)| usize::from(id.z) < PAGE_LEVELS) {
                level_tiles[usize::from(tile.1.z)].push(tile);
            }
            for (z, tiles) in level_tiles[levels].iter().enumerate() {
                let mut table = self.inherited(map, z, corners[map][z]);
                for (layer, id, slot) in tiles {
                    if in_window(z, corners[map][z], [id.x, id.y]) {
                        set(&mut table[place(id.x, id.y)], *layer, slot | (z as u32) << PAGE_SLOT_BITS);
                    }
                }
                let number = map * PAGE_LEVELS + z;
                let kept = &mut self.entries[number * PAGE_ENTRIES..][..PAGE_ENTRIES];
                if kept != table {
                    kept.copy_from_slice(&table);
                    self.changed.retain(|other| *other != number);
                    self.changed.push(number);
                }
            }
        }
    }

    /// A level's table if it had no tiles of its own: every entry is its parent's.
    fn inherited(&self, map: usize, z: usize, corner: [u32; 2]) -> Vec<[u32; 2]> {
        let mut table = vec![[0; 2]; PAGE_ENTRIES];
        let Some(above) = z.checked_sub(1) else { return table };
        let parents = &self.entries[(map * PAGE_LEVELS + above) * PAGE_ENTRIES..][..PAGE_ENTRIES];
        let across = 1u32 << z;
        let side = across.min(PAGE_WINDOW as u32);
        for dy in 0..side {
            let y = corner[1].wrapping_add(dy) % across;
            for dx in 0..side {
                let x = corner[0].wrapping_add(dx) % across;
                table[place(x, y)] = parents[place(x / 2, y / 2)];
            }
        }
        table
    }
}

/// Puts the 16 bits of a layer into an entry.
fn set(entry: &mut [u32; 2], layer: usize, bits: u32) {
    let shift = 16 * (layer as u32 % 2);
    let word = &mut entry[layer / 2];
    *word = *word & !(0xffff << shift) | bits << shift;
}

/// Where a tile's entry stands in its level's table.
fn place(x: u32, y: u32) -> usize {
    (y as usize % PAGE_WINDOW) * PAGE_WINDOW + x as usize % PAGE_WINDOW
}

fn in_window(z: usize, corner: [u32; 2], tile: [u32; 2]) -> bool {
    let across = 1u32 << z;
    (0..2).all(|axis| tile[axis].wrapping_sub(corner[axis]) % across < PAGE_WINDOW as u32)
}

/// First tile of each level's window: half a window before the eye's own tile. Must hold the tiles that shaders look up,
/// which lie within 16 of the reference point.
fn corners(lat: f64, lon: f64) -> Corners {
    Projection::ALL.map(|projection| {
        let side = match projection {
            Projection::Mercator => 0.0,
            Projection::North => 1.0,
            Projection::South => -1.0,
        };
        let far = side != 0.0 && lat * side <= 80f64.to_radians();
        let lat = if far { side * std::f64::consts::FRAC_PI_2 } else { lat };
        let eye = MapPoint::on(projection, lat, lon);
        std::array::from_fn(|z| {
            let tile = eye.tile(z as u8);
            let half = PAGE_WINDOW as u32 / 2;
            if (1usize << z) <= PAGE_WINDOW { [0, 0] } else { [tile.x.wrapping_sub(half), tile.y.wrapping_sub(half)] }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::TileTexels;
    use crate::data::streaming::lineage;
    use crate::data::tile::{Layer, TILE_TEXELS, TileId};
    use std::collections::HashMap;
    use std::sync::Arc;

    /// The entry's definition: the finest tile that is shown over a tile.
    fn wanted(slots: &[HashMap<TileId, u32>; Layer::COUNT], id: TileId) -> [u32; 2] {
        let bits = |slots: &HashMap<TileId, u32>| {
            lineage(id).find_map(|tile| slots.get(&tile).map(|slot| slot | u32::from(tile.z) << 12)).unwrap_or(0)
        };
        [bits(&slots[0]) | bits(&slots[1]) << 16, bits(&slots[2])]
    }

    #[test]
    fn every_entry_names_the_finest_tile_that_is_wanted_wherever_the_eye_goes() {
        let mut layers = Layer::ALL.map(|layer| Residency::new(layer, 64));
        let texels = [
            TileTexels::Terrain(vec![0.0; TILE_TEXELS * TILE_TEXELS]),
            TileTexels::Water(vec![[255; 4]; 65_536]),
            TileTexels::Imagery(vec![[255; 4]; 65_536]),
        ];
        let texels = texels.map(Arc::new);
        let mut pages = PageTable::new();
        let mut on_gpu = pages.entries.clone();
        // Across the antimeridian, along a meridian and to both poles; tiles come on the way, and others are wanted no more.
        let places =
            [[10.0, 179.9f64], [10.0, -179.8], [10.3, -179.8], [58.0, 12.0], [84.5, 12.0], [-89.0, 3.0], [-80.0, 3.0]];
        let mut sent = 0;
        for (step, [lat, lon]) in places.map(|place| place.map(f64::to_radians)).into_iter().enumerate() {
            let here = MapPoint::from_lat_lon(lat, lon);
            let now = 1 + step as u64;
            for (layer, deepest) in [(0, 5), (1, 9), (2, 4)] {
                let wanted: Vec<_> = lineage(here.tile(if step % 2 == 0 { deepest } else { 3 })).collect();
                for id in &wanted {
                    if layers[layer].want(*id, now) {
                        layers[layer].receive(*id, &texels[layer], now).unwrap();
                        layers[layer].want(*id, now);
                    }
                }
                layers[layer].show(now);
                let shown: Vec<_> = layers[layer].slots().map(|(id, _)| id).filter(|id| id.z > 0).collect();
                assert_eq!(shown.len(), wanted.len() - 1, "{shown:?}");
                assert!(shown.iter().all(|id| wanted.contains(id)));
            }
            for changed in [true, false] {
                // The second time the eye alone has moved.
                let lon = if changed { lon } else { lon + 0.02 };
                pages.update(&layers, changed, lat, lon);
                for (table, entries) in pages.take_changed() {
                    on_gpu[table * PAGE_ENTRIES..][..PAGE_ENTRIES].copy_from_slice(entries);
                    sent += 1;
                }
                let slots = layers.each_ref().map(|layer| layer.slots().collect());
                for (map, projection) in Projection::ALL.into_iter().enumerate() {
                    for z in 0..=pages.deepest[map] {
                        let eye = if map == 0 || here.projection == projection {
                            MapPoint::on(projection, lat, lon).tile(z)
                        } else {
                            continue;
                        };
                        let across = 1u32 << z;
                        for (dx, dy) in (0..31u32).flat_map(|dx| (0..31).map(move |dy| (dx, dy))) {
                            let x = eye.x.wrapping_add(dx).wrapping_sub(15) % across;
                            let y = eye.y.wrapping_add(dy).wrapping_sub(15) % across;
                            let id = TileId { projection, z, x, y };
                            let entry = on_gpu[(map * PAGE_LEVELS + usize::from(z)) * PAGE_ENTRIES + place(x, y)];
                            assert_eq!(entry, wanted(&slots, id), "{id} from place {step}");
                        }
                    }
                }
            }
        }
        // Of the 14 updates of 36 tables.
        assert!(sent < 150, "{sent} tables were sent");
    }
}
