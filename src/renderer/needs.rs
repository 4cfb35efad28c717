//! What a frame needs of the world before it can be drawn, tiles, lees and waves by shores, and where its eye can be.

use super::Renderer;
use super::side::Side;
use crate::data::exposure::Water;
use crate::data::sample::Sample;
use crate::data::tile::{Layer, Projection};
use crate::data::world::{World, WorldWaters};
use crate::model::earth::WGS84;
use crate::model::optics::opaque_depth_m;
use crate::model::waves;
use crate::scene::frame::Frame;
use crate::scene::frame::uniform::SHOWS_SEA;
use crate::scene::sea::shores::ShoreWaves;
use crate::scene::settings::Settings;
use crate::scene::view::camera::{Camera, LOWEST_M, OVER_BED_M};
use crate::scene::view::map_tiles::{Hiding, drawn_tiles, wanted_tiles};
use crate::scene::view::navigate::above_ground;
use crate::scene::view::state::ViewState;

/// Seconds that a frame may always spend on finding where land stands in the sea's way, and again on making windows of waves by shores, of a moving
/// picture and of a still one; a step that has been begun takes as long again.
const WORK_S: [f64; 2] = [0.003, 0.03];
/// Shares of the time that pictures take, which it may spend where that is more, up to so many seconds: where they take long a shore would be without its surf for minutes.
const WORK_SHARE: [f64; 2] = [0.1, 0.25];
const MOST_WORK_S: [f64; 2] = [0.05, 0.25];

/// Half a diagonal of the narrowest cells of hilly ground, metres, and how deep a hollow may be that they span.
const HALF_CHORD_M: f64 = 6.7;
const DEEPEST_HOLLOW_M: f64 = 10.0;

/// Eyes below this are told at what level inland water lies, m: a picture from higher shows no such step, and needs no more tiles than its own.
const LEVELS_FROM_M: f64 = 50_000.0;

impl Renderer {
    /// Asks for the tiles that a frame needs; true when all have come (or will never come).
    pub fn load(&mut self, frame: &Frame) -> bool {
        let camera = &frame.camera;
        let work_s = work_s(self.moving, self.picture_s);
        self.tiles.take_tiles(&self.gpu, &self.streaming.receive(&mut self.world));
        let wanted = wanted_tiles(camera, frame.size, &self.streaming);
        let is_sheltered = self.shelter(frame, work_s);
        // An eye that does not know yet at what level the lake below it lies is not where it will be.
        let is_settled = is_sheltered && self.knows_ground;
        self.complete = self.streaming.want(&mut self.world, &wanted, camera.geodetic()) && is_settled;
        self.tiles.take_pages(&self.gpu, &mut self.streaming.pages);
        let hiding = self.hiding(frame);
        self.visible = (!frame.is_globe()).then(|| {
            let foot = self.place_below(camera).filter(|place| place.depth_m.is_none());
            let foot_m = foot.map(|place| place.elevation_m);
            drawn_tiles(camera, frame.size, &self.streaming, hiding, frame.wider_ground(), foot_m)
        });
        let side = self.side(frame);
        // What is there stays; others wait for the picture's own tiles.
        let trains = (side.shows_surf && frame.shows_trains && frame.is_fine(), self.complete);
        let seconds = if self.seas.is_spread() { work_s } else { f64::INFINITY };
        self.complete &= self.shores.prepare(&mut self.world, frame, trains, seconds);
        self.complete
    }

    /// Finds where land stands in the way of a frame's sea; true when that is known.
    fn shelter(&mut self, frame: &Frame, budget_s: f64) -> bool {
        let (camera, world) = (&frame.camera, &mut self.world);
        let mut waters = WorldWaters::new(world, World::look_or_parent);
        let eye = (camera.lat, camera.lon, camera.altitude_m);
        self.seas.shelter.advance((&frame.sea, frame.wind_from), eye, budget_s, &mut waters)
    }

    /// How the sea of a frame hides its bed: not where the sea is not drawn, nor from an eye in it.
    fn hiding(&mut self, frame: &Frame) -> Option<Hiding> {
        let side = self.side(frame);
        let covers = frame.uniform.layers & SHOWS_SEA != 0 && !side.kind.under_water;
        let depth_m = opaque_depth_m(f64::from(frame.uniform.water_density));
        let beach_slope = f64::from(frame.uniform.shore.x);
        covers.then(|| Hiding { depth_m, resolution_m: self.resolution_m(), beach_slope })
    }

    /// How wide a cell of the terrain's source is, metres.
    pub(super) fn resolution_m(&self) -> f64 {
        self.world.resolution_m(Layer::Terrain, Projection::Mercator).unwrap_or(9_277.0)
    }

    /// What is below an eye: from afar as the tiles at hand have it, near with the level of inland water there, whose tiles are asked for.
    pub fn place_below(&mut self, eye: &Camera) -> Option<Sample> {
        let (lat, lon) = (eye.lat, eye.lon);
        if eye.altitude_m < LEVELS_FROM_M {
            self.world.sample_resident(lat, lon)
        } else {
            self.world.sample_passing(lat, lon)
        }
    }

    /// Whether what [`Renderer::place_below`] last told of an eye has the level of the water there, as far as that matters.
    pub fn knows_level_below(&self, eye: &Camera) -> bool {
        eye.altitude_m >= LEVELS_FROM_M || self.world.knows_level(eye.lat, eye.lon)
    }

