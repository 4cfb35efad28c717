//! `ocean-globe sample`: what is at a place, as JSON.

use crate::data::world::World;
use crate::error::{Error, Result};

/// Print elevation, depth, water class and shore distance at a place, as JSON.
#[derive(Debug, Clone, clap::Args)]
#[command(after_help = "Examples:
  ocean-globe sample --at 35.6812,-14.25
  ocean-globe sample --at=-90,0 --data www/data")]
pub struct SampleArgs {
    /// Latitude and longitude in degrees, `lat,lng`
    #[arg(long, value_name = "LAT,LNG", allow_hyphen_values = true)]
    pub at: String,
    /// Folder of the baked world
    #[arg(long, value_name = "FOLDER", default_value = "www/data")]
    pub data: String,
}

/// The JSON object that `sample` prints.
///
/// # Errors
/// A place that is no place, data that cannot be read.
pub fn sample(args: &SampleArgs) -> Result<serde_json::Value> {
    let bad = || Error::bad_value("--at", &args.at, "write latitude,longitude in degrees, e.g. 35.68,-14.25");
    let (lat, lon) = args.at.split_once(',').ok_or_else(bad)?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(bad);
    let (lat_deg, lon_deg) = (number(lat)?, number(lon)?);
    if lat_deg.abs() > 90.0 {
        return Err(bad());
    }
    let sample = World::open(&args.data).sample_blocking(lat_deg.to_radians(), lon_deg.to_radians())?;
    let mut object =
        serde_json::to_value(sample).map_err(|e| Error::bad_data("the sample", e.to_string(), "report this"))?;
    object["lat_deg"] = lat_deg.into();
    object["lng_deg"] = ((lon_deg + 180.0).rem_euclid(360.0) - 180.0).into();
    Ok(object)
}
