//! What clouds do to the light in a picture, at the nodes of a net over it: made anew for each frame.

use crate::gpu::pipeline::{Bind, Compute};
use crate::gpu::{Gpu, shader};
use crate::scene::frame::clouds::{MIRROR_NODES, MOST_NODES};

/// Bytes of a node: 16 bits for each of four numbers.
const NODE: u64 = 8;
/// Threads of a workgroup.
const THREADS: u32 = 64;

/// The composed shader.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/cloud_light.wgsl"), "")
}

/// What drawing passes read of it, and what a pass without clouds may have in its place: a node's bytes at least.
pub fn net(gpu: &Gpu) -> wgpu::Buffer {
    use wgpu::BufferUsages as B;
    gpu.empty_buffer("cloud net", B::STORAGE | B::COPY_DST, NODE * u64::from(2 * MOST_NODES))
}

/// The pass.
pub struct CloudLight {
    pipelines: [Compute; 2],
    /// Written by the shader, which has what is read in its bind group 1, and then copied there.
    made: wgpu::Buffer,
    group: wgpu::BindGroup,
    net: wgpu::Buffer,
    /// For shadows, the eye's among them, and for what is mirrored.
    nodes: [u32; 2],
}

impl CloudLight {
    /// The pass into [`net`]; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout, surface: &wgpu::BindGroupLayout, net: wgpu::Buffer) -> Self {
        use wgpu::BufferUsages as B;
        let layout = gpu.layout("cloud light", wgpu::ShaderStages::COMPUTE, &[Bind::StorageWrite]);
        let made = gpu.empty_buffer("cloud light", B::STORAGE | B::COPY_SRC, net.size());
        let group = gpu.bind("cloud light", &layout, &[made.as_entire_binding()]);
        let pipelines = gpu.compute("cloud light", &source(), &[frame, surface, &layout], ["shadows", "mirrors"]);
        Self { pipelines, made, group, net, nodes: [0; 2] }
    }

    /// Takes how many nodes across and down the next net has; `None`: it is not needed.
    /// What is mirrored is for fine pictures of a part of the globe alone.
    pub fn prepare(&mut self, size: Option<([u32; 2], bool)>) {
        let nodes = |([across, down], mirrors): ([u32; 2], bool)| {
            let mirrored = [across, down].map(|side| (side - 2) / MIRROR_NODES + 2);
            [across * down + 1, if mirrors { mirrored[0] * mirrored[1] } else { 0 }]
        };
        self.nodes = size.map_or([0; 2], nodes);
    }

    /// Dispatches of the frame.
    pub fn dispatches(&self) -> usize {
        self.nodes.iter().filter(|nodes| **nodes > 0).count()
    }

    /// Makes the net.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        if self.nodes[0] == 0 {
            return;
        }
        for (index, group) in (0..).zip([frame, surface, &self.group]) {
            pass.set_bind_group(index, group, &[]);
        }
        for (pipeline, nodes) in self.pipelines.iter().zip(self.nodes).filter(|(_, nodes)| *nodes > 0) {
            pass.set_pipeline(pipeline);
            pass.dispatch_workgroups(nodes.div_ceil(THREADS), 1, 1);
        }
    }

    /// Hands it to the drawing passes.
    pub fn hand_over(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.copy_buffer_to_buffer(&self.made, 0, &self.net, 0, NODE * u64::from(self.nodes[0] + self.nodes[1]));
    }
}
