//! Shores of deep tiles are smooth curves by the points of their polygons, which [`Bends`] then make ragged.
//!
//! The points of most polygons are the corners of a raster's texels, of 6 seconds of arc: a straight beach is a flight of stairs, whose corners turn
//! left and right by turns. So a point beside which the line turns the other way goes towards its two neighbours, by [`EVENS_M`] at most:
//!
//! ```text
//!        A ---- handle
//!       /  .        handle        A side is a cubic (Bezier) whose tangents are those of its two points. A tangent depends on the
//!      /     .     /              directions of both sides at its point, the shorter side's counting more (a parabola's).
//!  before     .. B ---- after
//! ```
//!
//! Why no seam shows where two stored tiles meet: each has the shores of the other for [`BUFFER_TEXELS`] beyond the border, and what a point does to
//! the line ends `longest` on, of which three and what a deep tile looks at fit into that buffer wherever it is. A longer side is straight between
//! its ends' curves, which do not depend on how long it is, so that it may be cut anywhere, and of a side farther on the direction alone counts. All is
//! then moved as the *place* says.
//!
//! Why shores stay apart: a curve leaves its side by [`BULGE_M`] and a point its place by [`EVENS_M`] at most, together less than what the points themselves may
//! be off, and an islet whose line turns one way all around keeps its size. The move is a map of the plane onto itself without folds (see
//! [`crate::model::ragged_shore`]), which no strait and no islet can lose.

use super::BUFFER_TEXELS;
use super::bends::{Bends, share};
use super::field::{MARGIN, SIDE};
use crate::data::tile::TileId;
use crate::model::ragged_shore::MOST_M;
use crate::model::sea_bed::smoothstep;

/// How far a handle may lead away from the side, metres; of that the curve goes three quarters at most.
const BULGE_M: f64 = 45.0;
/// How far a point of a flight of stairs may go, metres: as far as it takes where the raster's texels are 140 m wide.
const EVENS_M: f64 = 50.0;
/// Product of the sines by which a line turns one way and then the other, from which on it is such a flight.
const STAIRS: f64 = 0.1;
/// Length of the pieces that stand for the curve, texels: half an edge of the finest noise in it.
const PIECE_TEXELS: f64 = 1.5;
/// What a point does to the line ends here, source texels, at most.
const LONGEST: f64 = 2.0;
/// So many pieces of a tile are curved, at most: a shore that fills a tile has some thousand, one that is made to harm could have millions.
const MOST_PIECES: usize = 1 << 17;

type Place = [f64; 2];

/// Of a line, with its direction and length.
#[derive(Clone, Copy)]
struct Side {
    is_shore: bool,
    way: (Place, f64),
}

/// Where a line passes one of its points, and in which direction, where it has one there.
#[derive(Clone, Copy)]
struct Corner {
    at: Place,
    tangent: Option<Place>,
}

/// How a tile's shores are drawn. Places are in texels of the grid.
pub(super) struct Curves {
    bends: Bends,
    /// How far stairs are made even, of what is said above.
    evens: f64,
    /// What a point does to the line ends here.
    longest: f64,
    /// How far from the grid a line may lie and yet be drawn in it.
    pad: f64,
    /// How many more pieces may be curved.
    left: usize,
}

impl Curves {
    /// `None` where shores are as straight as they are stored, `down` texels of the tile being one of its source.
    pub(super) fn of(tile: TileId, down: f64) -> Option<Self> {
        let bends = Bends::of(tile)?;
        let narrowest_m = bends.texel_m(0.0).min(bends.texel_m(SIDE as f64));
        // A hundredth more, as texels beyond the grid are a little narrower towards the pole.
        let pad = 1.01 * (MOST_M + BULGE_M + EVENS_M) / narrowest_m;
        let longest = (LONGEST * down).min((f64::from(BUFFER_TEXELS) * down - pad) / 3.0);
        Some(Self { bends, evens: 1.0, longest, pad, left: MOST_PIECES })
    }

