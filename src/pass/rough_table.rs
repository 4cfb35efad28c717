//! What a rough sea mirrors, as a texture that shaders look up: [`rough_water::table`].

use half::f16;

use crate::gpu::Gpu;
use crate::gpu::texture::{self, Shape};
use crate::model::rough_water::{self, COSINES, DEVIATIONS};

/// The table: reflectance, and the sine of the elevation of what is mirrored.
pub fn view(gpu: &Gpu) -> wgpu::TextureView {
    let shape = Shape::picture(COSINES as u32, DEVIATIONS as u32);
    let texture = gpu.texture("rough table", shape, wgpu::TextureFormat::Rg16Float, wgpu::TextureUsages::COPY_DST);
    let texels: Vec<u16> = rough_water::table()
        .iter()
        .flat_map(|mean| [mean.reflectance, mean.sine].map(|value| f16::from_f64(value).to_bits()))
        .collect();
    gpu.fill(&texture, bytemuck::cast_slice(&texels));
    texture::view(&texture)
}
