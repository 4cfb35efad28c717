//! The sea: a grid projected from the screen onto the ellipsoid, over the scene that land and sky have left.

use crate::gpu::mesh::grid_triangles;
use crate::gpu::pipeline::Bind;
use crate::gpu::{Gpu, shader};

/// Pixels per cell of the grid.
const CELL_PIXELS: u32 = 4;
/// Cells along a side, at most: with two triangles per cell more than a million of them.
const MOST_CELLS: u32 = 800;

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/ocean.wgsl"), "")
}

/// The pass.
pub struct Ocean {
    pipeline: wgpu::RenderPipeline,
    scene_layout: wgpu::BindGroupLayout,
    scene: Option<wgpu::BindGroup>,
    size: [u32; 2],
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    index_count: u32,
}

fn mesh(size: [u32; 2]) -> (Vec<[f32; 2]>, Vec<u32>) {
    let [columns, rows] = size.map(|pixels| pixels.div_ceil(CELL_PIXELS).clamp(16, MOST_CELLS));
    let at = |i: u32, n: u32| 2.0 * i as f32 / n as f32 - 1.0;
    let row = |j: u32| (0..=columns).map(move |i| [at(i, columns), at(j, rows)]);
    ((0..=rows).flat_map(row).collect(), grid_triangles(columns, rows))
}

impl Ocean {
    /// The pass into `colour` and `depth` formats; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        colour: wgpu::TextureFormat,
        depth: wgpu::TextureFormat,
    ) -> Self {
        let binds = [Bind::Texels(wgpu::TextureViewDimension::D2), Bind::Depth];
        let scene_layout = gpu.layout("scene", wgpu::ShaderStages::FRAGMENT, &binds);
        let attributes = wgpu::vertex_attr_array![0 => Float32x2];
        let buffers = [wgpu::VertexBufferLayout {
            array_stride: 8,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &attributes,
        }];
        let groups = [frame, surface, &scene_layout];
        let pipeline = gpu.drawing("ocean", &source(), &groups, &buffers, colour, Some(depth));
        let empty = |usage| gpu.empty_buffer("sea grid", usage, 4);
        Self {
            pipeline,
            scene_layout,
            scene: None,
            size: [0; 2],
            vertices: empty(wgpu::BufferUsages::VERTEX),
            indices: empty(wgpu::BufferUsages::INDEX),
            index_count: 0,
        }
    }

    /// Takes the scene's colour and depth, and makes the grid of a picture of `size` pixels.
    pub fn set_scene(&mut self, gpu: &Gpu, size: [u32; 2], colour: &wgpu::TextureView, depth: &wgpu::TextureView) {
        let resources = [colour, depth].map(wgpu::BindingResource::TextureView);
        self.scene = Some(gpu.bind("scene", &self.scene_layout, &resources));
        if size != self.size {
            let (vertices, indices) = mesh(size);
            self.vertices = gpu.buffer("sea grid", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&vertices));
            self.indices = gpu.buffer("sea indices", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices));
            self.index_count = indices.len() as u32;
            self.size = size;
        }
    }

    /// One draw.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_bind_group(2, &self.scene, &[]);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.index_count, 0, 0..1);
    }
}
