//! The thresholds of the foam map's levels: a simulation of ∇D at independent rest points, and the bisection that finds where a level
//! must begin to break. See [`super`] for why.
//!
//! The simulation knows the spectrum and the patches alone, so it serves any amount, lifetime and chop of one sea; it can be made point by
//! point, and any part of its points gives an estimate.

use super::{Fold, GROWTH_S};
use crate::model::modes::{self, Mode};
use crate::model::{cascade::Cascade, dispersion, noise, spectrum::DirectionalSpectrum};

/// Independent rest points.
pub const POINTS: usize = 6144;
/// Instants of each and the time between them, s.
pub const INSTANTS: usize = 32;
const STEP_S: f64 = 0.15;
/// Bands of wave numbers, from below the peak to [`SHORTEST_TEXELS`] of the finest level.
const BANDS: usize = 12;
/// Parts of a band that its variance is summed from.
const PARTS: usize = 8;
/// Waves of fewer texels than this move no level.
const SHORTEST_TEXELS: f64 = 1.5;
/// A patch shorter than so many texels moves a level by next to nothing: its longest waves are a sixth of it. Equals
/// `SHORTEST_PATCH_TEXELS` in `shaders/foam.wgsl`.
pub const SHORTEST_PATCH_TEXELS: f64 = 10.0;
/// Directions off the wind, radians: the middles of six sectors of the half circle before it.
const DIRECTIONS: [f64; 6] = [-5.0 * SECTOR, -3.0 * SECTOR, -SECTOR, SECTOR, 3.0 * SECTOR, 5.0 * SECTOR];
/// Half a sector, 15°.
const SECTOR: f64 = std::f64::consts::PI / 12.0;

/// One wave of the simulation: what each level sees of its ∇D (xx, yy, xy) per unit of its random amplitude, and its frequency.
/// Single precision: the amplitudes are random.
struct Component<const N: usize> {
    gradient: [[f32; N]; 3],
    omega: f64,
    /// Whether its amplitude is always the same, and only its phase random.
    is_single: bool,
}

/// ∇D of a level at an instant: its smaller eigenvalue, its trace and its determinant.
#[derive(Clone, Copy)]
struct Gradient {
    mu: f32,
    trace: f32,
    determinant: f32,
}

impl Gradient {
    /// Area per area at rest under a chop λ, at least 0.
    fn jacobian(self, chop: f32) -> f32 {
        (1.0 + chop * self.trace + chop * chop * self.determinant).max(0.0)
    }
}

/// What a level has seen of ∇D.
struct Series {
    /// [`INSTANTS`] of each point, point after point.
    gradients: Vec<Gradient>,
    /// The smallest μ of each point: where it is over the threshold, there is no foam.
    lowest: Vec<f32>,
}

/// ∇D over time at independent rest points, as levels with texels of N sizes see it.
pub struct Simulation<const N: usize> {
    waves: Vec<Component<N>>,
    levels: [Series; N],
}

/// Root mean square share of a wave (kx, ky), rad/m, that a texel of `texel_m` sees in its patch's textures: it reads the two
/// mips on either side of its own size, each the means of blocks of samples, and interpolates between their texels. Equals what
/// `smaller_eigenvalue` in `shaders/foam.wgsl` does.
pub fn kept(patch: &Cascade, texel_m: f64, kx: f64, ky: f64) -> f64 {
    let step = patch.patch_m / patch.n as f64;
    let lod = libm::log2((texel_m / step).max(1.0)).min(f64::from(patch.n.ilog2()) - 2.0);
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
    if patch.patch_m < SHORTEST_PATCH_TEXELS * texel_m {
        return 0.0;
    }
    let part = lod - libm::floor(lod);
    (1.0 - part) * at_mip(libm::floor(lod)) + part * at_mip(libm::floor(lod) + 1.0)
}

impl<const N: usize> Simulation<N> {
    /// The simulation of a sea's waves over water `depth_m` deep as levels with texels of `texels_m` (increasing, m) see them, still without any
    /// point; `patches` hold the waves.
    pub fn new(spectrum: &dyn DirectionalSpectrum, depth_m: f64, patches: &[Cascade], texels_m: [f64; N]) -> Self {
        let empty = |_| Series { gradients: Vec::with_capacity(POINTS * INSTANTS), lowest: Vec::with_capacity(POINTS) };
        Self { waves: components(spectrum, depth_m, patches, texels_m), levels: std::array::from_fn(empty) }
    }

