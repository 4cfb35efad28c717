//! The panel: widgets on the view state. Small enough for a window of 640 by 360.

mod dial;
pub mod sea;
mod time;
pub mod views;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::RangeInclusive;

use egui::{
    Align2, Color32, ComboBox, CornerRadius, Frame, Key, Rect, Response, ScrollArea, Shadow, Shape, Slider, Ui,
    Visuals, vec2,
};

use crate::model::sea_state;
use crate::scene::layers::Layer;
use crate::scene::link::number::decimal;
use crate::scene::settings::{Datum, Mesh, Settings, Water};
use crate::scene::view::named::View;
use crate::scene::view::state::ViewState;

/// Width of the panel, points.
const WIDTH: f32 = 212.0;

/// What a click in the panel asks of the program.
#[derive(Clone, Copy, Debug)]
pub enum Action {
    /// A flight to a named view.
    Fly(&'static View),
    /// The link of the present view into the clipboard.
    CopyLink,
}

/// What the panel shows of the program.
pub struct Status<'a> {
    /// Time between frames, milliseconds; 0 before the second one.
    pub frame_ms: f64,
    /// Name of the graphics adapter.
    pub adapter: &'a str,
    /// Tiles on their way.
    pub pending: usize,
    /// Part of the tiles that have arrived, 0 to 1.
    pub progress: f32,
    /// The machine's clock, UTC seconds since 1970.
    pub now_s: f64,
    /// The sea that the settings ask for.
    pub figures: sea::Figures,
}

/// The colour that the panel stands on; the picture shows through.
pub fn ground_colour() -> Color32 {
    Visuals::dark().window_fill.gamma_multiply(0.9)
}

/// The panel's own state.
pub struct Panel {
    shown: bool,
    open: bool,
    views: views::Views,
    time: time::Editor,
    copied: bool,
    widgets: Widgets,
}

