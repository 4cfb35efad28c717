//! What a frame asks of the device.

use super::Renderer;
use crate::error::Result;

/// The work of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Vertices of the sea's mesh: the grid's own, or three for each of the bisected triangles in view. From space there is no mesh.
    pub vertices: u32,
    /// Triangles of the sea's mesh.
    pub triangles: u32,
    /// Map tiles of the ground that are drawn, a grid of triangles for each.
    pub map_tiles: u32,
    /// Triangles of the ground's grids.
    pub land_triangles: u32,
    /// Compute dispatches, those of the foam's replay included.
    pub dispatches: usize,
    /// Windows of the trains of waves by shores on the device.
    pub shore_windows: usize,
    /// Bytes of the buffer that these take on the device, and of windows that are kept or being made for it.
    pub shore_bytes: [u64; 2],
}

impl Renderer {
    /// What the last [`Renderer::render`] took. Waits for the device where the mesh is bisected: only the device knows its triangles.
    ///
    /// # Errors
    /// [`crate::error::Error::Gpu`] when the device is lost.
    pub fn cost(&self) -> Result<Cost> {
        let (shore_windows, on_device) = self.surface.trains_held();
        let shore_bytes = [on_device, self.shores.bytes() as u64];
        let shores = Cost { dispatches: self.dispatches, shore_windows, shore_bytes, ..Cost::default() };
        if self.visible.is_none() {
            return Ok(shores);
        }
        let [vertices, triangles] = match self.mesh.read_vertices(&self.gpu) {
            Some(vertices) => {
                let vertices = vertices?;
                [vertices, vertices / 3]
            }
            None => self.ocean.grid_counts(),
        };
        let [map_tiles, land_triangles] = self.land.counts();
        Ok(Cost { vertices, triangles, map_tiles, land_triangles, ..shores })
    }
}
