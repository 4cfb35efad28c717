//! A picture that the surface cuts through: the one from below is laid over the one from above where water stands before the lens.

use super::kind::Kind;
use crate::gpu::mesh::grid_triangles;
use crate::gpu::pipeline::{Bind, Drawing};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};

/// Cells of the grid over the picture, at whose corners the water's height is looked up.
const CELLS: [u32; 2] = [128, 72];

/// The composed shader.
pub fn source() -> String {
    let kind = Kind::default().definitions();
    let definitions = format!("{kind}const WAVES = true;\nconst NOISE = false;\n");
    shader::composed(include_str!("../../shaders/waterline.wgsl"), &definitions)
}

/// The pass and the picture from below.
pub struct Waterline {
    layout: wgpu::BindGroupLayout,
    pipeline: Drawing,
    format: wgpu::TextureFormat,
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    /// The picture from below, and the group with it.
    below: Option<(wgpu::Texture, wgpu::BindGroup)>,
}

impl Waterline {
    /// The pass into a colour that blends; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        format: wgpu::TextureFormat,
    ) -> Self {
        let binds = [Bind::Texels(wgpu::TextureViewDimension::D2)];
        let layout = gpu.layout("waterline", wgpu::ShaderStages::FRAGMENT, &binds);
        let attributes = wgpu::vertex_attr_array![0 => Float32x2];
        let grid = wgpu::VertexBufferLayout {
            array_stride: 8,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &attributes,
        };
        let target = wgpu::ColorTargetState {
            format,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::COLOR,
        };
        let [columns, rows] = CELLS;
        let at = |i: u32, n: u32| 2.0 * i as f32 / n as f32 - 1.0;
        let row = |j: u32| (0..=columns).map(move |i| [at(i, columns), at(j, rows)]);
        let vertices: Vec<[f32; 2]> = (0..=rows).flat_map(row).collect();
        let indices = grid_triangles(columns, rows);
        let pipeline =
            gpu.drawing("waterline", (&source(), "vertex"), &[frame, surface, &layout], &[grid], target, None);
        Self {
            layout,
            pipeline,
            format,
            vertices: gpu.buffer("waterline", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&vertices)),
            indices: gpu.buffer("waterline indices", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices)),
            below: None,
        }
    }

    /// What to draw the picture from below into, of a picture of `size` pixels.
    pub fn below(&mut self, gpu: &Gpu, size: [u32; 2]) -> wgpu::TextureView {
        let kept = self.below.take().filter(|(picture, _)| [picture.width(), picture.height()] == size);
        let (picture, _) = self.below.insert(kept.unwrap_or_else(|| {
            let shape = Shape::picture(size[0], size[1]);
            let picture = gpu.texture("below", shape, self.format, wgpu::TextureUsages::RENDER_ATTACHMENT);
            let view = texture::view(&picture);
            let group = gpu.bind("waterline", &self.layout, &[wgpu::BindingResource::TextureView(&view)]);
            (picture, group)
        }));
        texture::view(picture)
    }

    /// Lays it over what a pass has drawn.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        let Some((_, below)) = &self.below else { return };
        pass.set_pipeline(&self.pipeline);
        for (index, group) in (0..).zip([frame, surface, below]) {
            pass.set_bind_group(index, group, &[]);
        }
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..6 * CELLS[0] * CELLS[1], 0, 0..1);
    }
}