/// Where the main widgets are on the screen, points; for tests in a browser.
#[derive(Debug, Default)]
pub struct Widgets(BTreeMap<&'static str, Rect>);

impl Widgets {
    /// Notes where a widget is.
    pub fn note(&mut self, name: &'static str, response: &Response) {
        self.0.insert(name, response.rect);
    }
}

impl Panel {
    /// The panel, shown or hidden.
    pub fn new(shown: bool) -> Self {
        let (views, time) = (views::Views::default(), time::Editor::default());
        Self { shown, open: true, views, time, copied: false, widgets: Widgets::default() }
    }

    /// Whether the panel and the texts over the picture are shown.
    pub fn is_shown(&self) -> bool {
        self.shown
    }

    /// The widgets' rectangles as a JSON object of `[x, y, width, height]` in CSS pixels.
    pub fn widgets_json(&self, zoom_factor: f32) -> String {
        let mut json = String::from("{");
        for (name, rect) in &self.widgets.0 {
            let comma = if json.len() > 1 { "," } else { "" };
            let [x, y, w, h] = [rect.min.x, rect.min.y, rect.width(), rect.height()].map(|side| side * zoom_factor);
            // Writing to a String cannot fail.
            let _ = write!(json, "{comma}\"{name}\":[{x:.1},{y:.1},{w:.1},{h:.1}]");
        }
        json + "}"
    }

    /// Shows the panel and applies what the user does with it; `ground` paints [`ground_colour`] over a rectangle.
    pub fn show(
        &mut self,
        context: &egui::Context,
        state: &mut ViewState,
        status: &Status<'_>,
        ground: &dyn Fn(Rect) -> Shape,
    ) -> Option<Action> {
        if !context.egui_wants_keyboard_input() {
            let [hide, pause] = [Key::H, Key::Space].map(|key| context.input(|input| input.key_pressed(key)));
            self.shown ^= hide;
            if pause {
                time::toggle_pause(state);
            }
        }
        self.widgets.0.clear();
        if !self.shown {
            return None;
        }
        let mut action = None;
        let height = context.content_rect().height() - 16.0;
        egui::Area::new(egui::Id::unique("panel")).anchor(Align2::RIGHT_TOP, vec2(-6.0, 6.0)).fade_in(false).show(
            context,
            |ui| {
                let behind = ui.painter().add(Shape::Noop);
                let frame =
                    Frame::window(ui.style()).inner_margin(6).shadow(Shadow::NONE).corner_radius(CornerRadius::ZERO);
                let framed = frame.fill(Color32::TRANSPARENT).show(ui, |ui| {
                    ui.set_width(if self.open { WIDTH } else { 86.0 });
                    ui.spacing_mut().item_spacing = vec2(5.0, 3.0);
                    action = self.header(ui, status);
                    progress(ui, status);
                    if self.open {
                        let scroll = ScrollArea::vertical()
                            .max_height(height - 40.0)
                            .min_scrolled_height(height - 40.0)
                            .auto_shrink([false, true]);
                        scroll.show(ui, |ui| action = action.take().or(self.body(ui, state, status)));
                    }
                });
                ui.painter().set(behind, ground(framed.response.rect));
            },
        );
        action
    }

    fn header(&mut self, ui: &mut Ui, status: &Status<'_>) -> Option<Action> {
        let mut action = None;
        ui.horizontal(|ui| {
            let fold = ui.button(if self.open { "− Ocean" } else { "+ Ocean" });
            let fold = fold.on_hover_text("Fold the panel. The key H hides it.");
            self.widgets.note("fold", &fold);
            self.open ^= fold.clicked();
            if !self.open {
                return;
            }
            let copy = ui.button(if self.copied { "Link copied" } else { "Copy link" });
            let copy = copy.on_hover_text("A link that opens this view, this wind and this time");
            self.widgets.note("copyLink", &copy);
            if copy.clicked() {
                self.copied = true;
                action = Some(Action::CopyLink);
            } else if !copy.hovered() {
                self.copied = false;
            }
            let text = if status.frame_ms > 0.0 { format!("{:.0} ms", status.frame_ms) } else { String::new() };
            ui.weak(text).on_hover_text(format!("Time from frame to frame on {}", status.adapter));
        });
        action
    }

    fn body(&mut self, ui: &mut Ui, state: &mut ViewState, status: &Status<'_>) -> Option<Action> {
        self.wind(ui, &mut state.settings);
        status.figures.show(ui);
        ui.separator();
        let action = self.views.show(ui, &mut self.widgets);
        ui.separator();
        self.time.show(ui, state, status.now_s, &mut self.widgets);
        ui.separator();
        let more = egui::CollapsingHeader::new("Sea and layers").show(ui, |ui| self.sea(ui, &mut state.settings));
        self.widgets.note("more", &more.header_response);
        action
    }

    fn wind(&mut self, ui: &mut Ui, settings: &mut Settings) {
        ui.horizontal(|ui| {
            let dial = dial::show(ui, &mut settings.wind.from_deg);
            self.widgets.note("windDial", &dial);
            ui.vertical(|ui| {
                let mut speed_mps = settings.wind_speed_mps();
                ui.spacing_mut().slider_width = 72.0;
                let slider = ui.add(Slider::new(&mut speed_mps, 0.0..=60.0).custom_formatter(digits(1)).suffix(" m/s"));
                self.widgets.note("windSpeed", &slider);
                if slider.changed() {
                    settings.wind.speed_mps = speed_mps;
                    settings.beaufort = None;
                }
                let grade = settings.beaufort_grade();
                let combo = ComboBox::from_id_salt("beaufort").width(132.0).selected_text(grade_name(grade));
                let combo = combo.show_ui(ui, |ui| {
                    for other in 0..=12 {
                        if ui.selectable_label(other == grade, grade_name(other)).clicked() {
                            settings.beaufort = Some(other);
                            settings.wind.speed_mps = sea_state::speed_from_beaufort(f64::from(other));
                        }
                    }
                });
                self.widgets.note("beaufort", &combo.response);
                ui.weak(format!("wind from {:.0}°", settings.wind.from_deg));
            });
        });
    }

    fn sea(&mut self, ui: &mut Ui, settings: &mut Settings) {
        ui.spacing_mut().slider_width = 80.0;
        sea::show(ui, settings, &mut self.widgets);
        let haze = Slider::new(&mut settings.haze, 0.0..=0.2).custom_formatter(digits(2)).text("haze");
        let haze = ui.add(haze);
        self.widgets.note("haze", &haze);
        haze.on_hover_text("Optical depth of the aerosol: 0.05 far out, 0.1 near shores, 0.2 in smoke");
        let mut cover = settings.cloud_cover();
        ui.horizontal(|ui| {
            let clouds = ui.add(Slider::new(&mut cover, 0.0..=1.0).custom_formatter(digits(2)).text("clouds"));
            if clouds.changed() {
                settings.clouds = Some(cover);
            }
            self.widgets.note("clouds", &clouds);
            clouds.on_hover_text("Share of the earth under clouds");
            let by_wind = "As many as the wind brings: more in storms";
            if settings.clouds.is_some() && ui.small_button("auto").on_hover_text(by_wind).clicked() {
                settings.clouds = None;
            }
        });
        let name = |water| Water::ALL.iter().find(|(kind, _)| *kind == water).map_or("", |(_, name)| *name);
        let combo = egui::ComboBox::from_label("water").selected_text(name(settings.water)).show_ui(ui, |ui| {
            for (water, name) in Water::ALL {
                ui.selectable_value(&mut settings.water, water, name);
            }
        });
        self.widgets.note("water", &combo.response);
        let density =
            Slider::new(&mut settings.water_density_per_m, 0.1..=0.3).custom_formatter(digits(3)).text("ρ, 1/m");
        ui.add(density).on_hover_text("The water hides the ground by 1 − exp(−ρ·depth)");
        ui.horizontal(|ui| {
            let seed = ui.add(egui::DragValue::new(&mut settings.seed).speed(1));
            self.widgets.note("seed", &seed);
            ui.label("seed");
        });
        let mut on_geoid = settings.datum == Datum::Geoid;
        let check = ui.checkbox(&mut on_geoid, "sea on the geoid");
        self.widgets.note("geoid", &check);
        check.on_hover_text("Altitudes over the ellipsoid, as GPS has them, with the sea where it really is: up to 107 m below and 85 m above");
        settings.datum = if on_geoid { Datum::Geoid } else { Datum::Ellipsoid };
        self.mesh(ui, settings);
        ui.horizontal_wrapped(|ui| {
            for (layer, name) in Layer::ALL {
                let mut shown = settings.layers.shows(layer);
                let check = ui.checkbox(&mut shown, name);
                self.widgets.note(name, &check);
                settings.layers.set(layer, shown);
            }
        });
    }

    fn mesh(&mut self, ui: &mut Ui, settings: &mut Settings) {
        let mut bisected = settings.mesh == Mesh::Bisect;
        let check = ui.checkbox(&mut bisected, "bisected mesh");
        self.widgets.note("meshBisect", &check);
        check.on_hover_text("Triangles halved on the GPU where the surface needs it, instead of a grid on the screen");
        settings.mesh = if bisected { Mesh::Bisect } else { Mesh::Grid };
        if !bisected {
            return;
        }
        let pixels = Slider::new(&mut settings.triangles.pixels, 2.0..=64.0).logarithmic(true);
        let pixels = ui.add(pixels.custom_formatter(digits(1)).suffix(" px").text("triangles"));
        self.widgets.note("trianglePixels", &pixels);
        let budget =
            ui.add(Slider::new(&mut settings.triangles.budget, 1_000..=1_000_000).logarithmic(true).text("at most"));
        self.widgets.note("triangleBudget", &budget);
    }
}

/// Shows a number with at most so many decimals. egui's own limit would round the number itself, unasked.
fn digits(decimals: i32) -> impl Fn(f64, RangeInclusive<usize>) -> String {
    move |number, _| decimal(number, decimals)
}

/// A thin line whose length is the part of the tiles that has come. It always has its room, so that nothing below it jumps.
fn progress(ui: &mut Ui, status: &Status<'_>) {
    let (rect, line) = ui.allocate_exact_size(vec2(ui.available_width(), 3.0), egui::Sense::hover());
    if status.pending > 0 {
        let done = Rect::from_min_size(rect.min, vec2(rect.width() * status.progress.clamp(0.02, 1.0), rect.height()));
        ui.painter().rect_filled(done, 1.0, ui.visuals().selection.bg_fill);
        line.on_hover_text(format!("{} tiles to come", status.pending));
    }
}

fn grade_name(grade: u8) -> String {
    format!("{grade} {}", sea_state::name(usize::from(grade)))
}
