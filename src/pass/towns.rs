//! The windows of towns about the eye, for the shaders that build them up (`shaders/lib/built_up.wgsl`, `houses.wgsl`).

use crate::data::tile::{Projection, TileId};
use crate::gpu::Gpu;
use crate::scene::frame::Frame;
use crate::scene::towns::{SHIFTS, SIDE, TownMap, Window, corner_about, units};

/// Nearest pixels wider than this show no town, m; as `TOWNS_SEEN` in `shaders/lib/built_up.wgsl`.
const WIDEST_PIXEL_M: f64 = 500.0;

/// The windows on the GPU.
pub struct Towns {
    map: TownMap,
    windows: [Option<Window>; 2],
    /// Whether the last frame's eye is so near that towns show.
    near: bool,
    /// What the shader reads.
    pub buffer: wgpu::Buffer,
}

impl Towns {
    /// No window yet.
    pub fn new(gpu: &Gpu) -> Self {
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
        let buffer = gpu.empty_buffer("towns", usage, (SHIFTS.len() * (8 + SIDE * SIDE)) as u64);
        Self { map: TownMap::bundled(), windows: [None, None], near: false, buffer }
    }

    /// Brings the windows to the eye of a frame.
    pub fn prepare(&mut self, gpu: &Gpu, frame: &Frame) {
        let camera = &frame.camera;
        self.near = f64::from(frame.uniform.pixel_angle) * camera.altitude_m < WIDEST_PIXEL_M;
        if !self.near || Projection::for_latitude(camera.lat) != Projection::Mercator {
            return;
        }
        let eye = units(camera.lat, camera.lon);
        for (index, shift) in SHIFTS.into_iter().enumerate() {
            let corner = corner_about(eye, shift);
            if self.windows[index].as_ref().is_some_and(|window| window.corner == corner) {
                continue;
            }
            let window = self.map.window(index, eye);
            gpu.queue.write_buffer(&self.buffer, 8 * index as u64, bytemuck::cast_slice(&window.corner));
            let texels = (8 * SHIFTS.len() + index * SIDE * SIDE) as u64;
            gpu.queue.write_buffer(&self.buffer, texels, &window.texels);
            self.windows[index] = Some(window);
        }
    }

    /// Whether towns may show on a tile.
    pub fn are_on(&self, tile: TileId) -> bool {
        if !self.near || tile.projection != Projection::Mercator {
            return false;
        }
        let side = 1u64 << (32 - u32::from(tile.z));
        let corner = [tile.x, tile.y].map(|at| (u64::from(at) * side) as u32);
        let in_window = |(window, shift): (&Option<Window>, &u32)| {
            window.as_ref().is_some_and(|window| side >= 1 << 31 || window.has_town(corner, side, *shift))
        };
        self.windows.iter().zip(&SHIFTS).any(in_window)
    }
}
