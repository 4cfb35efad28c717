//! A round island as files of one's own: GeoTIFF in strips and in tiles, GeoJSON, Shapefile, FlatGeobuf.

use std::io::Cursor;

use flatgeobuf::geozero::{GeomProcessor, error::Result as GeoResult};
use flatgeobuf::{FgbCrs, FgbWriter, FgbWriterOptions, GeometryType, GeozeroGeometry};
use tiff::encoder::{Compression, DeflateLevel, TiffEncoder, colortype::Gray32Float};
use tiff::tags::Tag;

/// The island's middle, latitude and longitude, and its radius, degrees of latitude.
pub const MIDDLE: [f64; 2] = [10.3, -20.2];
pub const RADIUS_DEG: f64 = 0.08;
/// The grid: its north-western node, nodes along a side, and their distance, degrees.
pub const CORNER: [f64; 2] = [10.55, -20.45];
pub const SIDE: usize = 201;
pub const STEP_DEG: f64 = 0.0025;

/// Metres over the sea: a cone, and a level bed from 14 km on.
pub fn cone_m(lat_deg: f64, lon_deg: f64) -> f64 {
    let out = (lat_deg - MIDDLE[0]).hypot((lon_deg - MIDDLE[1]) * MIDDLE[0].to_radians().cos());
    (400.0 * (1.0 - out / RADIUS_DEG)).max(-250.0)
}

pub fn grid() -> Vec<f32> {
    let at = |i: usize| [CORNER[0] - (i / SIDE) as f64 * STEP_DEG, CORNER[1] + (i % SIDE) as f64 * STEP_DEG];
    (0..SIDE * SIDE).map(at).map(|[lat, lon]| cone_m(lat, lon) as f32).collect()
}

/// GeoTIFF's keys: projected (1) or geographic (2), pixels that are points, a system.
pub fn keys(model: u16, system: u16) -> Vec<u16> {
    let number = if model == 1 { 3072 } else { 2048 };
    vec![1, 1, 0, 3, 1024, 0, 1, model, 1025, 0, 1, 2, number, 0, 1, system]
}

/// A GeoTIFF in strips, deflated.
pub fn geotiff(values: &[f32], keys: &[u16], none: Option<&str>) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let encoder = TiffEncoder::new(&mut bytes).unwrap();
    let mut encoder = encoder.with_compression(Compression::Deflate(DeflateLevel::Fast));
    let mut image = encoder.new_image::<Gray32Float>(SIDE as u32, (values.len() / SIDE) as u32).unwrap();
    let tags = image.encoder();
    tags.write_tag(Tag::Unknown(33550), &[STEP_DEG, STEP_DEG, 0.0][..]).unwrap();
    tags.write_tag(Tag::Unknown(33922), &[0.0, 0.0, 0.0, CORNER[1], CORNER[0], 0.0][..]).unwrap();
    if !keys.is_empty() {
        tags.write_tag(Tag::Unknown(34735), keys).unwrap();
    }
    if let Some(none) = none {
        tags.write_tag(Tag::Unknown(42113), none).unwrap();
    }
    image.write_data(values).unwrap();
    bytes.into_inner()
}

/// The same as a Cloud-optimised one has it: in tiles, which reach beyond the image.
pub fn tiled(values: &[f32]) -> Vec<u8> {
    const TILE: usize = 64;
    let across = SIDE.div_ceil(TILE);
    let value = |[row, column]: [usize; 2]| {
        values.get(row * SIDE + column).filter(|_| column < SIDE).unwrap_or(&0.0).to_le_bytes()
    };
    let tiles: Vec<u8> = (0..across * across)
        .flat_map(|tile| {
            (0..TILE * TILE).map(move |i| [tile / across * TILE + i / TILE, tile % across * TILE + i % TILE])
        })
        .flat_map(value)
        .collect();
    let (size, first) = (TILE * TILE * 4, 1_000);
    let words = |list: &[usize]| list.iter().flat_map(|x| (*x as u32).to_le_bytes()).collect::<Vec<u8>>();
    let shorts = |list: &[u16]| list.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let doubles = |list: &[f64]| list.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let offsets: Vec<usize> = (0..across * across).map(|tile| first + tile * size).collect();
    // Tags: number, type (3: 16 bits, 4: 32, 12: double), values; longer ones follow the list.
    let tags: Vec<(u16, u16, Vec<u8>)> = vec![
        (256, 4, words(&[SIDE])),
        (257, 4, words(&[SIDE])),
        (258, 3, shorts(&[32])),
        (259, 3, shorts(&[1])),
        (262, 3, shorts(&[1])),
        (277, 3, shorts(&[1])),
        (322, 4, words(&[TILE])),
        (323, 4, words(&[TILE])),
        (324, 4, words(&offsets)),
        (325, 4, words(&vec![size; across * across])),
        (339, 3, shorts(&[3])),
        (33550, 12, doubles(&[STEP_DEG, STEP_DEG, 0.0])),
        (33922, 12, doubles(&[0.0, 0.0, 0.0, CORNER[1], CORNER[0], 0.0])),
        (34735, 3, shorts(&keys(2, 4326))),
    ];
    let mut file = [&b"II\x2a\0\x08\0\0\0"[..], &(tags.len() as u16).to_le_bytes()].concat();
    let mut more = Vec::new();
    let after = 8 + 2 + 12 * tags.len() + 4;
    for (number, kind, bytes) in tags {
        let count = bytes.len() / [2, 4, 8][usize::from(kind > 3) + usize::from(kind > 4)];
        file.extend([&number.to_le_bytes()[..], &kind.to_le_bytes(), &(count as u32).to_le_bytes()].concat());
        if bytes.len() <= 4 {
            file.extend(bytes.iter().copied().chain([0; 4]).take(4));
        } else {
            file.extend(((after + more.len()) as u32).to_le_bytes());
            more.extend(bytes);
        }
    }
    file.extend([0; 4]);
    file.extend(more);
    assert!(file.len() <= first);
    file.resize(first, 0);
    file.extend(tiles);
    file
}

