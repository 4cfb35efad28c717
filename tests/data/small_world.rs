//! A world of one continent with a lake, an island in it and a basin below the sea, as netCDF-3 files, and its bake.

use ocean_globe::cli::bake::{BakeArgs, bake};
use ocean_globe::error::Result;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A folder of its own that goes away with its test.
pub struct Folder(PathBuf);

impl Folder {
    pub fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("ocean-globe-bake-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The class of a place, as GMT numbers it.
pub fn class(lat_deg: f64, lon_deg: f64) -> u8 {
    let within = |south: f64, north: f64, west: f64, east: f64| {
        (south..north).contains(&lat_deg) && (west..east).contains(&lon_deg)
    };
    if within(30.0, 31.0, 30.0, 31.0) {
        3
    } else if within(25.0, 36.0, 25.0, 36.0) {
        2
    } else {
        u8::from(within(-50.0, 60.0, 0.0, 60.0) || lat_deg < -70.0)
    }
}

/// Elevation of a place: the basin lies 100 m below the sea, and so does the first column of land.
fn metres(lat_deg: f64, lon_deg: f64) -> f32 {
    let basin = lat_deg.abs() < 6.0 && (lon_deg - 30.0).abs() < 6.0;
    match class(lat_deg, lon_deg) {
        0 => -3000.0,
        _ if basin || lon_deg == 0.0 && lat_deg > -60.0 => -100.0,
        _ => 500.0,
    }
}

/// A netCDF-3 file of one variable over latitude and longitude.
fn netcdf(lat: &[f64], lon: &[f64], kind: u32, attributes: &[u8], values: &[u8]) -> Vec<u8> {
    let word = |value: usize| (value as u32).to_be_bytes();
    let name = |text: &str| {
        let mut bytes = word(text.len()).to_vec();
        bytes.extend(text.bytes());
        bytes.resize(4 + text.len().next_multiple_of(4), 0);
        bytes
    };
    let build = |begins: [usize; 3]| {
        let mut file = b"CDF\x01\0\0\0\0".to_vec();
        file.extend([word(10), word(2)].concat());
        file.extend([name("lat"), word(lat.len()).to_vec(), name("lon"), word(lon.len()).to_vec()].concat());
        file.extend([0; 8]);
        file.extend([word(11), word(3)].concat());
        for (i, (text, dimensions)) in [("lat", vec![0]), ("lon", vec![1]), ("z", vec![0, 1])].into_iter().enumerate() {
            file.extend([name(text), word(dimensions.len()).to_vec()].concat());
            dimensions.iter().for_each(|d| file.extend(word(*d)));
            if i == 2 {
                file.extend(attributes)
            } else {
                file.extend([0; 8])
            }
            let kind = if i == 2 { kind } else { 6 };
            file.extend([word(kind as usize), word(0), word(begins[i])].concat());
        }
        file
    };
    let header = build([0; 3]).len();
    let mut file = build([header, header + 8 * lat.len(), header + 8 * (lat.len() + lon.len())]);
    lat.iter().chain(lon).for_each(|degrees| file.extend(degrees.to_be_bytes()));
    file.extend(values);
    file
}

/// Rows of the mask: cells of one degree, their centres at half degrees.
pub fn mask_rows(rows: Range<usize>) -> Vec<u8> {
    let lat: Vec<_> = rows.map(|row| row as f64 - 89.5).collect();
    let lon: Vec<_> = (0..360).map(|column| f64::from(column) - 179.5).collect();
    let values: Vec<u8> = lat.iter().flat_map(|lat| lon.iter().map(|lon| class(*lat, *lon))).collect();
    netcdf(&lat, &lon, 1, &[0; 8], &values)
}

/// Writes the mask and the elevation (short integers of 0.1 m, from longitude 0 as in ETOPO5, north first).
pub fn inputs(folder: &Path) -> [PathBuf; 2] {
    let lat: Vec<_> = (0..=90).map(|row| 90.0 - 2.0 * f64::from(row)).collect();
    let lon: Vec<_> = (0..180).map(|column| 2.0 * f64::from(column)).collect();
    let east_west = |lon: f64| if lon >= 180.0 { lon - 360.0 } else { lon };
    let values: Vec<u8> = (lat.iter().flat_map(|lat| lon.iter().map(|lon| metres(*lat, east_west(*lon)))))
        .flat_map(|metres| ((metres / 0.1).round() as i16).to_be_bytes())
        .collect();
    let mut attributes = [12u32, 1, 12].map(u32::to_be_bytes).concat();
    attributes.extend(b"scale_factor");
    attributes.extend([6u32, 1].map(u32::to_be_bytes).concat());
    attributes.extend(0.1f64.to_be_bytes());
    let paths = ["mask.nc", "elevation.nc"].map(|name| folder.join(name));
    fs::write(&paths[0], mask_rows(0..180)).unwrap();
    fs::write(&paths[1], netcdf(&lat, &lon, 3, &attributes, &values)).unwrap();
    paths
}

/// Bakes a mask and an elevation into a folder.
pub fn run(mask: &Path, elevation: &Path, output: &Path) -> Result<()> {
    bake(&BakeArgs { elevation: Some(elevation.into()), masks: vec![mask.into()], ..nothing(output) })
}

/// What makes imagery alone, of a picture, in a folder that holds a world.
pub fn imagery(picture: &Path, output: &Path) -> BakeArgs {
    BakeArgs { imagery: Some(picture.into()), ..nothing(output) }
}

/// What makes the coast anew, of polygons and ponds in a folder that holds a world.
pub fn coast(folder: &Path) -> BakeArgs {
    let [coast, ponds] = ["gshhs_f.dat", "ponds.txt"].map(|name| Some(folder.join(name)));
    BakeArgs { coast, ponds, ..nothing(folder) }
}

/// What bakes nothing yet, on coarse levels.
pub fn nothing(output: &Path) -> BakeArgs {
    BakeArgs {
        bed: None,
        bed_elsewhere_m: -4000.0,
        bed_zoom: None,
        elevation: None,
        elevation_east_deg: 0.0,
        tints: None,
        masks: Vec::new(),
        imagery: None,
        coast: None,
        ponds: None,
        rivers: None,
        coast_zoom: 4,
        coast_tolerance_m: 50.0,
        coast_credit: "somebody's coasts".into(),
        output: output.into(),
        water_zoom: 4,
        terrain_zoom: 2,
        terrain_full_zoom: 1,
        terrain_worth_m: 1e6,
        polar_zoom: 0,
        sparse_zoom: 4,
        worth_km2: vec![1.0],
        elevation_credit: "somebody's heights".into(),
        mask_credit: "somebody's coasts".into(),
        imagery_zoom: 3,
        imagery_full_zoom: 3,
        imagery_worth: 0.0,
        imagery_quality: 90,
        imagery_credit: "somebody's colours".into(),
    }
}

/// The small world, baked into a folder of its own.
pub fn baked(name: &str) -> Folder {
    let folder = Folder::new(name);
    let [mask, elevation] = inputs(folder.path());
    run(&mask, &elevation, folder.path()).unwrap();
    folder
}
