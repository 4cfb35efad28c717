//! Floor 6: the program in a window or a page: input, the picture, the panel, the address.
//!
//! The scene is drawn before egui paints, into a picture of its own ([`blit`]), and only when something has visibly changed
//! ([`stillness`]): an idle page costs nothing. How fine the picture is, is up to [`pace`].

pub mod address;
pub mod blit;
pub mod clock;
pub mod fonts;
pub mod in_flight;
pub mod input;
pub mod pace;
pub mod page;
pub mod readout;
pub mod stillness;

use std::sync::Arc;

use egui_wgpu::wgpu;
use glam::DVec2;

use crate::data::fetch::now_s;
use crate::data::sample::Sample;
use crate::data::water::WaterClass;
use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::model::perlin;
use crate::panel::{self, Action, Panel};
use crate::renderer::Renderer;
use crate::scene::settings::{Quality, Settings};
use crate::scene::view::camera::Camera;
use crate::scene::view::flight::Flight;
use crate::scene::view::inertia::Navigator;
use crate::scene::view::named::View;
use crate::scene::view::state::ViewState;
use address::Address;
use blit::Picture;
use in_flight::InFlight;
use pace::{Adapter, Effort, Motion, Pace};
use page::Page;

/// What the program starts with.
pub struct Options {
    /// The view.
    pub state: ViewState,
    /// Whether the panel is shown; the key H shows and hides it.
    pub panel: bool,
}

/// Time without a move after which the eye is at rest, seconds: a hand that pauses must not wait for a full picture.
const PAUSE_S: f64 = 0.3;
/// Time in a frame for the sea of a picture at rest, seconds: hands are answered between two of them.
const SEA_WORK_S: f64 = 0.05;
/// Part of the time that pictures of arriving map tiles may take: the rest is for their decoding.
const SETTLING_SHARE: f64 = 0.4;

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

/// The program.
pub struct App {
    gpu: Gpu,
    renderer: Renderer,
    picture: Picture,
    page: Box<dyn Page>,
    address: Address,
    state: ViewState,
    navigator: Navigator,
    flight: Option<(Flight, f64)>,
    panel: Panel,
    shown: Option<Shown>,
    pace: Pace,
    in_flight: InFlight,
    /// When the last picture was begun, by [`now_s`], and what it is expected to take, milliseconds.
    begun_s: f64,
    picture_ms: f64,
    /// Whether the picture on its way is a moving one, or one at rest in full; `None` where it takes longer for what is still to come.
    paced: Option<bool>,
    /// Whether the picture on its way shows the same as the one before, a while later.
    renewing: bool,
    /// Quality whose waves are drawn.
    quality: Quality,
    /// The longest waves of the sea that was drawn, metres.
    longest_wave_m: f64,
    /// When the last frame was, by [`now_s`], while time runs.
    last_frame_s: Option<f64>,
    /// Whether the last frame asked for the next one at once.
    steady: bool,
    /// What was to be seen in the last frame, and when that last changed.
    wished: Option<(Camera, Settings)>,
    moved_s: f64,
    last_drag_s: f64,
    /// Smoothed time between pictures while something moves, milliseconds.
    frame_ms: f64,
}

impl App {
    /// The program inside eframe, drawing with eframe's device.
    ///
    /// # Errors
    /// [`Error::Gpu`] where eframe has no device.
    pub fn new(
        host: &eframe::CreationContext<'_>,
        gpu: Gpu,
        mut renderer: Renderer,
        options: Options,
        page: Box<dyn Page>,
    ) -> Result<Self> {
        let render_state = render_state(host)?;
        let context = host.egui_ctx.clone();
        // Where a processor paints, a repaint for each of many tiles would cost more than their pictures.
        let patience_s = if gpu.software { 0.1 } else { 0.0 };
        renderer.world_mut().set_waker(Arc::new(move || context.request_repaint_after_secs(patience_s)));
        renderer.seas_mut().spread();
        let picture = Picture::new(&gpu.device, render_state.target_format);
        // The page's own zoom does this, and does it for the picture too.
        host.egui_ctx.options_mut(|options| options.zoom_with_keyboard = false);
        host.egui_ctx.set_theme(egui::Theme::Dark);
        host.egui_ctx.set_fonts(fonts::definitions());
        let pace = Pace::new(if gpu.software { Adapter::Software } else { Adapter::Hardware });
        Ok(Self {
            gpu,
            renderer,
            picture,
            page,
            address: Address::default(),
            state: options.state,
            navigator: Navigator::default(),
            flight: None,
            panel: Panel::new(options.panel),
            shown: None,
            pace,
            in_flight: InFlight::default(),
            begun_s: 0.0,
            picture_ms: 0.0,
            paced: None,
            renewing: false,
            quality: Quality::Auto,
            longest_wave_m: 0.0,
            last_frame_s: None,
            steady: false,
            wished: None,
            moved_s: 0.0,
            last_drag_s: 0.0,
            frame_ms: 0.0,
        })
    }

