//! A sea: what decides the shape of its waves.
//!
//! The wind sea's height is the Beaufort table's for the wind, and its peak that of [Toba's law](sea_state::peak_period) for both,
//! whatever the spectrum. If a fetch is given, height and peak are those of [JONSWAP's growth](Jonswap::from_fetch) over that fetch, or
//! over the shorter one that grows the sea fully; Pierson and Moskowitz's and Elfouhaily's then have the peak that their own growth gives
//! to the height. TMA is the JONSWAP sea *run onto a shelf* of [`SHELF_DEPTH_M`], so that it is lower there. Short waves have the slopes
//! that [Cox and Munk](crate::bibliography::CoxMunk1954) measured. A swell adds its energy. Sines and Gerstner waves share out the energy of the
//! JONSWAP sea.

use super::modes::{self, Mode};
use super::spectrum::{
    DAMPING_M, Directed, DirectionalSpectrum, Elfouhaily, Equilibrium, Jonswap, Phillips, PiersonMoskowitz, SlopeTrue,
    SwellTrain, TAIL_START, Tma,
};
use super::{optics, quadrature::simpson_log, sea_state, spreading::DonelanBanner};

pub use super::sea_spectrum::{SeaSpectrum, WindSpectrum};

/// Depth of the shelf under a TMA sea, m: that of the inner shelf, where the sea's longest waves feel the ground from grade 4 on.
pub const SHELF_DEPTH_M: f64 = 15.0;

/// The shape of the wave spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpectrumKind {
    /// Phillips' equilibrium form with Tessendorf's long-wave cut.
    Phillips,
    /// Pierson and Moskowitz: a fully grown sea.
    PiersonMoskowitz,
    /// JONSWAP: a sea that grows with fetch.
    #[default]
    Jonswap,
    /// TMA: JONSWAP in shallow water.
    Tma,
    /// Elfouhaily and others: one spectrum from swell to ripples.
    Elfouhaily,
    /// A sum of sines, see [`super::modes`].
    Sines,
    /// A sum of Gerstner waves, likewise.
    Gerstner,
}

impl SpectrumKind {
    /// Every spectrum with its name in links.
    pub const ALL: [(Self, &'static str); 7] = [
        (Self::Phillips, "phillips"),
        (Self::PiersonMoskowitz, "pierson-moskowitz"),
        (Self::Jonswap, "jonswap"),
        (Self::Tma, "tma"),
        (Self::Elfouhaily, "elfouhaily"),
        (Self::Sines, "sines"),
        (Self::Gerstner, "gerstner"),
    ];

    /// The wave number in those of the peak from which on a spectrum draws the wind's waves; [`modes`] are the longer ones.
    pub fn ripples_from(self) -> f64 {
        if matches!(self, Self::Sines | Self::Gerstner) { TAIL_START } else { 0.0 }
    }
}

/// A swell in the frame of the waves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swell {
    /// Significant height, m.
    pub height_m: f64,
    /// Period of its peak, s.
    pub period_s: f64,
    /// Where it travels TO, radians counter-clockwise from downwind.
    pub toward: f64,
}

/// The sea: everything that decides the shape of the waves but not the wind's direction or the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sea {
    /// Wind speed, m/s.
    pub speed_mps: f64,
    /// Significant height of wind sea and swell together, m.
    pub hs_m: f64,
    /// Chooses one sea among the equally likely.
    pub seed: u32,
    /// λ of the choppy displacement X = x + λD; 0 for none. Does not enter the amplitudes. [`Sea::new`] lets sines have none, and
    /// Gerstner waves no more than keeps them from folding.
    pub chop: f64,
    /// The wind sea's spectrum.
    pub kind: SpectrumKind,
    /// Distance over which the wind has blown, m; `None`: the Beaufort table's sea.
    pub fetch_m: Option<f64>,
    /// Depth for the waves' speed, m; infinite but for [`SpectrumKind::Tma`].
    pub depth_m: f64,
    /// A swell, whose height [`Sea::hs_m`] contains.
    pub swell: Option<Swell>,
}

impl Sea {
    /// The sea that a wind speed in m/s raises, with the Beaufort table's height: the usual spectrum, deep water.
    pub fn from_wind(speed_mps: f64, seed: u32, chop: f64) -> Self {
        Self {
            speed_mps,
            hs_m: sea_state::significant_height(speed_mps),
            seed,
            chop,
            kind: SpectrumKind::default(),
            fetch_m: None,
            depth_m: f64::INFINITY,
            swell: None,
        }
    }

    /// The sea of a wind speed in m/s, a spectrum, a fetch in m (one that is not positive counts as none) and a swell.
    pub fn new(
        speed_mps: f64,
        kind: SpectrumKind,
        fetch_m: Option<f64>,
        swell: Option<Swell>,
        seed: u32,
        chop: f64,
    ) -> Self {
        let fetch_m = fetch_m.filter(|&fetch| usable(fetch) > 0.0);
        let swell = swell.filter(|swell| usable(swell.height_m) > 0.0 && usable(swell.period_s) > 0.0);
        let depth_m = if kind == SpectrumKind::Tma { SHELF_DEPTH_M } else { f64::INFINITY };
        let mut sea = Self { kind, fetch_m, depth_m, ..Self::from_wind(speed_mps, seed, chop) };
        if let Some(deep) = sea.grown() {
            sea.hs_m = match (kind, fetch_m) {
                (SpectrumKind::Tma, _) => quick_height(&directed(Tma::new(deep, depth_m))),
                (_, Some(_)) => deep.height(),
                (_, None) => sea.hs_m,
            };
        }
        if let Some(swell) = swell {
            sea.hs_m = libm::sqrt(sea.hs_m * sea.hs_m + swell.height_m * swell.height_m);
        }
        let mut sea = Self { swell, ..sea };
        sea.chop = match kind {
            SpectrumKind::Sines => 0.0,
            SpectrumKind::Gerstner => chop.min(modes::sharpest_chop(&sea.modes())),
            _ => chop,
        };
        sea
    }

