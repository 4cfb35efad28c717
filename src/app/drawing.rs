//! Which picture is drawn when: only one that shows something else than the last, one at a time, as fine as [`super::pace`] allows,
//! and at rest none that would soon be replaced.

use egui_wgpu::wgpu;

use crate::data::fetch::now_s;
use crate::gpu::Gpu;
use crate::model::perlin;
use crate::renderer::Renderer;
use crate::scene::settings::{Quality, Settings};
use crate::scene::view::camera::Camera;
use crate::scene::view::state::ViewState;

use super::blit::Picture;
use super::in_flight::InFlight;
use super::pace::{self, Adapter, Effort, Motion, Pace};

/// Time in a frame for the sea of a picture at rest, seconds: hands are answered between two of them.
const SEA_WORK_S: f64 = 0.05;
/// Part of the time that pictures of arriving map tiles may take: the rest is for their decoding.
const SETTLING_SHARE: f64 = 0.4;

/// What is to be seen, and how.
pub struct Wish<'a> {
    /// Eye and settings.
    pub state: &'a ViewState,
    /// The scene's time, seconds since 1970.
    pub unix_seconds: f64,
    /// Size of the canvas, physical pixels.
    pub canvas: [u32; 2],
    /// Physical pixels of a point of the screen.
    pub pixels_per_point: f64,
    /// What moves.
    pub motion: Motion,
    /// Whether the frame before asked for this one at once, so that the time between them says how fast pictures come.
    pub steady: bool,
}

/// What the picture shows; an equal one need not be drawn again.
#[derive(Clone, PartialEq)]
struct Shown {
    settings: Settings,
    camera: Camera,
    unix_seconds: f64,
    canvas: [u32; 2],
    effort: Effort,
    /// Of the sea, which settings come to by and by.
    sea: u64,
}

/// The picture, the renderer that draws it, and what is known of the last ones.
pub struct Drawing {
    gpu: Gpu,
    /// The renderer.
    pub renderer: Renderer,
    /// The finished picture.
    pub picture: Picture,
    shown: Option<Shown>,
    pace: Pace,
    in_flight: InFlight,
    /// When the last picture was begun, by [`now_s`], and what it is expected to take, milliseconds.
    begun_s: f64,
    picture_ms: f64,
    /// What moves in the picture on its way; `None` where its time tells nothing of the next: foam's past or a compiler had a part in it,
    /// or the quality was chosen.
    paced: Option<Motion>,
    /// Whether the picture on its way shows the same as the one before, a while later.
    renewing: bool,
    /// Quality whose waves are drawn.
    quality: Quality,
    /// The longest waves of the sea that was drawn, metres.
    pub longest_wave_m: f64,
    /// Smoothed time between pictures while something moves, milliseconds; 0 before any.
    pub frame_ms: f64,
}

impl Drawing {
    /// Nothing drawn yet; egui's target has a format of its own.
    pub fn new(gpu: Gpu, mut renderer: Renderer, target_format: wgpu::TextureFormat) -> Self {
        renderer.seas_mut().spread();
        Self {
            picture: Picture::new(&gpu, target_format),
            pace: Pace::new(if gpu.software { Adapter::Software } else { Adapter::Hardware }),
            gpu,
            renderer,
            shown: None,
            in_flight: InFlight::default(),
            begun_s: 0.0,
            picture_ms: 0.0,
            paced: None,
            renewing: false,
            quality: Quality::Auto,
            longest_wave_m: 0.0,
            frame_ms: 0.0,
        }
    }

    /// Draws what is wished if it differs from the picture and the device is free; `wake` is called when the picture is finished.
    pub fn update(&mut self, wish: &Wish, now: f64, wake: impl FnOnce() + Send + 'static) {
        self.renderer.set_moving(wish.motion == Motion::Moving);
        self.renderer.set_picture_s(1e-3 * self.picture_ms);
        self.quality = self.effort(wish, wish.motion).quality;
        let settings = self.drawn(&wish.state.settings);
        if !self.has_sea(&settings, wish.motion) || self.is_busy() {
            return;
        }
        self.learn();
        let Some((wanted, motion)) = self.wanted(wish, now) else { return };
        let (replayed, made) = (self.renderer.is_replaying(), self.gpu.pipelines_made());
        self.submit(&wanted, &settings, wake);
        if wish.steady && motion == Motion::Moving {
            let weight = if self.frame_ms == 0.0 { 1.0 } else { 0.1 };
            self.frame_ms += ((now - self.begun_s) * 1000.0 - self.frame_ms) * weight;
        }
        self.begun_s = now;
        let before = self.shown.take().map(|shown| Shown { unix_seconds: wanted.unix_seconds, ..shown });
        self.renewing = motion == Motion::Rest && before.as_ref() == Some(&wanted);
        let chosen = wish.state.settings.quality != Quality::Auto;
        let more = replayed || self.renderer.is_replaying() || self.gpu.pipelines_made() != made;
        self.paced = (!chosen && !more).then_some(motion);
        self.shown = Some(wanted);
    }

