//! The trains of waves near shores on the GPU: a buffer that shaders read node by node, see `shaders/lib/shore_trains.wgsl`.

use std::sync::Arc;

use crate::data::fetch::now_s;
use crate::gpu::Gpu;
use crate::scene::frame::Frame;
use crate::scene::sea::shores::{Header, SLOTS, Shores, Tile, WORDS};

/// In how many seconds a window of a moving picture comes.
pub const COMES_S: f64 = 1.5;

/// A slot's window.
struct Held {
    tile: Tile,
    nodes: Arc<Vec<[u32; 2]>>,
    /// Instant since when it shows, s; it is whole from [`COMES_S`] later on.
    since_s: f64,
}

/// The buffer, and whose nodes each slot holds.
pub struct ShoreTrains {
    /// For bind group 1. Small until a picture first shows a shore.
    pub buffer: wgpu::Buffer,
    is_whole: bool,
    held: [Option<Held>; SLOTS],
    /// Those that are held no more: tile, since when it showed, and when it went, s.
    left: Vec<(Tile, f64, f64)>,
}

/// So long after it went a window that comes back, with another sea's waves, shows at once, s.
const COMES_BACK_S: f64 = 3.0;

impl ShoreTrains {
    /// A buffer without windows.
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            buffer: buffer(gpu, size_of::<Header>()),
            is_whole: false,
            held: [const { None }; SLOTS],
            left: Vec::new(),
        }
    }

    /// Windows that it holds.
    pub fn windows(&self) -> usize {
        self.held.iter().flatten().count()
    }

    /// Takes the windows around a frame's eye; true where the buffer is another one from now on. In a picture that is `moving` new ones come by and
    /// by, others are whole at once.
    pub fn prepare(&mut self, gpu: &Gpu, shores: &Shores, frame: &Frame, moving: bool) -> bool {
        let wanted: Vec<_> = shores.ready().collect();
        let grows = !self.is_whole && !wanted.is_empty();
        if grows {
            self.buffer = buffer(gpu, WORDS * size_of::<[u32; 2]>());
            self.is_whole = true;
        }
        let is_held = |held: &Held, (tile, nodes): &(Tile, &Arc<Vec<[u32; 2]>>)| {
            held.tile == *tile && Arc::ptr_eq(&held.nodes, nodes)
        };
        let now_s = now_s();
        for slot in &mut self.held {
            if let Some(held) = slot.take_if(|held| !wanted.iter().any(|window| is_held(held, window))) {
                self.left.push((held.tile, held.since_s, now_s));
            }
        }
        self.left.retain(|(_, _, went_s)| (0.0..COMES_BACK_S).contains(&(now_s - went_s)));
        for window @ (tile, nodes) in &wanted {
            if self.held.iter().flatten().any(|held| is_held(held, window)) {
                continue;
            }
            let Some(slot) = self.held.iter().position(Option::is_none) else { break };
            let bytes: &[u8] = bytemuck::cast_slice(nodes);
            let start = size_of::<Header>() + slot * bytes.len();
            gpu.queue.write_buffer(&self.buffer, start as u64, bytes);
            // Another sea's waves at the same place are there as soon as they are made.
            let since_s = self.left.iter().find(|(left, ..)| left == tile).map_or(now_s, |(_, since_s, _)| *since_s);
            self.held[slot] = Some(Held { tile: *tile, nodes: (*nodes).clone(), since_s });
        }
        for held in self.held.iter_mut().flatten() {
            // A picture at rest has no next one to wait for; a page's clock may be put back.
            held.since_s = if moving { held.since_s.min(now_s) } else { now_s - COMES_S };
        }
        let slots = self.held.iter().enumerate();
        let share = |held: &Held| ((now_s - held.since_s) / COMES_S).clamp(0.0, 1.0);
        let slots = slots.filter_map(|(slot, held)| held.as_ref().map(|held| (held.tile, slot, share(held))));
        gpu.queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&shores.header(frame, slots)));
        grows
    }
}

fn buffer(gpu: &Gpu, bytes: usize) -> wgpu::Buffer {
    let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
    gpu.empty_buffer("shore trains", usage, bytes as u64)
}
