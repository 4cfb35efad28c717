//! What the renderer needs to know of a sea, worked out once for each sea.

use std::sync::{Arc, Mutex};

use crate::model::spectrum::DirectionalSpectrum;
use crate::model::waves::{self, Cascade, Sea};

use super::settings::{Quality, Settings};

/// Number of wavenumbers at which [`SeaTables::slope_variance`] is tabulated.
pub const SLOPE_SAMPLES: usize = 32;

/// A sea with its tiles and integrals.
#[derive(Clone, Debug, PartialEq)]
pub struct SeaTables {
    /// The sea itself.
    pub sea: Sea,
    /// Its wave tiles, longest first.
    pub cascades: Vec<Cascade>,
    /// Mean-square slope of the waves shorter than wavenumber 2^(i/2 − 8) rad/m.
    pub slope_variance: [f32; SLOPE_SAMPLES],
    /// Wavelength of the spectrum's peak, metres; 0 for a calm.
    pub peak_wavelength_m: f64,
    /// Mean level of the choppy tiles, metres, at most 0: subtracted from what they draw, see [`waves::chop_level_m`].
    pub chop_level_m: f64,
}

/// Samples along a side of a wave tile.
pub fn tile_samples(quality: Quality) -> usize {
    match quality {
        Quality::Low => 128,
        _ => 256,
    }
}

impl SeaTables {
    /// The tables of the sea that `settings` ask for; those of the last sea are kept.
    pub fn of(settings: &Settings) -> Arc<Self> {
        static LAST: Mutex<Option<Arc<SeaTables>>> = Mutex::new(None);
        let sea = Sea::from_wind(settings.wind_speed_mps(), settings.seed, settings.chop);
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
        let peak = spectrum.peak_wavenumber();
        let cascades = waves::cascades(&sea, n);
        let k_max = cascades.last().map_or(0.0, |last| last.k_max);
        Self {
            sea,
            chop_level_m: waves::chop_level_m(&spectrum, k_max, sea.chop),
            cascades,
            slope_variance: std::array::from_fn(|i| spectrum.mss_above((0.5 * i as f64 - 8.0).exp2()) as f32),
            peak_wavelength_m: if peak > 0.0 { std::f64::consts::TAU / peak } else { 0.0 },
        }
    }

    /// ω of every element of one of the tiles, rad/s, over this sea's depth.
    pub fn frequencies(&self, cascade: &Cascade) -> Vec<f64> {
        waves::angular_frequencies(cascade, f64::INFINITY)
    }
}
