//! Coral reefs as they are drawn: the bed is the one that is sampled, and an eye rides the lagoon's waves, not the open sea's.

use ocean_globe::cli::render::{self, LayerName, headless, parse_state};
use ocean_globe::data::world::World;
use ocean_globe::renderer::Radiance;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");

#[test]
fn reefs_are_drawn_where_they_are_sampled() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    // Over the lagoon in the north of Moorea, its crest and the sea beyond.
    let link = "#view=-17.476,-149.83,2500,0,0&bft=3&clouds=0&quality=low&time=2026-06-21T20:30:00Z";
    let state = parse_state(link).unwrap();
    let mut measured = |layer| render::measure(&mut renderer, &state, [64, 64], layer).unwrap().values;
    let (places, depths) = (measured(LayerName::Lonlat), measured(LayerName::Depth));
    let (mut errors, mut lagoon, mut deep) = (Vec::new(), 0, 0);
    for (place, depth) in places.chunks_exact(2).zip(&depths) {
        let sample = world.sample_blocking(place[1].to_radians(), place[0].to_radians()).unwrap();
        let Some(wanted) = sample.depth_m else { continue };
        errors.push((depth - wanted).abs() / (1.0 + 0.1 * wanted));
        lagoon += usize::from(sample.waves_left < 0.3);
        deep += usize::from(wanted > 40.0);
    }
    errors.sort_by(f64::total_cmp);
    let [half, most] = [errors.len() / 2, errors.len() * 95 / 100].map(|at| errors[at]);
    println!("{} places at sea, {lagoon} in the lagoon, {deep} deep: off by {half:.3} and {most:.3} m", errors.len());
    assert!(lagoon > 300 && deep > 100, "{lagoon} {deep}");
    assert!(half < 0.05 && most < 0.6, "{half} {most}");
}

#[test]
fn an_eye_rides_the_lagoons_waves() {
    let mut renderer = headless(DATA, Radiance::Single).unwrap();
    let mut world = World::open(DATA);
    let mut of = |lat: f64| world.sample_blocking(lat.to_radians(), -149.83f64.to_radians()).unwrap();
    let lats = (0..200).map(|i| -17.49 + 1e-4 * f64::from(i));
    let lat = lats.clone().find(|lat| {
        let place = of(*lat);
        place.waves_left < 0.2 && place.depth_m.is_some_and(|depth_m| depth_m > 4.0)
    });
    let lat = lat.expect("a lagoon");
    let (mut squares, mut off) = ([0.0; 2], 0.0f64);
    for second in [0, 2, 3, 5] {
        let link =
            format!("#view={lat},-149.83,40,0,0&ride=1&bft=5&clouds=0&quality=low&time=2026-06-21T20:30:0{second}Z");
        let state = parse_state(&link).unwrap();
        let drawn = render::measure(&mut renderer, &state, [65, 65], LayerName::Height).unwrap().values[32 * 65 + 32];
        let ridden = renderer.eye(&state, render::instant(&state)).altitude_m - 40.0;
        // As without the reef, at a place of which nothing has been told.
        renderer.seas_mut().tell_reef(0.0, 0.0, 1.0);
        let open = renderer.seas_mut().surface_height(&state.settings, &state.camera, render::instant(&state));
        println!("ridden {ridden:.3} m, drawn {drawn:.3} m, without a reef {open:.3} m");
        squares = [squares[0] + ridden * ridden, squares[1] + open * open];
        off = off.max((ridden - drawn).abs());
    }
    let ratio = (squares[0] / squares[1]).sqrt();
    assert!(ratio < 0.3 && off < 0.03, "{ratio} of the open sea's, {off} m off what is drawn");
}
