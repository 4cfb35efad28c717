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
//! excursions of an eigenvalue), so [`folds`] simulates ∇D at many independent rest points, from the sea's own
//! spectrum, and bisects. Each level of the foam map sees what the filters of its textures leave of the waves ([`kept`]) and has a
//! threshold of its own, so that all levels hold the same mean. Rejected: one threshold for all levels (a coarse level would hold no foam), and a
//! quantile of μ alone (the lifetime multiplies it by three in a gale and by ten in a breeze).

use super::{cascade::Cascade, dispersion, noise, spectrum::DirectionalSpectrum};

/// E-folding time of a whitecap in salt water, s ([Monahan](crate::bibliography::Monahan1971)); 2.54 s in fresh water.
pub const LIFETIME_S: f64 = 3.85;
/// Time in which a breaking crest turns white to 1 − 1/e, s.
pub const GROWTH_S: f64 = 0.25;
/// Independent rest points.
const POINTS: usize = 2048;
/// Instants of each and the time between them, s.
const INSTANTS: usize = 64;
const STEP_S: f64 = 0.15;
/// Bands of wave numbers, from below the peak to [`SHORTEST_TEXELS`] of the finest level.
const BANDS: usize = 12;
/// Waves of fewer texels than this move no level.
const SHORTEST_TEXELS: f64 = 1.5;
/// A tile shorter than so many texels moves a level by next to nothing: its longest waves are a sixth of it. Equals
/// `SHORTEST_TILE_TEXELS` in `shaders/foam.wgsl`.
pub const SHORTEST_TILE_TEXELS: f64 = 10.0;
/// Directions off the wind, radians: the middles of six sectors of the half circle before it.
const DIRECTIONS: [f64; 6] = [-5.0 * SECTOR, -3.0 * SECTOR, -SECTOR, SECTOR, 3.0 * SECTOR, 5.0 * SECTOR];
/// Half a sector, 15°.
const SECTOR: f64 = std::f64::consts::PI / 12.0;

/// Foam after `dt_s` seconds, drawn from `foam` towards `equilibrium` with a lifetime in seconds: F ← Fₑ + (F − Fₑ) e^{−dt/τ}, exact
/// for any step. A lifetime of 0 or less leaves Fₑ.
pub fn relaxed(foam: f64, equilibrium: f64, dt_s: f64, lifetime_s: f64) -> f64 {
    if lifetime_s <= 0.0 {
        return equilibrium;
    }
    equilibrium + (foam - equilibrium) * libm::exp(-dt_s.max(0.0) / lifetime_s)
}

/// F after `dt_s` seconds that began with `foam`, while the share `breaking` (0…1) breaks.
pub fn evolve(foam: f64, breaking: f64, dt_s: f64, lifetime_s: f64) -> f64 {
    relaxed(foam, breaking, dt_s, if breaking > foam { GROWTH_S } else { lifetime_s })
}

/// How long a crest breaks at one place, s, seen in texels `texel_m` metres wide: the shortest waves that a texel holds are as long as a
/// few texels, and their period goes with the root of their length. The factor is our own: a fraction (0.15 s) of the second
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

/// One wave of the simulation: what each level sees of its ∇D (xx, yy, xy) per unit of its random amplitude, and its frequency.
/// Single precision: the amplitudes are random.
struct Component<const N: usize> {
    gradient: [[f32; N]; 3],
    omega: f64,
}

