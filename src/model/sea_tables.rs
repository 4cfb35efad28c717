//! What follows from a sea once and for all: its wave patches, and the integrals of its spectrum that the shading needs.

use super::dispersion;
use super::perlin::Octaves;
use super::quadrature::simpson_log;
use super::sea::Sea;
use super::spectrum::DirectionalSpectrum;
use super::waves::{self, CASCADES, Cascade};

/// A sea with its patches and integrals. Slopes are variances along the wind and across it.
#[derive(Clone, Debug, PartialEq)]
pub struct SeaTables {
    /// The sea itself.
    pub sea: Sea,
    /// Period of its spectrum's peak, s; 0 for a calm.
    pub peak_period_s: f64,
    /// Its wave patches, longest first.
    pub cascades: [Cascade; CASCADES],
    /// Slopes of each patch's waves.
    pub cascade_slopes: [[f64; 2]; CASCADES],
    /// Slopes of the waves that are shorter than the patches hold.
    pub below_slopes: [f64; 2],
    /// Mean level of the choppy patches, metres, at most 0: subtracted from what they draw, see [`waves::chop_level_m`].
    pub chop_level_m: f64,
    /// The share of it that each patch makes; together 1, or 0 in a calm.
    pub cascade_levels: [f64; CASCADES],
    /// The share of the waves' energy that each patch holds; together 1, or 0 in a calm.
    pub cascade_shares: [f64; CASCADES],
    /// The far sea.
    pub perlin: Octaves,
}

impl SeaTables {
    /// The tables of a sea on patches of `n` by `n` samples.
    pub fn new(sea: Sea, n: usize) -> Self {
        let (spectrum, drawn, modes) = (sea.spectrum(), sea.drawn_spectrum(), sea.modes());
        let cascades = waves::cascades(n);
        // Simpson's rule wants no step inside its interval.
        let parts = |k0: f64, k1: f64| [[k0, k1.min(drawn.wind_from * (1.0 - 1e-12))], [k0.max(drawn.wind_from), k1]];
        let slopes = |k0, k1| {
            let [a, b] = parts(k0, k1).map(|[k0, k1]| slopes_between(&drawn, k0, k1));
            [a[0] + b[0], a[1] + b[1]]
        };
        let own = |i: usize| modes.iter().filter(move |mode| mode.cascade == i);
        let cascade_slopes = std::array::from_fn(|i| {
            own(i).fold(slopes(cascades[i].k_min, cascades[i].k_max), |sum, mode| {
                std::array::from_fn(|axis| sum[axis] + mode.wave_vector[axis].powi(2) * mode.variance())
            })
        });
        let k_max = cascades[CASCADES - 1].k_max;
        let below_slopes = slopes_between(&drawn, k_max, f64::INFINITY);
        let level: f64 = modes.iter().map(|mode| mode.wavenumber() * mode.variance()).sum();
        let chop_level_m = waves::chop_level_m(&drawn, sea.depth_m, k_max, sea.chop) - sea.chop * level;
        // Of height and of what draws the level down, by patch.
        let shares = |weight: &dyn Fn(f64) -> f64| {
            let between = |[k0, k1]: [f64; 2]| {
                if k0 >= k1 { 0.0 } else { simpson_log(k0, k1, 96, |k| weight(k) * drawn.omnidirectional(k)) }
            };
            let all_of = |i: usize| -> f64 {
                let single: f64 = own(i).map(|mode| weight(mode.wavenumber()) * mode.variance()).sum();
                single + parts(cascades[i].k_min.max(1e-4), cascades[i].k_max).map(between).iter().sum::<f64>()
            };
            let held: [f64; CASCADES] = std::array::from_fn(all_of);
            let all: f64 = held.iter().sum();
            held.map(|part| if all > 0.0 { part / all } else { 0.0 })
        };
        let (cascade_shares, cascade_levels) =
            (shares(&|_| 1.0), shares(&|k| k * dispersion::orbit_ratio(k, sea.depth_m)));
        let (peak_period_s, perlin) = (spectrum.peak_period(), Octaves::default());
        let mut tables = Self {
            sea,
            peak_period_s,
            cascades,
            cascade_slopes,
            below_slopes,
            chop_level_m,
            cascade_levels,
            cascade_shares,
            perlin,
        };
        tables.perlin = Octaves::of(&spectrum, tables.slopes());
        tables
    }

    /// How much higher the waves are than the open sea's where those of the patches are so by `gains`.
    pub fn height_gain(&self, gains: [f64; CASCADES]) -> f64 {
        let of_calm = if self.cascade_shares.iter().any(|share| *share > 0.0) { 0.0 } else { 1.0 };
        let energy: f64 = gains.iter().zip(self.cascade_shares).map(|(gain, share)| gain * gain * share).sum();
        libm::sqrt(energy + of_calm)
    }

    /// [`SeaTables::chop_level_m`] there, m.
    pub fn level_in_m(&self, gains: [f64; CASCADES]) -> f64 {
        let level: f64 = gains.iter().zip(self.cascade_levels).map(|(gain, share)| gain * gain * share).sum();
        level * self.chop_level_m
    }

    /// Slopes of the whole sea.
    pub fn slopes(&self) -> [f64; 2] {
        self.cascade_slopes.iter().fold(self.below_slopes, |sum, t| [sum[0] + t[0], sum[1] + t[1]])
    }

    /// Height over the mean level that next to no crest passes, m; no trough is so deep.
    pub fn crest_m(&self) -> f64 {
        1.2 * self.sea.hs_m
    }

    /// Whether another sea has the same waves on the same patches: it may differ in its chop.
    pub fn has_waves_of(&self, other: &Self) -> bool {
        Sea { chop: other.sea.chop, ..self.sea } == other.sea && self.cascades[0].n == other.cascades[0].n
    }

    /// Mean-square slope of the whole sea, both axes together.
    pub fn mean_square_slope(&self) -> f64 {
        self.slopes().iter().sum()
    }

    /// ω of every element of one of the patches, rad/s, over this sea's depth.
    pub fn frequencies(&self, cascade: &Cascade) -> Vec<f64> {
        waves::angular_frequencies(cascade, self.sea.depth_m)
    }
}

/// ∫∫ (kx², ky²) F d²k over k0 ≤ |k| < k1.
fn slopes_between(spectrum: &dyn DirectionalSpectrum, k0: f64, k1: f64) -> [f64; 2] {
    const ANGLES: usize = 48;
    // Waves of 600 km and of 1.6 mm: the range of the spectra's own integrals.
    let (k0, k1) = (k0.max(1e-5), k1.min(4e3));
    let directions: [(f64, f64); ANGLES] =
        std::array::from_fn(|i| libm::sincos(std::f64::consts::TAU * (i as f64 + 0.5) / ANGLES as f64));
    // The spectrum is what costs: both axes see the same densities, in the order in which the rule asks for them.
    let mut across = Vec::new();
    let ring = |k: f64, sum: f64| k * k * k * sum * std::f64::consts::TAU / ANGLES as f64;
    let along = simpson_log(k0, k1, 64, |k| {
        let [mut x, mut y] = [0.0; 2];
        for (sin, cos) in directions {
            let density = spectrum.density(k * cos, k * sin);
            x += cos * cos * density;
            y += sin * sin * density;
        }
        across.push(ring(k, y));
        ring(k, x)
    });
    let mut across = across.into_iter();
    [along, simpson_log(k0, k1, 64, |_| across.next().unwrap_or(0.0))]
}
