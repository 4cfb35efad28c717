//! Shaders' functions of waves by a shore, asked at places of real coasts.

use std::time::{Duration, Instant};

use bytemuck::Pod;
use ocean_globe::data::world::World;
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::shore_waves::Shallows;
use ocean_globe::pass::shore_trains::ShoreTrains;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::sea::shores::Shores;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

/// The windows around a frame's eye, made from the bundled world.
pub fn made(world: &mut World, frame: &Frame) -> Shores {
    let (mut shores, start) = (Shores::default(), Instant::now());
    while !shores.prepare(world, frame, (true, true), f64::INFINITY) {
        world.poll();
        assert!(start.elapsed() < Duration::from_secs(60), "the coast does not come");
        std::thread::sleep(Duration::from_millis(1));
    }
    shores
}

/// Places at sea about a camera, metres apart: latitude, longitude, the water.
pub fn places(world: &mut World, camera: &Camera, spread_m: f64) -> Vec<(f64, f64, Shallows)> {
    let mut places = Vec::new();
    for (i, j) in (-12..12).flat_map(|i| (-12..12).map(move |j| (f64::from(i), f64::from(j)))) {
        let lat = camera.lat + i * spread_m / 6.37e6;
        let lon = camera.lon + j * spread_m / 6.37e6 / camera.lat.cos();
        let place = world.sample_blocking(lat, lon).unwrap();
        places.extend(place.shallows().map(|water| (lat, lon, water)));
    }
    places
}

/// A kernel with the entry `ask`, which reads `asked` and writes `found` of its group 2 and knows a frame and the windows around it.
pub struct Asker {
    gpu: Gpu,
    layouts: [wgpu::BindGroupLayout; 2],
    kernel: Kernel<1>,
    trains: ShoreTrains,
    /// Whether it asks for a moving picture.
    pub moving: bool,
}

impl Asker {
    pub fn new(source: &str) -> Self {
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let ty = wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only: true },
            has_dynamic_offset: false,
            min_binding_size: None,
        };
        let entry =
            wgpu::BindGroupLayoutEntry { binding: 15, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None };
        let surface =
            gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &[entry] });
        let layouts = [kernel::frame_layout(&gpu), surface];
        let kernel = Kernel::<1>::new(&gpu, &shader::composed(source, ""), "ask", &layouts.each_ref());
        let trains = ShoreTrains::new(&gpu);
        Self { gpu, layouts, kernel, trains, moving: false }
    }

    /// What it finds at a frame's instant.
    pub fn found<A: Pod, F: Pod>(&mut self, shores: &Shores, frame: &Frame, asked: &[A]) -> Vec<F> {
        self.trains.prepare(&self.gpu, shores, frame, self.moving);
        assert!(shores.ready().next().is_some(), "windows of waves");
        let gpu = &self.gpu;
        let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
        let words = wgpu::BindGroupEntry { binding: 15, resource: self.trains.buffer.as_entire_binding() };
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.layouts[1],
            entries: &[words],
        });
        let groups = [kernel::frame_group(gpu, &self.layouts[0], &uniform, &frame.wave_cells), group];
        let [found] = self.kernel.run(gpu, &groups.each_ref(), asked);
        found
    }
}