    /// Where the eye of a frame is.
    pub(super) fn side(&mut self, frame: &Frame) -> Side {
        let (lat, lon) = (frame.camera.lat, frame.camera.lon);
        let place = self.place_below(&frame.camera);
        let shore = place.as_ref().and_then(|place| self.shore_waves(place, (lat, lon), frame.ticks()));
        Side::of(frame, place.as_ref(), shore.as_ref(), [self.blends, self.gpu.software])
    }

    /// The trains of waves of a shore at a place, where their windows are there.
    fn shore_waves(&self, place: &Sample, at: (f64, f64), ticks: u64) -> Option<ShoreWaves> {
        self.shores.waves_at(at, place.shallows()?, ticks)
    }

    /// About how high the mesh of land, or of water in it, stands below an eye, of what is at its foot, metres: over hollows narrower than its cells it is a chord.
    fn mesh_below(&mut self, eye: &Camera, place: &Sample) -> f64 {
        if eye.altitude_m > place.elevation_m + DEEPEST_HOLLOW_M {
            return place.elevation_m;
        }
        let north = HALF_CHORD_M / WGS84.a;
        let east = north / eye.lat.cos().max(0.01);
        let ways = [(1.0, 0.0), (0.0, 1.0), (0.7, 0.7), (0.7, -0.7)];
        let chords = ways.map(|(x, y)| {
            let end = |side: f64| self.world.sample_resident(eye.lat + side * y * north, eye.lon + side * x * east);
            let ends = [1.0, -1.0].map(end).map(|end| end.map_or(place.elevation_m, |end| end.elevation_m));
            0.5 * (ends[0] + ends[1])
        });
        // Where it is asked for no more it is no step.
        chords.into_iter().fold(place.elevation_m, f64::max).min(place.elevation_m + DEEPEST_HOLLOW_M - LOWEST_M)
    }

    /// A camera lifted by a part of the drawn water's height below it, as [`Seas::lifted`](crate::scene::sea::Seas::lifted).
    pub fn lifted(&mut self, settings: &Settings, camera: &Camera, part: f64, unix_seconds: f64) -> Camera {
        if let Some(place) = self.place_below(camera) {
            self.seas.tell_reef(camera.lat, camera.lon, place.waves_left);
        }
        self.seas.lifted(settings, camera, part, unix_seconds)
    }

    /// The eye that a state asks for, where it can be: a metre over the ground and the waves, or, for a negative altitude over
    /// the ocean, in the water above its bed.
    pub fn eye(&mut self, state: &ViewState, unix_seconds: f64) -> Camera {
        let asked = state.camera;
        self.world.set_beach_slope(state.settings.surf.beach_slope);
        let place = self.place_below(&asked);
        self.knows_ground = place.is_none() || self.knows_level_below(&asked);
        let Some(place) = place else {
            return self.seas.eye(state, unix_seconds);
        };
        let Some(depth_m) = place.depth_m else {
            if !place.is_moving_lake || !state.settings.quality.is_fine() {
                return above_ground(&asked, self.mesh_below(&asked, &place));
            }
            // Over the crests of a lake whose surface is drawn.
            let sea = self.seas.drawn(&state.settings);
            let share = self.seas.shelter.hs_m(&sea, Water::Lake, asked.lat, asked.lon) / sea.sea.hs_m.max(1e-3);
            return above_ground(&asked, place.elevation_m + share * sea.crest_m());
        };
        self.seas.tell_reef(asked.lat, asked.lon, place.waves_left);
        let ridden = self.seas.eye(state, unix_seconds);
        let crest_m = self.seas.drawn(&state.settings).crest_m();
        let lowest_m = if !state.ride && (0.0..crest_m + LOWEST_M).contains(&asked.altitude_m) {
            let shore = self.shore_waves(&place, (asked.lat, asked.lon), waves::ticks_from_unix(unix_seconds));
            let (level, rise_m) = shore.map_or((1.0, 0.0), |shore| (shore.level, shore.wave.rise));
            level * self.seas.surface_height(&state.settings, &asked, unix_seconds) + rise_m + LOWEST_M
        } else {
            OVER_BED_M - depth_m
        };
        Camera { altitude_m: ridden.altitude_m.max(lowest_m), ..ridden }
    }
}

/// Seconds that a frame may spend on work of one kind, where pictures take `picture_s`.
fn work_s(moving: bool, picture_s: f64) -> f64 {
    let still = usize::from(!moving);
    (WORK_SHARE[still] * picture_s).clamp(WORK_S[still], MOST_WORK_S[still])
}

#[cfg(test)]
mod tests {
    use super::work_s;

    #[test]
    fn slow_pictures_leave_more_time_for_work_and_quick_ones_no_less() {
        let of = |picture_s| [work_s(true, picture_s), work_s(false, picture_s)];
        assert_eq!(of(0.0), [0.003, 0.03]);
        assert_eq!(of(0.016), [0.003, 0.03], "as long as ever on a graphics card");
        assert_eq!(of(0.25), [0.025, 0.0625], "a tenth and a quarter");
        assert_eq!(of(f64::INFINITY), [0.05, 0.25]);
    }
}
