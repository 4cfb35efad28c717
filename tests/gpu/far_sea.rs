//! The far sea has the height and the slopes of the spectrum, and so has every mix of it with the waves.

use std::f64::consts::TAU;
use std::sync::Arc;

use ocean_globe::gpu::Gpu;
use ocean_globe::model::perlin::{self, OCTAVES, PEAK_CELLS, TEXELS};
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::{noise, optics};
use ocean_globe::pass::fft::Precision;
use ocean_globe::pass::perlin::Perlin;
use ocean_globe::scene::frame::{Frame, MIX_FAR_M, MIX_NEAR_M};
use ocean_globe::scene::settings::{Quality, Settings, Spectrum, Wind};

use crate::water::{Ensemble, NOON, Water, Waves, chopless, frame, mean, place, places, reseeded};

/// Gradient noise in f64 at a place in cells: at each lattice point a unit vector of a random direction.
fn unit_noise(x: f64, y: f64, sample: u32) -> f64 {
    let (i, j) = (x.floor(), y.floor());
    let fade = |t: f64| t * t * t * (10.0 + t * (6.0 * t - 15.0));
    let mut sum = 0.0;
    for (a, b) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)] {
        let (dx, dy) = (x - i - a, y - j - b);
        let [word, _] = noise::bits(sample, 77, (i + a) as i32, (j + b) as i32);
        let angle = word as f64 / u64::MAX as f64 * TAU;
        sum += (1.0 - fade(dx.abs())) * (1.0 - fade(dy.abs())) * (angle.cos() * dx + angle.sin() * dy);
    }
    sum
}

#[test]
fn the_models_variances_are_those_of_the_noise() {
    // Every sample has gradients of its own, so all are independent; their places fill a cell evenly. The noise is flatter than a
    // Gaussian, so that 200,000 squares have an error of at most sqrt(2/200,000) = 0.3 %: three of them are 1 %.
    const SAMPLES: usize = 200_000;
    const PATCH_M: f64 = 1000.0;
    let mut height = 0.0;
    let mut slopes = [[0.0; 2]; OCTAVES];
    for sample in 0..SAMPLES {
        let [x, y] = place(sample, 1.0);
        height += unit_noise(x, y, sample as u32).powi(2);
        for (octave, sums) in slopes.iter_mut().enumerate() {
            let step_m = PATCH_M / TEXELS as f64;
            let cells = [PEAK_CELLS << octave, (PEAK_CELLS << octave) / 2].map(|cells| cells as f64 / PATCH_M * step_m);
            let seed = (octave * SAMPLES + sample) as u32;
            let along = unit_noise(x + cells[0], y, seed) - unit_noise(x - cells[0], y, seed);
            let across = unit_noise(x, y + cells[1], seed) - unit_noise(x, y - cells[1], seed);
            for (sum, difference) in sums.iter_mut().zip([along, across]) {
                *sum += (difference / (2.0 * step_m)).powi(2);
            }
        }
    }
    let check = |name: &str, model: f64, sum: f64| {
        let found = sum / SAMPLES as f64;
        println!("{name}: {model:.6e} of {found:.6e}, {:+.3} %", 100.0 * (model / found - 1.0));
        assert!((model / found - 1.0).abs() < 0.01, "{name}: {model} of {found}");
    };
    check("height", perlin::variance(), height);
    for (octave, sums) in slopes.into_iter().enumerate() {
        let model = perlin::slope_variance(PATCH_M, octave);
        check("slope along", model[0], sums[0]);
        check("slope across", model[1], sums[1]);
    }
}

/// A 16-bit float.
fn half(bits: u16) -> f64 {
    let (exponent, mantissa) = (i32::from(bits >> 10 & 31), f64::from(bits & 1023));
    assert!(exponent < 31, "not finite: {bits:x}");
    let size = if exponent == 0 { mantissa * 2f64.powi(-24) } else { (mantissa + 1024.0) * 2f64.powi(exponent - 25) };
    if bits >> 15 == 0 { size } else { -size }
}

