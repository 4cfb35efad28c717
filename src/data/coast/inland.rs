//! Which lake or river is near a place, and which line of another level of tiles is the same lake's.
//!
//! A shore keeps some of its points at each coarser level, so that a lake is known again by them: the points of the coarser line are among
//! those of the finer one, to the rounding of both.

use super::{BUFFER_TEXELS, Level, Shores, Stream};
use crate::data::tile::{TILE_TEXELS, TileId};
use std::cmp::Reverse;
use std::collections::HashMap;

/// Share of a coarser line's points that a finer one of the same lake has, at least.
const SHARED: f64 = 0.8;

/// Looks at cells and points that finding a line in another tile takes, at most: more than any shore needs, and soon done.
const MOST_LOOKS: usize = 1 << 22;

/// A water so many times as long as it is wide flows: narrow lakes are up to 40, labyrinths as Päijänne up to 100.
const RIVER_WIDTHS: f64 = 150.0;

type Place = [f64; 2];

/// A lake's shore as a tile has it, on the unit map.
#[derive(Debug, Clone, PartialEq)]
pub struct Lake {
    /// Closed.
    pub points: Vec<Place>,
    /// North-western and south-eastern corner.
    pub corners: [Place; 2],
    /// Whether no border of the tile cuts it.
    pub is_whole: bool,
}

/// A river's middle as a tile has it, on the unit map.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// Of what kind.
    pub stream: Stream,
    /// Open.
    pub points: Vec<Place>,
}

/// The lakes and rivers of a tile.
#[derive(Debug, Clone, PartialEq)]
pub struct Inland {
    /// Lakes and ponds.
    pub lakes: Vec<Lake>,
    /// Rivers.
    pub rivers: Vec<Course>,
    /// One unit of the tile's coordinates.
    unit: f64,
    /// What the tile holds with its buffer.
    bounds: [Place; 2],
}

/// What is nearest to a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Nearest {
    /// A lake of [`Inland::lakes`].
    Lake(usize),
    /// A river of [`Inland::rivers`].
    River(usize),
}

impl Inland {
    /// Those of the tile `id` that `shores` is.
    pub fn of(id: TileId, shores: &Shores) -> Self {
        let side = f64::from(1u32 << id.z.min(31)).recip();
        let unit = side / f64::from(shores.extent);
        let corner = [id.x, id.y].map(|tile| f64::from(tile) * side);
        let place = |point: &[i32; 2]| [0, 1].map(|axis| corner[axis] + f64::from(point[axis]) * unit);
        let buffer = f64::from(BUFFER_TEXELS) * side / TILE_TEXELS as f64;
        let bounds = [corner.map(|at| at - buffer), corner.map(|at| at + side + buffer)];
        let is_lake = |level: Level| matches!(level, Level::Lake | Level::Pond);
        let lakes = shores.rings.iter().filter(|ring| is_lake(ring.level)).map(|ring| {
            let points: Vec<_> = ring.points.iter().map(place).collect();
            let far = |sign: f64| {
                let most = points.iter().fold([f64::NEG_INFINITY; 2], |m, p| [0, 1].map(|i| m[i].max(sign * p[i])));
                most.map(|at| sign * at)
            };
            let corners = [far(-1.0), far(1.0)];
            let is_whole = shores.are_shores(ring, id).all(|is_shore| is_shore)
                && ring.points.iter().all(|point| is_inside(place(point), bounds, 0.5 * unit));
            Lake { points, corners, is_whole }
        });
        let rivers = shores
            .rivers
            .iter()
            .map(|river| Course { stream: river.stream, points: river.points.iter().map(place).collect() });
        Self { lakes: lakes.collect(), rivers: rivers.collect(), unit, bounds }
    }

