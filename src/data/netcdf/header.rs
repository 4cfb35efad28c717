//! The header of a netCDF-3 file: dimensions, attributes, variables and where their values lie.

use crate::error::{Error, Result};
use std::io::Read;

/// The longest name or attribute accepted, bytes.
const MAX_TEXT: u64 = 1 << 20;
/// The most dimensions, attributes or variables accepted.
const MAX_ITEMS: u64 = 4096;

/// The type of stored numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Type {
    /// Signed 8 bits.
    Byte,
    /// Text.
    Char,
    /// Signed 16 bits.
    Short,
    /// Signed 32 bits.
    Int,
    /// IEEE 32 bits.
    Float,
    /// IEEE 64 bits.
    Double,
}

impl Type {
    /// Bytes of one number.
    pub fn size(self) -> u64 {
        match self {
            Self::Byte | Self::Char => 1,
            Self::Short => 2,
            Self::Int | Self::Float => 4,
            Self::Double => 8,
        }
    }

    /// The number that these (big-endian) bytes store; NaN where there are too few.
    pub fn number(self, bytes: &[u8]) -> f64 {
        let number = match self {
            Self::Byte => bytes.first().map(|b| f64::from(*b as i8)),
            Self::Char => bytes.first().map(|b| f64::from(*b)),
            Self::Short => bytes.first_chunk().map(|b| f64::from(i16::from_be_bytes(*b))),
            Self::Int => bytes.first_chunk().map(|b| f64::from(i32::from_be_bytes(*b))),
            Self::Float => bytes.first_chunk().map(|b| f64::from(f32::from_be_bytes(*b))),
            Self::Double => bytes.first_chunk().map(|b| f64::from_be_bytes(*b)),
        };
        number.unwrap_or(f64::NAN)
    }
}

/// A dimension.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dimension {
    /// Its name.
    pub name: String,
    /// Its length; of the record dimension, the number of records.
    pub length: u64,
    /// Whether it is the record dimension.
    pub is_record: bool,
}

/// An attribute: text, or numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Attribute {
    /// Its name.
    pub name: String,
    /// Its text, where it is text.
    pub text: Option<String>,
    /// Its numbers, where it has numbers.
    pub numbers: Vec<f64>,
}

/// A variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// Indices of its dimensions, slowest first.
    pub dimensions: Vec<usize>,
    /// Its attributes.
    pub attributes: Vec<Attribute>,
    /// The type of its values.
    pub kind: Type,
    /// Where its values (of the first record) begin, bytes.
    pub begin: u64,
    /// Whether its first dimension is the record dimension.
    pub is_record: bool,
}

impl Variable {
    /// The first number of an attribute.
    pub fn number(&self, attribute: &str) -> Option<f64> {
        self.attributes.iter().find(|a| a.name == attribute)?.numbers.first().copied()
    }
}

/// Everything before the values.
#[derive(Debug)]
pub(super) struct Header {
    pub(super) dimensions: Vec<Dimension>,
    pub(super) attributes: Vec<Attribute>,
    pub(super) variables: Vec<Variable>,
    /// Bytes from one record to the next.
    record_stride: u64,
}

impl Header {
    /// Where `count` values from `start` lie, bytes; `None` outside the variable or on overflow.
    pub(super) fn offset(&self, variable: &Variable, shape: &[u64], start: &[u64], count: u64) -> Option<u64> {
        if start.len() != shape.len() {
            return None;
        }
        let (last, last_length) = (*start.last().unwrap_or(&0), *shape.last().unwrap_or(&1));
        let in_place = start.iter().zip(shape).all(|(i, n)| i < n) && last.checked_add(count)? <= last_length;
        // Records lie apart, so a row of a one-dimensional record variable is one value.
        if !in_place || (variable.is_record && shape.len() == 1 && count != 1) {
            return None;
        }
        let fixed = usize::from(variable.is_record);
        let mut index = 0u64;
        for (i, n) in start.iter().zip(shape).skip(fixed) {
            index = index.checked_mul(*n)?.checked_add(*i)?;
        }
        let record = if variable.is_record { start[0].checked_mul(self.record_stride)? } else { 0 };
        variable.begin.checked_add(record)?.checked_add(index.checked_mul(variable.kind.size())?)
    }
}

/// Reads the header.
pub(super) fn read(name: &str, input: &mut impl Read, length: u64) -> Result<Header> {
    let mut reader = Reader { name, input, wide: false };
    let magic = reader.bytes(4)?;
    reader.wide = match &magic[..] {
        b"CDF\x01" => false,
        b"CDF\x02" => true,
        b"\x89HDF" => return Err(reader.bad("is a netCDF-4 file (convert it with `nccopy -k classic`)")),
        _ => return Err(reader.bad("is no netCDF-3 file")),
    };
    let records = reader.word()?;
    let mut dimensions = Vec::new();
    for _ in 0..reader.list(10)? {
        let (name, stored) = (reader.text()?, reader.word()?);
        dimensions.push(Dimension { name, length: u64::from(stored), is_record: stored == 0 });
    }
    let attributes = reader.attributes()?;
    let mut variables = Vec::new();
    for _ in 0..reader.list(11)? {
        variables.push(reader.variable(&dimensions)?);
    }
    let record_stride =
        record_stride(&dimensions, &variables).ok_or_else(|| reader.bad("has records that overflow"))?;
    let first = variables.iter().filter(|v| v.is_record).map(|v| v.begin).min();
    let counted = match (records, first) {
        // "Streaming": the number of records follows from the length of the file.
        (u32::MAX, Some(first)) => length.saturating_sub(first).checked_div(record_stride).unwrap_or(0),
        (u32::MAX, None) => 0,
        (records, _) => u64::from(records),
    };
    dimensions.iter_mut().filter(|d| d.is_record).for_each(|d| d.length = counted);
    Ok(Header { dimensions, attributes, variables, record_stride })
}

