//! Foreign bytes that are damaged or made to harm: every reader answers with an error that says what is wrong, in bounded
//! memory, and never panics. Long, but one thing: a list of readers, each with its lies, and at the end all of them with any bytes.

use ocean_globe::data::coast::write::encode;
use ocean_globe::data::coast::{self, Level, Ring, River, Shores, Stream};
use ocean_globe::data::netcdf::NetCdf;
use ocean_globe::data::pmtiles::write::ArchiveWriter;
use ocean_globe::data::pmtiles::{
    Archive, ByteSource, Entry, HEADER_BYTES, decode_directory, encode_directory, id_from_zxy, zxy_from_id,
};
use ocean_globe::data::tile::{Projection, TileId};
use ocean_globe::data::{imagery, terrarium, water};
use ocean_globe::error::Result;
use proptest::prelude::*;
use std::fs;
use std::path::PathBuf;
use std::sync::OnceLock;

struct Memory(Vec<u8>);

impl ByteSource for Memory {
    async fn read(&self, offset: u64, length: u64) -> Result<Vec<u8>> {
        let start = offset.min(self.0.len() as u64) as usize;
        let end = offset.saturating_add(length).min(self.0.len() as u64) as usize;
        Ok(self.0[start..end].to_vec())
    }

    fn name(&self) -> &str {
        "memory"
    }
}

fn path(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("ocean-globe-hostile-{}-{name}", std::process::id()))
}

fn contents(z: u8, x: u32, y: u32) -> Vec<u8> {
    // One tile in four is the same as others.
    if (x + y).is_multiple_of(4) { b"the same".to_vec() } else { format!("tile {z}/{x}/{y}").into_bytes() }
}

/// An archive of all tiles down to `deepest`.
fn archive(name: &str, deepest: u8) -> Vec<u8> {
    let path = path(name);
    let mut writer = ArchiveWriter::create(&path).unwrap();
    for z in (0..=deepest).rev() {
        for (x, y) in (0..1 << z).flat_map(|x| (0..1 << z).map(move |y| (x, y))) {
            writer.add(z, x, y, &contents(z, x, y)).unwrap();
        }
    }
    let size = writer.finish(&serde_json::json!({ "name": "test" })).unwrap();
    let bytes = fs::read(&path).unwrap();
    fs::remove_file(&path).unwrap();
    assert_eq!(size, bytes.len() as u64);
    bytes
}

fn small_archive() -> &'static [u8] {
    static ARCHIVE: OnceLock<Vec<u8>> = OnceLock::new();
    ARCHIVE.get_or_init(|| archive("small", 3))
}

fn open(bytes: &[u8]) -> Result<Archive<Memory>> {
    pollster::block_on(Archive::open(Memory(bytes.to_vec())))
}

#[test]
fn archives_with_and_without_leaves_give_back_every_tile() {
    for deepest in [0, 3, 8] {
        let bytes = archive(&format!("whole-{deepest}"), deepest);
        let archive = open(&bytes).unwrap();
        let leaves = archive.header().leaves.1;
        assert_eq!(leaves > 0, deepest == 8, "{leaves} bytes of leaves");
        assert!(HEADER_BYTES as u64 + archive.header().root.1 <= 16_384);
        for z in 0..=deepest {
            for (x, y) in (0..1 << z).flat_map(|x| (0..1 << z).map(move |y| (x, y))) {
                let tile = pollster::block_on(archive.tile(z, x, y)).unwrap();
                assert_eq!(tile, Some(contents(z, x, y)), "{z}/{x}/{y}");
            }
        }
        assert_eq!(pollster::block_on(archive.tile(deepest + 1, 0, 0)).unwrap(), None);
        assert_eq!(pollster::block_on(archive.tile(2, 4, 0)).unwrap(), None);
        assert_eq!(archive.metadata()["name"], "test");
        // "the same" is stored once.
        assert_eq!(bytes.windows(8).filter(|w| w == b"the same").count(), 1);
    }
}

