//! What waves by shores take: time of a frame and memory on the device, and the processor's time for what they are made of.
//!
//! A frame is timed beside the same one whose waves by shores are not drawn one by one, forwards and backwards in turn, and the median of
//! their ratios counts. They have no dispatch: shaders read a buffer that the processor fills.

use std::time::{Duration, Instant};

use super::{STEP_S, frame_ms, median};
use crate::cli::render::{draw, instant};
use crate::data::coast::{self, field::field};
use crate::data::fetch::Source;
use crate::data::pmtiles::Archive;
use crate::data::tile::{Layer, MapPoint, Projection};
use crate::data::world::{DEEPEST_SHORES, World, WorldWaters, archive_name};
use crate::error::Result;
use crate::gpu::Gpu;
use crate::renderer::{Cost, Radiance, Renderer};
use crate::scene::frame::{Frame, Output};
use crate::scene::sea::shelter::Shelter;
use crate::scene::sea::shores::Shores;
use crate::scene::view::state::ViewState;

/// What a view's shores take.
pub struct ShoreCost {
    /// Windows of trains on the device.
    pub windows: usize,
    /// Bytes of their buffer on the device, and of what is kept of windows for it.
    pub bytes: [u64; 2],
    /// Dispatches that a frame has more of than without them.
    pub dispatches: i64,
    /// Milliseconds of a frame with the trains and without, and the share of a frame that they take.
    pub frame_ms: [f64; 2],
    /// See `frame_ms`.
    pub share: f64,
    /// The processor's milliseconds for a window of trains.
    pub window_ms: f64,
    /// For a node of lees, where land stands in the sea's way.
    pub node_ms: f64,
    /// For a water tile of the deepest level from shores as polygons; `None` where the world has none there.
    pub tile_ms: Option<f64>,
}

/// Renderers for [`ShoreCosts::measure`]: of frames with the trains, and without.
pub struct ShoreCosts {
    renderers: [Renderer; 2],
    target: wgpu::TextureView,
    size: [u32; 2],
    data: String,
}

impl ShoreCosts {
    /// Over the world in the folder `data`, for pictures of `size` into `target`.
    ///
    /// # Errors
    /// As [`Renderer::with_radiance`].
    pub fn new(gpu: &Gpu, data: &str, target: wgpu::TextureView, size: [u32; 2]) -> Result<Self> {
        let one = || pollster::block_on(Renderer::with_radiance(gpu.clone(), World::open(data), Radiance::Half));
        Ok(Self { renderers: [one()?, one()?], target, size, data: data.into() })
    }

    /// What the shores of a view take, in `rounds`; `None` where it has no windows of trains.
    ///
    /// # Errors
    /// As [`draw`], or a lost device.
    pub fn measure(&mut self, state: &ViewState, rounds: u16) -> Result<Option<ShoreCost>> {
        let [whole, without] = &mut self.renderers;
        let (frame, _) = draw(whole, state, self.size, Output::Picture)?;
        let Cost { shore_windows: windows, shore_bytes: bytes, .. } = whole.cost()?;
        if windows == 0 {
            return Ok(None);
        }
        let bare = |frame: &Frame| Frame { shows_trains: false, ..frame.clone() };
        while !without.load(&bare(&frame)) {
            std::thread::sleep(Duration::from_millis(2));
        }
        without.settle(&bare(&frame));
        let (mut clock_s, mut dispatches) = (instant(state), 0);
        let (mut times, mut ratios) = ([const { Vec::new() }; 2], Vec::new());
        // The first pair makes pipelines.
        for round in 0..=rounds {
            clock_s += STEP_S;
            let frame = whole.frame(&state.settings, &frame.camera, clock_s, self.size);
            let mut with_ms = 0.0;
            if round % 2 == 0 {
                with_ms = frame_ms(whole, &frame, &self.target)?[0];
            }
            let without_ms = frame_ms(without, &bare(&frame), &self.target)?[0];
            if round % 2 == 1 {
                with_ms = frame_ms(whole, &frame, &self.target)?[0];
            }
            dispatches = whole.cost()?.dispatches as i64 - without.cost()?.dispatches as i64;
            if round > 0 {
                ratios.push(without_ms / with_ms);
                times[0].push(with_ms);
                times[1].push(without_ms);
            }
        }
        let mut world = World::open(&self.data);
        // The first time tiles come.
        let [_, window_ms] = [(); 2].map(|()| windows_ms(&mut world, &frame));
        let [_, node_ms] = [(); 2].map(|()| nodes_ms(&mut world, &frame));
        Ok(Some(ShoreCost {
            windows,
            bytes,
            dispatches,
            frame_ms: times.map(median),
            share: 1.0 - median(ratios),
            window_ms,
            node_ms,
            tile_ms: tile_ms(&self.data, &frame, rounds),
        }))
    }
}

