//! Land that water mirrors.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};

use crate::light::DATA;

const SIZE: [u32; 2] = [320, 180];
/// Rows over the waterline that are compared with as many below it, the first of which are the shore's own pixels.
const ROWS: std::ops::Range<usize> = 3..16;

/// Land over a waterline, and water as far below it, in green light, of pixels that show land above.
fn pairs(renderer: &mut Renderer, link: &str) -> Vec<[f64; 2]> {
    let state = render::parse_state(link).unwrap();
    let mut measured = |layer| render::measure(renderer, &state, SIZE, layer).unwrap().values;
    let [classes, radiance] = [LayerName::Class, LayerName::Radiance].map(&mut measured);
    let [width, height] = SIZE.map(|side| side as usize);
    let mut found = Vec::new();
    for column in 0..width {
        let at = |row: usize| row * width + column;
        let is_water = |row: usize| classes[at(row)] == 1.0 || classes[at(row)] == 2.0;
        let Some(waterline) = (1..height).find(|&row| is_water(row)) else { continue };
        for away in ROWS.filter(|&away| away <= waterline && waterline + away < height) {
            // From an eye 3 m over the water land at 2 km is seen 3 mrad, one pixel, higher than its image.
            let (above, below) = (waterline - away, waterline + away);
            if classes[at(above)] == 0.0 && is_water(below) {
                found.push([above, below].map(|row| radiance[3 * at(row) + 1]));
            }
        }
    }
    found
}

/// Their correlation, and the mean of water over that of land.
fn likeness(pairs: &[[f64; 2]]) -> [f64; 2] {
    let count = pairs.len() as f64;
    let means = [0, 1].map(|of| pairs.iter().map(|pair| pair[of]).sum::<f64>() / count);
    let product =
        |a: usize, b: usize| pairs.iter().map(|pair| (pair[a] - means[a]) * (pair[b] - means[b])).sum::<f64>();
    [product(0, 1) / (product(0, 0) * product(1, 1)).sqrt(), means[1] / means[0]]
}

#[test]
fn still_water_mirrors_its_shores_and_rough_water_a_blur_of_them() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Between the mountains of Lake Como, at an hour when they stand before a brighter sky.
    let link = |wind: &str| format!("#view=46.00,9.26,3,10,88&time=2026-06-21T15:00:00Z&clouds=0&{wind}");
    let [still, rough] = ["bft=0", "bft=2"].map(|wind| {
        let pairs = pairs(&mut renderer, &link(wind));
        let [alike, share] = likeness(&pairs);
        println!("{wind}: {} pairs of pixels, correlation {alike:.3}, water {share:.3} of land", pairs.len());
        assert!(pairs.len() > 800, "{}", pairs.len());
        (alike, share)
    });
    // Under 3 to 16 pixels of 3.3 mrad Fresnel's equations send back .95 to .8. Land at other distances is up to a pixel off, as wide as what is seen of it.
    assert!(still.0 > 0.75 && (0.8..0.95).contains(&still.1), "{still:?}");
    // Waves turn what is seen by tens of pixels: of its shape little is left.
    assert!(rough.0 < still.0 - 0.3 && rough.1 > 0.7, "{rough:?}");
}
