//! The eye and its moves: everywhere on the globe, at every height, with no special place.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use ocean_globe::model::earth::{Geodetic, WGS84};
use ocean_globe::scene::view::camera::{Camera, HIGHEST_M, LOWEST_M, wrap_positive, wrap_signed};
use ocean_globe::scene::view::flight::Flight;
use ocean_globe::scene::view::inertia::{Keys, Navigator};
use ocean_globe::scene::view::named::VIEWS;
use ocean_globe::scene::view::navigate;

const SIZE: DVec2 = DVec2::new(1280.0, 720.0);

/// Eyes over every awkward place: 0/0, both poles and beside them, the antimeridian from both sides, low and high.
const EYES: [[f64; 5]; 14] = [
    [0.0, 0.0, 2e6, 0.0, 0.0],
    [0.0, 0.0, 2.0, 10.0, 80.0],
    [90.0, 0.0, 3e6, 0.0, 0.0],
    [90.0, 77.0, 50.0, 200.0, 60.0],
    [89.9, -120.0, 5e4, 30.0, 20.0],
    [-90.0, 0.0, 2e7, 90.0, 0.0],
    [-89.99, 45.0, 1000.0, 300.0, 45.0],
    [10.0, 180.0, 1e6, 0.0, 0.0],
    [-17.0, -179.9999, 560.0, 270.0, 70.0],
    [66.0, 179.9999, 3e4, 90.0, 50.0],
    [35.68, -14.25, 560.0, 120.0, 78.0],
    [48.0, -5.0, 1.0, 350.0, 60.0],
    [20.0, -30.0, 2e7, 0.0, 0.0],
    [75.0, 20.0, 2e5, 0.0, 40.0],
];

fn eyes() -> impl Iterator<Item = Camera> {
    EYES.iter().map(|&[lat, lon, alt, heading, tilt]| Camera::from_degrees(lat, lon, alt, heading, tilt))
}

fn is_sound(camera: &Camera) -> bool {
    let numbers = [camera.lat, camera.lon, camera.altitude_m, camera.heading, camera.tilt];
    numbers.iter().all(|number| number.is_finite()) && *camera == camera.normalized()
}

#[test]
fn the_axes_are_orthonormal_and_point_where_the_numbers_say() {
    for camera in eyes() {
        let axes = camera.basis();
        assert!((axes.right.cross(axes.up) + axes.forward).length() < 1e-14, "{camera:?}");
        let up = ocean_globe::model::earth::normal(camera.lat, camera.lon);
        assert!((axes.forward.dot(up) + camera.tilt.cos()).abs() < 1e-14, "{camera:?}");
    }
    // Level, looking east from 0/0: forward is +y, up is +x.
    let axes = Camera::from_degrees(0.0, 0.0, 10.0, 90.0, 90.0).basis();
    assert!((axes.forward - DVec3::Y).length() < 1e-15 && (axes.up - DVec3::X).length() < 1e-15);
}

#[test]
fn a_camera_survives_the_way_through_earth_centred_axes() {
    for camera in eyes() {
        let back = Camera::from_ecef(camera.eye_ecef(), &camera.basis()).expect("an eye outside the earth");
        // At a pole longitude and heading are one angle; the axes say whether the view is the same.
        let (a, b) = (camera.basis(), back.basis());
        let off = (a.right - b.right).length() + (a.forward - b.forward).length();
        assert!(off < 1e-9, "{camera:?} -> {back:?}: {off}");
        assert!((back.altitude_m - camera.altitude_m).abs() < 1e-6, "{back:?}");
    }
}

#[test]
fn what_is_under_a_pixel_projects_back_to_it() {
    let mut hits = 0;
    for camera in eyes() {
        for (x, y) in [(640.0, 360.0), (600.5, 400.25), (100.0, 700.0), (1279.0, 719.0), (0.0, 0.0)] {
            let pixel = DVec2::new(x, y);
            let Some(place) = camera.unproject(pixel, SIZE) else { continue };
            hits += 1;
            let back = camera.project(place, SIZE).expect("a place that is seen");
            // 1e-6 m of the ground at 1 m is 1e-3 px.
            assert!(back.distance(pixel) < 1e-2, "{camera:?} {pixel} -> {place:?} -> {back}");
        }
    }
    assert!(hits > 45, "only {hits} pixels saw the ground");
}