    /// The simulation with single waves besides those of the spectrum.
    pub fn with_modes(mut self, modes: &[Mode], patches: &[Cascade], texels_m: [f64; N]) -> Self {
        self.waves.extend(modes.iter().map(|mode| {
            let ([x, y], k) = (mode.wave_vector, mode.wavenumber());
            // −kx²/k of a wave of the same variance as each of the others, a²/2.
            let parts = [x * x, y * y, x * y].map(|part| -part / k * libm::sqrt(mode.variance()));
            let seen = texels_m.map(|texel_m| kept(&patches[mode.cascade], texel_m, x, y));
            let gradient = parts.map(|part| seen.map(|seen| (part * seen) as f32));
            Component { gradient, omega: modes::frequency(mode), is_single: true }
        }));
        self
    }

    /// Simulates at most `points` more rest points, up to [`POINTS`]. Returns the steps that waves were moved on by.
    pub fn advance(&mut self, points: usize) -> usize {
        let from = self.points();
        let to = POINTS.min(from + points);
        (from..to).for_each(|point| simulate(point, &self.waves, &mut self.levels));
        (to - from) * INSTANTS * self.waves.len()
    }

    /// Where the levels break, by all points, such that the mean of F over the water's area is `wanted` (0…1) for a lifetime in
    /// seconds. `softness` is in root mean squares of the level's own μ. A level whose waves are all too short for it gets
    /// [`Fold::NEVER`].
    pub fn folds(mut self, chop: f64, softness: [f64; N], wanted: f64, lifetime_s: f64) -> [Fold; N] {
        if wanted <= 0.0 {
            return [Fold::NEVER; N];
        }
        self.advance(POINTS);
        std::array::from_fn(|level| self.fold(level, POINTS, chop, softness[level], wanted, lifetime_s))
    }

    /// How many points have been simulated.
    pub fn points(&self) -> usize {
        self.levels.first().map_or(POINTS, |level| level.lowest.len())
    }

    /// Where a level breaks, as [`Simulation::folds`], by the first `points` of those that have been simulated.
    pub fn fold(&self, level: usize, points: usize, chop: f64, softness: f64, wanted: f64, lifetime_s: f64) -> Fold {
        let points = points.min(self.points());
        let Series { gradients, lowest } = &self.levels[level];
        let (gradients, lowest) = (&gradients[..points * INSTANTS], &lowest[..points]);
        let deviation =
            (gradients.iter().map(|g| f64::from(g.mu * g.mu)).sum::<f64>() / gradients.len().max(1) as f64).sqrt();
        if wanted <= 0.0 || deviation < 1e-3 {
            return Fold::NEVER;
        }
        let area: f64 = gradients.iter().map(|g| f64::from(g.jacobian(chop as f32))).sum();
        let mut fold = Fold { softness: softness * deviation, ..Fold::NEVER };
        let (mut low, mut high) = (f64::from(lowest.iter().copied().fold(0.0, f32::min)), deviation + fold.softness);
        // 11 halvings: 5e-4 of the range.
        for _ in 0..11 {
            fold.threshold = 0.5 * (low + high);
            let mean = foam_area(gradients, lowest, chop as f32, fold, lifetime_s) / area.max(1e-9);
            if mean < wanted { low = fold.threshold } else { high = fold.threshold }
        }
        fold
    }
}

