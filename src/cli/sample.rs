//! `ocean-globe sample`: what is at a place, as JSON.

use std::time::{Duration, Instant};

use crate::app::clock::unix_now_s;
use crate::data::world::World;
use crate::error::{Error, Result};
use crate::scene::measured_place::{MeasuredPlaces, Question};

/// For the coast's tiles.
const PATIENCE: Duration = Duration::from_secs(60);

/// Print elevation, depth, water class, shore distance and the surface of the sea at a place, as JSON.
#[derive(Debug, Clone, Default, clap::Args)]
#[command(after_help = "Examples:
  ocean-globe sample --at 35.6812,-14.25
  ocean-globe sample --at=-90,0 --data www/data
  ocean-globe sample --at 35.68,-14.25 --state '#bft=8' --time 2026-11-20T12:00:00Z")]
pub struct SampleArgs {
    /// Latitude and longitude in degrees, `lat,lng`
    #[arg(long, value_name = "LAT,LNG", allow_hyphen_values = true)]
    pub at: String,
    /// The sea: a link's fragment, as the page's address shows it
    #[arg(long, default_value = "", value_name = "FRAGMENT")]
    pub state: String,
    /// The instant of the sea's surface, ISO 8601; without it the link's, or now
    #[arg(long, value_name = "TIME")]
    pub time: Option<String>,
    /// Folder of the baked world
    #[arg(long, value_name = "FOLDER", default_value = "www/data")]
    pub data: String,
}

/// The JSON object that `sample` prints.
///
/// # Errors
/// A place, a state or an instant that is none, data that cannot be read.
pub fn sample(args: &SampleArgs) -> Result<serde_json::Value> {
    let bad = || Error::bad_value("--at", &args.at, "write latitude,longitude in degrees, e.g. 35.68,-14.25");
    let (lat, lon) = args.at.split_once(',').ok_or_else(bad)?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|v| v.is_finite()).ok_or_else(bad);
    let (lat_deg, lon_deg) = (number(lat)?, number(lon)?);
    if lat_deg.abs() > 90.0 {
        return Err(bad());
    }
    let asked = Question::of_link(&args.state, (lat_deg, lon_deg), args.time.as_deref(), unix_now_s())?;
    let (mut world, mut places) = (World::open(&args.data), MeasuredPlaces::default());
    let start = Instant::now();
    loop {
        if let Some(found) = places.at(&mut world, &asked, World::look_blocking)? {
            return Ok(found);
        }
        // The waves of shores ask for tiles by themselves.
        world.poll();
        if start.elapsed() > PATIENCE {
            let why = format!("has not delivered the coast's tiles in {} s", PATIENCE.as_secs());
            let remedy = "try again, or leave out the waves of shores: `--state '#quality=low'`";
            return Err(Error::bad_data(&args.data, why, remedy));
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}
