//! Skylight at sea level, tabulated once for a haze: radiance by view and sun, irradiance by sun.

use super::due::Due;
use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::scene::frame::FrameUniform;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
const VIEWS: u32 = 32;
const AZIMUTHS: u32 = 16;
const SUNS: u32 = 32;
const IRRADIANCES: u32 = 64;

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/sky_table.wgsl"), "")
}

/// The pass and its tables.
pub struct SkyTable {
    pipelines: [Compute; 2],
    group: wgpu::BindGroup,
    /// By the haze.
    due: Due<f32>,
    /// View zenith cosine × azimuth from the sun × sun zenith cosine.
    pub radiance: wgpu::TextureView,
    /// By sun zenith cosine.
    pub irradiance: wgpu::TextureView,
}

impl SkyTable {
    /// Empty tables; `frame` is the layout of bind group 0, `air` that of the tables that these are made of.
    pub fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout, air: &wgpu::BindGroupLayout) -> Self {
        use wgpu::TextureViewDimension::{D2, D3};
        let binds = [Bind::Write(FORMAT, D3), Bind::Write(FORMAT, D2)];
        let layout = gpu.layout("sky table", wgpu::ShaderStages::COMPUTE, &binds);
        let pipelines = gpu.compute("sky table", &source(), &[frame, air, &layout], ["radiances", "irradiances"]);
        let usage = wgpu::TextureUsages::STORAGE_BINDING;
        let volume = Shape { depth: SUNS, dimension: wgpu::TextureDimension::D3, ..Shape::picture(VIEWS, AZIMUTHS) };
        let radiance = texture::view(&gpu.texture("sky radiance", volume, FORMAT, usage));
        let irradiance = texture::view(&gpu.texture("sky irradiance", Shape::picture(IRRADIANCES, 1), FORMAT, usage));
        let views = [&radiance, &irradiance].map(wgpu::BindingResource::TextureView);
        let group = gpu.bind("sky table", &layout, &views);
        Self { pipelines, group, due: Due::default(), radiance, irradiance }
    }

    /// Looks whether a frame needs other tables than there are.
    pub fn prepare(&mut self, frame: &FrameUniform) {
        self.due.look(frame.haze);
    }

    /// Dispatches that the next [`SkyTable::dispatch`] makes.
    pub fn dispatches(&self) -> usize {
        self.due.dispatches(self.pipelines.len())
    }

    /// Makes the tables, where they are not there.
    pub fn dispatch(&mut self, pass: &mut wgpu::ComputePass, frame: &wgpu::BindGroup, air: &wgpu::BindGroup) {
        if !self.due.take() {
            return;
        }
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, air, &[]);
        pass.set_bind_group(2, &self.group, &[]);
        pass.set_pipeline(&self.pipelines[0]);
        pass.dispatch_workgroups(VIEWS / 4, AZIMUTHS / 4, SUNS / 4);
        pass.set_pipeline(&self.pipelines[1]);
        pass.dispatch_workgroups(IRRADIANCES / 64, 1, 1);
    }
}
