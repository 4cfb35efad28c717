//! Stars, where nothing nearer has been drawn.

use crate::data::stars::stars;
use crate::gpu::pipeline::{Bind, Depth, DepthTest, Drawing};
use crate::gpu::{Gpu, shader};
use crate::scene::frame::Frame;
use crate::scene::settings::Quality;

/// A star of magnitude 0, as the display's tone takes it: those of magnitude 6 are just seen on black.
const BRIGHTNESS: f32 = 6.0;
/// Floats of a star: its direction, magnitude and colour index.
const FLOATS: usize = 5;
/// How far beyond the picture's edges stars are drawn, half widths: more than a spot reaches.
const EDGE: f32 = 1.1;
/// The faintest stars of a picture of low quality, magnitudes: a fifth of all.
const FAINTEST_OF_LOW: f32 = 4.5;

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/stars.wgsl"), "")
}

/// The pass.
pub struct Stars {
    pipeline: Drawing,
    uniform: wgpu::Buffer,
    group: wgpu::BindGroup,
    /// All stars, and those that may be in the picture.
    catalogue: Vec<[f32; FLOATS]>,
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
        let catalogue: Vec<[f32; FLOATS]> = stars()
            .map(|star| {
                let [x, y, z] = star.direction.as_vec3().to_array();
                [x, y, z, star.magnitude as f32, star.colour_index as f32]
            })
            .collect();
        let layout = gpu.layout("stars", wgpu::ShaderStages::VERTEX, &[Bind::Uniform]);
        let uniform = gpu.empty_buffer("stars", wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST, 64);
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
            pipeline: gpu.drawing("stars", (&source(), "vertex"), &[frame, surface, &layout], &[buffer], target, depth),
            group: gpu.bind("stars", &layout, &[uniform.as_entire_binding()]),
            uniform,
            count: 0,
            seen: gpu.buffer("stars", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&catalogue)),
            catalogue,
        }
    }

    /// Turns the stars to where they stand in a frame, and picks those that may be in it: a tenth.
    pub fn prepare(&mut self, gpu: &Gpu, frame: &Frame) {
        let axes = frame.from_j2000();
        let mut block = [0.0_f32; 16];
        for (column, axis) in [axes.x_axis, axes.y_axis, axes.z_axis].into_iter().enumerate() {
            block[4 * column..4 * column + 3].copy_from_slice(&axis.as_vec3().to_array());
        }
        block[12] = BRIGHTNESS;
        gpu.queue.write_buffer(&self.uniform, 0, bytemuck::cast_slice(&block));
        let clip = frame.uniform.clip_from_local * glam::Mat4::from_mat3(axes.as_mat3());
        let faintest = if frame.quality == Quality::Low { FAINTEST_OF_LOW } else { f32::INFINITY };
        let is_seen = |star: &&[f32; FLOATS]| {
            let at = clip * glam::Vec4::new(star[0], star[1], star[2], 0.0);
            star[3] < faintest && at.w > 0.0 && at.x.abs() < EDGE * at.w && at.y.abs() < EDGE * at.w
        };
        let seen: Vec<_> = self.catalogue.iter().filter(is_seen).copied().collect();
        self.count = seen.len() as u32;
        if self.count > 0 {
            gpu.queue.write_buffer(&self.seen, 0, bytemuck::cast_slice(&seen));
        }
    }

    /// Those of the frame, one draw.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_bind_group(2, &self.group, &[]);
        pass.set_vertex_buffer(0, self.seen.slice(..));
        pass.draw(0..3, 0..self.count);
    }
}
