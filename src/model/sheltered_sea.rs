//! The sea where land stands in its way: how much of the open sea comes past it, and what the wind makes anew in its lee.
//!
//! Seen from a place the sea comes from [`DIRECTIONS`] directions. What stands in each is its [`Exposure`], which the map alone decides. Of a
//! direction with the weight w, the sum of all being 1, the place has the energy
//!
//! ```text
//!  w [V m0 + (1 − V) min(m0, m0_YV(U, F, h))]
//! ```
//!
//! of the open sea's m0: V is what comes past the shore, bent round it, and m0_YV what the wind raises over the water on this side of it
//! ([`young_verhagen`]). The same holds of the energy in the ring of wave numbers of each wave patch, where the sea that the wind has raised
//! anew has waves of its own period: see [`LocalSea::gains`].
//!
//! V as a function of the shore's distance and of how far the ray passes it is the wave height of Sommerfeld's half plane, squared and
//! rounded off, so that of a wind sea behind a wall, its directions summed, the height is within 0.04 of that solution's (most of it by the 24
//! directions), of a swell's within 0.07. Known limits: what comes past both sides of an island adds up as if it
//! were one; the bed bends no waves here; a swell's lee is as deep as its peak's waves make it.

use std::f64::consts::{PI, TAU};

use super::GRAVITY;
use super::optics::cox_munk_mss;
use super::quadrature::simpson_log;
use super::sea::Sea;
use super::sea_tables::SeaTables;
use super::spectrum::{DAMPING_M, Directed, DirectionalSpectrum, Equilibrium, Jonswap, SlopeTrue};
use super::spreading::{Cos2s, DonelanBanner, Spreading};
use super::waves::Cascade;
use barrier::behind_barrier;
pub use peak::LocalWaves;

mod barrier;
mod peak;

/// Directions that an exposure is told for: number i is the bearing 15° i, clockwise from north. With half as many the lee of a wall is off
/// by 0.08 of the wave height where its shadow begins, with these by 0.02.
pub const DIRECTIONS: usize = 24;
/// Farther away no shore is looked for, m: a sea that has run so far is taken for the open one.
pub const FARTHEST_M: f64 = 300_000.0;
/// Rings of wave numbers with a gain of their own: those of the longest patches. The ripples of the last one are there as soon as the wind is.
pub const RINGS: usize = 3;
/// Exponent s of the spread cos^2s(θ/2) of a wind sea's energy about its mean direction
/// ([Goda](crate::bibliography::Goda2010): 10), and of a swell's.
pub const SPREADS: [f64; 2] = [10.0, 30.0];
/// Directions with less than this share of the energy do not count.
const NEGLIGIBLE: f64 = 2e-3;
/// No ring's waves are higher than this many times those of the open sea.
/// With it a node's 16 bits hold a gain of 1 as a whole number, and its rounding does not depend on how it was found.
pub const MOST_GAIN: f64 = 65_535.0 / 32_768.0;
/// Fetches that the wind's own seas are tabulated for, from 10 m to [`FARTHEST_M`], evenly in their logarithms.
const FETCHES: usize = 46;
const LEAST_FETCH_M: f64 = 10.0;

/// What stands in one direction from a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exposure {
    /// Metres of water up to the shore that stands there or, where none does, up to the one that the ray passes most closely.
    pub fetch_m: f64,
    /// By how much the ray clears the shores, or how far it would have to be moved to do so (then negative): distance from the ray over the
    /// root of the shore's distance from the place, least of all shores, m^½. Infinite: there is none.
    pub clearance: f64,
}

impl Exposure {
    /// Nothing in the way.
    pub const OPEN: Self = Self { fetch_m: FARTHEST_M, clearance: f64::INFINITY };

    /// V, 0 to 1: the share of the energy of waves of a length in metres that comes past the shore. About that of Fresnel's at the edge of a half plane,
    /// without its fringes; in clear water as near to 1 as leaves a sea of many directions the energy that it has there.
    pub fn passed(self, wavelength_m: f64) -> f64 {
        if self.clearance == f64::INFINITY || wavelength_m <= 0.0 {
            return if self.clearance >= 0.0 { 1.0 } else { 0.0 };
        }
        let v = self.clearance * libm::sqrt(2.0 / wavelength_m);
        if v < 0.0 { 1.0 / (4.0 - 5.8 * v + 2.0 * PI * PI * v * v) } else { 1.0 - 0.75 * libm::exp(-2.5 * v) }
    }
}

/// Exposure in each of the [`DIRECTIONS`]; `None` where it is not known (yet).
pub type Exposures = [Option<Exposure>; DIRECTIONS];

