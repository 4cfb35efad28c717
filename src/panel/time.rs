//! The time of the scene: its text, pause, rate, the hour of the day, and now.

use egui::{DragValue, Slider, TextEdit, Ui};

use super::{Widgets, digits};
use crate::scene::time::SceneTime;
use crate::scene::view::state::ViewState;

const DAY_S: f64 = 86_400.0;

/// What the user is typing, and the rate to come back to.
#[derive(Debug)]
pub struct Editor {
    text: Option<String>,
    rate: f64,
}

impl Default for Editor {
    fn default() -> Self {
        Self { text: None, rate: 1.0 }
    }
}

/// Stops the time, or lets it run at its usual rate.
pub fn toggle_pause(state: &mut ViewState) {
    state.rate = if state.rate == 0.0 { 1.0 } else { 0.0 };
}

impl Editor {
    /// Shows the widgets. `now_s`: the machine's clock, UTC seconds since 1970.
    pub fn show(&mut self, ui: &mut Ui, state: &mut ViewState, now_s: f64, widgets: &mut Widgets) {
        let at_s = state.time.unix_seconds(now_s);
        ui.horizontal(|ui| {
            self.show_text(ui, state, at_s, widgets);
            let now = ui.button("now").on_hover_text("The present time, at its own rate");
            widgets.note("now", &now);
            if now.clicked() {
                (state.time, state.rate, self.rate) = (SceneTime::Now, 1.0, 1.0);
            }
        });
        ui.horizontal(|ui| {
            let paused = state.rate == 0.0;
            let pause =
                ui.button(if paused { "run" } else { "pause" }).on_hover_text("Stops the time or lets it run (space)");
            widgets.note("pause", &pause);
            if !paused {
                self.rate = state.rate;
            }
            if pause.clicked() {
                state.rate = if paused { self.rate } else { 0.0 };
            }
            let rate = DragValue::new(&mut state.rate)
                .range(-1000.0..=1000.0)
                .speed(0.05)
                .custom_formatter(digits(3))
                .prefix("× ");
            let rate = ui.add(rate).on_hover_text("Seconds of the scene per second");
            widgets.note("rate", &rate);
            let mut hour = at_s.rem_euclid(DAY_S) / 3600.0;
            ui.spacing_mut().slider_width = 66.0;
            let slider = Slider::new(&mut hour, 0.0..=24.0).show_value(false);
            let slider = ui.add(slider).on_hover_text("Hour of the day, UTC");
            widgets.note("hour", &slider);
            if slider.changed() {
                state.time = SceneTime::At(at_s - at_s.rem_euclid(DAY_S) + hour * 3600.0);
            }
        });
    }

    fn show_text(&mut self, ui: &mut Ui, state: &mut ViewState, at_s: f64, widgets: &mut Widgets) {
        let shown = || SceneTime::At(at_s.floor()).to_string();
        let mut text = self.text.take().unwrap_or_else(shown);
        let edit = ui.add(TextEdit::singleline(&mut text).desired_width(144.0));
        let edit = edit.on_hover_text("UTC, e.g. 2026-11-20T12:00:00Z, or now");
        widgets.note("time", &edit);
        if edit.lost_focus() {
            // What cannot be read leaves the time as it was.
            if text != shown()
                && let Some(time) = SceneTime::parse(&text)
            {
                state.time = time;
            }
        } else if edit.has_focus() {
            self.text = Some(text);
        }
    }
}
