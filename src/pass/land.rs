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

/// The composed shader of a kind of picture, with imagery or without; of ground with relief that the data do not hold or without, with lakes
/// so near that their waves show or without, with beaches that waves run up or without.
pub fn source(kind: Kind, imagery: bool, [rugged, lakes, beach]: [bool; 3]) -> String {
    let shown = [("RUGGED", rugged), ("LAKES", lakes), ("SWASH", beach)];
    let shown = shown.map(|(name, value)| format!("const {name}: bool = {value};\n")).concat();
    shader::composed(include_str!("../../shaders/land.wgsl"), &(kind.ground_definitions(imagery) + &shown))
}

/// The pass.
pub struct Land {
    /// Without waves of lakes and with, each of ground without relief of its own and without beaches, with relief, with beaches, with both.
    pipelines: [[ByGround; 4]; 2],
    grid: wgpu::Buffer,
    indices: wgpu::Buffer,
    index_count: u32,
    instances: wgpu::Buffer,
    /// Tiles of the next draw: as the pipelines; the last come first.
    counts: [u32; 4],
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
        let pipelines = |lakes: bool, ground: usize| {
            let [rugged, beach] = [1, 2].map(|bit| ground & bit != 0);
            let source = |kind, imagery| source(kind, imagery, [rugged, lakes, beach]);
            let kinds = move || Kind::all().filter(move |kind| !(lakes || beach) || kind.shows_lakes());
            ByGround::new(kinds, |kind, imagery| {
                gpu.drawing("land", (&source(kind, imagery), "vertex"), &groups, &buffers, colour, depth)
            })
        };
        let (vertices, indices) = mesh();
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        Self {
            pipelines: [false, true].map(|lakes| [0, 1, 2, 3].map(|ground| pipelines(lakes, ground))),
            grid: gpu.buffer("land grid", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&vertices)),
            index_count: indices.len() as u32,
            indices: gpu.buffer("land indices", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices)),
            instances: gpu.empty_buffer("land tiles", usage, (MOST_TILES * size_of::<Instance>()) as u64),
            counts: [0; 4],
        }
    }

    /// Sets the tiles of the next draw, and whether each may have beaches that waves run up; what comes first should be near: it spares the
    /// shading of what it hides.
    pub fn set_tiles(&mut self, gpu: &Gpu, tiles: impl Iterator<Item = (DrawnTile, bool)>) {
        let mut grounds: [Vec<TileId>; 4] = Default::default();
        for (DrawnTile { id, is_rugged }, beach) in tiles.take(MOST_TILES) {
            grounds[usize::from(is_rugged) + 2 * usize::from(beach)].push(id);
        }
        let instance =
            |id: &TileId| Instance { square: id.projection as u32, level: u32::from(id.z), x: id.x, y: id.y };
        let instances: Vec<Instance> = grounds.iter().rev().flatten().map(instance).collect();
        gpu.queue.write_buffer(&self.instances, 0, bytemuck::cast_slice(&instances));
        self.counts = grounds.map(|tiles| tiles.len() as u32);
    }

    /// Tiles and triangles of the next draw.
    pub fn counts(&self) -> [u32; 2] {
        let tiles = self.counts.iter().sum();
        [tiles, tiles * (self.index_count / 3)]
    }

    /// Its draws, four at most, of a kind and with imagery or without, with waves of lakes or without.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass,
        (kind, lakes): ((Kind, bool), bool),
        groups: [&wgpu::BindGroup; 3],
    ) {
        let mut drawn = 0;
        let lakes = usize::from(lakes && kind.0.shows_lakes());
        for (pipelines, count) in self.pipelines[lakes].iter().zip(self.counts).rev() {
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
