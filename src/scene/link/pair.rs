//! The `key=value` pairs of a fragment: whose a pair is, and percent-encoding.

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
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&first, tail)) = rest.split_first() {
        let digit = |at: usize| tail.get(at).and_then(|&byte| (byte as char).to_digit(16));
        match (first, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((high * 16 + low) as u8);
                rest = &tail[2..];
            }
            _ => {
                bytes.push(first);
                rest = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Percent-encodes everything that could end a key or break an address.
pub fn encode(text: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-_.~@:,".contains(&byte);
    let encoded =
        text.bytes().map(|byte| if plain(byte) { (byte as char).to_string() } else { format!("%{byte:02X}") });
    encoded.collect()
}