/// An archive without compression, from its root directory and whatever follows.
fn raw_archive(root: &[u8], leaves: &[u8], data: &[u8]) -> Vec<u8> {
    let mut bytes = b"PMTiles\x03".to_vec();
    let mut at = HEADER_BYTES as u64;
    for section in [root, b"{}", leaves, data] {
        bytes.extend([at, section.len() as u64].map(u64::to_le_bytes).as_flattened());
        at += section.len() as u64;
    }
    bytes.extend([0; 24]);
    bytes.extend([0, 1, 1, 2, 0, 9]);
    bytes.resize(HEADER_BYTES, 0);
    bytes.extend([root, b"{}", leaves, data].concat());
    bytes
}

#[test]
fn directories_that_lie_are_refused() {
    let entry = |id, offset, length, run_length| Entry { id, offset, length, run_length };
    let tile = |root: &[Entry], leaves: &[u8]| {
        let archive = open(&raw_archive(&encode_directory(root), leaves, b"0123456789"))?;
        pollster::block_on(archive.tile(0, 0, 0))
    };
    assert_eq!(tile(&[entry(0, 2, 3, 1)], b"").unwrap().unwrap(), b"234");
    // A leaf that points at itself.
    let circle = encode_directory(&[entry(0, 0, 5, 0)]);
    assert_eq!(circle.len(), 5);
    let huge = u32::MAX;
    for (root, leaves, part) in [
        (entry(0, 8, 3, 1), &b""[..], "outside its section"),
        (entry(0, u64::MAX / 2, 3, 1), b"", "outside its section"),
        (entry(0, 0, huge, 1), b"", "bytes"),
        (entry(0, 0, 9, 0), b"", "outside its section"),
        (entry(0, 0, 5, 0), &circle, "nested deeper"),
    ] {
        let error = tile(&[root], leaves).unwrap_err().to_string();
        assert!(error.contains(part), "{root:?}: {error}");
    }
    for (bytes, part) in [
        (&[0xff; 12][..], "overflows"),
        (&[0x80, 0x80], "ends early"),
        (&[0xff, 0xff, 0xff, 0xff, 0x0f, 1, 1, 1], "as many entries"),
        (&[2, 0, 0, 1, 1, 1, 1, 1, 0], "do not rise"),
        (&[1, 0, 1, 0, 1], "no bytes"),
    ] {
        let error = decode_directory("x", bytes).unwrap_err().to_string();
        assert!(error.contains(part), "{bytes:?}: {error}");
    }
}

/// A PNG of any size, depth and colour, filled with zeros.
fn png(side: u32, color: png::ColorType, depth: png::BitDepth) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side, side);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == png::ColorType::Indexed {
        encoder.set_palette(vec![0; 3]);
    }
    let row = side as usize * color.samples() * (depth as usize) / 8;
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&vec![0; row * side as usize]).unwrap();
    writer.finish().unwrap();
    bytes
}

#[test]
fn pictures_that_are_no_tiles_are_refused_with_the_reason() {
    use png::{BitDepth, ColorType};
    let good = png(256, ColorType::Rgb, BitDepth::Eight);
    assert_eq!(terrarium::decode("tile", &good, terrarium::Encoding::Terrarium).unwrap(), vec![-32_768.0; 65_536]);
    assert!(terrarium::decode("tile", &png(256, ColorType::Rgba, BitDepth::Eight), Default::default()).is_ok());
    // A header that promises 2^31 - 1 rows and columns.
    let mut huge = good.clone();
    huge[16..24].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff]);
    for (bytes, part) in [
        (Vec::new(), "cannot be read as PNG"),
        (b"<html>not found</html>".to_vec(), "cannot be read as PNG"),
        (good[..good.len() / 2].to_vec(), "cannot be read as PNG"),
        (huge, "PNG"),
        (png(255, ColorType::Rgb, BitDepth::Eight), "255 x 255"),
        (png(512, ColorType::Rgb, BitDepth::Eight), "512 x 512"),
        (png(256, ColorType::Rgb, BitDepth::Sixteen), "16 bits"),
        (png(256, ColorType::Indexed, BitDepth::Eight), "Indexed"),
        (png(256, ColorType::Grayscale, BitDepth::Eight), "Grayscale"),
    ] {
        for error in [
            terrarium::decode("tile 1/2/3", &bytes, terrarium::Encoding::Terrarium).unwrap_err(),
            water::decode("tile 1/2/3", &bytes).unwrap_err(),
        ] {
            let error = error.to_string();
            assert!(error.contains(part) && error.contains("tile 1/2/3") && error.contains("256 x 256"), "{error}");
        }
    }
    let mut texels = vec![[128, 128, 0]; 65_536];
    texels[77][2] = 4;
    let error = water::decode("tile", &water::encode(&texels).unwrap()).unwrap_err().to_string();
    assert!(error.contains("texel 77") && error.contains("class 4"), "{error}");
}

