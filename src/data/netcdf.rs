//! netCDF-3 files (CDF-1 and CDF-2, "classic"), read row by row so that a raster of any size takes little memory.
//!
//! Format: <https://docs.unidata.ucar.edu/netcdf-c/current/file_format_specifications.html>. Numbers are big-endian.
//! `scale_factor`, `add_offset`, `_FillValue` and `missing_value` are applied.

mod header;

use crate::error::{Error, Result};
pub use header::{Attribute, Dimension, Type, Variable};
use std::fs::File;
use std::io::{BufReader, Read as _, Seek as _, SeekFrom};
use std::path::Path;

/// The largest piece read at once, bytes.
const MAX_READ: u64 = 1 << 30;

/// An open netCDF-3 file.
#[derive(Debug)]
pub struct NetCdf {
    name: String,
    file: BufReader<File>,
    length: u64,
    header: header::Header,
}

impl NetCdf {
    /// Opens a file and reads its header.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::BadData`] where it is no netCDF-3 file, or broken (netCDF-4 files are HDF5: convert them
    /// with `nccopy -k classic`).
    pub fn open(path: &Path) -> Result<Self> {
        let name = path.display().to_string();
        let failed = |e| Error::io(&name, e, "check the path and its permissions");
        let file = File::open(path).map_err(failed)?;
        let length = file.metadata().map_err(failed)?.len();
        let mut file = BufReader::with_capacity(1 << 16, file);
        let header = header::read(&name, &mut file, length)?;
        Ok(Self { name, file, length, header })
    }

    /// The file, for messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The dimensions; the record dimension with its current length.
    pub fn dimensions(&self) -> &[Dimension] {
        &self.header.dimensions
    }

    /// The variables.
    pub fn variables(&self) -> &[Variable] {
        &self.header.variables
    }

    /// The global attributes.
    pub fn attributes(&self) -> &[Attribute] {
        &self.header.attributes
    }

    /// A variable by its name.
    ///
    /// # Errors
    /// [`Error::BadData`] naming the variables that there are.
    pub fn variable(&self, name: &str) -> Result<&Variable> {
        self.variables().iter().find(|v| v.name == name).ok_or_else(|| {
            let known: Vec<_> = self.variables().iter().map(|v| v.name.as_str()).collect();
            Error::bad_data(&self.name, format!("has no variable `{name}`"), format!("it has {}", known.join(", ")))
        })
    }

    /// The lengths of a variable's dimensions.
    pub fn shape(&self, variable: &Variable) -> Vec<u64> {
        variable.dimensions.iter().map(|d| self.header.dimensions[*d].length).collect()
    }

    /// `count` values of a variable along its last dimension, from the position `start` (one index per dimension).
    /// Missing values are NaN; scale and offset are applied.
    ///
    /// # Errors
    /// [`Error::BadData`] outside the variable, or where the file ends before; [`Error::Io`].
    pub fn read_row(&mut self, variable: &Variable, start: &[u64], count: u64) -> Result<Vec<f64>> {
        let bytes = self.read_row_bytes(variable, start, count)?;
        let unpack = Unpacking::of(variable);
        let values = bytes.chunks_exact(variable.kind.size() as usize).map(|b| unpack.value(variable.kind.number(b)));
        Ok(values.collect())
    }

    /// As [`NetCdf::read_row`], the bytes as they are stored.
    ///
    /// # Errors
    /// As for [`NetCdf::read_row`].
    pub fn read_row_bytes(&mut self, variable: &Variable, start: &[u64], count: u64) -> Result<Vec<u8>> {
        let outside = || {
            let why = format!("has no values {start:?} + {count} in `{}`", variable.name);
            Error::bad_data(&self.name, why, "the file is damaged or not the one that was meant")
        };
        let shape = self.shape(variable);
        let bytes = count.checked_mul(variable.kind.size()).filter(|n| *n <= MAX_READ).ok_or_else(outside)?;
        let offset = self.header.offset(variable, &shape, start, count).ok_or_else(outside)?;
        if offset.checked_add(bytes).is_none_or(|end| end > self.length) {
            let why = format!("ends before the values of `{}`", variable.name);
            return Err(Error::bad_data(&self.name, why, "it is cut short: get it again"));
        }
        let failed = |e| Error::io(&self.name, e, "check the file");
        let mut buffer = vec![0; bytes as usize];
        self.file.seek(SeekFrom::Start(offset)).map_err(failed)?;
        self.file.read_exact(&mut buffer).map_err(failed)?;
        Ok(buffer)
    }
}

/// How stored numbers become values.
struct Unpacking {
    scale: f64,
    offset: f64,
    missing: [Option<f64>; 2],
}

impl Unpacking {
    fn of(variable: &Variable) -> Self {
        Self {
            scale: variable.number("scale_factor").unwrap_or(1.0),
            offset: variable.number("add_offset").unwrap_or(0.0),
            missing: [variable.number("_FillValue"), variable.number("missing_value")],
        }
    }

    fn value(&self, stored: f64) -> f64 {
        if self.missing.contains(&Some(stored)) { f64::NAN } else { stored * self.scale + self.offset }
    }
}
