//! The GPU's waves against the f64 model, on the golden tile and on a whole sea.

use ocean_globe::gpu::Gpu;
use ocean_globe::model::waves::{self, Cascade, Sea};
use ocean_globe::model::{dispersion, surface};
use ocean_globe::pass::fft::{Fft, Precision, WaveData};
use ocean_globe::scene::sea::SeaTables;

/// Worst error over the field's RMS, for 32-bit targets: h0 rounds by 6e-8, each of log2 N butterflies by about as much, and
/// the polynomials of the phase by 1e-7; 1e-5 is ten times their worst sum over the largest value, some 5 RMS.
const TOLERANCE: f64 = 1e-5;

fn gpu() -> Gpu {
    pollster::block_on(Gpu::headless()).expect("a graphics device, software or not")
}

/// The pass after one frame at `ticks`, mips included.
fn dispatched(gpu: &Gpu, n: usize, cascades: &[Cascade], data: &WaveData, ticks: u64) -> Fft {
    let mut fft = Fft::new(gpu, n, cascades.len(), Precision::Single);
    fft.set_waves(gpu, cascades, data);
    fft.set_time(gpu, ticks);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        fft.dispatch(&mut pass);
        fft.dispatch_mips(&mut pass);
    }
    gpu.queue.submit([encoder.finish()]);
    fft
}

/// All channels of one layer of one mip level, texel after texel.
fn floats(gpu: &Gpu, texture: &wgpu::Texture, layer: u32, mip: u32) -> Vec<f32> {
    let bytes = gpu.read_texture(texture, layer, mip).unwrap();
    bytes.chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect()
}

/// The eight fields of every cascade: Dx, Dy, h, Dxy, hx, hy, Dxx, Dyy.
fn transformed(gpu: &Gpu, n: usize, cascades: &[Cascade], data: &WaveData, ticks: u64) -> Vec<[Vec<f64>; 8]> {
    let fft = dispatched(gpu, n, cascades, data, ticks);
    let channel = |texture, layer, channel| -> Vec<f64> {
        floats(gpu, texture, layer, 0).iter().skip(channel).step_by(4).map(|&x| f64::from(x)).collect()
    };
    (0..cascades.len() as u32)
        .map(|layer| {
            std::array::from_fn(|field| {
                let texture = if field < 4 { &fft.displacements } else { &fft.gradients };
                channel(texture, layer, field % 4)
            })
        })
        .collect()
}

/// A grid whose first index is x, as the oracle keeps them, brought to ours: element (i, j) at j·N + i.
fn transposed<T: Copy>(grid: &[T], n: usize) -> Vec<T> {
    (0..n * n).map(|index| grid[index % n * n + index / n]).collect()
}

fn worst_over_rms(got: &[f64], want: &[f64]) -> f64 {
    assert_eq!(got.len(), want.len());
    let rms = (want.iter().map(|x| x * x).sum::<f64>() / want.len() as f64).sqrt();
    assert!(rms > 0.0);
    got.iter().zip(want).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / rms
}

#[test]
fn the_golden_tile_comes_out_as_the_direct_sums_say() {
    let oracle: serde_json::Value = serde_json::from_str(include_str!("oracles/fft.json")).unwrap();
    let tile = &oracle["golden_tile"];
    let n = tile["N"].as_u64().unwrap() as usize;
    let list = |v: &serde_json::Value| -> Vec<f64> {
        let grid: Vec<f64> = v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        transposed(&grid, n)
    };
    let cascade = Cascade { n, patch_m: tile["L"].as_f64().unwrap(), k_min: 0.0, k_max: f64::INFINITY };
    let h0: Vec<[f64; 2]> = list(&tile["h0_re"]).into_iter().zip(list(&tile["h0_im"])).map(|(a, b)| [a, b]).collect();
    let omegas: Vec<f64> = cascade.wave_vectors().map(|(x, y)| dispersion::omega_deep(x.hypot(y))).collect();
    let mut data = WaveData::default();
    data.push(&h0, &omegas);
    let ticks = waves::ticks_from_unix(tile["t"].as_f64().unwrap());
    let got = &transformed(&gpu(), n, &[cascade], &data, ticks)[0];
    for (field, name) in ["Dx", "Dz", "eta", "Dx_z", "eta_x", "eta_z", "Dx_x", "Dz_z"].into_iter().enumerate() {
        let want = list(&tile["fields"][name]);
        let error = worst_over_rms(&got[field], &want);
        println!("{name}: {error:.2e}");
        assert!(error < TOLERANCE, "{name}: {error:e}");
    }
}

