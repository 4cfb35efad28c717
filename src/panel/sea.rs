//! Which sea: its spectrum, fetch, swell, chop and foam.

use egui::{ComboBox, Response, Slider, Ui};

use super::{Widgets, digits};
use crate::model::sea_tables::SeaTables;
use crate::scene::sea::foam::Whitecaps;
use crate::scene::settings::{Foam, FoamRule, Settings, Spectrum, Swell};

/// The fetch that the switch turns on with, km.
const FETCH_KM: f64 = 300.0;
/// The swell that the switch turns on with, from 60 degrees to the right of the wind.
const SWELL: Swell = Swell { height_m: 2.0, period_s: 12.0, from_deg: 60.0 };

/// The present sea in figures: significant height, period of the peak, mean square slope, share under whitecaps.
pub struct Figures {
    hs_m: f64,
    tp_s: f64,
    mean_square_slope: f64,
    whitecaps: f64,
}

impl Figures {
    /// Those of a sea with its foam.
    pub fn of(tables: &SeaTables, foam: Foam) -> Self {
        Self {
            hs_m: tables.sea.hs_m,
            tp_s: tables.peak_period_s,
            mean_square_slope: tables.mean_square_slope(),
            whitecaps: Whitecaps::without_map(foam, tables).share,
        }
    }

    /// As a JSON object, for the page's scripts.
    pub fn json(&self) -> String {
        let Self { hs_m, tp_s, mean_square_slope, whitecaps } = self;
        format!(
            "{{\"hs_m\":{hs_m:.3},\"tp_s\":{tp_s:.3},\"mean_square_slope\":{mean_square_slope:.5},\"whitecaps\":{whitecaps:.5}}}"
        )
    }

    /// Shows them.
    pub fn show(&self, ui: &mut Ui) {
        let Self { hs_m, tp_s, mean_square_slope, whitecaps } = self;
        let line = |ui: &mut Ui, text: String, hint: &str| ui.weak(text).on_hover_text(hint.to_owned());
        ui.horizontal_wrapped(|ui| {
            line(ui, format!("Hs {hs_m:.1} m"), "Significant wave height: the mean of the highest third of the waves");
            line(ui, format!("Tp {tp_s:.1} s"), "Period of the waves that carry the most energy");
            line(ui, format!("slopes² {mean_square_slope:.3}"), "Mean square slope: how rough the water is to light");
            line(ui, format!("foam {:.1} %", 100.0 * whitecaps), "Share of the water under whitecaps");
        });
    }
}

/// Shows the widgets and applies what the user does with them.
pub fn show(ui: &mut Ui, settings: &mut Settings, widgets: &mut Widgets) {
    spectrum(ui, settings, widgets);
    fetch(ui, settings, widgets);
    swell(ui, settings, widgets);
    note(ui, widgets, "chop", slider(&mut settings.chop, 0.0..=2.0, 2).text("chop"));
    note(ui, widgets, "foamAmount", slider(&mut settings.foam.amount, 0.0..=3.0, 2).text("foam"));
    let lifetime = slider(&mut settings.foam.lifetime_s, 0.1..=60.0, 1).logarithmic(true);
    let lifetime = note(ui, widgets, "foamLifetime", lifetime.suffix(" s").text("foam fades"));
    lifetime.on_hover_text("Time after which a third of a patch of foam is left");
    let surf = note(ui, widgets, "surfWidth", slider(&mut settings.surf.width, 0.0..=3.0, 2).text("surf"));
    surf.on_hover_text("How wide the white water before beaches is");
    let slope = slider(&mut settings.surf.beach_slope, 0.01..=0.3, 3).logarithmic(true).text("beaches fall");
    let slope = note(ui, widgets, "beachSlope", slope);
    slope.on_hover_text("Of usual beaches, metres per metre where no data tell; all are as many times as steep");
    let mut by_height = settings.foam.rule == FoamRule::Height;
    let rule = ui.checkbox(&mut by_height, "foam on high water");
    widgets.note("foamByHeight", &rule);
    rule.on_hover_text("Instead of where the waves break");
    settings.foam.rule = if by_height { FoamRule::Height } else { FoamRule::Folding };
}

fn spectrum(ui: &mut Ui, settings: &mut Settings, widgets: &mut Widgets) {
    let name = |wanted: Spectrum| Spectrum::ALL.iter().find(|(s, _)| *s == wanted).map_or("", |(_, name)| name);
    let combo = ComboBox::from_label("spectrum").width(110.0).selected_text(name(settings.spectrum));
    let combo = combo.show_ui(ui, |ui| {
        for (spectrum, name) in Spectrum::ALL {
            ui.selectable_value(&mut settings.spectrum, spectrum, name);
        }
    });
    widgets.note("spectrum", &combo.response);
}

fn fetch(ui: &mut Ui, settings: &mut Settings, widgets: &mut Widgets) {
    let switch = switch(ui, &mut settings.fetch_km, FETCH_KM, "fetch");
    widgets.note("fetchSwitch", &switch);
    switch.on_hover_text("The sea grows over this distance; without it, it has the Beaufort table's height");
    if let Some(fetch_km) = &mut settings.fetch_km {
        note(ui, widgets, "fetch", slider(fetch_km, 1.0..=5000.0, 0).logarithmic(true).suffix(" km"));
    }
}

fn swell(ui: &mut Ui, settings: &mut Settings, widgets: &mut Widgets) {
    let from_deg = (settings.wind.from_deg + SWELL.from_deg).rem_euclid(360.0);
    let switch = switch(ui, &mut settings.swell, Swell { from_deg, ..SWELL }, "swell");
    widgets.note("swellSwitch", &switch);
    switch.on_hover_text("Waves of a far storm, on top of the wind's");
    if let Some(swell) = &mut settings.swell {
        note(ui, widgets, "swellHeight", slider(&mut swell.height_m, 0.0..=20.0, 1).suffix(" m"));
        note(ui, widgets, "swellPeriod", slider(&mut swell.period_s, 3.0..=30.0, 1).suffix(" s"));
        let from = note(ui, widgets, "swellFrom", slider(&mut swell.from_deg, 0.0..=360.0, 0).suffix("° from"));
        if from.changed() {
            swell.from_deg = swell.from_deg.rem_euclid(360.0);
        }
        from.on_hover_text("Where it comes from, clockwise from north");
    }
}

/// A check box that gives an option its value, or takes it away.
fn switch<T: Copy>(ui: &mut Ui, option: &mut Option<T>, value: T, name: &str) -> Response {
    let mut on = option.is_some();
    let response = ui.checkbox(&mut on, name);
    if response.changed() {
        *option = on.then_some(value);
    }
    response
}

fn slider(value: &mut f64, range: std::ops::RangeInclusive<f64>, decimals: i32) -> Slider<'_> {
    Slider::new(value, range).custom_formatter(digits(decimals))
}

fn note(ui: &mut Ui, widgets: &mut Widgets, name: &'static str, slider: Slider<'_>) -> Response {
    let response = ui.add(slider);
    widgets.note(name, &response);
    response
}
