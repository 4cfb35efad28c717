//! What is drawn of which tiles: the grid that all share, block by block, and draws of tiles that are drawn alike, one after the other.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::{Beach, Ground};
use crate::data::tile::TileId;
use crate::gpu::mesh::grid_triangles;
use crate::scene::view::map_tiles::{ALL_BLOCKS, BLOCKS, DrawnTile};

/// Cells along a side of a tile's grid; equals `GRID` in `shaders/land.wgsl`.
pub const GRID: u32 = 16;
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct Instance {
    square: u32,
    level: u32,
    x: u32,
    y: u32,
    /// A bit for each block that is drawn with its beach.
    beaches: u32,
}

impl Instance {
    pub(super) fn new(id: TileId, beaches: u32) -> Self {
        Self { square: id.projection as u32, level: u32::from(id.z), x: id.x, y: id.y, beaches }
    }
}

/// Of so many tiles, one after the other in the buffer, what of their grids, and what it is drawn with.
pub(super) struct Draw {
    pub(super) by: Ground,
    pub(super) indices: Range<u32>,
    pub(super) instances: Range<u32>,
}

/// Indices of each block's triangles, row by row; all of them are the whole grid's.
pub(super) type Blocks = Vec<Range<u32>>;

/// Grid vertices from one cell outside to one cell outside (the skirt), and their triangles, block by block.
pub(super) fn mesh() -> (Vec<[f32; 2]>, Vec<u32>, Blocks) {
    let side = GRID + 3;
    let at = |i: u32| i as f32 - 1.0;
    let vertices = (0..side * side).map(|v| [at(v % side), at(v / side)]).collect();
    let triangles = grid_triangles(side - 1, side - 1);
    // A cell of the skirt is of the block that it hangs from.
    let block_of = |cell: u32| (cell.saturating_sub(1) * BLOCKS / GRID).min(BLOCKS - 1);
    let mut indices = Vec::with_capacity(triangles.len());
    let blocks = (0..BLOCKS * BLOCKS).map(|block| {
        let first = indices.len() as u32;
        for (cell, cell_indices) in (0..).zip(triangles.chunks(6)) {
            let [column, row] = [cell % (side - 1), cell / (side - 1)].map(block_of);
            if row * BLOCKS + column == block {
                indices.extend_from_slice(cell_indices);
            }
        }
        first..indices.len() as u32
    });
    let blocks = blocks.collect();
    (vertices, indices, blocks)
}

/// A tile, what it is drawn with but for its beaches, and a bit for each of its blocks that is drawn.
pub(super) struct Part {
    pub(super) ground: Ground,
    pub(super) instance: Instance,
    pub(super) shown: u32,
}

/// Bits of tiles' blocks, as long as there is room for those that are drawn by themselves: later tiles have none.
pub(super) fn with_room(tiles: Vec<u32>, room: &mut usize) -> Vec<u32> {
    tiles.into_iter().map(|bits| if takes(bits.count_ones(), room) { bits } else { 0 }).collect()
}

/// Bits of a tile's blocks that are drawn as land, and as the sea's bed alone; where there is no room for them as land those that are shown, or all.
pub(super) fn land_and_bed(tile: &DrawnTile, room: &mut usize) -> [u32; 2] {
    let by_themselves =
        |parts: [u32; 2]| parts.into_iter().filter(|bits| *bits != ALL_BLOCKS).map(u32::count_ones).sum();
    let choices = [[tile.shown & !tile.bed, tile.shown & tile.bed], [tile.shown, 0]];
    choices.into_iter().find(|parts| takes(by_themselves(*parts), room)).unwrap_or([ALL_BLOCKS, 0])
}

/// Takes room for so many blocks, if there is as much.
fn takes(blocks: u32, room: &mut usize) -> bool {
    let left = room.checked_sub(blocks as usize);
    *room = left.unwrap_or(*room);
    left.is_some()
}

/// The draws of tiles, and their instances one after the other. Ground with relief, which is near, comes first, and beaches last: what has been drawn beside
/// them hides the rest of their blocks.
pub(super) fn draws(parts: &[Part], blocks: &Blocks) -> (Vec<Draw>, Vec<Instance>) {
    let whole = 0..blocks[blocks.len() - 1].end;
    let (mut draws, mut instances) = (Vec::new(), Vec::new());
    let mut draw = |by: Ground, beach: Beach, indices: &Range<u32>, is_drawn: &dyn Fn(&Part) -> bool| {
        let first = instances.len() as u32;
        let here = parts.iter().filter(|part| part.ground == by && is_drawn(part));
        instances.extend(here.map(|part| part.instance));
        let range = first..instances.len() as u32;
        if !range.is_empty() {
            draws.push(Draw { by: Ground { beach, ..by }, indices: indices.clone(), instances: range });
        }
    };
    let mut grounds: Vec<Ground> = Vec::new();
    for part in parts {
        if !grounds.contains(&part.ground) {
            grounds.push(part.ground);
        }
    }
    grounds.sort_by_key(|ground| !ground.rugged);
    let has = |bits: u32, block: usize| bits >> block & 1 != 0;
    for by in &grounds {
        for beach in [Beach::Beside, Beach::Absent] {
            let is_so = |part: &Part| (part.instance.beaches != 0) == (beach == Beach::Beside);
            draw(*by, beach, &whole, &|part| is_so(part) && part.shown == ALL_BLOCKS);
            for (block, indices) in blocks.iter().enumerate() {
                let is_shown = |part: &Part| part.shown != ALL_BLOCKS && has(part.shown, block);
                draw(*by, beach, indices, &|part| is_so(part) && is_shown(part));
            }
        }
    }
    for by in &grounds {
        for (block, indices) in blocks.iter().enumerate() {
            draw(*by, Beach::Only, indices, &|part| has(part.instance.beaches, block));
        }
    }
    (draws, instances)
}

