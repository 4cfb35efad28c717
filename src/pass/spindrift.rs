//! Spindrift: plumes of drops that a storm tears off breaking crests and blows before them.
//!
//! Cells of two squares about the eye, fixed to the water at rest as the foam map's texels are, have a plume each: those of the narrower one 3 m
//! wide, to some 90 m from the eye, those of the wider one 13.5 m, to 400 m. The map's young foam says how much of a crest breaks there now, and
//! with it the plume comes and goes: no drop has a history of its own, so that the same link shows the same spray to everyone. A dispatch finds
//! the plumes, and a draw lays them over the sea in the order of their cells, which is not that of their distances: all are white.

use std::collections::HashMap;

use bytemuck::{Pod, Zeroable};

use super::kind::Kind;
use super::look::Look;
use crate::gpu::pipeline::{Bind, Compute, Depth, DepthTest, Drawing};
use crate::gpu::{Gpu, shader};

/// Cells along a side of a square; a power of two.
const SIDE: u32 = 64;
/// Plumes of both squares.
const PLUMES: u32 = 2 * SIDE * SIDE;
/// Dispatches of one [`Spindrift::dispatch`].
pub const DISPATCHES: usize = 1;
/// Invocations of a workgroup.
const GROUP: u32 = 64;

/// As `Plume` in `shaders/lib/plume.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Plume {
    /// Where it leaves the crest, in the frame's local axes, metres.
    pub base: [f32; 3],
    /// Its opacity where it is densest, 0…1.
    pub strength: f32,
    /// Radiance of its drops, where nothing is seen through them.
    pub light: [f32; 3],
    /// Of its shape.
    pub seed: f32,
    /// Length along the wind and width, metres.
    pub size: [f32; 2],
    /// For WGSL's layout.
    pub unused: [f32; 2],
}

/// Looks of pictures that have spindrift.
pub fn looks() -> impl Iterator<Item = Look> {
    let shows = |look: &Look| {
        let Kind { measured, under_water, spray, fine, .. } = look.kind;
        !measured && !under_water && spray && fine && look.waves && look.foam
    };
    Look::all().filter(shows)
}

/// The composed shader that finds the plumes of one of the [`looks`].
pub fn plumes_source(look: Look) -> String {
    let own = format!("const MIRRORS_CLOUDS = false;\nconst PLUME_SIDE = {SIDE}u;\n");
    shader::composed(include_str!("../../shaders/plumes.wgsl"), &(look.definitions() + &own))
}

/// The composed shader that draws them.
pub fn source() -> String {
    shader::composed(include_str!("../../shaders/spindrift.wgsl"), "")
}

/// The pass.
pub struct Spindrift {
    written: wgpu::BindGroupLayout,
    made: wgpu::BindGroup,
    plumes: wgpu::Buffer,
    /// Of the draw.
    layouts: [wgpu::BindGroupLayout; 3],
    formats: [wgpu::TextureFormat; 2],
    tear: HashMap<Look, Compute>,
    drawings: HashMap<u32, Drawing>,
    read: Option<wgpu::BindGroup>,
}

impl Spindrift {
    /// The pass into `formats` of colour and depth, a colour that blends; `groups` are the layouts of bind groups 0 and 1.
    pub fn new(gpu: &Gpu, groups: [&wgpu::BindGroupLayout; 2], formats: [wgpu::TextureFormat; 2]) -> Self {
        let written = gpu.layout("plumes", wgpu::ShaderStages::COMPUTE, &[Bind::StorageWrite]);
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC;
        let plumes = gpu.empty_buffer("plumes", usage, u64::from(PLUMES) * size_of::<Plume>() as u64);
        let made = gpu.bind("plumes", &written, &[plumes.as_entire_binding()]);
        let read = gpu.layout("spindrift", wgpu::ShaderStages::VERTEX_FRAGMENT, &[Bind::Storage, Bind::Depth]);
        let layouts = [groups[0].clone(), groups[1].clone(), read];
        let (tear, drawings) = Default::default();
        Self { written, made, plumes, layouts, formats, tear, drawings, read: None }
    }

    /// Takes the depth of land that may stand before it.
    pub fn set_scene(&mut self, gpu: &Gpu, depth: &wgpu::TextureView) {
        let bound = [self.plumes.as_entire_binding(), wgpu::BindingResource::TextureView(depth)];
        self.read = Some(gpu.bind("spindrift", &self.layouts[2], &bound));
    }

    /// Compiles what a look needs, with so many samples of each pixel, once.
    pub fn prepare(&mut self, gpu: &Gpu, look: Look, samples: u32) {
        let Self { written, layouts, formats: [format, depth], tear, drawings, .. } = self;
        tear.entry(look).or_insert_with(|| {
            let groups = [&layouts[0], &layouts[1], written];
            let [tear] = gpu.compute("plumes", &plumes_source(look), &groups, ["tear"]);
            tear
        });
        drawings.entry(samples).or_insert_with(|| {
            let target = wgpu::ColorTargetState {
                format: *format,
                blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::COLOR,
            };
            let depth = Depth { format: *depth, test: DepthTest::Before, samples };
            gpu.drawing("spindrift", (&source(), "vertex"), &layouts.each_ref(), &[], target, Some(depth))
        });
    }

    /// Finds the plumes of a look. `groups`: bind groups 0 and 1.
    pub fn dispatch(&self, pass: &mut wgpu::ComputePass, look: Look, [frame, surface]: [&wgpu::BindGroup; 2]) {
        let Some(tear) = self.tear.get(&look) else { return };
        pass.set_pipeline(tear);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_bind_group(2, &self.made, &[]);
        pass.dispatch_workgroups(PLUMES / GROUP, 1, 1);
    }

    /// One draw, over the sea and before its depth.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, samples: u32, [frame, surface]: [&wgpu::BindGroup; 2]) {
        let Some((drawing, read)) = self.drawings.get(&samples).zip(self.read.as_ref()) else { return };
        pass.set_pipeline(drawing);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_bind_group(2, read, &[]);
        pass.draw(0..6 * PLUMES, 0..1);
    }

    /// The plumes of the last picture that had any; see [`Plume`].
    pub fn plumes(&self) -> &wgpu::Buffer {
        &self.plumes
    }
}
