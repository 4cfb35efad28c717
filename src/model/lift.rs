//! The drawn surface at one place, its waves summed there one by one, each as the linear interpolation between its patch's samples
//! leaves it: the surface of [`super::drawn_patches`] without their transforms, for an eye that rides on it.
//!
//! Where the water at a place has come from is found with the few waves that hold most of the energy, then with all of them: an
//! evaluation of all costs fourteen times as much, and from that close two or three of them are enough.

use glam::{DVec2, DVec3};

use super::dispersion;
use super::fft::{Complex, mul};
use super::moved_water::{Motion, Place, between_samples};
use super::sea_tables::SeaTables;
use super::surface::gain_of;
use super::wave_data::WaveData;
use super::waves::{CASCADES, Cascade, Patch, phase_u32};

/// Waves lower than this share of the significant height do not lift the eye.
const NOTICED: f64 = 5e-5;
/// Share of the energy of the waves that find the place first.
const LEADING: f64 = 0.95;
/// Waves of a patch with higher indices than this, which only patches of more than 256 samples have, are too low to be noticed.
const HIGHEST: i32 = 128;
/// How near the place the first waves must bring the water, and all of them, m. A slope of 0.3 makes 0.3 mm of the latter.
const NEAR_M: [f64; 2] = [0.02, 0.001];
/// Steps of a turn whose sines are tabulated.
const TURN: usize = 4096;

/// A wave and its mirror −k, which make a real wave together.
struct Wave {
    /// Its column in [`Axis`].
    column: usize,
    /// rad/m.
    kx: f64,
    /// 1/|k|, m.
    per_k: f64,
    /// The parts of H(k) that go with cos ωt and with sin ωt.
    parts: [Complex; 2],
    cycles_per_tick: u64,
}

/// Waves with one ky.
struct Row {
    row: usize,
    ky: f64,
    waves: Vec<Wave>,
}

/// The noticed waves of a cascade: those that find the place, and the others.
struct LiftedPatch {
    n: usize,
    patch_m: f64,
    /// Columns and rows that have waves, from −`reach` to `reach`.
    reach: i32,
    /// e^{2πi/n} to the power 0…n − 1.
    turns: Vec<Complex>,
    rows: [Vec<Row>; 2],
}

/// The waves of a sea that move an eye noticeably.
pub struct Lift {
    patches: Vec<LiftedPatch>,
    /// Cosine and sine of each of [`TURN`] steps.
    circle: Vec<Complex>,
}

/// H(k) of the waves of [`LiftedPatch::rows`] at an instant.
type Evolved = [Vec<Complex>; 2];

impl Lift {
    /// The waves of a sea.
    pub fn new(tables: &SeaTables, data: &WaveData) -> Self {
        let noticed: Vec<Vec<Noticed>> =
            tables.cascades.iter().enumerate().map(|(index, cascade)| noticed(tables, data, index, cascade)).collect();
        // The least energy of the waves that together hold the leading share.
        let mut energies: Vec<f64> = noticed.iter().flatten().map(|wave| wave.energy).collect();
        energies.sort_by(|a, b| b.total_cmp(a));
        let mut left = LEADING * energies.iter().sum::<f64>();
        let last = energies.iter().find(|energy| {
            left -= *energy;
            left <= 0.0
        });
        let least = last.copied().unwrap_or(0.0);
        let patches = tables.cascades.iter().zip(noticed).enumerate();
        let patches =
            patches.map(|(index, (cascade, noticed))| LiftedPatch::new(data, index, cascade, &noticed, least));
        Self { patches: patches.collect(), circle: (0..TURN).map(|i| turned(i as f64 / TURN as f64)).collect() }
    }

    /// How many waves these are.
    pub fn waves(&self) -> usize {
        self.patches.iter().flat_map(|patch| patch.rows.iter().flatten()).map(|row| row.waves.len()).sum()
    }

    /// Height of the water over `place` at a tick under a chop λ, m, where the waves of each patch are `gains` times as high.
    pub fn height(&self, place: &Place, chop: f64, ticks: u64, gains: [f64; CASCADES]) -> f64 {
        let evolved: Vec<Evolved> = self.patches.iter().map(|patch| self.evolved(patch, ticks)).collect();
        let leading = |index: usize, at| self.patches[index].motion(&evolved[index], 1, at).gained(gains[index]);
        let all = |index: usize, at| self.patches[index].motion(&evolved[index], 2, at).gained(gains[index]);
        let (near, _) = place.invert_from(DVec2::ZERO, chop, NEAR_M[0], leading);
        place.invert_from(near, chop, NEAR_M[1], all).1.height
    }

    fn evolved(&self, patch: &LiftedPatch, ticks: u64) -> Evolved {
        patch.rows.each_ref().map(|rows| {
            let h = |wave: &Wave| {
                let [cos, sin] = self.turn(phase_u32(wave.cycles_per_tick, ticks));
                let [with_cos, with_sin] = wave.parts;
                [with_cos[0] * cos + with_sin[0] * sin, with_cos[1] * cos + with_sin[1] * sin]
            };
            rows.iter().flat_map(|row| &row.waves).map(h).collect()
        })
    }

    /// Cosine and sine of a phase in 2⁻³² cycles, within 3e-13: the rest of a step is at most 1.6e-3, and its fourth power over 24
    /// what is left out.
    fn turn(&self, phase: u32) -> Complex {
        let step = u32::BITS - TURN.ilog2();
        let rest = f64::from(phase & ((1 << step) - 1)) * (std::f64::consts::TAU / 4_294_967_296.0);
        let square = rest * rest;
        mul(self.circle[(phase >> step) as usize], [1.0 - 0.5 * square, rest * (1.0 - square / 6.0)])
    }
}

