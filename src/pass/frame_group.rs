//! Bind group 0: the frame's block, the wave cells, two samplers, the world's tiles. Every drawing pass has it.

use crate::gpu::Gpu;
use crate::gpu::pipeline::Bind;
use crate::model::wave_domain::MAX_CELLS;
use crate::scene::frame::uniform::{MIRRORS_LAND, WaveCell};
use crate::scene::frame::{FrameUniform, LENS_M};

/// The group, its layout, and the buffers behind it.
pub struct FrameGroup {
    /// For the pipelines.
    pub layout: wgpu::BindGroupLayout,
    /// For the draws.
    pub group: wgpu::BindGroup,
    /// For passes that need the storage buffers for themselves: the frame's block alone.
    pub block_layout: wgpu::BindGroupLayout,
    /// The group of [`FrameGroup::block_layout`].
    pub block_group: wgpu::BindGroup,
    uniform: wgpu::Buffer,
    wave_cells: wgpu::Buffer,
}

impl FrameGroup {
    /// The group over the terrain and water atlases and their page tables.
    pub fn new(gpu: &Gpu, atlases: &[wgpu::TextureView; 2], pages: &wgpu::Buffer) -> Self {
        use wgpu::{BufferUsages as B, TextureViewDimension::D2Array};
        let binds = [
            Bind::Uniform,
            Bind::Uniform,
            Bind::Sampler,
            Bind::Sampler,
            Bind::Texels(D2Array),
            Bind::Texels(D2Array),
            Bind::Storage,
        ];
        // Not all(): it holds stages that browsers do not know, and they refuse the whole layout.
        let stages = wgpu::ShaderStages::VERTEX_FRAGMENT | wgpu::ShaderStages::COMPUTE;
        let layout = gpu.layout("frame", stages, &binds);
        let uniform = gpu.empty_buffer("frame", B::UNIFORM | B::COPY_DST, size_of::<FrameUniform>() as u64);
        let block_layout = gpu.layout("frame block", stages, &[Bind::Uniform]);
        let block_group = gpu.bind("frame block", &block_layout, &[uniform.as_entire_binding()]);
        let wave_cells =
            gpu.empty_buffer("wave_cells", B::UNIFORM | B::COPY_DST, (size_of::<WaveCell>() * MAX_CELLS) as u64);
        // Tables have one level, patches of waves all theirs.
        let clamped = gpu.sampler("clamped", wgpu::AddressMode::ClampToEdge, wgpu::MipmapFilterMode::Nearest);
        let repeated = gpu.sampler("repeated", wgpu::AddressMode::Repeat, wgpu::MipmapFilterMode::Linear);
        let group = gpu.bind(
            "frame",
            &layout,
            &[
                uniform.as_entire_binding(),
                wave_cells.as_entire_binding(),
                wgpu::BindingResource::Sampler(&clamped),
                wgpu::BindingResource::Sampler(&repeated),
                wgpu::BindingResource::TextureView(&atlases[0]),
                wgpu::BindingResource::TextureView(&atlases[1]),
                pages.as_entire_binding(),
            ],
        );
        Self { layout, group, block_layout, block_group, uniform, wave_cells }
    }

    /// Hands a frame's block and wave cells to the GPU, with what only the world knows: how wide the cells of the terrain's source are, the deepest
    /// levels of the maps' page tables ([`PageTable::deepest`]), how deep the sea is at the eye's place, metres, whether the water may cut through
    /// the picture, and whether land is so near that it mirrors it.
    ///
    /// [`PageTable::deepest`]: crate::data::streaming::PageTable::deepest
    pub fn upload(
        &self,
        gpu: &Gpu,
        (block, wave_cells): (&FrameUniform, &[WaveCell; MAX_CELLS]),
        (terrain_resolution_m, deepest_pages): (f64, u32),
        (depth_m, is_cut, mirrors_land): (f64, bool, bool),
    ) {
        let uniform = FrameUniform {
            terrain_resolution: terrain_resolution_m as f32,
            deepest_pages,
            layers: block.layers | if mirrors_land { MIRRORS_LAND } else { 0 },
            eye_depth: depth_m as f32,
            lens: if is_cut { LENS_M as f32 } else { 0.0 },
            ..*block
        };
        gpu.queue.write_buffer(&self.uniform, 0, bytemuck::bytes_of(&uniform));
        gpu.queue.write_buffer(&self.wave_cells, 0, bytemuck::cast_slice(wave_cells));
    }
}
