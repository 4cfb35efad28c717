//! The part of a picture that is looked at for clouds: every pixel that may show one, and few more.

use glam::DVec2;
use ocean_globe::model::clouds::{BASE_M, ICE_M};
use ocean_globe::model::earth::{Ellipsoid, WGS84};
use ocean_globe::scene::frame::Frame;
use ocean_globe::scene::sea::Seas;
use ocean_globe::scene::settings::Settings;
use ocean_globe::scene::view::camera::Camera;

const SIZE: [u32; 2] = [64, 36];

/// Numbers 0…1 that look random.
fn random(index: u32) -> f64 {
    (f64::from(index) * 0.754_877_666_246_692_7).fract()
}

fn lifted(metres: f64) -> Ellipsoid {
    Ellipsoid { a: WGS84.a + metres, b: WGS84.b + metres }
}

#[test]
fn the_area_holds_every_pixel_that_may_show_a_cloud() {
    let settings = Settings { clouds: Some(0.5), ..Settings::default() };
    let mut seas = Seas::default();
    let extent = DVec2::from(SIZE.map(f64::from));
    let (mut inside, mut needed) = (0, 0);
    for view in 0..600 {
        let [lat, lon, height, heading, tilt] = [0, 1, 2, 3, 4].map(|i| random(5 * view + i + 1));
        // From the deck to 30,000 km, a third of the views at each layer's side.
        let altitude = 2.0 * 10f64.powf(7.2 * height);
        let camera =
            Camera::from_degrees(180.0 * lat - 90.0, 360.0 * lon - 180.0, altitude, 360.0 * heading, 180.0 * tilt);
        let frame = Frame::of(&mut seas, &settings, &camera, 1_795_176_000.0, SIZE);
        let [left, top, width, rows] = frame.clouds.unwrap().area;
        assert!(left + width <= SIZE[0] && top + rows <= SIZE[1]);
        for pixel in 0..SIZE[0] * SIZE[1] {
            let [x, y] = [pixel % SIZE[0], pixel / SIZE[0]];
            let centre = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let shows = if altitude < BASE_M {
                camera.unproject_onto(&WGS84, centre, extent).is_none()
            } else if altitude < ICE_M {
                true
            } else {
                camera.unproject_onto(&lifted(ICE_M), centre, extent).is_some()
            };
            let is_in = (left..left + width).contains(&x) && (top..top + rows).contains(&y);
            assert!(is_in || !shows, "{camera:?}: pixel {x}, {y} of {:?}", frame.clouds);
            inside += u32::from(is_in);
            needed += u32::from(shows);
        }
    }
    println!("{needed} pixels may show clouds, {inside} are looked at");
    // A box around a round globe, and around half of one.
    assert!(f64::from(inside) < 1.35 * f64::from(needed), "{inside} {needed}");
}

#[test]
fn a_globe_in_the_distance_is_a_small_part_of_its_picture() {
    let settings = Settings { clouds: Some(0.5), ..Settings::default() };
    let camera = Camera::from_degrees(16.0, -25.0, 3e7, 0.0, 0.0);
    let frame = Frame::new(&settings, &camera, 1_795_176_000.0, [1280, 720]);
    let [left, top, width, height] = frame.clouds.unwrap().area;
    // Its radius is 10.1 degrees of a field of 45 degrees: 155 pixels.
    assert!((310..350).contains(&width) && (310..350).contains(&height), "{width} {height}");
    assert_eq!((2 * left + width, 2 * top + height), (1280, 720));
}
