//! The waves of a sea as the GPU takes them: amplitudes and frequencies of all patches, made once for all who draw, ride or measure it.
//!
//! Four patches of 2048² samples hold 16.8 million waves, seconds of work, so they can be made row by row over many frames
//! ([`Making::advance`]). Rejected: amplitudes made by the GPU, whose logarithms and sines differ from one driver to the next, so that
//! two viewers would see two seas.

use std::sync::Arc;

use super::modes::Mode;
use super::sea_spectrum::SeaSpectrum;
use super::sea_tables::SeaTables;
use super::waves::{self, CASCADES, Cascade, Cells, Patch};

/// Amplitudes, frequencies and scales of all cascades, one after another.
#[derive(Clone, Debug)]
pub struct WaveData {
    /// Depth of the water that they run over, m; infinite for deep water.
    pub depth_m: f64,
    /// h0(k), metres, in wave index order.
    pub amplitudes: Vec<[f32; 2]>,
    /// Cycles per tick in fixed point, low and high word. They depend on patches and depth alone, so seas share them.
    pub frequencies: Arc<Vec<[u32; 2]>>,
    /// See [`scales`], one for each cascade.
    pub scales: Vec<[[f32; 4]; 2]>,
}

impl Default for WaveData {
    /// Deep water without waves.
    fn default() -> Self {
        Self { depth_m: f64::INFINITY, amplitudes: Vec::new(), frequencies: Arc::default(), scales: Vec::new() }
    }
}

impl WaveData {
    /// All cascades of a sea, at once.
    pub fn of(tables: &SeaTables) -> Self {
        Making::new(tables, None).finish()
    }

    /// Appends one cascade from f64 amplitudes and frequencies (rad/s) in wave index order.
    pub fn push(&mut self, cascade: &Cascade, amplitudes: &[[f64; 2]], omegas: &[f64]) {
        let start = self.amplitudes.len();
        self.amplitudes.extend(amplitudes.iter().map(|h| h.map(|x| x as f32)));
        Arc::make_mut(&mut self.frequencies).extend(omegas.iter().map(|&omega| words(waves::cycles_per_tick(omega))));
        self.scales.push(scales(cascade, &self.amplitudes[start..]));
    }

    /// Amplitudes of cascade number `index` of patches with `n` by `n` samples.
    pub fn amplitudes_of(&self, index: usize, n: usize) -> &[[f32; 2]] {
        &self.amplitudes[index * n * n..(index + 1) * n * n]
    }

    /// Cycles per tick of each element of cascade number `index` of patches with `n` by `n` samples.
    pub fn frequencies_of(&self, index: usize, n: usize) -> impl Fn(usize) -> u64 {
        let words = &self.frequencies[index * n * n..(index + 1) * n * n];
        |element| u64::from(words[element][1]) << 32 | u64::from(words[element][0])
    }
}

/// Low and high word.
pub fn words(x: u64) -> [u32; 2] {
    [x as u32, (x >> 32) as u32]
}

/// Rows that are made together: enough for all cores, few enough for a slice of a frame.
const BATCH: usize = 16;

/// Wave data that is being made.
#[derive(Debug)]
pub struct Making {
    cascades: [Cascade; CASCADES],
    spectrum: SeaSpectrum,
    modes: Vec<Mode>,
    seed: u32,
    /// Where they are to be made: the depth.
    frequencies: Option<(f64, Vec<[u32; 2]>)>,
    powers: [Power; CASCADES],
    data: WaveData,
    /// The next row, counted through all cascades.
    row: usize,
}

impl Making {
    /// The waves of a sea, with the frequencies of another sea on the same patches in the same depth where there are some.
    pub fn new(tables: &SeaTables, frequencies: Option<Arc<Vec<[u32; 2]>>>) -> Self {
        let count = CASCADES * tables.cascades[0].n.pow(2);
        let wanted = frequencies.is_none().then(|| (tables.sea.depth_m, Vec::with_capacity(count)));
        let data = WaveData {
            depth_m: tables.sea.depth_m,
            amplitudes: Vec::with_capacity(count),
            frequencies: frequencies.unwrap_or_default(),
            scales: Vec::with_capacity(CASCADES),
        };
        Self {
            cascades: tables.cascades,
            spectrum: tables.sea.drawn_spectrum(),
            modes: tables.sea.modes(),
            seed: tables.sea.seed,
            frequencies: wanted,
            powers: Default::default(),
            data,
            row: 0,
        }
    }

    /// Makes more rows until `work` is done, at least a few; one is an evaluation of the spectrum, or 16 elements without one.
    /// Returns the evaluations.
    pub fn advance(&mut self, work: usize) -> usize {
        let (n, mut done, mut evaluations) = (self.cascades[0].n, 0, 0);
        while done < work && !self.is_complete() {
            let rows = self.row..(self.row + BATCH).min(CASCADES * n);
            done += rows.len() * n / 16;
            for row in self.rows(rows.clone()) {
                self.data.amplitudes.extend(row.amplitudes);
                self.powers[self.row / n].add(&row.power);
                evaluations += row.evaluations;
                done += row.evaluations;
                if let Some((depth_m, frequencies)) = &mut self.frequencies {
                    push_frequencies(frequencies, &self.cascades[self.row / n], self.row % n, *depth_m);
                }
                self.row += 1;
            }
        }
        evaluations
    }