#[test]
fn a_pixel_in_the_sky_has_no_place_and_a_place_behind_has_no_pixel() {
    let level = Camera::from_degrees(30.0, 40.0, 2.0, 0.0, 90.0);
    assert!(level.unproject(DVec2::new(640.0, 100.0), SIZE).is_none());
    assert!(level.unproject(DVec2::new(640.0, 500.0), SIZE).is_some());
    assert!(level.project(Geodetic::from_deg(29.0, 40.0, 0.0), SIZE).is_none());
    assert!(level.project(Geodetic::from_deg(30.001, 40.0, 0.0), SIZE).is_some());
    // A place due east of an eye that looks north-east is to the right of the middle; a higher one is above it.
    let eye = Camera::from_degrees(0.0, 0.0, 2.0, 45.0, 90.0);
    let low = eye.project(Geodetic::from_deg(0.0, 0.01, 0.0), SIZE).expect("in front");
    let high = eye.project(Geodetic::from_deg(0.0, 0.01, 50.0), SIZE).expect("in front");
    assert!(low.x > 640.0 && high.y < low.y);
}

#[test]
fn a_drag_keeps_the_grabbed_place_under_the_cursor() {
    let mut moves = 0;
    for start in eyes() {
        let mut camera = start;
        let mut hand = Navigator::default();
        let grabbed = DVec2::new(660.0, 430.0);
        let Some(place) = camera.unproject(grabbed, SIZE) else { panic!("{start:?} sees no ground") };
        hand.grab(&camera, grabbed, SIZE, 0.0);
        for step in 1..=12 {
            let pixel = grabbed + DVec2::new(10.0, 5.0) * f64::from(step);
            hand.drag(&mut camera, pixel, SIZE, 0.0, 1.0 / 60.0);
            let seen = camera.project(place, SIZE).expect("a place that is held");
            assert!(seen.distance(pixel) < 0.5, "{start:?}: {seen} is not {pixel}");
            assert_eq!(camera.altitude_m, start.altitude_m);
            assert_eq!(camera.tilt, start.tilt);
            assert!(is_sound(&camera), "{camera:?}");
            moves += 1;
        }
        assert!(camera.eye_ecef().distance(start.eye_ecef()) > 1e-2 * start.altitude_m, "{start:?} did not move");
    }
    assert_eq!(moves, EYES.len() * 12);
}

#[test]
fn north_stays_up_while_the_globe_is_dragged_along() {
    let mut camera = Camera::from_degrees(30.0, 0.0, 5e6, 0.0, 0.0);
    let mut hand = Navigator::default();
    hand.grab(&camera, DVec2::new(640.0, 360.0), SIZE, 0.0);
    for step in 1..=30 {
        hand.drag(&mut camera, DVec2::new(640.0 - 12.0 * f64::from(step), 360.0), SIZE, 0.0, 0.016);
    }
    assert!(wrap_signed(camera.heading).abs() < 1e-6, "heading {}", camera.heading);
    assert!(camera.lon > 0.2, "the eye went east, to {}", camera.lon);
}

#[test]
fn a_drag_from_the_sky_or_past_the_limb_turns_gently() {
    for (from, to) in [((20.0, 20.0), (60.0, 40.0)), ((640.0, 360.0), (1270.0, 10.0))] {
        let mut camera = Camera::default();
        let mut hand = Navigator::default();
        hand.grab(&camera, from.into(), SIZE, 0.0);
        hand.drag(&mut camera, to.into(), SIZE, 0.0, 0.016);
        let turned = camera.eye_ecef().angle_between(Camera::default().eye_ecef());
        assert!(turned > 0.01 && turned < PI / 2.0 + 1e-9 && is_sound(&camera), "{from:?} {to:?}: {turned}");
    }
}

#[test]
fn the_wheel_multiplies_the_height_and_holds_the_place_under_the_cursor() {
    let mut held = 0;
    for start in eyes() {
        let pixel = DVec2::new(700.0, 500.0);
        let next = navigate::zoom(&start, 0.8, pixel, SIZE, 0.0);
        let expected = (start.altitude_m * 0.8).clamp(LOWEST_M, HIGHEST_M);
        assert!((next.altitude_m / expected - 1.0).abs() < 1e-12, "{start:?} -> {next:?}");
        let place = start.unproject(pixel, SIZE).expect("ground in the lower half");
        let seen = next.project(place, SIZE).expect("a place that is held");
        assert!(seen.distance(pixel) < 0.5, "{start:?} -> {next:?}: {seen}");
        held += 1;
        assert!(is_sound(&next), "{next:?}");
    }
    assert_eq!(held, EYES.len());
}

