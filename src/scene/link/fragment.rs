//! The text form of a [`ViewState`], the part of a page's address after `#`:
//! ```text
//! #view=35.6812,-14.25,560,120,78&wind=13.9@240&spectrum=jonswap&fetch=300&time=2026-11-20T12:00:00Z&seed=7
//! ```
//! `key=value` pairs, latitude before longitude, only what differs from the default. With a name every key is
//! `name.key`, and all other pairs belong to the page. Reading never fails: a bad pair is reported and the last good
//! value stays; numbers are checked finite, then clamped. Unknown pairs are kept as they were written.
//! Values are ids and numbers, never addresses: a link cannot make a page fetch from a stranger's host.

use crate::error::{Error, Result};
use crate::scene::layers::Layers;
use crate::scene::link::maplibre;
use crate::scene::link::number::{clamped, decimal, whole};
use crate::scene::link::pair::{MAP_HASH, encode, our_pair};
use crate::scene::link::values::{
    format_foam, format_mesh, format_surf, format_swell, format_view, format_water, format_wind, name_of, named, names,
    parse_foam, parse_mesh, parse_surf, parse_swell, parse_view, parse_water, parse_wind,
};
use crate::scene::settings::{Datum, HAZIEST, Quality, Settings, Spectrum, Water};
use crate::scene::time::SceneTime;
use crate::scene::view::camera::Camera;
use crate::scene::view::state::ViewState;

/// Longest fragment of ours that is read or written, bytes.
pub const LONGEST: usize = 2048;

/// The keys in the order in which they are written.
const KEYS: [&str; 21] = [
    "view", "ride", "wind", "bft", "spectrum", "fetch", "swell", "chop", "foam", "haze", "clouds", "water", "surf",
    "time", "rate", "seed", "mesh", "quality", "datum", "layers", "v",
];

/// The view of a fragment. What it cannot use is an error here: a script must not get another view than it asked for.
///
/// # Errors
/// The first complaint of the fragment's parser.
pub fn parse_state(text: &str) -> Result<ViewState> {
    let (state, complaints) = ViewState::parse_fragment(text, None);
    complaints.into_iter().next().map_or(Ok(state), Err)
}

impl ViewState {
    /// Reads a fragment, with or without `#`; what it does not say has its default. The errors name the pairs that
    /// were skipped. `name`: the prefix of our keys on a page that has other pairs.
    pub fn parse_fragment(text: &str, name: Option<&str>) -> (Self, Vec<Error>) {
        let mut state = Self::default();
        let errors = state.apply_fragment(text, name);
        (state, errors)
    }

    /// As [`ViewState::parse_fragment`], but a bad pair leaves the present value.
    pub fn apply_fragment(&mut self, text: &str, name: Option<&str>) -> Vec<Error> {
        let mut last = std::mem::take(self);
        let mut errors = Vec::new();
        let mut room = LONGEST;
        // Whether the camera's altitude is still as a link has it.
        let mut written = false;
        let pairs = text.split('&').map(|pair| pair.trim_start_matches('#'));
        for pair in pairs.filter(|pair| !pair.is_empty()) {
            let Some((key, value)) = our_pair(pair, name) else {
                self.unknown.push(pair.into());
                continue;
            };
            if pair.len() >= room {
                if room > 0 {
                    errors.push(Error::bad_value("fragment", text.len(), format!("only {LONGEST} bytes are read")));
                }
                room = 0;
                continue;
            }
            room -= pair.len() + 1;
            if !KEYS.contains(&key.as_str()) && key != MAP_HASH {
                self.unknown.push(pair.into());
            } else if let Err(error) = self.set(&key, &value, &mut errors) {
                self.copy(&key, &last);
                errors.push(error);
            } else {
                last.copy(&key, self);
                written = if key == MAP_HASH { false } else { written || key == "view" };
            }
        }
        if written {
            self.camera.altitude_m -= self.rest_m(&self.camera);
        }
        errors
    }

