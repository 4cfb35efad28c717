//! The bisected mesh, kept up to the frame's eye; nothing of it exists before a frame asks for it.

use crate::error::Result;
use crate::gpu::Gpu;
use crate::pass::bisect::{Bisect, DISPATCHES, SETTLING, capacity_for, drawn_layout};
use crate::scene::frame::Frame;
use crate::scene::frame::bisection::Bisection;

/// What a mesh at rest depends on.
#[derive(Clone, Copy, PartialEq)]
struct View {
    bisection: Bisection,
    rays: [glam::Vec3; 3],
    pixel_angle: f32,
    altitude: f32,
    waves: [f32; 2],
}

impl View {
    /// None where the mesh is not drawn.
    fn of(frame: &Frame) -> Option<Self> {
        let u = &frame.uniform;
        Some(Self {
            bisection: frame.bisection.filter(|_| !frame.is_globe())?,
            rays: [u.ray_right, u.ray_up, u.ray_forward],
            pixel_angle: u.pixel_angle,
            altitude: u.eye_altitude,
            waves: [u.crest_height, u.rim_reach],
        })
    }
}

/// The mesh and how far it has come.
pub(super) struct Mesh {
    /// Layout of the sea's bind group 3.
    pub(super) layout: wgpu::BindGroupLayout,
    bisect: Option<Bisect>,
    view: Option<View>,
    /// Updates since the view last changed; [`SETTLING`] once it is known that more would change nothing.
    rested: u32,
    /// Updates that the frame makes.
    due: u32,
}

impl Mesh {
    /// No mesh yet.
    pub(super) fn new(gpu: &Gpu) -> Self {
        Self { layout: drawn_layout(gpu), bisect: None, view: None, rested: 0, due: 0 }
    }

    /// Gets ready for at most `updates` of them in the frame. `frame_layout` is that of a bind group of the frame's block alone.
    pub(super) fn prepare(&mut self, gpu: &Gpu, frame: &Frame, frame_layout: &wgpu::BindGroupLayout, updates: u32) {
        let view = View::of(frame);
        self.due = 0;
        let Some(View { bisection, .. }) = view else {
            (self.bisect, self.view) = (None, None);
            return;
        };
        let capacity = capacity_for(bisection.budget);
        if self.bisect.as_ref().is_none_or(|bisect| bisect.capacity() != capacity) {
            self.bisect = Some(Bisect::new(gpu, frame_layout, &self.layout, capacity));
            self.view = None;
        }
        let Some(bisect) = &self.bisect else { return };
        if self.view != view {
            (self.view, self.rested) = (view, 0);
            bisect.prepare(gpu, &bisection);
        }
        self.due = updates.min(SETTLING - self.rested);
        self.rested += self.due;
    }

    /// Back to the mesh's beginning.
    pub(super) fn forget(&mut self, gpu: &Gpu) {
        self.view = None;
        if let Some(bisect) = &self.bisect {
            bisect.reset(gpu);
        }
    }

    /// Records the frame's updates.
    pub(super) fn dispatch(&self, pass: &mut wgpu::ComputePass, frame_block: &wgpu::BindGroup) {
        let Some(bisect) = &self.bisect else { return };
        for _ in 0..self.due {
            bisect.dispatch(pass, frame_block);
        }
    }

    /// Looks whether the mesh is at rest already: then no more updates are due. Waits for the device.
    pub(super) fn stop_if_at_rest(&mut self, gpu: &Gpu) {
        let state = self.bisect.as_ref().and_then(|bisect| bisect.read_state(gpu).ok());
        if state.is_some_and(|state| state.is_at_rest()) {
            self.rested = SETTLING;
        }
    }

    /// Dispatches of the frame's updates.
    pub(super) fn dispatches(&self) -> usize {
        self.due as usize * DISPATCHES
    }

    /// Vertices that are drawn; `None` where the grid is. Waits for the device.
    pub(super) fn read_vertices(&self, gpu: &Gpu) -> Option<Result<u32>> {
        self.bisect.as_ref().map(|bisect| Ok(bisect.read_state(gpu)?.vertices))
    }

    /// What the sea draws instead of the grid: bind group 3 and the arguments of the draw.
    pub(super) fn drawn(&self) -> Option<(&wgpu::BindGroup, &wgpu::Buffer)> {
        self.bisect.as_ref().map(Bisect::drawn)
    }

    /// Whether the mesh still changes: that needs frames, and nothing from outside.
    pub(super) fn is_settling(&self) -> bool {
        self.bisect.is_some() && self.rested < SETTLING
    }
}
