//! The waves: spectrum in time, two-dimensional inverse FFT of eight fields for every cascade in two dispatches, mip levels.

use bytemuck::{Pod, Zeroable};

use crate::gpu::mips::MipChain;
use crate::gpu::pipeline::Bind;
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::model::waves::{self, Cascade};
use crate::scene::sea::SeaTables;

/// Mirrors `Evolution` in `shaders/fft.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[expect(missing_docs, reason = "documented where the shader declares them")]
pub struct Evolution {
    pub ticks: [u32; 2],
    pub cascade_count: u32,
    pub unused: u32,
    pub patches: [f32; 4],
}

/// The storage of the wave textures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// 16-bit floats: what is drawn.
    Half,
    /// 32-bit floats: what is compared with the model.
    Single,
}

impl Precision {
    /// The texture format and its name in WGSL.
    pub fn format(self) -> (wgpu::TextureFormat, &'static str) {
        match self {
            Self::Half => (wgpu::TextureFormat::Rgba16Float, "rgba16float"),
            Self::Single => (wgpu::TextureFormat::Rgba32Float, "rgba32float"),
        }
    }
}

/// Amplitudes and frequencies of all cascades, one after another: what the waves of a sea are made of.
#[derive(Clone, Debug, Default)]
pub struct WaveData {
    /// h0(k), metres.
    pub amplitudes: Vec<[f32; 2]>,
    /// Cycles per tick in fixed point, low and high word.
    pub frequencies: Vec<[u32; 2]>,
}

impl WaveData {
    /// Appends one cascade from f64 amplitudes and frequencies (rad/s) in wave index order.
    pub fn push(&mut self, amplitudes: &[[f64; 2]], omegas: &[f64]) {
        self.amplitudes.extend(amplitudes.iter().map(|h| h.map(|x| x as f32)));
        self.frequencies.extend(omegas.iter().map(|&omega| words(waves::cycles_per_tick(omega))));
    }

    /// All cascades of a sea.
    pub fn of(tables: &SeaTables) -> Self {
        let mut data = Self::default();
        for (i, cascade) in tables.cascades.iter().enumerate() {
            let amplitudes = waves::initial_amplitudes(&tables.sea, i, cascade);
            data.push(&amplitudes, &waves::angular_frequencies(cascade, f64::INFINITY));
        }
        data
    }
}

/// Low and high word.
pub fn words(x: u64) -> [u32; 2] {
    [x as u32, (x >> 32) as u32]
}

/// The composed shader of tiles of `n` samples.
pub fn source(n: usize, precision: Precision) -> String {
    let text = include_str!("../../shaders/fft.wgsl").replace("FORMAT", precision.format().1);
    shader::composed(&text, &format!("const N: u32 = {n}u;"))
}

/// The pass and the textures that it fills.
pub struct Fft {
    n: usize,
    rows: wgpu::ComputePipeline,
    columns: wgpu::ComputePipeline,
    evolution: wgpu::Buffer,
    amplitudes: wgpu::Buffer,
    frequencies: wgpu::Buffer,
    group: wgpu::BindGroup,
    mips: [MipChain; 2],
    cascades: Vec<Cascade>,
    /// (Dx, Dy, height, dDx/dy) in metres, one layer per cascade.
    pub displacements: wgpu::Texture,
    /// (dh/dx, dh/dy, dDx/dx, dDy/dy).
    pub gradients: wgpu::Texture,
}

