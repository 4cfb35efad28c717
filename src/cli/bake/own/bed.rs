//! A grid of elevations of any part of the world: GeoTIFF or netCDF.

use std::path::Path;

use super::geotiff;
use crate::cli::bake::{Axis, HIGHEST_M, axes};
use crate::data::netcdf::NetCdf;
use crate::error::{Error, Result};

/// The largest grid accepted, nodes: 1 GiB of metres, and as much again while gaps are filled.
pub const MAX_NODES: u64 = 1 << 28;
/// Beds end here, degrees: beyond lie the polar maps.
const NORTHERNMOST_DEG: f64 = 84.0;

/// Elevations in metres over the sea at nodes of latitude and longitude, rows from the north.
pub struct Bed {
    metres: Vec<f32>,
    width: usize,
    height: usize,
    /// Of the first node, degrees.
    north_deg: f64,
    west_deg: f64,
    /// Between rows and between columns, degrees, both positive.
    steps_deg: [f64; 2],
}

/// What a reader has found.
pub struct Grid {
    /// Rows from the north; NaN where the file says that there is no value.
    pub metres: Vec<f32>,
    /// Columns.
    pub width: usize,
    /// Latitude and longitude of the first node, degrees.
    pub corner_deg: [f64; 2],
    /// Between rows and between columns, degrees.
    pub steps_deg: [f64; 2],
}

impl Bed {
    /// Reads a grid in degrees of WGS84, in metres, north up, and fills what it calls missing from what lies around.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::BadData`] that says what is wrong, where, and what to do: another format, another reference system, a file that
    /// is cut short or too large, values that are no elevations.
    pub fn open(path: &Path) -> Result<Self> {
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        let grid = match extension.as_str() {
            "tif" | "tiff" | "gtiff" => geotiff::read(path)?,
            "nc" | "nc4" | "cdf" | "grd" => netcdf(path)?,
            _ => {
                let why = format!("has the ending `{extension}`, of no known format");
                let remedy = "give a GeoTIFF (.tif) or a netCDF (.nc); `gdal_translate IN OUT.tif` makes one of others";
                return Err(Error::bad_data(path.display().to_string(), why, remedy));
            }
        };
        Self::of(grid, &path.display().to_string())
    }

    fn of(grid: Grid, name: &str) -> Result<Self> {
        let bad = |why: String, remedy: &str| Err(Error::bad_data(name, why, remedy));
        let Grid { mut metres, width, corner_deg: [north_deg, west_deg], steps_deg } = grid;
        let height = metres.len() / width.max(1);
        if width < 2 || height < 2 {
            return bad(format!("has {width} x {height} nodes"), "give a grid of two rows and columns at least");
        }
        let far = |steps: usize, step: f64| (steps - 1) as f64 * step;
        let (south_deg, east_deg) = (north_deg - far(height, steps_deg[0]), west_deg + far(width, steps_deg[1]));
        let is_on_earth = [north_deg, south_deg, west_deg, east_deg].iter().all(|x| x.is_finite())
            && north_deg.abs().max(south_deg.abs()) <= 90.0 + steps_deg[0]
            && west_deg >= -360.0
            && east_deg - west_deg <= 360.0 + steps_deg[1]
            && east_deg <= 540.0;
        if !is_on_earth {
            let why = format!("reaches from {west_deg}, {south_deg} to {east_deg}, {north_deg}, which are no degrees");
            return bad(why, "bring it to degrees: `gdalwarp -t_srs EPSG:4326 IN OUT`");
        }
        if north_deg.abs().max(south_deg.abs()) > NORTHERNMOST_DEG {
            let why = format!("reaches from {south_deg} to {north_deg} degrees of latitude");
            return bad(why, "cut it at 84 degrees: `gdal_translate -projwin W 84 E S IN OUT`");
        }
        if let Some(at) = metres.iter().position(|m| m.abs() > HIGHEST_M) {
            let why = format!("has the elevation {} at row {}, column {}", metres[at], at / width, at % width);
            return bad(why, "give metres over the sea, and say which value means none (`gdal_translate -a_nodata`)");
        }
        if metres.iter().all(|m| m.is_nan()) {
            return bad("has no values".into(), "see whether it is the right file: `gdalinfo -stats`");
        }
        fill(&mut metres, width);
        Ok(Self { metres, width, height, north_deg, west_deg, steps_deg })
    }

    /// The wider of the distances between nodes, degrees.
    pub fn step_deg(&self) -> f64 {
        self.steps_deg[0].max(self.steps_deg[1])
    }

    /// Latitude of its middle, degrees.
    pub fn middle_lat_deg(&self) -> f64 {
        self.north_deg - 0.5 * (self.height - 1) as f64 * self.steps_deg[0]
    }

