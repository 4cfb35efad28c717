//! The water as the drawing shaders have it, at places that a test asks for.

use std::sync::Arc;

use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::texture;
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::wave_domain;
use ocean_globe::model::waves::{self, Cascade};
use ocean_globe::pass::fft::{Fft, Precision, WaveData};
use ocean_globe::pass::perlin::Perlin;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::frame::uniform::WaveAnchor;
use ocean_globe::scene::settings::{Settings, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

/// 2026-11-20T12:00:00Z.
pub const NOON: f64 = 1_795_176_000.0;

const KERNEL: &str = "#import waves
const WAVES = true;
const NOISE = true;
@group(2) @binding(0) var<storage, read> places: array<vec4f>;   // east and north of the eye, distance for the mix, footprint; metres
@group(2) @binding(1) var<storage, read_write> found: array<vec4f>;
@compute @workgroup_size(64)
fn drawn(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&places) { return; }
    let place = places[id.x];
    let p = vec3f(place.xy, -frame.eye_altitude);
    let slopes = slopes_in(OPEN_SEA, p, place.z, place.w, 1.0);
    let plane = plane_of(0u);
    let triangle = lattice_triangle(plane, 0u, frame.spacings.x, in_plane(plane, p));
    let placed = placement(plane, 0u, frame.spacings.x, frame.patches.x, triangle, 0u);
    let ax = placed.axis_x;
    let ay = placed.axis_y;
    found[2u * id.x] = vec4f(displacement_in(OPEN_SEA, p, place.z, place.w).z, 0.0, 0.0, 0.0);
    found[2u * id.x + 1u] = vec4f(dot(slopes.slope, ax), dot(slopes.slope, ay), slopes.rough);
}";

/// Height of the water, m; slopes along the wind and across it; their variances that the footprint hides.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    pub height: f64,
    pub slope: [f64; 2],
    pub rough: [f64; 2],
}

/// Energies and frequencies of a sea's patches, so that another seed costs its random numbers alone.
pub struct Waves {
    pub patches: [Cascade; waves::CASCADES],
    pub energies: Vec<Vec<f64>>,
    pub omegas: Vec<Vec<f64>>,
}

impl Waves {
    pub fn of(tables: &SeaTables) -> Self {
        let (patches, spectrum) = (tables.cascades, tables.sea.spectrum());
        let energies = patches.iter().map(|patch| waves::cell_energies(&spectrum, patch)).collect();
        let omegas = patches.iter().map(|patch| tables.frequencies(patch)).collect();
        Self { patches, energies, omegas }
    }

    pub fn data(&self, seed: u32) -> WaveData {
        let mut data = WaveData::default();
        for (index, patch) in self.patches.iter().enumerate() {
            data.push(patch, &waves::amplitudes(&self.energies[index], seed, index, patch), &self.omegas[index]);
        }
        data
    }
}

/// A sea without chop: its water stays where it is, so that a place at rest is a place drawn.
pub fn chopless(speed_mps: f64) -> Settings {
    Settings { wind: Wind { speed_mps, from_deg: 250.0 }, chop: 0.0, ..Settings::default() }
}

/// A frame of a chopless sea whose eye is over the middle of a wave cell, where no other cell has a share, and on a vertex of
/// lattices so wide that no other vertex has one: the water of one placement of each patch.
pub fn frame(settings: &Settings, unix_seconds: f64) -> Frame {
    let cell = wave_domain::cells_near(0.6, -0.5)[0];
    let camera = Camera::from_degrees(cell.lat.to_degrees(), cell.lon.to_degrees(), 3.0, 0.0, 0.0);
    let mut frame = Frame::new(settings, &camera, unix_seconds, [64, 64]);
    frame.uniform.spacings = glam::Vec4::splat(1e9);
    frame.uniform.perlin_spacing = 1e9;
    // With the vertex at the cell's centre, all places east and north of the eye have it as the first one of their triangle.
    frame.wave_cells[0].anchors.fill(WaveAnchor { vertex: [0, 0], eye: glam::Vec2::new(10_000.0, 1_000.0) });
    frame
}

/// The same frame with the noise of another seed at another instant.
pub fn reseeded(frame: &Frame, seed: u32, unix_seconds: f64) -> Frame {
    let mut tables = SeaTables::clone(&frame.sea);
    tables.sea.seed = seed;
    Frame { sea: Arc::new(tables), unix_seconds, ..frame.clone() }
}

/// The passes that make the water, and a kernel that asks for it.
pub struct Water {
    pub gpu: Gpu,
    pub fft: Fft,
    pub perlin: Perlin,
    layouts: [wgpu::BindGroupLayout; 2],
    kernel: Kernel<1>,
}

