//! The `Range` header (RFC 9110, section 14) for one file of known length.

use std::ops::Range;

/// What a `Range` header asks of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Wanted {
    /// The whole file: no header, several ranges at once, or a header that the RFC says to ignore.
    Whole,
    /// These bytes, never empty and never past the end.
    Part(Range<u64>),
    /// Nothing that the file has: answered by 416.
    Unsatisfiable,
}

/// Reads the value of a `Range` header for a file of `len` bytes.
///
/// ```
/// use ocean_globe::cli::serve::range::{Wanted, wanted};
/// assert_eq!(wanted(Some("bytes=0-1"), 10), Wanted::Part(0..2));
/// assert_eq!(wanted(Some("bytes=-3"), 10), Wanted::Part(7..10));
/// assert_eq!(wanted(Some("bytes=10-"), 10), Wanted::Unsatisfiable);
/// ```
#[must_use]
pub fn wanted(header: Option<&str>, len: u64) -> Wanted {
    let Some(spec) = header.and_then(bytes_unit) else { return Wanted::Whole };
    match spec.split_once('-') {
        Some(("", suffix)) => last_bytes(suffix, len),
        Some((first, last)) => from_to(first, last, len),
        None => Wanted::Whole,
    }
}

/// The part after `bytes=`; the unit's name has no case. A list of ranges is not for us: the answer is the whole file.
fn bytes_unit(header: &str) -> Option<&str> {
    let (unit, spec) = header.split_once('=')?;
    (unit.trim().eq_ignore_ascii_case("bytes") && !spec.contains(',')).then(|| spec.trim())
}

fn last_bytes(suffix: &str, len: u64) -> Wanted {
    match position(suffix) {
        None => Wanted::Whole,
        Some(0) => Wanted::Unsatisfiable,
        Some(_) if len == 0 => Wanted::Unsatisfiable,
        Some(count) => Wanted::Part(len.saturating_sub(count)..len),
    }
}

fn from_to(first: &str, last: &str, len: u64) -> Wanted {
    let Some(first) = position(first) else { return Wanted::Whole };
    let end = match last {
        "" => len,
        last => match position(last) {
            Some(last) if last >= first => last.saturating_add(1).min(len),
            _ => return Wanted::Whole,
        },
    };
    if first < len { Wanted::Part(first..end) } else { Wanted::Unsatisfiable }
}

/// Digits only, as `u64::from_str` would also take a plus sign; a number too large stands for "past every end".
fn position(text: &str) -> Option<u64> {
    let digits = !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    digits.then(|| text.parse().unwrap_or(u64::MAX))
}
