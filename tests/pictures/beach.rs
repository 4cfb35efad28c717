//! Beaches as they are seen from the air: wide here and narrow there, and overgrown in patches instead of along a line.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::{Radiance, Renderer};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/data");
const SIZE: [u32; 2] = [256, 256];

#[test]
fn beaches_differ_in_width_and_are_overgrown_in_patches() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let (mut widths, mut changes) = (Vec::new(), 0);
    // Pixels of 2.6 m, the sea on the left.
    for (lat, lon) in [(52.1, 4.2645), (52.106, 4.2725), (52.112, 4.2805)] {
        let state = render::parse_state(&format!("#view={lat},{lon},800,0,0&clouds=0&bft=2")).unwrap();
        let mut measured = |layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values;
        let (classes, albedo) = (measured(LayerName::Class), measured(LayerName::Albedo));
        for row in 0..SIZE[1] as usize {
            let at = |column: usize| row * SIZE[0] as usize + column;
            // Sand is red, what grows is green.
            let is_sand = |column: usize| albedo[3 * at(column)] > 1.05 * albedo[3 * at(column) + 1];
            let Some(shore) = (0..SIZE[0] as usize).rev().find(|&column| classes[at(column)] == 1.0) else { continue };
            let land: Vec<bool> = (shore + 2..SIZE[0] as usize).map(is_sand).collect();
            if land.len() < 60 {
                continue;
            }
            widths.push(land.iter().filter(|sand| **sand).count());
            changes += land.windows(2).filter(|pair| pair[0] != pair[1]).count();
        }
    }
    widths.sort_unstable();
    let [narrow, wide] = [1, 9].map(|tenths| widths[tenths * widths.len() / 10]);
    let each = changes as f64 / widths.len() as f64;
    println!("{} rows: {narrow} to {wide} pixels of sand, {each:.1} changes in each", widths.len());
    // A line is one change in each row, shreds and islands of what grows are two more each.
    assert!(widths.len() > 300 && wide > 2 * narrow.max(5), "{narrow} to {wide}");
    assert!(each > 1.5, "{each}");
}

/// Median reflectance in red light, seen from above, of the land beside the sea at a place, and how far that exceeds blue.
fn shore_reflectance(renderer: &mut Renderer, name: &str, lat: f64, lon: f64) -> [f64; 2] {
    // Pixels of 5 m.
    let state = render::parse_state(&format!("#view={lat},{lon},1600,0,0&clouds=0&bft=2")).unwrap();
    let mut measured = |layer| render::measure(renderer, &state, SIZE, layer).unwrap().values;
    let (classes, albedo) = (measured(LayerName::Class), measured(LayerName::Albedo));
    let width = SIZE[0] as usize;
    // Of the outermost two columns neighbours lie in other rows.
    let is_shore = |at: usize| {
        let beside = [at - 2, at + 2, at - 2 * width, at + 2 * width];
        (2..width - 2).contains(&(at % width)) && classes[at] != 1.0 && beside.iter().any(|&at| classes[at] == 1.0)
    };
    let shore: Vec<usize> = (2 * width..classes.len() - 2 * width).filter(|&at| is_shore(at)).collect();
    assert!(shore.len() > 200, "{name} has a shore of {} pixels", shore.len());
    let median = |channel: usize| {
        let mut values: Vec<_> = shore.iter().map(|&at| albedo[3 * at + channel]).collect();
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let [red, blue] = [median(0), median(2)];
    println!("{name}: the shore's reflectance is {red:.3} in red light, {blue:.3} in blue");
    [red, red - blue]
}

#[test]
fn shores_are_of_sand_where_slope_latitude_and_shape_say_so() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut judged = |places: &[(&str, f64, f64)], is_right: fn([f64; 2]) -> bool| -> Vec<String> {
        let wrong =
            places.iter().filter(|(name, lat, lon)| !is_right(shore_reflectance(&mut renderer, name, *lat, *lon)));
        wrong.map(|(name, ..)| (*name).to_owned()).collect()
    };
    // Sand is bright and yellow; rock, walls and mud are neither.
    let no_sand = judged(
        &[
            ("Holland", 52.106, 4.2725),
            ("Zandvoort", 52.3720, 4.5235),
            ("Jutland", 56.475, 8.125),
            ("Fuerteventura", 28.4, -14.156),
            ("El Cotillo, Fuerteventura", 28.6802, -14.0093),
            ("Copacabana", -22.9698, -43.1802),
            ("Bondi", -33.8937, 151.2843),
            ("Outer Banks", 35.2501, -75.5205),
            ("Nassau", 25.0771, -77.4027),
            ("Nazaré", 39.5945, -9.0732),
            ("Barbados", 13.1700, -59.6399),
            ("Gold Coast", -28.045, 153.436),
            ("Landes", 44.3005, -1.2834),
        ],
        |[red, over_blue]| red > 0.25 && over_blue > 0.08,
    );
    let sand = judged(
        &[
            ("Sotra, Norway", 60.36, 4.916),
            ("Lofoten, Norway", 68.09, 13.205),
            ("Haida Gwaii, Canada", 53.0, -131.681),
            ("Moher, Ireland", 52.9701, -9.4326),
            ("Sagres, Portugal", 36.9993, -8.9503),
            ("Corvo, Azores", 39.6700, -31.1088),
            ("Madeira", 32.7396, -17.2129),
            ("Big Sur, California", 36.2072, -121.7430),
            ("Cinque Terre, Italy", 44.1261, 9.6979),
            ("Halong, Vietnam", 20.8971, 107.1031),
            ("Bosphorus", 41.0813, 29.0614),
            ("Manhattan", 40.7012, -74.0166),
            ("Sundarbans", 21.8003, 89.1900),
        ],
        |[red, _]| red < 0.2,
    );
    // Snow and ice are brighter than either, and white or blue.
    let no_ice = judged(
        &[
            ("Ross Ice Shelf", -78.3655, -175.0),
            ("Ross Ice Shelf, west", -77.8583, 178.0),
            ("Brunt Ice Shelf", -75.4822, -27.0),
            ("Ronne Ice Shelf", -77.9374, -45.0),
        ],
        |[red, over_blue]| red > 0.5 && over_blue < 0.0,
    );
    assert!(no_sand.is_empty() && sand.is_empty(), "without sand: {no_sand:?}; with sand: {sand:?}");
    assert!(no_ice.is_empty(), "without ice: {no_ice:?}");
}
