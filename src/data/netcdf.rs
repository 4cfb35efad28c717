//! netCDF files (CDF-1, CDF-2, CDF-5, and netCDF-4, which is HDF5), read row by row so that a raster of any size takes little memory: the crate `netcdf-reader`
//! with this project's errors, which name the file and the remedy.

use crate::error::{Error, Result};
use netcdf_reader::{NcFile, NcReadable, NcSliceInfo, NcSliceInfoElem, NcVariable};
use std::path::Path;

/// The largest row read at once, values.
const LONGEST_ROW: u64 = 1 << 27;

/// An open netCDF file. It must not change while it is open.
pub struct NetCdf {
    name: String,
    file: NcFile,
}

impl NetCdf {
    /// Opens a file and reads its header.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::BadData`] where it is no netCDF file, or broken, or of a kind of HDF5 that is not read (convert it with `nccopy
    /// -k classic`).
    pub fn open(path: &Path) -> Result<Self> {
        let name = path.display().to_string();
        let file = NcFile::open(path).map_err(|why| {
            use netcdf_reader::Error::{InvalidMagic, Io, Nc4NotEnabled, UnexpectedEof, UnsupportedVersion};
            let why = match why {
                Io(why) => return Error::io(&name, why, "check the path and its permissions"),
                InvalidMagic | UnsupportedVersion(_) | Nc4NotEnabled => "is no netCDF file".to_owned(),
                UnexpectedEof { .. } => "ends within its header".to_owned(),
                why => why.to_string(),
            };
            Error::bad_data(&name, why, "give a netCDF file; `nccopy -k classic` writes another as netCDF-3")
        })?;
        Ok(Self { name, file })
    }

    /// The file, for messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The variables.
    pub fn variables(&self) -> &[NcVariable] {
        self.file.variables().unwrap_or_default()
    }

    /// A variable by its name.
    ///
    /// # Errors
    /// [`Error::BadData`] naming the variables that there are.
    pub fn variable(&self, name: &str) -> Result<&NcVariable> {
        self.variables().iter().find(|v| v.name == name).ok_or_else(|| {
            let known: Vec<_> = self.variables().iter().map(|v| v.name.as_str()).collect();
            Error::bad_data(&self.name, format!("has no variable `{name}`"), format!("it has {}", known.join(", ")))
        })
    }

    /// `count` values of a variable along its last dimension, from the position `start` (one index per dimension). Missing values
    /// are NaN; scale and offset are applied.
    ///
    /// # Errors
    /// [`Error::BadData`] outside the variable, or where the file ends before.
    pub fn read_row(&self, variable: &NcVariable, start: &[u64], count: u64) -> Result<Vec<f64>> {
        let row = self.row(variable, start, count)?;
        let values = self.file.read_variable_slice_unpacked_masked(&variable.name, &row);
        self.whole(variable, count, values.map(|values| values.into_iter().collect()))
    }

    /// As [`NetCdf::read_row`], the numbers as they are stored.
    ///
    /// # Errors
    /// As for [`NetCdf::read_row`], and where they are of another type.
    pub fn read_stored_row<T: NcReadable>(&self, variable: &NcVariable, start: &[u64], count: u64) -> Result<Vec<T>> {
        let row = self.row(variable, start, count)?;
        let values = self.file.read_variable_slice::<T>(&variable.name, &row);
        self.whole(variable, count, values.map(|values| values.into_iter().collect()))
    }

    /// A row that has as many values as were asked for.
    fn whole<T>(
        &self,
        variable: &NcVariable,
        count: u64,
        values: std::result::Result<Vec<T>, netcdf_reader::Error>,
    ) -> Result<Vec<T>> {
        let values = values.map_err(|why| self.damaged(variable, why))?;
        if values.len() as u64 != count {
            let why = format!("has {} values of `{}` where there should be {count}", values.len(), variable.name);
            return Err(Error::bad_data(&self.name, why, "it is cut short or damaged: get it again"));
        }
        Ok(values)
    }

    fn damaged(&self, variable: &NcVariable, why: netcdf_reader::Error) -> Error {
        let why = match why {
            netcdf_reader::Error::UnexpectedEof { .. } => format!("ends before the values of `{}`", variable.name),
            why => format!("has unreadable values of `{}`: {why}", variable.name),
        };
        Error::bad_data(&self.name, why, "it is cut short or damaged: get it again")
    }

    /// The part of a variable that a row is, where it has such a row.
    fn row(&self, variable: &NcVariable, start: &[u64], count: u64) -> Result<NcSliceInfo> {
        let sizes: Vec<u64> = variable.dimensions.iter().map(|d| d.size).collect();
        let holds = || {
            let (last, others) = start.split_last()?;
            let end = last.checked_add(count).filter(|end| Some(end) <= sizes.last() && count <= LONGEST_ROW)?;
            let outside = start.len() != sizes.len() || others.iter().zip(&sizes).any(|(at, size)| at >= size);
            let row = NcSliceInfoElem::Slice { start: *last, end, step: 1 };
            let selections = others.iter().map(|at| NcSliceInfoElem::Index(*at)).chain([row]).collect();
            (!outside).then_some(NcSliceInfo { selections })
        };
        holds().ok_or_else(|| {
            let why = format!("has no values {start:?} + {count} in `{}`", variable.name);
            Error::bad_data(&self.name, why, "the file is damaged or not the one that was meant")
        })
    }
}