/// Significant height, m, and period of the peak, s, of the sea that a wind of `speed_mps` (10 m up) raises over `fetch_m` of water of the
/// mean depth `depth_m` (infinite: deep): [Young and Verhagen](crate::bibliography::YoungVerhagen1996). 0 and 0 without wind or fetch.
pub fn young_verhagen(speed_mps: f64, fetch_m: f64, depth_m: f64) -> (f64, f64) {
    if !(speed_mps > 1e-3 && fetch_m > 0.0 && depth_m > 0.0) {
        return (0.0, 0.0);
    }
    let u2 = speed_mps * speed_mps;
    // tanh is 1 long before 1e6; an infinite depth would make ∞/∞ of tanh(B/tanh A) later.
    let (chi, delta) = (GRAVITY * fetch_m / u2, (GRAVITY * depth_m / u2).min(1e6));
    let held = |a: f64, b: f64| libm::tanh(a) * libm::tanh(b / libm::tanh(a));
    let energy = held(0.493 * libm::pow(delta, 0.75), 3.13e-3 * libm::pow(chi, 0.57));
    let rate = held(0.331 * libm::pow(delta, 1.01), 5.215e-4 * libm::pow(chi, 0.73));
    let (epsilon, nu) = (3.64e-3 * libm::pow(energy, 1.74), 0.133 * libm::pow(rate, -0.37));
    (4.0 * libm::sqrt(epsilon) * u2 / GRAVITY, speed_mps / (nu * GRAVITY))
}

/// Shares of the energy that comes from each direction, which add up to 1, of waves that come from bearing `from`, radians, with the spread
/// cos^2s(θ/2).
pub fn weights(from: f64, s: f64) -> [f64; DIRECTIONS] {
    let spread = Cos2s::new(s);
    let mut weights = [0.0; DIRECTIONS];
    for (i, weight) in weights.iter_mut().enumerate() {
        let (sin, cos) = libm::sincos(bearing(i) - from);
        *weight = spread.density(1.0, cos, sin);
    }
    let sum: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|weight| *weight = if *weight < NEGLIGIBLE * sum { 0.0 } else { *weight });
    let sum: f64 = weights.iter().sum();
    weights.map(|weight| weight / sum)
}

/// Bearing of a direction, radians clockwise from north.
pub fn bearing(direction: usize) -> f64 {
    TAU * direction as f64 / DIRECTIONS as f64
}

/// A sea as places in the lee of land have it.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalSea {
    /// Shares of the energy from each direction, of the wind sea and of the swell.
    weights: [[f64; DIRECTIONS]; 2],
    /// Lengths of their peaks' waves, m.
    wavelengths_m: [f64; 2],
    /// Energy in each ring, of the wind sea and of the swell, m².
    energies: [[f64; RINGS]; 2],
    /// Energy in each ring of the sea that the wind raises over a fetch, over that of the open one.
    grown: Vec<[f64; RINGS]>,
    /// Speed of the wind, m/s, height of the open sea that it raises, m, and mean depth of the water, m.
    wind: [f64; 3],
}

/// What comes from one of the [`DIRECTIONS`].
struct Direction {
    /// Shares of the energy of the wind sea and of the swell that come from there, in the open.
    weights: [f64; 2],
    /// What of these comes past the shore.
    passed: [f64; 2],
    fetch_m: f64,
}

impl LocalSea {
    /// Those of a sea under a wind from bearing `wind_from` (radians) over water of a mean depth in metres.
    pub fn new(tables: &SeaTables, wind_from: f64, depth_m: f64) -> Self {
        let sea = &tables.sea;
        let spectrum = sea.spectrum();
        let swell_from = wind_from - sea.swell.map_or(0.0, |swell| swell.toward);
        let length = |k: f64| if k > 0.0 { TAU / k } else { 0.0 };
        let energies = |part: &dyn DirectionalSpectrum| rings(&tables.cascades, |k| part.omnidirectional(k));
        let wind = energies(&spectrum.wind);
        let fetches = (0..FETCHES).map(|i| LEAST_FETCH_M * libm::exp(step() * i as f64));
        Self {
            weights: [weights(wind_from, SPREADS[0]), weights(swell_from, SPREADS[1])],
            wavelengths_m: [
                length(spectrum.wind.peak_wavenumber()),
                spectrum.swell.map_or(0.0, |swell| length(swell.peak_wavenumber())),
            ],
            energies: [wind, spectrum.swell.as_ref().map_or([0.0; RINGS], |swell| energies(swell))],
            grown: grown(sea, &tables.cascades, fetches, depth_m),
            wind: [sea.speed_mps, sea.wind_height_m(), depth_m],
        }
    }

    /// Whether a direction counts.
    pub fn needs(&self, direction: usize) -> bool {
        let swells = self.energies[1].iter().any(|energy| *energy > 0.0);
        self.weights[0][direction] > 0.0 || swells && self.weights[1][direction] > 0.0
    }