    /// Significant height of the wind sea alone, m.
    pub fn wind_height_m(&self) -> f64 {
        match self.swell {
            // Not through a square and its root: without a swell it is exactly hs_m.
            None => self.hs_m,
            Some(swell) => libm::sqrt((self.hs_m * self.hs_m - swell.height_m * swell.height_m).max(0.0)),
        }
    }

    /// The JONSWAP sea of this wind in deep water: of its fetch, or of the table's height; `None` for a calm.
    pub fn grown(&self) -> Option<Jonswap> {
        self.grown_to(sea_state::significant_height(self.speed_mps))
    }

    /// As [`Sea::grown`], with a height in m in place of the table's.
    fn grown_to(&self, hs_m: f64) -> Option<Jonswap> {
        let u10 = usable(self.speed_mps);
        // Below 1 mm/s the formulas leave f64's range before the sea leaves a calm.
        if u10 < 1e-3 || hs_m <= 0.0 {
            return None;
        }
        Some(match self.fetch_m {
            Some(fetch) => Jonswap::from_fetch(u10, fetch.min(Jonswap::longest_fetch(u10))),
            None => Jonswap::from_height(hs_m, sea_state::peak_period(u10, hs_m)),
        })
    }

    /// The single waves that this wind sea is drawn as; none where a whole spectrum is.
    pub fn modes(&self) -> Vec<Mode> {
        modes::modes(self)
    }

    /// What is drawn of this sea besides its [`Sea::modes`]: its spectrum, of which those leave the swell and the wind's ripples.
    pub fn drawn_spectrum(&self) -> SeaSpectrum {
        let spectrum = self.spectrum();
        SeaSpectrum { wind_from: self.kind.ripples_from() * spectrum.wind.peak_wavenumber(), ..spectrum }
    }

    /// The spectrum of this sea, wind sea and swell. Its significant height is [`Sea::hs_m`].
    pub fn spectrum(&self) -> SeaSpectrum {
        let swell = self.swell.and_then(|s| SwellTrain::new(s.height_m, s.period_s, s.toward, self.depth_m));
        SeaSpectrum { wind: self.wind_spectrum(), wind_from: 0.0, swell, depth_m: self.depth_m }
    }

    fn wind_spectrum(&self) -> WindSpectrum {
        let (u10, hs) = (usable(self.speed_mps), usable(self.wind_height_m()));
        let mss = optics::cox_munk_mss(u10).total;
        // On a shelf the height is lower than that of the sea that has run onto it.
        let grown = if self.kind == SpectrumKind::Tma { self.grown() } else { self.grown_to(hs) };
        let Some(grown) = grown.filter(|_| hs > 0.0) else {
            return WindSpectrum::Phillips(Phillips::CALM);
        };
        match self.kind {
            SpectrumKind::PiersonMoskowitz => {
                let sea = match self.fetch_m {
                    Some(_) => PiersonMoskowitz::from_height(hs),
                    None => PiersonMoskowitz::from_peak(grown.omega_p),
                };
                WindSpectrum::PiersonMoskowitz(SlopeTrue::new(directed(sea), hs, mss, DAMPING_M))
            }
            SpectrumKind::Jonswap | SpectrumKind::Sines | SpectrumKind::Gerstner => {
                WindSpectrum::Jonswap(SlopeTrue::new(Equilibrium::new(directed(grown)), hs, mss, DAMPING_M))
            }
            SpectrumKind::Tma => {
                let sea = directed(Tma::new(grown, self.depth_m));
                WindSpectrum::Tma(SlopeTrue::new(sea, hs, mss, DAMPING_M))
            }
            SpectrumKind::Elfouhaily => {
                let sea = match self.fetch_m {
                    Some(_) => Elfouhaily::from_height(u10, hs),
                    None => Elfouhaily::from_peak(u10, grown.omega_p),
                };
                // It has its own end of the shortest waves.
                WindSpectrum::Elfouhaily(SlopeTrue::new(sea, hs, mss, 0.0))
            }
            SpectrumKind::Phillips => WindSpectrum::Phillips(Phillips::new(u10, hs, directed(grown).peak_wavenumber())),
        }
    }
}

/// A speed or length, 0 if it is negative or not finite.
fn usable(x: f64) -> f64 {
    if x.is_finite() { x.max(0.0) } else { 0.0 }
}

fn directed<F>(frequency: F) -> Directed<F, DonelanBanner> {
    Directed { frequency, spreading: DonelanBanner }
}

/// Hs in m within 1e-4: a sea is looked up in every frame.
fn quick_height(spectrum: &impl DirectionalSpectrum) -> f64 {
    let peak = spectrum.peak_wavenumber();
    let part = |from: f64, to: f64| simpson_log(from * peak, to * peak, 64, |k| spectrum.omnidirectional(k));
    4.0 * libm::sqrt(part(0.1, 1.0) + part(1.0, 5.0) + part(5.0, 1e3))
}
