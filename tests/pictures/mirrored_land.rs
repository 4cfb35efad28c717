//! Land that water mirrors.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};

use crate::light::DATA;

const SIZE: [u32; 2] = [320, 180];
/// Rows over the waterline that are compared with as many below it, the first of which are the shore's own pixels.
const ROWS: std::ops::Range<usize> = 3..32;

/// The classes of a picture's pixels, and their radiance in green light.
fn measured(renderer: &mut Renderer, link: &str) -> [Vec<f64>; 2] {
    let state = render::parse_state(link).unwrap();
    let mut layer = |name| render::measure(renderer, &state, SIZE, name).unwrap().values;
    let [classes, radiance] = [LayerName::Class, LayerName::Radiance].map(&mut layer);
    [classes, radiance.chunks(3).map(|rgb| rgb[1]).collect()]
}

/// Land over a waterline, and water as far below it and `lower` rows more: their correlation, and the mean of water over that of land.
fn likeness([classes, green]: &[Vec<f64>; 2], lower: usize) -> [f64; 2] {
    let [width, height] = SIZE.map(|side| side as usize);
    let mut pairs = Vec::new();
    for column in 0..width {
        let at = |row: usize| row * width + column;
        let is_water = |row: usize| classes[at(row)] == 1.0 || classes[at(row)] == 2.0;
        let Some(waterline) = (1..height).find(|&row| is_water(row)) else { continue };
        for away in ROWS.filter(|&away| away <= waterline && waterline + away + lower <= height) {
            let (above, below) = (waterline - away, waterline + away + lower - 1);
            if classes[at(above)] == 0.0 && is_water(below) {
                pairs.push([green[at(above)], green[at(below)]]);
            }
        }
    }
    assert!(pairs.len() > 1000, "{} pairs of pixels", pairs.len());
    let count = pairs.len() as f64;
    let means = [0, 1].map(|of| pairs.iter().map(|pair| pair[of]).sum::<f64>() / count);
    let product =
        |a: usize, b: usize| pairs.iter().map(|pair| (pair[a] - means[a]) * (pair[b] - means[b])).sum::<f64>();
    [product(0, 1) / (product(0, 0) * product(1, 1)).sqrt(), means[1] / means[0]]
}

#[test]
fn still_water_mirrors_its_shores_and_rough_water_a_blur_of_them() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Between the mountains of Lake Como, and in the bay of Kotor.
    for (place, least) in [("46.00,9.26,3,10,88", 0.6), ("42.45,18.67,3,345,88", 0.4)] {
        let link = |wind: &str| format!("#view={place}&time=2026-06-21T15:00:00Z&clouds=0&{wind}");
        let still = measured(&mut renderer, &link("bft=0"));
        let alike = [0, 1, 2, 3, 5, 8].map(|lower| likeness(&still, lower)[0]);
        let share = likeness(&still, 1)[1];
        let rough = likeness(&measured(&mut renderer, &link("bft=2")), 1);
        println!("{place}: correlation {alike:.3?}, water {share:.3} of land; rough {rough:.3?}");
        // Land at 2 km is 3 mrad, one pixel, higher than its image to an eye 3 m over the water, nearer land more: an image that is drawn out or squeezed
        // is alike nowhere. What is left is land at other distances, as wide as what is seen of it.
        let best = alike.iter().copied().fold(f64::MIN, f64::max);
        assert!(best > least && alike[..3].contains(&best), "{alike:?}");
        // Under 3 to 32 pixels of 3.3 mrad Fresnel's equations send back .95 to .6; the water's own light, most by the shore, comes to that.
        assert!((0.6..1.1).contains(&share), "{share}");
        // Waves turn what is seen by tens of pixels: of its shape little is left.
        assert!(rough[0] < best - 0.3 && (0.5..1.3).contains(&rough[1]), "{rough:?}");
    }
}

#[test]
fn a_bed_below_the_horizon_is_not_mirrored() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    // Off the Landes, whose land is low, over sand some metres deep, which is redder than the sea: without a horizon in the picture.
    let link = "#view=44.2,-1.335,500,60,62&wind=0@310&clouds=0&time=2026-09-21T15:00:00Z";
    let state = render::parse_state(link).unwrap();
    let [classes, radiance] = [LayerName::Class, LayerName::Radiance]
        .map(|layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values);
    let width = SIZE[0] as usize;
    let rows = 12..170;
    assert!(rows.clone().all(|row| (0..100).all(|column| classes[row * width + column] == 1.0)));
    let red = |row: usize| (0..100).map(|column| radiance[3 * (row * width + column)]).sum::<f64>();
    let steps: Vec<f64> = rows.clone().skip(2).map(|row| red(row - 2) / red(row)).collect();
    let [least, most] = [steps.iter().copied().fold(f64::MAX, f64::min), steps.iter().copied().fold(0.0, f64::max)];
    println!("from row to row but one red goes by {least:.3} to {most:.3}");
    // Fresnel's reflectance changes most under the flattest sights, 6 degrees: by 6 % over two rows, of half a degree. Where sand in the picture's first rows stood for what
    // is above it a line lay across the sea, of 1.49.
    assert!(least > 0.95 && most < 1.1, "{steps:.3?}");
}

#[test]
fn a_cloud_before_a_mountain_is_no_patch_on_the_sea() {
    let mut renderer = render::headless(DATA, Radiance::Whole).unwrap();
    // Off Tahiti, whose top has a cloud before it, over waves that turn what is mirrored by as much as the mountain is high.
    let link = "#view=-17.53,-149.7,500,150,74&clouds=0.3&time=2026-05-10T20:30:00Z";
    let state = render::parse_state(link).unwrap();
    let values = render::measure(&mut renderer, &state, SIZE, LayerName::Radiance).unwrap().values;
    let width = SIZE[0] as usize;
    let patches: Vec<f64> = (48..60)
        .map(|row| {
            let mut green: Vec<f64> = (10..110).map(|column| values[3 * (row * width + column) + 1]).collect();
            green.sort_by(f64::total_cmp);
            green[99] / green[50]
        })
        .collect();
    println!("of a row the brightest pixel has {patches:.2?} of the middle one");
    // 1.29 where one look told what land is mirrored.
    assert!(patches.iter().all(|patch| *patch < 1.16), "{patches:?}");
}
