//! What a texture's mip levels, or a pixel's footprint, take from the slopes becomes roughness: nothing is lost in between.

use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::waves;
use ocean_globe::pass::fft::Precision;
use ocean_globe::scene::frame::{MIX_FAR_M, MIX_NEAR_M};

use crate::water::{Ensemble, NOON, Water, Waves, chopless, frame, mean, places, reseeded};

/// The first two and the last two channels of one layer of one mip level.
fn pairs(water: &Water, texture: &wgpu::Texture, layer: u32, mip: u32) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    let bytes = water.gpu.read_texture(texture, layer, mip).unwrap();
    let pair = |texel: &[u8]| {
        let [x, y, z, w] = bytemuck::pod_read_unaligned::<[f32; 4]>(texel).map(f64::from);
        ([x, y], [z, w])
    };
    bytes.chunks_exact(16).map(pair).unzip()
}

/// Slope variance that the means over 2^mip by 2^mip samples keep of the waves of a patch, along the wind and across it.
fn kept(patch: &waves::Cascade, energies: &[f64], mip: u32) -> [f64; 2] {
    let (step, block) = (patch.patch_m / patch.n as f64, f64::from(1 << mip));
    // The mean of e^{ikx} over `block` samples.
    let mean = |k: f64| if k == 0.0 { 1.0 } else { (0.5 * k * step * block).sin() / (block * (0.5 * k * step).sin()) };
    let mut sum = [0.0; 2];
    for ((kx, ky), energy) in patch.wave_vectors().zip(energies).filter(|(_, energy)| **energy > 0.0) {
        let left = (mean(kx) * mean(ky)).powi(2);
        sum = [sum[0] + kx * kx * energy * left, sum[1] + ky * ky * energy * left];
    }
    sum
}

#[test]
fn every_mip_level_keeps_or_hides_all_slopes() {
    const N: usize = 128;
    const SEEDS: u32 = 40;
    let mut water = Water::new(N, Precision::Single, |source| source);
    let sea = frame(&chopless(11.0), NOON);
    let tables = SeaTables::new(sea.sea.sea, N);
    let waves_of_sea = Waves::of(&tables);
    let mips = water.fft.slopes.mip_level_count();
    // [mip][axis]: resolved and unresolved of all patches, in the mean.
    let mut found = vec![[[Ensemble::default(); 2]; 2]; mips as usize];
    for seed in 0..SEEDS {
        water.set_sea(&waves_of_sea, seed, NOON);
        let mut sums = vec![[[0.0; 2]; 2]; mips as usize];
        for layer in 0..waves::CASCADES as u32 {
            let mut whole = [0.0; 2];
            for mip in 0..mips {
                let (slopes, squares) = pairs(&water, &water.fft.slopes, layer, mip);
                let count = slopes.len() as f64;
                for axis in 0..2 {
                    let resolved = slopes.iter().map(|s| s[axis] * s[axis]).sum::<f64>() / count;
                    let mut unresolved = 0.0;
                    for (slope, square) in slopes.iter().zip(&squares) {
                        let hidden = square[axis] - slope[axis] * slope[axis];
                        // A mean of squares is at least the square of the mean, but for the roundings of 32 bits.
                        assert!(hidden > -1e-6 * square[axis] - 1e-12, "patch {layer} mip {mip}: {hidden}");
                        unresolved += hidden / count;
                    }
                    if mip == 0 {
                        whole[axis] = resolved;
                    }
                    // In one realisation: means of means lose 2^-24 at each of at most 5 levels.
                    let all = resolved + unresolved;
                    assert!(
                        (all / whole[axis] - 1.0).abs() < 1e-5,
                        "patch {layer} mip {mip}: {all} of {}",
                        whole[axis]
                    );
                    sums[mip as usize][axis][0] += resolved;
                    sums[mip as usize][axis][1] += unresolved;
                }
            }
        }
        for (ensemble, sum) in
            found.as_flattened_mut().as_flattened_mut().iter_mut().zip(sums.as_flattened().as_flattened())
        {
            ensemble.push(*sum);
        }
    }
    for (mip, axes) in found.iter().enumerate() {
        for (axis, [resolved, unresolved]) in axes.iter().enumerate() {
            let total = tables.slopes()[axis];
            let sum = resolved.mean() + unresolved.mean() + tables.below_slopes[axis];
            let model: f64 =
                tables.cascades.iter().zip(&waves_of_sea.energies).map(|(t, e)| kept(t, e, mip as u32)[axis]).sum();
            println!(
                "mip {mip} axis {axis}: resolved {:.4} (the model's {:.4}), unresolved {:.4}, below {:.4}, sum {:.4}",
                resolved.mean() / total,
                model / total,
                unresolved.mean() / total,
                tables.below_slopes[axis] / total,
                sum / total
            );
            assert!((sum / total - 1.0).abs() < 0.02, "mip {mip} axis {axis}: {sum} of {total}");
            assert!(resolved.error() < 0.005 * total, "40 seas tell a quarter of the 2 %");
            // The ensemble's own error.
            let error = (resolved.mean() - model).abs();
            assert!(error < 3.5 * resolved.error() + 1e-6, "mip {mip} axis {axis}: {} of {model}", resolved.mean());
        }
    }
}

