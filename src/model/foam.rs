//! Whitecaps: where the chop folds the surface foam is born, and then it fades.
//!
//! State F in 0…1 at a rest point (share covered). The smaller eigenvalue μ of ∇D says how much of the point breaks ([`Fold`]):
//! F grows towards that share with [`GROWTH_S`], and from above it decays to it with the foam's lifetime. Both are exact
//! exponentials of the time that has gone by, so the result does not depend on the frame rate as long as frames are shorter than
//! a fold lives.
//!
//! # Which folds?
//! Linear waves fold too often in a gale and hardly ever in a breeze, and the more so the finer the grid: the measured whitecap
//! fraction fixes the threshold instead. The mean of F over the water's area has no closed form (it needs the durations of
//! excursions of an eigenvalue), so a [`Simulation`] follows ∇D at many independent rest points, from the sea's own
//! spectrum, and bisects. Each level of the foam map sees what the filters of its textures leave of the waves ([`kept`]) and has a
//! threshold of its own, so that all levels hold the same mean. Rejected: one threshold for all levels (a coarse level would hold no foam), and a
//! quantile of μ alone (the lifetime multiplies it by three in a gale and by ten in a breeze).

use super::sea_bed::smoothstep;

mod thresholds;

pub use thresholds::{INSTANTS, POINTS, SHORTEST_PATCH_TEXELS, Simulation, kept};

/// E-folding time of a whitecap in salt water, s ([Monahan](crate::bibliography::Monahan1971)); 2.54 s in fresh water.
pub const LIFETIME_S: f64 = 3.85;
/// E-folding time of the young foam of a whitecap, s: what still stands high and dense where the crest broke,
/// oceanographers' stage A. The time is our own, by what photographs show.
pub const YOUNG_S: f64 = 1.0;
/// Time in which a breaking crest turns white to 1 − 1/e, s.
pub const GROWTH_S: f64 = 0.25;

/// The film of bubbles that outlives whitecaps, by [`breaking_fraction`](super::sea_state::breaking_fraction): its share of the water, where it drifts
/// together into rows, and its opacity there. Neither has been measured: ours follow the Beaufort scale, with the first film at grade 6, marked rows at 8, and
/// nearly half as opaque as dense foam from 10 on, where it covers 0.56 of the water, and 0.72 at 12: crests that break now stand out of it.
pub fn film(breaking: f64) -> [f64; 2] {
    let ramp = |from, to| smoothstep(from, to, breaking);
    let opacity = (0.13 + 0.4 * breaking + 0.3 * ramp(0.12, 0.3)) * ramp(0.012, 0.08);
    [1.0 - libm::exp(-3.0 * breaking.min(MOST_BREAKING)), opacity.min(MOST_FILM)]
}

/// The film covers no more than where so much breaks: hurricanes have gaps in it, too.
const MOST_BREAKING: f64 = 0.42;
/// Opacity of the film, at most, lest it and foam be more than all: between the rafts of thin foam, which cover half of it (`RAFTS` of `shaders/lib/lace.wgsl`), it lies
/// twice as dense, and thin foam leaves it 0.6 (`THIN_FOAM`); and a little less than that, for what breaks to stand out of it.
const MOST_FILM: f64 = 0.45;

/// Foam after `dt_s` seconds, drawn from `foam` towards `equilibrium` with a lifetime in seconds: F ← Fₑ + (F − Fₑ) e^{−dt/τ}, exact
/// for any step. A lifetime of 0 or less leaves Fₑ.
pub fn relaxed(foam: f64, equilibrium: f64, dt_s: f64, lifetime_s: f64) -> f64 {
    if lifetime_s <= 0.0 {
        return equilibrium;
    }
    equilibrium + (foam - equilibrium) * libm::exp(-dt_s.max(0.0) / lifetime_s)
}

/// How long foam of a lifetime in seconds stays young, s.
pub fn young_s(lifetime_s: f64) -> f64 {
    lifetime_s * YOUNG_S / LIFETIME_S
}

/// F after `dt_s` seconds that began with `foam`, while the share `breaking` (0…1) breaks.
pub fn evolve(foam: f64, breaking: f64, dt_s: f64, lifetime_s: f64) -> f64 {
    relaxed(foam, breaking, dt_s, if breaking > foam { GROWTH_S } else { lifetime_s })
}

/// How long a crest breaks at one place, s, seen in parts `texel_m` metres wide: the shortest waves that one holds are as long as a
/// few of them, and their period goes with the root of their length. The factor is our own: a fraction (0.15 s) of the second
/// that waves of a metre or two take, for texels of 0.25 m.
pub fn breaking_s(texel_m: f64) -> f64 {
    0.3 * texel_m.sqrt()
}

/// The share of what is not yet white that a step of `dt_s` seconds leaves so where a texel `texel_m` metres wide breaks. A crest
/// that breaks for less than a step, T, is met by chance, in one of dt/T steps: then the step grows it dt/T times as much as
/// breaking for T does, so that the mean is right.
pub fn ungrown(texel_m: f64, dt_s: f64) -> f64 {
    let breaking_s = breaking_s(texel_m);
    let grown = if dt_s < breaking_s {
        1.0 - (-dt_s / GROWTH_S).exp()
    } else {
        dt_s / breaking_s * (1.0 - (-breaking_s / GROWTH_S).exp())
    };
    1.0 - grown.min(1.0)
}

/// Where a level breaks: saturate((threshold − μ)/softness) of a texel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fold {
    /// Value of μ below which whitecaps begin (1 + λμ is the smaller eigenvalue of the chop's gradient); −∞: never.
    pub threshold: f64,
    /// How far below it a texel breaks as a whole. Large texels hold many crests, of which few break at a time.
    pub softness: f64,
}

impl Fold {
    /// Nothing breaks.
    pub const NEVER: Self = Self { threshold: f64::NEG_INFINITY, softness: 1.0 };
}

/// Where the ramp saturate(η/σ − q) of a Gaussian height η must start, in standard deviations q, so that its mean is `share`
/// (0…½): the height rule's foam. By bisection on its closed form, the difference of two unit normal losses.
pub fn ramp_start(share: f64) -> f64 {
    // L(q) = φ(q) − q Q(q), the mean of max(x − q, 0).
    let loss = |q: f64| {
        let density = libm::exp(-0.5 * q * q) / libm::sqrt(std::f64::consts::TAU);
        density - q * 0.5 * libm::erfc(q * std::f64::consts::FRAC_1_SQRT_2)
    };
    let (mut low, mut high) = (-2.0, 6.0);
    for _ in 0..40 {
        let q = 0.5 * (low + high);
        if loss(q) - loss(q + 1.0) > share { low = q } else { high = q }
    }
    0.5 * (low + high)
}
