//! The sea that somebody draws, rides or measures, with what has been made of it. Whoever does so owns one [`Seas`].
//!
//! By default all is made when it is asked for: a picture, a sample and a test want the sea of their settings. A program whose settings
//! move while it draws has the work spread over its frames instead ([`Seas::spread`], [`Seas::begin`]):
//!
//! ```text
//!  settings move  ──►  new waves, a part a frame   ──►  drawn from then on   ──►  thresholds of foam, a part a frame
//!                      the last sea is drawn on         (first on patches of       until then those of a sixteenth
//!                                                       256², then on finer ones)  of their points
//! ```

use std::sync::Arc;

use crate::data::exposure::Water;
use crate::model::drawn_patches::DrawnPatches;
use crate::model::lift::Lift;
use crate::model::moved_water::Place;
use crate::model::sea_tables::SeaTables;
use crate::model::wave_data::{Making, WaveData};
use crate::model::waves;
use crate::scene::sea::foam::Whitecaps;
use crate::scene::sea::shelter::{Shelter, behind_reefs, of_patches};
use crate::scene::sea::tables::{patch_samples, sea_of};
use crate::scene::sea::thresholds::Thresholds;
use crate::scene::settings::{Foam, Settings};

/// Samples along a side of the patches that a new sea is first drawn on, where its quality asks for more.
const FIRST_SAMPLES: usize = 256;
/// Work on waves in a frame, see [`Making::advance`]: some 10 ms of a desktop's core, a third of the waves of 256² samples.
pub const WAVE_WORK: usize = 1 << 16;

/// What has been done so far; for tests and measurements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Evaluations of a spectrum for amplitudes.
    pub evaluations: usize,
    /// Steps that waves were moved on by for the thresholds of foam.
    pub wave_steps: usize,
    /// Places whose water was lifted wave by wave.
    pub lifted: usize,
}

/// The last sea that was asked for, the one that is drawn, and what has been made of them.
#[derive(Default)]
pub struct Seas {
    is_spread: bool,
    asked: Option<(Settings, Arc<SeaTables>)>,
    drawn: Option<Arc<SeaTables>>,
    waves: Option<(Arc<SeaTables>, Arc<WaveData>)>,
    making: Option<(Arc<SeaTables>, Making)>,
    thresholds: Thresholds,
    lift: Option<(Arc<SeaTables>, Lift)>,
    /// The last height and where and when it was: wind, latitude, longitude, tick, gains of the waves.
    height: Option<(Arc<SeaTables>, [u64; 8], f64)>,
    patches: Option<(Arc<SeaTables>, u64, Arc<DrawnPatches>)>,
    revision: u64,
    work: Work,
    /// A place, latitude and longitude, and what coral reefs leave of the waves' height there, which the world tells.
    reef: Option<[f64; 3]>,
    /// Where land stands in its way.
    pub shelter: Shelter,
}

impl Seas {
    /// Spreads what a change of the settings costs over the frames that follow, each of which says [`Seas::begin`].
    pub fn spread(&mut self) {
        self.is_spread = true;
    }

    /// Whether work is spread over frames.
    pub fn is_spread(&self) -> bool {
        self.is_spread
    }

    /// The tables of the sea that `settings` ask for.
    pub fn tables(&mut self, settings: &Settings) -> Arc<SeaTables> {
        if let Some((asked, tables)) = &self.asked
            && asked == settings
        {
            return tables.clone();
        }
        let (sea, n) = (sea_of(settings), patch_samples(settings.quality));
        let known = self.asked.take().map(|(_, tables)| tables);
        let known = known.filter(|tables| tables.sea == sea && tables.cascades[0].n == n);
        let tables = known.unwrap_or_else(|| Arc::new(SeaTables::new(sea, n)));
        self.asked = Some((settings.clone(), tables.clone()));
        tables
    }

    /// The sea to draw under `settings`: theirs, or, with the work spread, the last one whose waves have been made.
    pub fn drawn(&mut self, settings: &Settings) -> Arc<SeaTables> {
        match &self.drawn {
            Some(drawn) if self.is_spread => drawn.clone(),
            None if self.is_spread => {
                self.begin(settings);
                self.drawn(settings)
            }
            _ => self.tables(settings),
        }
    }

    /// Begins a frame under `settings` and does its part of the spread work.
    pub fn begin(&mut self, settings: &Settings) {
        if !self.is_spread {
            return;
        }
        let asked = self.tables(settings);
        match &self.drawn {
            Some(drawn) if *drawn == asked => self.making = None,
            // Its waves are there: another chop, or a sea that came back.
            _ if self.waves.as_ref().is_some_and(|(of, _)| of.has_waves_of(&asked)) => self.draw(asked),
            _ => self.make(settings, &asked),
        }
        if self.thresholds.advance(&mut self.work.wave_steps) {
            self.revision += 1;
        }
    }

