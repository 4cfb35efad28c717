//! GeoTIFF, also of the Cloud-optimised kind (tiles, overviews, BigTIFF): the first image, in degrees of WGS84 or of a system within a metre
//! of it.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use tiff::TiffError;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;

use super::bed::{Grid, MAX_NODES};
use crate::cli::bake::reference;
use crate::error::{Error, Result};

/// Bytes that one piece of an image may unpack to: whatever it says, no more is asked for.
const LARGEST_PIECE: usize = 1 << 28;

/// Numbers of tags: GeoTIFF 1.1 (OGC 19-008r4), and GDAL's for the value that means none.
const PIXEL_SCALE: Tag = Tag::Unknown(33550);
const TIE_POINTS: Tag = Tag::Unknown(33922);
const TRANSFORMATION: Tag = Tag::Unknown(34264);
const GEO_KEYS: Tag = Tag::Unknown(34735);
const NO_DATA: Tag = Tag::Unknown(42113);

/// Keys: projected (1) or geographic (2), area (1) or point (2), and the system's number in EPSG's list.
const MODEL_TYPE: u64 = 1024;
const RASTER_TYPE: u64 = 1025;
const GEODETIC_CRS: u64 = 2048;
const PROJECTED_CRS: u64 = 3072;

type Open = Decoder<BufReader<File>>;

/// Reads a file.
///
/// # Errors
/// As for [`super::bed::Bed::open`].
pub fn read(path: &Path) -> Result<Grid> {
    let name = path.display().to_string();
    let file = File::open(path).map_err(|e| Error::io(&name, e, "check the path and its permissions"))?;
    let mut limits = Limits::default();
    limits.decoding_buffer_size = LARGEST_PIECE;
    limits.intermediate_buffer_size = LARGEST_PIECE;
    let mut decoder = Decoder::new(BufReader::new(file)).map_err(|e| refused(&name, &e))?.with_limits(limits);
    let (width, height) = decoder.dimensions().map_err(|e| refused(&name, &e))?;
    if u64::from(width) * u64::from(height) > MAX_NODES {
        let why = format!("has {width} x {height} pixels");
        return Err(Error::bad_data(&name, why, "cut it or make it coarser: `gdal_translate -outsize 25% 25% IN OUT`"));
    }
    let (corner_deg, steps_deg) = place(&mut decoder, &name)?;
    let no_data = text(&mut decoder, NO_DATA);
    let no_data = no_data.and_then(|text| text.trim_matches(['\0', ' ']).parse::<f64>().ok());
    let mut metres = pixels(&mut decoder, &name, [width as usize, height as usize])?;
    for (at, value) in metres.iter_mut().enumerate() {
        if no_data
            .is_some_and(|none| f64::from(*value) == none || none.is_nan() && value.is_nan() || *value == none as f32)
        {
            *value = f32::NAN;
        } else if !value.is_finite() {
            let (row, column) = (at / width as usize, at % width as usize);
            let remedy =
                "say which value means none: `gdal_translate -a_nodata nan IN OUT`, or fill it: `gdal_fillnodata.py`";
            return Err(Error::bad_data(
                &name,
                format!("has the elevation {value} at row {row}, column {column}"),
                remedy,
            ));
        }
    }
    Ok(Grid { metres, width: width as usize, corner_deg, steps_deg })
}

/// Latitude and longitude of the first pixel's middle, and the steps from row to row and column to column, degrees.
fn place(decoder: &mut Open, name: &str) -> Result<([f64; 2], [f64; 2])> {
    let bad = |why: String, remedy: &str| Error::bad_data(name, why, remedy);
    let to_degrees = "bring it to degrees of WGS84: `gdalwarp -t_srs EPSG:4326 IN OUT`";
    let keys = decoder.find_tag_unsigned_vec::<u64>(GEO_KEYS).ok().flatten().unwrap_or_default();
    // Four numbers a key, the first four being the directory's own: key, where its value stands (0: here), count, value.
    let key = |wanted| keys.chunks_exact(4).skip(1).find(|key| key[0] == wanted && key[1] == 0).map(|key| key[3]);
    if let (Some(1), crs) | (_, crs @ Some(_)) = (key(MODEL_TYPE), key(PROJECTED_CRS)) {
        let system = crs.map_or_else(|| "a projection".to_owned(), |crs| format!("EPSG:{crs}"));
        return Err(bad(format!("is in the coordinates of {system}"), to_degrees));
    }
    match key(GEODETIC_CRS) {
        Some(crs) if reference::is_known(crs) => {}
        Some(crs) => return Err(bad(format!("is in degrees of EPSG:{crs}"), to_degrees)),
        None if keys.is_empty() => {
            let remedy = "say where it lies: `gdal_translate -a_srs EPSG:4326 -a_ullr W N E S IN OUT`";
            return Err(bad("is a TIFF without GeoTIFF's keys".into(), remedy));
        }
        None => return Err(bad("names no reference system by its EPSG number".into(), to_degrees)),
    }
    let numbers = |decoder: &mut Open, tag| {
        decoder.find_tag(tag).ok().flatten().and_then(|value| value.into_f64_vec().ok()).unwrap_or_default()
    };
    let (scale, tie, matrix) =
        (numbers(decoder, PIXEL_SCALE), numbers(decoder, TIE_POINTS), numbers(decoder, TRANSFORMATION));
    let (lon, lat, across, down) = match (&scale[..], &tie[..], &matrix[..]) {
        ([x, y, ..], [column, row, _, lon, lat, ..], _) => (lon - column * x, lat + row * y, *x, *y),
        (_, _, [x, 0.0, _, lon, 0.0, y, _, lat, ..]) => (*lon, *lat, *x, -*y),
        (_, _, [_, ..]) => {
            return Err(bad("is turned or sheared".into(), "straighten it: `gdalwarp -t_srs EPSG:4326 IN OUT`"));
        }
        _ => return Err(bad("does not say where it lies".into(), "add it: `gdal_translate -a_ullr W N E S IN OUT`")),
    };
    if !(across > 0.0 && down > 0.0 && across.is_finite() && down.is_finite() && lon.is_finite() && lat.is_finite()) {
        let why = format!("has pixels of {across} x {down} degrees at {lat}, {lon}");
        return Err(bad(why, "turn it north up: `gdalwarp -t_srs EPSG:4326 IN OUT`"));
    }
    // The tie is the corner of a pixel that is an area, the middle of one that is a point.
    let half = if key(RASTER_TYPE) == Some(2) { 0.0 } else { 0.5 };
    Ok(([lat - half * down, lon + half * across], [down, across]))
}

