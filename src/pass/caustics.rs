//! Light that the waves gather on the bed about an eye: a net of sun rays, drawn where it meets the bed.

use super::kind::Kind;
use crate::gpu::drawing::{Colour, begin};
use crate::gpu::mesh::grid_triangles;
use crate::gpu::pipeline::Drawing;
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};

/// Cells along a side of the net.
pub const CELLS: u32 = 384;
/// Texels along a side of the map.
pub const TEXELS: u32 = 1024;
/// Of the map, which holds irradiance over its mean.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R16Float;
/// Samples of a texel: many triangles are narrower than texels.
const SAMPLES: u32 = 4;

/// Whose the light on the bed is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rays {
    /// A flat surface's.
    Even,
    /// That of an eye in the water.
    InWater,
    /// That of an eye over the water.
    FromAbove {
        /// Whether there are shores with surf.
        surf: bool,
    },
}

impl Rays {
    /// Those that need a shader.
    pub const DRAWN: [Self; 3] = [Self::InWater, Self::FromAbove { surf: false }, Self::FromAbove { surf: true }];
}

/// The composed shader of one of [`Rays::DRAWN`].
pub fn source(rays: Rays) -> String {
    let above = rays != Rays::InWater;
    let surf = rays == Rays::FromAbove { surf: true };
    let kind = Kind { fine: true, under_water: !above, ..Kind::default() }.definitions();
    let flags = [("WAVES", true), ("NOISE", false), ("ABOVE", above), ("SURF", surf)];
    let flags = flags.map(|(name, value)| format!("const {name} = {value};\n")).concat();
    let definitions = format!("{kind}{flags}const CAUSTIC_CELLS = {CELLS}.0;\n");
    shader::composed(include_str!("../../shaders/caustics.wgsl"), &definitions)
}

/// What the map is drawn with.
struct Net {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    samples: wgpu::TextureView,
}

/// The pass and its map.
pub struct Caustics {
    /// One of each of [`Rays::DRAWN`].
    pipelines: [Drawing; 3],
    /// Made when an eye first sees any.
    net: Option<Net>,
    /// Irradiance of the bed by the sun over that under a flat surface; `shaders/lib/caustic_map.wgsl` knows where its texels lie.
    pub map: wgpu::Texture,
}

fn net() -> (Vec<[f32; 2]>, Vec<u32>) {
    let at = |i: u32| 2.0 * i as f32 / CELLS as f32 - 1.0;
    let row = |j: u32| (0..=CELLS).map(move |i| [at(i), at(j)]);
    ((0..=CELLS).flat_map(row).collect(), grid_triangles(CELLS, CELLS))
}

impl Caustics {
    /// `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout, surface: &wgpu::BindGroupLayout) -> Self {
        let attributes = wgpu::vertex_attr_array![0 => Float32x2];
        let grid = wgpu::VertexBufferLayout {
            array_stride: 8,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &attributes,
        };
        let added = wgpu::BlendComponent {
            src_factor: wgpu::BlendFactor::One,
            dst_factor: wgpu::BlendFactor::One,
            operation: wgpu::BlendOperation::Add,
        };
        let target = wgpu::ColorTargetState {
            format: FORMAT,
            blend: Some(wgpu::BlendState { color: added, alpha: added }),
            write_mask: wgpu::ColorWrites::RED,
        };
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let groups = [frame, surface];
        let pipeline = |rays| {
            let grid = std::slice::from_ref(&grid);
            gpu.drawing_into(
                "caustics",
                (&source(rays), "vertex"),
                &groups,
                grid,
                std::slice::from_ref(&target),
                None,
                SAMPLES,
            )
        };
        Self {
            pipelines: Rays::DRAWN.map(pipeline),
            net: None,
            map: gpu.texture("caustics", Shape::picture(TEXELS, TEXELS), FORMAT, usage),
        }
    }

    /// Makes the net, once.
    pub fn prepare(&mut self, gpu: &Gpu) {
        self.net.get_or_insert_with(|| {
            let (vertices, indices) = net();
            let shape = Shape { samples: SAMPLES, ..Shape::picture(TEXELS, TEXELS) };
            let samples = gpu.texture("caustic samples", shape, FORMAT, wgpu::TextureUsages::RENDER_ATTACHMENT);
            Net {
                vertices: gpu.buffer("caustics", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&vertices)),
                indices: gpu.buffer("caustic indices", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices)),
                samples: texture::view(&samples),
            }
        });
    }

    /// Draws the map.
    pub fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        rays: Rays,
        frame: &wgpu::BindGroup,
        surface: &wgpu::BindGroup,
    ) {
        let map = texture::view(&self.map);
        let pipeline = Rays::DRAWN.iter().position(|drawn| *drawn == rays).map(|index| &self.pipelines[index]);
        let Some((pipeline, Net { vertices, indices, samples })) = pipeline.zip(self.net.as_ref()) else {
            drop(begin(encoder, "caustics", &map, wgpu::Color::WHITE, None));
            return;
        };
        let colour = Colour { view: samples, mean: Some(&map) };
        let mut pass = begin(encoder, "caustics", colour, wgpu::Color::TRANSPARENT, None);
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..6 * CELLS * CELLS, 0, 0..1);
    }
}