    /// Works on the sea of these settings. Returns whether a picture may be drawn with what there is of it.
    fn has_sea(&mut self, settings: &Settings, motion: Motion) -> bool {
        let seas = self.renderer.seas_mut();
        let until_s = now_s() + SEA_WORK_S;
        seas.begin(settings);
        // At rest the sea is finished first: what its thresholds change, the foam's past would have to follow once more.
        while motion == Motion::Rest && seas.is_busy() && now_s() < until_s {
            seas.begin(settings);
        }
        motion != Motion::Rest || self.shown.is_none() || !seas.is_busy()
    }

    /// Takes in what the last picture took.
    fn learn(&mut self) {
        let Some(ms) = self.in_flight.news() else { return };
        self.picture_ms = ms;
        match self.paced {
            Some(Motion::Rest) => self.pace.measured_full(ms),
            Some(_) => self.pace.measured(ms),
            None => {}
        }
    }

    fn effort(&mut self, wish: &Wish, motion: Motion) -> Effort {
        self.pace.effort(wish.state.settings.quality, motion, wish.canvas, wish.pixels_per_point)
    }

    /// What the next picture shall show, and what moves in it; nothing where the last one does.
    fn wanted(&mut self, wish: &Wish, now: f64) -> Option<(Shown, Motion)> {
        let mut wanted = Shown {
            settings: wish.state.settings.clone(),
            camera: self.renderer.eye(wish.state, wish.unix_seconds),
            unix_seconds: wish.unix_seconds,
            canvas: wish.canvas,
            effort: self.effort(wish, Motion::Rest),
            sea: self.renderer.seas_mut().revision(),
        };
        let mut motion = wish.motion;
        let is_shown = self.shown.as_ref() == Some(&wanted);
        if motion == Motion::Rest && is_shown && !self.is_loading() {
            return None;
        }
        // What is drawn in full once stays so while the last of it arrives; other pictures wait, coarser, for all of it.
        if motion == Motion::Rest && !is_shown && self.is_unready(&wanted) {
            motion = Motion::Settling;
        }
        wanted.effort = self.effort(wish, motion);
        if self.shown.as_ref() == Some(&wanted) {
            if !self.is_loading() {
                return None;
            }
            let is_early = (now - self.begun_s) * 1000.0 * SETTLING_SHARE < self.picture_ms;
            if is_early && !self.renderer.is_replaying() && !self.loads(&wanted) {
                return None;
            }
        }
        Some((wanted, motion))
    }

    /// Works on what a full picture of this needs of the world; true when all of it is here.
    fn loads(&mut self, wanted: &Shown) -> bool {
        let frame = self.renderer.frame(&wanted.settings, &wanted.camera, wanted.unix_seconds, wanted.canvas);
        self.renderer.load(&frame)
    }

    /// Whether a full picture of this would soon be replaced: map tiles or the foam's past are to come.
    fn is_unready(&mut self, wanted: &Shown) -> bool {
        let other_waves = self.shown.as_ref().is_none_or(|shown| shown.effort.quality != wanted.effort.quality);
        !self.loads(wanted) || self.renderer.world_mut().pending() > 0 || other_waves || self.renderer.is_replaying()
    }

    fn submit(&mut self, wanted: &Shown, settings: &Settings, wake: impl FnOnce() + Send + 'static) {
        let size = pace::scaled(wanted.canvas, wanted.effort.scale);
        let mut frame = self.renderer.frame(settings, &wanted.camera, wanted.unix_seconds, size);
        frame.set_cell_pixels(frame.uniform.cell_pixels.max(wanted.effort.cell_pixels as f32));
        self.longest_wave_m = perlin::wavelength_m(frame.sea.perlin.patch_m, 0);
        self.picture.resize(&self.gpu, size);
        let label = wgpu::CommandEncoderDescriptor { label: Some("scene") };
        let mut encoder = self.gpu.device.create_command_encoder(&label);
        self.renderer.render(&mut encoder, &frame, &self.picture.view);
        self.in_flight.submit(&self.gpu, encoder, wake);
    }

    /// For how long the device has been at a picture, seconds; nothing where it is at none.
    pub fn busy_s(&self, now: f64) -> Option<f64> {
        self.is_busy().then_some(now - self.begun_s)
    }

    /// Whether the device is at a picture.
    pub fn is_busy(&self) -> bool {
        self.in_flight.is_busy(&self.gpu)
    }

    /// Whether tiles are on their way, so that another picture would be a better one.
    pub fn is_loading(&mut self) -> bool {
        self.renderer.needs_redraw() || self.renderer.world_mut().pending() > 0
    }

    /// Whether the picture is what an eye that moves, or one at rest, gets to see in the end.
    pub fn is_settled(&mut self, motion: Motion) -> bool {
        let full = motion == Motion::Moving || self.scale() == 1.0;
        let drawn = motion == Motion::Moving || self.renewing || !self.is_busy();
        full && drawn && self.pictures() > 0 && !self.is_loading()
    }

    /// Pictures that are finished.
    pub fn pictures(&self) -> u32 {
        self.in_flight.finished()
    }

    /// Pixels of the picture along a pixel of the canvas; 0 before the first.
    pub fn scale(&self) -> f64 {
        self.shown.as_ref().map_or(0.0, |shown| shown.effort.scale)
    }

    /// The settings with the quality whose waves are drawn.
    pub fn drawn(&self, settings: &Settings) -> Settings {
        Settings { quality: self.quality, ..settings.clone() }
    }
}