/// All pixels' first band, rows from the top.
fn pixels(decoder: &mut Open, name: &str, [width, height]: [usize; 2]) -> Result<Vec<f32>> {
    let samples = usize::from(decoder.find_tag_unsigned::<u16>(Tag::SamplesPerPixel).ok().flatten().unwrap_or(1));
    if samples != 1 {
        let remedy = "take the one of elevations: `gdal_translate -b 1 IN OUT`";
        return Err(Error::bad_data(name, format!("has {samples} bands"), remedy));
    }
    let (across, down) = decoder.chunk_dimensions();
    let (across, down) = (across.max(1) as usize, down.max(1) as usize);
    let mut all = vec![0.0f32; width * height];
    for piece in 0..width.div_ceil(across) * height.div_ceil(down) {
        let (column, row) = (piece % width.div_ceil(across) * across, piece / width.div_ceil(across) * down);
        let (wide, high) = decoder.chunk_data_dimensions(piece as u32);
        let values = decoder.read_chunk(piece as u32).map_err(|why| match refused(name, &why) {
            Error::BadData { what, why, remedy } => {
                Error::BadData { what, why: format!("{why}, in the piece at row {row}, column {column}"), remedy }
            }
            other => other,
        })?;
        let values = metres(values).ok_or_else(|| {
            let remedy = "make them numbers: `gdal_translate -ot Float32 IN OUT`";
            Error::bad_data(name, "has values that are no plain numbers", remedy)
        })?;
        // Values of less than a byte come packed.
        if values.len() as u64 != u64::from(wide) * u64::from(high) {
            let why = format!(
                "has {} values for {wide} x {high} pixels in the piece at row {row}, column {column}",
                values.len()
            );
            let remedy = "write it anew, with a byte or more for each: `gdal_translate -ot Float32 IN OUT`";
            return Err(Error::bad_data(name, why, remedy));
        }
        for (line, row) in values.chunks_exact(wide.max(1) as usize).zip(row..height) {
            let end = width.min(column + line.len());
            all[row * width + column..row * width + end].copy_from_slice(&line[..end - column]);
        }
    }
    Ok(all)
}

fn metres(values: DecodingResult) -> Option<Vec<f32>> {
    use DecodingResult::{F32, F64, I8, I16, I32, I64, U8, U16, U32};
    Some(match values {
        F32(values) => values,
        F64(values) => values.into_iter().map(|x| x as f32).collect(),
        I8(values) => values.into_iter().map(f32::from).collect(),
        I16(values) => values.into_iter().map(f32::from).collect(),
        U8(values) => values.into_iter().map(f32::from).collect(),
        U16(values) => values.into_iter().map(f32::from).collect(),
        I32(values) => values.into_iter().map(|x| x as f32).collect(),
        U32(values) => values.into_iter().map(|x| x as f32).collect(),
        I64(values) => values.into_iter().map(|x| x as f32).collect(),
        _ => return None,
    })
}

fn text(decoder: &mut Open, tag: Tag) -> Option<String> {
    decoder.find_tag(tag).ok().flatten().and_then(|value| value.into_string().ok())
}

/// What the decoder says, with a remedy.
fn refused(name: &str, why: &TiffError) -> Error {
    match why {
        TiffError::FormatError(why) => {
            Error::bad_data(name, format!("is no TIFF that can be read: {why}"), "get it again")
        }
        TiffError::UnsupportedError(why) => {
            let remedy = "write it anew: `gdal_translate -ot Float32 -co COMPRESS=DEFLATE -co TILED=YES IN OUT`";
            Error::bad_data(name, format!("is a kind of TIFF that is not read here: {why}"), remedy)
        }
        TiffError::IoError(_) => Error::bad_data(name, "ends before its pixels do", "it is cut short: get it again"),
        TiffError::LimitsExceeded => {
            let remedy = "write it in small tiles: `gdal_translate -co TILED=YES -co COMPRESS=DEFLATE IN OUT`";
            Error::bad_data(name, "has a piece of more than 256 MB", remedy)
        }
        other => Error::bad_data(name, other.to_string(), "it is damaged: get it again"),
    }
}
