//! Dry land, lakes and the sea bed: one grid with a skirt for every visible map tile, in instanced draws. What beaches show that waves run up takes much
//! longer than other ground, and is a narrow strip: where tiles have one they are drawn without it, and then those of their blocks that it crosses once more.
//! Tiles of which the sea hides a part, or a part is its bed alone, which takes less than land, are drawn block by block, too.

mod draws;

use std::collections::HashMap;

pub use draws::GRID;
use draws::{Blocks, Draw, Instance, Part, draws, land_and_bed, mesh, with_room};

use super::kind::Kind;
use crate::data::tile::TileId;
use crate::gpu::pipeline::{Depth, DepthTest, Drawing};
use crate::gpu::{Gpu, shader};
use crate::scene::view::map_tiles::{DrawnTile, blocks_with};

const MOST_TILES: usize = 1_024;
/// Drawn by themselves, in one picture; tiles that come later have no beaches and are drawn whole.
const MOST_BLOCKS: usize = 4_096;

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
    /// Whether it is the sea's bed, on which nothing of the land shows.
    pub bed: bool,
}

impl Ground {
    /// What of it a kind of picture shows, with imagery or without: towns are fine, and what all show without lakes is left to [`Near::Growth`].
    fn shown(self, kind: Kind, imagery: bool) -> Self {
        let near = if kind.shows_lakes() || self.bed { self.near } else { Near::Growth };
        Self { near, town: self.town && kind.fine && imagery, ..self }
    }
}

/// The composed shader of a kind of picture, with imagery or without. Beaches are never drawn without what grows beside them.
pub fn source(kind: Kind, imagery: bool, ground: Ground) -> String {
    let Ground { near, beach, rugged, town, inland, reefs, bed } = ground.shown(kind, imagery);
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
        ("BED_ALONE", bed),
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
    /// `ground`: what a tile is drawn with but for its beaches, and, for `true`, those of its blocks that have a bed alone; `has_beach`: whether it, or one of its descendants, may
    /// have some that waves run up.
    pub fn set_tiles(
        &mut self,
        gpu: &Gpu,
        (kind, imagery): (Kind, bool),
        tiles: impl Iterator<Item = DrawnTile>,
        ground: impl Fn(DrawnTile, bool) -> Ground,
        has_beach: impl Fn(TileId) -> bool,
    ) {
        let tiles: Vec<_> = tiles.take(MOST_TILES).collect();
        let beaches: Vec<_> = tiles.iter().map(|tile| blocks_with(tile.id, &has_beach)).collect();
        let mut room = MOST_BLOCKS;
        let beaches = with_room(beaches, &mut room);
        let of_tile = |(tile, beaches): (&DrawnTile, u32)| {
            let [land, bed] = land_and_bed(tile, &mut room);
            let part = |shown, is_bed, beaches| Part {
                ground: ground(*tile, is_bed).shown(kind, imagery),
                instance: Instance::new(tile.id, beaches),
                shown,
            };
            let land = (land != 0 || beaches != 0).then(|| part(land, false, beaches));
            land.into_iter().chain((bed != 0).then(|| part(bed, true, 0)))
        };
        let parts: Vec<_> = tiles.iter().zip(beaches).flat_map(of_tile).collect();
        self.kind = (kind, imagery);
        self.tiles = tiles.len() as u32;
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
