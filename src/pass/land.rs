//! Dry land, lakes and the sea bed: one grid with a skirt for every visible map tile, in instanced draws. What beaches show that waves run up takes much
//! longer than other ground, and is a narrow strip: where tiles have one they are drawn without it, and then those of their blocks that it crosses once more.
//! Tiles of which the sea hides a part are drawn block by block, too.

use std::collections::HashMap;
use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::kind::Kind;
use crate::data::tile::TileId;
use crate::gpu::mesh::grid_triangles;
use crate::gpu::pipeline::{Depth, DepthTest, Drawing};
use crate::gpu::{Gpu, shader};
use crate::scene::view::map_tiles::{ALL_BLOCKS, BLOCKS, DrawnTile, blocks_with};

/// Cells along a side of a tile's grid; equals `GRID` in `shaders/land.wgsl`.
pub const GRID: u32 = 16;
const MOST_TILES: usize = 1_024;
/// Drawn by themselves, in one picture; tiles that come later have no beaches and are drawn whole.
const MOST_BLOCKS: usize = 4_096;

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Instance {
    square: u32,
    level: u32,
    x: u32,
    y: u32,
    /// A bit for each block that is drawn with its beach.
    beaches: u32,
}

impl Instance {
    fn new(id: TileId, beaches: u32) -> Self {
        Self { square: id.projection as u32, level: u32::from(id.z), x: id.x, y: id.y, beaches }
    }
}

/// Pixels on the nearest ground that are so wide, metres, show nothing of what grows on it: seven tenths of a cell of the widest lattice of
/// `shaders/lib/plants.wgsl`, at the equator.
pub const GROWTH_M: f64 = 26.0;

/// What of the ground of a tile may show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Near {
    /// No more than what is as wide as pixels of [`GROWTH_M`].
    Nothing,
    /// What grows.
    Growth,
    /// And lakes so near that their waves show.
    Lakes,
}

/// What is drawn of ground where beaches are that waves run up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Beach {
    /// There are none.
    Absent,
    /// All but them.
    Beside,
    /// They, and what is nearest to them.
    Only,
}

impl Beach {
    /// Every one.
    pub const ALL: [Self; 3] = [Self::Absent, Self::Beside, Self::Only];
}

/// What the ground of a tile is drawn with: shaders are compiled for what may show, since software rasterisers run both sides of every branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Ground {
    /// What may show on it.
    pub near: Near,
    /// What of its beaches.
    pub beach: Beach,
    /// Whether it has relief that the data do not hold.
    pub rugged: bool,
    /// Whether there may be houses.
    pub town: bool,
    /// Whether there may be a lake or a river.
    pub inland: bool,
    /// Whether there may be coral reefs before it.
    pub reefs: bool,
}

impl Ground {
    /// What of it a kind of picture shows, with imagery or without: towns are fine, and what all show without lakes is left to [`Near::Growth`].
    fn shown(self, kind: Kind, imagery: bool) -> Self {
        let near = if kind.shows_lakes() { self.near } else { Near::Growth };
        Self { near, town: self.town && kind.fine && imagery, ..self }
    }
}

/// The composed shader of a kind of picture, with imagery or without. Beaches are never drawn without what grows beside them.
pub fn source(kind: Kind, imagery: bool, ground: Ground) -> String {
    let Ground { near, beach, rugged, town, inland, reefs } = ground.shown(kind, imagery);
    let (lakes, growth) = (near == Near::Lakes, near != Near::Nothing || beach != Beach::Absent);
    let [beside, swash] = [Beach::Beside, Beach::Only].map(|of| beach == of);
    let shown = [
        ("RUGGED", rugged),
        ("LAKES", lakes),
        ("BESIDE", beside),
        ("SWASH", swash),
        ("GROWTH", growth),
        ("TOWN", town),
        ("INLAND", inland || lakes),
        ("REEFS", reefs),
    ];
    let shown = shown.map(|(name, value)| format!("const {name}: bool = {value};\n")).concat();
    shader::composed(include_str!("../../shaders/land.wgsl"), &(kind.ground_definitions(imagery) + &shown))
}

/// The pass.
pub struct Land {
    /// Those that pictures have been drawn with so far, by what their shaders are made of.
    pipelines: HashMap<(Kind, bool, Ground), Drawing>,
    groups: [wgpu::BindGroupLayout; 3],
    formats: [wgpu::TextureFormat; 2],
    grid: wgpu::Buffer,
    indices: wgpu::Buffer,
    blocks: Blocks,
    instances: wgpu::Buffer,
    /// Of the next picture.
    draws: Vec<Draw>,
    /// What kind of picture it is, and whether there is imagery.
    kind: (Kind, bool),
    tiles: u32,
    triangles: u32,
}

/// Of so many tiles, one after the other in the buffer, what of their grids, and what it is drawn with.
struct Draw {
    by: Ground,
    indices: Range<u32>,
    instances: Range<u32>,
}

/// Indices of each block's triangles, row by row; all of them are the whole grid's.
type Blocks = Vec<Range<u32>>;

