//! Stars, where nothing nearer has been drawn.

use crate::data::stars::{Star, stars};
use crate::gpu::pipeline::{Depth, DepthTest, Drawing};
use crate::gpu::{Gpu, shader};
use crate::scene::frame::Frame;
use crate::scene::settings::Quality;

/// Floats of a star: its direction, magnitude and colour index.
const FLOATS: usize = 5;
/// How far beyond the picture's edges stars are drawn, half widths: more than a spot reaches.
const EDGE: f64 = 1.1;
/// The faintest stars of a picture of low quality, magnitudes: a fifth of all.
const FAINTEST_OF_LOW: f64 = 4.5;

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/stars.wgsl"), "")
}

/// The pass.
pub struct Stars {
    pipeline: Drawing,
    catalogue: Vec<Star>,
    /// Those that may be in the picture.
    seen: wgpu::Buffer,
    count: u32,
}

impl Stars {
    /// The pass into `formats` of colour and depth, a colour that blends; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        [colour, depth]: [wgpu::TextureFormat; 2],
    ) -> Self {
        let catalogue: Vec<Star> = stars().collect();
        let attributes = wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32];
        let buffer = wgpu::VertexBufferLayout {
            array_stride: 4 * FLOATS as u64,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &attributes,
        };
        let added = wgpu::BlendComponent {
            src_factor: wgpu::BlendFactor::One,
            dst_factor: wgpu::BlendFactor::One,
            operation: wgpu::BlendOperation::Add,
        };
        let target = wgpu::ColorTargetState {
            format: colour,
            blend: Some(wgpu::BlendState { color: added, alpha: added }),
            write_mask: wgpu::ColorWrites::ALL,
        };
        let depth = Some(Depth::single(depth, DepthTest::Undrawn));
        Self {
            pipeline: gpu.drawing("stars", (&source(), "vertex"), &[frame, surface], &[buffer], target, depth),
            seen: gpu.empty_buffer(
                "stars",
                wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                (4 * FLOATS * catalogue.len()) as u64,
            ),
            catalogue,
            count: 0,
        }
    }

    /// Turns the stars to where they stand in a frame, and picks those that may be in it: a tenth.
    pub fn prepare(&mut self, gpu: &Gpu, frame: &Frame) {
        let axes = frame.from_j2000();
        let clip = frame.uniform.clip_from_local.as_dmat4();
        let faintest = if frame.quality == Quality::Low { FAINTEST_OF_LOW } else { f64::INFINITY };
        let standing = self.catalogue.iter().filter(|star| star.magnitude < faintest).filter_map(|star| {
            let direction = axes * star.direction;
            let at = clip * direction.extend(0.0);
            let is_in = at.w > 0.0 && at.x.abs() < EDGE * at.w && at.y.abs() < EDGE * at.w;
            let [x, y, z] = direction.as_vec3().to_array();
            is_in.then_some([x, y, z, star.magnitude as f32, star.colour_index as f32])
        });
        let seen: Vec<[f32; FLOATS]> = standing.collect();
        gpu.queue.write_buffer(&self.seen, 0, bytemuck::cast_slice(&seen));
        self.count = seen.len() as u32;
    }

    /// Those of the frame, one draw.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_vertex_buffer(0, self.seen.slice(..));
        pass.draw(0..3, 0..self.count);
    }
}
