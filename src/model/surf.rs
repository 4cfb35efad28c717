//! What becomes of a wave between the depth where it feels the bottom and the beach: shape, breaking, decay.
//!
//! Letters: H height of a single wave, m; h depth, m; k wave number, rad/m; ω angular frequency, rad/s; L₀ = 2πg/ω² its length in deep
//! water; m slope of the bed. `shaders/lib/breakers.wgsl` does the same in 32 bits, and `shaders/lib/shore_trains.wgsl` what
//! [`TrainSum::wave`] does.

use super::GRAVITY;
use super::dispersion::{shoaling, wavenumber};
use super::sea_bed::smoothstep;
use super::shore_waves::Shallows;

/// How fast a broken wave loses what it has above a stable height, and that height over the depth
/// ([Dally](crate::bibliography::Dally1985)'s κ and Γ).
pub const DECAY: f64 = 0.15;
/// See [`DECAY`].
pub const STABLE: f64 = 0.4;
/// Least height over depth in which waves break.
pub const LEAST_INDEX: f64 = 0.45;
/// r of the shape of a bore: a steep front and a long back.
pub const BORE: f64 = 0.85;

/// Depths in which waves usually break, over their heights in deep water; ours.
const USUALLY_BREAKS: f64 = 1.4;
/// Height of a wave over the depth in which it breaks, on a bed of slope `m`: six tenths of [Weggel](crate::bibliography::Weggel1972)'s, which
/// is that of single waves on a level bed in the laboratory. The heights of a random sea are then those of
/// [Battjes and Janssen](crate::bibliography::Battjes1978), within a tenth. `height` is the breaker's, m.
pub fn breaker_index(m: f64, height: f64, omega: f64) -> f64 {
    let steepness = height * omega * omega / (std::f64::consts::TAU * std::f64::consts::TAU * GRAVITY);
    let weggel = 1.56 / (1.0 + libm::exp(-19.5 * m)) - 43.75 * (1.0 - libm::exp(-19.0 * m)) * steepness;
    (0.6 * weggel).clamp(LEAST_INDEX, 1.1)
}

/// Depth, m, in which a wave that comes straight in, `deep` m high in deep water of wave number `k_deep`, is `gamma` times as high as the
/// water is deep. Green's law gives it in closed form; the second factor makes up for what that lacks of shoaling: within 0.5 %.
pub fn breaking_depth(deep: f64, k_deep: f64, gamma: f64) -> f64 {
    let shallow = libm::pow(deep / gamma, 0.8) * libm::pow(4.0 * k_deep, -0.2);
    shallow * (1.0 + 0.22 * k_deep * shallow)
}

/// Iribarren's number of a wave that breaks `height` m high on a bed of slope `m` ([Battjes](crate::bibliography::Battjes1974)): the slope over the root of that height
/// over the length in deep water. It tells the kind of breaker: [`PLUNGES`], [`SURGES`].
pub fn similarity(m: f64, height: f64, omega: f64) -> f64 {
    let length = std::f64::consts::TAU * GRAVITY / (omega * omega);
    m / libm::sqrt(height.max(1e-6) / length)
}

/// Iribarren's numbers, about 0.4, over which breakers pass from those that spill, white along the crest first, to those that plunge, white all at once.
pub const PLUNGES: [f64; 2] = [0.3, 0.5];
/// And about 2, over which they pass to those that surge up the beach unbroken.
pub const SURGES: [f64; 2] = [1.7, 2.3];
/// Depths over the depth of breaking between which a spilling wave becomes a bore, and from which on a plunging one has.
pub const BORE_WITHIN: [f64; 2] = [0.75, 1.0];
/// See [`BORE_WITHIN`].
pub const BORE_OF_PLUNGING: f64 = 0.92;

/// Of what kind the breakers of an Iribarren number are: below 0.4 and from 2 on the first and the last.
pub fn kind(similarity: f64) -> &'static str {
    match similarity {
        number if number < 0.4 => "spilling",
        number if number < 2.0 => "plunging",
        _ => "surging",
    }
}

/// How far a wave has become a bore, 0 to 1, where the depth is `y` times that in which it breaks as one of Iribarren's number `similarity`.
pub fn bore(y: f64, similarity: f64) -> f64 {
    let [last, first] = BORE_WITHIN;
    let plunges = smoothstep(PLUNGES[0], PLUNGES[1], similarity);
    let surges = smoothstep(SURGES[0], SURGES[1], similarity);
    (1.0 - surges) * (1.0 - smoothstep(last + plunges * (BORE_OF_PLUNGING - last), first, y))
}