    /// From here on lines are rivers, whose points are no stairs, and bend by octaves alone that texels of a width in metres can hold.
    pub(super) fn rivers(&mut self, finest_m: f64) {
        self.bends.finest_m = finest_m;
        self.evens = 0.0;
    }

    /// Draws a closed line, of whose sides `is_shore` tells the shores; `draw` takes pieces, in their order.
    pub(super) fn ring(&mut self, points: &[Place], is_shore: &[bool], mut draw: impl FnMut(Place, Place, bool)) {
        let count = points.len();
        if count == 0 {
            return;
        }
        let side = |i: usize| {
            let i = i % count;
            Side { is_shore: is_shore[i], way: way(points[i], points[(i + 1) % count]) }
        };
        // The sides before a point and after it, two each.
        let corner = |curves: &Self, i: usize| {
            let around = [2, 1, 0].map(|before| side(i + 2 * count - before));
            curves.corner(points[i % count], [around[0], around[1], around[2], side(i + 1)])
        };
        // Where the side ends that begins at a point: where it was, if nobody sees it.
        let end = |curves: &Self, i: usize| {
            let (a, b) = (points[i], points[(i + 1) % count]);
            if curves.sees(a, b) { corner(curves, i + 1) } else { Corner { at: b, tangent: None } }
        };
        let mut from = self.moved(end(self, count - 1).at);
        for i in 0..count {
            let (a, b) = (points[i], points[(i + 1) % count]);
            let (own, last) = (side(i), end(self, i));
            if self.sees(a, b) && own.is_shore && own.way.1 > 0.0 && self.left > 0 {
                self.curve([a, b], own.way, [corner(self, i), last], |at| {
                    draw(from, at, true);
                    from = at;
                });
            }
            let to = self.moved(last.at);
            draw(from, to, own.is_shore);
            from = to;
        }
    }

    /// Where a line passes a point between the second and the third of four sides, and in which direction.
    fn corner(&self, at: Place, sides: [Side; 4]) -> Corner {
        let [_, before, after, _] = sides;
        let Some(tangent) = self.tangent((before.is_shore, before.way), (after.is_shore, after.way)) else {
            return Corner { at, tangent: None };
        };
        // By how much the line turns at the point before, at this one, and at the next; not where one of these is too far to be known.
        let turn = |i: usize| {
            let ([a, b], is_shore) = ([sides[i].way.0, sides[i + 1].way.0], sides[i].is_shore && sides[i + 1].is_shore);
            if is_shore { a[0] * b[1] - a[1] * b[0] } else { 0.0 }
        };
        let known = |side: Side| 1.0 - smoothstep(0.8 * self.longest, self.longest, side.way.1);
        let turns = [known(before) * turn(0), turn(1), known(after) * turn(2)];
        let stairs = (-turns[1] * turns[0]).max(-turns[1] * turns[2]);
        let share = self.evens * share(self.bends.texel_m(at[1])) * smoothstep(0.0, STAIRS, stairs);
        if share == 0.0 {
            return Corner { at, tangent: Some(tangent) };
        }
        let longest = self.longest.min(2.0 * before.way.1.min(after.way.1));
        // The ends of both sides, or what counts of them, are so far before and after it: the way from the one to the other, and half of that to their middle.
        let [back, on] = [before, after].map(|side| side.way.1.min(longest));
        let way_by = |of: [f64; 2]| [0, 1].map(|axis| of[0] * before.way.0[axis] + of[1] * after.way.0[axis]);
        let (chord, off) = (way_by([back, on]), way_by([-0.25 * back, 0.25 * on]));
        let chord_length = (chord[0] * chord[0] + chord[1] * chord[1]).sqrt().max(1e-9);
        let most = EVENS_M / self.bends.texel_m(at[1]);
        let far = (off[0] * off[0] + off[1] * off[1]).sqrt();
        let goes = share * if far > most { most / far } else { 1.0 };
        let sum = [0, 1].map(|axis| (1.0 - share) * tangent[axis] + share * chord[axis] / chord_length);
        let (tangent, _) = way([0.0; 2], sum);
        Corner { at: [0, 1].map(|axis| at[axis] + goes * off[axis]), tangent: Some(tangent) }
    }