/// Grid vertices from one cell outside to one cell outside (the skirt), and their triangles, block by block.
fn mesh() -> (Vec<[f32; 2]>, Vec<u32>, Blocks) {
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
struct Part {
    ground: Ground,
    instance: Instance,
    shown: u32,
}

/// Bits of tiles' blocks, as long as there is room for those that are drawn by themselves: those of later tiles are `otherwise`, which need none.
fn with_room(tiles: Vec<u32>, otherwise: u32, room: &mut usize) -> Vec<u32> {
    let fitting = |bits: u32| {
        let count = if bits == otherwise { 0 } else { bits.count_ones() as usize };
        let fits = count <= *room;
        *room -= if fits { count } else { 0 };
        if fits { bits } else { otherwise }
    };
    tiles.into_iter().map(fitting).collect()
}

/// The draws of tiles, and their instances one after the other. Ground with relief, which is near, comes first, and beaches last: what has been drawn beside
/// them hides the rest of their blocks.
fn draws(parts: &[Part], blocks: &Blocks) -> (Vec<Draw>, Vec<Instance>) {
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

impl Land {
    /// The pass into `formats` of colour and depth; `groups` are the layouts of bind groups: frame, surface, imagery.
    pub fn new(gpu: &Gpu, groups: [&wgpu::BindGroupLayout; 3], formats: [wgpu::TextureFormat; 2]) -> Self {
        let (vertices, indices, blocks) = mesh();
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        Self {
            pipelines: HashMap::new(),
            groups: groups.map(Clone::clone),
            formats,
            grid: gpu.buffer("land grid", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&vertices)),
            indices: gpu.buffer("land indices", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices)),
            instances: gpu.empty_buffer(
                "land tiles",
                usage,
                ((MOST_TILES + MOST_BLOCKS) * size_of::<Instance>()) as u64,
            ),
            blocks,
            draws: Vec::new(),
            kind: (Kind::default(), false),
            tiles: 0,
            triangles: 0,
        }
    }

    /// Sets the tiles of the next draw of a kind of picture, with imagery or without; what comes first should be near: it spares the shading of what it hides.
    /// `ground` and `has_beach`: what a tile is drawn with but for its beaches, and whether it, or one of its descendants, may have some that waves run up.
    pub fn set_tiles(
        &mut self,
        gpu: &Gpu,
        (kind, imagery): (Kind, bool),
        tiles: impl Iterator<Item = DrawnTile>,
        ground: impl Fn(DrawnTile) -> Ground,
        has_beach: impl Fn(TileId) -> bool,
    ) {
        let tiles: Vec<_> = tiles.take(MOST_TILES).collect();
        let beaches: Vec<_> = tiles.iter().map(|tile| blocks_with(tile.id, &has_beach)).collect();
        let mut room = MOST_BLOCKS;
        let beaches = with_room(beaches, 0, &mut room);
        let shown = with_room(tiles.iter().map(|tile| tile.shown).collect(), ALL_BLOCKS, &mut room);
        let of_tile = |((tile, beaches), shown): ((DrawnTile, u32), u32)| Part {
            ground: ground(tile).shown(kind, imagery),
            instance: Instance::new(tile.id, beaches),
            shown,
        };
        let parts: Vec<_> = tiles.iter().copied().zip(beaches).zip(shown).map(of_tile).collect();
        self.kind = (kind, imagery);
        self.tiles = parts.len() as u32;
        let instances;
        (self.draws, instances) = draws(&parts, &self.blocks);
        for draw in &self.draws {
            let pipeline = || pipeline(gpu, self.groups.each_ref(), self.formats, &source(kind, imagery, draw.by));
            self.pipelines.entry((kind, imagery, draw.by)).or_insert_with(pipeline);
        }
        let triangles = |draw: &Draw| draw.instances.len() as u32 * draw.indices.len() as u32 / 3;
        self.triangles = self.draws.iter().map(triangles).sum();
        gpu.queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
    }

    /// Tiles and triangles of the next draw.
    pub fn counts(&self) -> [u32; 2] {
        [self.tiles, self.triangles]
    }

    /// Its draws.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, groups: [&wgpu::BindGroup; 3]) {
        let (kind, imagery) = self.kind;
        pass.set_vertex_buffer(0, self.grid.slice(..));
        pass.set_vertex_buffer(1, self.instances.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        (0..).zip(groups).for_each(|(index, group)| pass.set_bind_group(index, group, &[]));
        let mut by = None;
        for draw in &self.draws {
            let Some(pipeline) = self.pipelines.get(&(kind, imagery, draw.by)) else { continue };
            if by != Some(draw.by) {
                pass.set_pipeline(pipeline);
                by = Some(draw.by);
            }
            pass.draw_indexed(draw.indices.clone(), 0, draw.instances.clone());
        }
    }
}

fn pipeline(
    gpu: &Gpu,
    groups: [&wgpu::BindGroupLayout; 3],
    [colour, depth]: [wgpu::TextureFormat; 2],
    source: &str,
) -> Drawing {
    let per_vertex = wgpu::vertex_attr_array![2 => Float32x2];
    let per_tile = wgpu::vertex_attr_array![0 => Uint32x2, 1 => Uint32x2, 3 => Uint32];
    let layout = |array_stride: usize, step_mode, attributes| wgpu::VertexBufferLayout {
        array_stride: array_stride as u64,
        step_mode,
        attributes,
    };
    let buffers = [
        layout(8, wgpu::VertexStepMode::Vertex, &per_vertex),
        layout(size_of::<Instance>(), wgpu::VertexStepMode::Instance, &per_tile),
    ];
    let depth = Some(Depth::single(depth, DepthTest::Nearest));
    gpu.drawing("land", (source, "vertex"), &groups, &buffers, colour, depth)
}

#[cfg(test)]
mod tests {
    use super::*;

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
        // Eight of beaches, four that do not fit, one; then of hidden ones' tiles none fits.
        assert_eq!(with_room(vec![0xff, 0xf, 0, 1], 0, &mut room), [0xff, 0, 0, 1]);
        assert_eq!(with_room(vec![0xf, ALL_BLOCKS], ALL_BLOCKS, &mut room), [ALL_BLOCKS; 2]);
        assert_eq!(room, 0);
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
