//! `ocean-globe sample`: what is at a place, as JSON.

use std::time::{Duration, Instant};

use crate::app::clock::unix_now_s;
use crate::cli::render::parse_state;
use crate::data::exposure::{Found, Water};
use crate::data::geoid;
use crate::data::tile::Layer;
use crate::data::water::WaterClass;
use crate::data::world::World;
use crate::error::{Error, Result};
use crate::model::sheltered_sea::RINGS;
use crate::model::spectrum::DirectionalSpectrum;
use crate::model::waves;
use crate::scene::sea::Seas;
use crate::scene::sea::shelter::of_patches;
use crate::scene::sea::shores::Shores;
use crate::scene::sea::surface_sample::instant;
use crate::scene::settings::Quality;
use crate::scene::time::SceneTime;

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
    let state = parse_state(&args.state)?;
    let unix_seconds = instant(&state, args.time.as_deref(), unix_now_s())?;
    let (lat, lon) = (lat_deg.to_radians(), lon_deg.to_radians());
    let mut world = World::open(&args.data);
    world.set_beach_slope(state.settings.surf.beach_slope);
    let sample = world.sample_blocking(lat, lon)?;
    let json = |e: serde_json::Error| Error::bad_data("the sample", e.to_string(), "report this");
    let mut object = serde_json::to_value(sample).map_err(json)?;
    // Elevations are measured from the sea's level, wherever that is drawn.
    let geoid_m = geoid::height_m(lat, lon);
    let over_rest_m = |height_m: f64| height_m - state.settings.datum.rest_m(lat, lon);
    object["geoid_m"] = geoid_m.into();
    object["elevation_over_geoid_m"] = sample.elevation_m.into();
    object["elevation_over_ellipsoid_m"] = (sample.elevation_m + geoid_m).into();
    let mut seas = Seas::default();
    let tables = seas.tables(&state.settings);
    let gains = |world: &mut World, seas: &mut Seas, water| {
        let mut failed = None;
        let mut look = |id| match world.tile_blocking(Layer::Water, id) {
            Ok(Some(texels)) => Found::Tile(texels),
            Ok(None) => Found::Absent,
            Err(error) => {
                failed.get_or_insert(error);
                Found::Absent
            }
        };
        let sea = (&tables, state.settings.wind_from());
        let found = of_patches(seas.shelter.at(sea, (water, lat, lon), &mut look).unwrap_or([1.0; RINGS]));
        // A lee that a damaged tile hides must not be told as open sea.
        failed.map_or(Ok(found), Err)
    };
    let height_m = |gains| serde_json::Value::from(tables.height_gain(gains) * tables.sea.hs_m);
    if let Some(depth_m) = sample.depth_m {
        let gains = gains(&mut world, &mut seas, Water::Ocean)?;
        let shore = match sample.shallows().filter(|_| state.settings.quality != Quality::Low) {
            None => None,
            Some(shallows) => {
                let mut shores = Shores::default();
                let start = Instant::now();
                while !shores.prepare_at(&mut world, (&tables, state.settings.wind_from()), lat, lon) {
                    world.poll();
                    if start.elapsed() > PATIENCE {
                        let why = format!("has not delivered the coast's tiles in {} s", PATIENCE.as_secs());
                        let remedy = "try again, or leave out the waves of shores: `--state '#quality=low'`";
                        return Err(Error::bad_data(&args.data, why, remedy));
                    }
                    std::thread::sleep(Duration::from_millis(1));
                }
                shores.waves_at((lat, lon), shallows, waves::ticks_from_unix(unix_seconds))
            }
        };
        let found = seas.sample_by_shore(&state.settings, (lat, lon), unix_seconds, depth_m, gains, shore);
        let mut surface = serde_json::to_value(found).map_err(json)?;
        // What `sampleSurface` tells, which knows no land.
        let open = seas.sample(&state.settings, lat, lon, unix_seconds, f64::INFINITY);
        surface["open_sea"] = serde_json::json!({ "height_m": open.height_m, "normal_enu": open.normal_enu });
        surface["height_over_geoid_m"] = over_rest_m(found.height_m).into();
        surface["height_over_ellipsoid_m"] = (over_rest_m(found.height_m) + geoid_m).into();
        surface["time"] = SceneTime::At(unix_seconds).to_string().into();
        surface["hs_m"] = tables.sea.hs_m.into();
        surface["hs_here_m"] = height_m(gains);
        surface["gains"] = gains.to_vec().into();
        surface["tp_s"] = tables.sea.spectrum().peak_period().into();
        object["surface"] = surface;
    } else {
        object["surface"] = serde_json::Value::Null;
    }
    if sample.class == WaterClass::Lake {
        object["lake_hs_m"] = height_m(gains(&mut world, &mut seas, Water::Lake)?);
    }
    object["lat_deg"] = lat_deg.into();
    object["lng_deg"] = ((lon_deg + 180.0).rem_euclid(360.0) - 180.0).into();
    Ok(object)
}