    /// Whether what is between two points may lie in the grid.
    fn sees(&self, a: Place, b: Place) -> bool {
        (0..2).all(|axis| a[axis].max(b[axis]) >= -self.pad && a[axis].min(b[axis]) <= SIDE as f64 + self.pad)
    }

    /// Where a place is drawn; far from the grid where it is.
    fn moved(&self, at: Place) -> Place {
        if self.sees(at, at) { self.bends.moved(at) } else { at }
    }

    /// The direction in which a line passes a point between two sides, of which [`way`] tells; `None` where it turns round, and where one is no
    /// shore and the other one goes its own way.
    fn tangent(&self, before: (bool, (Place, f64)), after: (bool, (Place, f64))) -> Option<Place> {
        let ((is_shore, (d, length)), (goes_on, (e, next))) = (before, after);
        if !is_shore || !goes_on || length == 0.0 || next == 0.0 {
            return None;
        }
        let (length, next) = (length.min(self.longest), next.min(self.longest));
        let sum = [0, 1].map(|axis| d[axis] * next + e[axis] * length);
        let size = (sum[0] * sum[0] + sum[1] * sum[1]).sqrt();
        (size > 0.1 * (length + next)).then(|| sum.map(|x| x / size))
    }

    /// The moved points between the corners of a side with its direction and length.
    fn curve(
        &mut self,
        [a, b]: [Place; 2],
        (d, length): (Place, f64),
        corners: [Corner; 2],
        mut to: impl FnMut(Place),
    ) {
        let [first, last] = corners.map(|corner| corner.tangent.unwrap_or(d));
        let [from, end] = corners.map(|corner| corner.at);
        if length <= 2.0 * self.longest {
            self.cubic([from, end], [first, last], &mut to);
            return;
        }
        let [c, e] = [(a, self.longest), (b, -self.longest)].map(|(at, by)| [at[0] + by * d[0], at[1] + by * d[1]]);
        if self.sees(a, c) {
            self.cubic([from, c], [first, d], &mut to);
        }
        self.straight(c, e, &mut to);
        if self.sees(e, b) {
            self.cubic([e, end], [d, last], &mut to);
        }
    }

    /// The points on a cubic between its ends.
    fn cubic(&mut self, [a, b]: [Place; 2], tangents: [Place; 2], to: &mut impl FnMut(Place)) {
        let (d, length) = way(a, b);
        let texel_m = self.bends.texel_m(a[1]);
        let bulge = share(texel_m) * BULGE_M / texel_m;
        let handles = tangents.map(|tangent| {
            let off = [tangent[0] - d[0], tangent[1] - d[1]];
            let off = (off[0] * off[0] + off[1] * off[1]).sqrt();
            let size = if off * length > 3.0 * bulge { bulge / off } else { length / 3.0 };
            tangent.map(|x| x * size)
        });
        let count = (length / PIECE_TEXELS).ceil().clamp(1.0, 4096.0) as usize;
        for i in 1..count {
            let t = i as f64 / count as f64;
            let s = 1.0 - t;
            let at = [0, 1].map(|axis| {
                let (p, q) = (a[axis] + handles[0][axis], b[axis] - handles[1][axis]);
                s * s * (s * a[axis] + 3.0 * t * p) + t * t * (3.0 * s * q + t * b[axis])
            });
            to(self.moved(at));
        }
        self.left = self.left.saturating_sub(count);
    }

