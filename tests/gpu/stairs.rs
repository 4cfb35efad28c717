//! Ridges within a pixel: what stairs tell of the edge that they come of.

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::{Gpu, shader};

use crate::kernel::Kernel;

/// Something at hand below the line through `y` at column 0, so many pixels lower a column.
const KERNEL: &str = "#import stairs
struct Asked { pixel: vec2i, y: f32, slope: f32 }
@group(0) @binding(0) var<storage, read> asked: array<Asked>;
@group(0) @binding(1) var<storage, read_write> found: array<f32>;
var<private> line: vec2f;
fn is_ground(at: vec2i) -> bool { return f32(at.y) + 0.5 > line.x + line.y * (f32(at.x) + 0.5); }
fn depth_at(at: vec2i) -> f32 { return select(0.0, 1e-4, is_ground(at)); }
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let own = asked[id.x];
    line = vec2f(own.y, own.slope);
    let other = beside(own.pixel);
    found[id.x] = mix(f32(is_ground(own.pixel)), f32(is_ground(own.pixel + other.out)), other.share);
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    pixel: [i32; 2],
    y: f32,
    slope: f32,
}

/// Share of a pixel below a line.
fn covered(Asked { pixel, y, slope }: Asked) -> f64 {
    const PARTS: i32 = 32;
    let part = |at: i32, i: i32| f64::from(at) + (f64::from(i) + 0.5) / f64::from(PARTS);
    let is_below = |i: i32| part(pixel[1], i / PARTS) > f64::from(y) + f64::from(slope) * part(pixel[0], i % PARTS);
    f64::from((0..PARTS * PARTS).filter(|i| is_below(*i)).count() as u32) / f64::from(PARTS * PARTS)
}

#[test]
fn a_straight_ridge_covers_of_each_pixel_what_it_does() {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "ask", &[]);
    for slope in [0.06, 0.11, 0.23, -0.31, 0.45, -0.85, 1.4, -5.0] {
        let asked: Vec<_> = (0..40)
            .flat_map(|x| (-220..80).map(move |y| Asked { pixel: [x, y], y: 1.37, slope }))
            .filter(|asked| (0.02..0.98).contains(&covered(*asked)))
            .collect();
        let [found] = kernel.run::<_, f32>(&gpu, &[], &asked);
        let (mut smooth, mut stairs) = (0.0, 0.0);
        for (asked, found) in asked.iter().zip(&found) {
            let wanted = covered(*asked);
            smooth += (f64::from(*found) - wanted).powi(2);
            stairs += (wanted.round() - wanted).powi(2);
        }
        let [smooth, stairs] = [smooth, stairs].map(|sum| (sum / asked.len() as f64).sqrt());
        println!("slope {slope}: {} pixels, {smooth:.3} off, as stairs {stairs:.3}", asked.len());
        // Stairs are off by up to a half, evenly: a root mean square of .29. The edge is taken to go through the middles of its steps, which are up to
        // half a pixel along it from where it goes: up to half of the slope, or of its inverse, and evenly, .29 of that.
        let flat = f64::from(slope.abs().min(1.0 / slope.abs()));
        assert!(asked.len() > 30 && smooth < (0.29 * flat).max(0.05) && smooth < stairs, "{slope}: {smooth}");
    }
}