/// e^{2πix}.
fn turned(x: f64) -> Complex {
    let (sin, cos) = libm::sincos(std::f64::consts::TAU * x);
    [cos, sin]
}

/// A wave that moves an eye: its signed indices, and its energy with its mirror's.
struct Noticed {
    energy: f64,
    i: i32,
    j: i32,
}

/// Index in a patch of `n` by `n` samples of signed indices.
fn element(i: i32, j: i32, n: usize) -> usize {
    let wrapped = |i: i32| i.rem_euclid(n as i32) as usize;
    wrapped(j) * n + wrapped(i)
}

/// Highest index of a noticed wave in a patch of `n` by `n` samples.
fn reach(n: usize) -> i32 {
    HIGHEST.min(n as i32 / 2 - 1)
}

/// The noticed waves of cascade number `index`, row by row; of each pair the one with positive ky, or kx where that is 0.
fn noticed(tables: &SeaTables, data: &WaveData, index: usize, cascade: &Cascade) -> Vec<Noticed> {
    let (n, reach, least) = (cascade.n, reach(cascade.n), NOTICED * tables.sea.hs_m);
    let h0 = data.amplitudes_of(index, n);
    let square = |i: usize| f64::from(h0[i][0]).powi(2) + f64::from(h0[i][1]).powi(2);
    let half = (0..=reach).flat_map(|j| (-reach..=reach).map(move |i| (i, j))).filter(|&(i, j)| j > 0 || i > 0);
    half.filter_map(|(i, j)| {
        let [with, against] = [element(i, j, n), element(-i, -j, n)].map(square);
        (with.sqrt() + against.sqrt() > least).then_some(Noticed { energy: with + against, i, j })
    })
    .collect()
}

impl LiftedPatch {
    /// The noticed waves of cascade number `index`; those of at least the energy `least` lead.
    fn new(data: &WaveData, index: usize, cascade: &Cascade, noticed: &[Noticed], least: f64) -> Self {
        let (patch, n) = (Patch::from(cascade), cascade.n);
        let (reach, h0) = (reach(n), data.amplitudes_of(index, n));
        let frequencies = data.frequencies_of(index, n);
        let mut rows = [const { Vec::<Row>::new() }; 2];
        for &Noticed { energy, i, j } in noticed {
            let rows = &mut rows[usize::from(energy < least)];
            let (with, against) = (element(i, j, n), element(-i, -j, n));
            let (kx, ky) = patch.wave_vector(with);
            let gain = gain_of(patch, with);
            let [[a, b], [c, d]] = [with, against].map(|i| h0[i].map(|part| gain * f64::from(part)));
            let row = (j + reach) as usize;
            if rows.last().is_none_or(|last| last.row != row) {
                rows.push(Row { row, ky, waves: Vec::new() });
            }
            let wave = Wave {
                column: (i + reach) as usize,
                kx,
                per_k: dispersion::orbit_ratio(libm::hypot(kx, ky), data.depth_m) / libm::hypot(kx, ky),
                // h0 (cos − i sin) + conj(h0(−k)) (cos + i sin).
                parts: [[a + c, b - d], [b + d, c - a]],
                cycles_per_tick: frequencies(with),
            };
            rows.last_mut().expect("a row has just been made").waves.push(wave);
        }
        Self { n, patch_m: cascade.patch_m, reach, turns: (0..n).map(|i| turned(i as f64 / n as f64)).collect(), rows }
    }

    /// e^{ikx} for the wave numbers −reach…reach of an axis, linearly between the samples around coordinate `at`, m.
    fn factors(&self, at: f64) -> Vec<Complex> {
        let (low, way) = between_samples(at, self.patch_m, self.n);
        let mix = |i: i32| {
            let turn = |sample: usize| self.turns[(i as isize * sample as isize).rem_euclid(self.n as isize) as usize];
            let (a, b) = (turn(low), turn(low + 1));
            [a[0] + way * (b[0] - a[0]), a[1] + way * (b[1] - a[1])]
        };
        (-self.reach..=self.reach).map(mix).collect()
    }

    /// The motion at patch coordinates `at`, m, by the first `parts` of the waves.
    fn motion(&self, evolved: &Evolved, parts: usize, at: DVec2) -> Motion {
        let (along_x, along_y) = (self.factors(at.x), self.factors(at.y));
        let mut sum = Motion::default();
        for (rows, evolved) in self.rows.iter().zip(evolved).take(parts) {
            let mut evolved = evolved.iter();
            for row in rows {
                // Sums of H e^{ikx} times 1, kx, 1/k, kx/k, kx²/k: written out, since a build for tests unrolls no loop.
                let [mut one, mut x, mut per, mut x_per, mut xx_per] = [DVec2::ZERO; 5];
                for (wave, h) in row.waves.iter().zip(&mut evolved) {
                    let turned = DVec2::from(mul(*h, along_x[wave.column]));
                    let over_k = wave.per_k * turned;
                    one += turned;
                    x += wave.kx * turned;
                    per += over_k;
                    x_per += wave.kx * over_k;
                    xx_per += wave.kx * wave.kx * over_k;
                }
                // Twice the real part, for the mirrored waves too.
                let turn = along_y[row.row].map(|part| 2.0 * part);
                let [one, x, per, x_per, xx_per] = [one, x, per, x_per, xx_per].map(|sum| mul(sum.to_array(), turn));
                let ky = row.ky;
                sum += Motion {
                    height: one[0],
                    shift: -DVec2::new(x_per[1], ky * per[1]),
                    slope: -DVec2::new(x[1], ky * one[1]),
                    stretch: -DVec3::new(xx_per[0], ky * ky * per[0], ky * x_per[0]),
                };
            }
        }
        sum
    }
}