    /// Goes on making the waves of the sea that is asked for. What has been begun on coarse patches is finished first, so that the sea
    /// follows a hand that never rests; what has been begun on fine ones is not.
    fn make(&mut self, settings: &Settings, asked: &Arc<SeaTables>) {
        let is_known = |of: &Arc<SeaTables>| of.sea == asked.sea;
        let begun = self.making.take().filter(|(of, _)| of.cascades[0].n <= FIRST_SAMPLES || of == asked);
        let (tables, mut making) = begun.unwrap_or_else(|| {
            let first = FIRST_SAMPLES.min(patch_samples(settings.quality));
            let is_first = !self.drawn.as_ref().is_some_and(is_known);
            let tables = if is_first && first < asked.cascades[0].n {
                Arc::new(SeaTables::new(asked.sea, first))
            } else {
                asked.clone()
            };
            let making = Making::new(&tables, self.frequencies(&tables));
            (tables, making)
        });
        // The first of all is waited for: there is nothing else to draw.
        self.work.evaluations += making.advance(if self.drawn.is_some() { WAVE_WORK } else { usize::MAX });
        if making.is_complete() {
            self.waves = Some((tables.clone(), Arc::new(making.finish())));
            self.draw(tables);
        } else {
            self.making = Some((tables, making));
        }
    }

    fn draw(&mut self, sea: Arc<SeaTables>) {
        self.drawn = Some(sea);
        self.revision += 1;
    }

    /// The frequencies of a sea, where the last one had the same.
    fn frequencies(&self, tables: &SeaTables) -> Option<Arc<Vec<[u32; 2]>>> {
        let (of, data) = self.waves.as_ref()?;
        let same = of.cascades == tables.cascades && of.sea.depth_m == tables.sea.depth_m;
        same.then(|| data.frequencies.clone())
    }

    /// Whether frames to come will show more of the sea that was asked for last.
    pub fn is_busy(&self) -> bool {
        let is_behind = self.asked.as_ref().is_some_and(|(_, asked)| self.drawn.as_ref() != Some(asked));
        self.is_spread && (is_behind || self.thresholds.is_busy())
    }

    /// A number that changes when a spread work has come to another result: the same settings then look different.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// What has been done so far.
    pub fn work(&self) -> Work {
        self.work
    }

    /// The waves of a sea; they are made now unless they are its last one's.
    pub fn waves(&mut self, tables: &Arc<SeaTables>) -> Arc<WaveData> {
        if let Some((of, data)) = &self.waves
            && (Arc::ptr_eq(of, tables) || of.has_waves_of(tables))
        {
            return data.clone();
        }
        let mut making = Making::new(tables, self.frequencies(tables));
        self.work.evaluations += making.advance(usize::MAX);
        let data = Arc::new(making.finish());
        self.waves = Some((tables.clone(), data.clone()));
        data
    }

    /// The whitecaps of a sea; `on_map`: where a foam map is drawn, whose thresholds cost most of it.
    pub fn whitecaps(&mut self, foam: Foam, sea: &Arc<SeaTables>, on_map: bool) -> Whitecaps {
        let mut whitecaps = Whitecaps::without_map(foam, sea);
        if on_map {
            let thresholds = &mut self.thresholds;
            whitecaps.folds =
                thresholds.of(sea, whitecaps.share, foam.lifetime_s, self.is_spread, &mut self.work.wave_steps);
        } else {
            self.thresholds.rest();
        }
        whitecaps
    }

    /// What coral reefs leave of the waves' height at a place, until another is told.
    pub fn tell_reef(&mut self, lat: f64, lon: f64, left: f64) {
        self.reef = Some([lat, lon, left]);
    }

    /// What they leave there, as far as it has been told.
    pub fn left_by_reefs(&self, lat: f64, lon: f64) -> f64 {
        self.reef
            .filter(|&[known_lat, known_lon, _]| known_lat == lat && known_lon == lon)
            .map_or(1.0, |[.., left]| left)
    }

    /// Height in metres of the drawn water over the ellipsoid at geodetic `lat`, `lon`, radians.
    pub fn height_at(&mut self, settings: &Settings, lat: f64, lon: f64, unix_seconds: f64) -> f64 {
        let tables = self.drawn(settings);
        if tables.sea.hs_m == 0.0 {
            return 0.0;
        }
        let ticks = waves::ticks_from_unix(unix_seconds);
        let sheltered = of_patches(self.shelter.around(Water::Ocean, lat, lon));
        let gains = behind_reefs(sheltered, self.left_by_reefs(lat, lon));
        let [a, b, c, d] = gains.map(f64::to_bits);
        let place = [settings.wind_from().to_bits(), lat.to_bits(), lon.to_bits(), ticks, a, b, c, d];
        if let Some((of, known, height_m)) = &self.height
            && *known == place
            && *of == tables
        {
            return *height_m;
        }
        if self.lift.as_ref().is_none_or(|(of, _)| !of.has_waves_of(&tables)) {
            let data = self.waves(&tables);
            self.lift = Some((tables.clone(), Lift::new(&tables, &data)));
        }
        let lifted = self.lift.as_ref().map_or(0.0, |(_, lift)| {
            lift.height(&Place::new(&tables, settings.wind_from(), lat, lon), tables.sea.chop, ticks, gains)
        });
        self.work.lifted += 1;
        let height_m = lifted - tables.level_in_m(gains);
        self.height = Some((tables, place, height_m));
        height_m
    }

    /// The wave patches of a sea at a tick of the wave clock.
    pub fn patches(&mut self, tables: &Arc<SeaTables>, ticks: u64) -> Arc<DrawnPatches> {
        if let Some((of, at, patches)) = &self.patches
            && *at == ticks
            && of.has_waves_of(tables)
        {
            return patches.clone();
        }
        let patches = Arc::new(DrawnPatches::new(tables.cascades, &self.waves(tables), ticks));
        self.patches = Some((tables.clone(), ticks, patches.clone()));
        patches
    }
}
