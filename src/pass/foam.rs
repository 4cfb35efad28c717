//! Foam in time: one dispatch advances the four squares of the foam map. What it means: `scene/foam.rs` and `model/foam.rs`.

use bytemuck::{Pod, Zeroable};

use crate::gpu::pipeline::Bind;
use crate::gpu::texture::{self, Shape};
use crate::gpu::{Gpu, shader};
use crate::model::foam::GROWTH_S;
use crate::model::waves::TICKS_PER_SECOND;
use crate::scene::foam::{FoamEye, LEVELS, TEXELS, TEXELS_M, replay_next, replay_span, replay_start, replay_stride};

/// 32 bits: 16 would round the small steps of a fast picture away, each driver in its own way.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;
/// Texels along a side of a workgroup.
const SIDE: u32 = 8;
/// Steps shorter than this are saved up, s: no eye sees them.
const SHORTEST_STEP_S: f64 = 1.0 / 120.0;

/// How long a crest of the finest square breaks at one place, s: a fraction of the second that its waves of a metre or two take.
const SHORTEST_BREAKING_S: f64 = 0.15;

/// Mirrors `FoamStep` in `shaders/foam.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[expect(missing_docs, reason = "documented where the shader declares them")]
pub struct FoamStep {
    pub previous: [[i32; 4]; LEVELS],
    pub grow: [f32; LEVELS],
    pub keep: [f32; LEVELS],
    pub empty: u32,
    pub cells: u32,
    pub unused_a: u32,
    pub unused_b: u32,
}

/// What a breaking crest leaves ungrown in a step of `dt_s` seconds. A crest that breaks for less than a step, T, is met by chance, in one
/// of dt/T steps: then the step grows it dt/T times as much as breaking for T does, so that the mean is right. On squares of
/// larger texels longer waves break, for longer.
fn ungrown(level: usize, dt_s: f64) -> f64 {
    let breaking_s = SHORTEST_BREAKING_S * (TEXELS_M[level] / TEXELS_M[0]).sqrt();
    let grown = if dt_s < breaking_s {
        1.0 - (-dt_s / GROWTH_S).exp()
    } else {
        dt_s / breaking_s * (1.0 - (-breaking_s / GROWTH_S).exp())
    };
    1.0 - grown.min(1.0)
}

/// The composed shader.
pub fn source() -> String {
    shader::composed(&include_str!("../../shaders/foam.wgsl").replace("FORMAT", "rgba32float"), "")
}

/// Up to when the map and each of its squares are right, and where the eye was then.
#[derive(Clone, Copy)]
struct State {
    ticks: u64,
    levels: [u64; LEVELS],
    eye: FoamEye,
    empty: bool,
    /// On its way through the past: then no step may be longer than the replay's.
    replaying: bool,
}

/// The pass and its two maps, of which one is read while the other is written.
pub struct Foam {
    pipeline: wgpu::ComputePipeline,
    step: wgpu::Buffer,
    /// `groups[i]` writes the other map than `maps[i]`.
    groups: [wgpu::BindGroup; 2],
    /// The maps, for bind group 1.
    pub maps: [wgpu::TextureView; 2],
    /// The maps' textures.
    pub textures: [wgpu::Texture; 2],
    current: usize,
    state: Option<State>,
}

impl Foam {
    /// Empty maps; `frame` and `surface` are the layouts of bind groups 0 and 1.
    pub fn new(gpu: &Gpu, frame: &wgpu::BindGroupLayout, surface: &wgpu::BindGroupLayout) -> Self {
        let binds = [Bind::Uniform, Bind::Write(FORMAT, wgpu::TextureViewDimension::D2)];
        let layout = gpu.layout("foam", wgpu::ShaderStages::COMPUTE, &binds);
        let [pipeline] = gpu.compute("foam", &source(), &[frame, surface, &layout], ["advance"]);
        let usage = wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST;
        let step = gpu.empty_buffer("foam step", usage, size_of::<FoamStep>() as u64);
        let shape = Shape::picture(TEXELS as u32, TEXELS as u32);
        let usage = wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::COPY_SRC;
        let textures = [0, 1].map(|_| gpu.texture("foam", shape, FORMAT, usage));
        let maps = textures.each_ref().map(texture::view);
        let groups = [1, 0].map(|to: usize| {
            gpu.bind("foam", &layout, &[step.as_entire_binding(), wgpu::BindingResource::TextureView(&maps[to])])
        });
        Self { pipeline, step, groups, maps, textures, current: 0, state: None }
    }

