//! The nearest piece of a shore for each texel of a grid.

use super::field::{REACH, SIDE};

const NONE: u32 = u32::MAX;

/// A piece of a shore, in texels of the grid.
pub(super) struct Piece {
    from: [f64; 2],
    way: [f64; 2],
    /// One over the square of its length; 0 of a point.
    inverse: f64,
}

impl Piece {
    pub(super) fn new(from: [f64; 2], to: [f64; 2]) -> Self {
        let way = [to[0] - from[0], to[1] - from[1]];
        let square = way[0] * way[0] + way[1] * way[1];
        Self { from, way, inverse: if square > 0.0 { 1.0 / square } else { 0.0 } }
    }

    /// From a place to the nearest point of the piece.
    fn nearest(&self, at: [f64; 2]) -> [f64; 2] {
        let away = [at[0] - self.from[0], at[1] - self.from[1]];
        let along = ((away[0] * self.way[0] + away[1] * self.way[1]) * self.inverse).clamp(0.0, 1.0);
        [away[0] - along * self.way[0], away[1] - along * self.way[1]]
    }
}

/// The nearest piece of each texel and how far it is.
pub(super) struct Sweep<'a> {
    pieces: &'a [Piece],
    scale: Option<&'a [f64]>,
    nearest: Vec<u32>,
    squares: Vec<f64>,
}

impl<'a> Sweep<'a> {
    pub(super) fn new(pieces: &'a [Piece], scale: Option<&'a [f64]>) -> Self {
        let cells = if pieces.is_empty() { 0 } else { SIDE * SIDE };
        let mut sweep = Self { pieces, scale, nearest: vec![NONE; cells], squares: vec![f64::INFINITY; cells] };
        for piece in 0..pieces.len() {
            sweep.seed(piece as u32);
        }
        if cells > 0 {
            (0..SIDE).for_each(|row| sweep.row(row, row.checked_sub(1)));
            (0..SIDE).rev().for_each(|row| sweep.row(row, (row + 1 < SIDE).then_some(row + 1)));
        }
        sweep
    }

    /// The texels that a piece passes, and those beside them.
    fn seed(&mut self, piece: u32) {
        let Piece { from, way, .. } = &self.pieces[piece as usize];
        let last = SIDE as f64 - 1.0;
        let clamped = |x: f64| x.clamp(0.0, last) as usize;
        let (top, bottom) = (from[1].min(from[1] + way[1]), from[1].max(from[1] + way[1]));
        for row in clamped(top - 1.0)..=clamped(bottom + 1.0) {
            // What of the piece lies in the row or beside it.
            let part = |y: f64| if way[1] == 0.0 { 0.0 } else { ((y - from[1]) / way[1]).clamp(0.0, 1.0) };
            let (mut a, mut b) = (part(row as f64 - 1.0), part(row as f64 + 2.0));
            if way[1] == 0.0 {
                (a, b) = (0.0, 1.0);
            }
            let ends = [from[0] + a * way[0], from[0] + b * way[0]];
            let (left, right) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            if right < -1.0 || left > last + 2.0 {
                continue;
            }
            for column in clamped(left - 1.0)..=clamped(right + 1.0) {
                self.learn(row * SIDE + column, column, row, piece);
            }
        }
    }

    /// Learns from the row before, then along the row both ways.
    fn row(&mut self, row: usize, before: Option<usize>) {
        let from = row * SIDE;
        for column in 0..SIDE {
            if let Some(before) = before {
                for other in column.saturating_sub(1)..=(column + 1).min(SIDE - 1) {
                    self.learn(from + column, column, row, self.nearest[before * SIDE + other]);
                }
            }
            if column > 0 {
                self.learn(from + column, column, row, self.nearest[from + column - 1]);
            }
        }
        for column in (0..SIDE - 1).rev() {
            self.learn(from + column, column, row, self.nearest[from + column + 1]);
        }
    }

    #[inline]
    fn learn(&mut self, at: usize, column: usize, row: usize, piece: u32) {
        if piece == NONE || piece == self.nearest[at] {
            return;
        }
        let [x, y] = self.pieces[piece as usize].nearest([column as f64 + 0.5, row as f64 + 0.5]);
        let mut square = x * x + y * y;
        if let Some(scale) = self.scale {
            // Half way between both places scale is about the mean of the way's.
            let middle = (row as f64 - y / 2.0).clamp(0.0, (SIDE - 1) as f64);
            let (below, part) = (middle as usize, middle - (middle as usize) as f64);
            let mean = scale[below] * (1.0 - part) + scale[(below + 1).min(SIDE - 1)] * part;
            let ratio = mean / scale[row];
            square *= ratio * ratio;
        }
        if square < self.squares[at] && square < (REACH + 1.5) * (REACH + 1.5) {
            (self.nearest[at], self.squares[at]) = (piece, square);
        }
    }

    /// From a texel to the nearest shore, texels, or more than [`REACH`].
    pub(super) fn texels(&self, at: usize) -> f64 {
        self.squares.get(at).map_or(f64::INFINITY, |square| square.sqrt())
    }
}
