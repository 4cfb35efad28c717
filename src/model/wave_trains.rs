//! The few trains that stand for a sea where it feels the bottom: each one frequency and one direction, all of the same energy.

use super::cascade::Cascade;
use super::sea_tables::SeaTables;
use super::spectrum::DirectionalSpectrum;
use super::{dispersion, noise};

/// How many.
pub const TRAINS: usize = 8;
/// Directions of each frequency.
const DIRECTIONS: usize = 2;
/// Trains take the waves of the first patches, those longer than 6 m, and of each patch's height, at most this share.
pub const TAKEN: [f64; 4] = [1.0, 0.9, 0.0, 0.0];

/// One of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Train {
    /// Angular frequency, rad/s.
    pub omega: f64,
    /// Where it travels to, radians counter-clockwise from downwind.
    pub toward: f64,
    /// Amplitude in deep water, m.
    pub amplitude_m: f64,
}

/// Variance of the waves that the trains take, m².
pub fn taken_m2(tables: &SeaTables) -> f64 {
    let spectrum = tables.sea.spectrum();
    let part =
        |(share, cascade): (f64, &Cascade)| share * share * spectrum.variance_between(cascade.k_min, cascade.k_max);
    TAKEN.into_iter().zip(&tables.cascades).filter(|(share, _)| *share > 0.0).map(part).sum()
}

/// The trains of a sea: at the middles of as many parts of equal energy, by frequency and then by direction, a little beside each other, so
/// that they pass through groups. `None` for a calm.
pub fn trains(tables: &SeaTables) -> Option<[Train; TRAINS]> {
    let spectrum = tables.sea.spectrum();
    let taken = taken_m2(tables);
    if taken < 1e-8 {
        return None;
    }
    let (k_min, k_max): (f64, f64) = (2e-4, tables.cascades[1].k_max);
    const STEPS: usize = 512;
    let k_at = |x: f64| k_min * libm::pow(k_max / k_min, x);
    let mut sum = 0.0;
    let sums: Vec<f64> = (0..STEPS)
        .map(|i| {
            let k = k_at((i as f64 + 0.5) / STEPS as f64);
            sum += k * spectrum.omnidirectional(k);
            sum
        })
        .collect();
    let parts = TRAINS / DIRECTIONS;
    let found = std::array::from_fn(|index| {
        let (part, side) = (index / DIRECTIONS, index % DIRECTIONS);
        // Some way beside the middle, so that both directions of a frequency beat.
        let jitter = |salt: u32| {
            f64::from((noise::bits(tables.sea.seed, 1_100 + salt, index as i32, 0)[0] >> 32) as u32) / 4_294_967_296.0
                - 0.5
        };
        let wanted = (part as f64 + 0.5 + 0.5 * jitter(0)) / parts as f64 * sum;
        let step = sums.partition_point(|sum| *sum < wanted).min(STEPS - 1);
        let before = if step > 0 { sums[step - 1] } else { 0.0 };
        let inside = (wanted - before) / (sums[step] - before).max(1e-300);
        let k = k_at((step as f64 + inside) / STEPS as f64);
        let share = (side as f64 + 0.5 + 0.3 * jitter(1)) / DIRECTIONS as f64;
        Train {
            omega: dispersion::omega_finite(k, tables.sea.depth_m),
            toward: direction(&spectrum, k, share),
            amplitude_m: libm::sqrt(2.0 * taken / TRAINS as f64),
        }
    });
    Some(found)
}

/// The direction on whose right a share of the energy of a wave number lies.
fn direction(spectrum: &impl DirectionalSpectrum, k: f64, share: f64) -> f64 {
    const STEPS: usize = 720;
    let at = |i: usize| std::f64::consts::TAU * ((i as f64 + 0.5) / STEPS as f64 - 0.5);
    let density: Vec<f64> = (0..STEPS)
        .map(|i| {
            let (sin, cos) = libm::sincos(at(i));
            spectrum.density(k * cos, k * sin)
        })
        .collect();
    // The circle is cut where the least is.
    let first = (0..STEPS).min_by(|&a, &b| density[a].total_cmp(&density[b])).unwrap_or(0);
    let total: f64 = density.iter().sum();
    let mut sum = 0.0;
    for i in (0..STEPS).map(|i| (first + i) % STEPS) {
        sum += density[i];
        if sum >= share * total {
            return at(i);
        }
    }
    0.0
}
