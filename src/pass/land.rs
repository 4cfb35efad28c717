//! Dry land, lakes and the sea bed: one grid with a skirt for every visible map tile, in one instanced draw.

use bytemuck::{Pod, Zeroable};

use super::kind::{ByGround, Kind};
use crate::data::tile::TileId;
use crate::gpu::mesh::grid_triangles;
use crate::gpu::pipeline::{Depth, DepthTest};
use crate::gpu::{Gpu, shader};
use crate::scene::view::map_tiles::DrawnTile;

/// Cells along a side of a tile's grid; equals `GRID` in `shaders/land.wgsl`.
pub const GRID: u32 = 16;
const MOST_TILES: usize = 1_024;

#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Instance {
    square: u32,
    level: u32,
    x: u32,
    y: u32,
}

/// Pixels on the nearest ground that are so wide, metres, show nothing of what grows on it: seven tenths of a cell of the widest lattice of
/// `shaders/lib/plants.wgsl`, at the equator.
pub const GROWTH_M: f64 = 26.0;

/// What of the ground of a whole picture may show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Near {
    /// No more than what is as wide as pixels of [`GROWTH_M`].
    Nothing,
    /// What grows.
    Growth,
    /// And lakes so near that their waves show.
    Lakes,
}

impl Near {
    const ALL: [Self; 3] = [Self::Nothing, Self::Growth, Self::Lakes];

    /// Whether pictures of a kind are drawn so: what all show without it is left to [`Near::Growth`].
    fn is_of(self, kind: Kind) -> bool {
        self == Self::Growth || kind.shows_lakes()
    }
}

/// The composed shader of a kind of picture, with imagery or without; of ground with relief that the data do not hold or without, and with beaches
/// that waves run up or without: these are never drawn without what grows beside them.
pub fn source(kind: Kind, imagery: bool, near: Near, [rugged, beach]: [bool; 2]) -> String {
    let (lakes, growth) = (near == Near::Lakes, near != Near::Nothing || beach);
    let shown = [("RUGGED", rugged), ("LAKES", lakes), ("SWASH", beach), ("GROWTH", growth)];
    let shown = shown.map(|(name, value)| format!("const {name}: bool = {value};\n")).concat();
    shader::composed(include_str!("../../shaders/land.wgsl"), &(kind.ground_definitions(imagery) + &shown))
}

/// The pass.
pub struct Land {
    /// As [`Near::ALL`], each of ground without relief of its own and without beaches, with relief, with beaches, with both.
    pipelines: [[ByGround; 4]; 3],
    grid: wgpu::Buffer,
    indices: wgpu::Buffer,
    index_count: u32,
    instances: wgpu::Buffer,
    /// What may show in the next draw.
    near: Near,
    /// And its tiles, as the pipelines; those with water inland, then the others; the last come first.
    counts: [u32; 8],
}

/// Grid vertices from one cell outside to one cell outside (the skirt), and their triangles.
fn mesh() -> (Vec<[f32; 2]>, Vec<u32>) {
    let side = GRID + 3;
    let at = |i: u32| i as f32 - 1.0;
    let vertices = (0..side * side).map(|v| [at(v % side), at(v / side)]).collect();
    (vertices, grid_triangles(side - 1, side - 1))
}

impl Land {
    /// The pass into `colour` and `depth` formats; `groups` are the layouts of bind groups: frame, surface, imagery.
    pub fn new(gpu: &Gpu, groups: [&wgpu::BindGroupLayout; 3], [colour, depth]: [wgpu::TextureFormat; 2]) -> Self {
        let per_vertex = wgpu::vertex_attr_array![2 => Float32x2];
        let per_tile = wgpu::vertex_attr_array![0 => Uint32x2, 1 => Uint32x2];
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
        let pipelines = |near: Near, ground: usize| {
            let [rugged, beach] = [1, 2].map(|bit| ground & bit != 0);
            let source = |kind, imagery| source(kind, imagery, near, [rugged, beach]);
            let kinds = move || Kind::all().filter(move |kind| near.is_of(*kind) && (!beach || kind.shows_lakes()));
            ByGround::new(kinds, |kind, imagery| {
                gpu.drawing("land", (&source(kind, imagery), "vertex"), &groups, &buffers, colour, depth)
            })
        };
        let (vertices, indices) = mesh();
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        Self {
            pipelines: Near::ALL.map(|near| [0, 1, 2, 3].map(|ground| pipelines(near, ground))),
            grid: gpu.buffer("land grid", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&vertices)),
            index_count: indices.len() as u32,
            indices: gpu.buffer("land indices", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices)),
            instances: gpu.empty_buffer("land tiles", usage, (MOST_TILES * size_of::<Instance>()) as u64),
            near: Near::Growth,
            counts: [0; 8],
        }
    }

    /// Sets what may show in the next draw, and its tiles, each with whether it may have beaches that waves run up, and lakes or rivers; what comes first should be
    /// near: it spares the shading of what it hides.
    pub fn set_tiles(&mut self, gpu: &Gpu, near: Near, tiles: impl Iterator<Item = (DrawnTile, [bool; 2])>) {
        let mut grounds: [Vec<TileId>; 8] = Default::default();
        for (DrawnTile { id, is_rugged }, [beach, inland]) in tiles.take(MOST_TILES) {
            grounds[usize::from(is_rugged) + 2 * usize::from(beach) + 4 * usize::from(!inland)].push(id);
        }
        let instance =
            |id: &TileId| Instance { square: id.projection as u32, level: u32::from(id.z), x: id.x, y: id.y };
        let instances: Vec<Instance> = grounds.iter().rev().flatten().map(instance).collect();
        gpu.queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
        self.near = near;
        self.counts = grounds.map(|tiles| tiles.len() as u32);
    }

    /// Tiles and triangles of the next draw.
    pub fn counts(&self) -> [u32; 2] {
        let tiles = self.counts.iter().sum();
        [tiles, tiles * (self.index_count / 3)]
    }

    /// Its draws, eight at most, of a kind and with imagery or without.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, kind: (Kind, bool), groups: [&wgpu::BindGroup; 3]) {
        let mut drawn = 0;
        let near = if self.near.is_of(kind.0) { self.near } else { Near::Growth };
        // Waves of lakes cost as much as all else where none is, too.
        let dry = if near == Near::Lakes { Near::Growth } else { near };
        let pipelines = [near, dry].map(|near| &self.pipelines[near as usize]).into_iter().flatten();
        let draws: Vec<_> = pipelines.zip(self.counts).collect();
        for (pipelines, count) in draws.into_iter().rev() {
            let tiles = drawn..drawn + count;
            drawn += count;
            if tiles.is_empty() || !pipelines.set(pass, kind, groups) {
                continue;
            }
            pass.set_vertex_buffer(0, self.grid.slice(..));
            pass.set_vertex_buffer(1, self.instances.slice(..));
            pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..self.index_count, 0, tiles);
        }
    }
}