impl Water {
    /// Patches of `n` samples; `edited` may change the drawing shaders' text.
    pub fn new(n: usize, precision: Precision, edited: impl Fn(String) -> String) -> Self {
        use wgpu::TextureViewDimension::*;
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let waves = [D2Array, D2Array, D2Array, D2].map(Bind::Texture);
        let layouts = [kernel::frame_layout(&gpu), gpu.layout("surface", wgpu::ShaderStages::COMPUTE, &waves)];
        let kernel = Kernel::new(&gpu, &edited(shader::composed(KERNEL, "")), "drawn", &layouts.each_ref());
        let fft = Fft::new(&gpu, n, waves::CASCADES, precision).sharpened(true);
        let perlin = Perlin::new(&gpu);
        Self { gpu, fft, perlin, layouts, kernel }
    }

    /// Another kernel on the same water: its groups 0 and 1 are those of the frame and of the surface.
    pub fn kernel<const N: usize>(&self, source: &str, entry: &str) -> Kernel<N> {
        Kernel::new(&self.gpu, source, entry, &self.layouts.each_ref())
    }

    /// Runs the waves at an instant.
    pub fn set_waves(&mut self, patches: &[Cascade], data: &WaveData, ticks: u64) {
        self.fft.set_waves(&self.gpu, patches, data);
        self.fft.set_time(&self.gpu, ticks);
        self.run(|water, pass| {
            water.fft.dispatch(pass);
            water.fft.dispatch_mips(pass);
        });
    }

    /// Runs the waves of a sea, with a seed, at a time.
    pub fn set_sea(&mut self, waves: &Waves, seed: u32, unix_seconds: f64) {
        self.set_waves(&waves.patches, &waves.data(seed), waves::ticks_from_unix(unix_seconds));
    }

    /// Runs the far sea of a frame.
    pub fn set_noise(&mut self, frame: &Frame) {
        self.perlin.prepare(&self.gpu, frame);
        self.run(|water, pass| {
            water.perlin.dispatch(pass);
            water.perlin.dispatch_mips(pass);
        });
    }

    fn run(&self, work: impl Fn(&Self, &mut wgpu::ComputePass)) {
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        work(self, &mut encoder.begin_compute_pass(&Default::default()));
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// Bind groups 0 and 1 of a frame.
    pub fn groups(&self, frame: &Frame) -> [wgpu::BindGroup; 2] {
        let gpu = &self.gpu;
        let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
        let [a, b, c] = [&self.fft.displacements, &self.fft.slopes, &self.fft.stretches].map(texture::array_view);
        let views = [a, b, c, texture::view(&self.perlin.texture)];
        [
            kernel::frame_group(gpu, &self.layouts[0], &uniform, &frame.wave_cells),
            gpu.bind("surface", &self.layouts[1], &views.each_ref().map(wgpu::BindingResource::TextureView)),
        ]
    }

    /// The water at places (east and north of the eye, distance, footprint; metres).
    pub fn at(&self, frame: &Frame, places: &[[f32; 4]]) -> Vec<Drawn> {
        let [found] = self.kernel.run::<_, [f32; 8]>(&self.gpu, &self.groups(frame).each_ref(), places);
        let drawn = |values: [f32; 8]| {
            let [height, _, _, _, x, y, rx, ry] = values.map(f64::from);
            Drawn { height, slope: [x, y], rough: [rx, ry] }
        };
        found.into_iter().map(drawn).collect()
    }
}

/// Place `index` of a plane-filling sequence in a square of `side_m`, m: the multiples of 1/ρ and 1/ρ², ρ³ = ρ + 1.
pub fn place(index: usize, side_m: f64) -> [f64; 2] {
    [0.754_877_666_246_692_7, 0.569_840_290_998_053_2].map(|step| (index as f64 * step).fract() * side_m)
}

/// For each pair (distance for the mix, footprint; m) `count` places in a square of `side_m`, from the sequence's `first` on.
pub fn places(pairs: &[[f64; 2]], first: usize, count: usize, side_m: f64) -> Vec<[f32; 4]> {
    let at = |[distance, footprint]: [f64; 2], index: usize| {
        let [x, y] = place(index, side_m);
        [x, y, distance, footprint].map(|metres| metres as f32)
    };
    pairs.iter().flat_map(|&pair| (first..first + count).map(move |index| at(pair, index))).collect()
}

/// The mean of a value over places.
pub fn mean(drawn: &[Drawn], value: impl Fn(&Drawn) -> f64) -> f64 {
    drawn.iter().map(value).sum::<f64>() / drawn.len() as f64
}

/// A mean with its standard error, from one value for each realisation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ensemble {
    count: f64,
    sum: f64,
    squares: f64,
}

impl Ensemble {
    pub fn push(&mut self, value: f64) {
        self.count += 1.0;
        self.sum += value;
        self.squares += value * value;
    }

    pub fn mean(&self) -> f64 {
        self.sum / self.count
    }

    pub fn error(&self) -> f64 {
        ((self.squares / self.count - self.mean().powi(2)).max(0.0) / (self.count - 1.0)).sqrt()
    }

    /// How many independent Gaussian numbers tell their variance as sharply as this tells its mean: 2 (mean/error)².
    pub fn independent_samples(&self) -> f64 {
        2.0 * (self.mean() / self.error()).powi(2)
    }
}
