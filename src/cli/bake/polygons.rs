//! A coast of one's own: polygons of GeoJSON, Shapefile or FlatGeobuf, as shorelines.
//!
//! A polygon is land, its holes are lakes. A property `kind` of a GeoJSON feature may say `lake`, `island` (in a lake) or `pond` (on such an
//! island) instead of `land`; then its holes are left to polygons of their own.

mod flatgeobuf;
mod geojson;
mod holes;
mod shapefile;

use std::path::Path;

use super::shorelines::{Shoreline, shoreline};
use crate::data::coast::Level;
use crate::error::{Error, Result};

/// The largest file that is read, bytes.
const LARGEST: u64 = 2 << 30;
/// The largest of JSON, of which each number takes 32 bytes while it is read: some gigabytes for this.
const LARGEST_JSON: u64 = 256 << 20;

/// Longitude and latitude, degrees.
type Point = [f64; 2];

/// A polygon as a file has it: what it is, its outline, then its holes.
struct Polygon {
    level: Level,
    rings: Vec<Vec<Point>>,
    /// Where it stands in the file, for messages.
    number: usize,
}

/// The endings that [`read`] knows.
pub fn is_known(path: &Path) -> bool {
    matches!(ending(path).as_str(), "geojson" | "json" | "shp" | "fgb")
}

fn ending(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default()
}

/// Reads a file of polygons in degrees of WGS84.
///
/// # Errors
/// [`Error::Io`]; [`Error::BadData`] that says what is wrong, where, and what to do.
pub fn read(path: &Path) -> Result<Vec<Shoreline>> {
    let name = path.display().to_string();
    let length = std::fs::metadata(path).map_err(|e| Error::io(&name, e, "check the path and its permissions"))?.len();
    let ending = ending(path);
    let (largest, remedy) = match ending.as_str() {
        "shp" | "fgb" => (LARGEST, "cut it, or simplify it: `ogr2ogr -simplify 0.0002 OUT IN`"),
        _ => (LARGEST_JSON, "give it as FlatGeobuf or Shapefile: `ogr2ogr OUT.fgb IN`"),
    };
    if length > largest {
        let why =
            format!("is {} MiB long, more than the {} MiB that are read", length.div_ceil(1 << 20), largest >> 20);
        return Err(Error::bad_data(&name, why, remedy));
    }
    let bytes = std::fs::read(path).map_err(|e| Error::io(&name, e, "check the path and its permissions"))?;
    let polygons = match ending.as_str() {
        "shp" => shapefile::read(path, &bytes)?,
        "fgb" => flatgeobuf::read(&name, &bytes)?,
        _ => geojson::read(&name, &bytes)?,
    };
    if polygons.is_empty() {
        let remedy = "give the land's polygons; of lines make them first: `ogr2ogr -nlt POLYGON OUT IN`";
        return Err(Error::bad_data(&name, "has no polygons", remedy));
    }
    let mut lines = Vec::new();
    for polygon in polygons {
        let level = polygon.level;
        for (number, ring) in polygon.rings.iter().enumerate() {
            check(ring, &name, polygon.number)?;
            let ring = &canonical(ring);
            match (number, level) {
                (0, _) => lines.push(shoreline(level, ring)),
                (_, Level::Land) => lines.push(shoreline(Level::Lake, ring)),
                _ => {}
            }
        }
    }
    Ok(lines)
}

/// A ring from its westernmost point on, counter-clockwise: formats differ in both, and simplifying keeps the first point.
fn canonical(ring: &[Point]) -> Vec<Point> {
    let mut ring = ring[..ring.len() - usize::from(ring.first() == ring.last())].to_vec();
    if doubled_area(&ring) < 0.0 {
        ring.reverse();
    }
    let before = |a: &Point, b: &Point| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
    let first = (0..ring.len()).min_by(|a, b| before(&ring[*a], &ring[*b])).unwrap_or(0);
    ring.rotate_left(first);
    ring
}

/// Twice the area of a ring, closed or not, positive counter-clockwise.
fn doubled_area(ring: &[Point]) -> f64 {
    let next = ring.iter().skip(1).chain(ring.first());
    ring.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum()
}

fn check(ring: &[Point], name: &str, number: usize) -> Result<()> {
    let bad = |why: String, remedy: &str| Err(Error::bad_data(name, format!("polygon {number} {why}"), remedy));
    let closed = ring.first() == ring.last();
    if ring.len() < if closed { 4 } else { 3 } {
        return bad(format!("has a ring of {} points", ring.len()), "mend it: `ogr2ogr -makevalid OUT IN`");
    }
    for [lon, lat] in ring {
        if !(lon.is_finite() && lat.is_finite()) {
            return bad(format!("has a point at {lon}, {lat}"), "mend it: `ogr2ogr -makevalid OUT IN`");
        }
        if !(-180.0..=180.0).contains(lon) || !(-90.0..=90.0).contains(lat) {
            let remedy =
                "bring it to degrees, cut at the antimeridian: `ogr2ogr -t_srs EPSG:4326 -wrapdateline OUT IN`";
            return bad(format!("has a point at {lon}, {lat}, which are no degrees"), remedy);
        }
    }
    Ok(())
}
