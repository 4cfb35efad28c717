//! What is at a place and an instant, ground and sea, in the numbers that are drawn: for a program that can wait for tiles, and for a page, which
//! cannot and asks again.

use serde_json::{Value, json};

use crate::data::exposure::Water;
use crate::data::geoid;
use crate::data::water::WaterClass;
use crate::data::world::{Look, World, WorldWaters};
use crate::error::{Error, Result};
use crate::model::earth::WGS84;
use crate::model::lakes;
use crate::model::surf;
use crate::model::waves;
use crate::scene::link::fragment::parse_state;
use crate::scene::sea::Seas;
use crate::scene::sea::shelter::{behind_reefs, of_patches};
use crate::scene::sea::shores::Shores;
use crate::scene::sea::surface_sample::{SurfaceSample, height_here_m};
use crate::scene::time::SceneTime;
use crate::scene::view::state::ViewState;

/// A place, an instant, and the sea there.
#[derive(Clone, Debug)]
pub struct Question {
    state: ViewState,
    lat_deg: f64,
    lng_deg: f64,
    unix_seconds: f64,
}

impl Question {
    /// Latitude and longitude in degrees, in the sea of a link's fragment, at an ISO 8601 instant (`now`, or none for the link's own; `now_s` is the
    /// clock's, UTC seconds since 1970).
    ///
    /// # Errors
    /// [`Error::BadValue`] for a fragment, a place or an instant that is none.
    pub fn of_link(fragment: &str, (lat_deg, lng_deg): (f64, f64), time: Option<&str>, now_s: f64) -> Result<Self> {
        let state = parse_state(fragment)?;
        if !lng_deg.is_finite() {
            return Err(Error::bad_value("longitude", lng_deg, "give degrees east, e.g. -14.25"));
        }
        if !(-90.0..=90.0).contains(&lat_deg) {
            return Err(Error::bad_value("latitude", lat_deg, "give degrees north, -90 to 90, e.g. 35.68"));
        }
        let remedy = "write an instant as 2026-11-20T12:00:00Z, or now";
        let time = match time {
            Some(text) => SceneTime::parse(text).ok_or_else(|| Error::bad_value("time", text, remedy))?,
            None => state.time,
        };
        Ok(Self { unix_seconds: time.unix_seconds(now_s), state, lat_deg, lng_deg })
    }

    /// As a script of a page asks it: degrees east first, and an empty time is the link's.
    ///
    /// # Errors
    /// Those of [`Question::of_link`].
    pub fn of_script(fragment: &str, lng_deg: f64, lat_deg: f64, time: &str, now_s: f64) -> Result<Self> {
        Self::of_link(fragment, (lat_deg, lng_deg), Some(time).filter(|time| !time.trim().is_empty()), now_s)
    }

    /// The surface there as if there were no land.
    pub fn open_sea(&self, seas: &mut Seas) -> SurfaceSample {
        let (lat, lon) = (self.lat_deg.to_radians(), self.lng_deg.to_radians());
        seas.sample(&self.state.settings, lat, lon, self.unix_seconds, f64::INFINITY)
    }
}

/// What measures places: it keeps the last sea, and the waves by the last shores.
#[derive(Default)]
pub struct MeasuredPlaces {
    seas: Seas,
    shores: Shores,
}

