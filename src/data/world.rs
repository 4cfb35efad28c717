//! The world as it loads: archives below one folder or URL, asked for tile by tile, coarse tiles first.
//!
//! Nothing here blocks: [`World::request`] notes a wish, [`World::poll`] starts what may start and hands over what has
//! arrived. A tile that fails is tried again, later and later, and given up after [`ATTEMPTS`] with one line in the
//! log; it never holds up the others. Decoded tiles stay in a bounded cache for readouts ([`World::sample_resident`]).
//!
//! It is long, but one thing: a request's way from wish to answer, in the order in which it goes.

mod answer;
#[cfg(not(target_arch = "wasm32"))]
mod blocking;
mod cache;
mod levels;
mod shore_bed;
mod shores;
mod slot;
mod span;
mod strict;

use super::coast::inland::Inland;
use super::exposure::Found;
use super::fetch::{Source, Spawner, join, now_s};
use super::pmtiles::Archive;
use super::sample::{Sample, Terrain, sample};
use super::streaming::PAGE_LEVELS;
use super::tile::{Layer, Projection, TileId};
use super::water::OwnShores;
use super::{SharedTexels, TileTexels};
use crate::error::{Error, Result};
use crate::model::sea_bed::USUAL_SLOPE;
use answer::{deepest, stored};
use cache::Cache;
use levels::Levels;
pub use levels::{LINES_LEVEL, WorldWaters};
pub use shore_bed::{SHORE_LEVEL, SHORE_SIDE};
use shores::Unfinished;
use slot::{Opening, Slot};
use span::{OnTheWay, Span, Wish};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap, HashSet};
use std::ops::Range;
use std::sync::{Arc, mpsc};
pub use strict::Look;

/// How often a tile or an archive is tried.
pub const ATTEMPTS: u32 = 3;
/// Requests that may be on their way at once.
pub const IN_FLIGHT: usize = 16;
/// Tiles that are remembered as not there, at most.
const MOST_ABSENT: usize = 1 << 16;
/// Decoded tiles kept for readouts; 256 KiB each.
pub const TILES_KEPT: usize = 512;
/// Wait before the second attempt, seconds; four times as long before the third.
const FIRST_WAIT_S: f64 = 1.0;
/// A tile that was given up may be asked for again after this time, seconds.
const GIVEN_UP_S: f64 = 30.0;

/// What came of a request.
#[derive(Debug)]
pub enum Outcome {
    /// The decoded texels.
    Tile(SharedTexels),
    /// The archive has no such tile: the parent serves.
    Absent,
    /// The tile was given up: the parent serves.
    Failed(Error),
}

/// One answered request.
#[derive(Debug)]
pub struct Arrival {
    /// What was asked for.
    pub layer: Layer,
    /// Which tile.
    pub id: TileId,
    /// What came of it.
    pub outcome: Outcome,
}

/// Called, from any thread, when [`World::poll`] has something to do.
pub type Waker = Arc<dyn Fn() + Send + Sync>;

type Key = (Layer, TileId);

/// What a tile's bytes say.
#[derive(Debug)]
enum Decoded {
    /// All there is to know.
    Whole(TileTexels),
    /// What is near the shores: the rest is its parent's.
    Near(OwnShores, Option<Arc<Inland>>),
}

/// Deepest level of the water tiles that are made of an archive's polygons: texels of 19 m at the equator, half as wide as the polygons
/// are true.
pub const DEEPEST_SHORES: u8 = PAGE_LEVELS as u8 - 1;

enum Event {
    Opened(usize, Result<Archive<Source>>),
    Tile(Key, Result<Option<Decoded>>),
    /// A request for these bytes of an archive is over.
    Over(usize, Range<u64>),
}

