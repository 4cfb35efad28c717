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
