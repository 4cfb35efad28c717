//! The whole program in a window that nobody sees: input, panel, address and the picture on egui's target.

use std::time::Duration;

use egui::{Event, Key, Modifiers, Pos2, Rect, pos2, vec2};
use egui_wgpu::wgpu;
use ocean_globe::renderer::TARGET_FORMAT;
use ocean_globe::scene::view::state::ViewState;

use crate::hidden_window::{Window, renderer, target};

const STILL: &str = "view=35,-30,12,270,80&wind=14@250&clouds=0&time=2026-06-21T12:30:00Z&rate=0&seed=7";

#[test]
fn without_the_panel_the_window_shows_the_renderers_picture_exactly() {
    let size = [320, 180];
    // A sea with whitecaps, whose past the window replays over several frames.
    let mut window = Window::open(STILL, false, size);
    window.settle();
    let seen = window.frame(vec![]);
    // The same frame by the renderer alone, on the same device.
    let mut alone = renderer(&window.gpu);
    let state = ViewState::parse_fragment(STILL, None).0;
    let unix_seconds = state.time.unix_seconds(0.0);
    let eye = alone.seas_mut().eye(&state, unix_seconds);
    let frame = alone.frame(&state.settings, &eye, unix_seconds, size);
    while !alone.load(&frame) || alone.world_mut().pending() > 0 {
        std::thread::sleep(Duration::from_millis(5));
    }
    // The window has replayed the foam's history over several frames.
    alone.settle(&frame);
    let own = target(&window.host.device, TARGET_FORMAT, size);
    let mut encoder = window.host.device.create_command_encoder(&Default::default());
    alone.render(&mut encoder, &frame, &own.create_view(&Default::default()));
    window.host.queue.submit([encoder.finish()]);
    let own = window.gpu.read_texture(&own, 0, 0).expect("a readable target");
    assert_eq!(seen.len(), own.len());
    let different = seen.chunks(4).zip(own.chunks(4)).filter(|(a, b)| a[..3] != b[..3]).count();
    assert_eq!(different, 0, "of {} pixels", seen.len() / 4);
    let first = seen[..3].to_vec();
    assert!(seen.chunks(4).any(|pixel| pixel[..3] != first), "a picture of one colour proves nothing");
}

#[test]
fn the_picture_shows_through_the_panels_ground_and_is_itself_beside_it() {
    let size = [640, 360];
    let mut window = Window::open(STILL, true, size);
    window.settle();
    let with = window.frame(vec![]);
    let fold = window.widget("fold").expect("a panel");
    window.key(Key::H);
    let without = window.frame(vec![]);
    let ground = ocean_globe::panel::ground_colour().to_array().map(f64::from);
    let at = |x: f32, y: u32| 4 * (x as usize + (y * size[0]) as usize);
    for y in 20..300 {
        // In the margin left of everything in the panel.
        let inside = at(fold.min.x - 4.0, y);
        for part in 0..3 {
            let through = ground[part] + (1.0 - ground[3] / 255.0) * f64::from(without[inside + part]);
            let seen = f64::from(with[inside + part]);
            assert!((seen - through).abs() <= 1.0, "row {y}, colour {part}: {seen}, not {through}");
        }
        let outside = at(fold.min.x - 12.0, y);
        assert_eq!(with[outside..outside + 3], without[outside..outside + 3], "row {y} beside the panel");
    }
}

#[test]
fn the_panel_fits_a_small_window_and_its_widgets_work() {
    let odd = "view=35.6812,-14.25,560,186,78&wind=12.345@250&bft=8&chop=0.123&time=2026-11-20T23:59:59.9Z&rate=0";
    let mut window = Window::open(odd, true, [640, 360]);
    let screen = Rect::from_min_size(Pos2::ZERO, vec2(640.0, 360.0));
    for name in [
        "fold",
        "copyLink",
        "windDial",
        "windSpeed",
        "beaufort",
        "viewGlobe",
        "viewHurricane",
        "time",
        "pause",
        "now",
        "more",
    ] {
        let rect = window.widget(name).unwrap_or_else(|| panic!("no widget {name}"));
        assert!(screen.contains_rect(rect) && rect.is_positive(), "{name} at {rect}");
    }
    // Nothing was touched, so nothing has changed.
    assert_eq!(window.fact("fragment"), odd);
    // Wind speed: a click near the right end of the slider's rail.
    let slider = window.widget("windSpeed").expect("a slider");
    let at = pos2(slider.min.x + 60.0, slider.center().y);
    window.press(at, true);
    window.press(at, false);
    window.frame(vec![]);
    assert!(window.state().settings.wind.speed_mps > 30.0, "{}", window.fact("fragment"));
    // The dial: its right edge is east.
    let dial = window.widget("windDial").expect("a dial");
    let at = dial.right_center() - vec2(3.0, 0.0);
    window.press(at, true);
    window.press(at, false);
    window.frame(vec![]);
    assert_eq!(window.state().settings.wind.from_deg, 90.0);
    window.click("pause");
    assert_eq!(window.state().rate, 1.0);
    window.click("pause");
    assert_eq!(window.state().rate, 0.0);
    window.key(Key::Space);
    assert_eq!(window.state().rate, 1.0);
    window.click("copyLink");
    let copied = window.commands.iter().find_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let copied = copied.expect("text in the clipboard");
    assert!(copied.starts_with("https://page.example/#view=35.6812,-14.25,560,186,78&wind="), "{copied}");
    // Folded it takes little room; hidden it takes none and publishes no widgets.
    window.click("fold");
    assert!(window.widget("windSpeed").is_none() && window.widget("fold").is_some());
    window.key(Key::H);
    assert_eq!(window.fact("widgets"), "{}");
}

