//! The trains of waves near the shores around the eye: which windows of coast are wanted, what has been made of them, and how the sea of the
//! patches is handed over to them.
//!
//! ```text
//!  +-----+-----+-----+    A window belongs to a tile of the map (4.9 km at the equator) and is twice as wide, so that waves have half a
//!  |   ┌─┼─────┼─┐   |    tile to bend before they come into it. Beside the tile's edges two windows blend, over a fifth of the tile.
//!  |   │ | own | │   |    What a window holds depends on its tile, the sea and the wind alone.
//!  +---┼-+-----+-┼---+
//! ```
//! The trains take over by depth and by the distance to the shore, with as much of the energy as the patches give up; far from the eye they
//! go. A window is made a step at a time: one round of one train, some milliseconds.

use std::collections::HashMap;
use std::sync::Arc;

use crate::data::fetch::now_s;
use crate::data::tile::{EQUATOR_M, MapPoint, POLAR_LATITUDE_DEG, Projection};
use crate::data::world::{SHORE_LEVEL, SHORE_SIDE, World};
use crate::model::sea::Sea;
use crate::model::sea_tables::SeaTables;
use crate::model::shore_waves::{ADDED, ADDED_BY_DEAN, Arrivals, Bed, Following, SHALLOWEST_M};
use crate::model::wave_trains::{TAKEN, TRAINS, Train, taken_m2, trains};
use crate::model::{surf, surface, swash, waves};
use crate::scene::frame::Frame;
use crate::scene::view::camera::Camera;

mod at_place;

pub use at_place::ShoreWaves;

/// Windows that the GPU holds, and that are kept, a mebibyte each: no eye wants more than 21, and all of them are to take less than 64 MB.
pub const SLOTS: usize = 24;
/// Tiles that are known to have no waves, at most.
const MOST_EMPTY: usize = 128;
/// ω²h/g from which on waves are free of the bottom, and below which the trains alone carry them: a third and a fifth of their length deep.
const HANDOVER: [f64; 2] = [1.2, 2.4];
/// No trains are farther from the shore, m.
const SHORES_END_M: f64 = 4_000.0;
/// Nor from the eye, m, or tiles.
const REACH: [f64; 2] = [6_000.0, 1.5];
/// Where in the buffer the table of windows and their nodes stand, words of eight bytes.
const TABLE: usize = 32;
/// See [`TABLE`].
const NODES: usize = 128;

/// Words of the buffer.
pub const WORDS: usize = NODES + SLOTS * SHORE_SIDE * SHORE_SIDE * TRAINS;
/// Words that change with time.
pub type Header = [[u32; 2]; NODES];

/// Numbers of `shaders/lib/shore_trains.wgsl` and `breakers.wgsl`.
pub fn shared_constants() -> String {
    let whole = [
        ("SHORE_LEVEL", usize::from(SHORE_LEVEL)),
        ("SHORE_SIDE", SHORE_SIDE),
        ("SHORE_TRAINS", TRAINS),
        ("SHORE_TABLE", TABLE),
        ("SHORE_NODES", NODES),
        ("SWASH_CRESTS", swash::CRESTS),
        ("SWASH_STEPS", swash::STEPS),
    ];
    let numbers = [
        ("PHASE_ADDED", ADDED),
        ("PHASE_ADDED_BY_DEAN", ADDED_BY_DEAN),
        ("SHALLOWEST", SHALLOWEST_M),
        ("FEELS_BOTTOM", HANDOVER[0]),
        ("FREE_OF_BOTTOM", HANDOVER[1]),
        ("SHORES_END", SHORES_END_M),
        ("TRAINS_TAKE_FIRST", TAKEN[0] * TAKEN[0]),
        ("TRAINS_TAKE_SECOND", TAKEN[1] * TAKEN[1]),
        ("BREAKER_DECAY", surf::DECAY),
        ("BREAKER_STABLE", surf::STABLE),
        ("BREAKER_LEAST_INDEX", surf::LEAST_INDEX),
        ("BREAKER_BORE", surf::BORE),
        ("BREAKER_PLUNGES", surf::PLUNGES[0]),
        ("BREAKER_PLUNGING", surf::PLUNGES[1]),
        ("BREAKER_SURGES", surf::SURGES[0]),
        ("BREAKER_SURGING", surf::SURGES[1]),
        ("BREAKER_BORE_LAST", surf::BORE_WITHIN[0]),
        ("BREAKER_BORE_FIRST", surf::BORE_WITHIN[1]),
        ("BREAKER_BORE_PLUNGING", surf::BORE_OF_PLUNGING),
        ("SWASH_STEEPEST", swash::STEEPEST),
        ("SWASH_SHINES", swash::SHINES_S),
        ("SWASH_FLAT", swash::FLAT[0]),
        ("SWASH_NOT_FLAT", swash::FLAT[1]),
        ("SWASH_FLAT_RUNUP", swash::FLAT_RUNUP),
        ("SWASH_FIFTIETH", swash::RAYLEIGH_FIFTIETH),
    ];
    let whole = whole.map(|(name, number)| format!("const {name} = {number}u;\n"));
    let numbers = numbers.map(|(name, number)| format!("const {name}: f32 = {number:?};\n"));
    whole.concat() + &numbers.concat()
}

