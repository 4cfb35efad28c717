//! How high the highest ground is about a place, roughly: what eyes in space need to know before anything has been loaded.

use super::earth::WGS84;

/// A cell's side, degrees.
const CELL_DEG: f64 = 10.0;
/// Hundreds of metres that no ground of a cell of 10 by 10 degrees is higher than: rows from the north, columns from 180° W on. From the
/// elevation of the bundled world (ETOPO5), rounded up.
#[rustfmt::skip]
pub const HIGHEST_HM: [[u8; 36]; 18] = [
    [0, 0, 0, 0, 0, 0, 0, 1, 17, 25, 25, 16, 21, 23, 23, 15, 11, 0, 0, 5, 7, 1, 3, 4, 4, 1, 1, 8, 0, 0, 0, 0, 0, 0, 0, 0],
    [7, 2, 2, 2, 1, 8, 7, 4, 17, 17, 19, 21, 25, 32, 33, 26, 7, 2, 0, 13, 8, 3, 1, 10, 10, 1, 8, 11, 8, 8, 11, 9, 7, 4, 1, 6],
    [9, 11, 43, 39, 27, 30, 8, 6, 6, 6, 12, 25, 22, 31, 32, 29, 19, 1, 21, 16, 11, 8, 4, 13, 13, 2, 8, 15, 9, 9, 19, 20, 25, 17, 14, 18],
    [4, 9, 17, 8, 28, 26, 27, 9, 8, 5, 9, 11, 9, 8, 0, 0, 3, 9, 15, 12, 4, 4, 4, 10, 5, 10, 32, 28, 28, 25, 17, 21, 10, 26, 34, 3],
    [0, 0, 0, 0, 0, 27, 36, 37, 9, 6, 11, 11, 7, 0, 0, 0, 0, 24, 36, 31, 23, 28, 37, 6, 29, 57, 59, 38, 34, 22, 22, 16, 16, 5, 0, 0],
    [0, 0, 0, 0, 0, 26, 36, 38, 8, 15, 12, 0, 0, 0, 1, 2, 4, 35, 19, 37, 23, 32, 37, 42, 45, 76, 65, 71, 55, 22, 12, 24, 15, 0, 0, 0],
    [0, 1, 18, 0, 0, 0, 14, 30, 28, 6, 12, 0, 0, 0, 0, 0, 22, 17, 24, 27, 12, 19, 23, 37, 27, 20, 70, 60, 62, 16, 31, 0, 1, 0, 0, 0],
    [0, 0, 29, 0, 0, 0, 1, 29, 37, 24, 48, 19, 1, 0, 0, 9, 11, 7, 16, 24, 24, 37, 29, 13, 0, 19, 12, 18, 17, 8, 21, 0, 1, 0, 0, 0],
    [0, 0, 1, 0, 0, 0, 0, 0, 4, 29, 45, 28, 10, 1, 0, 0, 10, 9, 18, 19, 32, 37, 26, 4, 0, 13, 17, 23, 16, 23, 22, 1, 0, 1, 1, 0],
    [0, 0, 0, 1, 1, 0, 0, 0, 7, 29, 53, 4, 6, 9, 9, 0, 1, 0, 2, 14, 28, 36, 3, 0, 0, 0, 0, 4, 19, 22, 20, 36, 33, 13, 12, 0],
    [4, 1, 1, 11, 1, 0, 0, 0, 0, 0, 53, 54, 10, 14, 7, 0, 0, 1, 0, 21, 17, 22, 21, 6, 1, 0, 0, 0, 1, 0, 9, 5, 13, 5, 7, 7],
    [1, 0, 1, 1, 0, 0, 0, 1, 0, 0, 49, 56, 14, 19, 0, 1, 0, 0, 0, 20, 31, 19, 20, 20, 0, 0, 0, 0, 0, 10, 9, 9, 10, 13, 8, 0],
    [0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 51, 50, 5, 0, 0, 0, 1, 0, 0, 14, 25, 9, 0, 0, 0, 1, 0, 0, 0, 5, 6, 8, 18, 14, 0, 13],
    [1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 22, 16, 0, 0, 0, 0, 0, 1, 0, 0, 0, 3, 0, 1, 13, 2, 0, 0, 0, 0, 0, 0, 13, 0, 16, 16],
    [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 19, 12, 3, 0, 14, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 2, 0],
    [0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 16, 57, 16, 4, 0, 0, 0, 1, 1, 4, 5, 12, 24, 28, 26, 22, 28, 59, 59, 26, 26, 26, 24, 17, 6, 0],
    [1, 4, 10, 16, 25, 25, 25, 22, 23, 28, 17, 22, 9, 10, 10, 22, 29, 37, 40, 40, 36, 36, 36, 35, 37, 39, 40, 39, 36, 33, 32, 31, 27, 25, 24, 10],
    [32, 19, 4, 7, 12, 20, 22, 27, 24, 22, 14, 17, 17, 21, 23, 25, 28, 29, 33, 35, 36, 38, 38, 39, 42, 41, 40, 39, 36, 32, 31, 29, 29, 29, 32, 29],
];

/// Metres that no ground is higher than which an eye so high (metres) over a place (radians) may see, were all of it at the sea's level: summits that
/// stand over the horizon are farther away than wide.
pub fn highest_in_view_m(lat: f64, lon: f64, altitude_m: f64) -> f64 {
    let horizon = libm::acos(1.0 / (1.0 + altitude_m.max(0.0) / WGS84.a));
    let (sin, cos) = libm::sincos(lat);
    let mut highest = 0;
    for (row, cells) in (0..).zip(&HIGHEST_HM) {
        for (column, cell) in (0..).zip(cells) {
            let middle = |index: i32, from: f64| (from + CELL_DEG * (f64::from(index) + 0.5)).to_radians();
            let (there, east) = (middle(17 - row, -90.0), middle(column, -180.0));
            let (sin_there, cos_there) = libm::sincos(there);
            let cosine = sin * sin_there + cos * cos_there * libm::cos(east - lon);
            // From its middle to its corners.
            let reach = (0.5 * CELL_DEG * std::f64::consts::SQRT_2).to_radians();
            if libm::acos(cosine.clamp(-1.0, 1.0)) < horizon + reach {
                highest = highest.max(*cell);
            }
        }
    }
    100.0 * f64::from(highest)
}