    /// Elevation in metres between the nodes, outside that of the nearest border, and how far outside the place is, degrees.
    pub fn at(&self, lat_deg: f64, lon_deg: f64) -> (f32, f64) {
        let [south_north, west_east] = self.steps_deg;
        let (last_row, last_column) = ((self.height - 1) as f64, (self.width - 1) as f64);
        // The turn of the longitude that lies nearest to the middle.
        let middle = self.west_deg + 0.5 * last_column * west_east;
        let lon_deg = middle + (lon_deg - middle + 180.0).rem_euclid(360.0) - 180.0;
        let (y, x) = ((self.north_deg - lat_deg) / south_north, (lon_deg - self.west_deg) / west_east);
        let (row, column) = (y.clamp(0.0, last_row), x.clamp(0.0, last_column));
        let outside = ((y - row) * south_north).hypot((x - column) * west_east);
        let (r, c) = ((row as usize).min(self.height - 2), (column as usize).min(self.width - 2));
        let (v, u) = ((row - r as f64) as f32, (column - c as f64) as f32);
        let node = |r: usize, c: usize| self.metres[r * self.width + c];
        let along = |r: usize| node(r, c) * (1.0 - u) + node(r, c + 1) * u;
        (along(r) * (1.0 - v) + along(r + 1) * v, outside)
    }

    /// Whether any of it lies within `reach` degrees of a box of latitudes and longitudes, degrees.
    pub fn is_near(&self, [south, north]: [f64; 2], [west, east]: [f64; 2], reach: f64) -> bool {
        let lowest = self.north_deg - (self.height - 1) as f64 * self.steps_deg[0];
        let easternmost = self.west_deg + (self.width - 1) as f64 * self.steps_deg[1];
        let meets = |turn: f64| west + turn <= easternmost + reach && east + turn >= self.west_deg - reach;
        south <= self.north_deg + reach && north >= lowest - reach && [-360.0, 0.0, 360.0].into_iter().any(meets)
    }
}

/// A netCDF file's first variable of latitude and longitude.
fn netcdf(path: &Path) -> Result<Grid> {
    let file = NetCdf::open(path)?;
    let name = file.name().to_owned();
    let bad = |why: String, remedy: &str| Error::bad_data(&name, why, remedy);
    let variable = file.variables().iter().find(|v| v.dimensions.len() == 2);
    let variable = variable.ok_or_else(|| {
        bad("has no variable of latitude and longitude".into(), "give a grid of two dimensions, as GEBCO's")
    })?;
    let (lat, lon) = axes(&file, variable)?;
    if lat.count.checked_mul(lon.count).is_none_or(|nodes| nodes > MAX_NODES) {
        return Err(bad(format!("has {} x {} nodes", lon.count, lat.count), "cut it or make it coarser"));
    }
    let (width, height) = (lon.count as usize, lat.count as usize);
    let mut metres = vec![0.0; width * height];
    for row in 0..height {
        let values = file.read_row(variable, &[row as u64, 0], lon.count)?;
        let to = if lat.step < 0.0 { row } else { height - 1 - row };
        metres[to * width..][..width].iter_mut().zip(values).for_each(|(node, value)| *node = value as f32);
    }
    let end = |axis: &Axis| axis.first + axis.step * (axis.count - 1) as f64;
    Ok(Grid { metres, width, corner_deg: [lat.first.max(end(&lat)), lon.first], steps_deg: [lat.step.abs(), lon.step] })
}

/// Gives nodes without a value the mean of those around, from as far as it takes: each is looked up in a grid half as fine, which is filled
/// likewise.
fn fill(metres: &mut [f32], width: usize) {
    if !metres.iter().any(|m| m.is_nan()) {
        return;
    }
    let height = metres.len() / width;
    let (w, h) = (width.div_ceil(2), height.div_ceil(2));
    let mut coarse = vec![f32::NAN; w * h];
    for (at, mean) in coarse.iter_mut().enumerate() {
        let (row, column) = (at / w * 2, at % w * 2);
        let around = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(j, i)| (row + j, column + i));
        let known = around.iter().filter(|(r, c)| *r < height && *c < width).map(|(r, c)| metres[r * width + c]);
        let (sum, count) = known.filter(|m| !m.is_nan()).fold((0.0, 0.0), |(sum, count), m| (sum + m, count + 1.0));
        *mean = if count > 0.0 { sum / count } else { f32::NAN };
    }
    // One node is the last: it has a value, as some node had.
    if coarse.len() < metres.len() {
        fill(&mut coarse, w);
    }
    let empty = metres.iter_mut().enumerate().filter(|(_, m)| m.is_nan());
    empty.for_each(|(at, m)| *m = coarse[at / width / 2 * w + at % width / 2]);
}
