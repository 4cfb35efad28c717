//! The GPU's waves against the f64 model, on the golden patch and on a whole sea.

use ocean_globe::gpu::Gpu;
use ocean_globe::gpu::context::device_descriptor;
use ocean_globe::model::sea::SpectrumKind;
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::surface::{self, Fields};
use ocean_globe::model::waves::{self, Cascade, Sea};
use ocean_globe::model::{dispersion, noise};
use ocean_globe::pass::fft::{self, Fft, Precision, WaveData};

/// Worst error over the field's RMS, for 32-bit targets: h0 rounds by 6e-8, each of log2 N butterflies by about as much, and
/// the polynomials of the phase by 1e-7; 1e-5 is ten times their worst sum over the largest value, some 5 RMS.
const TOLERANCE: f64 = 1e-5;

fn gpu() -> Gpu {
    pollster::block_on(Gpu::headless()).expect("a graphics device, software or not")
}

/// The pass after one frame at `ticks`, mips included.
fn dispatched(gpu: &Gpu, cascades: &[Cascade], data: &WaveData, ticks: u64, precision: Precision) -> Fft {
    let mut fft = Fft::new(gpu, cascades[0].n, cascades.len(), precision);
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

/// A finite 16-bit float.
fn half(bits: u16) -> f32 {
    let (exponent, mantissa) = (i32::from(bits >> 10 & 31), f32::from(bits & 1023));
    assert!(exponent < 31, "not finite: {bits:x}");
    let size = if exponent == 0 { mantissa * 2f32.powi(-24) } else { (mantissa + 1024.0) * 2f32.powi(exponent - 25) };
    if bits >> 15 == 0 { size } else { -size }
}

/// The 16-bit float next to a number.
fn nearest_half(x: f64) -> f64 {
    let step = x.abs().log2().floor().max(-14.0) - 10.0;
    (x * (-step).exp2()).round() * step.exp2()
}

/// All channels of one layer of one mip level, texel after texel.
fn floats(gpu: &Gpu, texture: &wgpu::Texture, layer: u32, mip: u32) -> Vec<f32> {
    let bytes = gpu.read_texture(texture, layer, mip).unwrap();
    if texture.format() == Precision::Half.format().0 {
        return bytes.chunks_exact(2).map(|b| half(u16::from_le_bytes(b.try_into().unwrap()))).collect();
    }
    bytes.chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap())).collect()
}

/// The eight fields of one cascade: Dx, Dy, h, Dxy, hx, hy, Dxx, Dyy.
fn fields_of(gpu: &Gpu, fft: &Fft, layer: u32) -> [Vec<f64>; 8] {
    let all = [&fft.displacements, &fft.slopes, &fft.stretches].map(|texture| floats(gpu, texture, layer, 0));
    let places = [(0, 0), (0, 1), (0, 2), (2, 2), (1, 0), (1, 1), (2, 0), (2, 1)];
    places.map(|(texture, channel)| all[texture].iter().skip(channel).step_by(4).map(|&x| f64::from(x)).collect())
}

/// The eight fields of every cascade, from 32-bit targets.
fn transformed(gpu: &Gpu, cascades: &[Cascade], data: &WaveData, ticks: u64) -> Vec<[Vec<f64>; 8]> {
    let fft = dispatched(gpu, cascades, data, ticks, Precision::Single);
    (0..cascades.len() as u32).map(|layer| fields_of(gpu, &fft, layer)).collect()
}

/// The model's fields in the same order.
fn in_order(f: &Fields) -> [&Vec<f64>; 8] {
    [&f.dx, &f.dy, &f.eta, &f.dx_y, &f.eta_x, &f.eta_y, &f.dx_x, &f.dy_y]
}

