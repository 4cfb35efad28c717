//! Beaches as they are seen from the air: wide here and narrow there, and overgrown in patches instead of along a line.

use ocean_globe::cli::render::{self, LayerName};
use ocean_globe::renderer::Radiance;

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

#[test]
fn coasts_that_ice_has_scoured_have_rock_where_others_have_sand() {
    let mut renderer = render::headless(DATA, Radiance::Single).unwrap();
    let mut reflectance = |name: &str, lat: f64, lon: f64| {
        // Pixels of 5 m.
        let state = render::parse_state(&format!("#view={lat},{lon},1600,0,0&clouds=0&bft=2")).unwrap();
        let mut measured = |layer| render::measure(&mut renderer, &state, SIZE, layer).unwrap().values;
        let (classes, albedo) = (measured(LayerName::Class), measured(LayerName::Albedo));
        let width = SIZE[0] as usize;
        // Land beside the sea.
        let is_shore = |at: usize| {
            let beside = [at - 2, at + 2, at - 2 * width, at + 2 * width];
            classes[at] != 1.0 && beside.iter().any(|&at| classes[at] == 1.0)
        };
        let mut red: Vec<_> =
            (2 * width..classes.len() - 2 * width).filter(|&at| is_shore(at)).map(|at| albedo[3 * at]).collect();
        red.sort_by(f64::total_cmp);
        assert!(red.len() > 200, "{name} has a shore of {} pixels", red.len());
        println!("{name}: the shore's reflectance in red light is {:.3}", red[red.len() / 2]);
        red[red.len() / 2]
    };
    let sandy = [
        reflectance("Holland", 52.106, 4.2725),
        reflectance("Jutland", 56.475, 8.125),
        reflectance("Fuerteventura", 28.4, -14.156),
    ];
    let rocky = [
        reflectance("Sotra, Norway", 60.36, 4.916),
        reflectance("Lofoten, Norway", 68.09, 13.205),
        reflectance("Haida Gwaii, Canada", 53.0, -131.681),
    ];
    assert!(sandy.iter().all(|red| *red > 0.25) && rocky.iter().all(|red| *red < 0.2), "{sandy:?}, {rocky:?}");
}
