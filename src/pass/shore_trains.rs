//! The trains of waves near shores on the GPU: a buffer that shaders read node by node, see `shaders/lib/shore_trains.wgsl`.

use std::sync::Arc;

use crate::gpu::Gpu;
use crate::scene::frame::Frame;
use crate::scene::sea::shores::{Header, SLOTS, Shores, Tile, WORDS};

/// A slot's window, and its nodes.
type Held = (Tile, Arc<Vec<[u32; 2]>>);

/// The buffer, and whose nodes each slot holds.
pub struct ShoreTrains {
    /// For bind group 1. Small until a picture first shows a shore.
    pub buffer: wgpu::Buffer,
    is_whole: bool,
    held: [Option<Held>; SLOTS],
}

impl ShoreTrains {
    /// A buffer without windows.
    pub fn new(gpu: &Gpu) -> Self {
        Self { buffer: buffer(gpu, size_of::<Header>()), is_whole: false, held: [const { None }; SLOTS] }
    }

    /// Windows that it holds.
    pub fn windows(&self) -> usize {
        self.held.iter().flatten().count()
    }

    /// Takes the windows around a frame's eye; true where the buffer is another one from now on.
    pub fn prepare(&mut self, gpu: &Gpu, shores: &Shores, frame: &Frame) -> bool {
        let wanted: Vec<_> = shores.ready().collect();
        let grows = !self.is_whole && !wanted.is_empty();
        if grows {
            self.buffer = buffer(gpu, WORDS * size_of::<[u32; 2]>());
            self.is_whole = true;
        }
        let is_held =
            |held: &Held, (tile, nodes): &(Tile, &Arc<Vec<[u32; 2]>>)| held.0 == *tile && Arc::ptr_eq(&held.1, nodes);
        for held in &mut self.held {
            if held.as_ref().is_some_and(|held| !wanted.iter().any(|window| is_held(held, window))) {
                *held = None;
            }
        }
        for window @ (tile, nodes) in &wanted {
            if self.held.iter().flatten().any(|held| is_held(held, window)) {
                continue;
            }
            let Some(slot) = self.held.iter().position(Option::is_none) else { break };
            let bytes: &[u8] = bytemuck::cast_slice(nodes);
            let start = size_of::<Header>() + slot * bytes.len();
            gpu.queue.write_buffer(&self.buffer, start as u64, bytes);
            self.held[slot] = Some((*tile, (*nodes).clone()));
        }
        let slots = self.held.iter().enumerate();
        let slots = slots.filter_map(|(slot, held)| held.as_ref().map(|(tile, _)| (*tile, slot)));
        gpu.queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&shores.header(frame, slots)));
        grows
    }
}

fn buffer(gpu: &Gpu, bytes: usize) -> wgpu::Buffer {
    let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
    gpu.empty_buffer("shore trains", usage, bytes as u64)
}
