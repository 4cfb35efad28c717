//! Nearest shore, for every cell of a grid: vector propagation (Danielsson 1980, doi:10.1016/0146-664X(80)90054-4).
//!
//! A shore point is the middle of the edge between a cell inside and a cell outside. Each cell learns the nearest shore
//! point from its neighbours in two sweeps; the result errs by a fraction of a cell in rare places.

/// No shore within reach.
pub const NOWHERE: (i16, i16) = (i16::MIN, i16::MIN);

/// For each of `side` x `side` cells the nearest shore point, in half cells from the centre of cell (0, 0), or
/// [`NOWHERE`] where none lies within `reach` cells. Also the number of shore points.
pub fn nearest_shore(inside: &[bool], side: usize, reach: usize) -> (Vec<(i16, i16)>, usize) {
    let mut nearest = vec![NOWHERE; side * side];
    let mut shores = 0;
    for row in 0..side {
        for column in 0..side {
            let at = row * side + column;
            let twice = (2 * column as i16, 2 * row as i16);
            if column + 1 < side && inside[at] != inside[at + 1] {
                shores += 1;
                (nearest[at], nearest[at + 1]) = ((twice.0 + 1, twice.1), (twice.0 + 1, twice.1));
            }
            if row + 1 < side && inside[at] != inside[at + side] {
                shores += 1;
                (nearest[at], nearest[at + side]) = ((twice.0, twice.1 + 1), (twice.0, twice.1 + 1));
            }
        }
    }
    if shores > 0 {
        let limit = 4 * (reach * reach) as i32;
        let mut sweep = Sweep { nearest: &mut nearest, side, limit };
        (0..side).for_each(|row| sweep.row(row, row.checked_sub(1)));
        (0..side).rev().for_each(|row| sweep.row(row, (row + 1 < side).then_some(row + 1)));
    }
    (nearest, shores)
}

/// Squared distance in half cells from a cell to a shore point.
pub fn squared(column: usize, row: usize, shore: (i16, i16)) -> i32 {
    let (dx, dy) = (i32::from(shore.0) - 2 * column as i32, i32::from(shore.1) - 2 * row as i32);
    dx * dx + dy * dy
}

struct Sweep<'a> {
    nearest: &'a mut [(i16, i16)],
    side: usize,
    limit: i32,
}

impl Sweep<'_> {
    /// Learns from the row before, then along the row both ways.
    fn row(&mut self, row: usize, before: Option<usize>) {
        let side = self.side;
        for column in 0..side {
            if let Some(before) = before {
                let from = before * side;
                for other in column.saturating_sub(1)..=(column + 1).min(side - 1) {
                    self.learn(column, row, self.nearest[from + other]);
                }
            }
            if column > 0 {
                self.learn(column, row, self.nearest[row * side + column - 1]);
            }
        }
        for column in (0..side - 1).rev() {
            self.learn(column, row, self.nearest[row * side + column + 1]);
        }
    }

    #[inline]
    fn learn(&mut self, column: usize, row: usize, shore: (i16, i16)) {
        if shore == NOWHERE {
            return;
        }
        let at = row * self.side + column;
        let known = self.nearest[at];
        let bound = if known == NOWHERE { self.limit + 1 } else { squared(column, row, known) };
        if squared(column, row, shore) < bound {
            self.nearest[at] = shore;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_shore_is_that_of_brute_force() {
        let side = 40;
        // Blobs from a fixed pseudo-random sequence.
        let mut seed = 7u32;
        let mut random = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 16) as usize % side
        };
        let blobs: Vec<_> = (0..9).map(|_| (random(), random(), random() % 6 + 1)).collect();
        let inside: Vec<bool> = (0..side * side)
            .map(|i| {
                blobs.iter().any(|(x, y, r)| (i % side).abs_diff(*x).pow(2) + (i / side).abs_diff(*y).pow(2) < r * r)
            })
            .collect();
        let (nearest, shores) = nearest_shore(&inside, side, side);
        let mut points = Vec::new();
        for row in 0..side {
            for column in 0..side {
                let at = row * side + column;
                if column + 1 < side && inside[at] != inside[at + 1] {
                    points.push((2 * column as i16 + 1, 2 * row as i16));
                }
                if row + 1 < side && inside[at] != inside[at + side] {
                    points.push((2 * column as i16, 2 * row as i16 + 1));
                }
            }
        }
        assert_eq!(points.len(), shores);
        for row in 0..side {
            for column in 0..side {
                let true_one = points.iter().map(|p| squared(column, row, *p)).min().unwrap();
                let found = squared(column, row, nearest[row * side + column]);
                // Two sweeps miss the very nearest point in rare places, by a small part of a cell.
                assert!(f64::from(found).sqrt() / 2.0 < f64::from(true_one).sqrt() / 2.0 + 0.3, "{column} {row}");
            }
        }
    }
}
