//! The far sea: octaves of tileable gradient noise that drift downwind at the phase speed of waves of their length.

use bytemuck::{Pod, Zeroable};

use crate::gpu::mips::MipChain;
use crate::gpu::pipeline::Bind;
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::model::dispersion;
use crate::scene::frame::{Frame, perlin_patch_m};

/// Octaves of the noise; equals `OCTAVES` in `shaders/perlin.wgsl`.
pub const OCTAVES: usize = 4;
/// Texels along a side.
const TEXELS: u32 = 256;
/// Texels along a side of a workgroup; equals `SIDE` in `shaders/perlin.wgsl`.
pub const SIDE: u32 = 16;
/// Lattice cells along the wind in the first octave: gradient noise has its strongest wave at about 1.6 cells.
const PEAK_CELLS: u32 = 8;
/// Height of an octave over that of the one before: between a k⁻⁴ sea's 2^-1 and Toba's 2^-1.25… rounded to the rougher.
const GAIN: f64 = 0.45;
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
        let patch = perlin_patch_m(&frame.sea);
        let unit = unit_variance();
        let total: f64 = (0..OCTAVES).map(|o| GAIN.powi(2 * o as i32) * unit).sum();
        let octave = |o: usize| {
            let cells = f64::from(PEAK_CELLS << o);
            let wavelength = 1.6 * patch / cells;
            let k = std::f64::consts::TAU / wavelength;
            let speed = dispersion::omega_deep(k) / k;
            let drift = (frame.unix_seconds * speed / patch).rem_euclid(1.0);
            // The lattice turns over in some ten periods: groups live about so long.
            let turn = (frame.unix_seconds * speed / wavelength / 10.0).rem_euclid(1.0) * std::f64::consts::TAU;
            [drift as f32, turn as f32, (GAIN.powi(o as i32) / total.sqrt()) as f32, 0.0]
        };
        Self {
            octaves: std::array::from_fn(octave),
            patch_length: patch as f32,
            seed: frame.sea.sea.seed,
            peak_cells: PEAK_CELLS,
            unused: 0,
        }
    }
}

/// Variance of gradient noise with unit gradients of random direction and the quintic fade, by the midpoint rule over a cell:
/// the four corners are independent, each contributes weight² · |offset|² / 2.
fn unit_variance() -> f64 {
    const STEPS: usize = 32;
    let fade = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let mut sum = 0.0;
    for (i, j) in (0..STEPS * STEPS).map(|s| (s % STEPS, s / STEPS)) {
        let at = |k: usize| (k as f64 + 0.5) / STEPS as f64;
        for (cx, cy) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
            let weight = |c: f64, t: f64| if c == 0.0 { 1.0 - fade(t) } else { fade(t) };
            let w = weight(cx, at(i)) * weight(cy, at(j));
            sum += w * w * 0.5 * ((at(i) - cx).powi(2) + (at(j) - cy).powi(2));
        }
    }
    sum / (STEPS * STEPS) as f64
}

/// The composed shader.
pub fn source() -> String {
    shader::composed(&include_str!("../../shaders/perlin.wgsl").replace("FORMAT", "rgba16float"), "")
}

/// The pass and the texture that it fills.
pub struct Perlin {
    pipeline: wgpu::ComputePipeline,
    settings: wgpu::Buffer,
    group: wgpu::BindGroup,
    mips: MipChain,
    /// (height, dh/dx, dh/dy, 0): unit standard deviation of height, slopes per metre; x downwind.
    pub texture: wgpu::Texture,
}

impl Perlin {
    /// The pass with a tile of 256 by 256 texels.
    pub fn new(gpu: &Gpu) -> Self {
        let write = Bind::Write(FORMAT, wgpu::TextureViewDimension::D2);
        let layout = gpu.layout("perlin", wgpu::ShaderStages::COMPUTE, &[Bind::Uniform, write]);
        let [pipeline] = gpu.compute("perlin", &source(), &[&layout], ["octaves"]);
        let usage = wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::COPY_SRC;
        let texture = gpu.texture("perlin", Shape::array(TEXELS, 1, TEXELS.ilog2() - 1), FORMAT, usage);
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
        pass.dispatch_workgroups(TEXELS / SIDE, TEXELS / SIDE, 1);
    }

    /// One dispatch per mip level.
    pub fn dispatch_mips(&self, pass: &mut wgpu::ComputePass) {
        self.mips.dispatch(pass);
    }
}
