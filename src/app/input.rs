//! Mouse, wheel, touch and keys become moves of the eye.
//!
//! | hand | move |
//! |---|---|
//! | drag | the grabbed place follows the cursor |
//! | wheel, pinch | height, towards the cursor |
//! | right drag, ctrl drag; two fingers turned, moved up and down | heading and tilt |
//! | arrows; shift + arrows | move; heading and tilt |
//! | + and −, Page Up and Page Down | height |

use egui::{Key, PointerButton, Pos2, Rect};
use glam::DVec2;

use crate::data::fetch::now_s;
use crate::scene::view::camera::{Camera, FIELD_OF_VIEW_Y};
use crate::scene::view::inertia::{Keys, Navigator};
use crate::scene::view::navigate;

/// Points of wheel travel that change the height by a factor of e.
const WHEEL_POINTS: f32 = 250.0;

/// Time that moves of the pointer wait for a picture at most, seconds.
const LONGEST_WAIT_S: f64 = 1.0;

/// How long these events may still wait for a picture that the device has been at for `busy_s` seconds. Only moves may: of a button and of
/// keys the time and place count when they are pressed.
pub fn wait_s(events: &[egui::Event], busy_s: f64) -> Option<f64> {
    use egui::{Event, TouchPhase};
    let moves = events.iter().all(|event| {
        let touch_moves = matches!(event, Event::Touch { phase: TouchPhase::Move, .. });
        touch_moves || matches!(event, Event::PointerMoved(_) | Event::MouseMoved(_) | Event::MouseWheel { .. })
    });
    (moves && busy_s < LONGEST_WAIT_S).then_some(LONGEST_WAIT_S - busy_s)
}

/// The hands at the window in one frame.
pub struct Hands<'a> {
    /// Where the input comes from.
    pub ui: &'a egui::Ui,
    /// The picture as a widget: tells what is meant for it and not for the panel.
    pub response: &'a egui::Response,
    /// Size of the picture, physical pixels.
    pub size: DVec2,
    /// Height of the ground below the eye, metres.
    pub ground_m: f64,
}

/// The physical pixel of the picture at a point of the screen.
pub fn pixel(at: Pos2, rect: Rect, pixels_per_point: f64) -> DVec2 {
    DVec2::new(f64::from(at.x - rect.min.x), f64::from(at.y - rect.min.y)) * pixels_per_point
}

