//! Mip levels of a texture that a compute pass has filled.

use super::pipeline::Bind;
use super::{Gpu, shader, texture};

/// The dispatches that make every mip level of one square texture array from its first.
pub struct MipChain {
    pipeline: wgpu::ComputePipeline,
    groups: Vec<wgpu::BindGroup>,
    side: u32,
    layers: u32,
}

/// The composed shader for a storage format by its WGSL name.
pub fn source(format: &str) -> String {
    shader::composed(&include_str!("../../shaders/mips.wgsl").replace("FORMAT", format), "")
}

impl MipChain {
    /// The chain of `texture`, whose format is called `format` in WGSL.
    pub fn new(gpu: &Gpu, texture: &wgpu::Texture, format: &str) -> Self {
        use wgpu::TextureViewDimension::D2Array;
        let binds = [Bind::Texels(D2Array), Bind::Write(texture.format(), D2Array)];
        let layout = gpu.layout("mips", wgpu::ShaderStages::COMPUTE, &binds);
        let [pipeline] = gpu.compute("mips", &source(format), &[&layout], ["halve"]);
        let groups = (1..texture.mip_level_count())
            .map(|mip| {
                let views = [mip - 1, mip].map(|level| texture::mip_view(texture, level));
                gpu.bind("mips", &layout, &views.each_ref().map(wgpu::BindingResource::TextureView))
            })
            .collect();
        Self { pipeline, groups, side: texture.width(), layers: texture.depth_or_array_layers() }
    }

    /// One dispatch per level.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass) {
        pass.set_pipeline(&self.pipeline);
        for (mip, group) in (1..).zip(&self.groups) {
            let groups = (self.side >> mip).div_ceil(8);
            pass.set_bind_group(0, group, &[]);
            pass.dispatch_workgroups(groups, groups, self.layers);
        }
    }
}
