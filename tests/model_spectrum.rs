//! Which waves a sea holds: amplitude in closed form (`oracles/spectra.json`), height and slopes by integration, and the
//! tiles' shares of the energy.

use ocean_globe::model::{
    optics,
    spectrum::{DirectionalSpectrum, Phillips},
    waves::*,
};
use serde_json::Value;

fn sea(speed: f64, seed: u32) -> Sea {
    Sea::from_wind(speed, seed, 1.0)
}

#[test]
fn phillips_amplitude_in_closed_form() {
    let file = serde_json::from_str::<Value>(include_str!("oracles/spectra.json")).unwrap();
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
        let sea = sea(speed, 0);
        let spectrum = Phillips::new(sea.speed_mps, sea.hs_m);
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
    // In a breeze L is U²/g and the peak period that of ω_p⁴ = 0.8 g²/L², 7.0 s at 10.2 m.
    let breeze = Phillips::new(10.0, 2.0);
    assert_eq!(breeze.l, 100.0 / 9.80665);
    assert!((breeze.peak_period() - std::f64::consts::TAU / (0.8f64.powf(0.25) * 9.80665 / 10.0)).abs() < 1e-9);
}

#[test]
fn cascades_share_the_spectrum() {
    for speed in [0.0, 1.0, 3.0, 6.0, 10.0, 15.0, 20.0, 28.0, 35.0, 60.0] {
        let sea = sea(speed, 0);
        let spectrum = sea.spectrum();
        let tiles = cascades(&sea, 256);
        println!("{speed} m/s: {tiles:?}");
        assert_eq!(tiles.len(), CASCADES);
        assert_eq!(tiles[0].k_min, 0.0);
        assert!((300.0..=6000.0).contains(&tiles[0].patch_m));
        if speed > 0.0 && tiles[0].patch_m < 6000.0 {
            assert!(tiles[0].patch_m * spectrum.peak_wavenumber() / std::f64::consts::TAU >= 8.0 - 1e-9);
        }
        for (long, short) in tiles.iter().zip(&tiles[1..]) {
            assert_eq!(long.k_max, short.k_min, "no gap, no overlap");
            assert!(short.k_min >= 4.0 * short.dk(), "the first ring is not too coarse");
            assert!(long.k_max <= 0.9 * std::f64::consts::PI * 256.0 / long.patch_m, "nor the last too fine");
            let ratio = long.patch_m / short.patch_m;
            assert!(ratio > 6.0 && ratio < 16.0);
        }
        for (a, b) in [(0, 1), (1, 2), (0, 2)] {
            let ratio = tiles[a].patch_m / tiles[b].patch_m;
            for q in 1..=4 {
                let off = (ratio * f64::from(q)).fract();
                assert!(off > 0.05 && off < 0.95, "{ratio} is nearly {} / {q}", (ratio * f64::from(q)).round());
            }
        }
        // Above 20 m/s the ratio's bound wins over the texel.
        assert!(tiles[2].patch_m / 256.0 < if speed <= 20.0 { 0.041 } else { 0.1 }, "{speed} m/s");
        // A finer grid has the same tiles, only longer rings.
        let fine = cascades(&sea, 512);
        assert_eq!(fine[0], Cascade { n: 512, ..tiles[0] });
        assert!(fine[2].k_max > tiles[2].k_max && fine[2].patch_m == tiles[2].patch_m);
    }
}

/// Energy in all tiles of a sea.
fn energy(spectrum: &impl DirectionalSpectrum, tiles: &[Cascade]) -> f64 {
    tiles.iter().map(|tile| cell_energies(spectrum, tile).iter().sum::<f64>()).sum()
}

#[test]
fn height_does_not_depend_on_the_grid() {
    for speed in [2.0, 10.0, 25.0] {
        let sea = sea(speed, 0);
        let spectrum = sea.spectrum();
        let m0 = sea.hs_m * sea.hs_m / 16.0;
        for n in [64, 128, 256] {
            let tiles = cascades(&sea, n);
            let missing = spectrum.variance_between(tiles[2].k_max, f64::INFINITY);
            let got = energy(&spectrum, &tiles) + missing;
            // 8 x 8 samples per edge cell place each of some 600 edges to 1/8 of a cell; the innermost ring of 6 cells is the
            // coarsest: 0.2 % of its energy.
            assert!((got / m0 - 1.0).abs() < 2e-3, "{speed} m/s, N = {n}: {got} of {m0}");
        }
        // Any other tiling of the plane holds the same: patches longer by half.
        let other: Vec<_> =
            cascades(&sea, 256).into_iter().map(|tile| Cascade { patch_m: tile.patch_m * 1.5, ..tile }).collect();
        // Their rings now end beyond the grids.
        let reach = |tile: &Cascade| std::f64::consts::PI * 255.0 / tile.patch_m;
        let kept: f64 =
            other.iter().map(|tile| spectrum.variance_between(tile.k_min, tile.k_max.min(reach(tile)))).sum();
        let got = energy(&spectrum, &other);
        // The grid's corners hold a little beyond its circle.
        assert!(got > kept * 0.998 && got < m0 * 1.002, "{speed} m/s: {got}, at least {kept}");
    }
}