#[test]
fn a_whole_sea_agrees_with_the_model_decades_from_now() {
    let tables = SeaTables::new(Sea::from_wind(13.9, 7, 1.0), 256);
    // 2060-01-01: the phase must not have lost a digit since 1970.
    let ticks = waves::ticks_from_unix(2_840_140_800.123);
    let data = WaveData::of(&tables);
    let got = transformed(&gpu(), 256, &tables.cascades, &data, ticks);
    for (index, cascade) in tables.cascades.iter().enumerate() {
        let h0 = waves::initial_amplitudes(&tables.sea, index, cascade);
        let want = surface::fields(&h0, cascade, ticks);
        let pairs = [&want.dx, &want.dy, &want.eta, &want.dx_y, &want.eta_x, &want.eta_y, &want.dx_x, &want.dy_y];
        for (field, want) in pairs.into_iter().enumerate() {
            let error = worst_over_rms(&got[index][field], want);
            println!("cascade {index} field {field}: {error:.2e}");
            assert!(error < TOLERANCE, "cascade {index} field {field}: {error:e}");
        }
    }
}

#[test]
fn moments_are_products_of_the_gradients_and_mips_are_plain_means() {
    let gpu = gpu();
    let n = 64;
    let tables = SeaTables::new(Sea::from_wind(10.0, 3, 1.0), n);
    let fft = dispatched(&gpu, n, &tables.cascades, &WaveData::of(&tables), 1 << 40);
    for layer in 0..tables.cascades.len() as u32 {
        let gradients = floats(&gpu, &fft.gradients, layer, 0);
        let moments = floats(&gpu, &fft.moments, layer, 0);
        let displacements = floats(&gpu, &fft.displacements, layer, 0);
        for ((g, m), d) in gradients.chunks(4).zip(moments.chunks(4)).zip(displacements.chunks(4)) {
            let want = [g[0] * g[0], g[1] * g[1], g[0] * g[1], d[3]];
            // One rounding of a product: 2^-22 of the value.
            let close = |(a, b): (&f32, &f32)| (a - b).abs() <= b.abs() * 2f32.powi(-22);
            assert!(m.iter().zip(&want).all(close), "{m:?} {want:?}");
        }
    }
    for texture in [&fft.displacements, &fft.gradients, &fft.moments] {
        assert_eq!(texture.mip_level_count(), n.ilog2() - 1);
        let first = floats(&gpu, texture, 1, 0);
        let rms = (first.iter().map(|x| f64::from(x * x)).sum::<f64>() / first.len() as f64).sqrt();
        for mip in 1..texture.mip_level_count() {
            let side = n >> mip;
            let block = 1 << mip;
            let got = floats(&gpu, texture, 1, mip);
            for (index, &value) in got.iter().enumerate() {
                let (x, y, channel) = (index / 4 % side, index / 4 / side, index % 4);
                let at = |s: usize| 4 * ((y * block + s / block) * n + x * block + s % block) + channel;
                let mean = (0..block * block).map(|s| f64::from(first[at(s)])).sum::<f64>() / (block * block) as f64;
                // Three roundings per level of values of at most some 8 RMS.
                let error = (f64::from(value) - mean).abs() / rms;
                assert!(error < 3.0 * 8.0 * 6e-8 * f64::from(mip), "mip {mip} texel {x},{y}: {error:e}");
            }
        }
    }
}