/// The archives of a world: terrain, water and perhaps imagery, each for Mercator and the two poles.
pub struct World {
    slots: Vec<Slot>,
    /// How steeply the bed falls from shores, metres per metre.
    beach_slope: f64,
    /// Requests without an answer: how often each has been tried.
    pending: HashMap<Key, u32>,
    /// Requests that may start now, coarse tiles first, then in the order of asking.
    ready: BinaryHeap<Reverse<(u8, u64, Key)>>,
    /// Requests that wait until a time, seconds.
    waiting: Vec<(f64, Key)>,
    /// Tiles given up, until a time, seconds.
    given_up: HashMap<Key, f64>,
    /// Tiles that are known not to exist.
    absent: HashSet<Key>,
    /// Water tiles that wait for their parents.
    unfinished: Unfinished,
    answered: Vec<Arrival>,
    on_the_way: OnTheWay,
    asked: u64,
    /// Requests answered since nothing was pending.
    done: usize,
    cache: Cache,
    levels: Levels,
    sender: mpsc::Sender<Event>,
    receiver: mpsc::Receiver<Event>,
    spawner: Spawner,
    waker: Option<Waker>,
}

/// Files of a world, by layer and map.
pub fn archive_name(layer: Layer, projection: Projection) -> String {
    match projection {
        Projection::Mercator => format!("{}.pmtiles", layer.name()),
        polar => format!("{}-{}.pmtiles", layer.name(), polar.name()),
    }
}

fn slot_index(layer: Layer, projection: Projection) -> usize {
    layer as usize * Projection::ALL.len() + projection as usize
}

impl World {
    /// The world below a folder (natively) or a URL (in the browser). Returns at once; what is missing shows up as
    /// failed tiles.
    pub fn open(base: &str) -> Self {
        let (sender, receiver) = mpsc::channel();
        let maps = Layer::ALL.into_iter().flat_map(|layer| Projection::ALL.map(|projection| (layer, projection)));
        let mut world = Self {
            slots: maps
                .map(|(layer, projection)| {
                    let name = join(base, &archive_name(layer, projection));
                    // What may be missing is not opened before it is wanted.
                    if layer == Layer::Imagery { Slot::unasked(name) } else { Slot::new(name) }
                })
                .collect(),
            beach_slope: USUAL_SLOPE,
            pending: HashMap::new(),
            ready: BinaryHeap::new(),
            waiting: Vec::new(),
            given_up: HashMap::new(),
            absent: HashSet::new(),
            unfinished: Unfinished::default(),
            answered: Vec::new(),
            on_the_way: OnTheWay::default(),
            asked: 0,
            done: 0,
            cache: Cache::new(TILES_KEPT),
            levels: Levels::default(),
            sender,
            receiver,
            spawner: Spawner::default(),
            waker: None,
        };
        world.open_slots();
        world
    }

    /// Sets what is called, from any thread, when [`World::poll`] has something to do (a repaint, usually).
    pub fn set_waker(&mut self, waker: Waker) {
        self.waker = Some(waker);
    }

    /// Asks for a tile, at the next [`World::send`] or [`World::poll`]. Asking again for what is on its way changes nothing; the answer
    /// comes from [`World::poll`], at its next call for a tile that is still in the cache.
    pub fn request(&mut self, layer: Layer, id: TileId) {
        let key = (layer, id);
        self.unfinished.is_wanted(&key);
        if self.pending.contains_key(&key) {
            return;
        }
        self.forgive(now_s());
        self.pending.insert(key, 0);
        self.slots[slot_index(layer, id.projection)].ask();
        if let Some(texels) = self.cache.get(&key) {
            self.answer(key, Outcome::Tile(texels));
        } else if self.absent.contains(&key) {
            self.answer(key, Outcome::Absent);
        } else if self.given_up.contains_key(&key) {
            let url = self.slot(layer, id.projection).name.clone();
            let why = format!("{} tile {id} was given up a moment ago", layer.name());
            self.answer(key, Outcome::Failed(Error::Fetch { url, why }));
        } else {
            self.make_ready(key);
        }
    }

