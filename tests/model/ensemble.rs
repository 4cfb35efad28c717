//! Many seas of one spectrum: energies and variances of `oracles/fft.json`, patch by patch and ring by ring.

use crate::oracle_sea::OracleSea;
use ocean_globe::model::spectrum::DirectionalSpectrum;
use ocean_globe::model::waves::{self, Patch, amplitudes, cell_energies, ticks_from_unix};
use ocean_globe::model::{fft, surface};
use serde_json::Value;

/// The sea's variance, as the oracle gives it.
const M0: f64 = 0.285_930_010_771_666_63;

fn oracle() -> Value {
    serde_json::from_str(include_str!("../oracles/fft.json")).unwrap()
}

/// The oracle's rows under `key`, `count` of them.
fn rows(key: &str, count: usize) -> Vec<Value> {
    let rows = oracle()[key].as_array().unwrap().clone();
    assert_eq!(rows.len(), count, "{key}");
    rows
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap_or_else(|| panic!("no {key} in {row}"))
}

fn samples(row: &Value) -> usize {
    row["N"].as_u64().unwrap() as usize
}

fn square(n: usize, patch_m: f64, k_min: f64, k_max: f64) -> Patch {
    Patch { samples: [n; 2], patch_m: [patch_m; 2], k_min, k_max }
}

/// F dk² at the cells' middles, ring half-open: what the oracle calls point-sampled.
fn point_energy(patch: Patch) -> f64 {
    let [dx, dy] = patch.dk();
    let inside = |&(x, y): &(f64, f64)| (patch.k_min..patch.k_max).contains(&x.hypot(y));
    patch.wave_vectors().filter(inside).map(|(x, y)| OracleSea.density(x, y) * dx * dy).sum()
}

/// The energy of the cells' integrals.
fn cell_energy(patch: Patch) -> f64 {
    cell_energies(&OracleSea, patch).iter().sum()
}

#[test]
fn the_oracles_sea_is_ours() {
    let file = oracle();
    assert_eq!(number(&file, "m0_analytic"), M0);
    // The closed forms agree to all printed digits; Simpson's 1024 steps cross the kink of sigma at the peak.
    assert!((OracleSea.variance_between(0.0, f64::INFINITY) / M0 - 1.0).abs() < 1e-4);
    for row in &rows("ensemble", 5) {
        let patch = square(samples(row), number(row, "L"), 0.0, f64::INFINITY);
        let want = number(row, "sum_F_dk2");
        assert!((point_energy(patch) / want - 1.0).abs() < 1e-3, "{row}: {}", point_energy(patch));
    }
}

#[test]
fn the_mean_of_many_seas_has_the_spectrums_variance() {
    for row in &rows("ensemble", 5) {
        let n = samples(row);
        let seeds: u32 = if n > 128 { 100 } else { 400 };
        let patch = square(n, number(row, "L"), 0.0, f64::INFINITY);
        let energies = cell_energies(&OracleSea, patch);
        let want: f64 = energies.iter().sum();
        let omega = waves::angular_frequencies(patch, f64::INFINITY);
        let (mut mean, mut square_mean, mut worst_imaginary) = (0.0, 0.0, 0.0f64);
        for seed in 0..seeds {
            let h0 = amplitudes(&energies, seed, 0, patch);
            let h: Vec<[f64; 2]> = (0..patch.count())
                .map(|i| surface::evolve(h0[i], h0[patch.mirror(i)], omega[i], omega[i] * 10.0 * f64::from(seed)).0)
                .collect();
            // Every tenth sea is transformed; for the rest Parseval's sum is the variance.
            let mut variance: f64 = h.iter().map(|h| h[0] * h[0] + h[1] * h[1]).sum();
            if seed % 10 == 0 {
                let mut field = h;
                fft::inverse_2d(&mut field, n);
                let spatial = field.iter().map(|x| x[0] * x[0]).sum::<f64>() / patch.count() as f64;
                assert!((spatial / variance - 1.0).abs() < 1e-12, "{row}");
                variance = spatial;
                let imaginary = field.iter().map(|x| x[1].abs()).fold(0.0, f64::max);
                worst_imaginary = worst_imaginary.max(imaginary / variance.sqrt());
            }
            mean += variance / f64::from(seeds);
            square_mean += variance * variance / f64::from(seeds);
        }
        let deviation = (square_mean - mean * mean).sqrt();
        let sigma = deviation / f64::from(seeds).sqrt();
        println!(
            "N {n}: {mean:.5} of {want:.5} ± {sigma:.5}, one sea {:.3}, imaginary {worst_imaginary:.1e}",
            deviation / mean
        );
        assert!((mean - want).abs() < 3.5 * sigma, "{row}: {mean} against {want}");
        // 100 draws know a deviation to 7 %, the oracle's as much, and points give the peak another weight than cells do.
        let one = number(row, "rel_std_of_one_tile");
        assert!((deviation / mean / one - 1.0).abs() < 0.25, "{row}: {}", deviation / mean);
        assert!(worst_imaginary < 1e-12, "the field is real");
        // What the grid can hold of the whole, by integration: its square has 4/pi of its circle's waves.
        let (circle, whole) = (OracleSea.variance_between(0.0, number(row, "kmax")), M0);
        assert!(want > 0.999 * circle && want < 1.001 * whole, "{row}: {want}");
    }
}

/// Whether no point falls on a ring's edge: of those at 6 steps rounding decides, in the oracle as here.
fn points_are_exact(row: &Value) -> bool {
    number(row, "boundary_in_dk_of_next") != 6.0
}