/// The sum of one record of every record variable, each padded to four bytes unless it is the only one.
fn record_stride(dimensions: &[Dimension], variables: &[Variable]) -> Option<u64> {
    let of_record: Vec<_> = variables.iter().filter(|v| v.is_record).collect();
    let mut stride = 0u64;
    for variable in &of_record {
        let lengths = variable.dimensions.iter().skip(1).map(|d| dimensions[*d].length);
        let bytes = lengths.into_iter().try_fold(variable.kind.size(), u64::checked_mul)?;
        stride = stride.checked_add(if of_record.len() == 1 { bytes } else { bytes.checked_next_multiple_of(4)? })?;
    }
    Some(stride)
}

struct Reader<'a, R> {
    name: &'a str,
    input: &'a mut R,
    /// CDF-2: offsets of 64 bits.
    wide: bool,
}

impl<R: Read> Reader<'_, R> {
    fn bad(&self, why: &str) -> Error {
        Error::bad_data(self.name, why, "a whole, undamaged netCDF-3 (classic) file is needed")
    }

    fn bytes(&mut self, count: u64) -> Result<Vec<u8>> {
        let mut bytes = Vec::new();
        let read = self.input.take(count).read_to_end(&mut bytes);
        match read {
            Ok(n) if n as u64 == count => Ok(bytes),
            Ok(_) => Err(self.bad("ends within its header")),
            Err(e) => Err(Error::io(self.name, e, "check the file")),
        }
    }

    fn word(&mut self) -> Result<u32> {
        Ok(self.bytes(4)?.iter().fold(0, |word, byte| word << 8 | u32::from(*byte)))
    }

    fn padded(&mut self, count: u64) -> Result<Vec<u8>> {
        if count > MAX_TEXT {
            return Err(self.bad("has a name or an attribute of impossible length"));
        }
        let mut bytes = self.bytes(count.next_multiple_of(4))?;
        bytes.truncate(count as usize);
        Ok(bytes)
    }

    fn text(&mut self) -> Result<String> {
        let length = self.word()?;
        Ok(String::from_utf8_lossy(&self.padded(u64::from(length))?).into_owned())
    }

    /// The length of a list that is tagged with `tag`, or absent.
    fn list(&mut self, tag: u32) -> Result<u32> {
        let (found, count) = (self.word()?, self.word()?);
        match (found, count) {
            (0, 0) => Ok(0),
            (found, count) if found == tag && u64::from(count) <= MAX_ITEMS => Ok(count),
            _ => Err(self.bad("has a broken list in its header")),
        }
    }

    fn kind(&mut self) -> Result<Type> {
        Ok(match self.word()? {
            1 => Type::Byte,
            2 => Type::Char,
            3 => Type::Short,
            4 => Type::Int,
            5 => Type::Float,
            6 => Type::Double,
            _ => return Err(self.bad("has values of an unknown type")),
        })
    }

    fn attributes(&mut self) -> Result<Vec<Attribute>> {
        let mut attributes = Vec::new();
        for _ in 0..self.list(12)? {
            let (name, kind, count) = (self.text()?, self.kind()?, self.word()?);
            let bytes = self.padded(u64::from(count) * kind.size())?;
            let is_text = kind == Type::Char;
            let text = is_text.then(|| String::from_utf8_lossy(&bytes).trim_end_matches('\0').to_owned());
            let numbers = bytes.chunks_exact(kind.size() as usize).filter(|_| !is_text).map(|b| kind.number(b));
            attributes.push(Attribute { name, text, numbers: numbers.collect() });
        }
        Ok(attributes)
    }

    fn variable(&mut self, known: &[Dimension]) -> Result<Variable> {
        let name = self.text()?;
        let rank = self.word()?;
        if u64::from(rank) > 32 {
            return Err(self.bad("has a variable of too many dimensions"));
        }
        let mut dimensions = Vec::new();
        for place in 0..rank {
            let index = self.word()? as usize;
            match known.get(index) {
                Some(dimension) if !dimension.is_record || place == 0 => dimensions.push(index),
                _ => return Err(self.bad("has a variable of impossible dimensions")),
            }
        }
        let attributes = self.attributes()?;
        let kind = self.kind()?;
        // The stored size is redundant, and wrong for large variables.
        self.word()?;
        let high = if self.wide { u64::from(self.word()?) } else { 0 };
        let begin = high << 32 | u64::from(self.word()?);
        let is_record = dimensions.first().is_some_and(|d| known[*d].is_record);
        Ok(Variable { name, dimensions, attributes, kind, begin, is_record })
    }
}
