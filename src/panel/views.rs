//! The named views as small pictures to press.

use egui::{
    Color32, Image, Rect, Sense, Stroke, StrokeKind, TextureHandle, TextureOptions, Ui, WidgetInfo, pos2, vec2,
};

use super::{Action, Widgets};
use crate::data::imagery::decode_jpeg;
use crate::scene::view::named::VIEWS;

/// The views one below another, as `make gallery` draws them.
const SHEET: &[u8] = include_bytes!("../../docs/gallery/views.jpg");
/// Width and height of one of them, pixels.
pub const PICTURE: [usize; 2] = [112, 63];
/// How many stand beside each other.
const COLUMNS: usize = 5;
const GAP: f32 = 3.0;

/// The pictures, on the device once they have been shown.
#[derive(Default)]
pub struct Views(Option<TextureHandle>);

impl Views {
    /// Shows them; the one that is pressed asks for a flight.
    pub fn show(&mut self, ui: &mut Ui, widgets: &mut Widgets) -> Option<Action> {
        let sheet =
            self.0.get_or_insert_with(|| ui.ctx().load_texture("views", sheet(), TextureOptions::LINEAR)).clone();
        let width = (ui.available_width() - GAP * (COLUMNS - 1) as f32) / COLUMNS as f32;
        let size = vec2(width, width * PICTURE[1] as f32 / PICTURE[0] as f32);
        let mut action = None;
        ui.spacing_mut().item_spacing = vec2(GAP, GAP);
        for (row, views) in VIEWS.chunks(COLUMNS).enumerate() {
            ui.horizontal(|ui| {
                for (column, view) in views.iter().enumerate() {
                    let (rect, button) = ui.allocate_exact_size(size, Sense::click());
                    let part = part_of_sheet(row * COLUMNS + column);
                    ui.painter().image(sheet.id(), rect, part, Color32::WHITE);
                    if button.hovered() || button.has_focus() {
                        let stroke = Stroke::new(1.5, ui.visuals().selection.bg_fill);
                        ui.painter().rect_stroke(rect, 0.0, stroke, StrokeKind::Outside);
                    }
                    button.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, view.title));
                    widgets.note(view.widget, &button);
                    if button.clicked() {
                        action = Some(Action::Fly(view));
                    }
                    button.on_hover_ui(|ui| {
                        let size = vec2(PICTURE[0] as f32, PICTURE[1] as f32) * 1.5;
                        ui.add(Image::new((sheet.id(), size)).uv(part));
                        ui.label(view.title);
                    });
                }
            });
        }
        action
    }
}

/// Where a view's picture is in the sheet, as parts of its sides.
fn part_of_sheet(index: usize) -> Rect {
    let share = |line: usize| line as f32 / VIEWS.len() as f32;
    Rect::from_min_max(pos2(0.0, share(index)), pos2(1.0, share(index + 1)))
}

/// The sheet; grey where it cannot be read, which a test rules out.
fn sheet() -> egui::ColorImage {
    let size = [PICTURE[0], PICTURE[1] * VIEWS.len()];
    match decode_jpeg("the pictures of the views", SHEET, size[1], "make gallery") {
        Ok((found, texels)) if found == size => egui::ColorImage::from_rgb(size, &texels),
        _ => egui::ColorImage::filled(size, Color32::GRAY),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_is_a_picture_of_every_view() {
        let (size, texels) = decode_jpeg("the pictures of the views", SHEET, 10_000, "make gallery").unwrap();
        assert_eq!(size, [PICTURE[0], PICTURE[1] * VIEWS.len()]);
        for (view, picture) in VIEWS.iter().zip(texels.chunks_exact(3 * PICTURE[0] * PICTURE[1])) {
            let (low, high) = picture.iter().fold((255, 0), |(low, high), &v| (v.min(low), v.max(high)));
            assert!(high - low > 60, "the picture of {} shows nothing", view.id);
        }
    }
}
