//! Text over the picture: what is under the cursor, the scale, who is to be credited.

use egui::{Align2, Color32, FontId, Pos2, Rect, pos2, vec2};
use glam::DVec2;

use crate::data::sample::Sample;
use crate::data::water::WaterClass;
use crate::data::world::World;
use crate::model::earth::{Geodetic, WGS84};
use crate::model::geodesic::surface_distance;
use crate::scene::layers::Layer;
use crate::scene::settings::Settings;
use crate::scene::view::camera::Camera;

/// Longest bar of the scale, points.
const LONGEST_BAR: f64 = 130.0;

/// What is written over the picture.
pub struct Overlay<'a> {
    /// The eye.
    pub camera: &'a Camera,
    /// Size of the picture, physical pixels.
    pub size: DVec2,
    /// Physical pixels per point of the screen.
    pub pixels_per_point: f64,
    /// The cursor in the picture, physical pixels.
    pub cursor: Option<DVec2>,
}

/// Who is to be credited for what the program holds itself: the others ask for a line in NOTICE alone.
const TOWNS_CREDIT: &str = "Towns: GeoNames, CC BY 4.0";

impl Overlay<'_> {
    /// Writes it along the lower edge.
    pub fn show(&self, ui: &egui::Ui, rect: Rect, world: &mut World, settings: &Settings) {
        let line = |number: f32| rect.left_bottom() + vec2(8.0, -6.0 - 16.0 * number);
        let credits = [world.credits(), vec![TOWNS_CREDIT.to_owned()]].concat().join(" · ");
        if settings.layers.shows(Layer::Credits) {
            // As wide as the window, in as many lines as it takes, from below.
            let width = rect.width() - 16.0;
            let galley = ui.painter().layout(credits, FontId::proportional(10.0), Color32::from_gray(225), width);
            let at = rect.left_bottom() + vec2(8.0, -4.0 - galley.size().y);
            let shade = Rect::from_min_size(at, galley.size()).expand2(vec2(4.0, 1.0));
            ui.painter().rect_filled(shade, 2.0, Color32::from_black_alpha(110));
            ui.painter().galley(at, galley, Color32::WHITE);
        }
        let place = self.cursor.and_then(|pixel| self.camera.unproject(pixel, self.size));
        let sample = place.and_then(|place| world.sample_passing(place.lat, place.lon));
        let text = place.map_or_else(String::new, |place| described(place, sample));
        outlined(ui, line(2.2), &text);
        let rest_m = settings.datum.rest_m(self.camera.lat, self.camera.lon);
        let coming = match world.pending() {
            0 => String::new(),
            tiles => format!("  loading {tiles} tiles"),
        };
        outlined(ui, line(3.2), &format!("eye {}{coming}", height(self.camera.altitude_m + rest_m)));
        if let Some((metres, points)) = self.scale() {
            draw_scale(ui, line(4.4), metres, points as f32);
        }
    }

    /// Length of the scale bar: round metres on the ground at the picture's centre, and points on the screen.
    fn scale(&self) -> Option<(f64, f64)> {
        let half = DVec2::new(20.0 * self.pixels_per_point, 0.0);
        let ends = [self.size / 2.0 - half, self.size / 2.0 + half];
        let [from, to] = ends.map(|pixel| self.camera.unproject(pixel, self.size));
        let (from, to) = (from?, to?);
        let metres_per_point = surface_distance(WGS84, (from.lat, from.lon), (to.lat, to.lon)).ok()? / 40.0;
        let metres = round_below(metres_per_point * LONGEST_BAR)?;
        Some((metres, metres / metres_per_point))
    }
}

/// The largest of 1, 2 and 5 times a power of ten that is not above a length.
fn round_below(length: f64) -> Option<f64> {
    let power = 10f64.powf(length.log10().floor());
    let round = [5.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|round| *round <= length)?;
    (round.is_finite() && round > 0.0).then_some(round)
}

/// A place in words: latitude, longitude, and what is there.
fn described(place: Geodetic, sample: Option<Sample>) -> String {
    let half = |degrees: f64, plus: char, minus: char| {
        format!("{:.4}° {}", degrees.abs(), if degrees < 0.0 { minus } else { plus })
    };
    let place = format!("{}  {}", half(place.lat.to_degrees(), 'N', 'S'), half(place.lon.to_degrees(), 'E', 'W'));
    let Some(sample) = sample else { return place };
    let what = match (sample.class, sample.depth_m) {
        (WaterClass::Ocean, Some(depth_m)) => format!("ocean, {depth_m:.0} m deep"),
        (WaterClass::Ocean, None) => "ocean".to_owned(),
        (WaterClass::Lake, _) => format!("lake, {:.0} m", sample.elevation_m),
        (WaterClass::River, _) => format!("river, {:.0} m", sample.elevation_m),
        (WaterClass::Island, _) => format!("island in a lake, {:.0} m", sample.elevation_m),
        (WaterClass::Land, _) => format!("land, {:.0} m", sample.elevation_m),
    };
    format!("{place}  {what}")
}

/// A length in metres or kilometres with three digits.
pub fn height(metres: f64) -> String {
    match metres.abs() {
        m if m < 100.0 => format!("{metres:.1} m"),
        m if m < 10_000.0 => format!("{metres:.0} m"),
        m if m < 100_000.0 => format!("{:.1} km", metres / 1000.0),
        _ => format!("{:.0} km", metres / 1000.0),
    }
}

fn draw_scale(ui: &egui::Ui, at: Pos2, metres: f64, points: f32) {
    let label = if metres < 1000.0 { format!("{metres} m") } else { format!("{} km", metres / 1000.0) };
    let bar = [at, at + vec2(points, 0.0)];
    for (width, colour) in [(3.0, Color32::from_black_alpha(160)), (1.2, Color32::WHITE)] {
        let stroke = egui::Stroke::new(width, colour);
        ui.painter().line_segment(bar, stroke);
        for end in bar {
            ui.painter().line_segment([end, end + vec2(0.0, -5.0)], stroke);
        }
    }
    outlined(ui, at + vec2(points + 6.0, 5.0), &label);
}

/// Text with a dark edge, legible over sea, snow and night. `at`: its lower left corner.
fn outlined(ui: &egui::Ui, at: Pos2, text: &str) {
    let font = FontId::proportional(12.5);
    let shade = Color32::from_black_alpha(190);
    for offset in [pos2(-1.0, 0.0), pos2(1.0, 0.0), pos2(0.0, -1.0), pos2(0.0, 1.0)] {
        ui.painter().text(at + offset.to_vec2(), Align2::LEFT_BOTTOM, text, font.clone(), shade);
    }
    ui.painter().text(at, Align2::LEFT_BOTTOM, text, font, Color32::WHITE);
}
