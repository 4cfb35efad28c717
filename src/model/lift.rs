//! The drawn surface at one place, its waves summed there one by one, each as the linear interpolation between its tile's samples
//! leaves it: the surface of [`super::drawn_tiles`] without their transforms, for an eye that rides on it.

use glam::{DVec2, DVec3};

use super::fft::{Complex, mul};
use super::moved_water::{Motion, between_samples};
use super::sea_tables::SeaTables;
use super::surface::{evolve, gain_of, phase_at};
use super::waves::{self, Cascade, Tile};

/// Waves lower than this share of the significant height do not lift the eye.
const NOTICED: f64 = 5e-5;

/// A wave and its mirror −k, which make a real wave together.
struct Wave {
    /// Column and row in the tile.
    at: [usize; 2],
    k: DVec2,
    h0: Complex,
    h0_mirror: Complex,
    cycles_per_tick: u64,
}

/// The waves of a cascade that move an eye noticeably.
pub struct Lift {
    n: usize,
    patch_m: f64,
    /// e^{2πi/n} to the power 0…n − 1.
    turns: Vec<Complex>,
    waves: Vec<Wave>,
}

impl Lift {
    /// The waves of cascade number `index`.
    pub fn new(tables: &SeaTables, index: usize, cascade: &Cascade) -> Self {
        let (tile, n) = (Tile::from(cascade), cascade.n);
        let h0 = waves::initial_amplitudes(&tables.sea, index, cascade);
        let omegas = tables.frequencies(cascade);
        let noticed = NOTICED * tables.sea.hs_m;
        let size = |i: usize| h0[i][0].hypot(h0[i][1]);
        let big = (0..tile.count()).filter(|&i| i < tile.mirror(i) && size(i) + size(tile.mirror(i)) > noticed);
        let sharpened = |i: usize| h0[i].map(|part| part * gain_of(tile, i));
        let waves = big.map(|i| Wave {
            at: [i % n, i / n],
            k: tile.wave_vector(i).into(),
            h0: sharpened(i),
            h0_mirror: sharpened(tile.mirror(i)),
            cycles_per_tick: waves::cycles_per_tick(omegas[i]),
        });
        let turn = |i: usize| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / n as f64).sin_cos();
            [cos, sin]
        };
        Self { n, patch_m: cascade.patch_m, turns: (0..n).map(turn).collect(), waves: waves.collect() }
    }

    /// H(k) of every wave at a tick.
    pub fn evolved(&self, ticks: u64) -> Vec<Complex> {
        let h = |w: &Wave| evolve(w.h0, w.h0_mirror, 0.0, phase_at(w.cycles_per_tick, ticks)).0;
        self.waves.iter().map(h).collect()
    }

    /// e^{ikx} for every wave number of an axis, linearly between the samples around coordinate `at`, m.
    fn factors(&self, at: f64) -> Vec<Complex> {
        let (low, way) = between_samples(at, self.patch_m, self.n);
        let mix = |i: usize| {
            let (a, b) = (self.turns[i * low % self.n], self.turns[i * (low + 1) % self.n]);
            [a[0] + way * (b[0] - a[0]), a[1] + way * (b[1] - a[1])]
        };
        (0..self.n).map(mix).collect()
    }

    /// The motion at tile coordinates `at`, m, from the waves' H(k).
    pub fn motion(&self, evolved: &[Complex], at: DVec2) -> Motion {
        let (along_x, along_y) = (self.factors(at.x), self.factors(at.y));
        let mut sum = Motion::default();
        for (wave, h) in self.waves.iter().zip(evolved) {
            let turned = mul(*h, mul(along_x[wave.at[0]], along_y[wave.at[1]]));
            // Twice the real part, for the mirrored wave too.
            let (re, im) = (2.0 * turned[0], 2.0 * turned[1]);
            let (k, unit) = (wave.k, wave.k.normalize());
            sum += Motion {
                height: re,
                shift: -im * unit,
                slope: -im * k,
                stretch: -re * DVec3::new(k.x * unit.x, k.y * unit.y, k.x * unit.y),
            };
        }
        sum
    }
}