/// Root mean square share of a wave (kx, ky), rad/m, that a texel of `texel_m` sees in its tile's textures: it reads the two mip
/// levels on either side of its own size, each the means of blocks of samples, and interpolates between their texels. Equals
/// what `smaller_eigenvalue` in `shaders/foam.wgsl` does.
pub fn kept(tile: &Cascade, texel_m: f64, kx: f64, ky: f64) -> f64 {
    let step = tile.patch_m / tile.n as f64;
    let lod = libm::log2((texel_m / step).max(1.0)).min(f64::from(tile.n.ilog2()) - 2.0);
    let at_mip = |mip: f64| {
        let block = libm::exp2(mip);
        let along = |k: f64| {
            let half = 0.5 * k * step;
            let mean = if half.abs() < 1e-9 { 1.0 } else { libm::sin(half * block) / (block * libm::sin(half)) };
            // A linear interpolation at any place between two values whose phases differ by 2·half·block.
            mean * libm::sqrt((2.0 + libm::cos(2.0 * half * block)) / 3.0)
        };
        along(kx) * along(ky)
    };
    if tile.patch_m < SHORTEST_TILE_TEXELS * texel_m {
        return 0.0;
    }
    let part = lod - libm::floor(lod);
    (1.0 - part) * at_mip(libm::floor(lod)) + part * at_mip(libm::floor(lod) + 1.0)
}

/// Where the levels with texels of `texels_m` (increasing, m) break, such that the mean of F over the water's area is `wanted`
/// (0…1) for a lifetime in seconds; `tiles` hold the waves. `softness` is in root mean squares of the level's own μ. A level whose
/// waves are all too short for it gets [`Fold::NEVER`].
pub fn folds<const N: usize>(
    spectrum: &dyn DirectionalSpectrum,
    tiles: &[Cascade],
    chop: f64,
    texels_m: [f64; N],
    softness: [f64; N],
    wanted: f64,
    lifetime_s: f64,
) -> [Fold; N] {
    let waves = components(spectrum, tiles, texels_m);
    let mut folds = [Fold::NEVER; N];
    if wanted <= 0.0 {
        return folds;
    }
    let mut series: [Vec<(f32, f32)>; N] = std::array::from_fn(|_| Vec::with_capacity(POINTS * INSTANTS));
    (0..POINTS).for_each(|point| simulate(point, &waves, chop as f32, &mut series));
    for ((fold, series), softness) in folds.iter_mut().zip(&series).zip(softness) {
        let lowest = series.iter().map(|(mu, _)| *mu).fold(0.0f32, f32::min);
        let deviation = (series.iter().map(|(mu, _)| f64::from(mu * mu)).sum::<f64>() / series.len() as f64).sqrt();
        if deviation < 1e-3 {
            continue;
        }
        fold.softness = softness * deviation;
        let (mut low, mut high) = (f64::from(lowest), deviation + fold.softness);
        // 11 halvings: 5e-4 of the range.
        for _ in 0..11 {
            fold.threshold = 0.5 * (low + high);
            let mean = mean_foam(series, *fold, lifetime_s);
            if mean < wanted { low = fold.threshold } else { high = fold.threshold }
        }
    }
    folds
}

/// Waves that carry the energy of the spectrum in bands of wave number and direction.
fn components<const N: usize>(
    spectrum: &dyn DirectionalSpectrum,
    tiles: &[Cascade],
    texels_m: [f64; N],
) -> Vec<Component<N>> {
    let finest_m = texels_m.iter().copied().fold(f64::INFINITY, f64::min);
    let from = 0.3 * spectrum.peak_wavenumber();
    let to = std::f64::consts::TAU / (SHORTEST_TEXELS * finest_m);
    let mut waves = Vec::new();
    if from <= 0.0 || to <= from {
        return waves;
    }
    let ratio = libm::pow(to / from, 1.0 / BANDS as f64);
    for band in 0..BANDS {
        let k0 = from * libm::pow(ratio, band as f64);
        let k = k0 * libm::sqrt(ratio);
        let Some(tile) = tiles.iter().find(|tile| k < tile.k_max) else { break };
        let energy = spectrum.omnidirectional(k) * k0 * (ratio - 1.0);
        let density = DIRECTIONS.map(|angle| spectrum.density(k * libm::cos(angle), k * libm::sin(angle)));
        let total: f64 = density.iter().sum();
        for (angle, density) in DIRECTIONS.iter().zip(density).filter(|_| total > 0.0) {
            let (sin, cos) = libm::sincos(*angle);
            // A wave a cos(kx − ωt) has the variance a²/2 and −a kx²/k cos(…) as dDx/dx.
            let slope = k * libm::sqrt(energy * density / total);
            let kept = texels_m.map(|texel_m| kept(tile, texel_m, k * cos, k * sin));
            let gradient = [cos * cos, sin * sin, sin * cos].map(|part| kept.map(|kept| (-slope * part * kept) as f32));
            waves.push(Component { gradient, omega: dispersion::omega_deep(k) });
        }
    }
    waves
}