/// A JPEG of any size and colour, of one tone.
fn jpeg(width: u16, height: u16, color: jpeg_encoder::ColorType, progressive: bool) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = jpeg_encoder::Encoder::new(&mut bytes, 90);
    encoder.set_progressive(progressive);
    let channels = if matches!(color, jpeg_encoder::ColorType::Luma) { 1 } else { 3 };
    let texels = vec![77; usize::from(width) * usize::from(height) * channels];
    encoder.encode(&texels, width, height, color).unwrap();
    bytes
}

#[test]
fn imagery_that_is_no_tile_is_refused_with_the_reason() {
    use jpeg_encoder::ColorType::{Luma, Rgb};
    let good = jpeg(256, 256, Rgb, false);
    let grey = [77, 77, 77, 255];
    for whole in [good.clone(), jpeg(256, 256, Rgb, true), jpeg(256, 256, Luma, false)] {
        let texels = imagery::decode("tile", &whole).unwrap();
        assert!(texels.len() == 65_536 && texels.iter().all(|texel| *texel == grey), "{:?}", texels[0]);
    }
    assert_eq!(
        imagery::decode("tile", &png(256, png::ColorType::Rgb, png::BitDepth::Eight)).unwrap(),
        vec![[0, 0, 0, 255]; 65_536]
    );
    // A frame that promises 65,535 rows and columns: its marker, length, depth, then the size.
    let frame = good.windows(2).position(|two| two == [0xff, 0xc0]).unwrap();
    let mut huge = good.clone();
    huge[frame + 5..frame + 9].fill(0xff);
    for (bytes, part) in [
        (Vec::new(), "cannot be read as JPEG"),
        (b"<html>not found</html>".to_vec(), "cannot be read as JPEG"),
        (good[..good.len() / 2].to_vec(), "cannot be read as JPEG"),
        (good[..3].to_vec(), "cannot be read as JPEG"),
        (huge, "cannot be read as JPEG"),
        (jpeg(255, 256, Rgb, false), "255 x 256"),
        (jpeg(8, 8, Rgb, false), "8 x 8"),
        (jpeg(512, 256, Rgb, false), "cannot be read as JPEG"),
        (png(128, png::ColorType::Rgb, png::BitDepth::Eight), "128 x 128"),
    ] {
        let error = imagery::decode("tile 1/2/3", &bytes).map(|_| part).unwrap_err().to_string();
        assert!(error.contains(part) && error.contains("tile 1/2/3") && error.contains("256 x 256"), "{error}");
    }
}

