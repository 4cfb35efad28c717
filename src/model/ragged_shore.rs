//! Bends of a shore between its true points: gradient noise ([K. Perlin](crate::bibliography::Perlin2001)) that moves the shore to and fro,
//! a function of the place alone.
//!
//! A coast looks alike at any scale (B. Mandelbrot 1967): each octave is half as wide as the one before and moves half as far. The broadest
//! is as wide as the pieces of a coast that is true to 50 m are long. Some coasts are rough and others are smooth, by a noise of kilometres.

use super::noise::hash;
use super::relief::RADIUS_M;

/// Edge of the broadest octave's lattice, metres.
pub const BROADEST_M: f64 = 320.0;
/// Octaves; the finest is 10 m wide.
pub const OCTAVES: u32 = 6;
/// An octave moves the shore so far, of its edge, where the noise is one: its deviation is about a quarter.
pub const MOVES: f64 = 0.13;
/// Nothing is moved this far from the shore, metres: bays and islands keep their places.
pub const REACH_M: f64 = 100.0;
/// Edge of the lattice of what is rough and what is smooth, metres.
const COAST_M: f64 = 6_000.0;

/// How far the shore moves inland near a place, metres, positive where there is more water. `normal` is the place's geodetic normal;
/// `texel_m` is how far apart such places are: octaves that these cannot hold are left out. `distance_m` is how far the shore is before.
pub fn moved_m(normal: [f64; 3], texel_m: f64, distance_m: f64) -> f64 {
    let near = 1.0 - (distance_m / REACH_M) * (distance_m / REACH_M);
    if near <= 0.0 || texel_m >= BROADEST_M / 2.0 {
        return 0.0;
    }
    let at = normal.map(|x| x * RADIUS_M);
    let mut moved = 0.0;
    for octave in 0..OCTAVES {
        let edge_m = BROADEST_M / f64::from(1u32 << octave);
        // Whole from four texels to an edge on, nothing at two.
        let held = ((edge_m / texel_m - 2.0) / 2.0).clamp(0.0, 1.0);
        if held == 0.0 {
            break;
        }
        moved += held * MOVES * edge_m * noise(at, edge_m, octave + 1);
    }
    let rough = (0.9 + 1.6 * noise(at, COAST_M, 0)).clamp(0.35, 1.5);
    near * near * rough * moved
}

/// Gradient noise, about -1 to 1.
fn noise(at: [f64; 3], edge_m: f64, number: u32) -> f64 {
    let place = at.map(|x| x / edge_m);
    let corner = place.map(f64::floor);
    let t = [0, 1, 2].map(|axis| place[axis] - corner[axis]);
    let fade = t.map(|t| t * t * t * (t * (t * 6.0 - 15.0) + 10.0));
    let word = corner.map(|x| x as i64 as u32);
    let mut sum = 0.0;
    for i in 0..8u32 {
        let step = [i & 1, i >> 1 & 1, i >> 2];
        let bits = hash([0, 1, 2].map(|axis| word[axis].wrapping_add(step[axis])).map(|x| x ^ number << 28));
        let away = [0, 1, 2].map(|axis| t[axis] - f64::from(step[axis]));
        // One of the twelve edges of a cube, four of them twice.
        let axis = [(bits >> 29) % 3, ((bits >> 29) % 3 + 1) % 3];
        let sign = |bit: u32| if bits >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let slope = sign(27) * away[axis[0] as usize] + sign(28) * away[axis[1] as usize];
        let weight = [0, 1, 2].map(|axis| if step[axis] == 1 { fade[axis] } else { 1.0 - fade[axis] });
        sum += weight[0] * weight[1] * weight[2] * slope;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shores_move_by_some_metres_and_by_none_in_the_mean() {
        let count = 20_000;
        let (mut sum, mut squares, mut most) = (0.0f64, 0.0f64, 0.0f64);
        for i in 0..count {
            // Places all over the globe (a golden spiral).
            let z = 1.0 - 2.0 * (f64::from(i) + 0.5) / f64::from(count);
            let (sin, cos) = libm::sincos(2.399_963_229_728_653 * f64::from(i));
            let r = libm::sqrt(1.0 - z * z);
            let moved = moved_m([r * cos, r * sin, z], 10.0, 0.0);
            (sum, squares, most) = (sum + moved, squares + moved * moved, most.max(moved.abs()));
            assert_eq!(moved_m([r * cos, r * sin, z], 10.0, REACH_M), 0.0);
        }
        let deviation = (squares / f64::from(count)).sqrt();
        println!("moved by {deviation} m, at most {most} m");
        // The oracle's bound on a shore that is true to 50 m is 40 m in the median.
        assert!((8.0..16.0).contains(&deviation) && most < 80.0, "{deviation}, {most}");
        assert!((sum / f64::from(count)).abs() < 0.3, "{}", sum / f64::from(count));
    }
}
