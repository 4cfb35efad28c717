//! The user's choices: wind, sea, quality, layers. Defaults and ranges are those of the link format.

use crate::data::geoid;
pub use crate::model::sea::SpectrumKind as Spectrum;
use crate::model::sea_bed::{USUAL_SLOPE, smoothstep};
use crate::model::sea_state;
use crate::scene::layers::{Layer, Layers};

/// The wind at 10 m over the sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wind {
    /// Speed in m/s, 0 to 60.
    pub speed_mps: f64,
    /// Where the wind comes FROM, degrees clockwise from north, `[0, 360)` (the meteorologist's convention).
    pub from_deg: f64,
}

impl Default for Wind {
    fn default() -> Self {
        Self { speed_mps: 8.0, from_deg: 250.0 }
    }
}

/// A swell from a far storm, on top of the wind sea.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swell {
    /// Significant height in metres, 0 to 20.
    pub height_m: f64,
    /// Period in seconds, 3 to 30.
    pub period_s: f64,
    /// Where it comes FROM, degrees clockwise from north.
    pub from_deg: f64,
}

/// Where foam lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FoamRule {
    /// Where the chop folds the surface; it grows, stays behind and fades.
    #[default]
    Folding,
    /// On high water: saturate((H − H0)/(Hmax − H0)), with no memory.
    Height,
}

/// Whitecaps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foam {
    /// Amount, 1 = the share that is measured at sea in such a wind; 0 to 3.
    pub amount: f64,
    /// Time in seconds after which a patch has faded to 1/e, 0.1 to 60.
    pub lifetime_s: f64,
    /// Where it lies.
    pub rule: FoamRule,
}

impl Default for Foam {
    fn default() -> Self {
        Self { amount: 1.0, lifetime_s: 3.5, rule: FoamRule::default() }
    }
}

/// How the surface of the sea is cut into triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mesh {
    /// A grid on the screen projected onto the ellipsoid.
    #[default]
    Grid,
    /// Triangles bisected on the GPU.
    Bisect,
}

impl Mesh {
    /// Every mesh with its name in links.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Grid, "grid"), (Self::Bisect, "bisect")];
}

/// How fine the bisected mesh is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangles {
    /// Length that their bases shall have on the screen, pixels, 2 to 64.
    pub pixels: f64,
    /// How many there are at most, 1,000 to 1,000,000: where more would be needed, all become coarser.
    pub budget: u32,
}

impl Default for Triangles {
    fn default() -> Self {
        Self { pixels: 6.0, budget: 200_000 }
    }
}

/// How much the picture may cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quality {
    /// Chosen by the program: [`Quality::High`] on a graphics card, [`Quality::Medium`] where the processor draws.
    #[default]
    Auto,
    /// For weak devices: triangles are twice as wide, nothing glows or sparkles, no light comes through crests, waters do not bloom.
    Low,
    /// For phones and laptops.
    Medium,
    /// For a graphics card: the edges of waves are smooth.
    High,
    /// For pictures.
    Ultra,
    /// For stills and measurements: more than a million triangles at 1920 by 1080.
    Extreme,
}

impl Quality {
    /// Whether it has small and faint effects: all but the one made for slow machines.
    pub fn is_fine(self) -> bool {
        self != Self::Low
    }

    /// Every quality with its name in links.
    pub const ALL: [(Self, &'static str); 6] = [
        (Self::Auto, "auto"),
        (Self::Low, "low"),
        (Self::Medium, "medium"),
        (Self::High, "high"),
        (Self::Ultra, "ultra"),
        (Self::Extreme, "extreme"),
    ];
}

/// What the sea's water holds, and so its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Water {
    /// By the place: its latitude and depth.
    #[default]
    Auto,
    /// The clearest and bluest there is, with 0.03 mg of chlorophyll per cubic metre.
    Gyre,
    /// The open ocean's, with 0.1 mg.
    Open,
    /// Of cooler seas, with 0.5 mg.
    Temperate,
    /// Green, with 2 mg.
    Shelf,
    /// With 3 mg and dissolved matter of the land.
    Coastal,
    /// Of muddy estuaries.
    Turbid,
}

impl Water {
    /// Every water with its name in links.
    pub const ALL: [(Self, &'static str); 7] = [
        (Self::Auto, "auto"),
        (Self::Gyre, "gyre"),
        (Self::Open, "open"),
        (Self::Temperate, "temperate"),
        (Self::Shelf, "shelf"),
        (Self::Coastal, "coastal"),
        (Self::Turbid, "turbid"),
    ];

    /// The clearest and the most turbid kind that are drawn, from 0 (gyre) to 5 (turbid).
    pub fn kinds(self) -> [f64; 2] {
        match self {
            Self::Auto => [0.0, 5.0],
            one => [f64::from(one as u8 - Self::Gyre as u8); 2],
        }
    }
}

/// Where waves break on shores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surf {
    /// Factor on the depth that waves break in, and so on the width of white water before a beach, 0 to 3; 0: no surf.
    pub width: f64,
    /// How steeply the bed falls from shores that usually do by 0.03, metres per metre, 0.01 to 0.3, where elevations are too coarse to tell.
    pub beach_slope: f64,
}

