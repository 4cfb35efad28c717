//! ESRI's Shapefile (its technical description of 1998): polygons, also those with heights or measures, whose rings run clockwise about land
//! and the other way about holes. Beside it the .prj says in which coordinates.

use std::path::Path;

use super::holes::separated;
use super::{Point, Polygon};
use crate::cli::bake::reference;
use crate::data::coast::Level;
use crate::error::{Error, Result};

const HEADER: usize = 100;
/// Of the header: that it is one, and the format's version.
const MAGIC: i32 = 9994;
/// Shapes without a geometry; polygons, with heights, with measures.
const NONE: i32 = 0;
const POLYGONS: [i32; 3] = [5, 15, 25];

/// Reads a file's bytes.
///
/// # Errors
/// As for [`super::read`].
pub fn read(path: &Path, bytes: &[u8]) -> Result<Vec<Polygon>> {
    let name = path.display().to_string();
    let bad = |why: String, remedy: &str| Error::bad_data(&name, why, remedy);
    let again = "it is cut short or damaged: get it again";
    let system = std::fs::read(path.with_extension("prj")).unwrap_or_default();
    if let Some(of) = reference::unknown(&String::from_utf8_lossy(&system)) {
        let remedy = "bring it to degrees of WGS84: `ogr2ogr -t_srs EPSG:4326 OUT IN`";
        return Err(bad(format!("is, by its .prj, in the coordinates of {of}"), remedy));
    }
    if bytes.len() < HEADER || big(bytes, 0) != Some(MAGIC) {
        return Err(bad("is no Shapefile".into(), "give the .shp of one"));
    }
    let kind = little(bytes, 32).unwrap_or_default();
    if !POLYGONS.contains(&kind) {
        let remedy = "give polygons: `ogr2ogr -nlt POLYGON OUT IN`";
        return Err(bad(format!("has shapes of type {kind}, not polygons (5, 15, 25)"), remedy));
    }
    let mut polygons = Vec::new();
    let mut rest = &bytes[HEADER..];
    let mut record = 0;
    while !rest.is_empty() {
        record += 1;
        // The length is in 16-bit words.
        let length = big(rest, 4).and_then(|words| usize::try_from(words).ok()).map(|words| 2 * words);
        let shape = length.and_then(|length| rest.get(8..8 + length));
        let shape = shape.ok_or_else(|| bad(format!("ends within record {record}"), again))?;
        rest = &rest[8 + shape.len()..];
        match little(shape, 0) {
            Some(NONE) => {}
            Some(kind) if POLYGONS.contains(&kind) => {
                let rings =
                    rings(shape).ok_or_else(|| bad(format!("has a broken polygon in record {record}"), again))?;
                let separated = separated(rings).ok_or_else(|| {
                    let why = format!("has more holes among more points in record {record} than any coast");
                    bad(why, "give it as FlatGeobuf, which says which hole is whose: `ogr2ogr OUT.fgb IN`")
                })?;
                let level = Level::Land;
                polygons.extend(separated.into_iter().map(|rings| Polygon { level, rings, number: record }));
            }
            _ => return Err(bad(format!("has another kind of shape in record {record}"), again)),
        }
    }
    Ok(polygons)
}

/// The rings of a record: type, box, number of parts, number of points, where parts begin, points. `None` where that does not fit.
fn rings(shape: &[u8]) -> Option<Vec<Vec<Point>>> {
    let count = |at: usize| usize::try_from(little(shape, at)?).ok();
    let (parts, points) = (count(36)?, count(40)?);
    let starts = shape.get(44..44usize.checked_add(parts.checked_mul(4)?)?)?;
    let places = shape.get(44 + 4 * parts..(44 + 4 * parts).checked_add(points.checked_mul(16)?)?)?;
    let mut starts: Vec<usize> =
        starts.chunks_exact(4).map(|word| usize::try_from(little(word, 0)?).ok()).collect::<Option<_>>()?;
    starts.push(points);
    let point = |at: &[u8]| Some([double(at, 0)?, double(at, 8)?]);
    let ring = |ends: &[usize]| {
        let bytes = places.get(ends[0].checked_mul(16)?..ends[1].checked_mul(16)?)?;
        bytes.chunks_exact(16).map(point).collect()
    };
    starts.windows(2).map(ring).collect()
}

fn big(bytes: &[u8], at: usize) -> Option<i32> {
    Some(i32::from_be_bytes(*bytes.get(at..)?.first_chunk()?))
}

fn little(bytes: &[u8], at: usize) -> Option<i32> {
    Some(i32::from_le_bytes(*bytes.get(at..)?.first_chunk()?))
}

fn double(bytes: &[u8], at: usize) -> Option<f64> {
    Some(f64::from_le_bytes(*bytes.get(at..)?.first_chunk()?))
}
