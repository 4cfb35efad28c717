//! The mesh bisected on the GPU: a pool of triangles that remembers, refined and coarsened in six dispatches an update.
//!
//! # Why this way
//! A triangle is halved at the middle of its base (longest-edge bisection); the triangle across the base must be halved there too, so no
//! corner ever lies inside an edge. Wishes are per edge: to halve a leg, the base is halved first, which leaves seven patterns.
//! ```text
//!      A          A          A          A              classify  marks edges that are too long, and what must follow from them
//!     / \        /|\        /|\        /|\             plan      gives free slots to the pieces; finds diamonds to merge
//!    /   \  ->  / | \      / | /\     /\|/\            apply     writes the pieces, links the neighbours, frees the old
//!   L-----R    L--M--R    L--M--R    L--M--R           count, account   sums of the slots' bits, a binary tree; the budget
//!              base       + right    + both            list      what is in view
//! ```
//! The slots are the leaves of a concurrent binary tree ([`Cbt`](crate::bibliography::Cbt)): a bit each and sums above them, by which
//! a thread finds the n-th free one. Pieces go to free slots, never to the old one's, so that every thread of `apply` reads the mesh as it
//! was: splits and merges need no order. A neighbour that stays is told by whoever changed. Rejected: updating in
//! place (reads race with writes: the published scheme needs 19 dispatches and a second copy of the links) and a mesh from
//! scratch every frame (its cost grows with its depth).
//!
//! A slot takes 36 bytes of corners, 16 of links and depth, 4 of command, 16 of pieces, 4 in the list and 3 bits of tree: 77.

use bytemuck::{Pod, Zeroable};

use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::{Gpu, shader};
use crate::model::cuboid;
use crate::scene::frame::bisection::Bisection;

/// Slots of one workgroup that counts; a pool has a power of two of them.
const COUNTED: u32 = 8192;
/// Slots along a workgroup that goes over them.
const SIDE: u32 = 64;
/// Updates after which a mesh at rest changes no more: one for each depth of a triangle.
pub const SETTLING: u32 = 64;

/// Dispatches of an update.
pub const DISPATCHES: usize = ENTRIES.len();

const ENTRIES: [&str; 6] = ["classify", "plan", "apply", "count", "account", "list"];

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/bisect.wgsl"), "")
}

/// The accounts of the pool; mirrors `State` in `shaders/lib/bisectors.wgsl`, which documents the members.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[expect(missing_docs, reason = "documented where the shader declares them")]
pub struct State {
    pub vertices: u32,
    pub instances: u32,
    pub first_vertex: u32,
    pub first_instance: u32,
    pub live: u32,
    pub wanted_slots: u32,
    pub growth: u32,
    pub taken: u32,
    pub merging: u32,
    pub coarseness: f32,
    pub acceptance: f32,
    pub updates: u32,
    pub last_growth: u32,
    pub last_merged: u32,
    pub resting: u32,
    pub unused: u32,
}

impl State {
    /// Whether further updates would change nothing.
    pub fn is_at_rest(&self) -> bool {
        self.resting != 0
    }
}

/// A triangle read back from the pool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bisector {
    /// Where it is.
    pub slot: u32,
    /// Apex, left and right end of the base.
    pub corners: cuboid::Triangle,
    /// Slots across the base, the left and the right leg.
    pub links: [u32; 3],
    /// Bisections since its root.
    pub depth: u32,
}

/// The pass and its pool.
pub struct Bisect {
    pipelines: [Compute; 6],
    group: wgpu::BindGroup,
    /// For drawing: block, corners, list, accounts.
    drawn_group: wgpu::BindGroup,
    block: wgpu::Buffer,
    corners: wgpu::Buffer,
    links: wgpu::Buffer,
    tree: wgpu::Buffer,
    state: wgpu::Buffer,
    capacity: u32,
}

/// Slots of a pool for so many triangles: an update needs room for the old and the new.
pub fn capacity_for(budget: u32) -> u32 {
    (budget + budget / 2).next_power_of_two().max(COUNTED)
}

/// Layout of the group that the sea's vertices read.
pub fn drawn_layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let binds = [Bind::Uniform, Bind::Storage, Bind::Storage, Bind::Storage];
    gpu.layout("drawn triangles", wgpu::ShaderStages::VERTEX, &binds)
}

