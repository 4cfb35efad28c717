//! Gusts and lulls roughen and smooth the sea, and leave it as rough as it is on the whole.

use bytemuck::{Pod, Zeroable};
use ocean_globe::gpu::{Gpu, shader};
use ocean_globe::model::noise;
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::settings::{Settings, Wind};
use ocean_globe::scene::view::camera::Camera;

use crate::kernel::{self, Kernel};

const KERNEL: &str = "#import gusts
struct Asked { at: vec2u, sin_lat: f32, footprint: f32, height: f32 }
@group(2) @binding(0) var<storage, read> asked: array<Asked>;
@group(2) @binding(1) var<storage, read_write> found: array<vec2f>;
@compute @workgroup_size(64)
fn ask(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= arrayLength(&asked) { return; }
    let own = asked[id.x];
    let point = MapPoint(MERCATOR, own.at);
    found[id.x] = vec2f(gusts(point, own.sin_lat, own.footprint), ripples_at(point, own.sin_lat, own.height, own.footprint));
}";

#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
struct Asked {
    at: [u32; 2],
    sin_lat: f32,
    footprint: f32,
    /// Over the long waves' significant height.
    height: f32,
    _unused: f32,
}

impl Asked {
    fn new(at: [u32; 2], sin_lat: f32, footprint: f32, height: f32) -> Self {
        Self { at, sin_lat, footprint, height, _unused: 0.0 }
    }
}

/// Factors of the hidden slopes' variance and of ripples' slopes for an eye at a longitude, in a wind from 250 degrees.
fn both(lon: f64, asked: &[Asked]) -> Vec<[f64; 2]> {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let settings = Settings { wind: Wind { speed_mps: 7.0, from_deg: 250.0 }, ..Settings::default() };
    let frame = Frame::new(&settings, &Camera::from_degrees(10.0, lon, 10.0, 0.0, 0.0), 1.7e9, [64; 2]);
    let layouts = [kernel::frame_layout(&gpu), gpu.layout("unused", wgpu::ShaderStages::COMPUTE, &[])];
    let uniform = gpu.buffer("frame", wgpu::BufferUsages::UNIFORM, bytemuck::bytes_of(&frame.uniform));
    let groups =
        [kernel::frame_group(&gpu, &layouts[0], &uniform, &frame.wave_cells), gpu.bind("unused", &layouts[1], &[])];
    let kernel = Kernel::<1>::new(&gpu, &shader::composed(KERNEL, ""), "ask", &layouts.each_ref());
    let [found] = kernel.run::<_, [f32; 2]>(&gpu, &groups.each_ref(), asked);
    found.into_iter().map(|factors| factors.map(f64::from)).collect()
}

/// Those of the hidden slopes alone.
fn gusts(lon: f64, asked: &[Asked]) -> Vec<f64> {
    both(lon, asked).into_iter().map(|[hidden, _]| hidden).collect()
}

#[test]
fn gusts_leave_the_mean_roughness() {
    const POINTS: i32 = 60_000;
    for (footprint, levels) in [(5.0, 4.0), (30.0, 3.0), (130.0, 2.0), (2_000.0f32, 0.0)] {
        let places = (0..POINTS).map(|n| noise::bits(3, 1, n, 0)[0]);
        let asked: Vec<_> =
            places.map(|bits| Asked::new([bits as u32, (bits >> 32) as u32], 0.2, footprint, 0.0)).collect();
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
fn ripples_are_as_steep_as_they_are_on_the_whole_and_steepest_on_crests() {
    const POINTS: i32 = 60_000;
    let asked: Vec<_> = (0..POINTS)
        .map(|n| {
            let [place, height] = [3, 4].map(|seed| noise::bits(seed, 1, n, 0)[0]);
            let [a, b] = [height as u32, (height >> 32) as u32].map(|word| (f64::from(word) + 0.5) / 4_294_967_296.0);
            // Normal (Box and Muller 1958): of waves as the sum of many they are, a quarter of the significant height is a deviation.
            let height = 0.25 * (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos();
            Asked::new([place as u32, (place >> 32) as u32], 0.2, 0.05, height as f32)
        })
        .collect();
    let found: Vec<f64> = both(-30.0, &asked).into_iter().map(|[_, ripples]| ripples * ripples).collect();
    let mean = |chosen: &dyn Fn(f32) -> bool| {
        let of: Vec<f64> =
            asked.iter().zip(&found).filter(|(asked, _)| chosen(asked.height)).map(|(_, s)| *s).collect();
        of.iter().sum::<f64>() / of.len() as f64
    };
    let [all, troughs, crests] = [mean(&|_| true), mean(&|height| height < -0.25), mean(&|height| height > 0.25)];
    println!("mean square {all:.4}, in troughs {troughs:.3}, on crests {crests:.3}");
    // Three deviations of the mean of 60,000 squares that have one of 0.48.
    assert!((all - 1.0).abs() < 0.006, "{all}");
    // Slopes are as peaked as Cox and Munk (1954) found them: their fourth moment is 3.23 to 3.4 times the square of the second, of ripples that hold
    // three fifths of the variance 3 (1 + 0.36 (peaked - 1)).
    let peaked = found.iter().map(|square| square * square).sum::<f64>() / found.len() as f64;
    println!("peaked {peaked:.3}");
    assert!((3.15..3.45).contains(&(3.0 * (1.0 + 0.36 * (peaked - 1.0)))), "{peaked}");
    // A height beyond a deviation is 1.525 of them in the mean: 1 ± 0.5 √0.4 1.525, less what lies beyond 1.8.
    assert!((troughs / 0.54 - 1.0).abs() < 0.1 && (crests / 1.46 - 1.0).abs() < 0.05, "{troughs} {crests}");
}

#[test]
fn gusts_lie_where_they_are_whatever_eye_sees_them() {
    // Nine points 30 m apart, 20 km from one eye and 2 km from the other.
    let asked = |lon: f64| {
        let at = (f64::from(1u32 << 31) * (1.0 + lon / 180.0)) as u32;
        (0..9u32).map(|n| Asked::new([at + n * 3_200, 2_000_000_000 + n * 700], 0.1, 5.0, 0.0)).collect()
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