/// A patch with all its waves at the same height, in the mean, of some `deviation_m` together: their amplitudes and frequencies, rad/s.
/// White noise shows errors of a transform that a sea's few long waves would hide.
fn white_noise(n: usize, patch_m: f64, deviation_m: f64) -> (Cascade, WaveData, Vec<[f64; 2]>, Vec<f64>) {
    let cascade = Cascade { n, patch_m, k_min: 0.0, k_max: f64::INFINITY };
    let h0: Vec<[f64; 2]> = (0..n * n)
        .map(|index| {
            let (i, j) = (index % n, index / n);
            if index == 0 || i == n / 2 || j == n / 2 {
                return [0.0; 2];
            }
            noise::gaussian_pair(5, 0, i as i32, j as i32).map(|x| 0.5 * deviation_m * x / n as f64)
        })
        .collect();
    let omegas: Vec<f64> = cascade.wave_vectors().map(|(x, y)| dispersion::omega_deep(x.hypot(y))).collect();
    let mut data = WaveData::default();
    data.push(&cascade, &h0, &omegas);
    (cascade, data, h0, omegas)
}

/// [`white_noise`], and what the model makes of it at [`LATER_S`].
fn white(n: usize, patch_m: f64, deviation_m: f64) -> (Cascade, WaveData, Fields) {
    let (cascade, data, h0, omegas) = white_noise(n, patch_m, deviation_m);
    let fields = surface::fields_at(&h0, &cascade, f64::INFINITY, &omegas, LATER_S);
    (cascade, data, fields)
}

/// Seconds since the clock's start; a whole number of ticks.
const LATER_S: f64 = 1234.5;

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
fn the_golden_patch_comes_out_as_the_direct_sums_say() {
    let oracle: serde_json::Value = serde_json::from_str(include_str!("../oracles/fft.json")).unwrap();
    let patch = &oracle["golden_tile"];
    let n = patch["N"].as_u64().unwrap() as usize;
    let list = |v: &serde_json::Value| -> Vec<f64> {
        let grid: Vec<f64> = v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        transposed(&grid, n)
    };
    let cascade = Cascade { n, patch_m: patch["L"].as_f64().unwrap(), k_min: 0.0, k_max: f64::INFINITY };
    let h0: Vec<[f64; 2]> = list(&patch["h0_re"]).into_iter().zip(list(&patch["h0_im"])).map(|(a, b)| [a, b]).collect();
    let omegas: Vec<f64> = cascade.wave_vectors().map(|(x, y)| dispersion::omega_deep(x.hypot(y))).collect();
    let mut data = WaveData::default();
    data.push(&cascade, &h0, &omegas);
    let ticks = waves::ticks_from_unix(patch["t"].as_f64().unwrap());
    let got = &transformed(&gpu(), &[cascade], &data, ticks)[0];
    for (field, name) in ["Dx", "Dz", "eta", "Dx_z", "eta_x", "eta_z", "Dx_x", "Dz_z"].into_iter().enumerate() {
        let want = list(&patch["fields"][name]);
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
    let got = transformed(&gpu(), &tables.cascades, &data, ticks);
    for (index, cascade) in tables.cascades.iter().enumerate() {
        let h0 = waves::initial_amplitudes(&tables.sea, index, cascade);
        let want = surface::fields(&h0, cascade, ticks);
        for (field, want) in in_order(&want).into_iter().enumerate() {
            let error = worst_over_rms(&got[index][field], want);
            println!("cascade {index} field {field}: {error:.2e}");
            assert!(error < TOLERANCE, "cascade {index} field {field}: {error:e}");
        }
    }
}

#[test]
fn squares_are_of_the_slopes_and_mips_are_plain_means() {
    let gpu = gpu();
    let n = 128;
    let tables = SeaTables::new(Sea::from_wind(10.0, 3, 1.0), n);
    let fft = dispatched(&gpu, &tables.cascades, &WaveData::of(&tables), 1 << 40, Precision::Single);
    for layer in 0..tables.cascades.len() as u32 {
        let slopes = floats(&gpu, &fft.slopes, layer, 0);
        for s in slopes.chunks(4) {
            let (found, want) = ([s[2], s[3]], [s[0] * s[0], s[1] * s[1]]);
            // One rounding of a product: 2^-22 of the value.
            let close = |(a, b): (&f32, &f32)| (a - b).abs() <= b.abs() * 2f32.powi(-22);
            assert!(found.iter().zip(&want).all(close), "{found:?} {want:?}");
        }
    }
    // Five levels of three textures: four at a time, then one.
    assert_eq!(fft.mip_dispatches(), 6);
    for texture in [&fft.displacements, &fft.slopes, &fft.stretches] {
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
                // Three additions per level, each rounding values of at most some 8 RMS.
                let error = (f64::from(value) - mean).abs() / rms;
                assert!(error < 3.0 * 8.0 * 6e-8 * f64::from(mip), "mip {mip} texel {x},{y}: {error:e}");
            }
        }
    }
}