    /// Writes the fragment, without `#`: the page's own pairs where there is a `name`, then ours, then unknown ones.
    pub fn format_fragment(&self, name: Option<&str>) -> String {
        let prefix = name.map(|name| encode(name) + ".").unwrap_or_default();
        let is_page_pair = |pair: &&String| our_pair(pair, name).is_none();
        let mut pairs: Vec<String> = self.unknown.iter().filter(is_page_pair).cloned().collect();
        let mut room = LONGEST;
        let values = KEYS.iter().filter_map(|key| Some(format!("{prefix}{key}={}", self.get(key)?)));
        let unknown = self.unknown.iter().filter(|pair| !is_page_pair(pair)).cloned();
        for pair in values.chain(unknown) {
            if let Some(left) = room.checked_sub(pair.len() + 1) {
                room = left;
                pairs.push(pair);
            }
        }
        pairs.join("&")
    }

    /// What a link's altitudes at a camera's place have more than the camera's own, which is over the resting sea, or over the waves, m.
    fn rest_m(&self, camera: &Camera) -> f64 {
        if self.ride { 0.0 } else { self.settings.datum.rest_m(camera.lat, camera.lon) }
    }

    /// A camera as links have it.
    fn view_text(&self, camera: &Camera) -> String {
        format_view(camera, |lat, lon| self.rest_m(&Camera { lat, lon, ..*camera }))
    }

    /// Sets one key from its decoded value. Notes that do not spoil the pair go to `notes`.
    fn set(&mut self, key: &str, value: &str, notes: &mut Vec<Error>) -> Result<()> {
        let bad = |remedy: &str| Error::bad_value(key, value, remedy);
        let s = &mut self.settings;
        match key {
            "view" => self.camera = parse_view(value).ok_or_else(|| bad("give lat,lng,alt[,heading[,tilt]]"))?,
            "ride" => self.ride = clamped(value, 0.0..=1.0).ok_or_else(|| bad("give 0 or 1"))? >= 0.5,
            "wind" => s.wind = parse_wind(value).ok_or_else(|| bad("give m/s@degrees, e.g. 8@250"))?,
            "bft" => s.beaufort = Some(whole(value, 0.0..=12.0).ok_or_else(|| bad("give a grade 0 to 12"))? as u8),
            "spectrum" => s.spectrum = named(&Spectrum::ALL, value).ok_or_else(|| bad(&names(&Spectrum::ALL)))?,
            "fetch" => s.fetch_km = Some(clamped(value, 1.0..=5000.0).ok_or_else(|| bad("give 1 to 5000 km"))?),
            "swell" => s.swell = Some(parse_swell(value).ok_or_else(|| bad("give height,period,from"))?),
            "chop" => s.chop = clamped(value, 0.0..=2.0).ok_or_else(|| bad("give 0 to 2"))?,
            "foam" => s.foam = parse_foam(value).ok_or_else(|| bad("give amount[,lifetime[,height]]"))?,
            "haze" => s.haze = clamped(value, 0.0..=HAZIEST).ok_or_else(|| bad("give 0 to 0.5"))?,
            "clouds" => s.clouds = Some(clamped(value, 0.0..=1.0).ok_or_else(|| bad("give a cover, 0 to 1"))?),
            "water" => {
                (s.water, s.water_density_per_m) = parse_water(value).ok_or_else(|| bad(&names(&Water::ALL)))?;
            }
            "surf" => s.surf = parse_surf(value).ok_or_else(|| bad("give a factor of its width[,beach slope]"))?,
            "time" => self.time = SceneTime::parse(value).ok_or_else(|| bad("give ISO 8601 UTC, or now"))?,
            "rate" => self.rate = clamped(value, -1000.0..=1000.0).ok_or_else(|| bad("give -1000 to 1000"))?,
            "seed" => {
                s.seed = whole(value, 0.0..=f64::from(u32::MAX)).ok_or_else(|| bad("give a whole number"))? as u32;
            }
            "mesh" => {
                (s.mesh, s.triangles) =
                    parse_mesh(value).ok_or_else(|| bad("give grid or bisect[,pixels[,budget]]"))?;
            }
            "quality" => s.quality = named(&Quality::ALL, value).ok_or_else(|| bad(&names(&Quality::ALL)))?,
            "datum" => s.datum = named(&Datum::ALL, value).ok_or_else(|| bad(&names(&Datum::ALL)))?,
            "layers" => {
                let (layers, unknown) = Layers::from_ids(value);
                s.layers = layers;
                notes.extend(unknown.iter().map(|id| Error::bad_value(key, id, "this layer is not known")));
            }
            "v" if value == "1" => {}
            "v" => return Err(bad("this version reads v=1")),
            MAP_HASH => self.camera = maplibre::camera_from_hash(value).ok_or_else(|| bad("give zoom/lat/lng"))?,
            _ => {}
        }
        Ok(())
    }

