//! Two published ways of doing the four transforms, re-typed from their description, to be compared with ours: each transforms
//! four spectra that are already there, and leaves evolution, unpacking and products out, which ours does as well.

use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::texture::{self, Shape};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::{fft, noise};
use wgpu::BufferUsages as B;

use crate::measure::{Work, assert_close, submit};

const FIELDS: usize = 4;
/// Two transforms of log2 N rounded butterflies in 32-bit floats: some 1e-7 each, and room for an order of magnitude.
const TOLERANCE: f64 = 1e-5;

/// A contender: what it records, and what it has left behind.
pub trait Peer {
    fn record(&self, pass: &mut wgpu::ComputePass);
    fn dispatches(&self) -> usize;
    fn bytes(&self) -> u64;
    /// The transformed field, [re, im] of each element.
    fn result(&self, gpu: &Gpu, field: usize) -> Vec<f64>;
}

/// Four spectra of white noise.
fn spectrum(n: usize, field: usize) -> Vec<[f32; 2]> {
    let at = |index: usize| noise::gaussian_pair(9, field as u32, (index % n) as i32, (index / n) as i32);
    (0..n * n).map(|index| at(index).map(|x| x as f32)).collect()
}

/// Runs a peer once and compares all that it has made with the transform in f64.
pub fn verify(gpu: &Gpu, what: &str, n: usize, peer: &dyn Peer) {
    let work: Work = &|pass| peer.record(pass);
    submit(gpu, work);
    for field in 0..FIELDS {
        let mut want: Vec<[f64; 2]> = spectrum(n, field).iter().map(|c| c.map(f64::from)).collect();
        fft::inverse_2d(&mut want, n);
        assert_close(what, &peer.result(gpu, field), want.as_flattened(), TOLERANCE);
    }
}

