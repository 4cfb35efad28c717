//! Protocol buffers as far as tiles need them (<https://protobuf.dev/programming-guides/encoding/>).

use super::{ENDS_EARLY, Read};

/// What a field holds.
pub(super) enum Value<'a> {
    Number(u64),
    Bytes(&'a [u8]),
}

/// Reads fields one after the other.
pub(super) struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    /// Bytes that are left.
    pub(super) fn left(&self) -> usize {
        self.0.len()
    }

    /// The next field's number and value; `None` at the end.
    pub(super) fn field(&mut self) -> Read<Option<(u64, Value<'a>)>> {
        let Some(tag) = self.number_if_any()? else { return Ok(None) };
        let value = match tag & 7 {
            0 => Value::Number(self.number()?),
            1 => Value::Bytes(self.bytes(8)?),
            2 => {
                let length = self.number()?;
                Value::Bytes(self.bytes(length)?)
            }
            5 => Value::Bytes(self.bytes(4)?),
            kind => return Err(format!("has a field of the unknown kind {kind}")),
        };
        Ok(Some((tag >> 3, value)))
    }

    /// A number of seven bits a byte; `None` at the end.
    pub(super) fn number_if_any(&mut self) -> Read<Option<u64>> {
        if self.0.is_empty() { Ok(None) } else { self.number().map(Some) }
    }

    /// A number that counts 0, -1, 1, -2, …
    pub(super) fn signed(&mut self) -> Read<i64> {
        let number = self.number()?;
        Ok((number >> 1) as i64 ^ -((number & 1) as i64))
    }

    fn number(&mut self) -> Read<u64> {
        let mut number = 0;
        for (i, byte) in self.0.iter().take(10).enumerate() {
            number |= u64::from(byte & 0x7f).checked_shl(7 * i as u32).unwrap_or(0);
            if byte & 0x80 == 0 {
                self.0 = &self.0[i + 1..];
                return Ok(number);
            }
        }
        Err(if self.0.len() < 10 { ENDS_EARLY.into() } else { "has a number of more than 64 bits".into() })
    }

    fn bytes(&mut self, length: u64) -> Read<&'a [u8]> {
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        let (bytes, rest) = self.0.split_at_checked(length).ok_or(ENDS_EARLY)?;
        self.0 = rest;
        Ok(bytes)
    }
}
