//! What the air does to light whoever looks, tabulated once for a haze: transmittance by height and zenith cosine, and the light that has
//! been scattered before by height and the sun's zenith cosine. Whoever fills them otherwise changes nobody who reads them.

use super::due::Due;
use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::scene::frame::FrameUniform;

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// Zenith cosines × heights, as S. Hillaire 2020.
const TRANSMITTANCES: [u32; 2] = [256, 64];
/// Suns × heights: twilight needs more suns than his 32.
const MULTIPLES: [u32; 2] = [64, 32];

/// The composed shaders of both tables.
pub fn sources() -> [String; 2] {
    [include_str!("../../shaders/transmittance_table.wgsl"), include_str!("../../shaders/multiple_table.wgsl")]
        .map(|text| shader::composed(text, ""))
}

/// The pass and its tables.
pub struct AirTable {
    /// For each table its pipeline, what that reads and writes, and the table's size.
    steps: [(Compute, wgpu::BindGroup, [u32; 2]); 2],
    /// By the haze.
    due: Due<f32>,
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
        let views = [("transmittance", TRANSMITTANCES), ("multiple scattering", MULTIPLES)].map(|(label, size)| {
            let shape = Shape::picture(size[0], size[1]);
            texture::view(&gpu.texture(label, shape, FORMAT, wgpu::TextureUsages::STORAGE_BINDING))
        });
        let layout = gpu.layout("air", compute, &[Bind::Texture(D2); 2]);
        let resources = views.each_ref().map(wgpu::BindingResource::TextureView);
        let group = gpu.bind("air", &layout, &resources);
        let step = |source: &str, entry, binds: &[Bind], resources: &[wgpu::BindingResource], size| {
            let own = gpu.layout(entry, compute, binds);
            let [pipeline] = gpu.compute(entry, source, &[frame, &own], [entry]);
            (pipeline, gpu.bind(entry, &own, resources), size)
        };
        let write = Bind::Write(FORMAT, D2);
        let [transmittances, multiples] = sources();
        let steps = [
            step(&transmittances, "transmittances", &[write], &resources[..1], TRANSMITTANCES),
            step(&multiples, "multiples", &[Bind::Texture(D2), write], &resources, MULTIPLES),
        ];
        let [transmittance, multiple] = views;
        Self { steps, due: Due::default(), transmittance, multiple, layout, group }
    }

    /// Looks whether a frame needs other tables than there are.
    pub fn prepare(&mut self, frame: &FrameUniform) {
        self.due.look(frame.haze);
    }

    /// Dispatches that the next [`AirTable::dispatch`] makes.
    pub fn dispatches(&self) -> usize {
        self.due.dispatches(self.steps.len())
    }

    /// Makes the tables, where they are not there.
    pub fn dispatch(&mut self, pass: &mut wgpu::ComputePass, frame: &wgpu::BindGroup) {
        if !self.due.take() {
            return;
        }
        pass.set_bind_group(0, frame, &[]);
        for (pipeline, group, size) in &self.steps {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(1, group, &[]);
            pass.dispatch_workgroups(size[0] / 8, size[1] / 8, 1);
        }
    }
}