fn twiddles(gpu: &Gpu, n: usize) -> wgpu::Buffer {
    let turn = |i: usize| {
        let (sin, cos) = (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
        [cos as f32, sin as f32]
    };
    let table: Vec<[f32; 2]> = (0..n).map(turn).collect();
    gpu.buffer("twiddles", B::STORAGE, bytemuck::cast_slice(&table))
}

fn numbers(bytes: &[u8]) -> Vec<f64> {
    bytemuck::pod_collect_to_vec::<u8, f32>(bytes).into_iter().map(f64::from).collect()
}

/// One dispatch per butterfly stage, axis and field, from texture to texture.
pub struct Stages {
    n: usize,
    pipeline: ocean_globe::gpu::pipeline::Compute,
    groups: Vec<wgpu::BindGroup>,
    results: Vec<wgpu::Texture>,
}

impl Stages {
    pub fn new(gpu: &Gpu, n: usize) -> Self {
        use wgpu::{TextureUsages as T, TextureViewDimension::D2};
        let format = wgpu::TextureFormat::Rg32Float;
        let binds = [Bind::Uniform, Bind::Storage, Bind::Texels(D2), Bind::Write(format, D2)];
        let layout = gpu.layout("stages", wgpu::ShaderStages::COMPUTE, &binds);
        let source = shader::composed(include_str!("stages.wgsl"), &format!("const N: u32 = {n}u;"));
        let [pipeline] = gpu.compute("stages", &source, &[&layout], ["butterfly"]);
        let table = twiddles(gpu, n);
        let (mut groups, mut results) = (Vec::new(), Vec::new());
        for field in 0..FIELDS {
            let usage = T::STORAGE_BINDING | T::COPY_DST | T::COPY_SRC;
            let shape = Shape::picture(n as u32, n as u32);
            let [input, a, b] = ["input", "a", "b"].map(|label| gpu.texture(label, shape, format, usage));
            let rows = wgpu::TexelCopyBufferLayout { bytes_per_row: Some(8 * n as u32), ..Default::default() };
            let values = spectrum(n, field);
            gpu.queue.write_texture(input.as_image_copy(), bytemuck::cast_slice(&values), rows, input.size());
            let [input, first, second] = [&input, &a, &b].map(texture::view);
            for stage in 0..2 * n.ilog2() {
                let (axis, stride) = (stage / n.ilog2(), 1u32 << (stage % n.ilog2()));
                let settings = gpu.buffer("stage", B::UNIFORM, bytemuck::cast_slice(&[stride, axis, 0, 0]));
                let (from, to) = match stage {
                    0 => (&input, &first),
                    _ if stage % 2 == 0 => (&second, &first),
                    _ => (&first, &second),
                };
                let resources = [
                    settings.as_entire_binding(),
                    table.as_entire_binding(),
                    wgpu::BindingResource::TextureView(from),
                    wgpu::BindingResource::TextureView(to),
                ];
                groups.push(gpu.bind("stage", &layout, &resources));
            }
            results.push(b);
        }
        Self { n, pipeline, groups, results }
    }
}

impl Peer for Stages {
    fn record(&self, pass: &mut wgpu::ComputePass) {
        pass.set_pipeline(&self.pipeline);
        let groups = self.n as u32 / 16;
        for group in &self.groups {
            pass.set_bind_group(0, group, &[]);
            pass.dispatch_workgroups(groups, groups, 1);
        }
    }

    fn dispatches(&self) -> usize {
        self.groups.len()
    }

    fn bytes(&self) -> u64 {
        (self.groups.len() * self.n * self.n * 16) as u64
    }

    fn result(&self, gpu: &Gpu, field: usize) -> Vec<f64> {
        numbers(&gpu.read_texture(&self.results[field], 0, 0).expect("the device answers"))
    }
}

/// Rows in workgroup memory by radix 2, a transpose, rows, a transpose.
pub struct Transposed {
    n: usize,
    rows: ocean_globe::gpu::pipeline::Compute,
    transpose: ocean_globe::gpu::pipeline::Compute,
    groups: [wgpu::BindGroup; 3],
    result: wgpu::Buffer,
}

impl Transposed {
    /// For at most 512 samples: half as many threads work on a row.
    pub fn new(gpu: &Gpu, n: usize) -> Self {
        let binds = [Bind::Storage, Bind::Storage, Bind::StorageWrite];
        let layout = gpu.layout("transposed", wgpu::ShaderStages::COMPUTE, &binds);
        let definitions = format!("const N: u32 = {n}u;\nconst BITS: u32 = {}u;", n.ilog2());
        let source = shader::composed(include_str!("transpose.wgsl"), &definitions);
        let [rows, transpose] = gpu.compute("transposed", &source, &[&layout], ["rows", "transpose"]);
        let table = twiddles(gpu, n);
        let values: Vec<[f32; 2]> = (0..FIELDS).flat_map(|field| spectrum(n, field)).collect();
        let input = gpu.buffer("input", B::STORAGE, bytemuck::cast_slice(&values));
        let [a, b] = ["a", "b"].map(|label| gpu.empty_buffer(label, B::STORAGE | B::COPY_SRC, input.size()));
        let groups = [(&input, &a), (&a, &b), (&b, &a)].map(|(from, to)| {
            let resources = [&table, from, to].map(wgpu::Buffer::as_entire_binding);
            gpu.bind("transposed", &layout, &resources)
        });
        Self { n, rows, transpose, groups, result: b }
    }
}

impl Peer for Transposed {
    fn record(&self, pass: &mut wgpu::ComputePass) {
        let (n, fields) = (self.n as u32, FIELDS as u32);
        let [first, forth, back] = &self.groups;
        for (group, across) in [(first, false), (forth, true), (back, false), (forth, true)] {
            pass.set_bind_group(0, group, &[]);
            pass.set_pipeline(if across { &self.transpose } else { &self.rows });
            if across {
                pass.dispatch_workgroups(n / 16, n / 16, fields);
            } else {
                pass.dispatch_workgroups(n, fields, 1);
            }
        }
    }

    fn dispatches(&self) -> usize {
        4
    }

    fn bytes(&self) -> u64 {
        (4 * FIELDS * self.n * self.n * 16) as u64
    }

    fn result(&self, gpu: &Gpu, field: usize) -> Vec<f64> {
        let bytes = self.result.size() / FIELDS as u64;
        let read = gpu.empty_buffer("read", B::COPY_DST | B::MAP_READ, bytes);
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(&self.result, field as u64 * bytes, &read, 0, bytes);
        gpu.queue.submit([encoder.finish()]);
        numbers(&gpu.read_buffer(&read).expect("the device answers"))
    }
}
