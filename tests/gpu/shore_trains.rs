//! Waves by a shore as the drawing shaders have them, against the model in f64: the formulas of breakers, and the sum of the trains at places
//! of real coasts.

use std::time::{Duration, Instant};

use bytemuck::{Pod, Zeroable};
use ocean_globe::data::tile::{MapPoint, Projection};
use ocean_globe::data::world::World;
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::{GRAVITY, dispersion, surf};
use ocean_globe::pass::shore_trains::ShoreTrains;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::sea::shores::Shores;
use ocean_globe::scene::settings::{Settings, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const BREAKERS: &str = "#import breakers
struct Found { first: vec4f, second: vec4f }
@group(2) @binding(0) var<storage, read> asked: array<vec4f>;
@group(2) @binding(1) var<storage, read_write> found: array<Found>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let k_deep = a.y * a.y / GRAVITY;
    let y = depth_number(k_deep * a.z);
    let gamma = breaker_index(a.w, a.x, a.y);
    let breaks = breaking_depth(a.x, k_deep, gamma);
    let turn = sine_cosine(1.9);
    let surface = wave_surface(wave_shape(a.x, y, a.z, 0.3), vec2f(turn.cosine, turn.sine));
    found[id.x] = Found(vec4f(y, shoaling(y), gamma, breaks), vec4f(broken_height(0.6, a.w, gamma), surface, 0.0));
}";

#[test]
fn breakers_are_those_of_the_model() {
    let mut asked = Vec::new();
    for height in [0.2f32, 1.0, 3.0] {
        for period in [4.0f32, 8.0, 16.0] {
            for depth in [0.1f32, 0.7, 3.0, 12.0, 60.0] {
                asked.extend(
                    [0.01f32, 0.03, 0.06, 0.1].map(|slope| [height, std::f32::consts::TAU / period, depth, slope]),
                );
            }
        }
    }
    let found = kernel::answers::<_, [f32; 8]>(BREAKERS, &asked);
    for (asked, found) in asked.iter().zip(&found) {
        let [height, omega, depth, slope] = asked.map(f64::from);
        let k = dispersion::wavenumber(omega, depth);
        let gamma = surf::breaker_index(slope, height, omega);
        let [rise, tilt] = surf::Shape::new(height, k, depth, 0.3).surface(1.9);
        let wanted = [
            k * depth,
            dispersion::shoaling(k, depth),
            gamma,
            surf::breaking_depth(height, omega * omega / GRAVITY, gamma),
            surf::broken(0.6, slope, gamma),
            rise,
            tilt,
        ];
        for (what, (wanted, found)) in wanted.iter().zip(found).enumerate() {
            // One step of Newton's leaves 2e-3 of kh, of which the Ursell number takes the square.
            let error = (f64::from(*found) - wanted).abs() / wanted.abs().max(0.3);
            assert!(error < 6e-3, "{what}: {found} for {wanted}, {asked:?}");
        }
    }
}

const TRAINS: &str = "#import shore_trains
struct Asked { at: vec2u, depth: f32, shore: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec4f>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let waves = shore_waves_at(MapPoint(MERCATOR, a.at), a.depth, a.shore, 0.0, 0.0);
    found[id.x] = vec4f(waves.rise, waves.slope, waves.share);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    depth: f32,
    shore: f32,
}

/// The windows around a frame's eye, made from the bundled world.
fn made(world: &mut World, frame: &Frame) -> Shores {
    let (mut shores, start) = (Shores::default(), Instant::now());
    while !shores.prepare(world, frame, (true, true), f64::INFINITY) {
        world.poll();
        assert!(start.elapsed() < Duration::from_secs(60), "the coast does not come");
        std::thread::sleep(Duration::from_millis(1));
    }
    shores
}

/// Places at sea about a camera, metres apart: latitude, longitude, depth, distance to the shore.
fn places(world: &mut World, camera: &Camera, spread_m: f64) -> Vec<[f64; 4]> {
    let mut places = Vec::new();
    for (i, j) in (-12..12).flat_map(|i| (-12..12).map(move |j| (f64::from(i), f64::from(j)))) {
        let lat = camera.lat + i * spread_m / 6.37e6;
        let lon = camera.lon + j * spread_m / 6.37e6 / camera.lat.cos();
        let place = world.sample_blocking(lat, lon).unwrap();
        if let (Some(depth), Some(shore)) = (place.depth_m, place.shore_distance_m) {
            places.push([lat, lon, depth, shore]);
        }
    }
    places
}