impl Bisect {
    /// A pool of `capacity` slots with the 24 roots; `frame` is the layout of a bind group 0 with the frame's block alone,
    /// `drawn` that of [`drawn_layout`].
    pub fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout, drawn: &wgpu::BindGroupLayout, capacity: u32) -> Self {
        Self::of_shader(gpu, frame, drawn, capacity, &source())
    }

    /// The same with another shader of the same entries: tests put their own wishes there.
    pub fn of_shader(
        gpu: &Gpu,
        frame: &wgpu::BindGroupLayout,
        drawn: &wgpu::BindGroupLayout,
        capacity: u32,
        source: &str,
    ) -> Self {
        use wgpu::BufferUsages as B;
        let mut binds = vec![Bind::Uniform];
        binds.extend([Bind::StorageWrite; 7]);
        let layout = gpu.layout("bisection", wgpu::ShaderStages::COMPUTE, &binds);
        let pipelines = gpu.compute("bisect", source, &[frame, &layout], ENTRIES);
        let pool =
            |label, words: u32| gpu.empty_buffer(label, B::STORAGE | B::COPY_SRC | B::COPY_DST, 4 * u64::from(words));
        let words = capacity / 32;
        let [corners, links, commands, pieces] =
            [("corners", 9), ("links", 4), ("commands", 1), ("pieces", 4)].map(|(label, n)| pool(label, n * capacity));
        let (tree, list) = (pool("tree", 2 * words), pool("drawn", capacity));
        let usage = B::STORAGE | B::INDIRECT | B::COPY_SRC | B::COPY_DST;
        let state = gpu.empty_buffer("mesh state", usage, size_of::<State>() as u64);
        let block = gpu.empty_buffer("bisection", B::UNIFORM | B::COPY_DST, size_of::<Bisection>() as u64);
        let buffers = [&block, &corners, &links, &commands, &pieces, &tree, &state, &list];
        let group = gpu.bind("bisection", &layout, &buffers.map(wgpu::Buffer::as_entire_binding));
        let buffers = [&block, &corners, &list, &state];
        let drawn_group = gpu.bind("drawn triangles", drawn, &buffers.map(wgpu::Buffer::as_entire_binding));
        let pass = Self { pipelines, group, drawn_group, block, corners, links, tree, state, capacity };
        pass.reset(gpu);
        pass
    }

    /// Slots of the pool.
    pub fn capacity(&self) -> u32 {
        self.capacity
    }

    /// Back to the roots.
    pub fn reset(&self, gpu: &Gpu) {
        let (triangles, across) = cuboid::roots();
        let links: Vec<[u32; 4]> = across.iter().map(|&[base, left, right]| [base, left, right, 0]).collect();
        let mut tree = vec![0u32; 2 * self.capacity as usize / 32];
        tree[0] = (1 << triangles.len()) - 1;
        let words = self.capacity as usize / 32;
        // Node i of the sums stands at words + i: all roots lie under the leftmost node of each level.
        let mut node = 1;
        while node < words {
            tree[words + node] = triangles.len() as u32;
            node *= 2;
        }
        let live = triangles.len() as u32;
        let state = State { instances: 1, live, coarseness: 1.0, acceptance: 1.0, ..State::default() };
        gpu.queue.write_buffer(&self.corners, 0, bytemuck::cast_slice(&triangles));
        gpu.queue.write_buffer(&self.links, 0, bytemuck::cast_slice(&links));
        gpu.queue.write_buffer(&self.tree, 0, bytemuck::cast_slice(&tree));
        gpu.queue.write_buffer(&self.state, 0, bytemuck::bytes_of(&state));
    }

    /// Sets the wish of the next updates and draws, and wakes a mesh at rest: needed whenever the eye, the water or the wish is another.
    pub fn prepare(&self, gpu: &Gpu, bisection: &Bisection) {
        gpu.queue.write_buffer(&self.block, 0, bytemuck::bytes_of(bisection));
        gpu.queue.write_buffer(&self.state, std::mem::offset_of!(State, resting) as u64, &[0; 4]);
    }

    /// One update: six dispatches.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass, frame: &wgpu::BindGroup) {
        let over_slots = self.capacity / SIDE;
        let groups = [over_slots, over_slots, over_slots, self.capacity / COUNTED, 1, over_slots];
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, &self.group, &[]);
        for (pipeline, groups) in self.pipelines.iter().zip(groups) {
            pass.set_pipeline(pipeline);
            pass.dispatch_workgroups(groups, 1, 1);
        }
    }

    /// What the sea's vertices read, and the arguments of their draw.
    pub fn drawn(&self) -> (&wgpu::BindGroup, &wgpu::Buffer) {
        (&self.drawn_group, &self.state)
    }

    /// The accounts after the last update.
    ///
    /// # Errors
    /// [`crate::error::Error::Gpu`] when the device is lost.
    pub fn read_state(&self, gpu: &Gpu) -> crate::error::Result<State> {
        Ok(bytemuck::pod_read_unaligned(&gpu.copy_buffer(&self.state)?))
    }

    /// Every live triangle.
    ///
    /// # Errors
    /// As [`Bisect::read_state`].
    pub fn read_mesh(&self, gpu: &Gpu) -> crate::error::Result<Vec<Bisector>> {
        let [tree, corners, links] = [&self.tree, &self.corners, &self.links].map(|buffer| gpu.copy_buffer(buffer));
        let tree: Vec<u32> = bytemuck::pod_collect_to_vec(&tree?);
        let corners: Vec<cuboid::Triangle> = bytemuck::pod_collect_to_vec(&corners?);
        let links: Vec<[u32; 4]> = bytemuck::pod_collect_to_vec(&links?);
        let is_live = |slot: &u32| tree[*slot as usize / 32] >> (slot % 32) & 1 == 1;
        let bisector = |slot: u32| {
            let [base, left, right, depth] = links[slot as usize];
            Bisector { slot, corners: corners[slot as usize], links: [base, left, right], depth }
        };
        Ok((0..self.capacity).filter(is_live).map(bisector).collect())
    }
}