    /// What is known of a tile. One that is not is asked for; its answer comes to nobody, but it is in the cache then.
    pub fn look(&mut self, layer: Layer, id: TileId) -> Found {
        if let Some(found) = self.known(layer, id) {
            return found;
        }
        let key = (layer, id);
        if !self.pending.contains_key(&key) {
            self.request(layer, id);
            self.unfinished.asks_silently(key);
        }
        Found::Coming
    }

    /// The tile, or that there is none; `None` where neither is known.
    fn known(&mut self, layer: Layer, id: TileId) -> Option<Found> {
        let key = (layer, id);
        if let Some(texels) = self.cache.get(&key) {
            return Some(Found::Tile(texels));
        }
        let beyond = self.max_zoom(layer, id.projection).is_some_and(|deepest| id.z > deepest);
        let is_absent =
            beyond || self.absent.contains(&key) || self.given_up.contains_key(&key) || !self.has(layer, id.projection);
        is_absent.then_some(Found::Absent)
    }

    /// Lets what was given up long enough ago be asked for again; levels found without it are found anew.
    fn forgive(&mut self, now: f64) {
        let given_up = self.given_up.len();
        self.given_up.retain(|_, until| *until > now);
        if self.given_up.len() < given_up {
            self.levels = Levels::default();
        }
    }

    /// Sends what has been asked for: neighbours together.
    pub fn send(&mut self) {
        self.start();
    }

    /// Takes in what has arrived, starts what may start, and returns the answers since the last call.
    pub fn poll(&mut self) -> Vec<Arrival> {
        while let Ok(event) = self.receiver.try_recv() {
            match event {
                Event::Opened(slot, result) => self.slots[slot].opened(result),
                Event::Tile(key, result) => self.arrived(key, result),
                Event::Over(slot, bytes) => self.on_the_way.over(slot, &bytes),
            }
        }
        self.finish_shores();
        let now = now_s();
        self.forgive(now);
        let (due, waiting) = std::mem::take(&mut self.waiting).into_iter().partition(|(at, _)| *at <= now);
        self.waiting = waiting;
        due.into_iter().for_each(|(_, key): (f64, Key)| self.make_ready(key));
        self.open_slots();
        self.start();
        std::mem::take(&mut self.answered)
    }

    /// Requests that have no answer yet.
    pub fn pending(&self) -> usize {
        self.pending.len()
    }

    /// Answered requests over all requests since nothing was pending, 0 to 1.
    pub fn progress(&self) -> f32 {
        let all = self.done + self.pending.len();
        if all == 0 { 1.0 } else { self.done as f32 / all as f32 }
    }

    /// Whether every archive that has been asked for has been opened or given up.
    pub fn settled(&self) -> bool {
        self.slots.iter().all(|slot| !matches!(slot.opening, Opening::At(_) | Opening::Started))
    }

    /// Whether the world has a layer on a map, as far as is known: its archive has not been given up.
    pub fn has(&self, layer: Layer, projection: Projection) -> bool {
        !matches!(self.slot(layer, projection).opening, Opening::Failed(_))
    }

    /// Why there is no world to show: an archive of the Mercator map that was given up.
    pub fn failure(&self) -> Option<String> {
        Layer::SHAPE.into_iter().find_map(|layer| self.slot(layer, Projection::Mercator).failure())
    }

    /// The deepest level of the tiles that an archive gives, once it is open: of polygons they are made more deeply than they are stored.
    pub fn max_zoom(&self, layer: Layer, projection: Projection) -> Option<u8> {
        self.slot(layer, projection).archive().map(|archive| deepest(archive))
    }

    /// Sets how steeply the bed falls from shores, metres per metre, in samples to come.
    pub fn set_beach_slope(&mut self, slope: f64) {
        self.beach_slope = slope;
    }

