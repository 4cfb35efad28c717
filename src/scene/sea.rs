//! What the renderer needs to know of a sea, worked out once for each sea.

use std::sync::{Arc, Mutex};

use crate::model::sea::{Sea, Swell};
use crate::model::spectrum::DirectionalSpectrum;
use crate::model::waves::{self, Cascade};

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
}

/// Samples along a side of a wave tile.
pub fn tile_samples(quality: Quality) -> usize {
    match quality {
        Quality::Low => 128,
        _ => 256,
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
        let peak = spectrum.peak_wavenumber();
        Self {
            sea,
            cascades: waves::cascades(&sea, n),
            slope_variance: std::array::from_fn(|i| spectrum.mss_above((0.5 * i as f64 - 8.0).exp2()) as f32),
            peak_wavelength_m: if peak > 0.0 { std::f64::consts::TAU / peak } else { 0.0 },
        }
    }
}