    /// Height of the ground or the resting water below the eye, metres, of the bed for an eye in the water; 0 while nobody knows.
    fn ground_m(&mut self) -> f64 {
        let Camera { lat, lon, altitude_m, .. } = self.state.camera;
        let sample = self.renderer.world_mut().sample_resident(lat, lon);
        let solid = |sample: &Sample| sample.class != WaterClass::Ocean || altitude_m < 0.0;
        sample.filter(solid).map_or(0.0, |sample| sample.elevation_m)
    }

    /// Moves everything that moves on by some seconds. Returns the scene's time and whether the eye has more to go.
    fn advance(&mut self, ui: &egui::Ui, response: &egui::Response, size: DVec2, seconds: f64) -> (f64, bool) {
        // After a pause, what begins to move begins now.
        let eye_seconds = if self.steady { seconds } else { 1.0 / 60.0 };
        let ground_m = self.ground_m();
        let hands = input::Hands { ui, response, size, ground_m };
        if hands.takes_over() {
            self.flight = None;
        }
        let mut moving = false;
        if let Some((flight, elapsed_s)) = &mut self.flight {
            *elapsed_s += eye_seconds;
            self.state.camera = flight.at(*elapsed_s);
            moving = true;
            if *elapsed_s >= flight.duration_s() {
                self.flight = None;
            }
        }
        let keys = hands.apply(&mut self.navigator, &mut self.state.camera, &mut self.last_drag_s);
        moving |= self.navigator.step(&mut self.state.camera, keys, size, ground_m, eye_seconds);
        let unix_seconds = clock::advance(&mut self.state, seconds, clock::unix_now_s());
        (unix_seconds, moving)
    }

    /// Whether tiles are on their way, so that another picture would be a better one.
    fn is_loading(&mut self) -> bool {
        self.renderer.needs_redraw() || self.renderer.world_mut().pending() > 0
    }

    /// Whether eye or sea have changed a moment ago.
    fn is_moving(&mut self, now: f64) -> bool {
        let wish = (self.state.camera, self.state.settings.clone());
        if self.wished.as_ref() != Some(&wish) {
            (self.wished, self.moved_s) = (Some(wish), now);
        }
        now - self.moved_s < PAUSE_S
    }

