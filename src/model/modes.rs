//! Seas of a few single waves: sums of sines and of Gerstner waves.
//!
//! [`COUNT`] waves share the variance m of the wind sea up to ten peak wave numbers evenly, a = √(2 m / COUNT) each: their wave numbers
//! are the middles of as many quantiles of the spectrum, their directions as many strata of the spreading at their frequency, dealt out so
//! that long and short waves get all of them. Each then takes the nearest free wave vector of its [patch](super::cascade)'s lattice, so that
//! whoever draws, rides or measures a sea takes them for waves like any others. That moves a wave vector by half a step of the lattice or
//! so, 6 % in the worst case, at the inner edge of a ring.
//!
//! A Gerstner wave moves water by Q a towards its crest, a sine moves it up and down alone. Beyond ten peak wave numbers the spectrum's own
//! ripples remain, half a hundredth of the variance but most of the slopes: without them the water is smooth like plastic.

use super::cascade::{CASCADES, Patch, cascades};
use super::sea::Sea;
use super::spectrum::DirectionalSpectrum;
use super::{dispersion, noise, spreading::DonelanBanner};

/// How many waves these seas have.
pub const COUNT: usize = 32;

/// The coarsest patches that are drawn: every quality holds the waves that these do, so that all draw the same ones.
const COARSEST: usize = 128;
/// Parts of the table of the spectrum's integral, and its start in peak wave numbers: 1e-13 of the variance lies below.
const PARTS: usize = 2048;
const STARTS: f64 = 0.2;
/// Fraction of the golden ratio: its multiples spread evenly over 0…1, however many are taken.
const GOLDEN: f64 = 0.618_033_988_749_895;
/// The noise that chooses a sea's directions.
const DIRECTION_KEY: u32 = 3_000;

/// One wave a cos(k·x − ωt + φ).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// Which patch holds it.
    pub cascade: usize,
    /// Its signed indices there.
    pub index: [i32; 2],
    /// kx downwind, ky to its left, rad/m.
    pub wave_vector: [f64; 2],
    /// h0 of the patch's element, m: ½ a (cos φ, sin φ).
    pub h0: [f64; 2],
}

impl Mode {
    /// The element that holds it in a patch of `n` by `n` samples.
    pub fn element(&self, n: usize) -> usize {
        let [i, j] = self.index.map(|i| i.rem_euclid(n as i32) as usize);
        j * n + i
    }

    /// a, m.
    pub fn amplitude_m(&self) -> f64 {
        2.0 * libm::hypot(self.h0[0], self.h0[1])
    }

    /// |k|, rad/m.
    pub fn wavenumber(&self) -> f64 {
        libm::hypot(self.wave_vector[0], self.wave_vector[1])
    }

    /// a²/2, the variance of the surface that is its own, m².
    pub fn variance(&self) -> f64 {
        0.5 * self.amplitude_m() * self.amplitude_m()
    }
}

/// The single waves of a sea's wind: [`COUNT`], or none where a whole spectrum is drawn, and in a calm.
pub fn modes(sea: &Sea) -> Vec<Mode> {
    let spectrum = sea.spectrum();
    let (wind, peak) = (spectrum.wind, spectrum.wind.peak_wavenumber());
    let end = sea.kind.ripples_from() * peak;
    if end <= 0.0 {
        return Vec::new();
    }
    let (sums, wave_numbers) = quantiles(&wind, [STARTS * peak, end]);
    let amplitude_m = libm::sqrt(2.0 * sums / COUNT as f64);
    let [turn, _] = noise::bits(sea.seed, DIRECTION_KEY, 0, 0);
    let turn = (turn >> 11) as f64 / (1u64 << 53) as f64;
    let mut modes: Vec<Mode> = Vec::with_capacity(COUNT);
    for (number, k) in wave_numbers.into_iter().enumerate() {
        let stratum = (GOLDEN * number as f64 + turn).fract();
        let angle = direction(libm::sqrt(k / peak), stratum);
        let (sin, cos) = libm::sincos(angle);
        let (cascade, index, wave_vector) = snapped([k * cos, k * sin], &modes);
        let [x, y] = noise::gaussian_pair(sea.seed, cascade as u32, index[0], index[1]);
        // Never 0 in both: the logarithm's argument is below 1.
        let unit = 0.5 * amplitude_m / libm::hypot(x, y).max(f64::MIN_POSITIVE);
        modes.push(Mode { cascade, index, wave_vector, h0: [unit * x, unit * y] });
    }
    modes
}

