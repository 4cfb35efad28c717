//! Fewer points for a closed line (D. Douglas and T. Peucker 1973, doi:10.3138/FM57-6770-U75U-7727).

/// The points to keep: none that is left out lies farther from the line drawn than `tolerance` says for it. `fixed` ones are kept. Lines of
/// up to four points stay; others keep four at least.
pub fn simplified(
    points: &[[i32; 2]],
    tolerance: impl Fn([i32; 2]) -> f64,
    fixed: impl Fn([i32; 2]) -> bool,
) -> Vec<[i32; 2]> {
    if points.len() <= 4 {
        return points.to_vec();
    }
    // A ring is cut at its first point and the one farthest from it, so that no piece ends where it begins.
    let far = (0..points.len()).max_by_key(|i| square(points[0], points[*i])).unwrap_or(0);
    let mut kept = vec![false; points.len() + 1];
    let mut open = Vec::new();
    let mut cuts: Vec<_> = (1..points.len()).filter(|i| *i == far || fixed(points[*i])).collect();
    cuts.push(points.len());
    let mut from = 0;
    for to in cuts {
        kept[from] = true;
        open.push((from, to));
        from = to;
    }
    let mut least = keep(points, &mut kept, open, tolerance);
    // What would vanish keeps its farthest points.
    least.sort_by(|a, b| b.0.total_cmp(&a.0));
    let lacking = 4usize.saturating_sub(kept[..points.len()].iter().filter(|kept| **kept).count());
    least.iter().take(lacking).for_each(|(_, at)| kept[*at] = true);
    points.iter().zip(kept).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

/// The points to keep of an open line, its ends among them.
pub fn simplified_line(points: &[[i32; 2]], tolerance: impl Fn([i32; 2]) -> f64) -> Vec<[i32; 2]> {
    let Some(last) = points.len().checked_sub(1) else { return Vec::new() };
    let mut kept = vec![false; points.len()];
    (kept[0], kept[last]) = (true, true);
    keep(points, &mut kept, vec![(0, last)], tolerance);
    points.iter().zip(kept).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

/// Keeps points of pieces, from one to another, until the others lie near enough; returns what was farthest away in the last ones, and how far.
fn keep(
    points: &[[i32; 2]],
    kept: &mut [bool],
    mut open: Vec<(usize, usize)>,
    tolerance: impl Fn([i32; 2]) -> f64,
) -> Vec<(f64, usize)> {
    let mut least = Vec::new();
    while let Some((from, to)) = open.pop() {
        let (a, b) = (points[from], points[to % points.len()]);
        let farthest = (from + 1..to).map(|i| (i, distance(points[i], a, b) / tolerance(points[i])));
        if let Some((at, ratio)) = farthest.max_by(|a, b| a.1.total_cmp(&b.1)) {
            if ratio > 1.0 {
                kept[at] = true;
                open.extend([(from, at), (at, to)]);
            } else {
                least.push((ratio, at));
            }
        }
    }
    least
}

fn square(a: [i32; 2], b: [i32; 2]) -> i64 {
    (0..2).map(|axis| i64::from(a[axis]) - i64::from(b[axis])).map(|way| way * way).sum()
}

/// From a point to the piece between two others.
fn distance(p: [i32; 2], a: [i32; 2], b: [i32; 2]) -> f64 {
    let way = [0, 1].map(|axis| f64::from(b[axis] - a[axis]));
    let away = [0, 1].map(|axis| f64::from(p[axis] - a[axis]));
    let length = way[0] * way[0] + way[1] * way[1];
    let along = if length > 0.0 { ((away[0] * way[0] + away[1] * way[1]) / length).clamp(0.0, 1.0) } else { 0.0 };
    (away[0] - along * way[0]).hypot(away[1] - along * way[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_lies_near_and_nothing_vanishes() {
        let ring: Vec<_> = (0..1000)
            .map(|i| {
                let (turn, wave) = (f64::from(i) * std::f64::consts::TAU / 1000.0, f64::from(i % 7));
                [((1000.0 + wave) * turn.cos()) as i32, ((500.0 - wave) * turn.sin()) as i32]
            })
            .collect();
        for tolerance in [3.0, 30.0, 300.0, 1e6] {
            let kept = simplified(&ring, |_| tolerance, |_| false);
            assert!(kept.len() >= 4 && kept.len() < ring.len() / 2, "{tolerance}: {}", kept.len());
            for point in &ring {
                let sides = kept.iter().zip(kept.iter().skip(1).chain(kept.first()));
                let nearest = sides.map(|(a, b)| distance(*point, *a, *b)).fold(f64::INFINITY, f64::min);
                assert!(nearest <= tolerance, "{point:?} is {nearest} away from the line for {tolerance}");
            }
        }
        let fixed = simplified(&ring, |_| 1e6, |point| point[1] == 0);
        assert!(ring.iter().filter(|point| point[1] == 0).all(|point| fixed.contains(point)));
    }
}