#[test]
fn elevations_survive_both_encodings() {
    let metres: Vec<f32> = (0..65_536).map(|i| (i as f32 - 40_000.0) * 0.25).collect();
    let back = terrarium::decode("t", &terrarium::encode(&metres).unwrap(), terrarium::Encoding::Terrarium).unwrap();
    assert_eq!(back, metres);
    let texels: Vec<_> = (0..65_536).map(|i| [1, (i >> 8) as u8, i as u8]).collect();
    let mapbox = terrarium::decode("t", &water::encode(&texels).unwrap(), terrarium::Encoding::Mapbox).unwrap();
    // 65,536 / 10 - 10,000, then steps of 0.1 m.
    assert!((mapbox[0] + 3446.4).abs() < 1e-3 && (mapbox[1000] + 3346.4).abs() < 1e-3);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn tile_ids_round_trip(z in 0u8..=31, x: u32, y: u32) {
        let cut = |v: u32| (u64::from(v) & ((1u64 << z) - 1)) as u32;
        let id = id_from_zxy(z, cut(x), cut(y)).unwrap();
        prop_assert_eq!(zxy_from_id(id), Some((z, cut(x), cut(y))));
    }

    #[test]
    fn damaged_archives_never_panic(changes in prop::collection::vec((0usize..600, any::<u8>()), 1..6), keep in 0usize..4000) {
        let mut bytes = small_archive().to_vec();
        for (at, byte) in changes {
            let at = at % bytes.len();
            bytes[at] = byte;
        }
        bytes.truncate(keep.max(10));
        if let Ok(archive) = open(&bytes) {
            for (x, y) in [(0, 0), (3, 1), (7, 7)] {
                let _ = pollster::block_on(archive.tile(3, x, y));
            }
        }
    }

    #[test]
    fn damaged_imagery_never_panics(
        changes in prop::collection::vec((0usize..1200, any::<u8>()), 1..6),
        keep in 0usize..4000,
        progressive: bool,
    ) {
        let mut bytes = jpeg(256, 256, jpeg_encoder::ColorType::Rgb, progressive);
        for (at, byte) in changes {
            let at = at % bytes.len();
            bytes[at] = byte;
        }
        bytes.truncate(keep.max(10));
        if let Ok(texels) = imagery::decode("x", &bytes) {
            prop_assert_eq!(texels.len(), 65_536);
        }
    }

    #[test]
    fn arbitrary_directories_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        if let Ok(entries) = decode_directory("x", &bytes) {
            prop_assert!(entries.windows(2).all(|pair| pair[0].id < pair[1].id));
        }
    }

    #[test]
    fn damaged_netcdf_never_panics(changes in prop::collection::vec((0usize..200, any::<u8>()), 0..5), keep in 0usize..220, name in 0u32..1_000_000) {
        // One record dimension, one fixed one, one variable of short integers with a scale: 3 records of 4.
        let mut bytes = b"CDF\x01\0\0\0\x03\0\0\0\x0a\0\0\0\x02\0\0\0\x01t\0\0\0\0\0\0\0\0\0\0\x01x\0\0\0\0\0\0\x04".to_vec();
        bytes.extend([0; 8]);
        bytes.extend(b"\0\0\0\x0b\0\0\0\x01\0\0\0\x01v\0\0\0\0\0\0\x02\0\0\0\0\0\0\0\x01");
        bytes.extend(b"\0\0\0\x0c\0\0\0\x01\0\0\0\x0ascale_fact\0\0\0\0\0\x06\0\0\0\x01");
        bytes.extend(0.5f64.to_be_bytes());
        bytes.extend(b"\0\0\0\x03\0\0\0\x08");
        let begin = bytes.len() as u32 + 4;
        bytes.extend(begin.to_be_bytes());
        bytes.extend((0..12i16).flat_map(i16::to_be_bytes));
        let untouched = changes.is_empty() && keep >= bytes.len();
        for (at, byte) in changes {
            let at = at % bytes.len();
            bytes[at] = byte;
        }
        bytes.truncate(keep);
        let path = path(&format!("{name}.nc"));
        fs::write(&path, &bytes).unwrap();
        let opened = NetCdf::open(&path);
        fs::remove_file(&path).unwrap();
        prop_assert!(opened.is_ok() || !untouched);
        if let Ok(file) = opened {
            for variable in file.variables() {
                let start = vec![0; variable.dimensions.len()];
                let _ = file.read_row(variable, &start, 4);
                let _ = file.read_row(variable, &start, u64::MAX);
            }
        }
    }
}