/// Waves that carry the energy of the spectrum in bands of wave number and direction.
fn components<const N: usize>(
    spectrum: &dyn DirectionalSpectrum,
    depth_m: f64,
    patches: &[Cascade],
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
        // Variance of ∇·D that each level sees of the waves of each direction. A band is wider than the spectrum's peak and than the
        // end of what a texel sees, and a little too much variance is half as many whitecaps again: summed in parts.
        let mut seen = [[0.0; N]; DIRECTIONS.len()];
        let part = libm::pow(ratio, 1.0 / PARTS as f64);
        for index in 0..PARTS {
            let k = k0 * libm::pow(part, index as f64 + 0.5);
            let Some(patch) = patches.iter().find(|patch| k < patch.k_max) else { break };
            let density = DIRECTIONS.map(|angle| spectrum.density(k * libm::cos(angle), k * libm::sin(angle)));
            let total: f64 = density.iter().sum();
            let stretch = k * dispersion::orbit_ratio(k, depth_m);
            let stretches = stretch * stretch * spectrum.omnidirectional(k) * k * libm::log(part);
            for ((angle, density), seen) in DIRECTIONS.iter().zip(density).zip(&mut seen).filter(|_| total > 0.0) {
                let (sin, cos) = libm::sincos(*angle);
                for (seen, texel_m) in seen.iter_mut().zip(texels_m) {
                    let kept = kept(patch, texel_m, k * cos, k * sin);
                    *seen += stretches * density / total * kept * kept;
                }
            }
        }
        let omega = dispersion::omega_finite(k0 * libm::sqrt(ratio), depth_m);
        for (angle, seen) in DIRECTIONS.iter().zip(seen).filter(|(_, seen)| seen.iter().any(|seen| *seen > 0.0)) {
            let (sin, cos) = libm::sincos(*angle);
            // A wave a cos(kx − ωt) has the variance a²/2 and −a coth kh kx²/k cos(…) as dDx/dx.
            let gradient =
                [cos * cos, sin * sin, sin * cos].map(|part| seen.map(|seen| (-part * libm::sqrt(seen)) as f32));
            waves.push(Component { gradient, omega, is_single: false });
        }
    }
    waves
}

/// Appends what every level sees at the instants of one rest point.
fn simulate<const N: usize>(point: usize, waves: &[Component<N>], levels: &mut [Series; N]) {
    // Amplitudes are complex Gaussian, so that the tails are those of a Gaussian sea; each turns on by a fixed angle.
    let mut turning: Vec<_> = waves
        .iter()
        .enumerate()
        .map(|(index, wave)| {
            // Frequencies differ a little from point to point, so that no beat is common to all.
            let [jitter, _] = noise::bits(1, 2_000, point as i32, index as i32);
            let omega = wave.omega * (0.85 + 0.3 * (jitter >> 11) as f64 / (1u64 << 53) as f64);
            let (sin, cos) = libm::sincos(-omega * STEP_S);
            let mut amplitude = noise::gaussian_pair(0, 2_000, point as i32, index as i32);
            if wave.is_single {
                let to_unit = std::f64::consts::SQRT_2 / libm::hypot(amplitude[0], amplitude[1]).max(f64::MIN_POSITIVE);
                amplitude = amplitude.map(|x| to_unit * x);
            }
            (amplitude.map(|x| x as f32), [cos as f32, sin as f32])
        })
        .collect();
    let mut lowest = [f32::INFINITY; N];
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
        for (level, (series, lowest)) in levels.iter_mut().zip(&mut lowest).enumerate() {
            let [xx, yy, xy] = sums.map(|sums| sums[level]);
            let half = 0.5 * (xx - yy);
            let mu = 0.5 * (xx + yy) - (half * half + xy * xy).sqrt();
            *lowest = lowest.min(mu);
            series.gradients.push(Gradient { mu, trace: xx + yy, determinant: xx * yy - xy * xy });
        }
    }
    for (series, lowest) in levels.iter_mut().zip(lowest) {
        series.lowest.push(lowest);
    }
}

/// Foam by area, summed over points and instants. Each point's record is run twice, the second time from the state that the first
/// tends to when it is repeated, so that lifetimes longer than the record count in full.
fn foam_area(gradients: &[Gradient], lowest: &[f32], chop: f32, fold: Fold, lifetime_s: f64) -> f64 {
    let (grow, keep) = ((-STEP_S / GROWTH_S).exp() as f32, (-STEP_S / lifetime_s).exp() as f32);
    let (threshold, steepness) = (fold.threshold as f32, (1.0 / fold.softness) as f32);
    let step = |f: f32, mu: f32| {
        let breaking = ((threshold - mu) * steepness).clamp(0.0, 1.0);
        breaking + (f - breaking) * if breaking > f { grow } else { keep }
    };
    let left = (-STEP_S * INSTANTS as f64 / lifetime_s).exp() as f32;
    let mut foam = 0.0f64;
    for (record, _) in gradients.chunks_exact(INSTANTS).zip(lowest).filter(|(_, lowest)| **lowest < threshold) {
        // One run maps the start to about a + b·start, with b what a lifetime leaves of it.
        let a = record.iter().fold(0.0, |f, gradient| step(f, gradient.mu));
        let mut f = (a / (1.0 - left).max(1e-6)).min(1.0);
        for gradient in record {
            f = step(f, gradient.mu);
            foam += f64::from(f * gradient.jacobian(chop));
        }
    }
    foam
}
