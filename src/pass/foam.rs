//! Foam in time: one dispatch advances the four levels of the foam map. What it means: `model/foam.rs`,
//! where it lies: `scene/sea/foam.rs`, when it moves on: `scene/sea/foam_history.rs`.

use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::model::lace;
use crate::scene::sea::foam::TEXELS;
use crate::scene::sea::foam_history::FoamStep;

/// 32 bits: 16 would round the small steps of a fast picture away, each driver in its own way.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;
/// Dispatches of one [`Foam::dispatch`].
pub const DISPATCHES: usize = 1;
/// Texels along a side of a workgroup.
const SIDE: u32 = 8;

/// The composed shader.
pub fn source() -> String {
    shader::composed(&include_str!("../../shaders/foam.wgsl").replace("FORMAT", "rgba32float"), "")
}

/// The pass and its two maps, of which one is read while the other is written.
pub struct Foam {
    /// Of steps in which time passes, and of those that only follow the eye.
    pipelines: [Compute; 2],
    step: wgpu::Buffer,
    is_due: bool,
    /// `groups[i]` writes the other map than `maps[i]`.
    groups: [wgpu::BindGroup; 2],
    /// The maps, for bind group 1.
    pub maps: [wgpu::TextureView; 2],
    /// The maps' textures.
    pub textures: [wgpu::Texture; 2],
    current: usize,
    /// The tile of the lace, for bind group 1, and whether it is there.
    pub lace: wgpu::Texture,
    has_lace: bool,
}

impl Foam {
    /// Empty maps, all foam over the young; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout, surface: &wgpu::BindGroupLayout) -> Self {
        let binds = [Bind::Uniform, Bind::Write(FORMAT, wgpu::TextureViewDimension::D2)];
        let layout = gpu.layout("foam", wgpu::ShaderStages::COMPUTE, &binds);
        let pipelines = gpu.compute("foam", &source(), &[frame, surface, &layout], ["advance", "follow"]);
        let usage = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
        let step = gpu.empty_buffer("foam step", usage, size_of::<FoamStep>() as u64);
        let shape = Shape::picture(TEXELS as u32, 2 * TEXELS as u32);
        let usage = wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::COPY_SRC;
        let textures = [0, 1].map(|_| gpu.texture("foam", shape, FORMAT, usage));
        let maps = textures.each_ref().map(texture::view);
        let groups = [1, 0].map(|to: usize| {
            gpu.bind("foam", &layout, &[step.as_entire_binding(), wgpu::BindingResource::TextureView(&maps[to])])
        });
        Self {
            pipelines,
            step,
            is_due: false,
            groups,
            maps,
            textures,
            current: 0,
            lace: empty_lace(gpu),
            has_lace: false,
        }
    }

    /// Makes the tile of the lace, once: it takes a tenth of a second, which pictures from space do not need.
    pub fn make_lace(&mut self, gpu: &Gpu) {
        if !std::mem::replace(&mut self.has_lace, true) {
            fill_lace(gpu, &self.lace);
        }
    }

    /// Which of [`Foam::maps`] is the present one.
    pub fn current(&self) -> usize {
        self.current
    }

    /// Sets the step that the next [`Foam::dispatch`] makes.
    pub fn prepare(&mut self, gpu: &Gpu, step: &FoamStep) {
        self.is_due = step.due != 0;
        gpu.queue.write_buffer(&self.step, 0, bytemuck::bytes_of(step));
    }

    /// One dispatch; `surface` must hold the present map. Afterwards the other map is the present one.
    pub fn dispatch(&mut self, pass: &mut wgpu::ComputePass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipelines[usize::from(!self.is_due)]);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_bind_group(2, &self.groups[self.current], &[]);
        pass.dispatch_workgroups(TEXELS as u32 / SIDE, TEXELS as u32 / SIDE, 1);
        self.current = 1 - self.current;
    }
}

/// A texture for the tile of `model/lace.rs` with its mip levels.
pub fn empty_lace(gpu: &Gpu) -> wgpu::Texture {
    let shape = Shape::array(lace::TEXELS as u32, 1, lace::MIPS as u32);
    gpu.texture("lace", shape, wgpu::TextureFormat::Rgba8Unorm, wgpu::TextureUsages::COPY_DST)
}

/// Fills it.
pub fn fill_lace(gpu: &Gpu, texture: &wgpu::Texture) {
    for (mip, texels) in lace::texels().iter().enumerate() {
        let side = (lace::TEXELS >> mip) as u32;
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture,
                mip_level: mip as u32,
                origin: wgpu::Origin3d::ZERO,
                aspect: wgpu::TextureAspect::All,
            },
            bytemuck::cast_slice(texels),
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * side), rows_per_image: None },
            wgpu::Extent3d { width: side, height: side, depth_or_array_layers: 1 },
        );
    }
}
