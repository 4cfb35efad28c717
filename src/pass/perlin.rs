//! The far sea: octaves of tileable gradient noise that drift downwind at the phase speed of waves of their length.

use bytemuck::{Pod, Zeroable};

use crate::gpu::mips::MipChain;
use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::model::dispersion;
use crate::model::perlin::{self, OCTAVES, Octaves, TEXELS};
use crate::scene::frame::Frame;

/// Texels along a side of a workgroup; equals `SIDE` in `shaders/perlin.wgsl`.
pub const SIDE: u32 = 16;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// Mirrors `PerlinSettings` in `shaders/perlin.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[expect(missing_docs, reason = "documented where the shader declares them")]
pub struct PerlinSettings {
    pub octaves: [[f32; 4]; OCTAVES],
    pub patch_length: f32,
    pub seed: u32,
    pub peak_cells: u32,
    pub unused: u32,
}

impl PerlinSettings {
    /// The noise of a sea at an instant; every phase is reduced in f64.
    pub fn of(frame: &Frame) -> Self {
        let Octaves { patch_m, amplitudes_m, .. } = frame.sea.perlin;
        let octave = |o: usize| {
            let wavelength_m = perlin::wavelength_m(patch_m, o);
            let k = std::f64::consts::TAU / wavelength_m;
            let speed = dispersion::omega_deep(k) / k;
            let drift = (frame.unix_seconds * speed / patch_m).rem_euclid(1.0);
            // The lattice turns over in some ten periods: groups live about so long.
            let turn = (frame.unix_seconds * speed / wavelength_m / 10.0).rem_euclid(1.0) * std::f64::consts::TAU;
            [drift as f32, turn as f32, amplitudes_m[o] as f32, 0.0]
        };
        Self {
            octaves: std::array::from_fn(octave),
            patch_length: patch_m as f32,
            seed: frame.sea.sea.seed,
            peak_cells: perlin::PEAK_CELLS as u32,
            unused: 0,
        }
    }
}

/// The composed shader.
pub fn source() -> String {
    shader::composed(&include_str!("../../shaders/perlin.wgsl").replace("FORMAT", "rgba16float"), "")
}

/// The pass and the texture that it fills.
pub struct Perlin {
    pipeline: Compute,
    settings: wgpu::Buffer,
    group: wgpu::BindGroup,
    mips: MipChain,
    /// (height, dh/dx, dh/dy, sum of the slopes' squares), metres; x downwind.
    pub texture: wgpu::Texture,
}

impl Perlin {
    /// The pass with a patch of [`TEXELS`] squared, as it is drawn.
    pub fn new(gpu: &Gpu) -> Self {
        Self::with_texels(gpu, TEXELS as u32)
    }

    /// The pass with a patch of `texels` squared, a multiple of [`SIDE`], for comparisons of cost: only [`TEXELS`] has the sea's slopes.
    pub fn with_texels(gpu: &Gpu, texels: u32) -> Self {
        let write = Bind::Write(FORMAT, wgpu::TextureViewDimension::D2);
        let layout = gpu.layout("perlin", wgpu::ShaderStages::COMPUTE, &[Bind::Uniform, write]);
        let [pipeline] = gpu.compute("perlin", &source(), &[&layout], ["octaves"]);
        let usage = wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::COPY_SRC;
        let texture = gpu.texture("perlin", Shape::array(texels, 1, texels.ilog2() - 1), FORMAT, usage);
        let mips = MipChain::new(gpu, &texture, "rgba16float");
        let buffer_usage = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
        let settings = gpu.empty_buffer("perlin", buffer_usage, size_of::<PerlinSettings>() as u64);
        let view = texture::picture_view(&texture, 0);
        let resources = [settings.as_entire_binding(), wgpu::BindingResource::TextureView(&view)];
        let group = gpu.bind("perlin", &layout, &resources);
        Self { pipeline, settings, group, mips, texture }
    }

    /// Sets sea and instant of the next dispatch.
    pub fn prepare(&self, gpu: &Gpu, frame: &Frame) {
        gpu.queue.write_buffer(&self.settings, 0, bytemuck::bytes_of(&PerlinSettings::of(frame)));
    }

    /// One dispatch, independent of the FFT's.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        let groups = self.texture.width() / SIDE;
        pass.dispatch_workgroups(groups, groups, 1);
    }

    /// One dispatch per four mip levels.
    pub fn dispatch_mips(&self, pass: &mut wgpu::ComputePass) {
        self.mips.dispatch(pass);
    }

    /// Dispatches of [`Perlin::dispatch`] and [`Perlin::dispatch_mips`].
    pub fn dispatches(&self) -> usize {
        1 + self.mips.dispatches()
    }
}
