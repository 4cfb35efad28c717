//! Height of the sea's level over the ellipsoid: the geoid EGM96, from the bundled grid of it (`scripts/make-geoid.sh`; credits: `NOTICE`).
//!
//! Between nodes, half a degree apart and rounded to 0.1 m, heights are cubic (Catmull and Rom): 0.07 m from the model's own grid of 15' in
//! the mean, 2 m at the worst, at a trench. The model itself is good to half a metre to a metre.

use std::f64::consts::{FRAC_PI_2, PI};
use std::io::Read;
use std::sync::LazyLock;

/// Columns from 180 degrees west, and rows from pole to pole, half a degree apart.
const COLUMNS: usize = 720;
const ROWS: usize = 361;
/// Deflated: by rows from the south-west each node's change from west to east, less that of the row before; zigzag, base 128.
const GRID: &[u8] = include_bytes!("geoid.bin");

/// Heights in 0.1 m. A constant of nature in a shorter form, the same for all, so that it is unpacked once.
static NODES: LazyLock<Vec<i16>> = LazyLock::new(|| unpacked().unwrap_or_else(|| vec![0; COLUMNS * ROWS]));

/// `None` where the bundled bytes are not the grid, which the tests would notice.
fn unpacked() -> Option<Vec<i16>> {
    let mut bytes = Vec::with_capacity(2 * COLUMNS * ROWS);
    flate2::read::ZlibDecoder::new(GRID).read_to_end(&mut bytes).ok()?;
    let (mut bytes, mut changes) = (bytes.into_iter(), [0; COLUMNS]);
    let mut nodes = Vec::with_capacity(COLUMNS * ROWS);
    for _ in 0..ROWS {
        let mut height = 0;
        for change in &mut changes {
            let mut zigzag = 0u32;
            for shift in (0..28).step_by(7) {
                let byte = bytes.next()?;
                zigzag |= u32::from(byte & 127) << shift;
                if byte < 128 {
                    break;
                }
            }
            *change += (zigzag >> 1) as i32 ^ -((zigzag & 1) as i32);
            height += *change;
            nodes.push(i16::try_from(height).ok()?);
        }
    }
    Some(nodes)
}

/// Height of the geoid over the ellipsoid at geodetic `lat`, `lon` (radians), m: -107 to 85. 0 for a place that is none.
pub fn height_m(lat: f64, lon: f64) -> f64 {
    if !(lat.is_finite() && lon.is_finite()) {
        return 0.0;
    }
    let y = (lat.clamp(-FRAC_PI_2, FRAC_PI_2) + FRAC_PI_2) / PI * (ROWS - 1) as f64;
    let x = (lon + PI) / (2.0 * PI) * COLUMNS as f64;
    let row = y.floor().min(ROWS as f64 - 2.0);
    let along = |row: i64| cubic([-1, 0, 1, 2].map(|step| node(row, x.floor() as i64 + step)), x - x.floor());
    cubic([-1, 0, 1, 2].map(|step| along(row as i64 + step)), y - row)
}

/// A node's height, m; beyond a pole the grid goes on down the opposite meridian.
fn node(row: i64, column: i64) -> f64 {
    let last = ROWS as i64 - 1;
    let (row, column) = match row {
        ..0 => (-row, column + COLUMNS as i64 / 2),
        _ if row > last => (2 * last - row, column + COLUMNS as i64 / 2),
        _ => (row, column),
    };
    f64::from(NODES[row as usize * COLUMNS + column.rem_euclid(COLUMNS as i64) as usize]) / 10.0
}

/// The cubic through the middle two of four even values, `t` (0…1) of the way between them.
fn cubic([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)))
}
