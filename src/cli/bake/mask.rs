//! The land mask: bands of bytes in netCDF (3 or 4) as `gmt grdlandmask -N0/1/2/3/4` writes them, seen as one raster of the world.
//!
//! Only a window of full rows is ever in memory, plus one copy of the world reduced by [`REDUCTION`] per axis.

use crate::data::netcdf::NetCdf;
use crate::data::water::WaterClass;
use crate::error::{Error, Result};
use netcdf_reader::{NcType, NcVariable};
use std::path::Path;

/// Cells along each axis that make one cell of the reduced world.
pub const REDUCTION: usize = 4;
/// In a cell of the reduced world: its cells are not all of one class.
pub const MIXED: u8 = 0x80;

struct Band {
    file: NetCdf,
    variable: NcVariable,
}

/// The mask as one raster: rows from south to north, columns from `west_deg` eastwards.
pub struct Mask {
    bands: Vec<Band>,
    /// For each row of the world, its band and its row in it.
    rows: Vec<(usize, u64)>,
    /// Columns once around.
    pub width: usize,
    /// Longitude of the first column's centre, degrees.
    west_deg: f64,
    /// Latitude of the first row's centre, degrees.
    south_deg: f64,
    /// Cell size, degrees.
    pub step_deg: f64,
}

impl Mask {
    /// Opens the bands, which together must cover the world once, at one cell size.
    pub fn open(paths: &[impl AsRef<Path>]) -> Result<Self> {
        let mut mask =
            Self { bands: Vec::new(), rows: Vec::new(), width: 0, west_deg: 0.0, south_deg: 0.0, step_deg: 0.0 };
        let mut filled: Vec<Option<(usize, u64)>> = Vec::new();
        for path in paths {
            let file = NetCdf::open(path.as_ref())?;
            let name = file.name().to_owned();
            let bad = |why: String| Error::bad_data(&name, why, "make the bands with scripts/make-world.sh");
            let variable = (file.variables().iter().find(|v| v.dimensions.len() == 2).cloned())
                .ok_or_else(|| bad("has no variable of latitude and longitude".into()))?;
            if variable.dtype != NcType::Byte {
                return Err(bad(format!("stores `{}` as {:?}, not as bytes", variable.name, variable.dtype)));
            }
            let (lat_deg, lon_deg) = super::axes(&file, &variable)?;
            let step_deg = lon_deg.step;
            let around = (360.0 / step_deg).round();
            if (around * step_deg - 360.0).abs() > 1e-3 * step_deg * around.sqrt() || lon_deg.count < around as u64 {
                return Err(bad(format!(
                    "does not go around the world: {} columns of {step_deg} degrees",
                    lon_deg.count
                )));
            }
            if (lat_deg.step - step_deg).abs() > 1e-6 * step_deg {
                return Err(bad(format!(
                    "has cells of {step_deg} by {} degrees; rows go south to north",
                    lat_deg.step
                )));
            }
            if mask.bands.is_empty() {
                // Cell centres lie half a cell from the pole, or (gridline registration) on it.
                let from_pole = (lat_deg.first + 90.0) / step_deg;
                mask.south_deg = -90.0 + (from_pole - (from_pole + 0.25).floor()) * step_deg;
                (mask.width, mask.west_deg, mask.step_deg) = (around as usize, lon_deg.first, step_deg);
                let rows = ((90.0 - mask.south_deg) / step_deg + 1e-6).floor() as usize + 1;
                filled = vec![None; rows.min(1 << 20)];
            }
            let first = (lat_deg.first - mask.south_deg) / step_deg;
            if (mask.width, mask.west_deg) != (around as usize, lon_deg.first) || (first - first.round()).abs() > 0.01 {
                return Err(bad("lies on another grid than the first band".into()));
            }
            for row in 0..lat_deg.count {
                if let Some(slot) = filled.get_mut(first.round() as usize + row as usize) {
                    *slot = Some((mask.bands.len(), row));
                }
            }
            mask.bands.push(Band { file, variable });
        }
        if let Some(gap) = filled.iter().position(Option::is_none) {
            let why = format!("miss latitude {:.3} degrees", mask.south_deg + gap as f64 * mask.step_deg);
            return Err(Error::bad_data("the land mask bands", why, "give all bands from pole to pole"));
        }
        mask.rows = filled.into_iter().flatten().collect();
        if mask.rows.len() < 2 * REDUCTION || mask.width < 2 * REDUCTION {
            return Err(Error::bad_data("the land mask", "is too small or missing", "give its bands with --mask"));
        }
        Ok(mask)
    }

    /// Rows from pole to pole.
    pub fn height(&self) -> usize {
        self.rows.len()
    }

