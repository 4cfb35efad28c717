//! Foam maps on the waves of a sea, and what is measured on them.

use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::texture;
use ocean_globe::model::waves::{self, TICKS_PER_SECOND};
use ocean_globe::model::{foam, wave_domain};
use ocean_globe::pass::fft::{Fft, Precision, WaveData};
use ocean_globe::pass::foam::Foam;
use ocean_globe::scene::frame::{Frame, FrameUniform};
use ocean_globe::scene::sea::foam::{FoamEye, LEVELS, TEXELS, TEXELS_M};
use ocean_globe::scene::sea::foam_history::{FoamStep, History};
use ocean_globe::scene::settings::{Settings, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::kernel;

/// 2026-11-20T12:00:00Z.
pub const NOON: f64 = 1_795_176_000.0;

pub fn blown(speed_mps: f64) -> Settings {
    Settings { wind: Wind { speed_mps, from_deg: 250.0 }, ..Settings::default() }
}

pub fn ticks(seconds: f64) -> u64 {
    (seconds * TICKS_PER_SECOND) as u64
}

pub fn mean(values: &[f32]) -> f64 {
    values.iter().map(|&x| f64::from(x)).sum::<f64>() / values.len() as f64
}

/// The waves of a sea, and foam maps on them.
pub struct Sea {
    pub gpu: Gpu,
    pub frame: Frame,
    fft: Fft,
    pub layouts: [wgpu::BindGroupLayout; 2],
    pub lifetime_s: f64,
}

/// A foam map with the frame that it is made under.
pub struct Map {
    foam: Foam,
    history: History,
    pub uniform: wgpu::Buffer,
    frame: wgpu::BindGroup,
    surfaces: [wgpu::BindGroup; 2],
}

impl Sea {
    /// The eye is over the middle of a wave cell.
    pub fn new(settings: &Settings) -> Self {
        use wgpu::TextureViewDimension::*;
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let cell = wave_domain::cells_near(0.6, -0.5)[0];
        let camera = Camera::from_degrees(cell.lat.to_degrees(), cell.lon.to_degrees(), 10.0, 0.0, 0.0);
        let frame = Frame::new(settings, &camera, NOON, [64, 64]);
        let layouts = [
            kernel::frame_layout(&gpu),
            gpu.layout("surface", wgpu::ShaderStages::COMPUTE, &[D2Array, D2Array, D2Array, D2, D2].map(Bind::Texture)),
        ];
        let mut fft = Fft::new(&gpu, frame.sea.cascades[0].n, waves::CASCADES, Precision::Half);
        fft.set_waves(&gpu, &frame.sea.cascades, &WaveData::of(&frame.sea));
        Self { gpu, frame, fft, layouts, lifetime_s: settings.foam.lifetime_s }
    }

    pub fn map(&self, uniform: &FrameUniform) -> Map {
        use wgpu::BufferUsages as B;
        let gpu = &self.gpu;
        let foam = Foam::new(gpu, &self.layouts[0], &self.layouts[1]);
        let uniform = gpu.buffer("frame", B::UNIFORM, bytemuck::bytes_of(uniform));
        let frame = kernel::frame_group(gpu, &self.layouts[0], &uniform, &self.frame.wave_cells);
        let surfaces = foam.maps.each_ref().map(|map| {
            let waves = [&self.fft.displacements, &self.fft.slopes, &self.fft.stretches].map(texture::array_view);
            // No noise is read: its place is taken by the map itself.
            let views = [&waves[0], &waves[1], &waves[2], map, map].map(wgpu::BindingResource::TextureView);
            gpu.bind("surface", &self.layouts[1], &views)
        });
        Map { foam, history: History::default(), uniform, frame, surfaces }
    }

    pub fn own_map(&self) -> Map {
        self.map(&self.frame.uniform)
    }

    /// Waves at an instant, as far as foam is made from them.
    pub fn run(&self, now: u64) {
        self.fft.set_time(&self.gpu, now);
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            self.fft.dispatch_stretches(&mut pass);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// Waves at an instant, their shape with all mip levels.
    pub fn run_whole(&self, now: u64) {
        self.fft.set_time(&self.gpu, now);
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            self.fft.dispatch(&mut pass);
            self.fft.dispatch_mips(&mut pass);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// The bind groups of the frame and of the waves that a map lies on.
    pub fn groups<'a>(&self, map: &'a Map) -> [&'a wgpu::BindGroup; 2] {
        [&map.frame, &map.surfaces[map.foam.current()]]
    }

    /// Brings a map to an instant whose waves are there.
    pub fn step(&self, map: &mut Map, now: u64, eye: &FoamEye) {
        let step = map.history.step(now, eye, self.lifetime_s, &self.frame.whitecaps.breaking_m);
        self.advance(map, &step);
    }

    /// As [`Sea::step`], of a map laid out in these levels: foam grows by the crests of its level.
    pub fn step_as(&self, map: &mut Map, levels: [usize; LEVELS], now: u64, eye: &FoamEye) {
        let mut step = map.history.step(now, eye, self.lifetime_s, &self.frame.whitecaps.breaking_m);
        if step.empty == 0 {
            // Every level is due at every step: the time that has passed is what all of them have decayed by.
            let dt_s = -self.lifetime_s * f64::from(step.keep[0]).ln();
            step.grow = levels.map(|level| foam::ungrown(self.frame.whitecaps.breaking_m[level], dt_s) as f32);
        }
        self.advance(map, &step);
    }

    fn advance(&self, map: &mut Map, step: &FoamStep) {
        map.foam.prepare(&self.gpu, step);
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            let surface = &map.surfaces[map.foam.current()];
            map.foam.dispatch(&mut pass, &map.frame, surface);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// As a frame does: as many steps as the map asks for. Returns their number.
    pub fn bring(&self, map: &mut Map, now: u64, eye: &FoamEye) -> usize {
        self.follow(map, now, eye, false)
    }

    /// As [`Sea::bring`]; `moving`: more frames follow.
    pub fn follow(&self, map: &mut Map, now: u64, eye: &FoamEye, moving: bool) -> usize {
        let mut uniform = self.frame.uniform;
        for (level, own) in uniform.foam_levels.iter_mut().enumerate() {
            (own.texel, own.fraction) = eye.texel(level);
        }
        // The frame's cells stay where its own eye is: the levels are laid out from there.
        let moved = eye.at - self.frame.foam_eye.at;
        for (level, own) in uniform.foam_levels.iter_mut().enumerate() {
            let shift = (moved / TEXELS_M[level]).as_vec2();
            own.fraction = [own.fraction[0] - shift.x, own.fraction[1] - shift.y];
        }
        self.gpu.queue.write_buffer(&map.uniform, 0, bytemuck::bytes_of(&uniform));
        let mut steps = 0;
        while let Some(instant) = map.history.next_instant(now, eye, self.lifetime_s, moving) {
            self.run(instant);
            self.step(map, instant, eye);
            steps += 1;
        }
        steps
    }

    /// Foam of one level of a map, by slot.
    pub fn foam(&self, map: &Map, level: usize) -> Vec<f32> {
        self.texels(map).into_iter().map(|texel| texel[level]).collect()
    }

    /// Young foam of one level of a map, by slot.
    pub fn young(&self, map: &Map, level: usize) -> Vec<f32> {
        self.part(map, 1).into_iter().map(|texel| texel[level]).collect()
    }

    /// Mean foam of each level of a map.
    pub fn means(&self, map: &Map) -> [f64; LEVELS] {
        let texels = self.texels(map);
        std::array::from_fn(|level| {
            texels.iter().map(|texel| f64::from(texel[level])).sum::<f64>() / texels.len() as f64
        })
    }

    fn texels(&self, map: &Map) -> Vec<[f32; LEVELS]> {
        self.part(map, 0)
    }

    /// All foam of a map, or the young.
    fn part(&self, map: &Map, part: usize) -> Vec<[f32; LEVELS]> {
        let bytes = self.gpu.read_texture(&map.foam.textures[map.foam.current()], 0, 0).unwrap();
        let texels = bytes.chunks_exact(16).map(bytemuck::pod_read_unaligned);
        let count = (TEXELS * TEXELS) as usize;
        texels.skip(part * count).take(count).collect()
    }
}
