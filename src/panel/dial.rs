//! A compass on which an arrow shows the wind: it flies from where the wind comes FROM to the middle.

use egui::{Color32, Response, Sense, Stroke, Ui, WidgetInfo, vec2};

/// Side of the dial, points.
const SIDE: f32 = 58.0;

/// Degrees that one press of an arrow key turns.
const KEY_STEP_DEG: f64 = 5.0;

/// Shows the dial; dragging anywhere in it points the arrow's tail at the cursor. Degrees clockwise from north.
pub fn show(ui: &mut Ui, from_deg: &mut f64) -> Response {
    let (rect, mut response) = ui.allocate_exact_size(vec2(SIDE, SIDE), Sense::click_and_drag());
    if response.is_pointer_button_down_on()
        && let Some(at) = response.interact_pointer_pos()
    {
        let offset = at - rect.center();
        if offset.length() > 2.0 {
            // Screen y points down; north is up.
            *from_deg = f64::from(offset.x).atan2(f64::from(-offset.y)).to_degrees().round().rem_euclid(360.0);
            response.mark_changed();
        }
    }
    if response.has_focus() {
        let (left, right) =
            ui.input(|input| (input.num_presses(egui::Key::ArrowLeft), input.num_presses(egui::Key::ArrowRight)));
        let step_deg = KEY_STEP_DEG * (right as f64 - left as f64);
        if step_deg != 0.0 {
            *from_deg = (*from_deg + step_deg).rem_euclid(360.0);
            response.mark_changed();
        }
    }
    response.widget_info(|| WidgetInfo::slider(true, *from_deg, "wind from, degrees"));
    paint(ui, &response, *from_deg);
    response.on_hover_text("Where the wind comes from. Drag the arrow.")
}

fn paint(ui: &Ui, response: &Response, from_deg: f64) {
    let visuals = ui.style().interact(response);
    let (centre, radius) = (response.rect.center(), SIDE / 2.0 - 2.0);
    let painter = ui.painter();
    painter.circle(centre, radius, ui.visuals().extreme_bg_color, Stroke::new(1.0, visuals.fg_stroke.color));
    for quarter in 0..16 {
        let (sin, cos) = (std::f32::consts::TAU * quarter as f32 / 16.0).sin_cos();
        let inner = if quarter % 4 == 0 { 0.78 } else { 0.9 };
        let mark = Stroke::new(1.0, Color32::from_gray(if quarter == 0 { 255 } else { 120 }));
        painter.line_segment([centre + vec2(sin, -cos) * radius * inner, centre + vec2(sin, -cos) * radius], mark);
    }
    let (sin, cos) = (from_deg.to_radians() as f32).sin_cos();
    let tail = vec2(sin, -cos) * radius * 0.85;
    painter.arrow(centre + tail, -tail * 1.7, Stroke::new(2.0, Color32::from_rgb(120, 200, 255)));
}