    /// How much higher the waves of each ring are than the open sea's, 0 to [`MOST_GAIN`], with these exposures, which hold what
    /// [`LocalSea::needs`].
    pub fn gains(&self, exposures: &Exposures) -> [f64; RINGS] {
        let mut wind = [0.0; RINGS];
        let mut swell = 0.0;
        for Direction { weights: [of_wind, of_swell], passed, fetch_m } in self.directions(exposures) {
            if of_wind > 0.0 {
                let grown = self.grown_over(fetch_m);
                for (sum, grown) in wind.iter_mut().zip(grown) {
                    *sum += of_wind * (passed[0] + (1.0 - passed[0]) * grown);
                }
            }
            swell += of_swell * passed[1];
        }
        std::array::from_fn(|ring| {
            let [of_wind, of_swell] = [0, 1].map(|part| self.energies[part][ring]);
            let all = of_wind + of_swell;
            if all > 0.0 { libm::sqrt((of_wind * wind[ring] + of_swell * swell) / all).min(MOST_GAIN) } else { 1.0 }
        })
    }

    /// What comes from each direction that counts.
    fn directions(&self, exposures: &Exposures) -> impl Iterator<Item = Direction> {
        (0..DIRECTIONS).filter(|direction| self.needs(*direction)).map(|direction| {
            let exposure = exposures[direction].map_or(Exposure::OPEN, |own| behind_barrier(exposures, direction, own));
            let passed = self.wavelengths_m.map(|length_m| exposure.passed(length_m));
            Direction { weights: self.weights.map(|weights| weights[direction]), passed, fetch_m: exposure.fetch_m }
        })
    }

    /// The sea that the wind raises over a fetch; `None` where that is no lower than the open one.
    fn raised(&self, fetch_m: f64) -> Option<Jonswap> {
        let [speed_mps, open_m, depth_m] = self.wind;
        let (hs_m, peak_s) = young_verhagen(speed_mps, fetch_m.max(LEAST_FETCH_M), depth_m);
        (hs_m > 0.0 && hs_m < open_m).then(|| Jonswap::from_height(hs_m, peak_s))
    }

    /// [`LocalSea::grown`] between the fetches of the table.
    fn grown_over(&self, fetch_m: f64) -> [f64; RINGS] {
        let at = libm::log(fetch_m.max(LEAST_FETCH_M) / LEAST_FETCH_M) / step();
        let low = (at as usize).min(FETCHES - 2);
        let way = (at - low as f64).min(1.0);
        let [a, b] = [self.grown[low], self.grown[low + 1]];
        std::array::from_fn(|ring| a[ring] + way * (b[ring] - a[ring]))
    }
}

/// From one fetch of the table to the next, in logarithms.
fn step() -> f64 {
    libm::log(FARTHEST_M / LEAST_FETCH_M) / (FETCHES - 1) as f64
}

/// ∫ of a spectrum over the rings of the first patches, m².
pub fn rings(cascades: &[Cascade], omnidirectional: impl Fn(f64) -> f64) -> [f64; RINGS] {
    std::array::from_fn(|ring| {
        let Cascade { k_min, k_max, .. } = cascades[ring];
        simpson_log(k_min.max(1e-4), k_max, 96, &omnidirectional)
    })
}

/// Energy in each ring of the sea over each of some fetches, over that of the open one: both as the usual spectrum has them. The first patches together
/// lose what the height does; the tail that the wind holds in balance is never more than the open sea's.
fn grown(sea: &Sea, cascades: &[Cascade], fetches: impl Iterator<Item = f64>, depth_m: f64) -> Vec<[f64; RINGS]> {
    let mss = cox_munk_mss(sea.speed_mps).total;
    let energies = |hs_m, peak_s| {
        let frequency = Jonswap::from_height(hs_m, peak_s);
        let sea = Equilibrium::new(Directed { frequency, spreading: DonelanBanner });
        let sea = SlopeTrue::new(sea, hs_m, mss, DAMPING_M);
        rings(cascades, |k| sea.omnidirectional(k))
    };
    let open_m = sea.wind_height_m();
    let open = sea.grown().map(|open| energies(open_m, TAU / open.omega_p));
    let over = |fetch_m| {
        let (hs_m, peak_s) = young_verhagen(sea.speed_mps, fetch_m, depth_m);
        let Some(open) = open.filter(|_| hs_m < open_m) else { return [1.0; RINGS] };
        if hs_m <= 0.0 {
            return [0.0; RINGS];
        }
        let grown = energies(hs_m, peak_s);
        std::array::from_fn(|ring| {
            let share = if open[ring] > 0.0 { grown[ring] / open[ring] } else { 1.0 };
            if ring + 1 < RINGS { share } else { share.min(1.0) }
        })
    };
    fetches.map(over).collect()
}
