//! What the wave transform is fed with, and how large its fields become.

use crate::model::sea_tables::SeaTables;
use crate::model::waves::{self, Cascade};

/// Amplitudes and frequencies of all cascades, one after another: what the waves of a sea are made of.
#[derive(Clone, Debug, Default)]
pub struct WaveData {
    /// h0(k), metres.
    pub amplitudes: Vec<[f32; 2]>,
    /// Cycles per tick in fixed point, low and high word.
    pub frequencies: Vec<[u32; 2]>,
}

impl WaveData {
    /// Appends one cascade from f64 amplitudes and frequencies (rad/s) in wave index order.
    pub fn push(&mut self, amplitudes: &[[f64; 2]], omegas: &[f64]) {
        self.amplitudes.extend(amplitudes.iter().map(|h| h.map(|x| x as f32)));
        self.frequencies.extend(omegas.iter().map(|&omega| words(waves::cycles_per_tick(omega))));
    }

    /// All cascades of a sea.
    pub fn of(tables: &SeaTables) -> Self {
        let mut data = Self::default();
        for (i, cascade) in tables.cascades.iter().enumerate() {
            let amplitudes = waves::initial_amplitudes(&tables.sea, i, cascade);
            data.push(&amplitudes, &tables.frequencies(cascade));
        }
        data
    }
}

/// Low and high word.
pub fn words(x: u64) -> [u32; 2] {
    [x as u32, (x >> 32) as u32]
}

/// Factors that bring the eight fields of a tile, halfway through the transform, to a root mean square of about one: so neither of
/// two fields that share a complex number is lost in the other's rounding, and 16-bit floats neither overflow nor vanish.
///
/// Order: Dx, Dy, h, dDx/dy; dh/dx, dh/dy, dDx/dx, dDy/dy. Powers of two, so that they cost no rounding; 1 for a field that is zero.
/// A field with multiplier m(k) has the variance 2 Σ m² |h0|² in the mean over time; halfway its N² samples still hold the
/// energy of N rows, hence √N over it.
pub fn scales(cascade: &Cascade, amplitudes: &[[f32; 2]]) -> [[f32; 4]; 2] {
    let mut sums = [0.0; 8];
    for ((kx, ky), h) in cascade.wave_vectors().zip(amplitudes) {
        let power = f64::from(h[0]).powi(2) + f64::from(h[1]).powi(2);
        if power > 0.0 {
            let (x, y) = (kx * kx, ky * ky);
            let k = (x + y).max(f64::MIN_POSITIVE);
            let squares = [x / k, y / k, 1.0, x * y / k, x, y, x * x / k, y * y / k];
            sums.iter_mut().zip(squares).for_each(|(sum, m)| *sum += m * power);
        }
    }
    let factor = |sum: f64| {
        let exponent = (0.5 * (cascade.n as f64 / (2.0 * sum)).log2()).round().clamp(-60.0, 60.0);
        if sum > 0.0 { exponent.exp2() as f32 } else { 1.0 }
    };
    [0, 4].map(|start| std::array::from_fn(|i| factor(sums[start + i])))
}
