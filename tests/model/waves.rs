//! The f64 sea: `golden_tile` of `oracles/fft.json` field by field, the ensemble's energy, direction of travel, the clock, the
//! hash.

use ocean_globe::model::{
    dispersion, fft, sea_state,
    spectrum::DirectionalSpectrum,
    surface::{self, ChopGradient},
    waves::*,
};
use serde_json::Value;

fn oracle(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// A grid whose first index is x, as the oracle keeps them, brought to ours: element (i, j) at j·N + i.
fn transposed(grid: &[f64], n: usize) -> Vec<f64> {
    (0..n * n).map(|index| grid[index % n * n + index / n]).collect()
}

fn sea(speed: f64, seed: u32) -> Sea {
    Sea::from_wind(speed, seed, 1.0)
}

#[test]
fn golden_patch() {
    let file = oracle(include_str!("../oracles/fft.json"));
    let patch = &file["golden_tile"];
    let n = patch["N"].as_u64().unwrap() as usize;
    let grid = |value: &Value| transposed(&numbers(value), n);
    let cascade = Cascade { n, patch_m: patch["L"].as_f64().unwrap(), k_min: 0.0, k_max: f64::INFINITY };
    let (t, chop) = (patch["t"].as_f64().unwrap(), patch["lambda_"].as_f64().unwrap());
    let h0: Vec<_> = grid(&patch["h0_re"]).into_iter().zip(grid(&patch["h0_im"])).map(|(re, im)| [re, im]).collect();
    let omega: Vec<f64> = cascade.wave_vectors().map(|(kx, ky)| dispersion::omega_deep(kx.hypot(ky))).collect();

    // The oracle prints 12 digits of numbers up to 0.2 in h0 (5e-13 each); 256 of them add up to some 5e-12 in the fields.
    const PRINTED: f64 = 2e-11;
    let minus = |index: usize| (n - index / n) % n * n + (n - index % n) % n;
    for (part, key) in ["H_re", "H_im"].iter().enumerate() {
        for (index, want) in grid(&patch[key]).into_iter().enumerate() {
            let (h, _) = surface::evolve(h0[index], h0[minus(index)], omega[index], omega[index] * t);
            assert!((h[part] - want).abs() < PRINTED, "{key}[{index}]: {} against {want}", h[part]);
        }
    }
    let got = surface::fields_at(&h0, &cascade, f64::INFINITY, &omega, t);
    let derived = |f: &dyn Fn(ChopGradient, usize) -> f64| -> Vec<f64> {
        (0..n * n).map(|index| f(got.chop_gradient(index, chop), index)).collect()
    };
    let slopes = |g: ChopGradient, index: usize| g.true_slope(got.eta_x[index], got.eta_y[index]);
    let fields = &patch["fields"];
    for (name, want, got) in [
        ("eta", &fields["eta"], got.eta.clone()),
        ("Dx", &fields["Dx"], got.dx.clone()),
        ("Dz", &fields["Dz"], got.dy.clone()),
        ("eta_x", &fields["eta_x"], got.eta_x.clone()),
        ("eta_z", &fields["eta_z"], got.eta_y.clone()),
        ("Dx_x", &fields["Dx_x"], got.dx_x.clone()),
        ("Dz_z", &fields["Dz_z"], got.dy_y.clone()),
        ("Dx_z", &fields["Dx_z"], got.dx_y.clone()),
        ("eta_t", &fields["eta_t"], got.eta_t.clone()),
        ("J", &patch["J"], derived(&|g, _| g.jacobian())),
        ("min_eigenvalue", &patch["min_eigenvalue"], derived(&|g, _| g.min_eigenvalue())),
        ("true_slope_x", &patch["true_slope_x"], derived(&|g, index| slopes(g, index)[0])),
        ("true_slope_z", &patch["true_slope_z"], derived(&|g, index| slopes(g, index)[1])),
    ] {
        let want = grid(want);
        assert_eq!(want.len(), got.len());
        let worst = want.iter().zip(&got).map(|(want, got)| (want - got).abs()).fold(0.0, f64::max);
        println!("{name}: worst {worst:.1e}");
        assert!(worst < PRINTED, "{name} is off by {worst}");
    }
    let variance = got.eta.iter().map(|eta| eta * eta).sum::<f64>() / (n * n) as f64;
    assert!((variance - patch["checks"]["spatial_variance"].as_f64().unwrap()).abs() < PRINTED);
}

#[test]
fn transform_agrees_with_another_library() {
    let n = 64;
    let mut ours: Vec<[f64; 2]> =
        (0..n * n).map(|i| ocean_globe::model::noise::gaussian_pair(1, 2, i as i32, 3)).collect();
    let mut theirs: Vec<_> = ours.iter().map(|&[re, im]| rustfft::num_complex::Complex::new(re, im)).collect();
    let plan = rustfft::FftPlanner::new().plan_fft_inverse(n);
    let transpose = |grid: &[rustfft::num_complex::Complex<f64>]| -> Vec<_> {
        (0..n * n).map(|index| grid[index % n * n + index / n]).collect()
    };
    plan.process(&mut theirs);
    theirs = transpose(&theirs);
    plan.process(&mut theirs);
    theirs = transpose(&theirs);
    fft::inverse_2d(&mut ours, n);
    // Values of RMS sqrt(2)·64 after 12 layers of roundings of 1e-16.
    for (a, b) in ours.iter().zip(&theirs) {
        assert!((a[0] - b.re).abs() < 2e-12 && (a[1] - b.im).abs() < 2e-12);
    }
    let mut one = vec![[0.0; 2]; 8];
    one[1] = [1.0, 0.0];
    fft::inverse(&mut one);
    // e^{+2πi m/8}: the second sample has a positive imaginary part.
    assert!((one[1][1] - std::f64::consts::FRAC_1_SQRT_2).abs() < 1e-15);
}

#[test]
fn ensemble_has_the_energy_of_the_spectrum() {
    const SEEDS: u32 = 60;
    for index in 0..CASCADES {
        let patch = cascades(64)[index];
        let energies = cell_energies(&sea(10.0, 0).spectrum(), &patch);
        let want: f64 = energies.iter().sum();
        let mut mean = 0.0;
        for seed in 0..SEEDS {
            let h0 = initial_amplitudes(&sea(10.0, seed), index, &patch);
            let eta = surface::fields(&h0, &patch, ticks_from_unix(f64::from(seed) * 17.0)).eta;
            mean += eta.iter().map(|eta| eta * eta).sum::<f64>() / eta.len() as f64 / f64::from(SEEDS);
        }
        // |H|² is exponential about (E + E')/2 and each pair k, -k counts twice: var(one patch) = Σ over pairs of (E + E')².
        let pair = |i: usize| energies[i] + energies[(64 - i / 64) % 64 * 64 + (64 - i % 64) % 64];
        let sigma = (0.5 * (0..64 * 64).map(|i| pair(i) * pair(i)).sum::<f64>() / f64::from(SEEDS)).sqrt();
        println!("cascade {index}: {mean:.4e} of {want:.4e}, sigma {sigma:.1e}");
        assert!((mean - want).abs() < 4.0 * sigma, "cascade {index}: {mean} against {want} ± {sigma}");
        assert!(sigma < 0.05 * want, "sharp enough to tell a factor 2 or 8");
    }
}

#[test]
fn waves_run_downwind() {
    for (index, patch) in cascades(128).iter().enumerate() {
        let h0 = initial_amplitudes(&sea(12.0, 5), index, patch);
        let f = surface::fields(&h0, patch, ticks_from_unix(1.7e9));
        let mean = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / a.len() as f64;
        let along = -mean(&f.eta_t, &f.eta_x) / mean(&f.eta_x, &f.eta_x);
        let across = -mean(&f.eta_t, &f.eta_y) / mean(&f.eta_y, &f.eta_y);
        // Between the speeds of the patch's shortest and longest waves, ω/k.
        let k0 = patch.k_min.max(patch.dk());
        assert!(along > 0.5 * dispersion::omega_deep(patch.k_max) / patch.k_max, "cascade {index}: {along} m/s");
        assert!(along < 2.0 * dispersion::omega_deep(k0) / k0, "cascade {index}: {along} m/s");
        assert!(across.abs() < 0.3 * along, "cascade {index}: {across} m/s across");
        // Chop gathers points at the crests: J is small where η is high.
        let j: Vec<f64> = (0..f.eta.len()).map(|i| f.chop_gradient(i, 1.0).jacobian() - 1.0).collect();
        assert!(mean(&f.eta, &j) < 0.0);
    }
}

#[test]
fn a_calm_is_flat() {
    for sea in [sea(0.0, 1), sea(-3.0, 1), sea(f64::NAN, 1), Sea { hs_m: f64::NAN, ..sea(8.0, 1) }] {
        assert_eq!(sea.spectrum().mss_above(0.0), 0.0);
        assert_eq!(sea.spectrum().peak_period(), 0.0);
        for (index, patch) in cascades(64).iter().enumerate() {
            assert!(patch.patch_m.is_finite() && patch.k_max.is_finite());
            let h0 = initial_amplitudes(&sea, index, patch);
            assert!(h0.iter().flatten().all(|&x| x == 0.0));
            assert!(surface::fields(&h0, patch, 12345).eta.iter().all(|&x| x == 0.0));
        }
    }
    assert!(sea(0.3, 0).spectrum().density(0.0, 0.0) == 0.0 && sea(0.3, 0).spectrum().density(1e-100, 0.0) == 0.0);
}

#[test]
fn amplitudes_keep_out_of_what_has_no_partner() {
    let n = 64;
    for (index, patch) in cascades(n).iter().enumerate() {
        let h0 = initial_amplitudes(&sea(9.0, 3), index, patch);
        assert!(h0.iter().flatten().all(|x| x.is_finite()) && h0.iter().flatten().any(|&x| x != 0.0));
        assert_eq!(h0[0], [0.0; 2]);
        assert!((0..n).all(|i| h0[n / 2 * n + i] == [0.0; 2] && h0[i * n + n / 2] == [0.0; 2]));
        let open = cell_energies(&sea(9.0, 3).spectrum(), &Cascade { k_min: 0.0, k_max: f64::INFINITY, ..*patch });
        assert!((0..n).all(|i| open[n / 2 * n + i] == 0.0 && open[i * n + n / 2] == 0.0) && open[n / 2 - 1] > 0.0);
        // A finer grid holds the same waves where the ring's end does not cut.
        let fine = Cascade { n: 2 * n, ..*patch };
        let again = initial_amplitudes(&sea(9.0, 3), index, &fine);
        for (i, j) in [(7usize, 3usize), (9, n - 5), (20, 1), (20, n - 1)] {
            let up = |i: usize| if i < n / 2 { i } else { i + n };
            assert_eq!(h0[j * n + i], again[up(j) * 2 * n + up(i)]);
        }
    }
}

/// Of the sea of 13.9 m/s, seed 7, four patches of 64 x 64.
const HASHES: [u64; 4] = [0xeb52_94d0_2c37_be57, 0x1763_6e86_6aa6_4922, 0x6148_07fe_0e55_bcf6, 0x3ed6_8b75_ae3e_678d];

#[test]
fn the_same_sea_everywhere() {
    let sea = sea(13.9, 7);
    let hashes: Vec<u64> =
        cascades(64).iter().enumerate().map(|(index, patch)| hash(&initial_amplitudes(&sea, index, patch))).collect();
    // Not derived but recorded: WebAssembly must give the same four, and so must every later version.
    assert_eq!(hashes, HASHES, "{hashes:#x?}");
    // FNV-1a's offset basis, and its hash of the bytes 00 00 80 3f 00 00 20 c0 by another implementation.
    assert_eq!(hash(&[]), 0xcbf2_9ce4_8422_2325);
    assert_eq!(hash(&[[1.0, -2.5]]), 0x09e6_29ee_2dfd_b3f8);
}

#[test]
fn the_clock_holds_for_centuries() {
    // A year-2200 phase of the fastest wave that any patch holds, against exact integer arithmetic on whole seconds.
    assert_eq!(cycles_per_tick(std::f64::consts::TAU), 1 << 44);
    assert_eq!(ticks_from_unix(1.0), 1 << 20);
    assert_eq!(ticks_from_unix(-1.0), (1u64 << 20).wrapping_neg());
    assert_eq!((ticks_from_unix(f64::NAN), ticks_from_unix(f64::INFINITY)), (0, 0));
    for seconds in [0.0, 1.0, 1.7e9, 7.258e9, -2.2e9] {
        let ticks = ticks_from_unix(seconds);
        assert_eq!(phase_u32(cycles_per_tick(3.0 * std::f64::consts::TAU), ticks), 0, "whole cycles at whole seconds");
        assert_eq!(
            phase_u32(cycles_per_tick(0.25 * std::f64::consts::TAU), ticks),
            ((seconds.rem_euclid(4.0)) as u32) << 30
        );
        // One tick later the phase is omega/2^20 further, to 2^-32 cycle: no grain at any date.
        for omega in [0.3, 2.0, 90.0] {
            let cycles = cycles_per_tick(omega);
            let step = phase_u32(cycles, ticks.wrapping_add(1)).wrapping_sub(phase_u32(cycles, ticks));
            let want = omega / std::f64::consts::TAU / TICKS_PER_SECOND * 4_294_967_296.0;
            assert!((f64::from(step) - want).abs() <= 1.0, "{omega} at {seconds}: {step}, want {want}");
        }
    }
}

#[test]
fn fields_at_ticks_are_fields_at_seconds() {
    let patch = cascades(32)[1];
    let h0 = initial_amplitudes(&sea(8.0, 1), 1, &patch);
    let (a, b) = (
        surface::fields(&h0, &patch, ticks_from_unix(50.0)),
        surface::fields_at(&h0, &patch, f64::INFINITY, &angular_frequencies(&patch, f64::INFINITY), 50.0),
    );
    let height = 0.25 * sea_state::significant_height(8.0);
    // A phase in 2^-32 cycle is off by 1.5e-9 at most, and so is each wave.
    assert!(a.eta.iter().zip(&b.eta).all(|(a, b)| (a - b).abs() < 4e-9 * height));
}