    /// Points on a straight line, at every other texel of the map: a side that has been cut elsewhere has the same.
    fn straight(&mut self, a: Place, b: Place, to: &mut impl FnMut(Place)) {
        let axis = usize::from((b[1] - a[1]).abs() > (b[0] - a[0]).abs());
        let step = 2.0;
        let number = |x: f64| (x.clamp(-self.pad - 8.0, SIDE as f64 + self.pad + 8.0) - MARGIN as f64) / step;
        let (low, high) = (number(a[axis].min(b[axis])).ceil() as i64, number(a[axis].max(b[axis])).floor() as i64);
        to(self.moved(a));
        for i in 0..=(high - low) {
            let x = (if b[axis] > a[axis] { low + i } else { high - i }) as f64 * step + MARGIN as f64;
            let t = (x - a[axis]) / (b[axis] - a[axis]);
            let at = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
            to(self.moved(at));
        }
        to(self.moved(b));
        self.left = self.left.saturating_sub((high - low).max(0) as usize);
    }
}

/// Direction and length from one place to another.
fn way(a: Place, b: Place) -> (Place, f64) {
    let way = [b[0] - a[0], b[1] - a[1]];
    let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
    (if length > 0.0 { way.map(|x| x / length) } else { [0.0; 2] }, length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::tile::Projection;

    /// The last tile of level 13 in one of level 8, and the first one of its eastern neighbour; 28 degrees north.
    fn beside_a_border() -> [TileId; 2] {
        [0, 1].map(|right| TileId::new(Projection::Mercator, 13, 32 * 118 + 31 + right, 3_420).unwrap())
    }

    /// What is drawn of a ring whose sides are all shores but those along `cut`.
    fn drawn(curves: &mut Curves, points: &[Place], cut: f64) -> Vec<[Place; 2]> {
        let next = points.iter().skip(1).chain(points.first());
        let is_shore: Vec<bool> = points.iter().zip(next).map(|(a, b)| a[0] != cut || b[0] != cut).collect();
        let mut pieces = Vec::new();
        curves.ring(points, &is_shore, |a, b, is_shore| pieces.extend(is_shore.then_some([a, b])));
        pieces
    }

    /// A zigzag eastwards from -340 texels, closed far in the south.
    fn zigzag(to: f64, height: f64) -> Vec<Place> {
        let count = ((to + 340.0) / 20.0) as u32;
        let mut points: Vec<_> =
            (0..=count).map(|i| [-340.0 + 20.0 * f64::from(i), 130.0 + height * (f64::from(i % 2) - 0.5)]).collect();
        points.extend([[to, 2_000.0], [-340.0, 2_000.0]]);
        points
    }

    #[test]
    fn a_shore_passes_its_points_and_has_no_corner() {
        for height in [8.0, 20.0, 40.0] {
            let mut curves = Curves::of(beside_a_border()[0], 32.0).unwrap();
            (curves.bends.moves, curves.evens) = (0.0, 0.0);
            let points = zigzag(600.0, height);
            let pieces = drawn(&mut curves, &points, f64::NAN);
            let seen = |at: &Place| (0.0..SIDE as f64).contains(&at[0]) && at[1] < 300.0;
            for point in points.iter().filter(|point| seen(point)) {
                assert!(pieces.iter().any(|[a, _]| a == point), "{point:?} is not on the line");
            }
            let turns = pieces.windows(2).filter(|two| seen(&two[0][1])).map(|two| {
                let [(a, _), (b, _)] = [way(two[0][0], two[0][1]), way(two[1][0], two[1][1])];
                libm::acos((a[0] * b[0] + a[1] * b[1]).min(1.0)).to_degrees()
            });
            let most = turns.fold(0.0, f64::max);
            println!("sides {height} texels high turn by {most} degrees from piece to piece");
            // Straight sides turn by so much at a point; the curve takes four pieces or more for it.
            let corner = 2.0 * libm::atan2(height, 20.0).to_degrees();
            assert!(most < 0.4 * corner, "{height}: {most} of {corner}");
        }
    }

    /// Of texels of a raster about as wide: 8 texels of the grid are 135 m.
    #[test]
    fn stairs_are_a_straight_shore_and_an_islet_keeps_its_size() {
        let mut curves = Curves::of(beside_a_border()[0], 32.0).unwrap();
        curves.bends.moves = 0.0;
        let corners = (0..40).map(|i| [-70.0 + 8.0 * f64::from((i + 1) / 2), -70.0 + 8.0 * f64::from(i / 2)]);
        let stairs: Vec<_> = corners.chain([[90.0, 2_000.0], [-70.0, 2_000.0]]).collect();
        // From the line through the middles of the steps.
        let off = |at: Place| (at[0] - at[1] - 4.0).abs() * 0.5f64.sqrt();
        let farthest = |pieces: Vec<[Place; 2]>| {
            let inner = pieces.iter().flatten().filter(|at| at.iter().all(|x| (0.0..80.0).contains(x)));
            inner.map(|at| off(*at)).fold(0.0, f64::max)
        };
        let even = farthest(drawn(&mut curves, &stairs, f64::NAN));
        curves.evens = 0.0;
        let uneven = farthest(drawn(&mut curves, &stairs, f64::NAN));
        assert!(even < 0.01 && uneven > 2.8, "{even} texels off the line, {uneven} without");

        let islet = [[100.0, 100.0], [110.0, 100.0], [110.0, 110.0], [100.0, 110.0]];
        let plain = drawn(&mut curves, &islet, f64::NAN);
        curves.evens = 1.0;
        assert_eq!(drawn(&mut curves, &islet, f64::NAN), plain);
    }

    #[test]
    fn both_sides_of_a_border_draw_the_same_shore_wherever_its_sides_are_cut() {
        let tiles = beside_a_border();
        for height in [20.0, 40.0] {
            // Three long sides among short ones: one that both tiles cut, and cut elsewhere.
            let line = |low: f64, high: f64| {
                let (a, b) = ([-900.0, 60.0], [1_100.0, 260.0]);
                let at = |x: f64| [x, a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1])];
                let mut points = vec![at(low), at(high), [high, 2_000.0], [low, 2_000.0]];
                let ridge = (0..17).map(|i| [100.0 + 20.0 * f64::from(i), 20.0 + height * f64::from(i % 2)]);
                points.splice(1..1, [[99.0, 159.9]].into_iter().chain(ridge).chain([[500.0, 200.0]]));
                points
            };
            // In texels of the western tile's grid; each knows its own side and 320 texels beyond the border.
            let border = 256.0 + MARGIN as f64;
            let [west, east] = [(0, -800.0, border + 320.0), (1, border - 320.0, 1_000.0)].map(|(tile, low, high)| {
                let mut curves = Curves::of(tiles[tile], 32.0).unwrap();
                let shift = 256.0 * tile as f64;
                let points: Vec<_> = line(low, high).iter().map(|[x, y]| [x - shift, *y]).collect();
                let pieces = drawn(&mut curves, &points, f64::NAN);
                pieces.into_iter().map(|piece| piece.map(|[x, y]| [x + shift, y])).collect::<Vec<_>>()
            });
            let near = |[a, b]: &[Place; 2]| [a, b].iter().all(|at| (at[0] - border).abs() < 12.0 && at[1] < 500.0);
            let count = west.iter().filter(|piece| near(piece)).count();
            assert!(count > 10, "{count} pieces about the border");
            for piece in west.iter().filter(|piece| near(piece)) {
                let off = east.iter().map(|other| way(piece[0], other[0]).1).fold(f64::INFINITY, f64::min);
                // The same sums in other units: the last digits of doubles.
                assert!(off < 1e-6, "{piece:?} is {off} texels from the other tile's line");
            }
        }
    }
}
