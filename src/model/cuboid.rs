//! The cuboid around the ellipsoid, 2a × 2a × 2b, whose six faces carry the bisected mesh, and integers for the points on it.
//!
//! ```text
//!   +------C------+      Each face: its centre A and four corners make four triangles (A; L, R),
//!   | \    |    / |      counter-clockwise from outside, whose bases L–R are the cuboid's edges.
//!   |   \  |  /   |      24 roots; a bisection halves the base:
//!   C---- A ------C          (A; L, R)  ->  (M; A, L) and (M; R, A),   M = (L + R) / 2
//!   |   /  |  \   |
//!   | /    |    \ |      In units of a, a and b the cuboid is the cube [-1, 1]³ and the ellipsoid its unit sphere, on
//!   +------C------+      which a point m of the cube stands for m / |m|.
//! ```
//! Coordinates are whole numbers of 2^-30, counted from -1: midpoints are exact for 60 bisections, and two triangles that
//! share a corner have the same bits for it, on whichever faces they lie. 2^-30 of the semi-axis is 6 mm.

use glam::{DVec3, IVec3};

use super::earth::WGS84;

/// Whole numbers to a semi-axis of the cuboid.
pub const UNIT: u32 = 1 << 30;

/// A point of the cuboid: each coordinate 0 to 2 [`UNIT`], at least one of them at an end.
pub type Point = [u32; 3];

/// Apex and the two ends of the base, counter-clockwise from outside.
pub type Triangle = [Point; 3];

/// The unit vector that a point stands for on the sphere that the ellipsoid is in units of its semi-axes.
pub fn scaled_direction(point: Point) -> DVec3 {
    let centred = point.map(|x| f64::from(x) / f64::from(UNIT) - 1.0);
    DVec3::from_array(centred).normalize()
}

/// The point of the cube [-1, 1]³ over a place on the ellipsoid, earth-centred, metres.
pub fn cube_from_ecef(ecef: DVec3) -> DVec3 {
    let scaled = ecef / DVec3::new(WGS84.a, WGS84.a, WGS84.b);
    scaled / scaled.abs().max_element()
}

/// The 24 triangles that the mesh begins with, and for each the triangles across its base, left and right edge.
pub fn roots() -> ([Triangle; 24], [[u32; 3]; 24]) {
    let offset = |v: IVec3| v.to_array().map(|x| UNIT.wrapping_add_signed(x * UNIT as i32));
    let axes = [IVec3::X, IVec3::Y, IVec3::Z];
    let root = |index: usize| {
        let (face, side) = (index / 4, index % 4);
        let out = if face % 2 == 0 { axes[face / 2] } else { -axes[face / 2] };
        // Counter-clockwise from outside: u × v = out.
        let u = axes[(face / 2 + 1) % 3];
        let v = out.cross(u);
        let corner = |k: usize| [u + v, v - u, -u - v, u - v][k % 4] + out;
        [out, corner(side), corner(side + 1)].map(offset)
    };
    let triangles: [Triangle; 24] = std::array::from_fn(root);
    let edge = |[apex, left, right]: Triangle, e: usize| [[left, right], [apex, left], [right, apex]][e];
    let across = |index: usize, e: usize| {
        let [from, to] = edge(triangles[index], e);
        let same = |other: &usize| (0..3).any(|f| edge(triangles[*other], f) == [to, from]);
        // The surface is closed: there always is one.
        (0..24).find(same).unwrap_or_default() as u32
    };
    (triangles, std::array::from_fn(|index| std::array::from_fn(|e| across(index, e))))
}

/// The ends of the edge that `point` was made the middle of; none for the eight corners and six centres.
///
/// The lowest set bits tell: in one coordinate alone, the edge lies along it; in two, it is the diagonal of a square, the one
/// through the centre of the square of twice the side.
pub fn parents(point: Point) -> Option<[Point; 2]> {
    let lowest = point.map(u32::trailing_zeros);
    let k = lowest.into_iter().min()?;
    let along = lowest.map(|zeros| zeros == k);
    let diagonal = along.iter().filter(|along| **along).count() == 2;
    if k > 30 || (diagonal && k == 30) {
        return None;
    }
    let (mut first, mut second) = (point, point);
    for axis in (0..3).filter(|axis| along[*axis]) {
        let (below, above) = (point[axis] - (1 << k), point[axis] + (1 << k));
        let odd_below = below >> (k + 1) & 1 == 1;
        (first[axis], second[axis]) = if diagonal && !odd_below { (above, below) } else { (below, above) };
    }
    Some([first, second])
}
