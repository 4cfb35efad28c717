//! The waves: spectrum in time, two-dimensional inverse FFT of eight fields for every cascade in two dispatches, mip levels.
//!
//! Each workgroup transforms whole rows or columns, eight elements per thread in registers, after
//! [Govindaraju et al.](crate::bibliography::Govindaraju2008). A dispatch takes all cascades whose intermediate values fit into
//! one storage binding (128 MiB by default):
//!
//! ```text
//!                  bytes per element   four cascades of 256² … 1024²   of 2048²
//!  Precision::Half                16                    2 dispatches          4
//!  Precision::Single              32                    2 dispatches          8
//! ```

use std::ops::Range;
use std::sync::Arc;

use bytemuck::{Pod, Zeroable};

use crate::gpu::mips::MipChain;
use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::model::wave_data::words;
use crate::model::waves::Cascade;

pub use crate::model::wave_data::WaveData;

/// Mirrors `Evolution` in `shaders/fft.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[expect(missing_docs, reason = "documented where the shader declares them")]
pub struct Evolution {
    pub ticks: [u32; 2],
    pub depth: f32,
    pub sharpened: u32,
    pub patches: [f32; 4],
    pub scales: [[f32; 4]; 8],
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

    /// Bytes of an element of the four complex fields between the two dispatches.
    pub fn bytes_halfway(self) -> u64 {
        match self {
            Self::Half => 16,
            Self::Single => 32,
        }
    }
}

/// What the pass is to make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Everything: what is drawn.
    All,
    /// [`Fft::stretches`] alone, by half the transforms: what foam is made from.
    Stretches,
}

/// How a workgroup of the pass is made for patches of `n` samples: (lines, complex fields per exchange). Eight elements per thread;
/// lines and fields are chosen so that at least 64 threads work together (from 128 samples) and the exchange fits into the
/// 16,384 bytes of workgroup memory.
fn workgroup(n: usize, wanted: Wanted) -> (usize, usize) {
    match (n, wanted) {
        (..=512, Wanted::All) => ((512 / n).clamp(1, n), 4),
        (..=512, Wanted::Stretches) => ((512 / n).clamp(1, n), 2),
        (1024, _) => (1, 2),
        _ => (1, 1),
    }
}

/// The composed shader of patches of `n` samples.
pub fn source(n: usize, precision: Precision, wanted: Wanted) -> String {
    let (lines, exchanged) = workgroup(n, wanted);
    let halves = if wanted == Wanted::All { 2 } else { 1 };
    let first = [8, 2, 4][n.ilog2() as usize % 3];
    let half = precision == Precision::Half;
    let text = include_str!("../../shaders/fft.wgsl").replace("FORMAT", precision.format().1);
    let text = text.replace("exchange_FIELDS", &format!("exchange_{exchanged}"));
    let definitions = format!(
        "const N: u32 = {n}u;\nconst LINES: u32 = {lines}u;\nconst FIRST: u32 = {first}u;\nconst HALF: bool = {half};\n\
         const HALVES: u32 = {halves}u;"
    );
    shader::composed(&text, &definitions)
}

/// The patches of each batch: as many as `room`, the largest storage binding in bytes, holds halfway through the transform.
pub fn batches(n: usize, layers: usize, precision: Precision, room: u64) -> Vec<Range<usize>> {
    let together = (room / ((n * n) as u64 * precision.bytes_halfway())).max(1) as usize;
    (0..layers).step_by(together).map(|first| first..layers.min(first + together)).collect()
}

/// Patches that one binding of the intermediate values holds: their two dispatches share it with the other batches.
struct Batch {
    patches: Range<usize>,
    evolution: wgpu::Buffer,
    group: wgpu::BindGroup,
}

