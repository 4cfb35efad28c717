//! Many seas on the GPU: their mean variance is the spectrum's.

use ocean_globe::gpu::Gpu;
use ocean_globe::model::waves::{self, Sea, cascades, cell_energies};
use ocean_globe::pass::fft::{Fft, Precision, WaveData};

const SEEDS: u32 = 400;
const N: usize = 128;

#[test]
fn four_hundred_seas_have_the_height_of_the_spectrum() {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let sea = Sea::from_wind(13.9, 0, 1.0);
    let (patches, spectrum) = (cascades(N), sea.spectrum());
    let energies: Vec<Vec<f64>> = patches.iter().map(|patch| cell_energies(&spectrum, patch)).collect();
    let omegas: Vec<Vec<f64>> = patches.iter().map(|patch| waves::angular_frequencies(patch, f64::INFINITY)).collect();
    let mut fft = Fft::new(&gpu, N, patches.len(), Precision::Single);
    let mut sums = vec![[0.0; 2]; patches.len() + 1];
    let start = std::time::Instant::now();
    for seed in 0..SEEDS {
        let mut data = WaveData::default();
        for (index, patch) in patches.iter().enumerate() {
            data.push(patch, &waves::amplitudes(&energies[index], seed, index, patch), &omegas[index]);
        }
        fft.set_waves(&gpu, &patches, &data);
        fft.set_time(&gpu, waves::ticks_from_unix(1.7e9 + 1e5 * f64::from(seed)));
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        fft.dispatch(&mut encoder.begin_compute_pass(&Default::default()));
        gpu.queue.submit([encoder.finish()]);
        let variance = |layer: usize| {
            let bytes = gpu.read_texture(&fft.displacements, layer as u32, 0).unwrap();
            let height = |texel: &[u8]| f64::from(f32::from_le_bytes(texel[8..12].try_into().unwrap()));
            bytes.chunks_exact(16).map(|texel| height(texel).powi(2)).sum::<f64>() / (N * N) as f64
        };
        let mut found: Vec<f64> = (0..patches.len()).map(variance).collect();
        found.push(found.iter().sum());
        for (sum, variance) in sums.iter_mut().zip(found) {
            *sum = [sum[0] + variance, sum[1] + variance * variance];
        }
    }
    println!("{:.1} s", start.elapsed().as_secs_f64());
    let mut want: Vec<f64> = energies.iter().map(|e| e.iter().sum()).collect();
    want.push(sea.hs_m * sea.hs_m / 16.0);
    for (index, (sum, want)) in sums.into_iter().zip(want).enumerate() {
        let [mean, square] = sum.map(|x| x / f64::from(SEEDS));
        let sigma = ((square - mean * mean) / f64::from(SEEDS)).sqrt();
        println!("{index}: {mean:.5} of {want:.5} ± {sigma:.5}");
        // The ensemble's own error, and for the whole sea the 1 % that its grids may miss of the spectrum.
        let grids = if index == patches.len() { 0.01 } else { 0.0 };
        assert!((mean - want).abs() < 3.0 * sigma + grids * want, "{index}: {mean} of {want} ± {sigma}");
        assert!(sigma < 0.02 * want, "sharp enough to tell any factor from one");
    }
}
