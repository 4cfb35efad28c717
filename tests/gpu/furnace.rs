//! White furnaces: under a sky as bright everywhere as what lies below the water, the water cannot be seen.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use half::f16;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::texture::{self, Shape};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::pass::rough_table;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import water
const FINE = true;
const CLOUDS = false;
const MIRRORS_CLOUDS = false;
struct Asked { to_eye: vec3f, rough: f32, normal: vec3f, white: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec4f>;
@compute @workgroup_size(64)
fn glow(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let a = asked[id.x];
    let up = vec3f(0.0, 0.0, 1.0);
    let water = WaterPoint(vec3f(0.0), a.to_eye, up, a.normal, vec3f(1.0, 0.0, 0.0), a.rough * vec2f(1.2, 0.8), 0.0, 1.0, Bed(vec3f(1.0), 0.0, 1.0),
        flat_foam(a.white, 0.0), MEAN_FACETS, vec3f(0.0), NO_LAND);
    let light = daylight_at(dot(frame.light, up));
    found[id.x] = vec4f(water_radiance(water, light, light), 1.0);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    to_eye: Vec3,
    rough: f32,
    normal: Vec3,
    white: f32,
}

#[test]
fn water_is_not_seen_in_a_white_furnace() {
    use wgpu::TextureViewDimension::{D2, D3};
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let mut frame =
        Frame::new(&Settings::default(), &Camera::from_degrees(0.0, -30.0, 10.0, 0.0, 0.0), 43_200.0, [64; 2]);
    frame.uniform.night = 0.0;
    let even = |value: f32, dimension| {
        let shape = Shape { dimension, ..Shape::picture(1, 1) };
        let texture = gpu.texture("furnace", shape, wgpu::TextureFormat::Rgba16Float, wgpu::TextureUsages::COPY_DST);
        gpu.fill(&texture, bytemuck::cast_slice(&[f16::from_f32(value).to_bits(); 4]));
        texture::view(&texture)
    };
    // A sky of radiance 1, the light of all of it on level ground, and no sun.
    let sky = even(1.0, wgpu::TextureDimension::D3);
    let [light, none] = [std::f32::consts::PI, 0.0].map(|value| even(value, wgpu::TextureDimension::D2));
    let rough = rough_table::view(&gpu);
    let mut binds = [Bind::Texture(D2); 14];
    (binds[5], binds[12], binds[13]) = (Bind::Texture(D3), Bind::Storage, Bind::Storage);
    let layouts = [kernel::frame_layout(&gpu), gpu.layout("furnace", wgpu::ShaderStages::COMPUTE, &binds)];
    let mut views = [&none; 12];
    (views[5], views[6], views[10]) = (&sky, &light, &rough);
    let clouds = gpu.empty_buffer("clouds", wgpu::BufferUsages::STORAGE, 16);
    let no_clouds = clouds.as_entire_binding();
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let groups = [
        kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells),
        gpu.bind(
            "furnace",
            &layouts[1],
            &[&views.map(wgpu::BindingResource::TextureView)[..], &[no_clouds.clone(), no_clouds]].concat(),
        ),
    ];
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "glow", &layouts.each_ref());
    let mut asked = Vec::new();
    for elevation in [0.1f32, 1.0, 5.0, 20.0, 60.0, 89.9] {
        let (sin, cos) = elevation.to_radians().sin_cos();
        for (slope, rough) in [(0.0, 0.0), (0.0, 0.02), (0.3, 0.005), (-0.3, 0.03), (-0.02, 0.001)] {
            for white in [0.0, 1.0] {
                let normal = Vec3::new(slope, 0.1, 1.0).normalize();
                asked.push(Asked { to_eye: Vec3::new(cos, 0.0, sin), rough, normal, white });
            }
        }
    }
    let [found] = kernel.run::<_, [f32; 4]>(&gpu, &groups.each_ref(), &asked);
    for (asked, found) in asked.iter().zip(&found) {
        // Foam keeps 0.45 of the light; flat foam in even light looks the same from everywhere.
        let wanted = if asked.white == 1.0 { 0.55 } else { 1.0 };
        // Half floats have eleven bits.
        assert!(found[..3].iter().all(|part| (part / wanted - 1.0).abs() < 1e-3), "{asked:?}: {found:?}");
    }
}
