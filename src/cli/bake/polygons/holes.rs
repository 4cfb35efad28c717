//! Which outer ring a hole lies in, where a format does not say.
//!
//! A ring's edges are held against those holes alone whose first point they pass at its latitude: along a coast these are a few for each, where
//! rings times holes would be a day's work for 10^5 of either.

use super::{Point, doubled_area};

/// Edges that may pass holes: some seconds' work. A coast of 10^7 points with 10^5 lakes has a tenth of it.
const MOST_PASSED: u64 = 1 << 30;

/// The rings that run clockwise, each with the holes inside of it. `None` where more work than for any real coast would be needed.
pub fn separated(rings: Vec<Vec<Point>>) -> Option<Vec<Vec<Vec<Point>>>> {
    let (outer, holes): (Vec<_>, Vec<_>) = rings.into_iter().partition(|ring| doubled_area(ring) <= 0.0);
    let mut passing = Passing::new(&holes);
    let mut owner: Vec<Option<usize>> = vec![None; holes.len()];
    let mut count = outer.len();
    for (number, ring) in outer.iter().enumerate() {
        passing.within(ring, |hole| owner[hole] = owner[hole].or(Some(number)))?;
    }
    // In none: written the wrong way round, as some programs do. Later ones may lie in it.
    for hole in 0..holes.len() {
        if owner[hole].is_none() {
            owner[hole] = Some(count);
            passing.within(&holes[hole], |later| {
                if later > hole {
                    owner[later] = owner[later].or(Some(count));
                }
            })?;
            count += 1;
        }
    }
    let mut polygons: Vec<_> = outer.into_iter().map(|ring| vec![ring]).collect();
    polygons.resize(count, Vec::new());
    for (hole, owner) in holes.into_iter().zip(owner) {
        polygons[owner?].push(hole);
    }
    Some(polygons)
}

/// The first points of holes from the south, and how much work they have been.
struct Passing {
    /// With the hole's number.
    points: Vec<(Point, usize)>,
    /// Whether a ray from each to the east has crossed the ring an odd number of times.
    is_odd: Vec<bool>,
    passed: u64,
}

impl Passing {
    fn new(holes: &[Vec<Point>]) -> Self {
        let first = holes.iter().enumerate().filter_map(|(number, hole)| Some((*hole.first()?, number)));
        let mut points: Vec<_> = first.filter(|([x, y], _)| !(x.is_nan() || y.is_nan())).collect();
        points.sort_by(|(a, _), (b, _)| a[1].total_cmp(&b[1]));
        Self { is_odd: vec![false; points.len()], points, passed: 0 }
    }

    /// Tells the holes that lie in a ring. `None`: too much work.
    fn within(&mut self, ring: &[Point], mut tell: impl FnMut(usize)) -> Option<()> {
        let between = |south: f64, north: f64| {
            let below = |end: f64| self.points.partition_point(|([_, y], _)| *y < end);
            below(south)..below(north)
        };
        let edges = || {
            ring.windows(2)
                .map(|ends| (ends[0], ends[1], between(ends[0][1].min(ends[1][1]), ends[0][1].max(ends[1][1]))))
        };
        // Known before any of it is done.
        self.passed += edges().map(|(_, _, range)| range.len() as u64).sum::<u64>();
        if self.passed > MOST_PASSED {
            return None;
        }
        let (mut first, mut end) = (self.points.len(), 0);
        for ([ax, ay], [bx, by], range) in edges() {
            first = first.min(range.start);
            end = end.max(range.end);
            for ([x, y], is_odd) in
                self.points[range.clone()].iter().map(|(point, _)| *point).zip(&mut self.is_odd[range])
            {
                *is_odd ^= x < ax + (y - ay) / (by - ay) * (bx - ax);
            }
        }
        for at in first..end {
            if std::mem::take(&mut self.is_odd[at]) {
                tell(self.points[at].1);
            }
        }
        Some(())
    }
}