/// Height over breaker height of a broken wave where the depth is `y` times that of breaking, on a bed of slope `m`
/// ([Dally](crate::bibliography::Dally1985)); `gamma` is its height over the depth in which it broke. 1 for y >= 1.
pub fn broken(y: f64, m: f64, gamma: f64) -> f64 {
    // At κ/m = 5/2 numerator and denominator of α vanish: a slope beside it.
    let at = DECAY / m;
    let at = if (at - 2.5).abs() < 5e-3 { 2.505 } else { at };
    let y = y.clamp(0.0, 1.0);
    let alpha = at * (STABLE / gamma) * (STABLE / gamma) / (2.5 - at);
    libm::sqrt(((1.0 + alpha) * libm::pow(y, at - 0.5) - alpha * y * y).max(0.0))
}

/// The shape of a wave, after [Abreu and others](crate::bibliography::Abreu2010): `r` says how far it is from a sine, `phase` whether its
/// crest is high (-π/2) or its front steep (0).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// r, 0 to below 1.
    pub r: f64,
    /// φ, radians.
    pub phase: f64,
}

impl Shape {
    /// Of a wave `height` m high with wave number `k` over a depth of `h` m, by its Ursell number
    /// ([Ruessink and others](crate::bibliography::Ruessink2012)); `bore`, 0 to 1, of a broken one. Where it hardly feels the bottom its crest is as
    /// pointed as water that goes to and fro by `chop` times a coth kh, of an amplitude a, makes it: that gives cos θ the second harmonic
    /// chop/2 k a² coth kh, and r/2 is that over a.
    pub fn new(height: f64, k: f64, h: f64, bore: f64, chop: f64) -> Self {
        let ursell = (0.375 * height * k / libm::pow(k * h, 3.0).max(1e-9)).max(1e-6);
        let skew = 0.857 / (1.0 + libm::exp((-0.471 - libm::log10(ursell)) / 0.297));
        let b = std::f64::consts::SQRT_2 * skew / libm::sqrt(9.0 + 2.0 * skew * skew);
        let psi = -std::f64::consts::FRAC_PI_2 * (1.0 - libm::tanh(0.815 / libm::pow(ursell, 0.672)));
        let pointed = 0.5 * chop * height * k / libm::tanh(k * h);
        let (r, phase) = ((2.0 * b / (1.0 + b * b)).max(pointed.min(BORE)), -psi - std::f64::consts::FRAC_PI_2);
        Self { r: r + (BORE - r) * bore, phase: phase * (1.0 - bore) }
    }

    /// The surface over its mean level at a phase (radians, growing with time), per half of the height, and its derivative. Whatever the
    /// shape, it has the mean square of a sine, so that energies stay.
    pub fn surface(self, phase: f64) -> [f64; 2] {
        let f = libm::sqrt(1.0 - self.r * self.r);
        let scale = libm::sqrt(0.5 * f * (1.0 + f));
        let (sin, cos) = libm::sincos(phase);
        let (sin_moved, cos_moved) = libm::sincos(phase + self.phase);
        let (rise, below) = (sin + self.r * libm::sin(self.phase) / (1.0 + f), 1.0 - self.r * cos_moved);
        [scale * rise / below, scale * (cos * below - rise * self.r * sin_moved) / (below * below)]
    }
}

/// Trains that come together at a place: Σ A e^{iθ}, and Σ k A cos θ and Σ k A sin θ along their ways, in any two axes. θ is 0 at a crest and
/// grows with time; the amplitudes A, m, are those of deep water.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrainSum {
    /// The first.
    pub z: [f64; 2],
    /// The second.
    pub cosines: [f64; 2],
    /// The third.
    pub sines: [f64; 2],
}

/// The water at a place of a shore.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfWave {
    /// Over the mean level, m.
    pub rise: f64,
    /// Its slope, along the axes of the sum.
    pub slope: [f64; 2],
    /// Of the wave that the place is in, m.
    pub height: f64,
    /// How far that has broken, 0 to 1.
    pub bore: f64,
}

/// Angular frequencies that stand for those of trains that come together, rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Their mean: so often crests come.
    pub mean: f64,
    /// Their harmonic mean, by which all grow together: in shallow water their energies do with the inverse of their frequencies (Green's law).
    pub growing: f64,
}