#[test]
fn rings_hold_what_the_integrals_say() {
    for row in &rows("cascade_cell_integrated", 5) {
        let mut total = [0.0; 3];
        for i in 0..3 {
            let at = |key: &str| row[key][i].as_f64().unwrap();
            let band = |j: usize| row["bands"][i][j].as_f64().unwrap();
            let patch = square(samples(row), at("L"), band(0), band(1));
            let cells = cell_energy(patch);
            let points = point_energy(patch);
            println!("{} dk: {points:.5e} {cells:.5e} {:.5e}", row["boundary_in_dk_of_next"], at("analytic"));
            // Points agree to the digits; 8 x 8 samples place an edge to a sixteenth of a step: at 1 dk, where k^-3 falls fast and
            // the ring has but 8 cells, 3 % of the ring. Our own rings start at 4 or 6, at N = 64 at 2.
            let exact = points_are_exact(row);
            assert!(!exact || (points / at("point_sampled") - 1.0).abs() < 1e-6, "{row}");
            let tolerance = 0.035 / number(row, "boundary_in_dk_of_next");
            // The first ring's first row holds 5e-5 of the energy, all of it in the edge cells.
            let absolute = 1e-5 * M0;
            assert!(
                (cells - at("analytic")).abs() < tolerance * at("analytic") + absolute,
                "ring {i} of {row}: {cells}"
            );
            total = [total[0] + points, total[1] + cells, total[2] + at("analytic")];
        }
        assert!((total[1] / total[2] - 1.0).abs() < 5e-3, "{row}: {total:?}");
        let points = total[0] / total[2] / number(row, "point_total_over_analytic");
        assert!(!points_are_exact(row) || (points - 1.0).abs() < 1e-6, "{row}");
    }
}

#[test]
fn disjoint_rings_share_the_energy_and_whole_spectra_count_it_again() {
    for row in &rows("cascades", 4) {
        let mut total = [0.0; 2];
        for ring in row["cascades"].as_array().unwrap() {
            let n = samples(row);
            let patch = square(n, number(ring, "L"), number(ring, "k_lo"), number(ring, "k_hi"));
            let cells = cell_energy(patch);
            // An open ring ends with its grid, whose corner cells at the edge are cut differently.
            assert!((point_energy(patch) / number(ring, "sum") - 1.0).abs() < 2e-3, "{ring}: {}", point_energy(patch));
            total = [total[0] + cells, total[1] + point_energy(patch)];
        }
        assert!((total[1] / M0 / number(row, "total_over_m0") - 1.0).abs() < 1e-3, "{row}: {total:?}");
        let shared = (total[0] / M0 - 1.0).abs() < 0.01;
        assert_eq!(shared, !row["name"].as_str().unwrap().starts_with("BUG"), "{row}: {total:?}");
    }
}

#[test]
fn the_peak_is_held_whole_on_few_waves() {
    for row in &rows("peak_capture_cell", 3) {
        let waves = number(row, "L_over_lambda_p");
        let patch = square(256, waves * std::f64::consts::TAU / OracleSea.peak_wavenumber(), 0.0, f64::INFINITY);
        let cells = cell_energy(patch);
        println!("{waves} waves: points {:.5}, cells {:.5}", point_energy(patch) / M0, cells / M0);
        // At half a wave the peak's width is a fourteenth of a cell: eight samples to a side are too few, and four waves the least.
        let tolerance = if waves < 1.0 { 0.2 } else { 0.01 };
        assert!((cells / M0 - number(row, "cell")).abs() < tolerance, "{row}: {}", cells / M0);
    }
}

#[test]
fn neither_grid_nor_lengths_turn_the_waves_or_change_their_height() {
    // The same band on grids of different counts and lengths, twelve seas each.
    for (samples, patch_m) in [([64, 64], [300.0, 300.0]), ([128, 64], [640.0, 290.0]), ([64, 256], [310.0, 1111.0])] {
        let patch = Patch { samples, patch_m, k_min: 0.0, k_max: 0.6 };
        let energies = cell_energies(&OracleSea, patch);
        let want: f64 = energies.iter().sum();
        assert!((want / OracleSea.variance_between(0.0, 0.6) - 1.0).abs() < 2e-3, "{patch:?}: {want}");
        let (mut variance, mut along, mut slope_x) = (0.0, 0.0, 0.0);
        let (mut across, mut slope_y) = (0.0, 0.0);
        for seed in 0..100 {
            let f =
                surface::fields(&amplitudes(&energies, seed, 0, patch), patch, ticks_from_unix(1e3 * f64::from(seed)));
            let mean = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / a.len() as f64;
            variance += mean(&f.eta, &f.eta) / 100.0;
            (along, slope_x) = (along - mean(&f.eta_t, &f.eta_x), slope_x + mean(&f.eta_x, &f.eta_x));
            (across, slope_y) = (across - mean(&f.eta_t, &f.eta_y), slope_y + mean(&f.eta_y, &f.eta_y));
        }
        println!(
            "{patch:?}: {variance:.4} of {want:.4}, {:.2} m/s along, {:.2} across",
            along / slope_x,
            across / slope_y
        );
        // One sea of 300 m is 11 % off, so a hundred are 1.1 %, and less on the longer grids.
        assert!((variance / want - 1.0).abs() < 0.04, "{patch:?}: {variance} of {want}");
        // Between the speeds of the shortest wave and of the peak, along the wind and not across it.
        assert!((4.0..9.7).contains(&(along / slope_x)), "{patch:?}: {} m/s", along / slope_x);
        assert!((across / slope_y).abs() < 0.3, "{patch:?}: {} m/s across", across / slope_y);
    }
}
