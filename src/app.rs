//! Floor 6: the program in a window or a page: input, the picture, the panel, the address.
//!
//! The scene is drawn before egui paints, into a picture of its own ([`blit`]), and only when something has changed: an
//! idle page costs nothing.

pub mod address;
pub mod blit;
pub mod clock;
pub mod input;
pub mod page;
pub mod readout;

use std::sync::Arc;

use egui_wgpu::wgpu;
use glam::DVec2;

use crate::data::fetch::now_s;
use crate::data::sample::Sample;
use crate::data::water::WaterClass;
use crate::error::{Error, Result};
use crate::gpu::Gpu;
use crate::panel::{self, Action, Panel};
use crate::renderer::Renderer;
use crate::scene::settings::Settings;
use crate::scene::view::camera::Camera;
use crate::scene::view::flight::Flight;
use crate::scene::view::inertia::Navigator;
use crate::scene::view::named::View;
use crate::scene::view::state::ViewState;
use address::Address;
use blit::Picture;
use page::Page;

/// What the program starts with.
pub struct Options {
    /// The view.
    pub state: ViewState,
    /// Whether the panel is shown; the key H shows and hides it.
    pub panel: bool,
}

/// What the picture shows; an equal one need not be drawn again.
#[derive(Clone, PartialEq)]
struct Shown {
    settings: Settings,
    camera: Camera,
    unix_seconds: f64,
    size: [u32; 2],
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
    /// When the last frame was, by [`now_s`], while something moves.
    last_frame_s: Option<f64>,
    last_drag_s: f64,
    /// Smoothed time between frames while something moves, milliseconds.
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
        renderer.world_mut().set_waker(Arc::new(move || context.request_repaint()));
        renderer.seas_mut().spread();
        let picture = Picture::new(&gpu.device, render_state.target_format);
        // The page's own zoom does this, and does it for the picture too.
        host.egui_ctx.options_mut(|options| options.zoom_with_keyboard = false);
        host.egui_ctx.set_theme(egui::Theme::Dark);
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
            last_frame_s: None,
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

    /// Moves everything that moves on by some seconds. Returns the scene's time and whether more is to come.
    fn advance(&mut self, ui: &egui::Ui, response: &egui::Response, size: DVec2, seconds: f64) -> (f64, bool) {
        let ground_m = self.ground_m();
        let hands = input::Hands { ui, response, size, ground_m };
        if hands.takes_over() {
            self.flight = None;
        }
        let mut moving = false;
        if let Some((flight, elapsed_s)) = &mut self.flight {
            *elapsed_s += seconds;
            self.state.camera = flight.at(*elapsed_s);
            moving = true;
            if *elapsed_s >= flight.duration_s() {
                self.flight = None;
            }
        }
        let keys = hands.apply(&mut self.navigator, &mut self.state.camera, &mut self.last_drag_s);
        moving |= self.navigator.step(&mut self.state.camera, keys, size, ground_m, seconds);
        let unix_seconds = clock::advance(&mut self.state, seconds, clock::unix_now_s());
        (unix_seconds, moving || self.state.rate != 0.0)
    }

    /// Whether tiles are on their way, so that another picture would be a better one.
    fn is_loading(&mut self) -> bool {
        self.renderer.needs_redraw() || self.renderer.world_mut().pending() > 0
    }

    /// Draws the scene if it differs from the picture.
    fn draw(&mut self, unix_seconds: f64, size: [u32; 2]) {
        self.picture.resize(&self.gpu.device, size);
        let size = self.picture.size();
        self.renderer.seas_mut().begin(&self.state.settings);
        let camera = self.renderer.eye(&self.state, unix_seconds);
        let sea = self.renderer.seas_mut().revision();
        let shown = Shown { settings: self.state.settings.clone(), camera, unix_seconds, size, sea };
        if self.shown.as_ref() == Some(&shown) && !self.is_loading() {
            return;
        }
        let frame = self.renderer.frame(&shown.settings, &shown.camera, unix_seconds, size);
        let label = wgpu::CommandEncoderDescriptor { label: Some("scene") };
        let mut encoder = self.gpu.device.create_command_encoder(&label);
        self.renderer.render(&mut encoder, &frame, &self.picture.view);
        self.gpu.queue.submit([encoder.finish()]);
        self.shown = Some(shown);
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
        let settings = &self.state.settings;
        panel::sea::Figures::of(&self.renderer.seas_mut().tables(settings), settings.foam)
    }

    /// Publishes the program's condition for the page's scripts.
    fn publish(&mut self, context: &egui::Context) {
        let settled = self.shown.is_some() && !self.is_loading();
        self.page.publish("state", if settled { "settled" } else { "loading" });
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
        if self.last_frame_s.is_some() {
            let weight = if self.frame_ms == 0.0 { 1.0 } else { 0.1 };
            self.frame_ms += (seconds * 1000.0 - self.frame_ms) * weight;
        }
        if self.address.read(&mut *self.page, &mut self.state) {
            self.navigator.stop();
            self.flight = None;
        }
        let context = ui.ctx().clone();
        let rect = ui.max_rect();
        let response = ui.allocate_rect(rect, egui::Sense::click_and_drag());
        let pixels_per_point = f64::from(context.pixels_per_point());
        let size = DVec2::new(f64::from(rect.width()), f64::from(rect.height())) * pixels_per_point;
        let (unix_seconds, moving) = self.advance(ui, &response, size, seconds);
        self.renderer.set_moving(moving);
        self.draw(unix_seconds, [size.x.round() as u32, size.y.round() as u32]);
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
        self.publish(&context);
        self.last_frame_s = (moving || self.flight.is_some()).then_some(now);
        if self.last_frame_s.is_some() || self.renderer.is_replaying() {
            context.request_repaint();
        } else if self.is_loading() {
            // What arrives wakes us; this is for what must be asked for again.
            context.request_repaint_after_secs(0.2);
        } else if let Some(wait_s) = waits {
            context.request_repaint_after_secs(wait_s as f32 + 0.01);
        }
    }

    fn persist_egui_memory(&self) -> bool {
        false
    }
}
