//! Floor 6: the program in a window or a page: input, the picture, the panel, the address.
//!
//! The scene is drawn before egui paints, into a picture of its own ([`blit`]), and only when something has visibly changed
//! ([`drawing`], [`stillness`]): an idle page costs nothing. How fine the picture is, is up to [`pace`].

pub mod address;
pub mod blit;
pub mod clock;
pub mod drawing;
pub mod fonts;
pub mod in_flight;
pub mod input;
pub mod pace;
pub mod page;
pub mod pane;
pub mod readout;
pub mod stillness;

use std::sync::Arc;

use glam::DVec2;

use crate::data::fetch::now_s;
use crate::data::water::WaterClass;
use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::panel::{self, Action, Panel};
use crate::renderer::Renderer;
use crate::scene::settings::Settings;
use crate::scene::view::camera::{Camera, LOWEST_M, OVER_BED_M};
use crate::scene::view::flight::Flight;
use crate::scene::view::inertia::Navigator;
use crate::scene::view::named::View;
use crate::scene::view::navigate::above_ground;
use crate::scene::view::state::ViewState;
use address::Address;
use drawing::{Drawing, Wish};
use pace::Motion;
use page::Page;
use pane::Pane;

/// What the program starts with.
pub struct Options {
    /// The view.
    pub state: ViewState,
    /// Whether the panel is shown; the key H shows and hides it.
    pub panel: bool,
}

/// Time without a move after which the eye is at rest, seconds: a hand that pauses must not wait for a full picture.
const PAUSE_S: f64 = 0.3;

