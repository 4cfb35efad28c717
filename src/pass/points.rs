//! Points of light, added to what has been drawn, where nothing nearer has been.

use crate::gpu::Gpu;
use crate::gpu::pipeline::{Depth, DepthTest, Drawing};

/// What the shader is told of a point: four numbers and another.
pub type Point = [f32; 5];

/// Points and what draws them.
pub struct Points {
    pipeline: Drawing,
    shown: wgpu::Buffer,
    most: usize,
    count: u32,
}

impl Points {
    /// At most so many points by a composed shader into `formats` of colour and depth, a colour that blends; `frame` and `surface` are the
    /// layouts of bind groups 0 and 1.
    pub fn new(
        gpu: &Gpu,
        (label, source, most): (&str, &str, usize),
        frame: &wgpu::BindGroupLayout,
        surface: &wgpu::BindGroupLayout,
        [colour, depth]: [wgpu::TextureFormat; 2],
    ) -> Self {
        let attributes = wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32];
        let buffer = wgpu::VertexBufferLayout {
            array_stride: size_of::<Point>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
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
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        Self {
            pipeline: gpu.drawing(label, (source, "vertex"), &[frame, surface], &[buffer], target, depth),
            shown: gpu.empty_buffer(label, usage, (most * size_of::<[Point; 3]>()) as u64),
            most,
            count: 0,
        }
    }

    /// Sets the points that are drawn; those beyond the most are not.
    pub fn show(&mut self, gpu: &Gpu, points: &[Point]) {
        let points = &points[..points.len().min(self.most)];
        // Once for each corner: an instance of a single triangle costs a processor that stands in for a graphics card 4 µs.
        let corners: Vec<[Point; 3]> = points.iter().map(|point| [*point; 3]).collect();
        gpu.queue.write_buffer(&self.shown, 0, bytemuck::cast_slice(&corners));
        self.count = points.len() as u32;
    }

    /// One draw.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_vertex_buffer(0, self.shown.slice(..));
        pass.draw(0..3 * self.count, 0..1);
    }
}
