//! The sea that the settings ask for.

use std::sync::Arc;

use crate::model::sea::{Sea, Swell};
use crate::model::sea_tables::SeaTables;
use crate::scene::settings::{Quality, Settings};

/// Samples along a side of a wave patch. All have the same patches; from 256 on finer ones add shorter waves and change no other.
pub fn patch_samples(quality: Quality) -> usize {
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
    /// The tables of the sea that `settings` ask for. [`Seas`](crate::scene::sea::Seas) keeps them.
    pub fn of(settings: &Settings) -> Arc<Self> {
        Arc::new(Self::new(sea_of(settings), patch_samples(settings.quality)))
    }
}
