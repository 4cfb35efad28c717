//! Mistakes that popular ocean renderers make with the moving surface, its clock, its light and its units: each is kept here,
//! and the very check that our code passes rejects it. Those of amplitudes and transforms are in `mistakes.rs`.

use std::f64::consts::TAU;

use crate::oracle_sea::OracleSea;
use ocean_globe::model::quadrature::simpson;
use ocean_globe::model::spectrum::DirectionalSpectrum;
use ocean_globe::model::surface::{ChopGradient, Fields};
use ocean_globe::model::waves::{self, Patch, amplitudes, cell_energies};
use ocean_globe::model::{dispersion, foam, optics, surface};
use serde_json::Value;

fn patch(patch_m: f64) -> Patch {
    Patch { samples: [64; 2], patch_m: [patch_m; 2], k_min: 0.0, k_max: f64::INFINITY }
}

fn near(got: f64, want: f64, tolerance: f64) {
    assert!((got / want - 1.0).abs() < tolerance, "{got}, expected {want}");
}

#[test]
fn the_wrong_sign_of_the_chop() {
    let patch = patch(300.0);
    let energies = cell_energies(&OracleSea, patch);
    let seas: Vec<Fields> =
        (0..20).map(|seed| surface::fields(&amplitudes(&energies, seed, 0, patch), patch, 0)).collect();
    // Correlation of height and Jacobian, and the mean level of the moved water, at a λ.
    let moments = |chop: f64| {
        let (mut product, mut level, mut squares) = (0.0, 0.0, [0.0; 2]);
        for f in &seas {
            for (i, eta) in f.eta.iter().enumerate() {
                let j = f.chop_gradient(i, chop).jacobian();
                product += eta * (j - 1.0);
                squares = [squares[0] + eta * eta, squares[1] + (j - 1.0) * (j - 1.0)];
                level += eta * j / (seas.len() * patch.count()) as f64;
            }
        }
        [product / (squares[0] * squares[1]).sqrt(), level]
    };
    let check = |[correlation, level]: [f64; 2]| correlation < -0.3 && level < 0.0;
    assert!(check(moments(0.9)), "{:?}", moments(0.9));
    assert!(!check(moments(-0.9)), "{:?}", moments(-0.9));
    // −λ Σ k E, by the cells and by our integral; twenty seas know it to some per cent.
    let sum: f64 = energies.iter().zip(patch.wave_vectors()).map(|(e, (x, y))| -0.9 * e * x.hypot(y)).sum();
    near(moments(0.9)[1], sum, 0.1);
    // The square grid's corners hold a little beyond the circle.
    near(waves::chop_level_m(&OracleSea, f64::INFINITY, 64.0 * patch.dk()[0] / 2.0, 0.9), sum, 0.02);
}

#[test]
fn deep_waters_chop_on_a_shelf() {
    // Waves about 46 m long over 5 m: water goes to and fro by coth kh, 1.7 times as far as up and down.
    let (patch, depth_m) = (patch(300.0), 5.0);
    let energies = cell_energies(&OracleSea, patch);
    let omegas = waves::angular_frequencies(patch, depth_m);
    let level = |depth_m: f64| {
        let mean_of = |seed| {
            let f = surface::fields_at(&amplitudes(&energies, seed, 0, patch), patch, depth_m, &omegas, 0.0);
            f.eta.iter().enumerate().map(|(i, eta)| eta * f.chop_gradient(i, 0.9).jacobian()).sum::<f64>()
        };
        (0..20).map(mean_of).sum::<f64>() / (20 * patch.count()) as f64
    };
    // −λ Σ k coth kh E, by the cells.
    let wave = |(e, (x, y)): (&f64, (f64, f64))| {
        let k = x.hypot(y);
        if k > 0.0 { -0.9 * e * k / (k * depth_m).tanh() } else { 0.0 }
    };
    let sum: f64 = energies.iter().zip(patch.wave_vectors()).map(wave).sum();
    let [ours, theirs] = [level(depth_m), level(f64::INFINITY)];
    println!("{ours:.4} m by the surface, {sum:.4} m by the sum, {theirs:.4} m with deep water's chop");
    // Twenty seas know it to some per cent.
    near(ours, sum, 0.1);
    assert!((theirs / sum - 1.0).abs() > 0.2, "{theirs} with deep water's chop");
    // The integral begins with longer waves than the patch holds, of a thousandth of the energy.
    near(waves::chop_level_m(&OracleSea, depth_m, 64.0 * patch.dk()[0] / 2.0, 0.9), sum, 0.03);
}

