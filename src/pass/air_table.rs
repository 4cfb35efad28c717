//! What the air does to light whoever looks, tabulated once for a haze: transmittance by height and zenith cosine, and the light that has
//! been scattered before by height and the sun's zenith cosine. Whoever fills them otherwise changes nobody who reads them.

use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::scene::frame::FrameUniform;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Zenith cosines × heights, as S. Hillaire 2020.
const TRANSMITTANCES: [u32; 2] = [256, 64];
/// Suns × heights: twilight needs more suns than his 32.
const MULTIPLES: [u32; 2] = [64, 32];

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/air_table.wgsl"), "")
}

/// The pass and its tables.
pub struct AirTable {
    pipelines: [Compute; 2],
    written: wgpu::BindGroup,
    /// Haze that the tables are of.
    made: Option<f32>,
    due: bool,
    /// Towards the top of the air, which drawing passes read too.
    pub transmittance: wgpu::TextureView,
    /// Light that has been scattered before.
    pub multiple: wgpu::TextureView,
    /// Layout of [`AirTable::group`].
    pub layout: wgpu::BindGroupLayout,
    /// Both tables, for the passes that make others of them.
    pub group: wgpu::BindGroup,
}

impl AirTable {
    /// Empty tables; `frame` is the layout of bind group 0.
    pub fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout) -> Self {
        use wgpu::TextureViewDimension::D2;
        let compute = wgpu::ShaderStages::COMPUTE;
        let storage = gpu.layout("air table", compute, &[Bind::Write(FORMAT, D2); 2]);
        let pipelines = gpu.compute("air table", &source(), &[frame, &storage], ["transmittances", "multiples"]);
        let views = [("transmittance", TRANSMITTANCES), ("multiple scattering", MULTIPLES)].map(|(label, size)| {
            let shape = Shape::picture(size[0], size[1]);
            texture::view(&gpu.texture(label, shape, FORMAT, wgpu::TextureUsages::STORAGE_BINDING))
        });
        let layout = gpu.layout("air", compute, &[Bind::Texture(D2); 2]);
        let resources = views.each_ref().map(wgpu::BindingResource::TextureView);
        let written = gpu.bind("air table", &storage, &resources);
        let group = gpu.bind("air", &layout, &resources);
        let [transmittance, multiple] = views;
        Self { pipelines, written, made: None, due: false, transmittance, multiple, layout, group }
    }

    /// Looks whether a frame needs other tables than there are.
    pub fn prepare(&mut self, frame: &FrameUniform) {
        self.due = self.made != Some(frame.haze);
        self.made = Some(frame.haze);
    }

    /// Dispatches that the next [`AirTable::dispatch`] makes.
    pub fn dispatches(&self) -> usize {
        if self.due { self.pipelines.len() } else { 0 }
    }

    /// Makes the tables, where they are not there.
    pub fn dispatch(&mut self, pass: &mut wgpu::ComputePass, frame: &wgpu::BindGroup) {
        if !std::mem::take(&mut self.due) {
            return;
        }
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, &self.written, &[]);
        for (pipeline, size) in self.pipelines.iter().zip([TRANSMITTANCES, MULTIPLES]) {
            pass.set_pipeline(pipeline);
            pass.dispatch_workgroups(size[0] / 8, size[1] / 8, 1);
        }
    }
}