    /// Draws the scene if it differs from the picture and the device is free.
    fn draw(&mut self, context: &egui::Context, mut motion: Motion, unix_seconds: f64, canvas: [u32; 2], now: f64) {
        let ratio = f64::from(context.pixels_per_point());
        let settings = self.state.settings.clone();
        // The waves of a picture at rest are those of its coarser forerunners.
        self.quality = match motion {
            Motion::Moving => self.pace.effort(settings.quality, motion, canvas, ratio).quality,
            _ => settings.quality,
        };
        let drawn = Settings { quality: self.quality, ..settings.clone() };
        let until_s = now_s() + SEA_WORK_S;
        self.renderer.seas_mut().begin(&drawn);
        // At rest the sea is finished first: what its thresholds change, the foam's past would have to follow once more.
        while motion == Motion::Rest && self.renderer.seas_mut().is_busy() && now_s() < until_s {
            self.renderer.seas_mut().begin(&drawn);
        }
        if motion == Motion::Rest && self.shown.is_some() && self.renderer.seas_mut().is_busy() {
            return;
        }
        if self.in_flight.is_busy(&self.gpu) {
            return;
        }
        if let Some(ms) = self.in_flight.news() {
            self.picture_ms = ms;
            match self.paced {
                Some(true) => self.pace.measured(ms),
                Some(false) => self.pace.measured_full(ms),
                None => {}
            }
        }
        let camera = self.renderer.eye(&self.state, unix_seconds);
        let sea = self.renderer.seas_mut().revision();
        let full = self.pace.effort(settings.quality, Motion::Rest, canvas, ratio);
        let mut wanted = Shown { settings, camera, unix_seconds, canvas, effort: full, sea };
        let is_shown = self.shown.as_ref() == Some(&wanted);
        if motion == Motion::Rest && is_shown && !self.is_loading() {
            return;
        }
        // What is drawn in full once stays so while the last of it arrives.
        if motion == Motion::Rest && !is_shown && self.is_unready(&wanted) {
            motion = Motion::Settling;
        }
        wanted.effort = self.pace.effort(wanted.settings.quality, motion, canvas, ratio);
        if self.shown.as_ref() == Some(&wanted) {
            let waits_for_tiles = !self.renderer.is_replaying();
            if !self.is_loading()
                || (waits_for_tiles && (now - self.begun_s) * 1000.0 * SETTLING_SHARE < self.picture_ms)
            {
                return;
            }
        }
        let size = pace::scaled(canvas, wanted.effort.scale);
        let mut frame = self.renderer.frame(&drawn, &camera, unix_seconds, size);
        frame.uniform.cell_pixels = frame.uniform.cell_pixels.max(wanted.effort.cell_pixels as f32);
        self.longest_wave_m = perlin::wavelength_m(frame.sea.perlin.patch_m, 0);
        self.picture.resize(&self.gpu.device, size);
        let label = wgpu::CommandEncoderDescriptor { label: Some("scene") };
        let mut encoder = self.gpu.device.create_command_encoder(&label);
        self.renderer.render(&mut encoder, &frame, &self.picture.view);
        let (context, let_moves_through) =
            (context.clone(), if self.gpu.software { self.page.keep_moves() } else { || {} });
        self.in_flight.submit(&self.gpu, encoder, move || {
            let_moves_through();
            context.request_repaint();
        });
        if self.steady && motion == Motion::Moving {
            let weight = if self.frame_ms == 0.0 { 1.0 } else { 0.1 };
            self.frame_ms += ((now - self.begun_s) * 1000.0 - self.frame_ms) * weight;
        }
        self.begun_s = now;
        let before = self.shown.take().map(|shown| Shown { unix_seconds, ..shown });
        self.renewing = motion == Motion::Rest && before.as_ref() == Some(&wanted);
        self.paced = (!self.renderer.is_replaying()).then_some(motion != Motion::Rest);
        self.shown = Some(wanted);
    }

    /// Whether a full picture of this would soon be replaced: map tiles or the foam's past are to come.
    fn is_unready(&mut self, wanted: &Shown) -> bool {
        let frame = self.renderer.frame(&wanted.settings, &wanted.camera, wanted.unix_seconds, wanted.canvas);
        let other_waves = self.shown.as_ref().is_none_or(|shown| shown.effort.quality != wanted.effort.quality);
        !self.renderer.load(&frame)
            || self.renderer.world_mut().pending() > 0
            || other_waves
            || self.renderer.is_replaying()
    }

    /// Starts a flight to a named view and makes it an entry of the history.
    fn fly(&mut self, view: &View) {
        let from = self.state.clone();
        let mut to = view.state();
        to.unknown = from.unknown.clone();
        to.settings.water_density_per_m = from.settings.water_density_per_m;
        to.settings.layers = from.settings.layers;
        self.address.push(&mut *self.page, &from, &to, now_s());
        self.navigator.stop();
        self.flight = Some((Flight::new(from.camera, to.camera), 0.0));
        self.state = ViewState { camera: from.camera, ..to };
    }

    fn act(&mut self, context: &egui::Context, action: Action) {
        match action {
            Action::Fly(view) => self.fly(view),
            Action::CopyLink => context.copy_text(self.page.link(&self.state.format_fragment(None))),
        }
    }

    /// The sea that the settings ask for in figures.
    fn figures(&mut self) -> panel::sea::Figures {
        let settings = Settings { quality: self.quality, ..self.state.settings.clone() };
        panel::sea::Figures::of(&self.renderer.seas_mut().tables(&settings), settings.foam)
    }

    /// Publishes the program's condition for the page's scripts; `held`: a hand or a flight moves the eye.
    fn publish(&mut self, context: &egui::Context, motion: Motion, held: bool) {
        let full = self.shown.as_ref().is_some_and(|shown| motion == Motion::Moving || shown.effort.scale == 1.0);
        let drawn = motion == Motion::Moving || self.renewing || !self.in_flight.is_busy(&self.gpu);
        let settled = !held && full && drawn && self.in_flight.finished() > 0 && !self.is_loading();
        self.page.publish("state", if settled { "settled" } else { "loading" });
        self.page.publish("pictures", &self.in_flight.finished().to_string());
        let scale = self.shown.as_ref().map_or(0.0, |shown| shown.effort.scale);
        self.page.publish("scale", &format!("{scale:.2}"));
        self.page.publish("frame-ms", &format!("{:.1}", self.frame_ms));
        let figures = self.figures();
        self.page.publish("sea", &figures.json());
        self.page.publish("fragment", &self.state.format_fragment(None));
        self.page.publish("widgets", &self.panel.widgets_json(context.zoom_factor()));
    }
}