#[test]
fn the_wheel_alone_leads_from_orbit_to_the_deck_and_back() {
    let mut camera = Camera::from_degrees(20.0, -30.0, HIGHEST_M, 0.0, 0.0);
    let (mut tilt, mut steps) = (camera.tilt, 0);
    while camera.altitude_m > LOWEST_M {
        camera = navigate::zoom(&camera, 0.9, SIZE / 2.0, SIZE, 0.0);
        assert!(camera.tilt >= tilt && camera.tilt - tilt < 0.1, "no jump: {camera:?}");
        (tilt, steps) = (camera.tilt, steps + 1);
        assert!(steps < 300, "stuck at {camera:?}");
    }
    assert!((camera.tilt.to_degrees() - 78.0).abs() < 1e-6, "the deck looks ahead: {camera:?}");
    // Who looks ahead already is not tilted past the deck's view on the way down.
    let ahead = Camera { altitude_m: 6000.0, tilt: 1.2, ..camera };
    let ahead = navigate::zoom(&ahead, 0.004, SIZE / 2.0, SIZE, 0.0);
    assert!((ahead.tilt.to_degrees() - 78.0).abs() < 1e-6, "{ahead:?}");
    for _ in 0..400 {
        camera = navigate::zoom(&camera, 1.1, SIZE / 2.0, SIZE, 0.0);
    }
    assert!(camera.altitude_m == HIGHEST_M && camera.tilt < 1e-9, "{camera:?}");
}

#[test]
fn the_eye_never_goes_below_the_ground() {
    let mut camera = Camera::from_degrees(46.0, 7.0, 4000.0, 0.0, 30.0);
    let mut hand = Navigator::default();
    hand.zoom_by(1e-6, SIZE / 2.0);
    while hand.step(&mut camera, Keys::default(), SIZE, 2500.0, 0.02) {
        assert!(camera.altitude_m >= 2501.0 - 1e-9, "{camera:?}");
    }
    assert!((camera.altitude_m - 2501.0).abs() < 1e-6, "{camera:?}");
    // A hill that comes in below the eye, as finer tiles tell it, lifts it as soon as it moves.
    hand.step(&mut camera, Keys::default(), SIZE, 3000.0, 0.02);
    assert!((camera.altitude_m - 2501.0).abs() < 1e-6, "{camera:?} was lifted at rest");
    hand.step(&mut camera, Keys { slide: DVec2::X, ..Keys::default() }, SIZE, 3000.0, 0.02);
    assert_eq!(camera.altitude_m, 3001.0);
    let lifted = navigate::above_ground(&Camera { altitude_m: -50.0, ..camera }, -430.0);
    assert_eq!(lifted.altitude_m, -50.0, "a dry valley below the sea's level may be entered");
}

#[test]
fn motion_does_not_depend_on_the_frame_rate() {
    let end = |frame_s: f64| {
        let mut camera = Camera::from_degrees(10.0, 20.0, 1e5, 0.0, 0.0);
        let mut hand = Navigator::default();
        hand.grab(&camera, SIZE / 2.0, SIZE, 0.0);
        hand.drag(&mut camera, SIZE / 2.0 + DVec2::new(40.0, 5.0), SIZE, 0.0, 0.016);
        hand.release(&camera, 0.0);
        hand.zoom_by(0.25, SIZE / 2.0);
        for _ in 0..(4.0 / frame_s) as usize {
            hand.step(&mut camera, Keys::default(), SIZE, 0.0, frame_s);
        }
        camera
    };
    let (fast, slow) = (end(1.0 / 120.0), end(1.0 / 10.0));
    assert!((fast.altitude_m / 25_000.0 - 1.0).abs() < 1e-9 && (slow.altitude_m / 25_000.0 - 1.0).abs() < 1e-9);
    // Swinging and rising in turns instead of at once costs a second-order difference; the height is 25 km.
    let apart = fast.eye_ecef().distance(slow.eye_ecef());
    assert!(apart < 2500.0, "{apart} m apart");
    let start = Camera::from_degrees(10.0, 20.0, 1e5, 0.0, 0.0);
    assert!(fast.eye_ecef().distance(start.eye_ecef()) > 75_000.0);
}

#[test]
fn everything_comes_to_rest() {
    let mut camera = Camera::from_degrees(10.0, 20.0, 100.0, 0.0, 70.0);
    let mut hand = Navigator::default();
    let keys = Keys { slide: DVec2::ONE, rise: -1.0, turn: DVec2::new(1.0, 1.0) };
    for _ in 0..30 {
        assert!(hand.step(&mut camera, keys, SIZE, 0.0, 0.016));
    }
    let mut steps = 0;
    while hand.step(&mut camera, Keys::default(), SIZE, 0.0, 0.016) {
        steps += 1;
        assert!(steps < 300, "still moving");
    }
    assert!(camera.heading > 0.1 && camera.altitude_m < 90.0 && is_sound(&camera), "{camera:?}");
}

