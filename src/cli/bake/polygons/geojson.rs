//! GeoJSON (RFC 7946): whatever holds polygons, at any depth that the JSON reader takes (128).

use serde_json::Value;

use super::{Point, Polygon};
use crate::data::coast::Level;
use crate::error::{Error, Result};

/// Reads a file's bytes.
///
/// # Errors
/// As for [`super::read`].
pub fn read(name: &str, bytes: &[u8]) -> Result<Vec<Polygon>> {
    let json: Value = serde_json::from_slice(bytes).map_err(|e| {
        let why = format!("is no JSON that can be read: {e}");
        Error::bad_data(name, why, "it is cut short or of another kind: get it again")
    })?;
    // RFC 7946 knows WGS84 alone; what came before it named others.
    let crs = json.pointer("/crs/properties/name").and_then(Value::as_str);
    if let Some(crs) = crs.filter(|crs| !crs.ends_with("CRS84") && !crs.ends_with("4326")) {
        let remedy = "bring it to degrees of WGS84: `ogr2ogr -t_srs EPSG:4326 OUT IN`";
        return Err(Error::bad_data(name, format!("is in the coordinates of {crs}"), remedy));
    }
    let mut reader = Reader { name, polygons: Vec::new() };
    reader.add(&json, Level::Land)?;
    Ok(reader.polygons)
}

struct Reader<'a> {
    name: &'a str,
    polygons: Vec<Polygon>,
}

impl Reader<'_> {
    fn bad(&self, why: &str) -> Error {
        let why = format!("polygon {} {why}", self.polygons.len() + 1);
        Error::bad_data(self.name, why, "write it as RFC 7946 has it: `ogr2ogr -f GeoJSON OUT IN`")
    }

    fn add(&mut self, json: &Value, level: Level) -> Result<()> {
        let list = |key: &str| json.get(key).and_then(Value::as_array);
        match json.get("type").and_then(Value::as_str) {
            Some("FeatureCollection") => {
                let features = list("features").ok_or_else(|| self.bad("stands in a collection without features"))?;
                features.iter().try_for_each(|feature| self.add(feature, level))
            }
            Some("Feature") => {
                let kind = json.pointer("/properties/kind").and_then(Value::as_str);
                let level = match kind {
                    None => level,
                    Some(kind) => Level::ALL.into_iter().find(|level| level.name() == kind).ok_or_else(|| {
                        let why = format!("is of the kind `{kind}`");
                        let known = Level::ALL.map(Level::name).join(", ");
                        Error::bad_data(
                            self.name,
                            format!("polygon {} {why}", self.polygons.len() + 1),
                            format!("known are {known}"),
                        )
                    })?,
                };
                // A feature may have no geometry.
                json.get("geometry").filter(|geometry| !geometry.is_null()).map_or(Ok(()), |it| self.add(it, level))
            }
            Some("GeometryCollection") => {
                let all = list("geometries").ok_or_else(|| self.bad("stands in a collection without geometries"))?;
                all.iter().try_for_each(|geometry| self.add(geometry, level))
            }
            Some("Polygon") => {
                let rings = list("coordinates").ok_or_else(|| self.bad("has no coordinates"))?;
                self.polygon(rings, level)
            }
            Some("MultiPolygon") => {
                let polygons = list("coordinates").ok_or_else(|| self.bad("has no coordinates"))?;
                polygons.iter().try_for_each(|rings| {
                    let rings =
                        rings.as_array().ok_or_else(|| self.bad("has coordinates that are no list of rings"))?;
                    self.polygon(rings, level)
                })
            }
            Some("Point" | "MultiPoint" | "LineString" | "MultiLineString") => Ok(()),
            _ => Err(self.bad("has no known type")),
        }
    }

    fn polygon(&mut self, rings: &[Value], level: Level) -> Result<()> {
        let point = |point: &Value| -> Option<Point> {
            let point = point.as_array()?;
            Some([point.first()?.as_f64()?, point.get(1)?.as_f64()?])
        };
        let ring = |ring: &Value| ring.as_array()?.iter().map(point).collect::<Option<Vec<_>>>();
        let rings = rings.iter().map(ring).collect::<Option<Vec<_>>>();
        let rings = rings.ok_or_else(|| self.bad("has a point that is no pair of numbers"))?;
        self.polygons.push(Polygon { level, rings, number: self.polygons.len() + 1 });
        Ok(())
    }
}