impl MeasuredPlaces {
    /// What is at a place, as `ocean-globe sample` prints it; `None` while tiles are on their way: ask again after [`World::poll`].
    ///
    /// # Errors
    /// What `look` reports of a tile, and of an archive that cannot be opened.
    pub fn at(&mut self, world: &mut World, asked: &Question, look: Look) -> Result<Option<Value>> {
        let Question { state, lat_deg, lng_deg, unix_seconds } = asked;
        let (lat, lon) = (lat_deg.to_radians(), lng_deg.to_radians());
        world.set_beach_slope(state.settings.surf.beach_slope);
        let Some(sample) = world.sample_by(lat, lon, look)? else { return Ok(None) };
        let json = |e: serde_json::Error| Error::bad_data("the sample", e.to_string(), "report this");
        let mut object = serde_json::to_value(sample).map_err(json)?;
        // Elevations are measured from the sea's level, wherever that is drawn.
        let geoid_m = geoid::height_m(lat, lon);
        object["geoid_m"] = geoid_m.into();
        object["elevation_over_geoid_m"] = sample.elevation_m.into();
        object["elevation_over_ellipsoid_m"] = (sample.elevation_m + geoid_m).into();
        object["surface"] = Value::Null;
        let tables = self.seas.tables(&state.settings);
        let mut surface = None;
        let mut breakers = Value::Null;
        if let Some(depth_m) = sample.depth_m {
            let Some((sheltered, peak_s)) = self.waves(world, state, (Water::Ocean, lat, lon), look)? else {
                return Ok(None);
            };
            let gains = behind_reefs(sheltered, sample.waves_left);
            let has_trains = sample.shallows().is_some() && state.settings.quality.is_fine();
            if has_trains && !self.shores.prepare_at(world, (&tables, state.settings.wind_from()), lat, lon) {
                return Ok(None);
            }
            let trains = sample.shallows().filter(|_| has_trains);
            let ticks = waves::ticks_from_unix(*unix_seconds);
            let shore = trains.and_then(|shallows| self.shores.waves_at((lat, lon), shallows, ticks));
            let hs_here_m = height_here_m(&tables, depth_m, gains, shore.as_ref());
            if let Some(similarity) = shore.map(|shore| shore.similarity) {
                breakers = json!({ "iribarren": similarity, "kind": surf::kind(similarity) });
            }
            let mut by_shore = |depth_m, left, shore| {
                let gains = behind_reefs(sheltered, left);
                self.seas.sample_by_shore(&state.settings, (lat, lon), *unix_seconds, depth_m, gains, shore)
            };
            let mut found = by_shore(depth_m, sample.waves_left, shore);
            // Shaders look up depth, reefs and trains where the water rests that the patches' chop has carried here. That depends on all by a tenth of
            // itself: twice brings millimetres.
            for _ in 0..if shore.is_some() || sample.waves_left < 1.0 { 2 } else { 0 } {
                let [east_m, north_m, _] = found.displacement_enu_m;
                let rest = (lat - north_m / WGS84.a, lon - east_m / (WGS84.a * libm::cos(lat)));
                let Some(there) = world.sample_by(rest.0, rest.1, look)? else { return Ok(None) };
                let Some(water) = there.shallows() else { break };
                let shore = trains.and_then(|_| self.shores.waves_at(rest, water, ticks));
                found = by_shore(water.h, there.waves_left, shore);
            }
            surface = Some((found, gains, peak_s, hs_here_m));
        }
        if sample.class == WaterClass::Lake {
            let Some((gains, peak_s)) = self.waves(world, state, (Water::Lake, lat, lon), look)? else {
                return Ok(None);
            };
            object["lake_hs_m"] = (tables.height_gain(gains) * tables.sea.hs_m).into();
            object["lake_tp_s"] = peak_s.into();
            if sample.is_moving_lake && state.settings.quality.is_fine() {
                let depth_m = lakes::BED_SLOPE * sample.lake_distance_m.unwrap_or(0.0);
                let waves = self.seas.sample_in(&state.settings, (lat, lon), *unix_seconds, depth_m, gains);
                let found = SurfaceSample { height_m: waves.height_m + sample.elevation_m, ..waves };
                surface = Some((found, gains, peak_s, height_here_m(&tables, depth_m, gains, None)));
            }
        }
        if let Some((found, gains, peak_s, hs_here_m)) = surface {
            let over_rest_m = found.height_m - state.settings.datum.rest_m(lat, lon);
            let mut surface = serde_json::to_value(found).map_err(json)?;
            // What `sampleOpenSea` tells, which knows no land.
            let open = asked.open_sea(&mut self.seas);
            let tp_s = tables.peak_period_s;
            surface["open_sea"] = json!({ "height_m": open.height_m, "normal_enu": open.normal_enu, "tp_s": tp_s });
            surface["height_over_geoid_m"] = over_rest_m.into();
            surface["height_over_ellipsoid_m"] = (over_rest_m + geoid_m).into();
            surface["time"] = SceneTime::At(*unix_seconds).to_string().into();
            surface["hs_m"] = tables.sea.hs_m.into();
            surface["hs_here_m"] = hs_here_m.into();
            surface["gains"] = gains.to_vec().into();
            surface["tp_s"] = peak_s.into();
            surface["breakers"] = breakers;
            object["surface"] = surface;
        }
        object["lat_deg"] = (*lat_deg).into();
        object["lng_deg"] = ((lng_deg + 180.0).rem_euclid(360.0) - 180.0).into();
        Ok(Some(object))
    }

    /// How much higher than the open sea's the waves of each patch are at a place, and the period of their peak, s; `None` while tiles are on
    /// their way.
    fn waves(
        &mut self,
        world: &mut World,
        state: &ViewState,
        place: (Water, f64, f64),
        look: Look,
    ) -> Result<Option<([f64; waves::CASCADES], f64)>> {
        let tables = self.seas.tables(&state.settings);
        let mut found = WorldWaters::new(world, look);
        let (sea, shelter) = ((&tables, state.settings.wind_from()), &mut self.seas.shelter);
        let gains = shelter.at(sea, place, &mut found).map(of_patches);
        let waves = gains.and_then(|gains| Some((gains, shelter.peak_period_at(sea, place, &mut found)?)));
        // A lee that a damaged tile hides must not be told as open sea.
        found.failed.map_or(Ok(waves), Err)
    }
}
