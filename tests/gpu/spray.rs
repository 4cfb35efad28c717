//! Spray in the air as the drawing shaders have it: as much as lies along a ray.

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::spray;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::{Settings, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import spray
const SPRAY = true;
struct Asked { rise: f32, distance: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec2f>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    found[id.x] = vec2f(spray_depth(asked[id.x].rise, asked[id.x].distance), spray_before_sky(asked[id.x].rise));
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    rise: f32,
    distance: f32,
}

#[test]
fn spray_lies_along_rays() {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let layouts = [kernel::frame_layout(&gpu), gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[])];
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "ask", &layouts.each_ref());
    let settings = Settings { wind: Wind { speed_mps: 30.0, from_deg: 250.0 }, ..Settings::default() };
    for altitude_m in [2.0, 30.0, 400.0, 1e6] {
        let frame = Frame::new(&settings, &Camera::from_degrees(10.0, -30.0, altitude_m, 0.0, 0.0), 1.7e9, [64; 2]);
        let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
        let groups =
            [kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), gpu.bind("unused", &layouts[1], &[])];
        let extinction = spray::extinction_per_m(30.0);
        let height = spray::scale_height_m(frame.sea.sea.hs_m);
        // Down to the water at several slants, level, and up.
        let down = [1.0, 0.3, 0.02].map(|sine: f64| (-sine, altitude_m / sine));
        for (rise, distance) in down.into_iter().chain([(0.0, 700.0), (1e-5, 700.0), (0.4, 150.0)]) {
            let asked = [Asked { rise: rise as f32, distance: distance as f32 }; 64];
            let [found] = kernel.run::<_, [f32; 2]>(&gpu, &groups.each_ref(), &asked);
            // By midpoints of even steps in the logarithm of the way from the ray's lower end.
            let (steps, first) = (20_000, 1e-9);
            let end = if rise < 0.0 { 0.0 } else { altitude_m };
            let edge = |n: i32| distance * f64::powf(first, 1.0 - f64::from(n) / f64::from(steps));
            let wanted: f64 = (0..steps)
                .map(|n| (edge(n), edge(n + 1)))
                .map(|(a, b)| (b - a) * (-(end + rise.abs() * 0.5 * (a + b)) / height).exp())
                .sum::<f64>()
                * extinction;
            println!("{altitude_m} m, rise {rise}, {distance:.0} m: {:.5}, wanted {wanted:.5}", found[0][0]);
            // Single precision, a difference of exponentials that differ by a thousandth and more.
            assert!(
                (f64::from(found[0][0]) - wanted).abs() < 5e-4 * wanted + 1e-9,
                "{altitude_m} m, {rise}: {found:?}"
            );
            if rise > 0.1 {
                let sky = extinction * height * (-altitude_m / height).exp() / rise;
                assert!((f64::from(found[0][1]) - sky).abs() < 1e-4 * sky + 1e-9, "{altitude_m} m, {rise}: {found:?}");
            }
        }
    }
}
