//! Which waves a sea holds: amplitude in closed form (`oracles/spectra.json`), height and slopes by integration, and the
//! patches' shares of the energy.

use ocean_globe::model::{
    dispersion, optics,
    sea::SpectrumKind,
    sea_state,
    spectrum::{DirectionalSpectrum, Phillips},
    waves::*,
};
use serde_json::Value;

fn sea(speed: f64, seed: u32) -> Sea {
    Sea::from_wind(speed, seed, 1.0)
}

#[test]
fn phillips_amplitude_in_closed_form() {
    let file = serde_json::from_str::<Value>(include_str!("../oracles/spectra.json")).unwrap();
    let rows = file["phillips"]["A_from_Hs"].as_array().unwrap();
    assert_eq!(rows.len(), 8);
    for row in rows {
        let (l, hs) = (row["L"].as_f64().unwrap(), row["Hs_target"].as_f64().unwrap());
        for (upwind, key) in [(1.0, "A_full_plane"), (0.0, "A_half_plane")] {
            let got = Phillips::plain(l, 0.0, upwind, hs).a;
            let want = row[key].as_f64().unwrap();
            // Simpson with 256 steps of 0.06 in ln k costs 1e-9, waves beyond 4,000 rad/m hold 1e-8 of the variance.
            assert!((got / want - 1.0).abs() < 2e-8, "{key} {got}, want {want}");
        }
    }
    let rows = file["phillips"]["radial_check"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for row in rows {
        let (u, damping) = (row["U"].as_f64().unwrap(), row["l"].as_f64().unwrap());
        let sea = Phillips::plain(u * u / 9.80665, damping, 1.0, 1.0);
        let radial = 1.0 / 16.0 / (sea.a * std::f64::consts::PI);
        assert!((radial / row["radial_integral"].as_f64().unwrap() - 1.0).abs() < 2e-8, "{row}: {radial}");
    }
}

#[test]
fn spectrum_keeps_height_and_slopes() {
    for speed in [0.3, 0.836, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0, 35.0, 60.0] {
        let sea = Sea { kind: SpectrumKind::Phillips, ..sea(speed, 0) };
        let peak_s = sea_state::peak_period(speed, sea.hs_m);
        let peak = dispersion::wavenumber(std::f64::consts::TAU / peak_s, f64::INFINITY);
        let spectrum = Phillips::new(speed, sea.hs_m, peak);
        assert_eq!(sea.spectrum().density(0.3, 0.1), spectrum.density(0.3, 0.1), "it is what the sea is drawn with");
        // Two Simpson rules of different steps against each other; the tail's kink costs the coarser its order.
        assert!((spectrum.significant_height() / sea.hs_m - 1.0).abs() < 1e-4, "{speed} m/s");
        let (got, want) = (spectrum.mss_above(0.0), optics::cox_munk_mss(speed).total);
        println!(
            "{speed} m/s: Hs {:.3}, Tp {:.2} s, L {:.3} m, tail {:.3}, mss {got:.5} of {want:.5}",
            sea.hs_m,
            spectrum.peak_period(),
            spectrum.l,
            spectrum.tail
        );
        assert!((got / want - 1.0).abs() < 2e-3, "{speed} m/s: mean square slope {got}, measured {want}");
        // The analytic ring integral against 128 samples around it.
        let k = 3.0 * spectrum.peak_wavenumber();
        struct Sampled(Phillips);
        impl DirectionalSpectrum for Sampled {
            fn density(&self, kx: f64, ky: f64) -> f64 {
                self.0.density(kx, ky)
            }
            fn peak_wavenumber(&self) -> f64 {
                self.0.peak_wavenumber()
            }
        }
        assert!((Sampled(spectrum).omnidirectional(k) / spectrum.omnidirectional(k) - 1.0).abs() < 1e-12);
    }
    // ω_p⁴ = 0.8 g²/L²: a sea whose L is U²/g has its peak at 7.0 s at 10.2 m.
    let omega = 0.8f64.powf(0.25) * 9.80665 / 10.0;
    let breeze = Phillips::new(10.0, 2.0, omega * omega / 9.80665);
    assert!((breeze.l - 100.0 / 9.80665).abs() < 1e-12);
    assert!((breeze.peak_period() - std::f64::consts::TAU / omega).abs() < 1e-9);
    // Two metres on waves of a metre would be a wall: its waves get longer.
    let steep = Phillips::new(10.0, 2.0, std::f64::consts::TAU);
    assert!(steep.l > 4.0 && (steep.significant_height() / 2.0 - 1.0).abs() < 1e-4, "{}", steep.l);
}

#[test]
fn cascades_share_the_wave_numbers() {
    let patches = cascades(256);
    println!("{patches:#?}");
    assert_eq!(patches.len(), CASCADES);
    assert!(patches[0].k_min == 0.0 && patches[0].patch_m >= 5000.0 && patches[3].patch_m / 256.0 <= 0.01);
    for n in [64, 128, 256, 512, 1024] {
        let finer = cascades(n);
        for (long, short) in finer.iter().zip(&finer[1..]) {
            assert_eq!(long.k_max, short.k_min, "no gap, no overlap");
            assert!(
                long.k_max <= 0.9 * std::f64::consts::PI * n as f64 / long.patch_m + 1e-12,
                "nor the last too fine"
            );
            // 0.9 of the longer patch's highest wave number is N / 32 steps of the shorter at a ratio of 14.4.
            let least = if n == 64 { 2.0 } else { 4.0 };
            assert!(short.k_min >= least * short.dk(), "N = {n}: the first ring is not too coarse");
        }
        // Neither the wind nor the grid moves a patch; from 256 on only the last ring grows.
        for (a, b) in finer.iter().zip(&patches) {
            assert_eq!(a.patch_m, b.patch_m);
            assert!(n < 256 || (a.k_min == b.k_min && (a.k_max == b.k_max || b.k_max == patches[3].k_max)));
        }
        assert!(finer[3].k_max == 0.9 * std::f64::consts::PI * n as f64 / finer[3].patch_m);
    }
}

#[test]
fn no_two_patches_repeat_together() {
    for (a, b) in [(0, 1), (1, 2), (2, 3), (0, 2), (1, 3), (0, 3)] {
        let ratio = PATCHES_M[a] / PATCHES_M[b];
        for q in 1..=8 {
            let off = (ratio * f64::from(q) - (ratio * f64::from(q)).round()).abs();
            // What is left of the shorter patch when q of the longer have passed; 1/√5 is the most that any ratio keeps for all q.
            assert!(off * f64::from(q) > 0.15, "{ratio} is nearly {} / {q}", (ratio * f64::from(q)).round());
        }
    }
}

/// Energy in all patches of a sea.
fn energy(spectrum: &impl DirectionalSpectrum, patches: &[Cascade]) -> f64 {
    patches.iter().map(|patch| cell_energies(spectrum, patch).iter().sum::<f64>()).sum()
}

#[test]
fn every_grid_holds_the_height_of_every_grade() {
    for grade in 0..=12 {
        let sea = sea(sea_state::speed_from_beaufort(f64::from(grade)), 0);
        let (spectrum, m0) = (sea.spectrum(), sea.hs_m * sea.hs_m / 16.0);
        let ratio = |n| energy(&spectrum, &cascades(n)) / m0;
        if grade == 0 {
            assert_eq!(energy(&spectrum, &cascades(64)), 0.0);
            continue;
        }
        let ratios = [64, 128, 256, 512, 1024].map(ratio);
        println!("grade {grade:2}: {}", ratios.map(|r| format!("{r:.5}")).join("  "));
        for (i, r) in ratios.into_iter().enumerate() {
            assert!((r - 1.0).abs() < 0.01, "grade {grade}, N = {}: {r}", 64 << i);
        }
    }
}

#[test]
fn neither_samples_nor_lengths_change_the_height() {
    let sea = sea(10.0, 0);
    let spectrum = sea.spectrum();
    // Grids of different counts and lengths along x and y; each holds all waves up to 0.8 rad/m.
    for (samples, patch_m) in [
        ([256, 256], [900.0, 900.0]),
        ([256, 512], [600.0, 1800.0]),
        ([128, 1024], [437.0, 3111.0]),
        ([512, 128], [1700.0, 450.0]),
    ] {
        let patch = Patch { samples, patch_m, k_min: 0.0, k_max: 0.8 };
        let got: f64 = cell_energies(&spectrum, patch).iter().sum();
        let want = spectrum.variance_between(0.0, 0.8);
        // 8 x 8 samples place the edge to 1/8 of a cell on both sides of the truth; the origin's cell holds no energy yet.
        assert!((got / want - 1.0).abs() < 1e-3, "{patch:?}: {got} of {want}");
    }
}
