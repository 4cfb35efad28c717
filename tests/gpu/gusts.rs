//! Gusts and lulls roughen and smooth the sea, and leave it as rough as it is on the whole.

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::noise;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::{Settings, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import gusts
struct Asked { at: vec2u, sin_lat: f32, footprint: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    found[id.x] = gusts(MapPoint(MERCATOR, asked[id.x].at), asked[id.x].sin_lat, asked[id.x].footprint);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    sin_lat: f32,
    footprint: f32,
}

/// Factors for an eye at a longitude, in a wind from 250 degrees.
fn gusts(lon: f64, asked: &[Asked]) -> Vec<f64> {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let settings = Settings { wind: Wind { speed_mps: 7.0, from_deg: 250.0 }, ..Settings::default() };
    let frame = Frame::new(&settings, &Camera::from_degrees(10.0, lon, 10.0, 0.0, 0.0), 1.7e9, [64; 2]);
    let layouts = [kernel::frame_layout(&gpu), gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[])];
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let groups =
        [kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), gpu.bind("unused", &layouts[1], &[])];
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "ask", &layouts.each_ref());
    let [found] = kernel.run::<_, f32>(&gpu, &groups.each_ref(), asked);
    found.into_iter().map(f64::from).collect()
}

#[test]
fn gusts_leave_the_mean_roughness() {
    const POINTS: i32 = 60_000;
    for (footprint, levels) in [(5.0, 4.0), (30.0, 3.0), (130.0, 2.0), (2_000.0f32, 0.0)] {
        let places = (0..POINTS).map(|n| noise::bits(3, 1, n, 0)[0]);
        let asked: Vec<_> =
            places.map(|bits| Asked { at: [bits as u32, (bits >> 32) as u32], sin_lat: 0.2, footprint }).collect();
        let found = gusts(-30.0, &asked);
        let mean = found.iter().sum::<f64>() / found.len() as f64;
        let logs: Vec<f64> = found.iter().map(|factor| factor.ln()).collect();
        let middle = logs.iter().sum::<f64>() / logs.len() as f64;
        let deviation = (logs.iter().map(|log| (log - middle).powi(2)).sum::<f64>() / logs.len() as f64).sqrt();
        println!("{footprint} m: mean {mean:.4}, deviation of the logarithm {deviation:.4}");
        // Three deviations of the mean of as many points, and the noise's own distribution, which is not quite a normal one.
        assert!((mean - 1.0).abs() < 0.01, "{footprint} m: {mean}");
        // The noise's deviation is known to two figures.
        let wanted = 0.35 * f64::sqrt(levels / 4.0);
        assert!((deviation - wanted).abs() <= 0.03 * wanted, "{footprint} m: {deviation}");
    }
}

#[test]
fn gusts_lie_where_they_are_whatever_eye_sees_them() {
    // Nine points 30 m apart, 20 km from one eye and 2 km from the other.
    let asked = |lon: f64| {
        let at = (f64::from(1u32 << 31) * (1.0 + lon / 180.0)) as u32;
        (0..9u32)
            .map(|n| Asked { at: [at + n * 3_200, 2_000_000_000 + n * 700], sin_lat: 0.1, footprint: 5.0 })
            .collect()
    };
    let asked: Vec<_> = asked(-30.0);
    let [near, far] = [-30.02, -30.2].map(|lon| gusts(lon, &asked));
    println!("{near:.4?}\n{far:.4?}");
    for (near, far) in near.iter().zip(&far) {
        // The way from the eye has 24 bits: a metre of 20 km in 2^24 is nothing; what is left is rounding of the turned way.
        assert!((near / far - 1.0).abs() < 1e-3, "{near} and {far}");
    }
    assert!(near.iter().any(|factor| (factor / near[0] - 1.0).abs() > 0.01));
}
