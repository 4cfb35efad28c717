//! Crests against the sky have smooth edges, where the quality asks for them.

use ocean_globe::cli::render;
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::Output;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [640, 180];

/// Share of the columns whose highest crest ends in a pixel that is between sky and sea.
fn between(renderer: &mut Renderer, quality: &str) -> f64 {
    // No foam, so that the sea under a crest is one dark blue; into the wind, away from the sun.
    let link = "#view=35.6812,-14.25,2,262,88&ride=1&bft=8&time=2026-11-20T12:00:00Z&rate=0&layers=-foam";
    let state = render::parse_state(&format!("{link}&quality={quality}")).unwrap();
    let (_, target) = render::draw(renderer, &state, SIZE, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(&target, 0, 0).unwrap();
    let red = |x: u32, y: u32| f64::from(bytes[4 * (y * SIZE[0] + x) as usize]);
    let mut columns = 0.0;
    for x in 0..SIZE[0] {
        // The edge: the first pixel from above that is a sixth darker than the sky two pixels higher.
        let edge = (4..SIZE[1] - 4).find(|&y| red(x, y) < 0.83 * red(x, y - 2)).expect("a crest under the sky");
        let (sky, sea) = (red(x, edge - 2), red(x, edge + 2));
        let is_between = |y| (0.2..0.8).contains(&((red(x, y) - sea) / (sky - sea)));
        columns += f64::from(u8::from(is_between(edge) || is_between(edge - 1)));
    }
    columns / f64::from(SIZE[0])
}

#[test]
fn crests_end_in_pixels_between_sky_and_sea() {
    let mut renderer = render::headless(DATA, Radiance::Half).unwrap();
    let [medium, high] = ["medium", "high"].map(|quality| between(&mut renderer, quality));
    println!("{medium:.3} of the columns with one sample, {high:.3} with four");
    // Of four samples at four heights one to three lie under an edge in three of four places; some of these the curve of the display and
    // the light of the crests themselves take out of what counts here.
    assert!(high > 0.35 && medium < 0.1, "{medium} {high}");
}