#[test]
fn the_drawn_slopes_and_their_roughness_add_up_under_every_footprint() {
    const PLACES: usize = 1024;
    const SEAS: u32 = 24;
    const FOOTPRINTS: [f64; 13] = [0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4];
    let mut water = Water::new(256, Precision::Half, |source| source);
    for speed in [5.0, 11.0, 17.0] {
        let sea = frame(&chopless(speed), NOON);
        let waves_of_sea = Waves::of(&sea.sea);
        let side_m = sea.sea.cascades[0].patch_m;
        let total = sea.sea.slopes();
        // The waves alone, both, the far sea alone.
        let distances = [0.0, 0.5 * (MIX_NEAR_M + MIX_FAR_M), MIX_FAR_M];
        let pairs: Vec<_> = distances.iter().flat_map(|&d| FOOTPRINTS.map(|footprint| [d, footprint])).collect();
        let mut found = vec![[[Ensemble::default(); 2]; 2]; pairs.len()];
        for seed in 0..SEAS {
            let now = reseeded(&sea, seed, NOON + 1e4 * f64::from(seed * seed));
            water.set_sea(&waves_of_sea, seed, now.unix_seconds);
            water.set_noise(&now);
            let places = places(&pairs, PLACES * seed as usize, PLACES, side_m);
            let drawn = water.at(&now, &places);
            for (drawn, found) in drawn.chunks_exact(PLACES).zip(&mut found) {
                for (axis, [slope, rough]) in found.iter_mut().enumerate() {
                    slope.push(mean(drawn, |d| d.slope[axis] * d.slope[axis]));
                    rough.push(mean(drawn, |d| d.rough[axis]));
                }
            }
        }
        for ([distance, footprint], axes) in pairs.into_iter().zip(found) {
            let [along, across] = [0, 1].map(|axis| {
                let [slope, rough] = axes[axis].map(|ensemble| ensemble.mean() / total[axis]);
                (slope, rough, slope + rough)
            });
            println!("{speed} m/s, {distance} m, footprint {footprint} m: along {along:.4?}, across {across:.4?}");
            let both = (along.2 * total[0] + across.2 * total[1]) / (total[0] + total[1]);
            assert!((both - 1.0).abs() < 0.02, "{speed} m/s, {distance} m, footprint {footprint} m: {both}");
            // The noise's patch keeps the sum of both axes' squares, and its own slopes say how they share it: along the wind
            // 0.75 of them in its short octaves and 0.8 in its long ones. A twentieth of the 0.4 that it holds in a light
            // wind, put on the wrong axis, is 2 % of the whole, and more of the smaller one.
            let bound = if distance == 0.0 { 0.02 } else { 0.04 };
            for (_, _, sum) in [along, across] {
                assert!((sum - 1.0).abs() < bound, "{speed} m/s, {distance} m, footprint {footprint} m: {sum}");
            }
            if footprint >= 3e3 {
                assert!(along.0 + across.0 < 0.01, "what is far smaller than the footprint is roughness alone");
            }
        }
    }
}
