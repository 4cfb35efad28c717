//! The weather of clouds over the whole earth, made anew when a frame's instant has another.

use bytemuck::{Pod, Zeroable};
use glam::Vec4;

use super::due::Due;
use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::{Gpu, shader};
use crate::model::clouds::{self, MAP_TEXELS, STORMS, Weather};
use crate::scene::frame::constants::clouds_field;

/// The composed shader.
pub fn source() -> String {
    let storms = format!("const STORMS = {STORMS}u;\n");
    shader::composed(include_str!("../../shaders/cloud_map.wgsl"), &(storms + &clouds_field()))
}

/// What the shader is told of a weather.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Told {
    storms: [[Vec4; STORMS]; 2],
    weights: [f32; 2],
    numbers: [u32; 2],
}

/// The pass and its map.
pub struct CloudMap {
    pipeline: Compute,
    group: wgpu::BindGroup,
    told: wgpu::Buffer,
    due: Due<Weather>,
    /// Levels, for drawing passes.
    pub levels: wgpu::Buffer,
}

impl CloudMap {
    /// An empty map.
    pub fn new(gpu: &Gpu) -> Self {
        use wgpu::BufferUsages as B;
        let layout = gpu.layout("cloud map", wgpu::ShaderStages::COMPUTE, &[Bind::Uniform, Bind::StorageWrite]);
        let told = gpu.empty_buffer("weather", B::UNIFORM | B::COPY_DST, size_of::<Told>() as u64);
        let levels = gpu.empty_buffer("cloud levels", B::STORAGE, u64::from(MAP_TEXELS * MAP_TEXELS) * 8);
        let [pipeline] = gpu.compute("cloud map", &source(), &[&layout], ["make"]);
        let group = gpu.bind("cloud map", &layout, &[told.as_entire_binding(), levels.as_entire_binding()]);
        Self { pipeline, group, told, due: Due::default(), levels }
    }

    /// Looks whether a frame needs another weather than there is.
    pub fn prepare(&mut self, gpu: &Gpu, weather: Weather) {
        self.due.look(weather);
        if self.due.dispatches(1) == 1 {
            let storms = weather.numbers.map(clouds::storms);
            let told = Told { storms, weights: weather.weights, numbers: weather.numbers };
            gpu.queue.write_buffer(&self.told, 0, bytemuck::bytes_of(&told));
        }
    }

    /// Dispatches that the next [`CloudMap::dispatch`] makes.
    pub fn dispatches(&self) -> usize {
        self.due.dispatches(1)
    }

    /// Makes the map, where it is not there.
    pub fn dispatch(&mut self, pass: &mut wgpu::ComputePass) {
        if self.due.take() {
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &self.group, &[]);
            pass.dispatch_workgroups(MAP_TEXELS / 8, MAP_TEXELS / 8, 1);
        }
    }
}