#[test]
fn the_patch_on_the_gpu_has_the_models_variances_in_every_octave() {
    let gpu = pollster::block_on(Gpu::headless()).expect("a graphics device, software or not");
    let pass = Perlin::new(&gpu);
    let settings = Settings { wind: Wind { speed_mps: 12.0, from_deg: 200.0 }, ..Settings::default() };
    let sea = frame(&settings, NOON);
    let unit = perlin::variance();
    // A patch of the first octave has 32 cells, each later one four times as many.
    for (octave, patches) in [(0, 400), (1, 120), (2, 40), (3, 16)] {
        let mut tables = SeaTables::clone(&sea.sea);
        tables.perlin.amplitudes_m = [0.0; OCTAVES];
        tables.perlin.amplitudes_m[octave] = 1.0;
        let alone = Frame { sea: Arc::new(tables), ..sea.clone() };
        let [x, y] = perlin::slope_variance(sea.sea.perlin.patch_m, octave);
        let mut sums = [Ensemble::default(); 3];
        for patch in 0..patches {
            // Each patch has a seed and an instant of its own, from seconds to decades apart.
            pass.prepare(&gpu, &reseeded(&alone, patch, NOON + 37.7 * f64::from(patch * patch * patch)));
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            pass.dispatch(&mut encoder.begin_compute_pass(&Default::default()));
            gpu.queue.submit([encoder.finish()]);
            let bytes = gpu.read_texture(&pass.texture, 0, 0).unwrap();
            let mut squares = [0.0; 3];
            for texel in bytes.chunks_exact(8) {
                let [h, sx, sy, both] =
                    std::array::from_fn(|c| half(u16::from_le_bytes([texel[2 * c], texel[2 * c + 1]])));
                // The last channel is the slopes' squares: three roundings by at most 2^-10, or 2^-24 where they are tiny.
                assert!((sx * sx + sy * sy - both).abs() < 4e-3 * both + 1e-6);
                for (sum, value) in squares.iter_mut().zip([h, sx, sy]) {
                    *sum += value * value;
                }
            }
            for (sum, square) in sums.iter_mut().zip(squares) {
                sum.push(square / (TEXELS * TEXELS) as f64);
            }
        }
        for ((name, want), found) in [("height", unit), ("along", x), ("across", y)].into_iter().zip(sums) {
            let (mean, error) = (found.mean(), found.error());
            println!("octave {octave} {name}: {:.4} ± {:.4} of the model's", mean / want, error / want);
            // The patches' own error; 16-bit values add 2^-11 of the variance at most.
            assert!(
                (mean - want).abs() < 3.5 * error + 1e-3 * want,
                "octave {octave} {name}: {mean} of {want} ± {error}"
            );
            assert!(error < 0.02 * want, "octave {octave} {name}: ± {error} of {want} tells too little");
        }
    }
}

/// Stations of the mix.
const STATIONS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