fn check_white(sizes: &[usize]) {
    let gpu = gpu();
    for &n in sizes {
        let (cascade, data, want) = white(n, 300.0, 0.5);
        let got = &transformed(&gpu, &[cascade], &data, waves::ticks_from_unix(LATER_S))[0];
        let error = |field: usize| worst_over_rms(&got[field], in_order(&want)[field]);
        let errors: Vec<f64> = (0..8).map(error).collect();
        println!("{n}: {}", errors.iter().map(|e| format!("{e:.1e} ")).collect::<String>());
        assert!(errors.iter().all(|&error| error < TOLERANCE), "{n}: {errors:?}");
    }
}

#[test]
fn white_noise_of_every_size_in_one_workgroup_agrees_with_the_model() {
    check_white(&[16, 32, 64, 128, 256, 512, 1024]);
}

#[test]
fn white_noise_of_the_largest_size_agrees_with_the_model() {
    check_white(&[2048]);
}

#[test]
fn sixteen_bits_cost_less_than_their_last_place() {
    // Beyond a target that rounds to the nearest: a rounding to 11 bits errs by at most 2^-11 of the value where it takes the
    // nearest and 2^-10 where it cuts off, which is as good by WGSL; spread evenly, and with mantissas as they come, that is
    // 0.42 or 0.84 · 2^-11 of the RMS. The transform keeps the energy of the error halfway, so all is well below 2^-11 if
    // one of the two conversions rounds. What is no rounding comes on top, such as a field lost beside a greater one in the same
    // complex number: at 2.5 m of patch dDx/dy has some 200 times the height's size.
    let gpu = gpu();
    for (n, patch_m, deviation_m) in [(64, 5000.0, 3.0), (256, 2.5, 0.01), (1024, 300.0, 0.5)] {
        let (cascade, data, want) = white(n, patch_m, deviation_m);
        let fft = dispatched(&gpu, &[cascade], &data, waves::ticks_from_unix(LATER_S), Precision::Half);
        let got = fields_of(&gpu, &fft, 0);
        let power = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>();
        let excess = |(got, want): (&Vec<f64>, &Vec<f64>)| {
            let difference: Vec<f64> = got.iter().zip(want).map(|(a, b)| a - b).collect();
            let rounding: Vec<f64> = want.iter().map(|&x| nearest_half(x) - x).collect();
            ((power(&difference) - power(&rounding)) / power(want)).sqrt() * 2048.0
        };
        let errors: Vec<f64> = got.iter().zip(in_order(&want)).map(excess).collect();
        println!("{n}: {errors:.3?} of 2^-11");
        assert!(errors.iter().all(|&error| error < 1.0), "{n}: {errors:?} of 2^-11");
    }
}

#[test]
fn the_stretches_alone_have_the_bits_that_they_have_among_all_fields() {
    let gpu = gpu();
    // Every way of changing places between threads, and every first stage.
    for (n, precision) in [
        (32, Precision::Single),
        (128, Precision::Half),
        (256, Precision::Half),
        (512, Precision::Half),
        (1024, Precision::Half),
        (2048, Precision::Single),
    ] {
        let (cascade, data, ..) = white_noise(n, 300.0, 0.5);
        let now = waves::ticks_from_unix(LATER_S);
        let fft = dispatched(&gpu, &[cascade], &data, now, precision);
        let stretches = || -> Vec<Vec<f32>> {
            (0..fft.stretches.mip_level_count()).map(|mip| floats(&gpu, &fft.stretches, 0, mip)).collect()
        };
        let others = || [&fft.displacements, &fft.slopes].map(|texture| floats(&gpu, texture, 0, 0));
        let (want, left) = (stretches(), others());
        let alone = |ticks| {
            fft.set_time(&gpu, ticks);
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            fft.dispatch_stretches(&mut encoder.begin_compute_pass(&Default::default()));
            gpu.queue.submit([encoder.finish()]);
            stretches()
        };
        // Another instant between the two, so that what is read has been made anew.
        assert!(alone(now + 1_000_000) != want, "{n}: the stretches stand still");
        assert!(others() == left, "{n}: the other fields were made too");
        assert!(alone(now) == want, "{n}: {precision:?}");
    }
}

