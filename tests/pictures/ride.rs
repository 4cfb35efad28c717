//! The sea that is drawn is the model's, everywhere on earth; an eye that rides it stands as high above it as its link says.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::Radiance;
use ocean_globe::scene::sea::Seas;

#[test]
fn the_eye_rides_the_surface_that_is_drawn() {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
    let mut renderer = render::headless(data, Radiance::Single).unwrap();
    let mut seas = Seas::default();
    // The equator, the antimeridian and beside the pole are no special places.
    let places = ["35.6812,-14.25", "0,0", "-20,180", "-20,-179.9999", "89.9,30"];
    for (place, grade) in places.iter().flat_map(|place| [4, 8, 12].map(|grade| (place, grade))) {
        let fragment = format!("#view={place},40,0,0&clouds=0&bft={grade}&time=2026-11-20T12:00:00Z");
        let state = render::parse_state(&fragment).unwrap();
        let expected = seas.surface_height(&state.settings, &state.camera, render::instant(&state));
        let measured = render::measure(&mut renderer, &state, [257, 257], LayerName::Height).unwrap();
        let drawn = measured.values[128 * 257 + 128];
        println!("{place} grade {grade}: model {expected:.3} m, drawn {drawn:.3} m");
        // The grid's cells are half a metre wide; slopes up to 0.3 over half a cell, twice for height and chop, make 0.15 m. Linear
        // interpolation takes up to a fifth off the waves near the end of each ring, a tenth of the deviation Hs / 4: 0.03 Hs at 3 sigma.
        let hs = seas.tables(&state.settings).sea.hs_m;
        assert!((expected - drawn).abs() < 0.15 + 0.03 * hs, "{place} grade {grade}: {expected} against {drawn}");
    }
}