#[test]
fn records_scale_and_missing_values_are_read() {
    // Two record variables, so that each record is padded; one has three bytes per record.
    let mut bytes =
        b"CDF\x02\0\0\0\x02\0\0\0\x0a\0\0\0\x02\0\0\0\x01t\0\0\0\0\0\0\0\0\0\0\x01x\0\0\0\0\0\0\x03".to_vec();
    bytes.extend([0; 8]);
    bytes.extend(b"\0\0\0\x0b\0\0\0\x02");
    let begins_at = |bytes: &mut Vec<u8>, begin: u64| bytes.extend(begin.to_be_bytes());
    bytes.extend(b"\0\0\0\x01b\0\0\0\0\0\0\x02\0\0\0\0\0\0\0\x01");
    bytes.extend([0; 8]);
    bytes.extend(b"\0\0\0\x01\0\0\0\x04");
    let end = 204;
    begins_at(&mut bytes, end);
    bytes.extend(b"\0\0\0\x01s\0\0\0\0\0\0\x02\0\0\0\0\0\0\0\x01\0\0\0\x0c\0\0\0\x02");
    bytes.extend(b"\0\0\0\x0aadd_offset\0\0\0\0\0\x05\0\0\0\x01");
    bytes.extend(100f32.to_be_bytes());
    bytes.extend(b"\0\0\0\x0a_FillValue\0\0\0\0\0\x03\0\0\0\x01\x80\0\0\0");
    bytes.extend(b"\0\0\0\x03\0\0\0\x08");
    begins_at(&mut bytes, end + 4);
    assert!(bytes.len() as u64 <= end, "the header takes {} bytes", bytes.len());
    bytes.resize(end as usize, 0);
    for record in 0..2u8 {
        bytes.extend([record, 0xff, 7, 0]);
        for value in [i16::from(record), -3, i16::MIN] {
            bytes.extend(value.to_be_bytes());
        }
        bytes.extend([0, 0]);
    }
    let path = path("records.nc");
    fs::write(&path, &bytes).unwrap();
    let file = NetCdf::open(&path).unwrap();
    fs::remove_file(&path).unwrap();
    let (b, s) = (file.variable("b").unwrap(), file.variable("s").unwrap());
    assert_eq!(b.dimensions.iter().map(|d| d.size).collect::<Vec<_>>(), [2, 3]);
    assert_eq!(file.read_row(b, &[1, 0], 3).unwrap(), [1.0, -1.0, 7.0]);
    let row = file.read_row(s, &[1, 0], 3).unwrap();
    assert_eq!(row[..2], [101.0, 97.0]);
    assert!(row[2].is_nan());
    assert_eq!(file.read_row(s, &[0, 1], 1).unwrap(), [97.0]);
    for (start, count) in [(vec![2, 0], 3), (vec![0, 1], 3), (vec![0], 1)] {
        assert!(file.read_row(s, &start, count).is_err(), "{start:?}");
    }
    assert!(file.variable("nothing").unwrap_err().to_string().contains("b, s"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Whatever becomes of a tile's bytes, there is an answer, and what is accepted can be drawn.
    #[test]
    fn damaged_coast_tiles_do_no_harm(at in 0usize..400, byte: u8, length in 0usize..400, x in 0u32..16) {
        let ring = |level, by: i32| Ring { level, points: (0..30).map(|i| [by + i * 97 % 3000, i * i * 13 % 4000]).collect() };
        let river = |stream, by: i32| River { stream, points: ring(Level::Land, by).points };
        let mut bytes = encode(4096, &[ring(Level::Land, 0), ring(Level::Lake, 500), ring(Level::Island, 900)], &[river(Stream::River, 0), river(Stream::Tributary, 700)]);
        let place = at % bytes.len();
        bytes[place] ^= byte;
        bytes.truncate(length.max(1));
        if let Ok(shores) = Shores::decode("tile", &bytes) {
            let id = TileId::new(Projection::Mercator, 9, 2 * x + 1, 200).unwrap();
            let own = coast::field::field(id, 8, &shores);
            prop_assert!(own.is_none_or(|own| own.steps.iter().flatten().all(|step| *step != 0 && step.abs() <= 254)));
        }
    }
}