/// The program.
pub struct App {
    gpu: Gpu,
    drawing: Drawing,
    page: Box<dyn Page>,
    address: Address,
    state: ViewState,
    navigator: Navigator,
    flight: Option<(Flight, f64)>,
    panel: Panel,
    pane: Pane,
    /// When the last frame was, by [`now_s`], while time runs.
    last_frame_s: Option<f64>,
    /// Whether the last frame asked for the next one at once.
    steady: bool,
    /// What was to be seen in the last frame, and when that last changed.
    wished: Option<(Camera, Settings)>,
    moved_s: f64,
    last_drag_s: f64,
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
        // The page's own zoom does this, and does it for the picture too.
        host.egui_ctx.options_mut(|options| options.zoom_with_keyboard = false);
        host.egui_ctx.set_theme(egui::Theme::Dark);
        host.egui_ctx.set_fonts(fonts::definitions());
        let pane = Pane::new(&gpu, render_state.target_format, panel::ground_colour());
        Ok(Self {
            pane,
            drawing: Drawing::new(gpu.clone(), renderer, render_state.target_format),
            gpu,
            page,
            address: Address::default(),
            state: options.state,
            navigator: Navigator::default(),
            flight: None,
            panel: Panel::new(options.panel),
            last_frame_s: None,
            steady: false,
            wished: None,
            moved_s: 0.0,
            last_drag_s: 0.0,
        })
    }

    /// Height of what the eye stays [`LOWEST_M`] above, metres: the ground or the resting water below it, for an eye in the water or at its surface
    /// what lets it come near the bed. While nobody knows an eye stays where its link put it.
    fn ground_m(&mut self) -> f64 {
        let altitude_m = self.state.camera.altitude_m;
        let in_water = altitude_m < 0.0 || (self.state.ride && altitude_m < LOWEST_M);
        let renderer = &mut self.drawing.renderer;
        // An eye that the terrain about a lake has lifted would not come down again.
        match renderer.place_below(&self.state.camera).filter(|_| renderer.knows_level_below(&self.state.camera)) {
            Some(sample) if sample.class != WaterClass::Ocean => sample.elevation_m,
            Some(sample) if in_water => sample.elevation_m + OVER_BED_M - LOWEST_M,
            None if in_water => altitude_m - LOWEST_M,
            _ => 0.0,
        }
    }

    /// Moves everything that moves on by some seconds. Returns the scene's time and whether the eye has more to go.
    fn advance(&mut self, ui: &egui::Ui, response: &egui::Response, size: DVec2, seconds: f64) -> (f64, bool) {
        // After a pause, what begins to move begins now.
        let eye_seconds = if self.steady { seconds } else { 1.0 / 60.0 };
        let ground_m = self.ground_m();
        let hands = input::Hands { ui, response, size, ground_m };
        // An eye at rest is lifted where it is drawn alone: by coarse tiles, before finer ones come, it might be lifted for good.
        if hands.takes_over() || self.navigator.is_grabbed() || self.flight.is_some() {
            self.state.camera = above_ground(&self.state.camera, ground_m);
        }
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

    /// Whether eye or sea have changed a moment ago.
    fn is_moving(&mut self, now: f64) -> bool {
        let wish = (self.state.camera, self.state.settings.clone());
        if self.wished.as_ref() != Some(&wish) {
            (self.wished, self.moved_s) = (Some(wish), now);
        }
        now - self.moved_s < PAUSE_S
    }

    /// Starts a flight to a named view and makes it an entry of the history.
    fn fly(&mut self, view: &View) {
        let from = self.state.clone();
        let mut to = view.state();
        to.unknown = from.unknown.clone();
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
        let settings = self.drawing.drawn(&self.state.settings);
        panel::sea::Figures::of(&self.drawing.renderer.seas_mut().tables(&settings), settings.foam)
    }

    /// Publishes the program's condition for the page's scripts; `held`: a hand or a flight moves the eye.
    fn publish(&mut self, context: &egui::Context, motion: Motion, held: bool) {
        let settled = !held && self.drawing.is_settled(motion);
        self.page.publish("state", if settled { "settled" } else { "loading" });
        self.page.publish("pictures", &self.drawing.pictures().to_string());
        self.page.publish("scale", &format!("{:.2}", self.drawing.scale()));
        self.page.publish("frame-ms", &format!("{:.1}", self.drawing.frame_ms));
        let figures = self.figures();
        self.page.publish("sea", &figures.json());
        self.page.publish("fragment", &self.state.format_fragment(None));
        self.page.publish("widgets", &self.panel.widgets_json(context.zoom_factor()));
    }

    /// Asks egui for the frame that what still moves or arrives needs; `moving`: a hand or the eye was at it a moment ago.
    fn ask_for_next_frame(&mut self, context: &egui::Context, moving: bool, now: f64) {
        if self.drawing.is_busy() {
            // The finished picture wakes us; natively somebody must ask for it.
            context.request_repaint_after_secs(if cfg!(target_arch = "wasm32") { 0.5 } else { 0.004 });
        } else if self.steady || self.drawing.renderer.is_replaying() {
            context.request_repaint();
        } else if moving {
            context.request_repaint_after_secs((self.moved_s + PAUSE_S - now).max(0.0) as f32 + 0.001);
        } else if self.drawing.is_loading() {
            // What arrives wakes us; this is for what must be asked for again.
            context.request_repaint_after_secs(0.2);
        } else if self.drawing.pictures() > 0 && self.drawing.scale() < 1.0 {
            context.request_repaint();
        }
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
    /// Where a processor paints a page, no frame is painted while a picture is on its way, as long as hands only move: it would show
    /// nothing new, and the picture would come later for it. What hands do is kept for the next frame.
    fn raw_input_hook(&mut self, context: &egui::Context, input: &mut egui::RawInput) {
        if !cfg!(target_arch = "wasm32") || !self.gpu.software {
            return;
        }
        if let Some(wait_s) = self.drawing.busy_s(now_s()).and_then(|busy_s| input::wait_s(&input.events, busy_s)) {
            // egui leaves a hidden window alone.
            input.viewports.entry(egui::ViewportId::ROOT).or_default().occluded = Some(true);
            context.request_repaint_after_secs(wait_s as f32);
        }
    }

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
        let still_s = stillness::still_s(&self.state.camera, size.y, self.drawing.longest_wave_m);
        let runs = rate != 0.0 && still_s < rate * stillness::SHORTEST_S;
        let held = if rate == 0.0 || runs { unix_seconds } else { stillness::held(unix_seconds, still_s) };
        let moving = self.is_moving(now) || eye_moves || response.is_pointer_button_down_on();
        let motion = if moving || runs { Motion::Moving } else { Motion::Rest };
        let largest = self.gpu.device.limits().max_texture_dimension_2d;
        let canvas = [size.x, size.y].map(|side| (side.round() as u32).clamp(1, largest));
        let waker = context.clone();
        let wish =
            Wish { state: &self.state, unix_seconds: held, canvas, pixels_per_point, motion, steady: self.steady };
        self.drawing.update(&wish, now, move || {
            // Without any delay egui would make two frames.
            waker.request_repaint_after_secs(0.001);
        });
        ui.painter().add(egui_wgpu::Callback::new_paint_callback(rect, self.drawing.picture.callback()));

        let cursor = response.hover_pos().map(|at| input::pixel(at, rect, pixels_per_point));
        let overlay = readout::Overlay { camera: &self.state.camera, size, pixels_per_point, cursor };
        if self.panel.is_shown() {
            overlay.show(ui, rect, self.drawing.renderer.world_mut(), &self.state.settings);
        }
        let now_unix_s = clock::unix_now_s();
        let figures = self.figures();
        let status = panel::Status {
            frame_ms: self.drawing.frame_ms,
            adapter: &self.gpu.adapter,
            pending: self.drawing.renderer.world_mut().pending(),
            progress: self.drawing.renderer.world_mut().progress(),
            now_s: now_unix_s,
            figures,
        };
        if let Some(action) = self.panel.show(&context, &mut self.state, &status, &|rect| self.pane.shape(rect)) {
            self.act(&context, action);
        }
        let waits = if self.flight.is_some() { None } else { self.address.write(&mut *self.page, &self.state, now) };
        self.publish(&context, motion, moving);
        self.last_frame_s = (self.state.rate != 0.0 || eye_moves || self.flight.is_some()).then_some(now);
        self.steady = eye_moves || runs || self.flight.is_some();
        self.ask_for_next_frame(&context, moving, now);
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