/// A window's tile of [`SHORE_LEVEL`]: column and row.
pub type Tile = [u32; 2];

enum Window {
    Making {
        bed: Box<Bed>,
        following: Option<Box<Following>>,
        done: Vec<Arrivals>,
    },
    /// Its nodes, as the GPU has them.
    Ready(Arc<Vec<[u32; 2]>>),
    /// No waves: no shore, or no water.
    Empty,
}

impl Window {
    fn is_making(&self) -> bool {
        matches!(self, Self::Making { .. })
    }

    /// Bytes that it holds.
    fn bytes(&self) -> usize {
        match self {
            Self::Making { bed, following, done } => {
                let following = following.as_ref().map_or(0, |following| following.bytes());
                bed.bytes() + following + done.iter().map(Arrivals::bytes).sum::<usize>()
            }
            Self::Ready(nodes) => size_of::<[u32; 2]>() * nodes.capacity(),
            Self::Empty => 0,
        }
    }
}

/// See above.
#[derive(Default)]
pub struct Shores {
    /// The sea, the bearing that its wind comes from, and the slope of beaches.
    sea: Option<(Arc<SeaTables>, [f64; 2])>,
    trains: Option<[Train; TRAINS]>,
    taken_m2: f64,
    windows: HashMap<Tile, Window>,
    /// Those around the eye, the nearest first.
    wanted: Vec<Tile>,
}

impl Shores {
    /// Brings the windows around a frame's eye on, for some seconds or a step; true when all are there. `shows`: whether the frame shows surf;
    /// `may_begin`: whether others are begun than those that are there.
    pub fn prepare(
        &mut self,
        world: &mut World,
        frame: &Frame,
        (shows, may_begin): (bool, bool),
        seconds: f64,
    ) -> bool {
        let Camera { lat, lon, altitude_m, .. } = frame.camera;
        let reach_m = (reach_m(lat).powi(2) - altitude_m * altitude_m).max(0.0).sqrt();
        let tiles = if shows { around(lat, lon, reach_m) } else { Vec::new() };
        self.prepare_tiles(world, (&frame.sea, frame.wind_from), (tiles, may_begin), seconds)
    }

    /// As [`Shores::prepare`], for a place, geodetic radians, in a sea whose wind comes from a bearing in radians.
    pub fn prepare_at(&mut self, world: &mut World, sea: (&Arc<SeaTables>, f64), lat: f64, lon: f64) -> bool {
        self.prepare_tiles(world, sea, (around(lat, lon, 1.0), true), f64::INFINITY)
    }