impl Fft {
    /// A pass for `layers` cascades of `n` by `n` samples (a power of two from 16 to 512), all waves still zero.
    pub fn new(gpu: &Gpu, n: usize, layers: usize, precision: Precision) -> Self {
        use wgpu::{BufferUsages as B, TextureUsages as T, TextureViewDimension::D2Array};
        let (format, _) = precision.format();
        let mips = n.ilog2() + 1 - 2;
        let shape = Shape::array(n as u32, layers as u32, mips);
        let make = |label| gpu.texture(label, shape, format, T::STORAGE_BINDING | T::COPY_SRC);
        let (displacements, gradients) = (make("displacements"), make("gradients"));
        let write = Bind::Write(format, D2Array);
        let compute = wgpu::ShaderStages::COMPUTE;
        let binds = [Bind::Uniform, Bind::Storage, Bind::Storage, Bind::Storage, Bind::StorageWrite, write, write];
        let layout = gpu.layout("fft", compute, &binds);
        let [rows, columns] = gpu.compute("fft", &source(n, precision), &[&layout], ["rows", "columns"]);

        let count = (n * n * layers) as u64;
        let evolution = gpu.empty_buffer("evolution", B::UNIFORM | B::COPY_DST, size_of::<Evolution>() as u64);
        let amplitudes = gpu.empty_buffer("amplitudes", B::STORAGE | B::COPY_DST, count * 8);
        let frequencies = gpu.empty_buffer("frequencies", B::STORAGE | B::COPY_DST, count * 8);
        let halfway = gpu.empty_buffer("halfway", B::STORAGE, count * 32);
        let twiddles: Vec<[f32; 2]> = (0..n)
            .map(|i| {
                let angle = std::f64::consts::TAU * i as f64 / n as f64;
                [libm::cos(angle) as f32, libm::sin(angle) as f32]
            })
            .collect();
        let twiddles = gpu.buffer("twiddles", B::STORAGE, bytemuck::cast_slice(&twiddles));
        let level = |t: &wgpu::Texture, mip| texture::mip_view(t, mip);
        let group = gpu.bind(
            "fft",
            &layout,
            &[
                evolution.as_entire_binding(),
                amplitudes.as_entire_binding(),
                frequencies.as_entire_binding(),
                twiddles.as_entire_binding(),
                halfway.as_entire_binding(),
                wgpu::BindingResource::TextureView(&level(&displacements, 0)),
                wgpu::BindingResource::TextureView(&level(&gradients, 0)),
            ],
        );
        let mips = [&displacements, &gradients].map(|t| MipChain::new(gpu, t, precision.format().1));
        Self {
            n,
            rows,
            columns,
            evolution,
            amplitudes,
            frequencies,
            group,
            mips,
            cascades: Vec::new(),
            displacements,
            gradients,
        }
    }

    /// Takes new waves. `cascades` say the patch lengths; `data` holds n² elements for each.
    pub fn set_waves(&mut self, gpu: &Gpu, cascades: &[Cascade], data: &WaveData) {
        gpu.queue.write_buffer(&self.amplitudes, 0, bytemuck::cast_slice(&data.amplitudes));
        gpu.queue.write_buffer(&self.frequencies, 0, bytemuck::cast_slice(&data.frequencies));
        self.cascades = cascades.to_vec();
    }

    /// Samples along a side.
    pub fn samples(&self) -> usize {
        self.n
    }

    /// Sets the instant of the next [`Fft::dispatch`], in ticks of the wave clock.
    pub fn set_time(&self, gpu: &Gpu, ticks: u64) {
        let patch = |i: usize| self.cascades.get(i).map_or(1.0, |c| c.patch_m as f32);
        let evolution = Evolution {
            ticks: words(ticks),
            cascade_count: self.cascades.len() as u32,
            unused: 0,
            patches: std::array::from_fn(patch),
        };
        gpu.queue.write_buffer(&self.evolution, 0, bytemuck::bytes_of(&evolution));
    }

    /// Two dispatches for the waves of all cascades.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass) {
        let (n, layers) = (self.n as u32, self.cascades.len() as u32);
        pass.set_bind_group(0, &self.group, &[]);
        pass.set_pipeline(&self.rows);
        pass.dispatch_workgroups(n, layers, 1);
        pass.set_pipeline(&self.columns);
        pass.dispatch_workgroups(n, layers, 1);
    }

    /// One dispatch per mip level of each texture.
    pub fn dispatch_mips(&self, pass: &mut wgpu::ComputePass) {
        self.mips.iter().for_each(|chain| chain.dispatch(pass));
    }
}