fn seas() -> [(&'static str, Settings); 3] {
    [
        ("8 m/s", chopless(8.0)),
        ("17 m/s", chopless(17.0)),
        ("Phillips 14 m/s", Settings { spectrum: Spectrum::Phillips, fetch_km: Some(200.0), ..chopless(14.0) }),
    ]
}

/// Of the water as it is drawn, between the textures' samples: variances of height, and of slope along and across with the roughness
/// that is left, over the spectrum's own, at every station.
fn along_the_mix(water: &mut Water, settings: &Settings, realisations: u32) -> [[Ensemble; 3]; 5] {
    const PLACES: usize = 768;
    const SHARED: u32 = 2;
    // Patches of 128 samples: what they do not hold is roughness, and many seas are made in the time of one of 512.
    let sea = frame(&Settings { quality: Quality::Low, ..settings.clone() }, NOON);
    let waves_of_sea = Waves::of(&sea.sea);
    let m0 = (sea.sea.sea.hs_m / 4.0).powi(2);
    let slopes = sea.sea.slopes();
    // The whole of the longest patch, and with it the noise's patch several times: every phase of a lattice cell alike.
    let side_m = sea.sea.cascades[0].patch_m;
    let stations = STATIONS.map(|r| [MIX_NEAR_M + r * (MIX_FAR_M - MIX_NEAR_M), 0.0]);
    let mut found = [[Ensemble::default(); 3]; 5];
    let mut sums = [[0.0; 3]; 5];
    for realisation in 0..realisations {
        let now = reseeded(&sea, realisation, NOON + 1e4 * f64::from(realisation * realisation));
        // The waves of a patch are worth far more samples than the noise of one; what has the same waves counts as one realisation.
        if realisation % SHARED == 0 {
            water.set_sea(&waves_of_sea, realisation, now.unix_seconds);
        }
        water.set_noise(&now);
        let places = places(&stations, PLACES * realisation as usize, PLACES, side_m);
        for (drawn, sum) in water.at(&now, &places).chunks_exact(PLACES).zip(&mut sums) {
            sum[0] += mean(drawn, |d| d.height * d.height) / m0;
            for axis in 0..2 {
                sum[1 + axis] += mean(drawn, |d| d.slope[axis] * d.slope[axis] + d.rough[axis]) / slopes[axis];
            }
        }
        if realisation % SHARED == SHARED - 1 {
            let means = std::mem::take(&mut sums).as_flattened().to_owned();
            for (ensemble, sum) in found.as_flattened_mut().iter_mut().zip(means) {
                ensemble.push(sum / f64::from(SHARED));
            }
        }
    }
    found
}

#[test]
fn the_variance_is_the_same_along_the_mix() {
    let mut water = Water::new(128, Precision::Half, |source| source);
    for (name, settings) in seas() {
        let start = std::time::Instant::now();
        let found = along_the_mix(&mut water, &settings, 160);
        println!("{name}: {:.1} s", start.elapsed().as_secs_f64());
        for (r, station) in STATIONS.into_iter().zip(&found) {
            for (what, ensemble) in ["height", "slope along", "slope across"].into_iter().zip(station) {
                let (mean, samples) = (ensemble.mean(), ensemble.independent_samples());
                println!("  r {r}: {what} {mean:.4}, {samples:.0} independent samples");
                // Three errors of the variance of 20,000 samples, sqrt(2/20,000) each, are the 3 % asked for.
                assert!(samples >= 20_000.0, "{name} r {r} {what}: {samples:.0} samples");
                assert!((mean - 1.0).abs() < 0.03, "{name} r {r} {what}: {mean} of the spectrum's");
            }
        }
    }
}

#[test]
fn hermite_weights_in_place_of_amplitudes_lose_half_the_variance_midway() {
    let right = "return vec2f(sqrt(1.0 - perlin_energy), sqrt(perlin_energy));";
    let wrong = "return vec2f(1.0 - perlin_energy, perlin_energy);";
    let mut water = Water::new(128, Precision::Half, |source| {
        assert!(source.contains(right));
        source.replace(right, wrong)
    });
    let found = along_the_mix(&mut water, &seas()[1].1, 48);
    for ensemble in found[2] {
        // Half, known to 4 standard errors; far from the 3 % that the right weights keep.
        println!("{:.3} ± {:.3}", ensemble.mean(), ensemble.error());
        assert!((ensemble.mean() - 0.5).abs() < 4.0 * ensemble.error() + 0.005);
        assert!(ensemble.mean() < 0.8);
    }
}

#[test]
fn slopes_are_those_that_were_measured_and_the_far_sea_has_them_all() {
    for tenths in (50..=150).step_by(5) {
        let speed = f64::from(tenths) / 10.0;
        for spectrum in [Spectrum::Phillips, Spectrum::Jonswap, Spectrum::PiersonMoskowitz] {
            let settings = Settings { wind: Wind { speed_mps: speed, from_deg: 0.0 }, spectrum, ..Settings::default() };
            let tables = SeaTables::of(&settings);
            let (found, measured) = (tables.mean_square_slope(), optics::cox_munk_mss(speed).total);
            println!(
                "{spectrum:?} {speed} m/s: {found:.5} of {measured:.5}, {:+.2} %",
                100.0 * (found / measured - 1.0)
            );
            assert!((found / measured - 1.0).abs() < 0.1, "{spectrum:?} {speed} m/s: {found} of {measured}");
            for (axis, total) in tables.slopes().into_iter().enumerate() {
                let (held, rough) = (tables.perlin.slopes[axis], tables.perlin.rough[axis]);
                // Sums of doubles.
                assert!((held + rough - total).abs() < 1e-12, "{spectrum:?} {speed} m/s: {held} + {rough} of {total}");
                assert!(rough > 0.05 * total, "texels cannot hold it all");
            }
            let amplitudes = tables.perlin.amplitudes_m;
            let variance = amplitudes.iter().map(|a| a * a).sum::<f64>() * perlin::variance();
            // Two integrations of one spectrum by Simpson's rule.
            assert!(
                (variance / (tables.sea.hs_m / 4.0).powi(2) - 1.0).abs() < 2e-3,
                "{spectrum:?} {speed} m/s: {variance}"
            );
        }
    }
}