#[cfg(test)]
mod tests {
    use super::super::Near;
    use super::*;
    use crate::scene::view::map_tiles::blocks_with;

    #[test]
    fn each_block_that_shows_is_drawn_once_and_once_more_for_its_beach() {
        let (_, indices, blocks) = mesh();
        let plain = Ground {
            near: Near::Growth,
            beach: Beach::Absent,
            rugged: false,
            town: false,
            inland: false,
            reefs: false,
            bed: false,
        };
        let part = |x: u32, rugged: bool, beaches: u32, shown: u32| {
            let id = TileId { projection: crate::data::tile::Projection::Mercator, z: 10, x, y: 5 };
            Part { ground: Ground { rugged, ..plain }, instance: Instance::new(id, beaches), shown }
        };
        let parts = [
            part(0, false, 0, ALL_BLOCKS),
            part(1, false, 0, 0x0ff0),
            part(2, true, 0x0030, ALL_BLOCKS),
            part(3, true, 0x0100, 0xff00),
            part(4, false, 0, 0),
        ];
        let (draws, instances) = draws(&parts, &blocks);
        for part in &parts {
            let of_tile = |draw: &&Draw| {
                instances[draw.instances.start as usize..draw.instances.end as usize]
                    .iter()
                    .any(|i| i.x == part.instance.x)
            };
            let triangles = |only: bool| {
                let of_kind = draws.iter().filter(of_tile).filter(|draw| (draw.by.beach == Beach::Only) == only);
                let mut found: Vec<_> = of_kind.flat_map(|draw| draw.indices.clone()).collect();
                found.sort_unstable();
                found
            };
            let wanted = |bits: u32| -> Vec<u32> {
                (0..)
                    .zip(&blocks)
                    .filter(|(block, _)| bits >> block & 1 != 0)
                    .flat_map(|(_, range)| range.clone())
                    .collect()
            };
            assert_eq!(triangles(false), wanted(part.shown), "tile {}", part.instance.x);
            assert_eq!(triangles(true), wanted(part.instance.beaches), "beaches of tile {}", part.instance.x);
            let beside = draws.iter().filter(of_tile).filter(|draw| draw.by.beach == Beach::Beside).count();
            assert_eq!(beside != 0, part.instance.beaches != 0);
            assert!(draws.iter().filter(of_tile).all(|draw| draw.by.rugged == part.ground.rugged));
        }
        assert!(indices.len() as u32 == blocks[blocks.len() - 1].end && draws[0].by.rugged);
    }

    #[test]
    fn blocks_have_so_much_room_and_no_more() {
        let mut room = 9;
        // Eight of beaches, four that do not fit, one.
        assert_eq!(with_room(vec![0xff, 0xf, 0, 1], &mut room), [0xff, 0, 0, 1]);
        assert_eq!(room, 0);
        let id = TileId { projection: crate::data::tile::Projection::Mercator, z: 10, x: 3, y: 5 };
        let divided = |shown, bed, room| {
            let mut room = room;
            (land_and_bed(&DrawnTile { id, is_rugged: false, shown, bed }, &mut room), room)
        };
        assert_eq!(divided(0xf, 0, 0), ([ALL_BLOCKS, 0], 0));
        assert_eq!(divided(ALL_BLOCKS, ALL_BLOCKS, 0), ([0, ALL_BLOCKS], 0));
        assert_eq!(divided(0x0fff, 0x00ff, 20), ([0x0f00, 0x00ff], 8));
        assert_eq!(divided(ALL_BLOCKS, 0x00ff, 16), ([0xff00, 0x00ff], 0));
        assert_eq!(divided(ALL_BLOCKS, 0x00ff, 15), ([ALL_BLOCKS, 0], 15));
        assert_eq!(divided(0x0fff, 0x00ff, 11), ([ALL_BLOCKS, 0], 11));
    }

    #[test]
    fn blocks_are_the_grid_and_lie_where_descendants_of_their_tile_do() {
        let (vertices, indices, blocks) = mesh();
        let all = grid_triangles(GRID + 2, GRID + 2);
        let sorted = |indices: &[u32]| {
            let mut triangles: Vec<&[u32]> = indices.chunks(3).collect();
            triangles.sort_unstable();
            triangles.concat()
        };
        assert_eq!(sorted(&indices), sorted(&all), "the blocks are the grid");
        let id = TileId { projection: crate::data::tile::Projection::Mercator, z: 10, x: 3, y: 5 };
        for (index, block) in blocks.iter().enumerate() {
            let [column, row] = [index as u32 % BLOCKS, index as u32 / BLOCKS];
            // A descendant's cells are the block's.
            let wanted = TileId { z: id.z + 2, x: id.x * BLOCKS + column, y: id.y * BLOCKS + row, ..id };
            let has = |tile: TileId| std::iter::successors(Some(wanted), |id| id.parent()).any(|above| above == tile);
            assert_eq!(blocks_with(id, &has), 1 << index);
            let width = (GRID / BLOCKS) as f32;
            for &vertex in &indices[block.start as usize..block.end as usize] {
                for (at, block) in vertices[vertex as usize].into_iter().zip([column, row]) {
                    let first = block as f32 * width;
                    assert!((first..=first + width).contains(&at.clamp(0.0, GRID as f32)));
                }
            }
        }
        assert_eq!(blocks_with(id, &|_| false), 0);
        assert_eq!(blocks_with(id, &|_| true), 0xffff);
    }
}
