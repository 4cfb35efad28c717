//! What of a line lies in a box of the map.

use crate::data::coast::{Ring, River};

/// A box's corners, the north-western one first.
pub type Bounds = ([i32; 2], [i32; 2]);

/// What of a ring lies in a box (I. Sutherland and G. Hodgman 1974, doi:10.1145/360767.360802); parts are joined along its border.
pub fn ring(ring: Ring, (low, high): Bounds) -> Option<Ring> {
    let level = ring.level;
    let mut points = ring.points;
    for axis in 0..2 {
        for (limit, sign) in [(low[axis], 1), (high[axis], -1)] {
            let inside = |point: &[i32; 2]| sign * (point[axis] - limit) >= 0;
            let within = points.iter().filter(|point| inside(point)).count();
            if within == 0 {
                return None;
            }
            if within == points.len() {
                continue;
            }
            let mut kept: Vec<[i32; 2]> = Vec::with_capacity(points.len() + 8);
            let mut before = points[points.len() - 1];
            for point in points {
                if inside(&before) != inside(&point) {
                    kept.push(at_border(before, point, axis, limit));
                }
                if inside(&point) {
                    kept.push(point);
                }
                before = point;
            }
            kept.dedup();
            points = kept;
        }
    }
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    (points.len() >= 3).then_some(Ring { level, points })
}

/// The parts of a river that lie in a box.
pub fn river(river: &River, (low, high): Bounds) -> Vec<River> {
    let mut parts: Vec<Vec<[i32; 2]>> = vec![river.points.clone()];
    for axis in 0..2 {
        for (limit, sign) in [(low[axis], 1), (high[axis], -1)] {
            parts = parts.iter().flat_map(|points| beyond(points, axis, limit, sign)).collect();
        }
    }
    parts.into_iter().map(|points| River { stream: river.stream, points }).collect()
}

/// The parts of a line on one side of a border.
fn beyond(points: &[[i32; 2]], axis: usize, limit: i32, sign: i32) -> Vec<Vec<[i32; 2]>> {
    let inside = |point: &[i32; 2]| sign * (point[axis] - limit) >= 0;
    let (mut parts, mut part) = (Vec::new(), Vec::new());
    for (i, point) in points.iter().enumerate() {
        let crosses = i > 0 && inside(&points[i - 1]) != inside(point);
        if crosses {
            part.push(at_border(points[i - 1], *point, axis, limit));
        }
        if inside(point) {
            part.push(*point);
        } else {
            parts.push(std::mem::take(&mut part));
        }
    }
    parts.push(part);
    parts.iter_mut().for_each(Vec::dedup);
    parts.retain(|part| part.len() > 1);
    parts
}

/// Where a side meets a border; the same from both ends.
fn at_border(a: [i32; 2], b: [i32; 2], axis: usize, limit: i32) -> [i32; 2] {
    let (a, b) = if a <= b { (a, b) } else { (b, a) };
    let other = 1 - axis;
    let part = f64::from(limit - a[axis]) / f64::from(b[axis] - a[axis]);
    let mut point = [limit; 2];
    point[other] = a[other] + (part * f64::from(b[other] - a[other])).round() as i32;
    point
}