#[test]
fn trains_at_places_are_those_of_the_cpu() {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let mut world = World::open("www/data");
    let camera = Camera::from_degrees(52.0986, 4.2520, 30.0, 0.0, 60.0);
    let settings = Settings { wind: Wind { speed_mps: 9.0, from_deg: 310.0 }, ..Settings::default() };
    let frame = Frame::new(&settings, &camera, 1_782_039_600.0, [64; 2]);
    // Opens the archives.
    let places = places(&mut world, &camera, 23.0);
    let shores = made(&mut world, &frame);
    let mut trains = ShoreTrains::new(&gpu);
    assert!(trains.prepare(&gpu, &shores, &frame), "windows of waves");
    let entry =
        |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None };
    let storage = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Storage { read_only: true },
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let surface = gpu
        .device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &[entry(15, storage)] });
    let layouts = [kernel::frame_layout(&gpu), surface];
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(TRAINS, ""), "ask", &layouts.each_ref());
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let buffer = wgpu::BindGroupEntry { binding: 15, resource: trains.buffer.as_entire_binding() };
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &layouts[1],
        entries: &[buffer],
    });
    let groups = [kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), group];
    let asked: Vec<_> = places
        .iter()
        .map(|&[lat, lon, depth, shore]| {
            let point = MapPoint::on(Projection::Mercator, lat, lon);
            Asked { at: [point.u, point.v], depth: depth as f32, shore: shore as f32 }
        })
        .collect();
    let [found] = kernel.run::<_, [f32; 4]>(&gpu, &groups.each_ref(), &asked);
    let (mut seen, mut squares, mut heights) = (0, [0.0; 2], 0.0);
    for (place, found) in places.iter().zip(&found) {
        let &[lat, lon, depth, shore] = place;
        let Some(wanted) = shores.waves_at((lat, lon), depth, shore, frame.ticks()) else {
            assert_eq!(found[3], 0.0, "{place:?}");
            continue;
        };
        assert!((f64::from(found[3]) - wanted.share).abs() < 1e-4, "{found:?} {wanted:?}");
        squares[0] += (f64::from(found[0]) - wanted.wave.rise).powi(2);
        squares[1] +=
            (f64::from(found[1]) - wanted.wave.slope[0]).powi(2) + (f64::from(found[2]) - wanted.wave.slope[1]).powi(2);
        heights += wanted.wave.rise.powi(2);
        seen += 1;
    }
    let [rise, slope] = squares.map(|square| (square / f64::from(seen)).sqrt());
    let height = (heights / f64::from(seen)).sqrt();
    println!("{seen} places, waves of {height:.3} m rms: off by {rise:.5} m and {slope:.5}");
    assert!(seen > 150 && height > 0.1);
    // Phases of hundreds of radians in 32 bits, and the fronts of bores, which 1e-3 of a radian move by a centimetre.
    assert!(rise < 0.01 * height && slope < 0.01, "{rise} {slope}");
}

#[test]
fn windows_of_waves_hand_over_their_energy() {
    // Off the Dutch coast, across the edges of windows, over 40 instants: variance of the trains over what they have taken and shoaling makes of
    // it, at places beside edges and away from them.
    let mut world = World::open("www/data");
    let camera = Camera::from_degrees(52.105, 4.235, 30.0, 0.0, 60.0);
    let settings = Settings { wind: Wind { speed_mps: 6.0, from_deg: 310.0 }, ..Settings::default() };
    let frame = Frame::new(&settings, &camera, 1_782_039_600.0, [64; 2]);
    let places = places(&mut world, &camera, 190.0);
    let shores = made(&mut world, &frame);
    // Another eye finds the same waves where both see them.
    let other = Camera::from_degrees(52.099, 4.226, 300.0, 0.0, 60.0);
    let others = made(&mut world, &Frame::new(&settings, &other, 0.0, [64; 2]));
    for [lat, lon, depth, shore] in &places {
        let waves = [&shores, &others].map(|shores| shores.waves_at((*lat, *lon), *depth, *shore, frame.ticks()));
        assert_eq!(waves[0], waves[1]);
    }
    let mut sums = [[0.0f64; 2]; 2];
    for [lat, lon, _, shore] in places.into_iter().filter(|place| place[3] > 900.0 && place[3] < 2_300.0) {
        let point = MapPoint::on(Projection::Mercator, lat, lon);
        let inside = [point.u, point.v].map(|at| f64::from(at << 13) / 4_294_967_296.0);
        let beside = usize::from(inside.iter().any(|at| (at - 0.5).abs() > 0.42));
        for instant in 0..40 {
            let ticks = frame.ticks() + instant * 7_340_033;
            // As deep everywhere, so that waves are as high: only their phases and their ways differ.
            let Some(waves) = shores.waves_at((lat, lon), 8.0, shore, ticks) else { continue };
            sums[beside][0] += waves.wave.rise * waves.wave.rise;
            sums[beside][1] += waves.share;
        }
    }
    let [away, beside] = sums.map(|[square, share]| square / share);
    println!(
        "variance {away:.4} m² away from edges, {beside:.4} m² beside them, of {} and {} samples",
        sums[0][1], sums[1][1]
    );
    assert!(sums[1][1] > 300.0, "edges were met");
    // Thousands of samples each, of eight trains at forty instants; the trains' lees differ from place to place.
    assert!((beside / away - 1.0).abs() < 0.03, "{beside} beside edges, {away} away from them");
}