    /// The real resolution of an archive's source, metres, once it is open and where it says so.
    pub fn resolution_m(&self, layer: Layer, projection: Projection) -> Option<f64> {
        self.slot(layer, projection).archive()?.metadata().get("resolution_m")?.as_f64().filter(|r| *r > 0.0)
    }

    /// Who is to be credited for the archives that are open, each once; plain text.
    pub fn credits(&self) -> Vec<String> {
        let mut credits: Vec<String> = Vec::new();
        for archive in self.slots.iter().filter_map(Slot::archive) {
            if let Some(credit) = archive.metadata().get("attribution").and_then(|a| a.as_str())
                && !credit.is_empty()
                && !credits.iter().any(|known| known == credit)
            {
                credits.push(credit.to_owned());
            }
        }
        credits
    }

    /// What is at geodetic `lat`, `lon` (radians), from the tiles in the cache; `None` where not even a coarse terrain
    /// tile is there. Tiles that tell at what level inland water lies there are asked for: of places that stay, as the eye's.
    pub fn sample_resident(&mut self, lat: f64, lon: f64) -> Option<Sample> {
        self.sample_now(lat, lon, true)
    }

    /// The same of places that pass, as the cursor's: nothing is asked for.
    pub fn sample_passing(&mut self, lat: f64, lon: f64) -> Option<Sample> {
        self.sample_now(lat, lon, false)
    }

    fn sample_now(&mut self, lat: f64, lon: f64, may_ask: bool) -> Option<Sample> {
        let terrain = self.terrain_at(lat)?;
        let deepest_water = self.max_zoom(Layer::Water, Projection::for_latitude(lat));
        let stands = self.stands_now(lat, lon, may_ask);
        let cache = &mut self.cache;
        sample((lat, lon), terrain, deepest_water, stands, &mut |layer, id| Ok(cache.get(&(layer, id)))).ok().flatten()
    }

    fn terrain_at(&self, lat: f64) -> Option<Terrain> {
        let projection = Projection::for_latitude(lat);
        let deepest = self.max_zoom(Layer::Terrain, projection)?;
        let resolution_m = self.resolution_m(Layer::Terrain, projection).unwrap_or(0.0);
        Some(Terrain { deepest, resolution_m, beach_slope: self.beach_slope })
    }

    fn slot(&self, layer: Layer, projection: Projection) -> &Slot {
        &self.slots[slot_index(layer, projection)]
    }

    fn note_absent(&mut self, key: Key) {
        // They are found again as quickly as they were.
        if self.absent.len() >= MOST_ABSENT {
            self.absent.clear();
        }
        self.absent.insert(key);
    }

    fn answer(&mut self, key: Key, outcome: Outcome) {
        if let Outcome::Absent = outcome {
            self.note_absent(key);
        }
        if self.pending.remove(&key).is_some() {
            self.done += 1;
            if self.unfinished.asked_silently(&key) {
                return;
            }
            self.answered.push(Arrival { layer: key.0, id: key.1, outcome });
        }
        if self.pending.is_empty() {
            self.done = 0;
        }
    }

    fn make_ready(&mut self, key: Key) {
        self.asked += 1;
        self.ready.push(Reverse((key.1.z, self.asked, key)));
    }

    fn open_slots(&mut self) {
        let now = now_s();
        for (index, slot) in self.slots.iter_mut().enumerate() {
            if slot.should_open(now) {
                let (source, sender, waker) = (Source::new(slot.name.clone()), self.sender.clone(), self.waker.clone());
                self.spawner.spawn(async move {
                    let _ = sender.send(Event::Opened(index, Archive::open(source).await));
                    waker.inspect(|wake| wake());
                });
            }
        }
    }

    fn is_here(&mut self, key: Key, texels: TileTexels, inland: Option<Arc<Inland>>) {
        let texels = Arc::new(texels);
        self.cache.put(key, texels.clone(), inland);
        self.answer(key, Outcome::Tile(texels));
    }

