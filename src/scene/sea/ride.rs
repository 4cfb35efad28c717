//! The eye over the moving water: its altitude counted from the surface at its place instead of from the ellipsoid.

use std::sync::{Arc, Mutex, PoisonError};

use crate::model::lift::Lift;
use crate::model::moved_water::Place;
use crate::model::sea_tables::SeaTables;
use crate::model::waves;
use crate::scene::settings::Settings;
use crate::scene::view::camera::Camera;
use crate::scene::view::state::ViewState;

/// Height in metres of the drawn surface over the ellipsoid under the eye.
pub fn surface_height(settings: &Settings, camera: &Camera, unix_seconds: f64) -> f64 {
    type Kept = (Arc<SeaTables>, Vec<Lift>);
    static LAST: Mutex<Option<Kept>> = Mutex::new(None);
    let tables = SeaTables::of(settings);
    if tables.sea.hs_m == 0.0 {
        return 0.0;
    }
    let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
    let (_, lifts) = match last.take().filter(|(kept, _)| *kept == tables) {
        Some(kept) => last.insert(kept),
        None => {
            let lift = |(index, cascade)| Lift::new(&tables, index, cascade);
            let lifts = tables.cascades.iter().enumerate().map(lift).collect();
            last.insert((tables.clone(), lifts))
        }
    };
    let ticks = waves::ticks_from_unix(unix_seconds);
    let evolved: Vec<_> = lifts.iter().map(|lift| lift.evolved(ticks)).collect();
    let place = Place::new(&tables, settings.wind_from(), camera.lat, camera.lon);
    let tile = |index: usize, at| lifts[index].motion(&evolved[index], at);
    place.invert(tables.sea.chop, tile).1.height - tables.chop_level_m
}

impl ViewState {
    /// The eye at an instant: the camera, lifted onto the moving surface when it rides.
    pub fn eye(&self, unix_seconds: f64) -> Camera {
        if !self.ride {
            return self.camera;
        }
        let lift = surface_height(&self.settings, &self.camera, unix_seconds);
        Camera { altitude_m: self.camera.altitude_m + lift, ..self.camera }
    }
}
