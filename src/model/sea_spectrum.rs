//! The spectrum of a whole sea: the wind's waves, whichever their shape, and a swell.

use super::spectrum::{
    Directed, DirectionalSpectrum, Elfouhaily, Equilibrium, Jonswap, Phillips, PiersonMoskowitz, SlopeTrue, SwellTrain,
    Tma,
};
use super::{dispersion, spreading::DonelanBanner};

/// The spectrum of a wind sea.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WindSpectrum {
    /// Of [`SpectrumKind::Phillips`](super::sea::SpectrumKind::Phillips), and of every calm.
    Phillips(Phillips),
    /// Of [`SpectrumKind::PiersonMoskowitz`](super::sea::SpectrumKind::PiersonMoskowitz).
    PiersonMoskowitz(SlopeTrue<Directed<PiersonMoskowitz, DonelanBanner>>),
    /// Of [`SpectrumKind::Jonswap`](super::sea::SpectrumKind::Jonswap).
    Jonswap(SlopeTrue<Equilibrium<Directed<Jonswap, DonelanBanner>>>),
    /// Of [`SpectrumKind::Tma`](super::sea::SpectrumKind::Tma).
    Tma(SlopeTrue<Directed<Tma, DonelanBanner>>),
    /// Of [`SpectrumKind::Elfouhaily`](super::sea::SpectrumKind::Elfouhaily).
    Elfouhaily(SlopeTrue<Elfouhaily>),
}

/// Calls a method of whichever spectrum it is; through an enum, so that a sea stays `Copy` and its inner loops without pointers.
macro_rules! each {
    ($self:expr, $sea:ident => $call:expr) => {
        match $self {
            WindSpectrum::Phillips($sea) => $call,
            WindSpectrum::PiersonMoskowitz($sea) => $call,
            WindSpectrum::Jonswap($sea) => $call,
            WindSpectrum::Tma($sea) => $call,
            WindSpectrum::Elfouhaily($sea) => $call,
        }
    };
}

impl DirectionalSpectrum for WindSpectrum {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        each!(self, sea => sea.density(kx, ky))
    }

    fn peak_wavenumber(&self) -> f64 {
        each!(self, sea => sea.peak_wavenumber())
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        each!(self, sea => sea.omnidirectional(k))
    }

    fn peak_period(&self) -> f64 {
        each!(self, sea => sea.peak_period())
    }
}

/// Wind sea and swell: their energies add up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeaSpectrum {
    /// The wind sea.
    pub wind: WindSpectrum,
    /// The wave number from which on the wind sea has energy, rad/m; 0 for all of it.
    pub wind_from: f64,
    /// The swell.
    pub swell: Option<SwellTrain>,
    /// Depth of the water, m.
    pub depth_m: f64,
}

impl SeaSpectrum {
    /// The swell, where the frequency spectrum's highest point is its peak.
    fn leading_swell(&self) -> Option<&SwellTrain> {
        let height = |part: &dyn DirectionalSpectrum| {
            let k = part.peak_wavenumber();
            // S(ω) = ∫F k dθ / (dω/dk).
            if k > 0.0 { self.omnidirectional(k) / dispersion::group_velocity(k, self.depth_m) } else { 0.0 }
        };
        self.swell.as_ref().filter(|swell| height(*swell) >= height(&self.wind))
    }
}

impl DirectionalSpectrum for SeaSpectrum {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        let is_ripple = self.wind_from <= 0.0 || kx * kx + ky * ky >= self.wind_from * self.wind_from;
        let wind = if is_ripple { self.wind.density(kx, ky) } else { 0.0 };
        self.swell.map_or(wind, |swell| wind + swell.density(kx, ky))
    }

    /// Of the higher of the two peaks.
    fn peak_wavenumber(&self) -> f64 {
        self.leading_swell().map_or_else(|| self.wind.peak_wavenumber(), SwellTrain::peak_wavenumber)
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        let wind = if k >= self.wind_from { self.wind.omnidirectional(k) } else { 0.0 };
        self.swell.map_or(wind, |swell| wind + swell.omnidirectional(k))
    }

    fn peak_period(&self) -> f64 {
        self.leading_swell().map_or_else(|| self.wind.peak_period(), SwellTrain::peak_period)
    }
}
