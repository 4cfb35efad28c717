//! Bends of a shore between its true points: gradient noise ([K. Perlin](crate::bibliography::Perlin2001)) that moves each of its places along
//! the ground, a function of the place alone.
//!
//! A coast looks alike at any scale (B. Mandelbrot 1967): each octave is half as wide as the one before and moves somewhat more than half as far. The
//! broadest are as wide as the sides of a coast that is true to 50 m are long. Some coasts are rough and others are smooth, by a noise of kilometres.
//!
//! Octaves act one after the other, each on the places that the broader ones have moved. No octave moves two places so differently that they
//! change their order, so that all together map the ground onto itself without a fold: straits stay open and islets whole, and no
//! new ones come, as they do where noise is added to the distance from a shore.

use super::noise::hash;
use super::relief::RADIUS_M;

/// Edge of an octave's lattice, metres, and how far it moves where the noise is one, of that edge: its deviation is about a quarter.
const OCTAVES: [[f64; 2]; 10] = [
    [640.0, 0.08],
    [400.0, 0.14],
    [250.0, 0.19],
    [160.0, 0.22],
    [100.0, 0.22],
    [63.0, 0.22],
    [40.0, 0.2],
    [25.0, 0.2],
    [16.0, 0.2],
    [10.0, 0.2],
];
/// No place is moved farther, metres.
pub const MOST_M: f64 = 300.0;
/// Edge of the lattice of what is rough and what is smooth, metres.
const COAST_M: f64 = 2_500.0;
/// The roughest.
const ROUGHEST: f64 = 1.3;

/// How far a place of a shore moves east and north, metres. `lat` and `lon` are cosine and sine of its latitude and longitude; `texel_m` is how fine
/// the shore is drawn: octaves that such texels cannot hold are left out.
pub fn moved_m(lat: [f64; 2], lon: [f64; 2], texel_m: f64) -> [f64; 2] {
    let mut moved = [0.0; 2];
    if texel_m >= OCTAVES[0][0] {
        return moved;
    }
    let east = [-lon[1], lon[0], 0.0];
    let north = [-lat[1] * lon[0], -lat[1] * lon[1], lat[0]];
    let mut at = [lat[0] * lon[0], lat[0] * lon[1], lat[1]].map(|x| x * RADIUS_M);
    let rough = (0.9 + 1.8 * noise(at, COAST_M, 0)[0]).clamp(0.3, ROUGHEST);
    for (octave, [edge_m, moves]) in OCTAVES.into_iter().enumerate() {
        // Whole from two and a half texels to an edge on, nothing at half of that.
        let held = (edge_m / (1.25 * texel_m) - 1.0).clamp(0.0, 1.0);
        if held == 0.0 {
            break;
        }
        let by = noise(at, edge_m, octave as u32 + 1).map(|x| x * held * rough * moves * edge_m);
        at = [0, 1, 2].map(|axis| at[axis] + by[0] * east[axis] + by[1] * north[axis]);
        moved = [moved[0] + by[0], moved[1] + by[1]];
    }
    moved
}

/// Two gradient noises, each about -1 to 1.
fn noise(at: [f64; 3], edge_m: f64, number: u32) -> [f64; 2] {
    let place = at.map(|x| x / edge_m);
    let corner = place.map(f64::floor);
    let t = [0, 1, 2].map(|axis| place[axis] - corner[axis]);
    let fade = t.map(|t| t * t * t * (t * (t * 6.0 - 15.0) + 10.0));
    let word = corner.map(|x| x as i64 as u32);
    let mut sums = [0.0; 2];
    for i in 0..8u32 {
        let step = [i & 1, i >> 1 & 1, i >> 2];
        let bits = hash([0, 1, 2].map(|axis| word[axis].wrapping_add(step[axis])).map(|x| x ^ number << 28));
        let away = [0, 1, 2].map(|axis| t[axis] - f64::from(step[axis]));
        let weight = [0, 1, 2].map(|axis| if step[axis] == 1 { fade[axis] } else { 1.0 - fade[axis] });
        let weight = weight[0] * weight[1] * weight[2];
        for (sum, bits) in sums.iter_mut().zip([bits, bits << 8]) {
            // One of the twelve edges of a cube, four of them twice.
            let axis = [(bits >> 29) % 3, ((bits >> 29) % 3 + 1) % 3];
            let sign = |bit: u32| if bits >> bit & 1 == 0 { 1.0 } else { -1.0 };
            *sum += weight * (sign(27) * away[axis[0] as usize] + sign(28) * away[axis[1] as usize]);
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places all over the globe (a golden spiral).
    fn places(count: u32) -> impl Iterator<Item = [[f64; 2]; 2]> {
        (0..count).map(move |i| {
            let z = 1.0 - 2.0 * (f64::from(i) + 0.5) / f64::from(count);
            let (sin, cos) = libm::sincos(2.399_963_229_728_653 * f64::from(i));
            [[libm::sqrt(1.0 - z * z), z], [cos, sin]]
        })
    }

    #[test]
    fn shores_move_by_some_metres_and_by_none_in_the_mean() {
        let count = 20_000;
        let (mut sum, mut squares, mut most) = ([0.0f64; 2], [0.0f64; 2], 0.0f64);
        for [lat, lon] in places(count) {
            let moved = moved_m(lat, lon, 10.0);
            for axis in 0..2 {
                sum[axis] += moved[axis] / f64::from(count);
                squares[axis] += moved[axis] * moved[axis] / f64::from(count);
            }
            most = most.max(moved[0].hypot(moved[1]));
        }
        let deviation = squares.map(f64::sqrt);
        println!("moved by {deviation:?} m, at most {most} m, in the mean by {sum:?} m");
        // The oracle's bound on a shore that is true to 50 m is 40 m in the median.
        assert!(deviation.iter().all(|x| (20.0..34.0).contains(x)) && most < MOST_M, "{deviation:?}, {most}");
        assert!(sum.iter().all(|mean| mean.abs() < 1.0), "{sum:?}");
    }

    #[test]
    fn the_ground_is_moved_without_a_fold() {
        let (texel_m, step) = (10.0, 1.0 / RADIUS_M);
        let (mut folded, mut judged, mut least) = (0, 0, f64::INFINITY);
        for [lat, lon] in places(40_000).filter(|[lat, _]| lat[0] > 0.2) {
            let turned = |[cos, sin]: [f64; 2], by: f64| [cos - sin * by, sin + cos * by];
            let here = moved_m(lat, lon, texel_m);
            let east = moved_m(lat, turned(lon, step / lat[0]), texel_m);
            let north = moved_m(turned(lat, step), lon, texel_m);
            let [a, b] = [east, north].map(|there| [there[0] - here[0], there[1] - here[1]]);
            let grown = (1.0 + a[0]) * (1.0 + b[1]) - a[1] * b[0];
            (folded, judged, least) = (folded + u32::from(grown <= 0.0), judged + 1, least.min(grown));
        }
        println!("{folded} of {judged} folded, areas grow by {least} at least");
        assert!(folded == 0 && judged > 30_000, "{folded} of {judged}");
    }
}
