//! The glow spreads light, and neither makes nor loses any.

use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::texture::{self, Shape};
use ocean_globe::pass::bloom::Bloom;

const SIZE: [u32; 2] = [640, 480];

/// The glow, half as wide and high, of a picture whose pixels are grey.
fn glow(grey: impl Fn(u32, u32) -> f32) -> Vec<f32> {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let half = |value: f32| half::f16::from_f32(value).to_bits();
    let texels: Vec<u16> =
        (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y))).flat_map(|(x, y)| [half(grey(x, y)); 4]).collect();
    let picture = Shape::picture(SIZE[0], SIZE[1]);
    let radiance = gpu.texture("radiance", picture, wgpu::TextureFormat::Rgba16Float, wgpu::TextureUsages::COPY_DST);
    gpu.fill(&radiance, bytemuck::cast_slice(&texels));
    let bloom = Bloom::new(&gpu);
    let glow = bloom.glow(&gpu, SIZE, &texture::view(&radiance));
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    bloom.draw(&mut encoder, &glow);
    gpu.queue.submit([encoder.finish()]);
    let bytes = gpu.read_texture(glow.view.texture(), 0, 0).unwrap();
    bytes.chunks_exact(8).map(|texel| half::f16::from_bits(u16::from_le_bytes([texel[0], texel[1]])).to_f32()).collect()
}

#[test]
fn an_even_light_stays_as_it_is() {
    // Halves to 2^-11, and the filter's weights.
    let found = glow(|_, _| 0.7);
    assert!(found.iter().all(|light| (light / 0.7 - 1.0).abs() < 2e-3), "{:?}", found.iter().copied().reduce(f32::min));
}

#[test]
fn a_bright_point_glows_ever_less_and_loses_nothing() {
    let [x, y] = [321, 240];
    let found = glow(|i, j| if [i, j] == [x, y] { 60_000.0 } else { 0.0 });
    let columns = SIZE[0] / 2;
    // Each texel stands for four pixels.
    let sum = 4.0 * found.iter().map(|light| f64::from(*light)).sum::<f64>();
    println!("{:.4} of the light", sum / 60_000.0);
    // The coarsest texels are 64 pixels wide: next to none of the glow reaches the edges. Halves lose 2^-11 in each of eleven passes.
    assert!((sum / 60_000.0 - 1.0).abs() < 0.02, "{sum}");
    // Rings around it, from the middle out: each as bright as a half of the last or less.
    let ring = |from: f64, to: f64| {
        let texels = (0..).zip(&found).filter_map(|(n, light): (u32, &f32)| {
            let away =
                f64::hypot(f64::from(2 * (n % columns)) - f64::from(x), f64::from(2 * (n / columns)) - f64::from(y));
            (from..to).contains(&away).then_some(f64::from(*light))
        });
        let (sum, count) = texels.fold((0.0, 0.0), |(sum, count), light| (sum + light, count + 1.0));
        sum / count
    };
    let rings: Vec<f64> = (0..7).map(|n| ring(4.0 * 2f64.powi(n - 1), 4.0 * 2f64.powi(n))).collect();
    println!("{rings:.4?}");
    assert!(rings.windows(2).all(|pair| pair[1] < 0.5 * pair[0]) && rings[5] > 0.0, "{rings:?}");
}