    fn prepare_tiles(
        &mut self,
        world: &mut World,
        (sea, wind_from): (&Arc<SeaTables>, f64),
        (tiles, may_begin): (Vec<Tile>, bool),
        seconds: f64,
    ) -> bool {
        self.wanted.clear();
        if tiles.is_empty() || sea.sea.hs_m == 0.0 {
            return true;
        }
        // To windows the number of samples is no matter, nor is the chop.
        let of = [wind_from, world.beach_slope()];
        let is_same = |(kept, kept_of): &(Arc<SeaTables>, [f64; 2])| {
            let same =
                Sea { chop: kept.sea.chop, ..sea.sea } == kept.sea && kept.cascades[1].k_max == sea.cascades[1].k_max;
            *kept_of == of && same
        };
        if !self.sea.as_ref().is_some_and(is_same) {
            self.windows.clear();
            self.trains = trains(sea);
            self.taken_m2 = taken_m2(sea);
        }
        self.sea = Some((sea.clone(), of));
        let Some(trains) = self.trains else { return true };
        self.wanted = tiles;
        let wanted = &self.wanted;
        let has_many = self.windows.len() > MOST_EMPTY + SLOTS;
        self.windows.retain(|tile, window| match window {
            Window::Making { .. } => wanted.contains(tile),
            Window::Ready(_) => true,
            Window::Empty => !has_many || wanted.contains(tile),
        });
        // One is made at a time, and what has been begun is finished first.
        let mut tiles = self.wanted.clone();
        tiles.sort_by_key(|tile| !self.windows.get(tile).is_some_and(Window::is_making));
        let end = now_s() + seconds;
        let mut is_first = true;
        let mut may_go_on = || std::mem::take(&mut is_first) || now_s() < end;
        let mut complete = true;
        for tile in tiles {
            if !self.windows.contains_key(&tile) {
                if !may_begin || !may_go_on() {
                    complete = false;
                    continue;
                }
                let Some(bed) = world.shore_bed(tile) else {
                    complete = false;
                    continue;
                };
                let window = begun(bed);
                if window.is_making() {
                    self.make_room();
                }
                self.windows.insert(tile, window);
            }
            while let Some(window @ Window::Making { .. }) = self.windows.get_mut(&tile) {
                if !may_go_on() {
                    return false;
                }
                advance(window, &trains, wind_from);
            }
        }
        world.send();
        complete
    }

    /// Lets the farthest windows go that nobody wants, if there are as many as are kept.
    fn make_room(&mut self) {
        let across = 1i64 << SHORE_LEVEL;
        let kept = |(tile, window): (&Tile, &Window)| (!matches!(window, Window::Empty)).then_some(*tile);
        while self.windows.iter().filter_map(kept).count() >= SLOTS {
            let away = |tile: &Tile| {
                let eye = self.wanted[0];
                let [x, y] = [0, 1].map(|axis| (i64::from(tile[axis]) - i64::from(eye[axis])).abs());
                (x.min(across - x).max(y), *tile)
            };
            let spare = self.windows.iter().filter_map(kept).filter(|tile| !self.wanted.contains(tile));
            let Some(farthest) = spare.max_by_key(away) else { return };
            self.windows.remove(&farthest);
        }
    }

    /// Bytes of all windows that are kept or being made.
    pub fn bytes(&self) -> usize {
        self.windows.values().map(Window::bytes).sum()
    }

    /// Windows around the eye that hold waves, with their nodes, the nearest first.
    pub fn ready(&self) -> impl Iterator<Item = (Tile, &Arc<Vec<[u32; 2]>>)> {
        self.wanted.iter().filter_map(|tile| match self.windows.get(tile) {
            Some(Window::Ready(nodes)) => Some((*tile, nodes)),
            _ => None,
        })
    }

    /// Share of a sea's energy that is the trains'.
    fn taken_share(&self, sea: &SeaTables) -> f64 {
        (16.0 * self.taken_m2 / (sea.sea.hs_m * sea.sea.hs_m)).min(1.0)
    }

    /// The words that change with time; `slots` says where the nodes of windows are, and by which share of their energy these are there.
    pub fn header(&self, frame: &Frame, slots: impl Iterator<Item = (Tile, usize, f64)>) -> Header {
        let mut words = [[0; 2]; NODES];
        // A sea without trains has none of their energy: they reach no eye.
        words[0] = [1f32, 1e-3].map(f32::to_bits);
        // Shaders divide by their frequencies.
        (0..TRAINS).for_each(|train| words[1 + 2 * train] = [1f32, 0.0].map(f32::to_bits));
        words[TABLE - 1] = [0f32, 1.0].map(f32::to_bits);
        // Tiles of no window.
        words[TABLE..TABLE + 64].fill([u32::MAX, 0]);
        let (Some(trains), false) = (&self.trains, self.wanted.is_empty()) else { return words };
        let rates = rates(trains);
        words[0] = [rates.mean, reach_m(frame.camera.lat)].map(|x| (x as f32).to_bits());
        for (index, train) in trains.iter().enumerate() {
            let phase = surface::phase_at(waves::cycles_per_tick(train.omega), frame.ticks());
            words[1 + 2 * index] = [train.omega, train.amplitude_m].map(|x| (x as f32).to_bits());
            words[2 + 2 * index] = [(phase as f32).to_bits(), 0];
        }
        words[TABLE - 1] = [self.taken_share(&frame.sea), rates.growing].map(|x| (x as f32).to_bits());
        for ([x, y], slot, share) in slots {
            words[TABLE + (y as usize & 7) * 8 + (x as usize & 7)] =
                [x | (y << 16), (slot as u32 + 1) | (((65_535.0 * share) as u32) << 16)];
        }
        words
    }
}