#[test]
fn a_named_view_makes_an_entry_in_the_history_and_the_address_follows() {
    let mut window = Window::open(STILL, true, [640, 360]);
    assert!(window.page.borrow().addresses.is_empty(), "opening a link leaves the address as it is");
    window.click("viewGale");
    let pushed: Vec<_> = window.page.borrow().addresses.iter().filter(|(_, push)| *push).cloned().collect();
    assert_eq!(pushed.len(), 1);
    assert!(pushed[0].0.contains("bft=8") && pushed[0].0.contains("ride=1"), "{}", pushed[0].0);
    assert_eq!(window.state().settings.beaufort, Some(8));
    // Back: the page's address changes under the program.
    window.page.borrow_mut().arriving = Some(STILL.to_owned());
    window.frame(vec![]);
    assert_eq!(window.fact("fragment"), STILL);
    let written = window.page.borrow().addresses.len();
    window.frame(vec![]);
    assert_eq!(window.page.borrow().addresses.len(), written, "what came from the address is not written back");
    // Garbage leaves the view.
    window.page.borrow_mut().arriving = Some(format!("{STILL}&chop=x&view=1,2&%%%"));
    window.frame(vec![]);
    assert_eq!(window.state().camera, ViewState::parse_fragment(STILL, None).0.camera);
}

#[test]
fn a_drag_and_the_wheel_move_the_eye_and_the_panel_does_not_let_them_through() {
    let still = "view=35.6812,-14.25,20000,0,0&clouds=0&time=2026-11-20T12:00:00Z&rate=0";
    let mut window = Window::open(still, true, [480, 270]);
    let start = window.state().camera;
    window.press(pos2(100.0, 130.0), true);
    window.frame(vec![Event::PointerMoved(pos2(160.0, 130.0))]);
    window.press(pos2(160.0, 130.0), false);
    let dragged = window.state().camera;
    assert!(dragged.lon < start.lon && (dragged.lat - start.lat).abs() < 1e-4, "{dragged:?}");
    let scroll = |at: Pos2| {
        let wheel = Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: vec2(0.0, 100.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers: Modifiers::NONE,
        };
        vec![Event::PointerMoved(at), wheel]
    };
    window.frame(scroll(pos2(100.0, 130.0)));
    (0..10).for_each(|_| drop(window.frame(vec![])));
    let low = window.state().camera;
    assert!(low.altitude_m < dragged.altitude_m * 0.95, "{low:?}");
    // The eye glides to rest in its own time: until nothing asks for another frame.
    while window.repaint_delay < Duration::from_secs(1) {
        std::thread::sleep(Duration::from_millis(10));
        window.frame(vec![]);
    }
    let rest = window.state().camera;
    let over_panel = window.widget("pause").expect("a panel").center() + vec2(0.0, 14.0);
    window.frame(scroll(over_panel));
    (0..10).for_each(|_| drop(window.frame(vec![])));
    assert_eq!(window.state().camera, rest);
}

#[test]
fn a_moving_picture_of_a_processor_is_coarser_and_one_at_rest_is_full() {
    let still = "view=38,-2,3000000&clouds=0&time=2026-06-21T12:30:00Z&rate=0";
    // The first pictures are as coarse as the canvas asks for on any processor; a quick one would soon make finer ones.
    let mut window = Window::open(still, false, [640, 360]);
    assert!(window.gpu.software, "{} is a graphics card: this test is about processors", window.gpu.adapter);
    let before = window.pictures();
    window.press(pos2(300.0, 180.0), true);
    for step in 0..5 {
        window.frame(vec![Event::PointerMoved(pos2(300.0 + 6.0 * step as f32, 180.0))]);
        let _ = window.gpu.device.poll(wgpu::PollType::wait_indefinitely());
    }
    window.frame(vec![]);
    assert!(window.pictures() > before + 2, "{} pictures of a drag", window.pictures() - before);
    let scale: f64 = window.fact("scale").parse().expect("a number");
    assert!((0.4..0.9).contains(&scale), "a scale of {scale}");
    assert_eq!(window.fact("state"), "loading");
    window.press(pos2(330.0, 180.0), false);
    window.settle();
    assert_eq!(window.fact("scale"), "1.00");
    // A quality that somebody has chosen is drawn as it is, moving or not.
    window.page.borrow_mut().arriving = Some(format!("{still}&quality=low"));
    window.frame(vec![]);
    let _ = window.gpu.device.poll(wgpu::PollType::wait_indefinitely());
    window.frame(vec![]);
    assert_eq!(window.fact("scale"), "1.00");
}

#[test]
fn from_orbit_time_runs_without_a_picture_and_at_the_deck_with_many() {
    let running = |view: &str| format!("{view}&time=2026-06-21T12:30:00Z&seed=7&quality=low");
    let mut orbit = Window::open(&running("view=16,-25,30000000&clouds=0"), false, [160, 90]);
    orbit.settle();
    let shown_s = orbit.state().time;
    // 276 km to a pixel: the terminator moves half of it in five minutes. One picture may fall into any three seconds.
    let [frames, pictures] = orbit.run_for(3.0);
    assert!(pictures <= 1 && frames <= 12, "{pictures} pictures, {frames} frames");
    assert!(orbit.repaint_delay > Duration::from_secs(1) || pictures > 0, "{:?}", orbit.repaint_delay);
    orbit.frame(vec![]);
    assert_ne!(orbit.state().time, shown_s, "the time stands still");
    let mut deck = Window::open(&running("view=35,-30,12,270,80&wind=5@250&clouds=0"), false, [160, 90]);
    deck.settle();
    let [frames, pictures] = deck.run_for(3.0);
    assert!(pictures >= 3 && frames >= pictures, "{pictures} pictures, {frames} frames");
}
