//! Foam's lace covers the share that it is told to cover, whatever the pixels are wide.

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::noise;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import foam
struct Asked { at: vec2f, share: f32, footprint: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<f32>;
@compute @workgroup_size(64)
fn lace(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    found[id.x] = foam_lace(asked[id.x].share, asked[id.x].at, asked[id.x].footprint);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [f32; 2],
    share: f32,
    footprint: f32,
}

const SHARES: [f32; 6] = [0.01, 0.03, 0.1, 0.3, 0.6, 0.9];
const POINTS: i32 = 131_072;

#[test]
fn lace_covers_its_share_between_any_two_of_its_octaves() {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let frame = Frame::new(&Settings::default(), &Camera::from_degrees(10.0, -30.0, 10.0, 0.0, 0.0), 1.7e9, [64; 2]);
    let layouts = [kernel::frame_layout(&gpu), gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[])];
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let groups =
        [kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), gpu.bind("unused", &layouts[1], &[])];
    let lace = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "lace", &layouts.each_ref());
    // Over two kilometres: cells of the noise are 6 m at most, so that nearly all points are independent.
    let places: Vec<[f32; 2]> = (0..POINTS)
        .map(|n| noise::bits(7, 5, n, 0).map(|bits| 2_000.0 * ((bits >> 40) as f32 / (1u32 << 24) as f32 - 0.5)))
        .collect();
    // From a whole octave to the second next, 0.05 m being the first, in sixths; then where the lace dissolves.
    let footprints = (0..=12).map(|n| 0.2 * 2f32.powf(n as f32 / 6.0)).chain([3.0, 8.0, 15.0, 30.0]);
    for footprint in footprints {
        let asked: Vec<Asked> =
            SHARES.iter().flat_map(|&share| places.iter().map(move |&at| Asked { at, share, footprint })).collect();
        let [found] = lace.run::<_, f32>(&gpu, &groups.each_ref(), &asked);
        let means: Vec<f32> =
            found.chunks_exact(places.len()).map(|found| found.iter().sum::<f32>() / POINTS as f32).collect();
        println!(
            "{footprint:.3} m: {:.3?}",
            means.iter().zip(SHARES).map(|(mean, share)| mean / share).collect::<Vec<_>>()
        );
        for (mean, share) in means.into_iter().zip(SHARES) {
            // The fitted distribution is within 2 % of the water above a level. What these points leave to chance: of uniform noise what is
            // covered deviates by 3.7 times its mean at a share of 1 %, by 2.8 at 3 %, over 362, the root of their number: three
            // deviations are 3.1 % and 2.3 %.
            let allowed = if share < 0.02 { 0.051 } else { 0.043 };
            assert!((mean / share - 1.0).abs() < allowed, "{footprint} m: {mean} of {share}");
        }
    }
}
