//! Reference systems whose degrees are taken as they are: those of WGS84 and of what lies within a metre of it, ETRS89 and NAD83.

/// Their numbers in EPSG's list, with and without height.
const NUMBERS: [u64; 6] = [4326, 4979, 4258, 4937, 4269, 4957];

/// Their datums as GDAL, ESRI, EPSG and ISO write them, letters and digits alone.
const DATUMS: [&str; 12] = [
    "WGS84",
    "WGS1984",
    "DWGS1984",
    "WORLDGEODETICSYSTEM1984",
    "WORLDGEODETICSYSTEM1984ENSEMBLE",
    "ETRS89",
    "DETRS1989",
    "EUROPEANTERRESTRIALREFERENCESYSTEM1989",
    "EUROPEANTERRESTRIALREFERENCESYSTEM1989ENSEMBLE",
    "NAD83",
    "DNORTHAMERICAN1983",
    "NORTHAMERICANDATUM1983",
];

/// Whether a number of EPSG's list is one of them.
pub fn is_known(number: u64) -> bool {
    NUMBERS.contains(&number)
}

/// The name of what a text (WKT, as a .prj has it) describes, if that is not one of them: a projection, or degrees on another datum. An empty
/// text describes nothing.
pub fn unknown(text: &str) -> Option<String> {
    let text = text.to_uppercase();
    let name = text.split('"').nth(1).unwrap_or(text.trim());
    // A projection has the keyword PROJCS, or in newer text PROJCRS.
    let is_projected = text.contains("PROJCS") || text.contains("PROJCRS");
    let datums = ["DATUM[\"", "ENSEMBLE[\""].iter().filter_map(|keyword| text.split_once(keyword));
    // The first is that of the degrees; one of heights may follow.
    let datum = datums.min_by_key(|(before, _)| before.len());
    let plain = |name: &str| name.chars().filter(char::is_ascii_alphanumeric).collect::<String>();
    let is_known = datum.and_then(|(_, rest)| rest.split('"').next()).is_some_and(|it| DATUMS.contains(&&*plain(it)));
    (!text.trim().is_empty() && (is_projected || !is_known)).then(|| name.to_owned())
}
