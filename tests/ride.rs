//! An eye that rides the sea stands as far above the drawn surface as its link says.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::ride::surface_height;

#[test]
fn the_eye_rides_the_surface_that_is_drawn() {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
    let mut renderer = render::headless(data, Radiance::Single).unwrap();
    for grade in [4, 8, 12] {
        let fragment = format!("#view=35.6812,-14.25,40,0,0&bft={grade}&time=2026-11-20T12:00:00Z");
        let state = render::parse_state(&fragment).unwrap();
        let frame = render::frame_of(&state, [257, 257]);
        let expected = surface_height(&state.settings, &state.camera, frame.unix_seconds);
        let measured = render::measure(&mut renderer, &state, [257, 257], LayerName::Height).unwrap();
        let drawn = f64::from(measured.values[128 * 257 + 128]);
        println!("grade {grade}: model {expected:.3} m, drawn {drawn:.3} m");
        // The grid's cells are half a metre wide; slopes up to 0.3 over half a cell, twice for height and chop, make 0.15 m.
        let hs = frame.sea.sea.hs_m;
        assert!((expected - drawn).abs() < 0.15 + 0.01 * hs, "grade {grade}: {expected} against {drawn}");
    }
}