/// The pass and the textures that it fills.
pub struct Fft {
    n: usize,
    /// Rows and columns.
    all: [Compute; 2],
    stretches_alone: [Compute; 2],
    amplitudes: wgpu::Buffer,
    frequencies: wgpu::Buffer,
    /// Those in the buffer: seas on the same patches share them.
    known_frequencies: Option<Arc<Vec<[u32; 2]>>>,
    batches: Vec<Batch>,
    mips: MipChain,
    cascades: Vec<Cascade>,
    scales: Vec<[[f32; 4]; 2]>,
    depth_m: f64,
    sharpened: bool,
    /// (Dx, Dy, height, 0) in metres, one layer per cascade.
    pub displacements: wgpu::Texture,
    /// (dh/dx, dh/dy, (dh/dx)², (dh/dy)²): the squares' means in its mip levels hold what a pixel cannot resolve.
    pub slopes: wgpu::Texture,
    /// (dDx/dx, dDy/dy, dDx/dy, 0).
    pub stretches: wgpu::Texture,
}

impl Fft {
    /// A pass for up to four `layers` of `n` by `n` samples (a power of two from 16 to 2048), all waves still zero.
    pub fn new(gpu: &Gpu, n: usize, layers: usize, precision: Precision) -> Self {
        use wgpu::{BufferUsages as B, TextureUsages as T, TextureViewDimension::D2Array};
        let (format, name) = precision.format();
        let shape = Shape::array(n as u32, layers as u32, n.ilog2() - 1);
        let make = |label| gpu.texture(label, shape, format, T::STORAGE_BINDING | T::COPY_SRC);
        let [displacements, slopes, stretches] = ["displacements", "slopes", "stretches"].map(make);
        let write = Bind::Write(format, D2Array);
        let compute = wgpu::ShaderStages::COMPUTE;
        let binds =
            [Bind::Uniform, Bind::Storage, Bind::Storage, Bind::Storage, Bind::StorageWrite, write, write, write];
        let layout = gpu.layout("fft", compute, &binds);
        let [all, stretches_alone] = [Wanted::All, Wanted::Stretches]
            .map(|wanted| gpu.compute("fft", &source(n, precision, wanted), &[&layout], ["rows", "columns"]));

        let samples = (n * n) as u64;
        let batches = batches(n, layers, precision, gpu.device.limits().max_storage_buffer_binding_size);
        let largest = batches.iter().map(|patches| patches.len()).max().unwrap_or(1) as u64;
        let waves = |label| gpu.empty_buffer(label, B::STORAGE | B::COPY_DST, samples * 8 * layers as u64);
        let (amplitudes, frequencies) = (waves("amplitudes"), waves("frequencies"));
        let halfway = gpu.empty_buffer("halfway", B::STORAGE, samples * precision.bytes_halfway() * largest);
        let twiddles = gpu.buffer("twiddles", B::STORAGE, bytemuck::cast_slice(&twiddles(n)));
        let batch = |patches: Range<usize>| {
            let evolution = gpu.empty_buffer("evolution", B::UNIFORM | B::COPY_DST, size_of::<Evolution>() as u64);
            let part = |buffer| {
                let size = wgpu::BufferSize::new(samples * 8 * patches.len() as u64);
                wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                    buffer,
                    offset: samples * 8 * patches.start as u64,
                    size,
                })
            };
            let [d, g, m] = [&displacements, &slopes, &stretches].map(|t| texture::layers_view(t, &patches));
            let resources = [
                evolution.as_entire_binding(),
                part(&amplitudes),
                part(&frequencies),
                twiddles.as_entire_binding(),
                halfway.as_entire_binding(),
                wgpu::BindingResource::TextureView(&d),
                wgpu::BindingResource::TextureView(&g),
                wgpu::BindingResource::TextureView(&m),
            ];
            let group = gpu.bind("fft", &layout, &resources);
            Batch { patches, evolution, group }
        };
        let batches = batches.into_iter().map(batch).collect();
        let mips = MipChain::of(gpu, &[&displacements, &slopes, &stretches], name);
        let (cascades, scales) = (Vec::new(), Vec::new());
        Self {
            sharpened: false,
            depth_m: f64::INFINITY,
            n,
            all,
            stretches_alone,
            amplitudes,
            frequencies,
            known_frequencies: None,
            batches,
            mips,
            cascades,
            scales,
            displacements,
            slopes,
            stretches,
        }
    }

    /// Takes new waves. `cascades` say the patch lengths; `data` holds n² elements for each.
    pub fn set_waves(&mut self, gpu: &Gpu, cascades: &[Cascade], data: &WaveData) {
        gpu.queue.write_buffer(&self.amplitudes, 0, bytemuck::cast_slice(&data.amplitudes));
        if self.known_frequencies.as_ref().is_none_or(|known| !Arc::ptr_eq(known, &data.frequencies)) {
            gpu.queue.write_buffer(&self.frequencies, 0, bytemuck::cast_slice(&data.frequencies));
            self.known_frequencies = Some(data.frequencies.clone());
        }
        self.scales.clone_from(&data.scales);
        self.depth_m = data.depth_m;
        self.cascades = cascades.to_vec();
    }

    /// Whether heights and displacements make up for the linear interpolation that they are drawn with
    /// ([`interpolation_gain`](crate::model::surface::interpolation_gain)): so is what is drawn. Without it they are the model's at
    /// the samples.
    pub fn sharpened(self, sharpened: bool) -> Self {
        Self { sharpened, ..self }
    }

    /// Samples along a side.
    pub fn samples(&self) -> usize {
        self.n
    }

    /// Sets the instant of the next [`Fft::dispatch`] or [`Fft::dispatch_stretches`], in ticks of the wave clock.
    pub fn set_time(&self, gpu: &Gpu, ticks: u64) {
        for batch in &self.batches {
            let first = batch.patches.start;
            let length = |i: usize| self.cascades.get(first + i).map_or(1.0, |c| c.patch_m as f32);
            let scale = |i: usize| self.scales.get(first + i / 2).map_or([1.0; 4], |pair| pair[i % 2]);
            let evolution = Evolution {
                ticks: words(ticks),
                depth: self.depth_m.min(1e6) as f32,
                sharpened: u32::from(self.sharpened),
                patches: std::array::from_fn(length),
                scales: std::array::from_fn(scale),
            };
            gpu.queue.write_buffer(&batch.evolution, 0, bytemuck::bytes_of(&evolution));
        }
    }

    /// Two dispatches for the waves of all cascades of a batch.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass) {
        self.transform(pass, Wanted::All);
    }

    fn transform(&self, pass: &mut wgpu::ComputePass, wanted: Wanted) {
        let groups = (self.n / workgroup(self.n, wanted).0) as u32;
        let pipelines = if wanted == Wanted::All { &self.all } else { &self.stretches_alone };
        for batch in &self.batches {
            let patches = batch.patches.end.min(self.cascades.len()).saturating_sub(batch.patches.start) as u32;
            pass.set_bind_group(0, &batch.group, &[]);
            for pipeline in pipelines {
                pass.set_pipeline(pipeline);
                pass.dispatch_workgroups(groups, patches, 1);
            }
        }
    }

    /// Dispatches of one [`Fft::dispatch`].
    pub fn dispatches(&self) -> usize {
        2 * self.batches.len()
    }

    /// The mip levels of the three textures.
    pub fn dispatch_mips(&self, pass: &mut wgpu::ComputePass) {
        self.mips.dispatch(pass);
    }

    /// [`Fft::stretches`] alone, with their mips: what foam is made from. The other textures keep what they hold.
    pub fn dispatch_stretches(&self, pass: &mut wgpu::ComputePass) {
        self.transform(pass, Wanted::Stretches);
        self.mips.dispatch_from(pass, 2);
    }

    /// Dispatches of one [`Fft::dispatch_stretches`].
    pub fn stretch_dispatches(&self) -> usize {
        // Mips of one of three textures.
        self.dispatches() + self.mips.dispatches() / 3
    }

    /// Dispatches of one [`Fft::dispatch_mips`].
    pub fn mip_dispatches(&self) -> usize {
        self.mips.dispatches()
    }
}

/// exp(2πi·j/n), from f64.
fn twiddles(n: usize) -> Vec<[f32; 2]> {
    let twiddle = |j: usize| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * j as f64 / n as f64);
        [cos as f32, sin as f32]
    };
    (0..n).map(twiddle).collect()
}