#[test]
fn turning_looks_up_from_the_ground_but_never_away_from_the_globe_in_space() {
    let low = navigate::turn(&Camera::from_degrees(0.0, 0.0, 10.0, 0.0, 80.0), 0.5, 9.0, SIZE, 0.0);
    assert!((low.tilt - PI).abs() < 1e-12 && (low.heading - 0.5).abs() < 1e-12, "{low:?}");
    let high = navigate::turn(&Camera::default(), 0.0, 9.0, SIZE, 0.0);
    assert!(high.tilt > 0.1 && high.tilt < (6378.2f64 / 26378.1).asin() + 1e-3, "{high:?}");
    // Looking down, the eye circles the place in the middle of the picture.
    let start = Camera::from_degrees(10.0, 10.0, 5e4, 0.0, 30.0);
    let middle = start.unproject(SIZE / 2.0, SIZE).expect("ground");
    let turned = navigate::turn(&start, 1.0, 0.1, SIZE, 0.0);
    let seen = turned.project(middle, SIZE).expect("in front");
    assert!(seen.distance(SIZE / 2.0) < 2.0, "{seen}");
}

#[test]
fn no_number_is_lost_at_the_poles() {
    for lat in [90.0, -90.0, 89.999_999_999, -89.999_999_999] {
        for altitude in [1.0, 1e4, 4e7] {
            let mut camera = Camera::from_degrees(lat, 0.0, altitude, 0.0, 0.0);
            let mut hand = Navigator::default();
            for step in 0..40 {
                let keys = Keys { slide: DVec2::new(0.3, 1.0), rise: 0.0, turn: DVec2::new(1.0, 0.2) };
                hand.step(&mut camera, keys, SIZE, 0.0, 0.05);
                assert!(is_sound(&camera), "{lat} {altitude} step {step}: {camera:?}");
                assert!(camera.ray(SIZE / 3.0, SIZE).is_finite() && camera.eye_ecef().is_finite());
            }
        }
    }
}

#[test]
fn a_flight_starts_and_ends_at_its_views_and_is_smooth_between() {
    for (from, to) in VIEWS.iter().zip(VIEWS.iter().rev()) {
        let (from, to) = (from.state().camera, to.state().camera);
        let flight = Flight::new(from, to);
        assert!((2.0..=7.0).contains(&flight.duration_s()));
        assert_eq!((flight.at(0.0), flight.at(flight.duration_s())), (from, to));
        assert_eq!(flight.at(f64::NAN), from);
        let frames = 600;
        let mut last = from;
        // In the water heights count from a metre below the lower end.
        let floor_m = (from.altitude_m.min(to.altitude_m) - 1.0).min(0.0);
        let over = |camera: &Camera| camera.altitude_m - floor_m;
        for frame in 1..=frames {
            let camera = flight.at(flight.duration_s() * f64::from(frame) / f64::from(frames));
            assert!(is_sound(&camera), "{camera:?}");
            assert!((over(&camera) / over(&last)).ln().abs() < 0.15, "{last:?} -> {camera:?}");
            let step_m = (camera.eye_ecef() - last.eye_ecef()).length();
            assert!(step_m < 0.25 * over(&camera).max(over(&last)), "{step_m} m: {last:?} -> {camera:?}");
            last = camera;
        }
    }
    // Across the antimeridian and over the pole by the short way.
    let across = Flight::new(
        Camera::from_degrees(0.0, 179.0, 1e4, 350.0, 0.0),
        Camera::from_degrees(0.0, -179.0, 1e4, 10.0, 0.0),
    );
    let middle = across.at(across.duration_s() / 2.0);
    assert!(middle.lon.abs() > 178.9f64.to_radians() && wrap_signed(middle.heading).abs() < 1e-9, "{middle:?}");
}

#[test]
fn angles_wrap_into_their_ranges_whatever_they_are() {
    for angle in [(-PI).next_down(), 0.0, -1e-300, 1e-300, PI, -PI, 7.0, -7.0, 1e9, -1e9, -f64::EPSILON, 2.0 * PI] {
        assert!((-PI..PI).contains(&wrap_signed(angle)), "{angle}");
        assert!((0.0..2.0 * PI).contains(&wrap_positive(angle)), "{angle}");
    }
    assert!((wrap_signed(PI + 0.1) + PI - 0.1).abs() < 1e-15);
}

#[test]
fn the_scale_at_the_centre_is_that_of_the_ground() {
    let camera = Camera::from_degrees(0.0, 0.0, 1e5, 0.0, 0.0);
    let scale = camera.metres_per_pixel(SIZE).expect("ground");
    let (a, b) = (SIZE / 2.0, SIZE / 2.0 + DVec2::new(10.0, 0.0));
    let points = [a, b].map(|pixel| WGS84.ecef_from_geodetic(camera.unproject(pixel, SIZE).expect("ground")));
    assert!((points[0].distance(points[1]) / (10.0 * scale) - 1.0).abs() < 1e-3);
    assert!(Camera { tilt: 2.0, ..camera }.metres_per_pixel(SIZE).is_none());
}
