//! FlatGeobuf (version 3), by the crate of that name. It believes the sizes that a file claims, so these are held against the file before.

use ::flatgeobuf::{FallibleStreamingIterator, FgbReader, Geometry, GeometryType};

use super::{Point, Polygon};
use crate::data::coast::Level;
use crate::error::{Error, Result};

/// Bytes of a node of the index: four coordinates and an offset.
const NODE: u64 = 40;
/// Polygons may lie in collections so deep.
const DEEPEST: usize = 8;

/// Reads a file's bytes.
///
/// # Errors
/// As for [`super::read`].
pub fn read(name: &str, bytes: &[u8]) -> Result<Vec<Polygon>> {
    let damaged = |why: String| Error::bad_data(name, why, "it is cut short or damaged: get it again");
    let reader = FgbReader::open(bytes).map_err(|e| damaged(format!("is no FlatGeobuf that can be read: {e}")))?;
    let header = reader.header();
    if let Some(crs) = header.crs().filter(|crs| ![0, 4326].contains(&crs.code())) {
        let remedy = "bring it to degrees of WGS84: `ogr2ogr -t_srs EPSG:4326 OUT IN`";
        return Err(Error::bad_data(name, format!("is in the coordinates of EPSG:{}", crs.code()), remedy));
    }
    let kind = header.geometry_type();
    let first = index_end(bytes, header.features_count(), header.index_node_size());
    let ends = first.and_then(|first| features(bytes, first, header.features_count()));
    let count = ends.ok_or_else(|| damaged("ends before its features do".into()))?;
    let mut all = reader.select_all_seq().map_err(|e| damaged(e.to_string()))?;
    let mut polygons = Vec::new();
    for number in 1..=count {
        let feature = all.next().map_err(|e| damaged(format!("has an unreadable feature {number}: {e}")))?;
        let Some(geometry) = feature.and_then(|feature| feature.geometry()) else { continue };
        add(&mut polygons, &geometry, kind, number, 0)
            .ok_or_else(|| damaged(format!("has a broken feature {number}")))?;
    }
    Ok(polygons)
}

/// Where the features begin: after the magic number, the header and the index, a tree of `node_size` children a node.
fn index_end(bytes: &[u8], features: u64, node_size: u16) -> Option<u64> {
    let header = u64::from(u32::from_le_bytes(*bytes.get(8..)?.first_chunk()?));
    let start = 12 + header;
    if node_size == 0 || features == 0 {
        return Some(start);
    }
    if node_size < 2 || features > bytes.len() as u64 / NODE {
        return None;
    }
    let (mut level, mut nodes) = (features, features);
    // Even a single feature has a root above it.
    loop {
        level = level.div_ceil(u64::from(node_size));
        nodes += level;
        if level == 1 {
            return Some(start + NODE * nodes);
        }
    }
}

/// How many features there are from `at` to the end, each with its size before it; `None` where that does not fit, or the header counts others.
fn features(bytes: &[u8], at: u64, counted: u64) -> Option<usize> {
    let mut rest = bytes.get(usize::try_from(at).ok()?..)?;
    let mut count = 0;
    while !rest.is_empty() {
        let size = u32::from_le_bytes(*rest.first_chunk()?) as usize;
        rest = rest.get(4usize.checked_add(size)?..)?;
        count += 1;
    }
    (counted == 0 || counted == count as u64).then_some(count)
}

/// Adds a geometry's polygons; `None` where its numbers do not fit each other.
fn add(
    polygons: &mut Vec<Polygon>,
    geometry: &Geometry<'_>,
    kind: GeometryType,
    number: usize,
    depth: usize,
) -> Option<()> {
    // A file of one kind says so once, in its header.
    let own = if geometry.type_() == GeometryType::Unknown { kind } else { geometry.type_() };
    match own {
        GeometryType::Polygon => {
            let points: Vec<f64> = geometry.xy()?.iter().collect();
            let points: Vec<Point> = points.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
            let ends = geometry
                .ends()
                .map_or_else(|| vec![points.len()], |ends| ends.iter().map(|end| end as usize).collect());
            let mut rings = Vec::new();
            let mut start = 0;
            for end in ends {
                rings.push(points.get(start..end)?.to_vec());
                start = end;
            }
            polygons.push(Polygon { level: Level::Land, rings, number });
        }
        GeometryType::MultiPolygon | GeometryType::GeometryCollection if depth < DEEPEST => {
            let inner = if own == GeometryType::MultiPolygon { GeometryType::Polygon } else { GeometryType::Unknown };
            for part in geometry.parts()?.iter() {
                add(polygons, &part, inner, number, depth + 1)?;
            }
        }
        _ => {}
    }
    Some(())
}
