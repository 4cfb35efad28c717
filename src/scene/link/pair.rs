//! The `key=value` pairs of a fragment: whose a pair is, and percent-encoding.

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

/// What is escaped in keys and values.
const ESCAPED: &AsciiSet =
    &NON_ALPHANUMERIC.remove(b'-').remove(b'_').remove(b'.').remove(b'~').remove(b'@').remove(b':').remove(b',');

/// The key under which a MapLibre hash, which has none, is handed on.
pub const MAP_HASH: &str = "/";

/// The decoded key and value of a pair that is ours; `None` where it belongs to the page.
///
/// Without a `name` every pair is ours. With one, ours are `name.key=value` and MapLibre's `name=zoom/lat/lng`.
pub fn our_pair(pair: &str, name: Option<&str>) -> Option<(String, String)> {
    let Some((key, value)) = pair.split_once('=') else {
        let key = if name.is_none() && is_map_hash(pair) { MAP_HASH } else { pair };
        return name.is_none().then(|| (key.into(), decode(pair)));
    };
    let (key, value) = (decode(key), decode(value));
    let Some(name) = name else { return Some((key, value)) };
    let rest = key.strip_prefix(name)?;
    if rest.is_empty() {
        return is_map_hash(&value).then(|| (MAP_HASH.into(), value));
    }
    rest.strip_prefix('.').map(|key| (key.into(), value))
}

/// Whether a text has the form of `zoom/lat/lng…`, whatever its numbers.
fn is_map_hash(text: &str) -> bool {
    let mut parts = text.split('/');
    parts.next().is_some_and(|zoom| zoom.parse::<f64>().is_ok()) && parts.count() >= 2
}

/// Percent-decodes; a `%` without two digits stays, and so does a `+`.
pub fn decode(text: &str) -> String {
    percent_decode_str(text).decode_utf8_lossy().into_owned()
}

/// Percent-encodes everything that could end a key or break an address.
pub fn encode(text: &str) -> String {
    utf8_percent_encode(text, ESCAPED).to_string()
}
