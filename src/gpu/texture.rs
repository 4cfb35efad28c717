//! Textures and their views.

use super::Gpu;

/// Size and kind of a texture to make.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Layers of an array, or depth of a volume.
    pub depth: u32,
    /// Mip levels.
    pub mips: u32,
    /// Of a texel.
    pub samples: u32,
    /// Two- or three-dimensional.
    pub dimension: wgpu::TextureDimension,
}

impl Shape {
    /// A plain picture.
    pub fn picture(width: u32, height: u32) -> Self {
        Self { width, height, depth: 1, mips: 1, samples: 1, dimension: wgpu::TextureDimension::D2 }
    }

    /// An array of `layers` squares with `mips` levels.
    pub fn array(side: u32, layers: u32, mips: u32) -> Self {
        Self { width: side, height: side, depth: layers, mips, samples: 1, dimension: wgpu::TextureDimension::D2 }
    }
}

impl Gpu {
    /// A texture that can be sampled, plus `usage`.
    pub fn texture(
        &self,
        label: &str,
        shape: Shape,
        format: wgpu::TextureFormat,
        usage: wgpu::TextureUsages,
    ) -> wgpu::Texture {
        self.device.create_texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d { width: shape.width, height: shape.height, depth_or_array_layers: shape.depth },
            mip_level_count: shape.mips,
            sample_count: shape.samples,
            dimension: shape.dimension,
            format,
            usage: usage | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        })
    }

    /// Fills a picture's first mip level with `bytes`, row by row.
    pub fn fill(&self, texture: &wgpu::Texture, bytes: &[u8]) {
        let rows = texture.height();
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(bytes.len() as u32 / rows),
            rows_per_image: Some(rows),
        };
        self.queue.write_texture(texture.as_image_copy(), bytes, layout, texture.size());
    }
}

/// The whole texture.
pub fn view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&Default::default())
}

/// The whole texture as an array of pictures, even when it has one layer.
pub fn array_view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..Default::default()
    })
}

/// The first mip level of a layer, as a picture.
pub fn picture_view(texture: &wgpu::Texture, layer: u32) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2),
        mip_level_count: Some(1),
        base_array_layer: layer,
        array_layer_count: Some(1),
        ..Default::default()
    })
}

/// One mip level of every layer, as an array of pictures.
pub fn mip_view(texture: &wgpu::Texture, mip: u32) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        base_mip_level: mip,
        mip_level_count: Some(1),
        ..Default::default()
    })
}

/// The first mip level of some layers, as an array of pictures.
pub fn layers_view(texture: &wgpu::Texture, layers: &std::ops::Range<usize>) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        mip_level_count: Some(1),
        base_array_layer: layers.start as u32,
        array_layer_count: Some(layers.len() as u32),
        ..Default::default()
    })
}
