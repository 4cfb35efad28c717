//! Textures back to the CPU: for pictures, measured layers and tests. Native only, since it waits.

use super::Gpu;
use crate::error::{Error, Result};

impl Gpu {
    /// The bytes of one layer of one mip level, rows tightly packed.
    ///
    /// # Errors
    /// [`Error::Gpu`] when the device is lost meanwhile.
    pub fn read_texture(&self, texture: &wgpu::Texture, layer: u32, mip: u32) -> Result<Vec<u8>> {
        let (width, height) = ((texture.width() >> mip).max(1), (texture.height() >> mip).max(1));
        let texel = texture.format().block_copy_size(None).unwrap_or(4);
        let (row, padded) = (width * texel, (width * texel).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT));
        let usage = wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ;
        let buffer = self.empty_buffer("readback", usage, u64::from(padded) * u64::from(height));
        let mut encoder = self.device.create_command_encoder(&Default::default());
        encoder.copy_texture_to_buffer(
            wgpu::TexelCopyTextureInfo {
                texture,
                mip_level: mip,
                origin: wgpu::Origin3d { x: 0, y: 0, z: layer },
                aspect: wgpu::TextureAspect::All,
            },
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(padded),
                    rows_per_image: Some(height),
                },
            },
            wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        );
        self.queue.submit([encoder.finish()]);
        let bytes = self.read_buffer(&buffer)?;
        Ok(bytes.chunks(padded as usize).flat_map(|line| &line[..row as usize]).copied().collect())
    }

    /// The bytes of a buffer that can be copied from.
    ///
    /// # Errors
    /// [`Error::Gpu`] when the device is lost meanwhile.
    pub fn copy_buffer(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>> {
        let usage = wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ;
        let copy = self.empty_buffer("readback", usage, buffer.size());
        let mut encoder = self.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, buffer.size());
        self.queue.submit([encoder.finish()]);
        self.read_buffer(&copy)
    }

    /// The bytes of a buffer that can be mapped for reading.
    ///
    /// # Errors
    /// [`Error::Gpu`] when the device is lost meanwhile.
    pub fn read_buffer(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>> {
        let lost = |e: String| Error::gpu(format!("reading back from the GPU failed: {e}"), "try again");
        let slice = buffer.slice(..);
        let (sender, receiver) = std::sync::mpsc::channel();
        slice.map_async(wgpu::MapMode::Read, move |outcome| {
            let _ = sender.send(outcome);
        });
        self.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|e| lost(e.to_string()))?;
        receiver.recv().map_err(|e| lost(e.to_string()))?.map_err(|e| lost(e.to_string()))?;
        let bytes = slice.get_mapped_range().map_err(|e| lost(e.to_string()))?.to_vec();
        buffer.unmap();
        Ok(bytes)
    }
}