    /// The classes ([`WaterClass`] as bytes) of the rows that cover latitudes `south_deg` to `north_deg`.
    pub fn window(&mut self, south_deg: f64, north_deg: f64) -> Result<Raster> {
        let row_of = |lat_deg: f64| ((lat_deg - self.south_deg) / self.step_deg).round();
        let last = self.height() as f64 - 1.0;
        let (first, end) =
            (row_of(south_deg).clamp(0.0, last) as usize, row_of(north_deg).clamp(0.0, last) as usize + 1);
        self.rows(first, end)
    }

    fn rows(&mut self, first: usize, end: usize) -> Result<Raster> {
        let mut cells = Vec::with_capacity((end - first) * self.width);
        for (band, row) in &self.rows[first..end] {
            let Band { file, variable } = &self.bands[*band];
            let bytes = file.read_stored_row::<i8>(variable, &[*row, 0], self.width as u64)?;
            for byte in bytes {
                cells.push(match byte {
                    0 => WaterClass::Ocean as u8,
                    1 => WaterClass::Land as u8,
                    2 | 4 => WaterClass::Lake as u8,
                    3 => WaterClass::Island as u8,
                    other => {
                        let why = format!("has the mask value {other}");
                        return Err(Error::bad_data(file.name(), why, "use `gmt grdlandmask -N0/1/2/3/4`"));
                    }
                });
            }
        }
        let south_deg = self.south_deg + first as f64 * self.step_deg;
        Ok(Raster { cells, width: self.width, west_deg: self.west_deg, south_deg, step_deg: self.step_deg })
    }

    /// The whole world, reduced: the class that most cells have, and [`MIXED`] where they differ.
    pub fn reduced(&mut self, mut progress: impl FnMut(usize)) -> Result<Raster> {
        let width = self.width.div_ceil(REDUCTION);
        let mut cells = Vec::with_capacity(width * self.height().div_ceil(REDUCTION));
        for first in (0..self.height()).step_by(REDUCTION) {
            let strip = self.rows(first, (first + REDUCTION).min(self.height()))?;
            for column in (0..self.width).step_by(REDUCTION) {
                let mut counts = [0u8; 4];
                for row in strip.cells.chunks_exact(self.width) {
                    row[column..self.width.min(column + REDUCTION)].iter().for_each(|c| counts[usize::from(*c)] += 1);
                }
                let most = (0..4).max_by_key(|class| counts[*class]).unwrap_or(0);
                let mixed = counts.iter().filter(|n| **n > 0).count() > 1;
                cells.push(most as u8 | if mixed { MIXED } else { 0 });
            }
            progress(first);
        }
        let step_deg = self.step_deg * REDUCTION as f64;
        let middle = (REDUCTION - 1) as f64 / 2.0 * self.step_deg;
        Ok(Raster { cells, width, west_deg: self.west_deg + middle, south_deg: self.south_deg + middle, step_deg })
    }
}

/// Classes on a grid of latitude and longitude, rows from south to north; columns go around the world.
pub struct Raster {
    /// One byte per cell, row by row.
    pub cells: Vec<u8>,
    /// Columns.
    pub width: usize,
    west_deg: f64,
    south_deg: f64,
    step_deg: f64,
}

impl Raster {
    /// A world of nothing but ocean, in cells of a degree.
    pub fn of_ocean() -> Self {
        let cells = vec![WaterClass::Ocean as u8; 360 * 180];
        Self { cells, width: 360, west_deg: -179.5, south_deg: -89.5, step_deg: 1.0 }
    }

    /// The column nearest to a longitude (degrees).
    pub fn column(&self, lon_deg: f64) -> usize {
        let columns = ((lon_deg - self.west_deg) / self.step_deg).round() as i64;
        columns.rem_euclid((360.0 / self.step_deg).round() as i64).min(self.width as i64 - 1) as usize
    }

    /// The row nearest to a latitude (degrees), clamped to those that are there.
    pub fn row(&self, lat_deg: f64) -> usize {
        let row = ((lat_deg - self.south_deg) / self.step_deg).round().max(0.0) as usize;
        row.min(self.cells.len() / self.width - 1)
    }

    /// (latitude, longitude) of a cell's centre, degrees.
    pub fn centre_deg(&self, row: usize, column: usize) -> (f64, f64) {
        (self.south_deg + row as f64 * self.step_deg, self.west_deg + column as f64 * self.step_deg)
    }

    /// Cell size, degrees.
    pub fn step_deg(&self) -> f64 {
        self.step_deg
    }

    /// The class at a place (degrees), without [`MIXED`].
    pub fn class(&self, lat_deg: f64, lon_deg: f64) -> u8 {
        self.cells[self.row(lat_deg) * self.width + self.column(lon_deg)] & !MIXED
    }
}
