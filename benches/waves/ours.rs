//! Our passes, ready to run: the wave transform of a white patch and the far sea's noise; verified before they are timed.

use ocean_globe::gpu::Gpu;
use ocean_globe::model::surface::{self, Fields};
use ocean_globe::model::waves::{self, Cascade};
use ocean_globe::model::{dispersion, noise};
use ocean_globe::pass::fft::{Fft, Precision, WaveData};

use crate::cpu::CpuSea;
use crate::measure::{assert_close, submit};

/// Seconds of the instant that is verified; a whole number of ticks.
const INSTANT_S: f64 = 1234.5;

/// A patch of white noise: amplitudes, frequencies.
pub fn white(n: usize) -> (Cascade, Vec<[f64; 2]>, Vec<f64>) {
    let cascade = Cascade { n, patch_m: 300.0, k_min: 0.0, k_max: f64::INFINITY };
    let amplitude = |index: usize| {
        let (i, j) = (index % n, index / n);
        let unpaired = index == 0 || i == n / 2 || j == n / 2;
        let pair = noise::gaussian_pair(5, 0, i as i32, j as i32);
        if unpaired { [0.0; 2] } else { pair.map(|x| 0.25 * x / n as f64) }
    };
    let h0 = (0..n * n).map(amplitude).collect();
    let omegas = cascade.wave_vectors().map(|(x, y)| dispersion::omega_deep(x.hypot(y))).collect();
    (cascade, h0, omegas)
}

/// The pass with the same white noise in each of some patches.
pub fn fft(gpu: &Gpu, n: usize, layers: usize, precision: Precision) -> Fft {
    let (cascade, h0, omegas) = white(n);
    let mut data = WaveData::default();
    (0..layers).for_each(|_| data.push(&cascade, &h0, &omegas));
    let mut fft = Fft::new(gpu, n, layers, precision);
    fft.set_waves(gpu, &vec![cascade; layers], &data);
    fft.set_time(gpu, waves::ticks_from_unix(INSTANT_S));
    fft
}

fn model(n: usize) -> Fields {
    let (cascade, h0, omegas) = white(n);
    surface::fields_at(&h0, &cascade, f64::INFINITY, &omegas, INSTANT_S)
}

/// The transform of `n` samples in 32-bit floats against the model, to 1e-5 of the RMS as in the tests.
pub fn verify_gpu(gpu: &Gpu, n: usize) {
    let fft = fft(gpu, n, 1, Precision::Single);
    submit(gpu, &|pass| fft.dispatch(pass));
    let want = model(n);
    let wanted = [
        (&fft.displacements, vec![&want.dx, &want.dy, &want.eta]),
        (&fft.slopes, vec![&want.eta_x, &want.eta_y]),
        (&fft.stretches, vec![&want.dx_x, &want.dy_y, &want.dx_y]),
    ];
    for (texture, fields) in wanted {
        let bytes = gpu.read_texture(texture, 0, 0).expect("the device answers");
        let values = bytemuck::pod_collect_to_vec::<u8, f32>(&bytes);
        for (channel, want) in fields.into_iter().enumerate() {
            let got: Vec<f64> = values.iter().skip(channel).step_by(4).map(|&x| f64::from(x)).collect();
            assert_close("our transform", &got, want, 1e-5);
        }
    }
}

/// The CPU's heights and slopes against the model, to the same tolerance; the noise must be there and have the slopes of its heights.
pub fn verify_cpu(n: usize) {
    let (cascade, h0, omegas) = white(n);
    let mut sea = CpuSea::new(&cascade, &h0, &omegas);
    sea.waves(waves::ticks_from_unix(INSTANT_S));
    let want = model(n);
    for (got, want) in sea.fields().iter().zip([&want.eta, &want.eta_x, &want.eta_y]) {
        assert_close("the CPU's transform", got, want, 1e-5);
    }
    sea.perlin(0.25);
    let noise = &sea.noise;
    let variance = noise.iter().map(|v| v[0] * v[0]).sum::<f32>() / noise.len() as f32;
    assert!((0.01..1.0).contains(&variance), "variance of the CPU's noise: {variance}");
    let difference = (noise[n + 2][0] - noise[n][0]) * n as f32 / 2.0;
    assert!((difference - noise[n + 1][1]).abs() < 1e-3, "slope of the CPU's noise");
}
