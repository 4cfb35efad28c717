//! Foam's lace: the share that it is told to cover is covered, and means do not depend on how wide pixels are.

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::pipeline::Bind;
use ocean_globe::gpu::{Gpu, shader, texture};
use ocean_globe::model::{foam, noise};
use ocean_globe::pass;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import lace
struct Asked { at: vec2f, share: f32, young: f32, footprint: f32, unused: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec3f>;
@compute @workgroup_size(64)
fn foamy(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let own = asked[id.x];
    let seen = lace_at(own.at, own.footprint);
    let dense = dense_from(own.young);
    found[id.x] = vec3f(covered(excess(own.share, seen.level.x), seen.hidden.x), foam_of(own.share, dense, 1.0, seen, true).white,
        mean_foam(own.share, dense, 1.0, true).white);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [f32; 2],
    share: f32,
    young: f32,
    footprint: f32,
    unused: f32,
}

/// Shares of the water under whitecaps: of a breeze, whose foam has neither rows nor a film, and of a storm.
const BREEZE: f32 = 0.005;
const STORM: f32 = 0.2;
const SHARES: [f32; 6] = [0.01, 0.03, 0.1, 0.3, 0.6, 0.9];
const POINTS: i32 = 131_072;
struct Lace {
    gpu: Gpu,
    groups: [wgpu::BindGroup; 2],
    kernel: Kernel<1>,
    places: Vec<[f32; 2]>,
}

impl Lace {
    fn new(whitecaps: f32) -> Self {
        let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
        let camera = Camera::from_degrees(10.0, -30.0, 10.0, 0.0, 0.0);
        let mut frame = Frame::new(&Settings::default(), &camera, 1.7e9, [64; 2]);
        frame.uniform.whitecaps = whitecaps;
        // The lace alone is read of bind group 1, at its last binding.
        let surface = [Bind::Texture(wgpu::TextureViewDimension::D2); 12];
        let layouts = [kernel::frame_layout(&gpu), gpu.layout("surface", wgpu::ShaderStages::COMPUTE, &surface)];
        let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
        let lace = pass::foam::empty_lace(&gpu);
        pass::foam::fill_lace(&gpu, &lace);
        let tile = texture::view(&lace);
        let groups = [
            kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells),
            gpu.bind("surface", &layouts[1], &surface.map(|_| wgpu::BindingResource::TextureView(&tile))),
        ];
        let kernel = Kernel::new(&gpu, &shader::composed(KERNEL, ""), "foamy", &layouts.each_ref());
        // Over ten kilometres: hundreds of the rows' tiles, which are 256 m by 2 km.
        let place =
            |n| noise::bits(7, 5, n, 0).map(|bits| 10_000.0 * ((bits >> 40) as f32 / (1u32 << 24) as f32 - 0.5));
        Self { gpu, groups, kernel, places: (0..POINTS).map(place).collect() }
    }

    /// Means over all places of what is covered and of the opacity, and what the opacity is where pixels hide the lace, of foam that was
    /// born when it covered everything.
    fn of(&self, share: f32, footprint: f32) -> [f64; 3] {
        let young = share.powf((foam::LIFETIME_S / foam::YOUNG_S) as f32);
        let asked: Vec<_> = self.places.iter().map(|&at| Asked { at, share, young, footprint, unused: 0.0 }).collect();
        let [found] = self.kernel.run::<_, [f32; 4]>(&self.gpu, &self.groups.each_ref(), &asked);
        [0, 1, 2].map(|part| found.iter().map(|found| f64::from(found[part])).sum::<f64>() / found.len() as f64)
    }
}

#[test]
fn lace_covers_its_share_whatever_pixels_are_wide() {
    for whitecaps in [BREEZE, STORM] {
        let lace = Lace::new(whitecaps);
        for footprint in (0..=22).map(|n| 0.005 * 2f32.powf(n as f32 * 0.75)) {
            let found = SHARES.map(|share| (share, lace.of(share, footprint)));
            println!(
                "{whitecaps}, {footprint:.3} m: {:.3?}",
                found.map(|(share, [covered, ..])| covered / f64::from(share))
            );
            println!("    opacity {:.3?}", found.map(|(_, [_, white, mean])| white / mean));
            for (share, [covered, white, mean]) in found {
                // Levels have 254 steps, and what pixels leave of them has somewhat shorter tails than a normal number: found are 3 %
                // at a share of 3 %, 6 % at one of 1 %, and 1 % from 10 % on.
                let allowed = if share < 0.02 { 0.065 } else { 0.035 };
                let share = f64::from(share);
                assert!((covered / share - 1.0).abs() < allowed, "{whitecaps}, {footprint} m: {covered} of {share}");
                assert!(
                    (white / mean - 1.0).abs() < allowed,
                    "{whitecaps}, {footprint} m: {white} for {mean} at {share}"
                );
            }
        }
    }
}

#[test]
fn whitecaps_reflect_what_is_measured_over_their_lives() {
    let lace = Lace::new(BREEZE);
    // Foam that decays exponentially covers as much at any share as at any other.
    const AGES: usize = 50;
    let shares = (0..AGES).map(|k| (k as f32 + 0.5) / AGES as f32);
    let mean = shares.map(|share| 0.55 * lace.of(share, 1e4)[2] / f64::from(share)).sum::<f64>() / AGES as f64;
    println!("{mean:.3}");
    // P. Koepke 1984: 0.22 with 0.11 either way.
    assert!((0.11..0.33).contains(&mean), "{mean}");
}