/// Appends (μ, J) of every level at the instants of one rest point.
fn simulate<const N: usize>(point: usize, waves: &[Component<N>], chop: f32, series: &mut [Vec<(f32, f32)>; N]) {
    // Amplitudes are complex Gaussian, so that the tails are those of a Gaussian sea; each turns on by a fixed angle.
    let mut turning: Vec<_> = waves
        .iter()
        .enumerate()
        .map(|(index, wave)| {
            // Frequencies differ a little from point to point, so that no beat is common to all.
            let [jitter, _] = noise::bits(1, 2_000, point as i32, index as i32);
            let omega = wave.omega * (0.85 + 0.3 * (jitter >> 11) as f64 / (1u64 << 53) as f64);
            let (sin, cos) = libm::sincos(-omega * STEP_S);
            let amplitude = noise::gaussian_pair(0, 2_000, point as i32, index as i32);
            (amplitude.map(|x| x as f32), [cos as f32, sin as f32])
        })
        .collect();
    for _ in 0..INSTANTS {
        let mut sums = [[0.0f32; N]; 3];
        for (wave, (z, turn)) in waves.iter().zip(&mut turning) {
            for (sums, gradients) in sums.iter_mut().zip(&wave.gradient) {
                for (sum, gradient) in sums.iter_mut().zip(gradients) {
                    *sum += gradient * z[0];
                }
            }
            *z = [z[0] * turn[0] - z[1] * turn[1], z[0] * turn[1] + z[1] * turn[0]];
        }
        for (level, series) in series.iter_mut().enumerate() {
            let [xx, yy, xy] = sums.map(|sums| sums[level]);
            let half = 0.5 * (xx - yy);
            let mu = 0.5 * (xx + yy) - (half * half + xy * xy).sqrt();
            let j = (1.0 + chop * xx) * (1.0 + chop * yy) - chop * chop * xy * xy;
            series.push((mu, j.max(0.0)));
        }
    }
}

/// Mean of F over the displaced water's area. Each point's record is run twice, the second time from the state that the first tends
/// to when it is repeated, so that lifetimes longer than the record count in full.
fn mean_foam(series: &[(f32, f32)], fold: Fold, lifetime_s: f64) -> f64 {
    let (grow, keep) = ((-STEP_S / GROWTH_S).exp() as f32, (-STEP_S / lifetime_s).exp() as f32);
    let (threshold, steepness) = (fold.threshold as f32, (1.0 / fold.softness) as f32);
    let step = |f: f32, mu: f32| {
        let breaking = ((threshold - mu) * steepness).clamp(0.0, 1.0);
        breaking + (f - breaking) * if breaking > f { grow } else { keep }
    };
    let left = (-STEP_S * INSTANTS as f64 / lifetime_s).exp() as f32;
    let (mut foam, mut area) = (0.0f64, 0.0f64);
    for record in series.chunks_exact(INSTANTS) {
        // One run maps the start to about a + b·start, with b what a lifetime leaves of it.
        let a = record.iter().fold(0.0, |f, (mu, _)| step(f, *mu));
        let mut f = (a / (1.0 - left).max(1e-6)).min(1.0);
        for (mu, j) in record {
            f = step(f, *mu);
            foam += f64::from(f * j);
            area += f64::from(*j);
        }
    }
    foam / area.max(1e-9)
}