/// What eframe made for wgpu.
///
/// # Errors
/// [`Error::Gpu`] where it made nothing.
pub fn render_state<'a>(host: &'a eframe::CreationContext<'_>) -> Result<&'a egui_wgpu::RenderState> {
    let remedy = "use a browser with WebGPU or a driver with Vulkan, Metal or DirectX 12";
    host.wgpu_render_state.as_ref().ok_or_else(|| Error::gpu("eframe has no wgpu device", remedy))
}

impl eframe::App for App {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        let now = now_s();
        let seconds = self.last_frame_s.map_or(1.0 / 60.0, |last| (now - last).max(0.0));
        if self.address.read(&mut *self.page, &mut self.state) {
            self.navigator.stop();
            self.flight = None;
        }
        let context = ui.ctx().clone();
        let rect = ui.max_rect();
        let response = ui.allocate_rect(rect, egui::Sense::click_and_drag());
        let pixels_per_point = f64::from(context.pixels_per_point());
        let size = DVec2::new(f64::from(rect.width()), f64::from(rect.height())) * pixels_per_point;
        let (unix_seconds, eye_moves) = self.advance(ui, &response, size, seconds);
        let rate = self.state.rate.abs();
        let still_s = stillness::still_s(&self.state.camera, size.y, self.longest_wave_m);
        let runs = rate != 0.0 && still_s < rate * stillness::SHORTEST_S;
        let held = if rate == 0.0 || runs { unix_seconds } else { stillness::held(unix_seconds, still_s) };
        let moving = self.is_moving(now) || eye_moves || response.is_pointer_button_down_on();
        let motion = if moving || runs { Motion::Moving } else { Motion::Rest };
        self.renderer.set_moving(moving || runs);
        let largest = self.gpu.device.limits().max_texture_dimension_2d;
        let canvas = [size.x, size.y].map(|side| (side.round() as u32).clamp(1, largest));
        self.draw(&context, motion, held, canvas, now);
        ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, self.picture.callback()));

        let cursor = response.hover_pos().map(|at| input::pixel(at, rect, pixels_per_point));
        let overlay = readout::Overlay { camera: &self.state.camera, size, pixels_per_point, cursor };
        if self.panel.is_shown() {
            overlay.show(ui, rect, self.renderer.world_mut(), &self.state.settings);
        }
        let now_unix_s = clock::unix_now_s();
        let figures = self.figures();
        let status = panel::Status {
            frame_ms: self.frame_ms,
            adapter: &self.gpu.adapter,
            pending: self.renderer.world_mut().pending(),
            progress: self.renderer.world_mut().progress(),
            now_s: now_unix_s,
            figures,
        };
        if let Some(action) = self.panel.show(&context, &mut self.state, &status) {
            self.act(&context, action);
        }
        let waits = if self.flight.is_some() { None } else { self.address.write(&mut *self.page, &self.state, now) };
        self.publish(&context, motion, moving);
        self.last_frame_s = (self.state.rate != 0.0 || eye_moves || self.flight.is_some()).then_some(now);
        self.steady = eye_moves || runs || self.flight.is_some();
        if self.in_flight.is_busy(&self.gpu) {
            // The finished picture wakes us; natively somebody must ask for it.
            context.request_repaint_after_secs(if cfg!(target_arch = "wasm32") { 0.5 } else { 0.004 });
        } else if self.steady || self.renderer.is_replaying() {
            context.request_repaint();
        } else if moving {
            context.request_repaint_after_secs((self.moved_s + PAUSE_S - now).max(0.0) as f32 + 0.001);
        } else if self.is_loading() {
            // What arrives wakes us; this is for what must be asked for again.
            context.request_repaint_after_secs(0.2);
        } else if self.shown.as_ref().is_some_and(|shown| shown.effort.scale < 1.0) {
            context.request_repaint();
        }
        if rate != 0.0 && !runs {
            // A tick more, so that the next instant has come.
            let next_s = if self.state.rate > 0.0 { held + still_s - unix_seconds } else { unix_seconds - held };
            context.request_repaint_after_secs((next_s / rate) as f32 + 0.001);
        }
        if let Some(wait_s) = waits {
            context.request_repaint_after_secs(wait_s as f32 + 0.01);
        }
    }

    fn persist_egui_memory(&self) -> bool {
        false
    }
}