/// Slope along the heading of a Gerstner wave of steepness `ak` at a phase, and the exact one.
fn gerstner(heading: f64, ak: f64, phase: f64, slope: impl Fn(ChopGradient, [f64; 2]) -> [f64; 2]) -> [f64; 2] {
    let (sin, cos) = heading.sin_cos();
    // eta = a cos, D = −a k̂ sin, so ∇D = −ak cos k̂k̂ and ∇eta = −ak sin k̂.
    let d = -ak * phase.cos();
    let gradient = ChopGradient::new(d * cos * cos, d * sin * sin, d * cos * sin, 1.0);
    let [x, y] = slope(gradient, [-ak * phase.sin() * cos, -ak * phase.sin() * sin]);
    [x.hypot(y), (ak * phase.sin() / (1.0 - ak * phase.cos())).abs()]
}

#[test]
fn slopes_without_the_jacobian_or_with_its_diagonal() {
    let file: Value = serde_json::from_str(include_str!("../oracles/fft.json")).unwrap();
    let rows = file["gerstner_slope"]["rows"].as_array().unwrap();
    assert!(rows.len() >= 24);
    let check = |slope: &dyn Fn(ChopGradient, [f64; 2]) -> [f64; 2]| {
        rows.iter().all(|row| {
            let at = |key: &str| row[key].as_f64().unwrap();
            let [got, exact] = gerstner(at("heading_deg").to_radians(), at("ak"), at("phase"), slope);
            (exact - at("exact_mag")).abs() < 1e-12 && (got - exact).abs() < 1e-12
        })
    };
    let without = |_: ChopGradient, slope: [f64; 2]| slope;
    let diagonal = |g: ChopGradient, [x, y]: [f64; 2]| [x / g.xx, y / g.yy];
    assert!(check(&|g, [x, y]| g.true_slope(x, y)));
    assert!(!check(&without) && !check(&diagonal));
    // ak = 0.6 at 45 degrees.
    let at_45 = |slope: &dyn Fn(ChopGradient, [f64; 2]) -> [f64; 2]| gerstner(TAU / 8.0, 0.6, 0.3, slope);
    assert!((at_45(&without)[0] - 0.177).abs() < 5e-4 && (at_45(&diagonal)[0] - 0.249).abs() < 5e-4);
    assert!((at_45(&without)[1] - 0.415).abs() < 5e-4);
    // Independent of the heading: only the whole matrix.
    let spread = |slope: &dyn Fn(ChopGradient, [f64; 2]) -> [f64; 2]| {
        let all = [0.0, 0.3, 0.8, 1.2, 2.0].map(|heading| gerstner(heading, 0.6, 0.3, slope)[0]);
        all.iter().fold(0.0f64, |a, b| a.max((b - all[0]).abs()))
    };
    assert!(spread(&|g, [x, y]| g.true_slope(x, y)) < 1e-12 && spread(&diagonal) > 0.1);
}