    /// Which of [`Foam::maps`] is the present one.
    pub fn current(&self) -> usize {
        self.current
    }

    /// Forgets the history: the next frame starts a replay.
    pub fn reset(&mut self) {
        self.state = None;
    }

    /// The instant up to which a map that is to show `ticks` must be brought next, and None when it shows them already. The first
    /// of a replay has no history; a step from a recent state leads straight to `ticks`.
    pub fn next_instant(&mut self, ticks: u64, eye: &FoamEye, lifetime_s: f64) -> Option<u64> {
        let usable = |state: &State| {
            let age = ticks.wrapping_sub(state.ticks);
            // Half of the widest square: nothing that the map knows would be left in the finer ones.
            let near = state.eye.at.distance(eye.at) < 0.25 * f64::from(TEXELS) * TEXELS_M[LEVELS - 1];
            let fine = state.eye.finest <= eye.finest;
            age <= 2 * replay_span(lifetime_s) && state.eye.frame == eye.frame && near && fine
        };
        let Some(state) = self.state.filter(usable) else {
            let ticks = replay_start(ticks, lifetime_s);
            self.state = Some(State { ticks, levels: [ticks; LEVELS], eye: *eye, empty: true, replaying: true });
            return Some(ticks);
        };
        let age = ticks.wrapping_sub(state.ticks);
        let seconds = age as f64 / TICKS_PER_SECOND;
        if state.empty {
            return Some(state.ticks);
        }
        // Saved up, unless the eye has moved on to texels that the map does not know.
        if seconds < SHORTEST_STEP_S && (age == 0 || state.eye == *eye) {
            return (state.eye != *eye).then_some(ticks);
        }
        // A picture that follows the last one late, on a slow machine, is a step all the same.
        let straight = !state.replaying && seconds <= 0.5 * lifetime_s;
        let next = if straight { ticks } else { replay_next(state.ticks, ticks, lifetime_s) };
        self.state = Some(State { replaying: next != ticks, ..state });
        Some(next)
    }

    /// Sets what the next [`Foam::dispatch`] does: brings the map to `ticks` with the eye at `eye`.
    pub fn prepare(&mut self, gpu: &Gpu, ticks: u64, eye: &FoamEye, lifetime_s: f64) {
        let fresh = State { ticks, levels: [ticks; LEVELS], eye: *eye, empty: true, replaying: false };
        let last = self.state.unwrap_or(fresh);
        let on_the_way = last.replaying && !last.empty;
        let due: [bool; LEVELS] = std::array::from_fn(|level| {
            level >= eye.finest && (!on_the_way || ticks.is_multiple_of(replay_stride(level, lifetime_s)))
        });
        let dt_s = |level: usize| ticks.wrapping_sub(last.levels[level]) as f64 / TICKS_PER_SECOND;
        // A square that is not due stays as it is.
        let each = |left: &dyn Fn(usize) -> f64| std::array::from_fn(|l| if due[l] { left(l) as f32 } else { 1.0 });
        let step = FoamStep {
            previous: std::array::from_fn(|level| {
                let ([x, y], _) = last.eye.texel(level);
                [x, y, 0, 0]
            }),
            // The first instant of a replay has no time before it: crests that break then count as white.
            grow: if last.empty { [0.0; LEVELS] } else { each(&|level| ungrown(level, dt_s(level))) },
            keep: each(&|level| (-dt_s(level) / lifetime_s).exp()),
            empty: u32::from(last.empty),
            cells: eye.cells,
            ..FoamStep::default()
        };
        gpu.queue.write_buffer(&self.step, 0, bytemuck::bytes_of(&step));
        let levels = std::array::from_fn(|level| if due[level] || last.empty { ticks } else { last.levels[level] });
        self.state = Some(State { ticks, levels, eye: *eye, empty: false, ..last });
    }

    /// One dispatch; `surface` must hold the present map. Afterwards the other map is the present one.
    pub fn dispatch(&mut self, pass: &mut wgpu::ComputePass, frame: &wgpu::BindGroup, surface: &wgpu::BindGroup) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, frame, &[]);
        pass.set_bind_group(1, surface, &[]);
        pass.set_bind_group(2, &self.groups[self.current], &[]);
        pass.dispatch_workgroups(TEXELS as u32 / SIDE, TEXELS as u32 / SIDE, 1);
        self.current = 1 - self.current;
    }
}