    /// Copies the value of one key.
    fn copy(&mut self, key: &str, from: &Self) {
        let (to, settings) = (&mut self.settings, &from.settings);
        match key {
            "view" | MAP_HASH => self.camera = from.camera,
            "ride" => self.ride = from.ride,
            "wind" => to.wind = settings.wind,
            "bft" => to.beaufort = settings.beaufort,
            "spectrum" => to.spectrum = settings.spectrum,
            "fetch" => to.fetch_km = settings.fetch_km,
            "swell" => to.swell = settings.swell,
            "chop" => to.chop = settings.chop,
            "foam" => to.foam = settings.foam,
            "haze" => to.haze = settings.haze,
            "clouds" => to.clouds = settings.clouds,
            "water" => {
                (to.water, to.water_density_per_m) = (settings.water, settings.water_density_per_m);
            }
            "surf" => to.surf = settings.surf,
            "time" => self.time = from.time,
            "rate" => self.rate = from.rate,
            "seed" => to.seed = settings.seed,
            "mesh" => (to.mesh, to.triangles) = (settings.mesh, settings.triangles),
            "quality" => to.quality = settings.quality,
            "datum" => to.datum = settings.datum,
            _ => {}
        }
    }

    /// The text of one key's value; `None` where it is the default.
    fn get(&self, key: &str) -> Option<String> {
        let s = &self.settings;
        let default = Settings::default();
        match key {
            "view" => Some(self.view_text(&self.camera)).filter(|text| *text != self.view_text(&Camera::default())),
            "ride" => self.ride.then(|| "1".into()),
            "wind" => Some(format_wind(s.wind)).filter(|text| *text != format_wind(default.wind)),
            "bft" => s.beaufort.map(|grade| grade.to_string()),
            "spectrum" => (s.spectrum != default.spectrum).then(|| name_of(&Spectrum::ALL, s.spectrum)),
            "fetch" => s.fetch_km.map(|km| decimal(km, 3)),
            "swell" => s.swell.map(format_swell),
            "chop" => Some(decimal(s.chop, 3)).filter(|text| text != "1"),
            "foam" => Some(format_foam(s.foam)).filter(|text| text != "1"),
            "haze" => Some(decimal(s.haze, 3)).filter(|text| *text != decimal(default.haze, 3)),
            "clouds" => s.clouds.map(|cover| decimal(cover, 3)),
            "water" => Some(format_water(s.water, s.water_density_per_m)).filter(|text| text != "auto"),
            "surf" => Some(format_surf(s.surf)).filter(|text| text != "1"),
            "time" => (self.time != SceneTime::Now).then(|| self.time.to_string()),
            "rate" => Some(decimal(self.rate, 6)).filter(|text| text != "1"),
            "seed" => (s.seed != default.seed).then(|| s.seed.to_string()),
            "mesh" => (s.mesh != default.mesh).then(|| format_mesh(s.mesh, s.triangles)),
            "quality" => (s.quality != default.quality).then(|| name_of(&Quality::ALL, s.quality)),
            "datum" => (s.datum != default.datum).then(|| name_of(&Datum::ALL, s.datum)),
            "layers" => Some(s.layers.to_ids()).filter(|ids| !ids.is_empty()),
            _ => None,
        }
    }
}