#[test]
fn folding_cascade_by_cascade() {
    // Two crests, each of which stands, in two cascades: together they fold.
    let (a, b) = ([-0.6, 0.0, 0.0], [-0.7, -0.1, 0.0]);
    let fold = |d: [f64; 3]| ChopGradient::new(d[0], d[1], d[2], 1.0);
    let summed = fold([a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
    // The truth: which way neighbours land, by finite differences of the summed map X = x + D at unit steps.
    let lands = |dx: f64, dy: f64| [dx * (1.0 + a[0] + b[0]), dy * (1.0 + a[1] + b[1])];
    let (east, north) = (lands(1.0, 0.0), lands(0.0, 1.0));
    let truth = east[0] * north[1] - east[1] * north[0];
    let check = |jacobian: f64| (jacobian - truth).abs() < 1e-12;
    assert!(check(summed.jacobian()) && summed.jacobian() < 0.0 && summed.min_eigenvalue() < 0.0);
    let (j1, j2) = (fold(a).jacobian(), fold(b).jacobian());
    assert!(j1 > 0.0 && j2 > 0.0, "neither folds alone");
    for mistaken in [j1 * j2, j1 + j2 - 1.0, j1.min(j2)] {
        assert!(!check(mistaken), "{mistaken}");
    }
}

#[test]
fn hermite_weights_on_amplitudes() {
    let file: Value = serde_json::from_str(include_str!("../oracles/fft.json")).unwrap();
    let cross = &file["crossfade"];
    let variance = |[a, b]: [f64; 2]| a * a + b * b;
    let ours = |t: f64| {
        let w = optics::mix_weights(t, 0.0, 1.0);
        [w.fft, w.perlin]
    };
    let hermite = |t: f64| [1.0 - t * t * (3.0 - 2.0 * t), t * t * (3.0 - 2.0 * t)];
    let check = |weights: &dyn Fn(f64) -> [f64; 2]| {
        (0..=100).all(|i| (variance(weights(f64::from(i) / 100.0)) - 1.0).abs() < 1e-12)
    };
    assert!(check(&ours));
    assert!(!check(&hermite) && !check(&|t| [1.0 - t, t]));
    assert_eq!(variance(hermite(0.5)), cross["hermite_3t2_2t3_mid_variance"].as_f64().unwrap());
    assert_eq!(variance([0.5, 0.5]), cross["linear_mid_variance"].as_f64().unwrap());
    let mid = cross["power_complementary_mid_variance"].as_f64().unwrap();
    assert!((variance(ours(0.5)) - mid).abs() < 1e-12);
    for row in cross["table"].as_array().unwrap() {
        let [t, weight] = ["t", "hermite"].map(|key| row[key].as_f64().unwrap());
        assert!((hermite(t)[1] - weight).abs() < 1e-12);
        // The oracle's column blends linearly in the Hermite weight.
        assert!((variance(hermite(t)) - row["variance_linear_amp"].as_f64().unwrap()).abs() < 1e-12, "{row}");
    }
}

#[test]
fn frequencies_floored_to_a_loop() {
    let floored = |omega: f64, period: f64| (omega / (TAU / period)).floor() * (TAU / period);
    let check = |clock: &dyn Fn(f64) -> f64| [0.05, 0.5, 1.3, 20.0].iter().all(|&w| (clock(w) / w - 1.0).abs() < 1e-6);
    // Ours: the clock's own frequency, read off the phase that goes by in 1000 s.
    let ours = |omega: f64| waves::cycles_per_tick(omega) as f64 / 2f64.powi(64) * waves::TICKS_PER_SECOND * TAU;
    assert!(check(&ours));
    assert!(!check(&|omega| floored(omega, 200.0)));
    near(floored(0.5, 200.0) / 0.5 - 1.0, -0.058, 0.02);
    // A loop of 5 s freezes all waves slower than 1.26 rad/s: three quarters of the variance.
    let frozen = simpson(0.3, TAU / 5.0, 2000, OracleSea::frequency) / simpson(0.3, 20.0, 20_000, OracleSea::frequency);
    near(frozen, 0.75, 0.03);
}

#[test]
fn the_phase_in_single_precision() {
    // A day at 20 rad/s or so: worst difference of the phase from the exact one.
    let exact = |omega: f64, seconds: f64| (omega * seconds).rem_euclid(TAU);
    let worst = |phase: &dyn Fn(f64, f64) -> f64| {
        let off = |i: i32| {
            let (omega, seconds) = (1.0 + 0.013 * f64::from(i), 86_400.0 + 0.37 * f64::from(i));
            let d = (phase(omega, seconds) - exact(omega, seconds)).rem_euclid(TAU);
            d.min(TAU - d)
        };
        (0..100).map(off).fold(0.0, f64::max)
    };
    let ours =
        |omega: f64, seconds: f64| surface::phase_at(waves::cycles_per_tick(omega), waves::ticks_from_unix(seconds));
    let single = |omega: f64, seconds: f64| f64::from((omega as f32) * (seconds as f32)).rem_euclid(TAU);
    // A tick is a microsecond: half of it is 1e-6 rad at 2.3 rad/s.
    let check = |worst: f64| worst < 1e-5;
    assert!(check(worst(&ours)), "{}", worst(&ours));
    assert!(!check(worst(&single)));
    // Half a unit in the last place of 2e5 is 0.008; the frequency's own rounding goes on growing with the time.
    assert!((0.005..0.08).contains(&worst(&single)), "{}", worst(&single));
}

#[test]
fn the_local_wave_number_times_the_distance() {
    // A beach of 1 in 50 seen from 1 km: depth falls from 20 m to 0.5 m.
    let (omega, depth) = (TAU / 10.0, |x: f64| 20.0 - 0.02 * x);
    let k = |x: f64| dispersion::wavenumber(omega, depth(x));
    let integral = |x: f64| simpson(0.0, x, 400, k);
    let product = |x: f64| k(x) * x;
    let ratio = |phase: &dyn Fn(f64) -> f64, x: f64| (phase(x + 0.01) - phase(x - 0.01)) / 0.02 / k(x);
    // The crests' spacing must be that of the local wave number.
    let check =
        |phase: &dyn Fn(f64) -> f64| [100.0, 500.0, 900.0, 970.0].iter().all(|&x| (ratio(phase, x) - 1.0).abs() < 1e-3);
    assert!(check(&integral));
    assert!(!check(&product));
    // d(kx)/dx = k + x dk/dx: where 1 km of beach has a depth of 0.2 m left, 50 times too much.
    assert!(ratio(&product, 990.0) > 30.0, "{}", ratio(&product, 990.0));
}

#[test]
fn schlick_from_below_with_the_wrong_cosine() {
    let check = |below: &dyn Fn(f64) -> f64| {
        // Against Fresnel, before the critical angle of 48.6 degrees and past it.
        [10.0f64, 30.0, 45.0, 47.0, 50.0, 70.0].iter().all(|degrees| {
            let cos = degrees.to_radians().cos();
            (below(cos) - optics::fresnel(cos, 1.333, 1.0).unpolarised()).abs() < 0.04
        })
    };
    assert!(check(&|cos| optics::schlick_from_below(cos, 1.333, 1.0)));
    let mistaken = |cos: f64| optics::schlick(cos, optics::r0(1.333, 1.0));
    assert!(!check(&mistaken));
    near(mistaken(50f64.to_radians().cos()), 0.026, 0.02);
    assert_eq!(optics::schlick_from_below(50f64.to_radians().cos(), 1.333, 1.0), 1.0);
}

#[test]
fn foam_that_fades_by_the_frame() {
    let lifetime = 3.5;
    let after = |step: &dyn Fn(f64, f64) -> f64, frames: u32| {
        (0..frames).fold(1.0, |foam, _| step(foam, 7.0 / f64::from(frames)))
    };
    let ours = |foam: f64, dt: f64| foam::relaxed(foam, 0.1, dt, lifetime);
    let euler = |foam: f64, dt: f64| foam + (0.1 - foam) * dt / lifetime;
    let check = |step: &dyn Fn(f64, f64) -> f64| {
        let rates = [1, 7, 70, 1000].map(|frames| after(step, frames));
        rates.iter().all(|foam| (foam / rates[0] - 1.0).abs() < 1e-12)
    };
    assert!(check(&ours));
    assert!(!check(&euler));
    near(ours(1.0, lifetime), 0.1 + 0.9 / std::f64::consts::E, 1e-12);
    assert!(after(&euler, 1) < 0.0, "and a long frame makes it negative");
    assert_eq!(foam::relaxed(1.0, 0.1, 5.0, 0.0), 0.1);
}

#[test]
fn fetch_in_kilometres_and_a_cube_root_forgotten() {
    let file: Value = serde_json::from_str(include_str!("../oracles/spectra.json")).unwrap();
    let rows = file["jonswap_fetch"]["rows"].as_array().unwrap();
    assert!(rows.len() > 3);
    let g = ocean_globe::model::GRAVITY;
    let check = |peak: &dyn Fn(f64, f64) -> f64| {
        rows.iter().all(|row| {
            let at = |key: &str| row[key].as_f64().unwrap();
            let want = row["third"]["omega_p"].as_f64().unwrap();
            (peak(at("U10"), at("fetch_m")) / want - 1.0).abs() < 1e-9
        })
    };
    let ours = |u: f64, fetch_m: f64| 22.0 * (g * g / (u * fetch_m)).cbrt();
    assert!(check(&ours));
    assert!(!check(&|u, fetch_m| ours(u, fetch_m / 1000.0)));
    assert!(!check(&|u, fetch_m| 22.0 * g * g / (u * fetch_m)));
    // The sea of these tests has its peak where the table says.
    assert!((OracleSea.peak_period() / (TAU / ours(10.0, 1e5)) - 1.0).abs() < 1e-12);
    near(OracleSea.significant_height(), 2.138_896_952_250_544, 1e-4);
}