    /// The lake or river nearest to a place, of which the map's side is so many metres there, and not farther than a distance in metres. The
    /// smallest lake that holds it is nearer than any river.
    pub fn nearest(&self, at: Place, metres: f64, reach_m: f64) -> Option<Nearest> {
        let reach = reach_m / metres;
        let mut found = (reach * reach, None);
        let mut least = f64::INFINITY;
        for (index, lake) in self.lakes.iter().enumerate() {
            let [low, high] = lake.corners;
            let off = [0, 1].map(|i| (low[i] - at[i]).max(at[i] - high[i]).max(0.0));
            if off[0] * off[0] + off[1] * off[1] > found.0 {
                continue;
            }
            if lake.holds(at) {
                let size = (high[0] - low[0]) * (high[1] - low[1]);
                if size < least {
                    (least, found) = (size, (0.0, Some(Nearest::Lake(index))));
                }
            } else {
                let away = square_away(at, &lake.points, true);
                if away < found.0 {
                    found = (away, Some(Nearest::Lake(index)));
                }
            }
        }
        if found.0 > 0.0 {
            for (index, river) in self.rivers.iter().enumerate() {
                let away = square_away(at, &river.points, false).sqrt() - 0.5 * river.stream.width_m() / metres;
                let away = away.max(1e-12);
                if away * away < found.0 {
                    found = (away * away, Some(Nearest::River(index)));
                }
            }
        }
        found.1
    }

    /// The lake that a coarser tile's line is, if it is here.
    pub fn finer(&self, coarse: &Self, line: usize) -> Option<usize> {
        let line = coarse.lakes.get(line)?;
        let shown = shown(line, [coarse, self], coarse.unit);
        let mut near: Vec<_> =
            (0..self.lakes.len()).filter(|index| are_near(line, &self.lakes[*index], coarse.unit)).collect();
        // Ponds in its box come after it.
        near.sort_by_key(|index| Reverse(self.lakes[*index].points.len()));
        let mut left = MOST_LOOKS;
        near.into_iter().find(|index| Points::of(&self.lakes[*index], coarse.unit).have_most(&shown, &mut left))
    }

    /// The lake that a finer tile's line is, if it is here.
    pub fn coarser(&self, fine: &Self, line: usize) -> Option<usize> {
        let line = fine.lakes.get(line)?;
        let points = Points::of(line, self.unit);
        let mut left = MOST_LOOKS;
        (0..self.lakes.len()).find(|index| {
            let own = &self.lakes[*index];
            are_near(own, line, self.unit) && points.have_most(&shown(own, [self, fine], self.unit), &mut left)
        })
    }
}

impl Lake {
    /// Whether it is the banks of a wide river: many times as long as it is wide.
    pub fn is_river(&self) -> bool {
        let next = self.points.iter().skip(1).chain(self.points.first());
        let (mut doubled, mut round) = (0.0, 0.0);
        let [low, high] = self.corners;
        for (a, b) in self.points.iter().zip(next) {
            // About a corner, lest digits be lost.
            doubled += (a[0] - low[0]) * (b[1] - low[1]) - (b[0] - low[0]) * (a[1] - low[1]);
            round += libm::hypot(b[0] - a[0], b[1] - a[1]);
        }
        let width = libm::fabs(doubled) / round.max(f64::MIN_POSITIVE);
        libm::hypot(high[0] - low[0], high[1] - low[1]) > RIVER_WIDTHS * width
    }

    /// Whether a place is in it.
    fn holds(&self, at: Place) -> bool {
        let next = self.points.iter().skip(1).chain(self.points.first());
        let mut holds = false;
        for (a, b) in self.points.iter().zip(next) {
            if (a[1] > at[1]) != (b[1] > at[1]) {
                holds ^= at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
            }
        }
        holds
    }
}

/// Whether a place lies in a box, and farther than a margin from its border.
fn is_inside(at: Place, [low, high]: [Place; 2], margin: f64) -> bool {
    (0..2).all(|axis| at[axis] > low[axis] + margin && at[axis] < high[axis] - margin)
}

/// Whether the boxes of two lines meet, to a margin.
fn are_near(a: &Lake, b: &Lake, margin: f64) -> bool {
    (0..2).all(|axis| {
        a.corners[1][axis] >= b.corners[0][axis] - margin && a.corners[0][axis] <= b.corners[1][axis] + margin
    })
}