/// A circle of 120 points, closed, counter-clockwise: 3 m off the round shore at most.
fn circle(radius_deg: f64) -> Vec<[f64; 2]> {
    let point = |i: usize| {
        let (sin, cos) = (std::f64::consts::TAU * (i % 120) as f64 / 120.0).sin_cos();
        [MIDDLE[1] + radius_deg * cos / MIDDLE[0].to_radians().cos(), MIDDLE[0] + radius_deg * sin]
    };
    (0..=120).map(point).collect()
}

/// The island with a lake round its middle.
fn rings() -> [Vec<[f64; 2]>; 2] {
    let mut lake = circle(0.02);
    lake.reverse();
    [circle(RADIUS_DEG), lake]
}

pub fn geojson() -> String {
    let rings = serde_json::to_string(&rings()).unwrap();
    let island = r#"{"type":"Feature","properties":{"name":"x"},"geometry":{"type":"Polygon","coordinates":"#;
    let nothing = r#"{"type":"Feature","properties":null,"geometry":null}"#;
    format!(r#"{{"type":"FeatureCollection","features":[{island}{rings}}}}},{nothing}]}}"#)
}

/// Rings run clockwise about land in a Shapefile.
pub fn shapefile() -> Vec<u8> {
    shapefile_of(&rings().map(|mut ring| {
        ring.reverse();
        ring
    }))
}

/// A Shapefile of one record.
pub fn shapefile_of(rings: &[Vec<[f64; 2]>]) -> Vec<u8> {
    let points: Vec<u8> = rings.iter().flatten().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let mut ends = vec![0];
    rings.iter().for_each(|ring| ends.push(ends[ends.len() - 1] + ring.len()));
    let counts = [rings.len(), ends[rings.len()]];
    let numbers: Vec<u8> = counts.iter().chain(&ends[..rings.len()]).flat_map(|x| (*x as i32).to_le_bytes()).collect();
    let record = [&5i32.to_le_bytes()[..], &[0; 32], &numbers, &points].concat();
    let mut file = vec![0; 100];
    file[..4].copy_from_slice(&9994i32.to_be_bytes());
    file[28..32].copy_from_slice(&1000i32.to_le_bytes());
    file[32..36].copy_from_slice(&5i32.to_le_bytes());
    file.extend([1i32, record.len() as i32 / 2].map(i32::to_be_bytes).concat());
    file.extend(record);
    file
}

struct Rings;

impl GeozeroGeometry for Rings {
    fn process_geom<P: GeomProcessor>(&self, to: &mut P) -> GeoResult<()> {
        to.polygon_begin(true, 2, 0)?;
        for (number, ring) in rings().iter().enumerate() {
            to.linestring_begin(false, ring.len(), number)?;
            ring.iter().enumerate().try_for_each(|(i, [lon, lat])| to.xy(*lon, *lat, i))?;
            to.linestring_end(false, number)?;
        }
        to.polygon_end(true, 0)
    }
}

pub fn flatgeobuf(code: i32) -> Vec<u8> {
    let options = FgbWriterOptions { crs: FgbCrs { code, ..FgbCrs::default() }, ..FgbWriterOptions::default() };
    let mut writer = FgbWriter::create_with_options("island", GeometryType::Polygon, options).unwrap();
    writer.add_feature_geom(Rings, |_| {}).unwrap();
    let mut bytes = Vec::new();
    writer.write(&mut bytes).unwrap();
    bytes
}