/// The sharpest chop λ under which no sum of these waves folds, Σ λ k a = 1; infinite without waves.
pub fn sharpest_chop(modes: &[Mode]) -> f64 {
    // Not by sum(), which is -0 for none.
    1.0 / modes.iter().fold(0.0, |sum, mode| sum + mode.wavenumber() * mode.amplitude_m())
}

/// The variance of the waves between two wave numbers, m², and the wave numbers below which (i + ½)/COUNT of it lies, i = 0…COUNT − 1;
/// by trapezoids even in ln k.
fn quantiles(spectrum: &impl DirectionalSpectrum, ends: [f64; 2]) -> (f64, [f64; COUNT]) {
    let step = libm::log(ends[1] / ends[0]) / PARTS as f64;
    let at = |part: f64| ends[0] * libm::exp(step * part);
    let density: Vec<f64> = (0..=PARTS).map(|part| at(part as f64)).map(|k| k * spectrum.omnidirectional(k)).collect();
    let mut sums = vec![0.0];
    for pair in density.windows(2) {
        sums.push(sums[sums.len() - 1] + 0.5 * step * (pair[0] + pair[1]));
    }
    let total = sums[PARTS];
    let wave_numbers = std::array::from_fn(|i| {
        let wanted = total * (i as f64 + 0.5) / COUNT as f64;
        let above = sums.partition_point(|sum| *sum < wanted).clamp(1, PARTS);
        let (low, high) = (sums[above - 1], sums[above]);
        at(above as f64 - 1.0 + ((wanted - low) / (high - low).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0))
    });
    (total, wave_numbers)
}

/// The direction θ, radians, below which a share `stratum` (0…1) of a frequency x = ω/ω_p lies, by the inverse of the integral of
/// [`DonelanBanner`]'s spreading: ½ (1 + tanh βθ / tanh βπ).
fn direction(x: f64, stratum: f64) -> f64 {
    let beta = DonelanBanner::beta(x).max(1e-6);
    let y = (2.0 * stratum - 1.0) * libm::tanh(beta * std::f64::consts::PI);
    libm::atanh(y.clamp(-1.0 + 1e-12, 1.0 - 1e-12)) / beta
}

/// The free place nearest to a wave vector on the lattice of the patch whose ring holds it: patch, indices and wave vector.
fn snapped(wanted: [f64; 2], taken: &[Mode]) -> (usize, [i32; 2], [f64; 2]) {
    let patches = cascades(COARSEST);
    let k = libm::hypot(wanted[0], wanted[1]);
    let cascade = patches.iter().position(|patch| k < patch.k_max).unwrap_or(CASCADES - 1);
    let patch = Patch::from(&patches[cascade]);
    let [dk, _] = patch.dk();
    let middle = wanted.map(|k| libm::round(k / dk) as i32);
    // A square of 15 by 15 places holds more than COUNT within any ring.
    let reach = -7..=7;
    let near = reach.clone().flat_map(|j| reach.clone().map(move |i| [middle[0] + i, middle[1] + j]));
    let nearest = near
        .map(|index| (index, index.map(|i| f64::from(i) * dk)))
        .filter(|(index, at)| {
            let k = libm::hypot(at[0], at[1]);
            let is_free = !taken.iter().any(|mode| mode.cascade == cascade && mode.index == *index);
            is_free && k > 0.0 && k >= patch.k_min && k < patch.k_max
        })
        .min_by(|(_, a), (_, b)| {
            let off = |at: &[f64; 2]| libm::hypot(at[0] - wanted[0], at[1] - wanted[1]);
            off(a).total_cmp(&off(b))
        });
    let (index, at) = nearest.unwrap_or_else(|| {
        // Shorter waves than any patch holds: the last of the ring, downwind.
        let i = (patch.k_max / dk) as i32 - taken.len() as i32 % 8;
        ([i, 0], [f64::from(i) * dk, 0.0])
    });
    (cascade, index, at)
}

/// ω of a mode in deep water, rad/s, as its patch has it.
pub fn frequency(mode: &Mode) -> f64 {
    dispersion::omega_capillary(mode.wavenumber(), f64::INFINITY, dispersion::SEA_TENSION)
}