impl Hands<'_> {
    /// Whether the user does anything that ends a flight.
    pub fn takes_over(&self) -> bool {
        let pressed = self.response.is_pointer_button_down_on();
        pressed || self.wheel_ratio() != 1.0 || self.keys() != Keys::default()
    }

    /// Moves the eye by what happened in this frame; returns the keys that are held.
    pub fn apply(&self, navigator: &mut Navigator, camera: &mut Camera, last_drag_s: &mut f64) -> Keys {
        let ratio = self.wheel_ratio();
        if let Some(at) = self.ui.input(|input| input.pointer.hover_pos())
            && ratio != 1.0
        {
            navigator.zoom_by(ratio, self.pixel(at));
        }
        if let Some(touch) = self.ui.input(|input| input.multi_touch()) {
            navigator.stop();
            self.two_fingers(&touch, camera);
        } else {
            self.one_pointer(navigator, camera, last_drag_s);
        }
        self.keys()
    }

    fn pixel(&self, at: Pos2) -> DVec2 {
        pixel(at, self.response.rect, f64::from(self.ui.ctx().pixels_per_point()))
    }

    /// Radians that the view turns per physical pixel.
    fn turn_per_pixel(&self) -> f64 {
        1.5 * FIELD_OF_VIEW_Y / self.size.y.max(1.0)
    }

    /// What the wheel or a trackpad's pinch asks for, as a factor of the height.
    fn wheel_ratio(&self) -> f64 {
        if !self.response.contains_pointer() {
            return 1.0;
        }
        let (scroll, pinch, touch) =
            self.ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta(), input.multi_touch().is_some()));
        if touch { 1.0 } else { f64::from((-scroll / WHEEL_POINTS).exp() / pinch.max(1e-3)) }
    }

    fn one_pointer(&self, navigator: &mut Navigator, camera: &mut Camera, last_drag_s: &mut f64) {
        let (primary, secondary, ctrl, delta, at, now) = self.ui.input(|input| {
            let pointer = &input.pointer;
            let turning = pointer.button_down(PointerButton::Secondary) || pointer.button_down(PointerButton::Middle);
            let ctrl = input.modifiers.ctrl || input.modifiers.command;
            (pointer.primary_down(), turning, ctrl, pointer.delta(), pointer.interact_pos(), now_s())
        });
        let held = self.response.is_pointer_button_down_on();
        let turning = held && (secondary || (primary && ctrl));
        let dragging = held && primary && !turning;
        if turning && delta != egui::Vec2::ZERO {
            let points = f64::from(self.ui.ctx().pixels_per_point()) * self.turn_per_pixel();
            let (heading, tilt) = (-f64::from(delta.x) * points, f64::from(delta.y) * points);
            *camera = navigate::turn(camera, heading, tilt, self.size, self.ground_m);
        }
        match at {
            Some(at) if dragging && !navigator.is_grabbed() => {
                navigator.grab(camera, self.pixel(at), self.size, self.ground_m);
                *last_drag_s = now;
            }
            Some(at) if dragging && delta != egui::Vec2::ZERO => {
                navigator.drag(camera, self.pixel(at), self.size, self.ground_m, now - *last_drag_s);
                *last_drag_s = now;
            }
            _ if !dragging && navigator.is_grabbed() => navigator.release(camera, now - *last_drag_s),
            _ => {}
        }
        if self.response.double_clicked()
            && let Some(at) = at
        {
            navigator.zoom_by(0.4, self.pixel(at));
        }
    }

    fn two_fingers(&self, touch: &egui::MultiTouchInfo, camera: &mut Camera) {
        let centre = self.pixel(touch.center_pos);
        let ratio = 1.0 / f64::from(touch.zoom_delta.max(1e-3));
        *camera = navigate::zoom(camera, ratio, centre, self.size, self.ground_m);
        let points = f64::from(self.ui.ctx().pixels_per_point()) * self.turn_per_pixel();
        let (heading, tilt) = (-f64::from(touch.rotation_delta), -f64::from(touch.translation_delta.y) * points);
        *camera = navigate::turn(camera, heading, tilt, self.size, self.ground_m);
    }

    fn keys(&self) -> Keys {
        if self.ui.ctx().egui_wants_keyboard_input() {
            return Keys::default();
        }
        self.ui.input(|input| {
            let axis = |minus: &[Key], plus: &[Key]| {
                let down = |keys: &[Key]| f64::from(u8::from(keys.iter().any(|&key| input.key_down(key))));
                down(plus) - down(minus)
            };
            let arrows =
                DVec2::new(axis(&[Key::ArrowLeft], &[Key::ArrowRight]), axis(&[Key::ArrowDown], &[Key::ArrowUp]));
            let rise = axis(&[Key::Plus, Key::Equals, Key::PageDown], &[Key::Minus, Key::PageUp]);
            let (slide, turn) = if input.modifiers.shift { (DVec2::ZERO, arrows) } else { (arrows, DVec2::ZERO) };
            if input.modifiers.ctrl || input.modifiers.command {
                return Keys::default();
            }
            Keys { slide, rise, turn }
        })
    }
}

#[cfg(test)]
mod tests {
    use egui::{Event, Modifiers, PointerButton, pos2};

    use super::{Key, LONGEST_WAIT_S, wait_s};

    #[test]
    fn moves_wait_for_a_picture_and_nothing_else_does() {
        let moved = Event::PointerMoved(pos2(3.0, 4.0));
        let pressed = Event::PointerButton {
            pos: pos2(3.0, 4.0),
            button: PointerButton::Primary,
            pressed: true,
            modifiers: Modifiers::NONE,
        };
        let key =
            Event::Key { key: Key::H, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::NONE };
        assert_eq!(wait_s(&[], 0.0), Some(LONGEST_WAIT_S));
        assert_eq!(wait_s(&[moved.clone(), moved.clone()], 0.25), Some(LONGEST_WAIT_S - 0.25));
        assert_eq!(wait_s(std::slice::from_ref(&moved), LONGEST_WAIT_S), None);
        assert_eq!(wait_s(&[moved.clone(), pressed], 0.0), None);
        assert_eq!(wait_s(&[key, moved], 0.0), None);
    }
}