impl Rates {
    /// Those of trains of the same energy.
    pub fn of(omegas: impl ExactSizeIterator<Item = f64> + Clone) -> Self {
        let count = omegas.len() as f64;
        Self {
            mean: omegas.clone().sum::<f64>() / count,
            growing: count / omegas.map(|omega| 1.0 / omega).sum::<f64>(),
        }
    }
}

/// Those of a single train.
impl From<f64> for Rates {
    fn from(omega: f64) -> Self {
        Self { mean: omega, growing: omega }
    }
}

/// What a single wave has become at a place.
struct Grown {
    h: f64,
    k: f64,
    /// Its height, m.
    height: f64,
    /// The depth in which it breaks, m.
    breaks: f64,
    /// Iribarren's number as it breaks.
    similarity: f64,
}

impl Grown {
    /// One that is `deep` m high in deep water.
    fn new(Rates { mean: omega, growing }: Rates, place: Shallows, deep: f64) -> Self {
        let h = place.h.max(super::shore_waves::SHALLOWEST_M);
        let k = wavenumber(omega, h);
        // Of the bed where a wave of this height breaks.
        let slope = place.slope_where((h / (USUALLY_BREAKS * deep.max(1e-6))).min(1.0)).max(0.01);
        let m = slope.min(0.1);
        let gamma = breaker_index(m, deep, omega);
        let breaks = breaking_depth(deep.max(1e-6), growing * growing / GRAVITY, gamma);
        let grown = deep * shoaling(wavenumber(growing, h), h);
        let height = if h < breaks { grown.min(gamma * breaks * broken(h / breaks, m, gamma)) } else { grown };
        Self { h, k, height, breaks, similarity: similarity(slope, gamma * breaks, omega) }
    }
}

/// Significant height at a place by a shore, m, of waves whose heights in deep water have Rayleigh's distribution with the rms
/// `rms_deep`, m: each grows and breaks for itself, and √2 times the rms of what they become is four times the water's deviation, as their shapes
/// keep the mean square of a sine.
pub fn significant_height(rates: impl Into<Rates>, place: Shallows, rms_deep: f64) -> f64 {
    let rates = rates.into();
    const QUANTILES: usize = 64;
    let squares = (0..QUANTILES).map(|i| {
        let deep = rms_deep * libm::sqrt(-libm::log((i as f64 + 0.5) / QUANTILES as f64));
        let height = Grown::new(rates, place, deep).height;
        height * height
    });
    libm::sqrt(2.0 * squares.sum::<f64>() / QUANTILES as f64)
}

/// [`similarity`] of the wave that is as high in deep water as the significant height, where it breaks before a place; `rms_deep` as of
/// [`significant_height`].
pub fn usual_similarity(rates: impl Into<Rates>, place: Shallows, rms_deep: f64) -> f64 {
    Grown::new(rates.into(), place, std::f64::consts::SQRT_2 * rms_deep).similarity
}

impl TrainSum {
    /// The water at a place by a shore: `energy` is the share of the trains' that is theirs here, `rates` are their
    /// frequencies, `chop` the sea's.
    pub fn wave(&self, rates: impl Into<Rates>, place: Shallows, energy: f64, chop: f64) -> SurfWave {
        let size = libm::hypot(self.z[0], self.z[1]);
        let deep = 2.0 * size * place.left * libm::sqrt(energy);
        let Grown { h, k, height, breaks, similarity } = Grown::new(rates.into(), place, deep);
        let bore = bore(h / breaks.max(1e-3), similarity);
        let turn = self.z.map(|part| part / size.max(1e-6));
        // The shape begins with a rise, the sum with a crest.
        let phase = libm::atan2(turn[1], turn[0]) + std::f64::consts::FRAC_PI_2;
        let [rise, tilt] = Shape::new(height, k, h, bore, chop).surface(phase);
        let along = |axis: usize| turn[0] * self.cosines[axis] + turn[1] * self.sines[axis];
        let local = [along(0), along(1)].map(|k| k / size.max(0.2 * deep + 1e-4));
        let length = libm::hypot(local[0], local[1]).max(1e-6);
        // Between two crests of different ways the sum has no direction, and turns as quickly as it likes.
        let bound = (2.0 * k / length).min(1.0);
        let slope = [0, 1].map(|axis| {
            let growth = (turn[0] * self.sines[axis] - turn[1] * self.cosines[axis]) / size.max(1e-4);
            0.5 * height * (-tilt * bound * local[axis] + (1.0 - bore) * rise * growth)
        });
        SurfWave { rise: 0.5 * height * rise, slope, height, bore }
    }
}
