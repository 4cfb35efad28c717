//! The bench's counts of what a shader reads, against a shader whose reads are known.

#[path = "../../benches/accesses/counting.rs"]
mod counting;

use counting::{MARK, Reads, counting};
use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::full_screen::FullScreen;
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::texture::{self, Shape};

/// At column x: x + 3 texels in a loop, two in calls on the branch that is taken, and none on the one that is not.
const SHADER: &str = "
@group(0) @binding(0) var picture: texture_2d<f32>;

@vertex
fn vertex(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
    return vec4f(f32(i & 1u) * 4.0 - 1.0, f32(i >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

fn looked(at: u32) -> f32 { return textureLoad(picture, vec2u(at, 0u), 0).x; }

@fragment
fn fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    var sum = 0.0;
    for (var i = 0u; i < u32(at.x) + 3u; i++) { sum += textureLoad(picture, vec2u(i, 0u), 0).x; }
    if sum < 0.5 {
        sum += looked(0u) + looked(1u);
    } else {
        sum += textureLoad(picture, vec2u(0u), 0).y;
    }
    return vec4f(sum);
}
";

#[test]
fn a_fragment_counts_what_it_reads_through_loops_branches_and_calls() {
    let gpu = pollster::block_on(Gpu::headless()).unwrap();
    let rewritten = counting(SHADER, &|name| {
        assert_eq!(name, "picture");
        [64.0, 16.0]
    });
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
    let format = wgpu::TextureFormat::Rgba32Float;
    let black = gpu.texture("black", Shape::picture(8, 1), format, usage);
    let counts = gpu.texture("counts", Shape::picture(4, 1), format, usage);
    let binds = [Bind::Texels(wgpu::TextureViewDimension::D2)];
    let pass = FullScreen::new(&gpu, "counting", &rewritten, &binds, format, None);
    let group = pass.read(&gpu, &[wgpu::BindingResource::TextureView(&texture::view(&black))]);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    {
        let view = texture::view(&counts);
        let mut drawing = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: Default::default(),
            })],
            ..Default::default()
        });
        pass.draw(&mut drawing, &group);
    }
    gpu.queue.submit([encoder.finish()]);
    let bytes = gpu.read_texture(&counts, 0, 0).unwrap();
    for (x, pixel) in bytes.chunks_exact(16).map(bytemuck::pod_read_unaligned::<[f32; 4]>).enumerate() {
        // The loop's, and one in each call.
        let texels = (x + 3 + 2) as f64;
        let expected = Reads { samples: 0.0, texels, loads: 0.0, bytes: 16.0 * texels };
        assert_eq!((Reads::from_pixel(pixel), pixel[3]), (expected, MARK), "pixel {x}");
    }
}

#[test]
fn samples_and_loads_from_buffers_are_told_apart() {
    let source = "
@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var linear: sampler;
struct Item { place: vec2f, key: u32 }
@group(0) @binding(2) var<storage, read> items: array<Item>;
@group(0) @binding(3) var<uniform> block: vec4f;
@fragment
fn fragment() -> @location(0) vec4f {
    let item = items[1].place + vec2f(items[2].place.y, f32(items[0].key)) + block.xy;
    return textureSampleLevel(picture, linear, item, 0.0);
}
";
    let text = counting(source, &|_| [32.0, 8.0]);
    // One sample, three loads of 8, 4 and 4 bytes, and nothing for the uniform block.
    let sums: Vec<f64> = text
        .lines()
        .filter_map(|line| line.split_once("vec3<f32>("))
        .map(|(_, rest)| {
            rest.split(')').next().unwrap().split(',').map(|n| n.trim().trim_end_matches('f').parse::<f64>().unwrap())
        })
        .fold(vec![0.0; 3], |sum, numbers| sum.iter().zip(numbers).map(|(a, b)| a + b).collect());
    assert_eq!(sums, [f64::from(MARK), 3.0, 32.0 + 16.0], "{text}");
}
