//! Writing a coast tile.

use super::{Level, Ring, River, Stream};

/// The tile of some rings, each of three points or more, and rivers of two or more, in units of which `extent` span the tile. The same bytes for
/// the same lines.
pub fn encode(extent: u32, rings: &[Ring], rivers: &[River]) -> Vec<u8> {
    let mut tile = Vec::new();
    for level in Level::ALL {
        let (mut geometry, mut at) = (Vec::new(), [0; 2]);
        for ring in rings.iter().filter(|ring| ring.level == level) {
            draw(&outer(ring), &mut at, &mut geometry);
            number(&mut geometry, 1 << 3 | 7);
        }
        layer(&mut tile, level.name(), extent, (3, &geometry));
    }
    for stream in Stream::ALL {
        let (mut geometry, mut at) = (Vec::new(), [0; 2]);
        for river in rivers.iter().filter(|river| river.stream == stream) {
            draw(&river.points, &mut at, &mut geometry);
        }
        layer(&mut tile, stream.name(), extent, (2, &geometry));
    }
    tile
}

/// A layer of one feature of a kind, if there is anything in it.
fn layer(tile: &mut Vec<u8>, name: &str, extent: u32, (kind, geometry): (u64, &[u8])) {
    if geometry.is_empty() {
        return;
    }
    let mut feature = Vec::new();
    number_field(&mut feature, 3, kind);
    bytes_field(&mut feature, 4, geometry);
    let mut layer = Vec::new();
    number_field(&mut layer, 15, 2);
    bytes_field(&mut layer, 1, name.as_bytes());
    bytes_field(&mut layer, 2, &feature);
    number_field(&mut layer, 5, extent.into());
    bytes_field(tile, 3, &layer);
}

/// Twice the area, positive for an outer ring of the specification: clockwise where y points down.
pub fn doubled_area(points: &[[i32; 2]]) -> i64 {
    let next = points.iter().skip(1).chain(points.first());
    let cross = |(a, b): (&[i32; 2], &[i32; 2])| i64::from(a[0]) * i64::from(b[1]) - i64::from(b[0]) * i64::from(a[1]);
    points.iter().zip(next).map(cross).sum()
}

/// The points of a ring, turned as an outer one.
fn outer(ring: &Ring) -> Vec<[i32; 2]> {
    if doubled_area(&ring.points) >= 0 { ring.points.clone() } else { ring.points.iter().rev().copied().collect() }
}

fn draw(points: &[[i32; 2]], at: &mut [i32; 2], to: &mut Vec<u8>) {
    for (i, point) in points.iter().enumerate() {
        match i {
            0 => number(to, 1 << 3 | 1),
            1 => number(to, (points.len() as u64 - 1) << 3 | 2),
            _ => {}
        }
        for axis in 0..2 {
            let way = i64::from(point[axis]) - i64::from(at[axis]);
            number(to, (way << 1 ^ way >> 63) as u64);
        }
        *at = *point;
    }
}

fn number(to: &mut Vec<u8>, mut number: u64) {
    while number >= 0x80 {
        to.push(number as u8 | 0x80);
        number >>= 7;
    }
    to.push(number as u8);
}

fn number_field(to: &mut Vec<u8>, field: u64, value: u64) {
    number(to, field << 3);
    number(to, value);
}

fn bytes_field(to: &mut Vec<u8>, field: u64, bytes: &[u8]) {
    number(to, field << 3 | 2);
    number(to, bytes.len() as u64);
    to.extend(bytes);
}