impl Default for Surf {
    fn default() -> Self {
        Self { width: 1.0, beach_slope: USUAL_SLOPE }
    }
}

/// Where the resting sea is, and with it the land, whose heights are measured from it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Datum {
    /// On the ellipsoid WGS84.
    #[default]
    Ellipsoid,
    /// On the geoid EGM96, where the sea really is: -107 to 85 m over the ellipsoid.
    Geoid,
}

impl Datum {
    /// Every datum with its name in links.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Ellipsoid, "ellipsoid"), (Self::Geoid, "geoid")];

    /// Height of the resting sea over the ellipsoid at geodetic `lat`, `lon` (radians), m.
    pub fn rest_m(self, lat: f64, lon: f64) -> f64 {
        match self {
            Self::Ellipsoid => 0.0,
            Self::Geoid => geoid::height_m(lat, lon),
        }
    }
}

/// The haziest air that may be chosen: a plume of smoke or dust.
pub const HAZIEST: f64 = 0.5;

/// All choices that shape the sea and the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The wind; its speed yields to [`Settings::beaufort`] where that is given.
    pub wind: Wind,
    /// Beaufort grade 0 to 12, instead of a wind speed.
    pub beaufort: Option<u8>,
    /// The wave spectrum.
    pub spectrum: Spectrum,
    /// Distance over which the wind has blown, km, 1 to 5,000; `None`: a fully grown sea.
    pub fetch_km: Option<f64>,
    /// A swell on top of the wind sea.
    pub swell: Option<Swell>,
    /// Choppiness λ: factor on the horizontal displacement, 0 to 2.
    pub chop: f64,
    /// Whitecaps.
    pub foam: Foam,
    /// Seed of the random phases: the same seed and time make the same sea everywhere.
    pub seed: u32,
    /// How the surface is meshed.
    pub mesh: Mesh,
    /// How fine it is, where it is bisected.
    pub triangles: Triangles,
    /// Where waves break on shores.
    pub surf: Surf,
    /// Where the resting sea is.
    pub datum: Datum,
    /// What the picture may cost.
    pub quality: Quality,
    /// What is drawn.
    pub layers: Layers,
    /// Optical depth of the air's aerosol at 550 nm, straight up, 0 to [`HAZIEST`]: 0.05 to 0.2 over oceans.
    pub haze: f64,
    /// Share of the earth under clouds, 0 to 1; `None`: as many as the wind brings, [`Settings::cloud_cover`].
    pub clouds: Option<f64>,
    /// The sea's water.
    pub water: Water,
    /// ρ in the water's opacity `1 − exp(−ρ·depth)`, per metre, 0.1 to 0.3.
    pub water_density_per_m: f64,
}

/// Of water as it is measured.
pub const USUAL_WATER_DENSITY_PER_M: f64 = 0.2;

/// Share of the earth under clouds unless a link says otherwise, and in storms.
const USUAL_CLOUDS: f64 = 0.45;
const STORMY_CLOUDS: f64 = 0.98;
/// Winds between which the one goes over into the other, m/s: where grades 9 and 12 begin.
const STORMY_MPS: [f64; 2] = [20.8, 32.7];

impl Default for Settings {
    fn default() -> Self {
        Self {
            wind: Wind::default(),
            beaufort: None,
            spectrum: Spectrum::default(),
            fetch_km: None,
            swell: None,
            chop: 1.0,
            foam: Foam::default(),
            seed: 0,
            mesh: Mesh::default(),
            triangles: Triangles::default(),
            surf: Surf::default(),
            datum: Datum::default(),
            quality: Quality::default(),
            layers: Layers::default(),
            haze: 0.08,
            clouds: None,
            water: Water::Auto,
            water_density_per_m: USUAL_WATER_DENSITY_PER_M,
        }
    }
}

impl Settings {
    /// Speed at 10 m in m/s that drives the waves: the Beaufort grade's where one is given, else the wind's.
    pub fn wind_speed_mps(&self) -> f64 {
        self.beaufort.map_or(self.wind.speed_mps, |grade| sea_state::speed_from_beaufort(f64::from(grade)))
    }

    /// Share of the earth under clouds, 0 to 1: what is asked for, or as many as the wind brings.
    pub fn cloud_cover(&self) -> f64 {
        let storm = smoothstep(STORMY_MPS[0], STORMY_MPS[1], self.wind_speed_mps());
        self.clouds.unwrap_or(USUAL_CLOUDS + (STORMY_CLOUDS - USUAL_CLOUDS) * storm)
    }

    /// The whitecaps that are drawn: none where their layer is hidden.
    pub fn shown_foam(&self) -> Foam {
        if self.layers.shows(Layer::Foam) {
            return self.foam;
        }
        Foam { amount: 0.0, rule: FoamRule::Folding, ..self.foam }
    }

    /// Bearing that the wind comes from, radians clockwise from north. One for the whole earth; a field of winds would give each place
    /// its own.
    pub fn wind_from(&self) -> f64 {
        self.wind.from_deg.to_radians()
    }

    /// The Beaufort grade of [`Settings::wind_speed_mps`].
    pub fn beaufort_grade(&self) -> u8 {
        self.beaufort.unwrap_or_else(|| sea_state::beaufort_from_speed(self.wind.speed_mps) as u8)
    }
}
