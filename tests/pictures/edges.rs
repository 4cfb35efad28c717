//! Crests against the sky have smooth edges, where the quality asks for them; shores always.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};
use ocean_globe::scene::frame::Output;
use ocean_globe::scene::view::state::ViewState;

use crate::tone::displayed;

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [640, 180];

/// The exposed radiance of a picture before the lens, which spreads every edge.
fn before_the_lens(renderer: &mut Renderer, state: &ViewState, size: [u32; 2]) -> Vec<[f64; 3]> {
    let _ = render::draw(renderer, state, size, Output::Picture).unwrap();
    let bytes = renderer.gpu().read_texture(renderer.radiance().unwrap(), 0, 0).unwrap();
    let part = |texel: &[u8], at: usize| half::f16::from_le_bytes([texel[2 * at], texel[2 * at + 1]]).to_f64();
    bytes.chunks_exact(8).map(|texel| [0, 1, 2].map(|at| part(texel, at))).collect()
}

/// Share of the columns whose highest crest ends in a pixel that is between sky and sea.
fn between(renderer: &mut Renderer, quality: &str) -> f64 {
    // No foam, so that the sea under a crest is one dark blue; into the wind, away from the sun.
    let link = "#view=35.6812,-14.25,2,262,88&clouds=0&ride=1&bft=8&time=2026-11-20T12:00:00Z&rate=0&layers=-foam";
    let state = render::parse_state(&format!("{link}&quality={quality}")).unwrap();
    let shown: Vec<f64> =
        before_the_lens(renderer, &state, SIZE).into_iter().map(|radiance| displayed(radiance)[0]).collect();
    let red = |x: u32, y: u32| shown[(y * SIZE[0] + x) as usize];
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

#[test]
fn shores_from_space_end_in_pixels_between_sea_and_land() {
    // Sahara and Namibia: bright land beside dark water.
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let (mut edges, mut between) = (0, 0);
    for view in ["22,-14,2000000", "-20,14,2500000"] {
        let state =
            render::parse_state(&format!("#view={view}&clouds=0&time=2026-11-20T12:30:00Z&quality=low")).unwrap();
        let size = [240, 180];
        let mut layer = |layer| render::measure(&mut renderer, &state, size, layer).unwrap().values;
        let (class, radiance) = (layer(LayerName::Class), layer(LayerName::Radiance));
        // Red over blue tells land from sea by far.
        let hue: Vec<f64> = radiance.chunks_exact(3).map(|rgb| rgb[0] / rgb[2]).collect();
        for row in 0..size[1] as usize {
            for x in 4..size[0] as usize - 4 {
                let at = |x: usize| row * size[0] as usize + x;
                let all = |from: usize, class_is: f64| (from..from + 4).all(|x| class[at(x)] == class_is);
                if !(all(x - 3, 1.0) && all(x + 1, 0.0)) {
                    continue;
                }
                let [sea, land] = [hue[at(x - 2)], hue[at(x + 3)]];
                let is_between = |x: usize| (0.15..0.85).contains(&((hue[at(x)] - sea) / (land - sea)));
                edges += 1;
                between += usize::from(is_between(x) || is_between(x + 1));
            }
        }
    }
    let share = f64::from(between as u32) / f64::from(edges);
    println!("{edges} shores, {share:.3} of them in a pixel between");
    // A shore crosses a pixel anywhere: of 0.7 of them the share of land lies between those two.
    assert!(edges > 100 && share > 0.5, "{share} of {edges}");
}

#[test]
fn far_ridges_before_the_sea_have_no_dark_outline() {
    // Tahiti from 25 km, its ridges before the sea and before the sky.
    let link = "#view=-17.42,-149.62,3000,155,74&haze=0.05&clouds=0&time=2026-06-21T20:30:00Z&quality=high";
    let state = render::parse_state(link).unwrap();
    let size = [480, 270];
    let mut measuring = render::headless(DATA, Radiance::Single).unwrap();
    let class = render::measure(&mut measuring, &state, size, LayerName::Class).unwrap().values;
    let mut drawing = render::headless(DATA, Radiance::Half).unwrap();
    let radiance = before_the_lens(&mut drawing, &state, size);
    let at = |x: u32, y: u32| (y * size[0] + x) as usize;
    let green = |x, y| radiance[at(x, y)][1];
    let (mut ridges, mut dark) = (0, 0);
    for x in 0..size[0] {
        let Some(top) = (3..size[1] - 4).find(|&y| class[at(x, y)] == 0.0) else { continue };
        ridges += 1;
        let edge = green(x, top - 1).min(green(x, top));
        dark += u32::from(edge < 0.97 * green(x, top - 3).min(green(x, top + 3)));
    }
    println!("{dark} of {ridges} columns have a dark skyline");
    // The light of a pixel with an edge lies between that on its sides; rock darker than both is seldom.
    assert!(ridges > 200 && dark * 20 < ridges, "{dark} of {ridges}");
}
