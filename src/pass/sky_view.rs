//! The air that the eye sees, tabulated for all directions: the sky's radiance, and radiance and transmittance of the haze before
//! surfaces. The tables last as long as the eye is where it is and the sun where it stands: turning the head costs nothing.

use super::due::Due;
use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::scene::frame::FrameUniform;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Azimuths on one side of the sun, which stands for the other.
const AZIMUTHS: u32 = 32;
/// And elevations.
const ROWS: u32 = 96;
/// Azimuths × elevations of the sky.
const SKY: [u32; 2] = [AZIMUTHS, ROWS];
/// Azimuths, with two columns for the transmittance, × elevations, two fifths of them above the horizon (`haze_first_above`), × distances.
const HAZE: [u32; 3] = [AZIMUTHS + 2, ROWS, 32];

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/sky_view.wgsl"), "")
}

/// What the tables depend on: the ellipsoid about the eye, what lights it, how deep troughs are, and the haze.
#[derive(Clone, Copy, PartialEq)]
struct Made {
    quadric: [glam::Vec3; 3],
    heights: [f32; 3],
    light: glam::Vec3,
    haze: f32,
}

impl Made {
    fn of(u: &FrameUniform) -> Self {
        Self {
            quadric: [u.quadric_diagonal, u.quadric_mixed, u.quadric_gradient],
            heights: [u.quadric_constant, u.eye_altitude, u.crest_height],
            haze: u.haze,
            light: u.light,
        }
    }
}

/// The pass and its tables.
pub struct SkyView {
    pipelines: [Compute; 2],
    written: wgpu::BindGroup,
    due: Due<Made>,
    /// The sky.
    pub sky: wgpu::TextureView,
    /// The haze.
    pub haze: wgpu::TextureView,
}

impl SkyView {
    /// Empty tables; `frame` is the layout of bind group 0, `air` that of [`super::air_table::AirTable::group`].
    pub fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout, air: &wgpu::BindGroupLayout) -> Self {
        use wgpu::TextureViewDimension::{D2, D3};
        let binds = [Bind::Write(FORMAT, D2), Bind::Write(FORMAT, D3)];
        let storage = gpu.layout("sky view", wgpu::ShaderStages::COMPUTE, &binds);
        let pipelines = gpu.compute("sky view", &source(), &[frame, air, &storage], ["skies", "hazes"]);
        let usage = wgpu::TextureUsages::STORAGE_BINDING;
        let volume =
            Shape { depth: HAZE[2], dimension: wgpu::TextureDimension::D3, ..Shape::picture(HAZE[0], HAZE[1]) };
        let sky = texture::view(&gpu.texture("sky view", Shape::picture(SKY[0], SKY[1]), FORMAT, usage));
        let haze = texture::view(&gpu.texture("haze", volume, FORMAT, usage));
        let written = gpu.bind("sky view", &storage, &[&sky, &haze].map(wgpu::BindingResource::TextureView));
        Self { pipelines, written, due: Due::default(), sky, haze }
    }

    /// Looks whether a frame needs other tables than there are.
    pub fn prepare(&mut self, frame: &FrameUniform) {
        self.due.look(Made::of(frame));
    }

    /// Dispatches of the frame.
    pub fn dispatches(&self) -> usize {
        self.due.dispatches(self.pipelines.len())
    }

    /// Makes the frame's tables, where they are not there; `air` is [`super::air_table::AirTable::group`].
    pub fn dispatch(&mut self, pass: &mut wgpu::ComputePass, frame: &wgpu::BindGroup, air: &wgpu::BindGroup) {
        if !self.due.take() {
            return;
        }
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, air, &[]);
        pass.set_bind_group(2, &self.written, &[]);
        for pipeline in &self.pipelines {
            pass.set_pipeline(pipeline);
            pass.dispatch_workgroups(AZIMUTHS.div_ceil(8), ROWS.div_ceil(8), 1);
        }
    }
}
