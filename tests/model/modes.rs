//! Seas of single waves: 32 of equal energy that are the spectrum's in few.

use ocean_globe::model::modes::{COUNT, Mode};
use ocean_globe::model::moved_water::Place;
use ocean_globe::model::sea::{Sea, SpectrumKind, Swell};
use ocean_globe::model::sea_tables::SeaTables;
use ocean_globe::model::spectrum::DirectionalSpectrum;
use ocean_globe::model::waves::{cascades, initial_amplitudes};
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::settings::{Quality, Settings};

use crate::summed::summed;

const SEEDS: [u32; 4] = [0, 1, 2, 77];
const SPEEDS_MPS: [f64; 6] = [1.5, 4.0, 8.0, 13.0, 20.0, 32.0];

fn sea(kind: SpectrumKind, speed_mps: f64, seed: u32, chop: f64) -> Sea {
    Sea::new(speed_mps, kind, None, None, seed, chop)
}

#[test]
fn thirty_two_waves_share_the_energy_evenly_and_ripples_have_the_rest() {
    for (speed, seed) in SPEEDS_MPS.into_iter().flat_map(|speed| SEEDS.map(|seed| (speed, seed))) {
        let sea = sea(SpectrumKind::Sines, speed, seed, 1.0);
        let (modes, spectrum, peak) = (sea.modes(), sea.spectrum(), sea.spectrum().wind.peak_wavenumber());
        assert_eq!(modes.len(), COUNT);
        let least = modes.iter().map(Mode::variance).fold(f64::INFINITY, f64::min);
        assert!(modes.iter().all(|mode| mode.variance() < least * (1.0 + 1e-12)), "{speed} m/s");
        let held: f64 = modes.iter().map(Mode::variance).sum();
        let ripples = sea.drawn_spectrum().variance_between(10.0 * peak, f64::INFINITY);
        // Simpson's rule and the trapezoids of the quantiles are each good to a thousandth.
        let hs = 4.0 * (held + ripples).sqrt();
        assert!((hs / sea.hs_m - 1.0).abs() < 2e-3, "{speed} m/s: {hs} of {} m", sea.hs_m);
        assert!(ripples < 0.02 * held, "{speed} m/s: ripples have {} of it", ripples / held);
        // No two on one place of a lattice, nor a wave with its opposite, and all within their ring, at any quality.
        for (index, mode) in modes.iter().enumerate() {
            let is_other = |other: &Mode| {
                let opposite = other.index.map(|i| -i);
                other.cascade != mode.cascade || (other.index != mode.index && opposite != mode.index)
            };
            assert!(modes[..index].iter().all(is_other), "{speed} m/s, seed {seed}: {mode:?}");
            let k = mode.wavenumber();
            for ring in [128, 256, 2048].map(|n| cascades(n)[mode.cascade]) {
                assert!(k < ring.k_max && (k >= ring.k_min || ring.n > 128), "{speed} m/s: {k} in {ring:?}");
            }
        }
        // 32 quantiles are the spectrum's means to a quantile's width, and the lattice moves them by a few hundredths.
        let mss: f64 = modes.iter().map(|mode| mode.wavenumber().powi(2) * mode.variance()).sum();
        let wanted = spectrum.mss_between(0.0, 10.0 * peak);
        assert!((mss / wanted - 1.0).abs() < 0.3, "{speed} m/s: slopes {mss} of {wanted}");
        let downwind = modes.iter().map(|mode| mode.wave_vector[0] / mode.wavenumber()).sum::<f64>() / COUNT as f64;
        let across = modes.iter().map(|mode| mode.wave_vector[1] / mode.wavenumber()).sum::<f64>() / COUNT as f64;
        let mean = mean_cosine(&spectrum, 10.0 * peak);
        assert!((downwind - mean).abs() < 0.08 && across.abs() < 0.1, "{speed} m/s: {downwind} of {mean}, {across}");
    }
}

/// The mean cosine of the waves' directions, weighted with their energy, by sums.
fn mean_cosine(spectrum: &impl DirectionalSpectrum, end: f64) -> f64 {
    let mut sums = [0.0; 2];
    for (i, j) in (0..400).flat_map(|i| (0..90).map(move |j| (i, j))) {
        let k = end * (0.02f64).powf(f64::from(i) / 400.0);
        let (sin, cos) = (std::f64::consts::TAU * (f64::from(j) + 0.5) / 90.0).sin_cos();
        let energy = k * k * spectrum.density(k * cos, k * sin);
        sums = [sums[0] + energy, sums[1] + cos * energy];
    }
    sums[1] / sums[0]
}