    /// Starts ready requests while there is room. Those whose archive is not open yet stay ready, and those whose bytes are on their
    /// way for others.
    fn start(&mut self) {
        if self.on_the_way.len() >= IN_FLIGHT {
            return;
        }
        let (mut later, mut wishes, mut spans) = (Vec::new(), Vec::new(), Vec::new());
        while let Some(Reverse((z, order, key))) = self.ready.pop() {
            let index = slot_index(key.0, key.1.projection);
            let slot = &self.slots[index];
            match &slot.opening {
                Opening::Open(archive) if key.1.z > deepest(archive) => self.answer(key, Outcome::Absent),
                Opening::Open(archive) => {
                    let stored = stored(archive, key.1);
                    let place = archive.place(stored.z, stored.x, stored.y);
                    let wish = Wish { slot: index, key, rank: (z, order), place };
                    match &wish.place {
                        Some(place) if archive.has(place) => spans.push(Span::from(wish)),
                        Some(place) if self.on_the_way.brings(index, place) => later.push(Reverse((z, order, key))),
                        _ => wishes.push(wish),
                    }
                }
                Opening::Failed(why) => {
                    let error = Error::Fetch { url: slot.name.clone(), why: why.clone() };
                    self.answer(key, Outcome::Failed(error));
                }
                _ => later.push(Reverse((z, order, key))),
            }
        }
        spans.extend(span::spans(wishes, |slot, gap| {
            let at_hand = self.slots[slot].archive().is_some_and(|archive| archive.has_any_of(gap));
            at_hand || self.on_the_way.brings_any_of(slot, gap)
        }));
        for span in spans {
            let archive = self.slots[span.slot()].archive().filter(|_| self.on_the_way.len() < IN_FLIGHT).cloned();
            let Some(archive) = archive else {
                later.extend(span.wishes.iter().map(|wish| Reverse((wish.rank.0, wish.rank.1, wish.key))));
                continue;
            };
            let (sender, waker) = (self.sender.clone(), self.waker.clone());
            let (slot, bytes) = (span.slot(), span.bytes().clone());
            self.on_the_way.add(slot, bytes.clone());
            self.spawner.spawn(async move {
                // A world that is gone takes no answers.
                let tell = |key, result| drop(sender.send(Event::Tile(key, result)));
                span::fetch(&archive, span, tell).await;
                let _ = sender.send(Event::Over(slot, bytes));
                waker.inspect(|wake| wake());
            });
        }
        self.ready.extend(later);
    }

    fn arrived(&mut self, key: Key, result: Result<Option<Decoded>>) {
        match result {
            Ok(Some(Decoded::Whole(texels))) => self.is_here(key, texels, None),
            Ok(Some(Decoded::Near(shores, inland))) => self.unfinished.add(key.1, shores, inland),
            Ok(None) => self.answer(key, Outcome::Absent),
            Err(error) => {
                // Perhaps its bytes: they are asked for anew.
                if let Some(archive) = self.slot(key.0, key.1.projection).archive() {
                    let stored = stored(archive, key.1);
                    archive.place(stored.z, stored.x, stored.y).inspect(|place| archive.forget(place));
                }
                let tried = self.pending.get_mut(&key).map_or(ATTEMPTS, |tried| {
                    *tried += 1;
                    *tried
                });
                if tried < ATTEMPTS {
                    self.waiting.push((now_s() + wait_s(tried), key));
                } else {
                    log::warn!("{} tile {} is given up, its parent serves: {error}", key.0.name(), key.1);
                    self.given_up.insert(key, now_s() + GIVEN_UP_S);
                    self.answer(key, Outcome::Failed(error));
                }
            }
        }
    }
}

/// The wait after a failed attempt, seconds.
fn wait_s(tried: u32) -> f64 {
    FIRST_WAIT_S * 4f64.powi(tried.saturating_sub(1).min(4) as i32)
}