/// Milliseconds for a window of trains around a frame's eye.
fn windows_ms(world: &mut World, frame: &Frame) -> f64 {
    let (mut shores, mut spent) = (Shores::default(), Duration::ZERO);
    loop {
        let start = Instant::now();
        let complete = shores.prepare(world, frame, (true, true), f64::INFINITY);
        spent += start.elapsed();
        if complete || world.failure().is_some() {
            return spent.as_secs_f64() * 1e3 / shores.ready().count().max(1) as f64;
        }
        world.poll();
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Milliseconds for a node of lees around a frame's eye.
fn nodes_ms(world: &mut World, frame: &Frame) -> f64 {
    let (mut shelter, mut spent) = (Shelter::default(), Duration::ZERO);
    let eye = (frame.camera.lat, frame.camera.lon, frame.camera.altitude_m);
    loop {
        let start = Instant::now();
        let complete = shelter.advance(
            (&frame.sea, frame.wind_from),
            eye,
            f64::INFINITY,
            &mut WorldWaters::new(world, World::look_or_parent),
        );
        spent += start.elapsed();
        if complete || world.failure().is_some() {
            return spent.as_secs_f64() * 1e3 / shelter.found().max(1) as f64;
        }
        world.send();
        world.poll();
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Milliseconds for the water tile under a frame's eye, from shores as polygons.
fn tile_ms(data: &str, frame: &Frame, rounds: u16) -> Option<f64> {
    let name = archive_name(Layer::Water, Projection::Mercator);
    let archive = pollster::block_on(Archive::open(Source::new(format!("{data}/{name}")))).ok()?;
    let tile = MapPoint::on(Projection::Mercator, frame.camera.lat, frame.camera.lon).tile(DEEPEST_SHORES);
    let from = tile.ancestor(archive.header().max_zoom.min(tile.z))?;
    let bytes = pollster::block_on(archive.tile(from.z, from.x, from.y)).ok()??;
    let times = (0..rounds).map(|_| {
        let start = Instant::now();
        let shores = coast::Shores::decode("tile", &bytes).ok()?;
        std::hint::black_box(field(tile, from.z, &shores));
        Some(start.elapsed().as_secs_f64() * 1e3)
    });
    times.collect::<Option<Vec<f64>>>().map(median)
}

impl ShoreCost {
    /// Heads of [`ShoreCost::row`]'s columns.
    pub fn head() -> String {
        let columns = ["windows", "GPU MB", "kept MB", "dispatches", "frame ms", "without", "share", "window ms"];
        let columns = columns.iter().chain(&["node µs", "tile ms"]);
        format!("{:<12}{}", "shores", columns.map(|column| format!(" {column:>10}")).collect::<String>())
    }

    /// A row of the table.
    pub fn row(&self, view: &str) -> String {
        let Self { windows, bytes, dispatches, frame_ms: [with, without], share, .. } = self;
        let [gpu, kept] = bytes.map(|bytes| bytes as f64 * 1e-6);
        let tile = self.tile_ms.map_or_else(|| "-".into(), |ms| format!("{ms:.2}"));
        let share = format!("{:.1} %", 100.0 * share);
        format!(
            "{view:<12} {windows:>10} {gpu:>10.1} {kept:>10.1} {dispatches:>10} {with:>10.2} {without:>10.2} {share:>10} {:>10.1} {:>10.1} {tile:>10}",
            self.window_ms,
            1e3 * self.node_ms,
        )
    }

    /// The record of the view called `view`.
    pub fn json(&self, view: &str) -> serde_json::Value {
        serde_json::json!({
            "view": view,
            "windows": self.windows,
            "gpu_bytes": self.bytes[0],
            "kept_bytes": self.bytes[1],
            "dispatches": self.dispatches,
            "frame_ms": self.frame_ms[0],
            "without_ms": self.frame_ms[1],
            "share": self.share,
            "window_ms": self.window_ms,
            "node_ms": self.node_ms,
            "tile_ms": self.tile_ms,
        })
    }
}