#[test]
fn sines_have_no_chop_and_gerstner_waves_do_not_fold() {
    for (speed, seed, chop) in
        SPEEDS_MPS.into_iter().flat_map(|v| SEEDS.into_iter().flat_map(move |s| [0.3, 2.0].map(|c| (v, s, c))))
    {
        assert_eq!(sea(SpectrumKind::Sines, speed, seed, chop).chop, 0.0);
        let gerstner = sea(SpectrumKind::Gerstner, speed, seed, chop);
        let folding: f64 = gerstner.modes().iter().map(|m| gerstner.chop * m.wavenumber() * m.amplitude_m()).sum();
        assert!(folding < 1.0 + 1e-12 && gerstner.chop <= chop, "{speed} m/s: {folding}");
        // The user's sharpness where it is not too sharp.
        assert!(gerstner.chop == chop || (folding - 1.0).abs() < 1e-12, "{speed} m/s: {} for {chop}", gerstner.chop);
    }
    let [calm, jonswap] = [sea(SpectrumKind::Gerstner, 0.0, 0, 1.5), sea(SpectrumKind::Jonswap, 9.0, 0, 1.5)];
    assert!(calm.modes().is_empty() && calm.chop == 1.5 && jonswap.modes().is_empty() && jonswap.chop == 1.5);
}

#[test]
fn amplitudes_slopes_and_swell_are_those_of_the_same_sea() {
    let swell = Some(Swell { height_m: 2.0, period_s: 14.0, toward: 1.0 });
    let [few, all] = [SpectrumKind::Gerstner, SpectrumKind::Jonswap]
        .map(|kind| SeaTables::new(Sea::new(10.0, kind, None, swell, 3, 1.0), 256));
    assert_eq!((few.sea.hs_m, few.peak_period_s), (all.sea.hs_m, all.peak_period_s));
    for axis in [0, 1] {
        // As above: what 32 waves hold of the slopes of waves up to 10 kp, a third of all, to a third.
        assert!((few.slopes()[axis] / all.slopes()[axis] - 1.0).abs() < 0.12, "{:?} {:?}", few.slopes(), all.slopes());
    }
    let variance: f64 = few
        .cascades
        .iter()
        .enumerate()
        .flat_map(|(index, patch)| initial_amplitudes(&few.sea, index, patch))
        .map(|h| 2.0 * (h[0] * h[0] + h[1] * h[1]))
        .sum();
    // The swell's waves are random: some 100 of them hold a third of the variance.
    assert!((variance / (few.sea.hs_m.powi(2) / 16.0) - 1.0).abs() < 0.15, "{variance}");
}

#[test]
fn the_measured_surface_is_the_sum_of_sines_and_of_gerstner_waves() {
    const T_S: f64 = 1_795_694_400.0;
    for spectrum in [SpectrumKind::Sines, SpectrumKind::Gerstner] {
        let settings =
            Settings { beaufort: Some(7), spectrum, chop: 0.9, quality: Quality::High, ..Settings::default() };
        let mut seas = Seas::default();
        let tables = seas.tables(&settings);
        let (modes, chop) = (tables.sea.modes(), tables.sea.chop);
        let (mut heights, mut sums, mut ripples, mut errors) = (0.0, 0.0, 0.0, 0.0f64);
        for i in 0..300 {
            let lat = (35.0 + 0.003 * f64::from(i % 17)).to_radians();
            let lon = (-14.0 + 0.004 * f64::from(i)).to_radians();
            let sample = seas.sample(&settings, lat, lon, T_S, f64::INFINITY);
            let place = Place::new(&tables, settings.wind_from(), lat, lon);
            let (rest, motion) = place.invert(chop, |cascade, at| summed(&modes, cascade, at, T_S));
            let height_m = motion.height - tables.chop_level_m;
            assert!((rest + chop * motion.shift).length() < 1e-3, "the sum folds");
            heights += sample.height_m.powi(2) / 300.0;
            sums += height_m.powi(2) / 300.0;
            errors += (sample.height_m - height_m).powi(2) / 300.0;
            ripples = tables.sea.drawn_spectrum().variance_between(0.0, f64::INFINITY);
        }
        println!(
            "{spectrum:?}: Hs {:.3} m, of the sum {:.3}, apart {:.4}, ripples {:.4}",
            4.0 * heights.sqrt(),
            4.0 * sums.sqrt(),
            errors.sqrt(),
            ripples.sqrt()
        );
        // What is apart are the ripples, whose rms of 300 values is known to a tenth, and the linear interpolation between samples:
        // 9 to 40 a wave, (π/9)²/8 of an amplitude at worst and in the mean over waves a tenth of that, 2 mm of 0.3 m.
        assert!(errors.sqrt() < 1.15 * ripples.sqrt() + 0.005, "{spectrum:?}");
        assert!(errors.sqrt() > 0.8 * ripples.sqrt(), "{spectrum:?}: no ripples");
        // 300 places see some 60 independent waves: 9 % of a height.
        assert!((4.0 * heights.sqrt() / tables.sea.hs_m - 1.0).abs() < 0.2, "{spectrum:?}");
    }
}
