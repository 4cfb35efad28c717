//! The map's tiles on the GPU: an atlas for each layer, and the page tables by which shaders find the finest tile at hand.

use crate::data::TileTexels;
use crate::data::streaming::{ATLAS_SLOTS, PAGE_ENTRIES, PAGE_LEVELS, PageTable, Upload};
use crate::data::tile::{Layer, Projection, TILE_TEXELS};
use crate::gpu::Gpu;
use crate::gpu::pipeline::Bind;
use crate::gpu::texture::{Shape, array_view};

/// What is shown of land before its first imagery tile, sRGB.
const NEUTRAL: [u8; 4] = [108, 102, 84, 255];
/// Bytes of a level's page table.
const TABLE_BYTES: u64 = (PAGE_ENTRIES * size_of::<[u32; 2]>()) as u64;

/// The textures and the buffer.
pub struct WorldTiles {
    atlases: [wgpu::Texture; Layer::COUNT],
    pages: wgpu::Buffer,
    /// Of bind group 2 of what shows the land: its imagery, and where towns are.
    pub imagery_layout: wgpu::BindGroupLayout,
    /// The group of [`WorldTiles::imagery_layout`].
    pub imagery: wgpu::BindGroup,
}

impl WorldTiles {
    /// Empty atlases: open sea everywhere. `towns`: [`Towns::buffer`].
    ///
    /// [`Towns::buffer`]: super::towns::Towns::buffer
    pub fn new(gpu: &Gpu, towns: &wgpu::Buffer) -> Self {
        let atlases = Layer::ALL.map(|layer| {
            let (label, format) = match layer {
                Layer::Terrain => ("terrain tiles", wgpu::TextureFormat::R32Float),
                Layer::Water => ("water tiles", wgpu::TextureFormat::Rgba8Unorm),
                Layer::Imagery => ("imagery tiles", wgpu::TextureFormat::Rgba8UnormSrgb),
            };
            let shape = Shape::array(TILE_TEXELS as u32, ATLAS_SLOTS, 1);
            gpu.texture(label, shape, format, wgpu::TextureUsages::COPY_DST)
        });
        let tables = (Projection::ALL.len() * PAGE_LEVELS) as u64;
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
        let binds = [Bind::Texels(wgpu::TextureViewDimension::D2Array), Bind::Storage];
        let imagery_layout = gpu.layout("imagery", wgpu::ShaderStages::VERTEX_FRAGMENT, &binds);
        let view = array_view(&atlases[Layer::Imagery as usize]);
        let bindings = [wgpu::BindingResource::TextureView(&view), towns.as_entire_binding()];
        let imagery = gpu.bind("imagery", &imagery_layout, &bindings);
        let pages = gpu.empty_buffer("pages", usage, tables * TABLE_BYTES);
        let tiles = Self { atlases, pages, imagery_layout, imagery };
        // Slot 0 is the void that is shown before the first tile: bare sea of no known depth.
        tiles.upload(gpu, Layer::Terrain, 0, &TileTexels::Terrain(vec![-4_000.0; TILE_TEXELS * TILE_TEXELS]));
        tiles.upload(gpu, Layer::Water, 0, &TileTexels::Water(vec![[255, 1, 1, 0]; TILE_TEXELS * TILE_TEXELS]));
        tiles.upload(gpu, Layer::Imagery, 0, &TileTexels::Imagery(vec![NEUTRAL; TILE_TEXELS * TILE_TEXELS]));
        tiles
    }

    /// Takes tiles that have come.
    pub fn take_tiles(&self, gpu: &Gpu, uploads: &[Upload]) {
        uploads.iter().for_each(|upload| self.upload(gpu, upload.layer, upload.slot, &upload.texels));
    }

    /// Takes the page tables that have changed.
    pub fn take_pages(&self, gpu: &Gpu, pages: &mut PageTable) {
        for (table, entries) in pages.take_changed() {
            gpu.queue.write_buffer(&self.pages, table as u64 * TABLE_BYTES, bytemuck::cast_slice(entries));
        }
    }

    /// What tells the ground's shape: the atlases of terrain and water as arrays, then the page tables.
    pub fn bindings(&self) -> ([wgpu::TextureView; 2], &wgpu::Buffer) {
        (Layer::SHAPE.map(|layer| array_view(&self.atlases[layer as usize])), &self.pages)
    }

    fn upload(&self, gpu: &Gpu, layer: Layer, slot: u32, texels: &TileTexels) {
        let bytes: &[u8] = match texels {
            TileTexels::Terrain(metres) => bytemuck::cast_slice(metres),
            TileTexels::Water(texels) | TileTexels::Imagery(texels) => bytemuck::cast_slice(texels),
        };
        let side = TILE_TEXELS as u32;
        gpu.queue.write_texture(
            wgpu::TexelCopyTextureInfo {
                texture: &self.atlases[layer as usize],
                mip_level: 0,
                origin: wgpu::Origin3d { x: 0, y: 0, z: slot },
                aspect: wgpu::TextureAspect::All,
            },
            bytes,
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * side), rows_per_image: Some(side) },
            wgpu::Extent3d { width: side, height: side, depth_or_array_layers: 1 },
        );
    }
}
