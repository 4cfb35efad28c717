//! The wave tiles of a moment as the GPU makes them, in f64: for measuring the drawn surface at any place.

use std::sync::{Arc, Mutex, PoisonError};

use glam::{DVec2, DVec3};

use super::fft::Complex;
use super::moved_water::{Motion, between_samples};
use super::sea_tables::SeaTables;
use super::surface::{gain_of, packed_fields, phase_at};
use super::waves::{self, Cascade};

/// Amplitudes h0 and cycles per tick of a cascade.
type Waves = (Vec<Complex>, Vec<u64>);

/// The eight fields of every cascade at a tick, two to a grid; see [`packed_fields`].
pub struct DrawnTiles {
    tables: Arc<SeaTables>,
    ticks: u64,
    waves: Arc<Vec<Waves>>,
    grids: Vec<[Vec<Complex>; 4]>,
}

impl DrawnTiles {
    /// The tiles of a sea at a tick of the wave clock. The last ones are kept, and the amplitudes of the last sea: a new tick
    /// costs sixteen transforms.
    pub fn of(tables: &Arc<SeaTables>, ticks: u64) -> Arc<Self> {
        static LAST: Mutex<Option<Arc<DrawnTiles>>> = Mutex::new(None);
        let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
        let kept = last.take().filter(|kept| kept.tables == *tables);
        let tiles = match kept {
            Some(kept) if kept.ticks == ticks => kept,
            Some(kept) => Arc::new(Self::new(tables, kept.waves.clone(), ticks)),
            None => {
                let waves = |(index, cascade): (usize, &Cascade)| {
                    let cycles = tables.frequencies(cascade).into_iter().map(waves::cycles_per_tick).collect();
                    (waves::initial_amplitudes(&tables.sea, index, cascade), cycles)
                };
                let waves = tables.cascades.iter().enumerate().map(waves).collect();
                Arc::new(Self::new(tables, Arc::new(waves), ticks))
            }
        };
        last.insert(tiles).clone()
    }

    fn new(tables: &Arc<SeaTables>, waves: Arc<Vec<Waves>>, ticks: u64) -> Self {
        let grids = |(cascade, (h0, cycles)): (&Cascade, &Waves)| {
            packed_fields(h0, cascade, |index| gain_of(cascade, index), |index| phase_at(cycles[index], ticks))
        };
        let grids = tables.cascades.iter().zip(waves.iter()).map(grids).collect();
        Self { tables: tables.clone(), ticks, waves, grids }
    }

    /// The motion at tile coordinates `at` of cascade `index`, m, linearly between the four samples around.
    pub fn motion(&self, index: usize, at: DVec2) -> Motion {
        let Cascade { n, patch_m, .. } = self.tables.cascades[index];
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
