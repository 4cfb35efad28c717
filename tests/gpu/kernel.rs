//! Small compute shaders that ask the drawing shaders' functions, and the bind group of the frame that these read.

use bytemuck::Pod;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::frame::uniform::{FrameUniform, WaveCell};
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

/// Threads of a workgroup, as every kernel declares.
const THREADS: usize = 64;

/// A shader whose last bind group has the inputs at binding 0 and N outputs from binding 1 on: one of each for an input.
pub struct Kernel<const N: usize> {
    layout: wgpu::BindGroupLayout,
    pipeline: ocean_globe::gpu::pipeline::Compute,
}

impl<const N: usize> Kernel<N> {
    /// `lower` are the layouts of the groups before the last.
    pub fn new(gpu: &Gpu, source: &str, entry: &str, lower: &[&wgpu::BindGroupLayout]) -> Self {
        let binds: Vec<Bind> = std::iter::once(Bind::Storage).chain([Bind::StorageWrite; N]).collect();
        let layout = gpu.layout("kernel", wgpu::ShaderStages::COMPUTE, &binds);
        let [pipeline] = gpu.compute(entry, source, &[lower, &[&layout]].concat(), [entry]);
        Self { layout, pipeline }
    }

    /// The outputs of every input.
    pub fn run<In: Pod, Out: Pod>(&self, gpu: &Gpu, lower: &[&wgpu::BindGroup], inputs: &[In]) -> [Vec<Out>; N] {
        use wgpu::BufferUsages as B;
        let size = (inputs.len() * size_of::<Out>()) as u64;
        let input = gpu.buffer("inputs", B::STORAGE, bytemuck::cast_slice(inputs));
        let outputs = [(); N].map(|()| gpu.empty_buffer("outputs", B::STORAGE | B::COPY_SRC, size));
        let copies = [(); N].map(|()| gpu.empty_buffer("outputs", B::MAP_READ | B::COPY_DST, size));
        let resources: Vec<_> = std::iter::once(&input).chain(&outputs).map(wgpu::Buffer::as_entire_binding).collect();
        let group = gpu.bind("kernel", &self.layout, &resources);
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&self.pipeline);
            for (index, &group) in (0..).zip(lower.iter().chain([&&group])) {
                pass.set_bind_group(index, group, &[]);
            }
            pass.dispatch_workgroups(inputs.len().div_ceil(THREADS) as u32, 1, 1);
        }
        for (output, copy) in outputs.iter().zip(&copies) {
            encoder.copy_buffer_to_buffer(output, 0, copy, 0, size);
        }
        gpu.queue.submit([encoder.finish()]);
        copies.map(|copy| {
            let bytes = gpu.read_buffer(&copy).unwrap();
            bytes.chunks_exact(size_of::<Out>()).map(bytemuck::pod_read_unaligned).collect()
        })
    }
}

/// Layout of bind group 0 as far as waves read it: frame, wave cells, samplers.
pub fn frame_layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    gpu.layout("frame", wgpu::ShaderStages::COMPUTE, &[Bind::Uniform, Bind::Uniform, Bind::Sampler, Bind::Sampler])
}

/// Bind group 0 as far as waves read it; `uniform` holds the frame's block.
pub fn frame_group(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    uniform: &wgpu::Buffer,
    wave_cells: &[WaveCell],
) -> wgpu::BindGroup {
    let wave_cells = gpu.buffer("wave_cells", wgpu::BufferUsages::UNIFORM, bytemuck::cast_slice(wave_cells));
    let clamped = gpu.sampler("clamped", wgpu::AddressMode::ClampToEdge, wgpu::MipmapFilterMode::Nearest);
    let repeated = gpu.sampler("repeated", wgpu::AddressMode::Repeat, wgpu::MipmapFilterMode::Linear);
    gpu.bind(
        "frame",
        layout,
        &[
            uniform.as_entire_binding(),
            wave_cells.as_entire_binding(),
            wgpu::BindingResource::Sampler(&clamped),
            wgpu::BindingResource::Sampler(&repeated),
        ],
    )
}

/// What a kernel with the entry `ask`, which reads `asked` and writes `found` of its group 2 and knows a frame as links have it, finds.
pub fn answers<A: Pod, F: Pod>(source: &str, asked: &[A]) -> Vec<F> {
    answers_in(source, asked, |_| {})
}

/// As [`answers`], with what `change` makes of the frame.
pub fn answers_in<A: Pod, F: Pod>(source: &str, asked: &[A], change: impl FnOnce(&mut FrameUniform)) -> Vec<F> {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let layouts = [frame_layout(&gpu), gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[])];
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(source, ""), "ask", &layouts.each_ref());
    let mut frame = Frame::new(&Settings::default(), &Camera::from_degrees(0.0, 0.0, 10.0, 0.0, 0.0), 0.0, [64; 2]);
    change(&mut frame.uniform);
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let groups = [frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), gpu.bind("unused", &layouts[1], &[])];
    let [found] = kernel.run::<_, F>(&gpu, &groups.each_ref(), asked);
    found
}
