//! What the renderer needs to know of a sea, worked out once for each sea.

use std::sync::{Arc, Mutex};

use crate::model::perlin::Octaves;
use crate::model::quadrature::simpson_log;
use crate::model::sea::{Sea, Swell};
use crate::model::spectrum::DirectionalSpectrum;
use crate::model::waves::{self, CASCADES, Cascade};

use super::settings::{Quality, Settings};

/// A sea with its tiles and integrals. Slopes are variances along the wind and across it.
#[derive(Clone, Debug, PartialEq)]
pub struct SeaTables {
    /// The sea itself.
    pub sea: Sea,
    /// Period of its spectrum's peak, s; 0 for a calm.
    pub peak_period_s: f64,
    /// Its wave tiles, longest first.
    pub cascades: [Cascade; CASCADES],
    /// Slopes of each tile's waves.
    pub cascade_slopes: [[f64; 2]; CASCADES],
    /// Slopes of the waves that are shorter than the tiles hold.
    pub below_slopes: [f64; 2],
    /// Mean level of the choppy tiles, metres, at most 0: subtracted from what they draw, see [`waves::chop_level_m`].
    pub chop_level_m: f64,
    /// The far sea.
    pub perlin: Octaves,
}

/// Samples along a side of a wave tile. All have the same tiles; from 256 on finer ones add shorter waves and change no other.
pub fn tile_samples(quality: Quality) -> usize {
    match quality {
        Quality::Low => 128,
        Quality::Auto | Quality::Medium => 256,
        Quality::High => 512,
        Quality::Ultra => 1024,
        Quality::Extreme => 2048,
    }
}

/// The sea that `settings` ask for. A swell's direction becomes one in the frame of the waves: compass bearings FROM run clockwise,
/// angles TO counter-clockwise, so that their difference is the wind's less the swell's.
pub fn sea_of(settings: &Settings) -> Sea {
    let wind_from_deg = settings.wind.from_deg;
    let swell = settings.swell.map(|swell| Swell {
        height_m: swell.height_m,
        period_s: swell.period_s,
        toward: (wind_from_deg - swell.from_deg).to_radians(),
    });
    let fetch_m = settings.fetch_km.map(|km| km * 1000.0);
    Sea::new(settings.wind_speed_mps(), settings.spectrum, fetch_m, swell, settings.seed, settings.chop)
}

impl SeaTables {
    /// The tables of the sea that `settings` ask for; those of the last sea are kept.
    pub fn of(settings: &Settings) -> Arc<Self> {
        static LAST: Mutex<Option<Arc<SeaTables>>> = Mutex::new(None);
        let sea = sea_of(settings);
        let n = tile_samples(settings.quality);
        let mut last = LAST.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        match last.as_ref().filter(|kept| kept.sea == sea && kept.cascades[0].n == n) {
            Some(kept) => kept.clone(),
            None => last.insert(Arc::new(Self::new(sea, n))).clone(),
        }
    }

    /// The tables of a sea on tiles of `n` by `n` samples.
    pub fn new(sea: Sea, n: usize) -> Self {
        let spectrum = sea.spectrum();
        let cascades = waves::cascades(n);
        let cascade_slopes = std::array::from_fn(|i| slopes_between(&spectrum, cascades[i].k_min, cascades[i].k_max));
        let below_slopes = slopes_between(&spectrum, cascades[CASCADES - 1].k_max, f64::INFINITY);
        let chop_level_m = waves::chop_level_m(&spectrum, cascades[CASCADES - 1].k_max, sea.chop);
        let (peak_period_s, perlin) = (spectrum.peak_period(), Octaves::default());
        let mut tables = Self { sea, peak_period_s, cascades, cascade_slopes, below_slopes, chop_level_m, perlin };
        tables.perlin = Octaves::of(&spectrum, tables.slopes());
        tables
    }

    /// Slopes of the whole sea.
    pub fn slopes(&self) -> [f64; 2] {
        self.cascade_slopes.iter().fold(self.below_slopes, |sum, t| [sum[0] + t[0], sum[1] + t[1]])
    }

    /// Mean-square slope of the whole sea, both axes together.
    pub fn mean_square_slope(&self) -> f64 {
        self.slopes().iter().sum()
    }

    /// ω of every element of one of the tiles, rad/s, over this sea's depth.
    pub fn frequencies(&self, cascade: &Cascade) -> Vec<f64> {
        waves::angular_frequencies(cascade, self.sea.depth_m)
    }
}

/// ∫∫ (kx², ky²) F d²k over k0 ≤ |k| < k1.
fn slopes_between(spectrum: &dyn DirectionalSpectrum, k0: f64, k1: f64) -> [f64; 2] {
    const ANGLES: usize = 48;
    // Waves of 600 km and of 1.6 mm: the range of the spectra's own integrals.
    let (k0, k1) = (k0.max(1e-5), k1.min(4e3));
    let integral = |part: fn(f64, f64) -> f64| {
        simpson_log(k0, k1, 64, |k| {
            let ring = (0..ANGLES).map(|i| {
                let (sin, cos) = libm::sincos(std::f64::consts::TAU * (i as f64 + 0.5) / ANGLES as f64);
                part(cos, sin) * spectrum.density(k * cos, k * sin)
            });
            k * k * k * ring.sum::<f64>() * std::f64::consts::TAU / ANGLES as f64
        })
    };
    [integral(|cos, _| cos * cos), integral(|_, sin| sin * sin)]
}