#[test]
fn patches_that_need_several_bindings_come_out_the_same() {
    let (n, seed) = (32, 3);
    let tables = SeaTables::new(Sea::from_wind(12.0, seed, 1.0), n);
    let data = WaveData::of(&tables);
    let whole = transformed(&gpu(), &tables.cascades, &data, 1 << 40);
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default())).unwrap();
    let mut descriptor = device_descriptor(&adapter);
    descriptor.required_limits.max_storage_buffer_binding_size = (n * n * 32 * 2) as u64;
    let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).unwrap();
    let small = Gpu::new(&adapter, device, queue);
    assert!(tables.cascades.len() > 2);
    assert_eq!(Fft::new(&small, n, tables.cascades.len(), Precision::Single).dispatches(), 4);
    assert_eq!(transformed(&small, &tables.cascades, &data, 1 << 40), whole);
}

#[test]
fn all_cascades_take_two_dispatches_and_the_largest_four() {
    const DEFAULT_BINDING: u64 = 128 << 20;
    let dispatches = |n, precision| 2 * fft::batches(n, 4, precision, DEFAULT_BINDING).len();
    for n in [16, 64, 256, 512, 1024] {
        assert_eq!(dispatches(n, Precision::Half), 2);
        assert_eq!(dispatches(n, Precision::Single), 2);
    }
    assert_eq!(dispatches(2048, Precision::Half), 4);
    assert_eq!(dispatches(2048, Precision::Single), 8);
}

#[test]
fn a_sea_on_a_shelf_moves_farther_to_and_fro() {
    // 15 m deep: waves of 100 m go 1.36 times as far as they rise, those of 20 m as far.
    let tables = SeaTables::new(Sea::new(13.9, SpectrumKind::Tma, None, None, 7, 1.0), 128);
    let ticks = waves::ticks_from_unix(1.7e9);
    let data = WaveData::of(&tables);
    let got = transformed(&gpu(), &tables.cascades, &data, ticks);
    let cascade = &tables.cascades[0];
    let h0 = waves::initial_amplitudes(&tables.sea, 0, cascade);
    let (depth_m, t) = (tables.sea.depth_m, waves::TICKS_PER_SECOND.recip() * ticks as f64);
    let omegas = tables.frequencies(cascade);
    // By the phases of the clock, which seconds in f64 would have to a radian's thousandth only.
    let phases: Vec<f64> =
        omegas.iter().map(|&omega| surface::phase_at(waves::cycles_per_tick(omega), ticks) / t).collect();
    let [on_shelf, deep] =
        [depth_m, f64::INFINITY].map(|depth_m| surface::fields_at(&h0, cascade, depth_m, &phases, t));
    for (field, (want, deep)) in in_order(&on_shelf).into_iter().zip(in_order(&deep)).enumerate() {
        let (error, without) = (worst_over_rms(&got[0][field], want), worst_over_rms(&got[0][field], deep));
        println!("field {field}: {error:.2e}, {without:.2e} off those of deep water's chop");
        assert!(error < TOLERANCE, "field {field}: {error:e}");
        // Heights and their slopes know nothing of it.
        let is_chop = [0, 1, 3, 6, 7].contains(&field);
        assert!(is_chop == (without > 0.1), "field {field}: {without}");
    }
    // Where the model's own D comes from: for a single wave the orbit of linear theory, cosh over sinh of kh.
    for (k, ratio) in [(std::f64::consts::TAU / 100.0, 1.35803), (std::f64::consts::TAU / 20.0, 1.00016)] {
        assert!((dispersion::orbit_ratio(k, 15.0) - ratio).abs() < 1e-4);
    }
}