    /// Whether all is made.
    pub fn is_complete(&self) -> bool {
        self.row == CASCADES * self.cascades[0].n
    }

    /// The rest at once.
    pub fn finish(mut self) -> WaveData {
        self.advance(usize::MAX);
        for (power, cascade) in self.powers.iter().zip(&self.cascades) {
            self.data.scales.push(power.scales(cascade.n));
        }
        if let Some((_, frequencies)) = self.frequencies {
            self.data.frequencies = Arc::new(frequencies);
        }
        self.data
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn rows(&self, rows: std::ops::Range<usize>) -> Vec<Row> {
        use rayon::prelude::*;
        rows.into_par_iter().map(|row| self.make_row(row)).collect()
    }

    #[cfg(target_arch = "wasm32")]
    fn rows(&self, rows: std::ops::Range<usize>) -> Vec<Row> {
        rows.map(|row| self.make_row(row)).collect()
    }

    fn make_row(&self, row: usize) -> Row {
        let n = self.cascades[0].n;
        let (index, patch) = (row / n, Patch::from(&self.cascades[row / n]));
        let mut cells = Cells::new(&self.spectrum, patch);
        let mut made = Row { amplitudes: Vec::with_capacity(n), power: Power::default(), evaluations: 0 };
        let is_here = |mode: &&Mode| mode.cascade == index && mode.element(n) / n == row % n;
        let modes: Vec<&Mode> = self.modes.iter().filter(is_here).collect();
        for element in row % n * n..(row % n + 1) * n {
            let energy = cells.energy(element);
            let mut h = waves::amplitude(energy, self.seed, index, &patch, element);
            for mode in modes.iter().filter(|mode| mode.element(n) == element) {
                h = [h[0] + mode.h0[0], h[1] + mode.h0[1]];
            }
            let h = h.map(|x| x as f32);
            made.power.count(patch.wave_vector(element), h);
            made.amplitudes.push(h);
        }
        made.evaluations = cells.evaluations;
        made
    }
}

/// One row of a patch.
struct Row {
    amplitudes: Vec<[f32; 2]>,
    power: Power,
    evaluations: usize,
}

/// Appends row `j` of a patch, after those before it. ω depends on |k|, so that an eighth of the patch holds all of them, bit for bit.
fn push_frequencies(frequencies: &mut Vec<[u32; 2]>, cascade: &Cascade, j: usize, depth_m: f64) {
    let n = cascade.n;
    let (patch, start) = (Patch::from(cascade), frequencies.len() - j * n);
    if j > n / 2 {
        return frequencies.extend_from_within(start + (n - j) * n..start + (n - j + 1) * n);
    }
    for i in 0..n {
        let known = if i > n / 2 { Some(j * n + n - i) } else { (i < j).then_some(i * n + j) };
        frequencies.push(match known {
            Some(at) => frequencies[start + at],
            None => words(waves::cycles_per_tick(waves::angular_frequency(patch.wave_vector(j * n + i), depth_m))),
        });
    }
}

/// Sums over waves of their squares as the eight fields see them.
#[derive(Clone, Copy, Debug, Default)]
struct Power([f64; 8]);

impl Power {
    fn count(&mut self, (kx, ky): (f64, f64), h: [f32; 2]) {
        let power = f64::from(h[0]).powi(2) + f64::from(h[1]).powi(2);
        if power > 0.0 {
            let (x, y) = (kx * kx, ky * ky);
            let k = (x + y).max(f64::MIN_POSITIVE);
            let squares = [x / k, y / k, 1.0, x * y / k, x, y, x * x / k, y * y / k];
            self.0.iter_mut().zip(squares).for_each(|(sum, m)| *sum += m * power);
        }
    }

    fn add(&mut self, other: &Self) {
        self.0.iter_mut().zip(other.0).for_each(|(sum, more)| *sum += more);
    }

    fn scales(&self, n: usize) -> [[f32; 4]; 2] {
        let factor = |sum: f64| {
            let exponent = (0.5 * (n as f64 / (2.0 * sum)).log2()).round().clamp(-60.0, 60.0);
            if sum > 0.0 { exponent.exp2() as f32 } else { 1.0 }
        };
        [0, 4].map(|start| std::array::from_fn(|i| factor(self.0[start + i])))
    }
}

/// Factors that bring the eight fields of a patch, halfway through the transform, to a root mean square of about one: so neither of
/// two fields that share a complex number is lost in the other's rounding, and 16-bit floats neither overflow nor vanish.
///
/// Order: Dx, Dy, h, dDx/dy; dh/dx, dh/dy, dDx/dx, dDy/dy. Powers of two, so that they cost no rounding; 1 for a field that is zero.
/// A field with multiplier m(k) has the variance 2 Σ m² |h0|² in the mean over time; halfway its N² samples still hold the
/// energy of N rows, hence √N over it.
pub fn scales(cascade: &Cascade, amplitudes: &[[f32; 2]]) -> [[f32; 4]; 2] {
    let mut power = Power::default();
    cascade.wave_vectors().zip(amplitudes).for_each(|(k, h)| power.count(k, *h));
    power.scales(cascade.n)
}
