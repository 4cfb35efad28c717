//! Mip levels of a texture that a compute pass has filled: up to four levels in a dispatch.

use super::pipeline::{Bind, Compute};
use super::texture::{self, Shape};
use super::{Gpu, shader};

/// Levels of one dispatch: the storage textures that WebGPU allows a shader.
const LEVELS: u32 = 4;
/// Texels of the finest level along a side of a workgroup.
const REACH: u32 = 16;

/// The dispatches that make every mip level of some square texture arrays of one size from their first.
pub struct MipChain {
    pipeline: Compute,
    /// Those of all textures come before the next levels, so that the device waits for finished levels once per four levels and
    /// not once per texture.
    steps: Vec<Step>,
    layers: u32,
}

/// One dispatch.
struct Step {
    /// Which texture of the chain it is for.
    texture: usize,
    group: wgpu::BindGroup,
    /// Workgroups along a side.
    groups: u32,
}

/// The composed shader for a storage format by its WGSL name.
pub fn source(format: &str) -> String {
    shader::composed(&include_str!("../../shaders/mips.wgsl").replace("FORMAT", format), "")
}

impl MipChain {
    /// The chain of `texture`, whose format is called `format` in WGSL.
    pub fn new(gpu: &Gpu, texture: &wgpu::Texture, format: &str) -> Self {
        Self::of(gpu, &[texture], format)
    }

    /// The chains of textures that are alike in size, layers, levels and format (called `format` in WGSL).
    pub fn of(gpu: &Gpu, textures: &[&wgpu::Texture], format: &str) -> Self {
        use wgpu::TextureViewDimension::D2Array;
        let like = textures[0];
        let write = Bind::Write(like.format(), D2Array);
        let layout =
            gpu.layout("mips", wgpu::ShaderStages::COMPUTE, &[Bind::Texels(D2Array), write, write, write, write]);
        let [pipeline] = gpu.compute("mips", &source(format), &[&layout], ["halve"]);
        // Stand in for levels beyond the last: each binding has its own, since none may be bound twice for writing.
        let unwanted = (1..LEVELS).map(|_| {
            let usage = wgpu::TextureUsages::STORAGE_BINDING;
            texture::array_view(&gpu.texture("unwanted", Shape::array(1, 1, 1), like.format(), usage))
        });
        let unwanted: Vec<_> = unwanted.collect();
        let last = like.mip_level_count() - 1;
        let mut steps = Vec::new();
        for from in (0..last).step_by(LEVELS as usize) {
            for (index, texture) in textures.iter().enumerate() {
                let views = (from..=from + LEVELS).map(|level| match level.checked_sub(last + 1) {
                    None => texture::mip_view(texture, level),
                    Some(beyond) => unwanted[beyond as usize].clone(),
                });
                let views: Vec<_> = views.collect();
                let resources: Vec<_> = views.iter().map(wgpu::BindingResource::TextureView).collect();
                let groups = (texture.width() >> from).div_ceil(REACH);
                steps.push(Step { texture: index, group: gpu.bind("mips", &layout, &resources), groups });
            }
        }
        Self { pipeline, steps, layers: like.depth_or_array_layers() }
    }

    /// One dispatch per four levels of each texture.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass) {
        self.dispatch_from(pass, 0);
    }

    /// As [`MipChain::dispatch`], without the first `left_out` textures.
    pub fn dispatch_from(&self, pass: &mut wgpu::ComputePass, left_out: usize) {
        pass.set_pipeline(&self.pipeline);
        for step in self.steps.iter().filter(|step| step.texture >= left_out) {
            pass.set_bind_group(0, &step.group, &[]);
            pass.dispatch_workgroups(step.groups, step.groups, self.layers);
        }
    }

    /// Dispatches of one [`MipChain::dispatch`].
    pub fn dispatches(&self) -> usize {
        self.steps.len()
    }
}