/// The points of a line that two tiles reach.
fn shown(line: &Lake, of: [&Inland; 2], margin: f64) -> Vec<Place> {
    line.points.iter().copied().filter(|at| of.iter().all(|of| is_inside(*at, of.bounds, margin))).collect()
}

/// The points of a finer line, by cells as wide as the coarser one's unit: to the rounding of both.
struct Points {
    margin: f64,
    corners: [Place; 2],
    cells: HashMap<[i64; 2], Vec<Place>>,
}

impl Points {
    fn of(fine: &Lake, margin: f64) -> Self {
        let mut points = Self { margin, corners: fine.corners, cells: HashMap::new() };
        for at in &fine.points {
            points.cells.entry(points.cell(*at)).or_default().push(*at);
        }
        points
    }

    fn cell(&self, at: Place) -> [i64; 2] {
        at.map(|at| (at / self.margin).floor() as i64)
    }

    /// Whether one is near a place; none is once no looks are left.
    fn have(&self, at: Place, left: &mut usize) -> bool {
        *left = left.saturating_sub(1);
        if *left == 0 || !is_inside(at, self.corners, -2.0 * self.margin) {
            return false;
        }
        let [i, j] = self.cell(at);
        let mut around = (-1..=1).flat_map(|di| (-1..=1).map(move |dj| [i + di, j + dj]));
        around.any(|cell| {
            *left = left.saturating_sub(1);
            self.cells.get(&cell).into_iter().flatten().any(|own| {
                *left = left.saturating_sub(1);
                *left > 0 && (0..2).all(|axis| (own[axis] - at[axis]).abs() <= self.margin)
            })
        })
    }

    /// Whether they have enough of a coarser line's points.
    fn have_most(&self, coarse: &[Place], left: &mut usize) -> bool {
        let least = SHARED * coarse.len() as f64;
        let mut shared = coarse.len();
        for at in coarse {
            shared -= usize::from(!self.have(*at, left));
            if *left == 0 || (shared as f64) < least {
                return false;
            }
        }
        shared > 0
    }
}

/// The square of the distance to a line.
fn square_away(at: Place, points: &[Place], is_closed: bool) -> f64 {
    let last = points.last().filter(|_| is_closed).into_iter().zip(points.first());
    let away = |(a, b): (&Place, &Place)| {
        let (way, to) = ([b[0] - a[0], b[1] - a[1]], [at[0] - a[0], at[1] - a[1]]);
        let length = way[0] * way[0] + way[1] * way[1];
        let along = if length > 0.0 { ((to[0] * way[0] + to[1] * way[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
        let off = [to[0] - along * way[0], to[1] - along * way[1]];
        off[0] * off[0] + off[1] * off[1]
    };
    points.iter().zip(points.iter().skip(1)).chain(last).map(away).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inland(lakes: impl Iterator<Item = Vec<Place>>, unit: f64) -> Inland {
        let lake = |points| Lake { points, corners: [[0.2; 2], [0.8; 2]], is_whole: true };
        Inland { lakes: lakes.map(lake).collect(), rivers: Vec::new(), unit, bounds: [[0.0; 2], [1.0; 2]] }
    }

    #[test]
    fn tiles_made_to_match_slowly_are_done_soon() {
        let began = std::time::Instant::now();
        // Points in the corner of each other's cells, but not near.
        let [line, others] = [[0.5001, 0.5001], [0.5019, 0.5019]].map(|at| vec![at; 1 << 17]);
        let coarse = inland([line].into_iter(), 1e-3);
        assert_eq!(inland([others.clone()].into_iter(), 5e-4).finer(&coarse, 0), None);
        assert_eq!(coarse.coarser(&inland([others].into_iter(), 5e-4), 0), None);
        let ponds = || vec![[0.5019, 0.5019]; 4];
        assert_eq!(inland((0..1 << 15).map(|_| ponds()), 5e-4).finer(&coarse, 0), None);
        assert!(began.elapsed().as_secs() < 10, "{:?}", began.elapsed());
    }
}
