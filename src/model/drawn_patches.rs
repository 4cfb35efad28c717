//! The wave patches of a moment as the GPU makes them, in f64: for measuring the drawn surface at any place.

use glam::{DVec2, DVec3};

use super::fft::Complex;
use super::moved_water::{Motion, between_samples};
use super::surface::{gain_of, packed_fields, phase_at};
use super::wave_data::WaveData;
use super::waves::{CASCADES, Cascade};

/// The eight fields of every cascade at a tick, two to a grid; see [`packed_fields`].
pub struct DrawnPatches {
    cascades: [Cascade; CASCADES],
    grids: Vec<[Vec<Complex>; 4]>,
}

impl DrawnPatches {
    /// The patches of a sea's waves at a tick of the wave clock: sixteen transforms.
    pub fn new(cascades: [Cascade; CASCADES], data: &WaveData, ticks: u64) -> Self {
        let grids = |(index, cascade): (usize, &Cascade)| {
            let n = cascade.n;
            let h0: Vec<Complex> = data.amplitudes_of(index, n).iter().map(|h| h.map(f64::from)).collect();
            let cycles = data.frequencies_of(index, n);
            packed_fields(&h0, cascade, data.depth_m, |at| gain_of(cascade, at), |at| phase_at(cycles(at), ticks))
        };
        Self { grids: cascades.iter().enumerate().map(grids).collect(), cascades }
    }

    /// The motion at patch coordinates `at` of cascade `index`, m, linearly between the four samples around.
    pub fn motion(&self, index: usize, at: DVec2) -> Motion {
        let Cascade { n, patch_m, .. } = self.cascades[index];
        let ((i, u), (j, v)) = (between_samples(at.x, patch_m, n), between_samples(at.y, patch_m, n));
        let (next_i, next_j) = ((i + 1) % n, (j + 1) % n);
        let corners = [
            (j * n + i, (1.0 - u) * (1.0 - v)),
            (j * n + next_i, u * (1.0 - v)),
            (next_j * n + i, (1.0 - u) * v),
            (next_j * n + next_i, u * v),
        ];
        let [shift, height, slope, stretch] = self.grids[index].each_ref().map(|grid| {
            let weighted = corners.map(|(at, weight)| weight * DVec2::from_array(grid[at]));
            weighted.into_iter().sum::<DVec2>()
        });
        Motion { height: height.x, shift, slope, stretch: DVec3::new(stretch.x, stretch.y, height.y) }
    }
}
