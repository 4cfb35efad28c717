//! The period of the waves at a place in a lee or on a lake.

use std::f64::consts::TAU;

use super::{Exposures, LocalSea};
use crate::model::dispersion;
use crate::model::sea_spectrum::SeaSpectrum;
use crate::model::spectrum::{DirectionalSpectrum, FrequencySpectrum, Jonswap};

/// The waves at a place, in parts whose energies add up.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LocalWaves {
    /// Shares of the open sea's wind sea and of its swell.
    open: [f64; 2],
    /// What the wind raises anew, and its share, for each fetch.
    grown: Vec<(f64, Jonswap)>,
}

impl LocalWaves {
    /// Adds a share of the waves of a place with these exposures, which hold what [`LocalSea::needs`].
    pub fn add(&mut self, share: f64, sea: &LocalSea, exposures: &Exposures) {
        for direction in sea.directions(exposures) {
            let [of_wind, of_swell] = direction.weights;
            self.open[0] += share * of_wind * direction.passed[0];
            self.open[1] += share * of_swell * direction.passed[1];
            let new = share * of_wind * (1.0 - direction.passed[0]);
            match sea.raised(direction.fetch_m) {
                _ if new <= 0.0 => {}
                Some(grown) => self.grown.push((new, grown)),
                None => self.open[0] += new,
            }
        }
    }

    /// Period of the highest of the parts' peaks in the frequency spectrum of all, s; `open` is the open sea's. 0 for a calm.
    pub fn peak_period(&self, open: &SeaSpectrum) -> f64 {
        let swell = open.swell.as_ref().map(|swell| swell as &dyn DirectionalSpectrum);
        let parts = [(self.open[0], Some(&open.wind as &dyn DirectionalSpectrum)), (self.open[1], swell)];
        let parts =
            parts.into_iter().filter_map(|(share, part)| Some((share, part?))).filter(|(share, _)| *share > 0.0);
        let density = |omega: f64| {
            // S(ω) = ∫F k dθ / (dω/dk).
            let k = dispersion::wavenumber(omega, open.depth_m);
            let of_open: f64 = parts.clone().map(|(share, part)| share * part.omnidirectional(k)).sum();
            let of_grown: f64 = self.grown.iter().map(|(share, grown)| share * grown.density(omega)).sum();
            of_open / dispersion::group_velocity(k, open.depth_m) + of_grown
        };
        let of_open = parts
            .clone()
            .map(|(_, part)| (dispersion::omega_finite(part.peak_wavenumber(), open.depth_m), part.peak_period()));
        let of_grown = self.grown.iter().map(|(_, grown)| (grown.omega_p, TAU / grown.omega_p));
        let peaks = of_open.chain(of_grown).filter(|(omega, _)| *omega > 0.0);
        let highest = peaks.map(|(omega, period)| (density(omega), period)).max_by(|a, b| a.0.total_cmp(&b.0));
        highest.map_or(0.0, |(_, period)| period)
    }
}