fn tile_m(lat: f64) -> f64 {
    EQUATOR_M * libm::cos(lat) / f64::from(1u32 << SHORE_LEVEL)
}

/// How far from the eye trains are seen, m: no farther than seven tiles around it tell.
fn reach_m(lat: f64) -> f64 {
    REACH[0].min(REACH[1] * tile_m(lat))
}

/// Their frequencies.
fn rates(trains: &[Train; TRAINS]) -> surf::Rates {
    surf::Rates::of(trains.iter().map(|train| train.omega))
}

/// Tiles of which something may show within a distance, the nearest first.
fn around(lat: f64, lon: f64, reach_m: f64) -> Vec<Tile> {
    let reach = reach_m / tile_m(lat);
    if reach == 0.0 || lat.abs() > (POLAR_LATITUDE_DEG - 0.5).to_radians() {
        return Vec::new();
    }
    let across = f64::from(1u32 << SHORE_LEVEL);
    let point = MapPoint::on(Projection::Mercator, lat, lon);
    let eye = [point.u, point.v].map(|at| f64::from(at) / 4_294_967_296.0 * across);
    let [x, y] = eye.map(|at| at.floor() as i64);
    let mut found: Vec<(f64, Tile)> = Vec::new();
    for (i, j) in (x - 3..=x + 3).flat_map(|i| (y - 3..=y + 3).map(move |j| (i, j))) {
        // A window serves a tenth of a tile beyond its own.
        let beside = |at: f64, low: i64| (low as f64 - 0.1 - at).max(at - low as f64 - 1.1).max(0.0);
        let away = libm::hypot(beside(eye[0], i), beside(eye[1], j));
        if away < reach && (0..across as i64).contains(&j) {
            let middle = libm::hypot(i as f64 + 0.5 - eye[0], j as f64 + 0.5 - eye[1]);
            found.push((middle, [i.rem_euclid(across as i64) as u32, j as u32]));
        }
    }
    found.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    found.into_iter().take(SLOTS).map(|(_, tile)| tile).collect()
}

/// A window whose bed is known.
fn begun(bed: Bed) -> Window {
    let is_coast = bed.shore_m.iter().any(|shore| (0.0..SHORES_END_M).contains(shore));
    if is_coast { Window::Making { bed: Box::new(bed), following: None, done: Vec::new() } } else { Window::Empty }
}

/// One step of a window's making.
fn advance(window: &mut Window, trains: &[Train; TRAINS], wind_from: f64) {
    let Window::Making { bed, following, done } = window else { return };
    match following {
        None => {
            let train = &trains[done.len()];
            // Downwind, turned counter-clockwise; south is down.
            let (sin, cos) = libm::sincos(wind_from);
            let (turn_sin, turn_cos) = libm::sincos(train.toward);
            let east = -sin * turn_cos + cos * turn_sin;
            let north = -cos * turn_cos - sin * turn_sin;
            *following = Some(Box::new(Following::new(bed, train.omega, [east, -north])));
        }
        Some(train) => {
            if train.advance(bed)
                && let Some(train) = following.take()
            {
                done.push(train.finish(bed));
            }
        }
    }
    if done.len() == TRAINS {
        *window = Window::Ready(Arc::new(words(done)));
    }
}

/// Node by node, train by train: R, and the way in halves of 2^-15.
fn words(arrivals: &[Arrivals]) -> Vec<[u32; 2]> {
    let packed = |part: f64| u32::from(libm::round((0.5 * part).clamp(-1.0, 1.0) * 32_767.0) as i16 as u16);
    let word = |(at, train): (usize, &Arrivals)| {
        let [east, south] = train.way[at].map(packed);
        [(train.rest[at] as f32).to_bits(), east | south << 16]
    };
    (0..SHORE_SIDE * SHORE_SIDE).flat_map(|at| arrivals.iter().map(move |train| word((at, train)))).collect()
}
