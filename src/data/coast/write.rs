//! Writing a coast tile.

use super::{Level, Ring};

/// The tile of some rings in units of which `extent` span the tile, each of three points or more. The same bytes for the same rings.
pub fn encode(extent: u32, rings: &[Ring]) -> Vec<u8> {
    let mut tile = Vec::new();
    for level in Level::ALL {
        let mut geometry = Vec::new();
        let mut at = [0; 2];
        for ring in rings.iter().filter(|ring| ring.level == level) {
            draw(ring, &mut at, &mut geometry);
        }
        if geometry.is_empty() {
            continue;
        }
        let mut feature = Vec::new();
        number_field(&mut feature, 3, 3);
        bytes_field(&mut feature, 4, &geometry);
        let mut layer = Vec::new();
        number_field(&mut layer, 15, 2);
        bytes_field(&mut layer, 1, level.name().as_bytes());
        bytes_field(&mut layer, 2, &feature);
        number_field(&mut layer, 5, extent.into());
        bytes_field(&mut tile, 3, &layer);
    }
    tile
}

/// Twice the area, positive for an outer ring of the specification: clockwise where y points down.
pub fn doubled_area(points: &[[i32; 2]]) -> i64 {
    let next = points.iter().skip(1).chain(points.first());
    let cross = |(a, b): (&[i32; 2], &[i32; 2])| i64::from(a[0]) * i64::from(b[1]) - i64::from(b[0]) * i64::from(a[1]);
    points.iter().zip(next).map(cross).sum()
}

fn draw(ring: &Ring, at: &mut [i32; 2], to: &mut Vec<u8>) {
    let outer: Box<dyn Iterator<Item = &[i32; 2]>> =
        if doubled_area(&ring.points) >= 0 { Box::new(ring.points.iter()) } else { Box::new(ring.points.iter().rev()) };
    for (i, point) in outer.enumerate() {
        match i {
            0 => number(to, 1 << 3 | 1),
            1 => number(to, (ring.points.len() as u64 - 1) << 3 | 2),
            _ => {}
        }
        for axis in 0..2 {
            let way = i64::from(point[axis]) - i64::from(at[axis]);
            number(to, (way << 1 ^ way >> 63) as u64);
        }
        *at = *point;
    }
    number(to, 1 << 3 | 7);
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
