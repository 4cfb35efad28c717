//! WGSL with two directives of its own, each at the start of a line. `#import name` inserts a library of `shaders/lib` once, before
//! its first user. `#unroll 8 statement` repeats the statement with 0…7 for every `$`: an array that stays in registers must be
//! indexed by constants, and not every driver unrolls a loop to get there.

use std::collections::HashSet;

use crate::scene::frame::uniform::{self, FoamLevel, FrameUniform, WaveAnchor, WaveCell};

/// Every shader library by name; `frame_memory` is declared in Rust.
pub const LIBRARY: &[(&str, &str)] = &[
    ("air", include_str!("../../shaders/lib/air.wgsl")),
    ("air_coordinates", include_str!("../../shaders/lib/air_coordinates.wgsl")),
    ("atmosphere", include_str!("../../shaders/lib/atmosphere.wgsl")),
    ("bisected_mesh", include_str!("../../shaders/lib/bisected_mesh.wgsl")),
    ("bisection_tree", include_str!("../../shaders/lib/bisection_tree.wgsl")),
    ("bisector_pieces", include_str!("../../shaders/lib/bisector_pieces.wgsl")),
    ("bisectors", include_str!("../../shaders/lib/bisectors.wgsl")),
    ("brdf", include_str!("../../shaders/lib/brdf.wgsl")),
    ("cuboid", include_str!("../../shaders/lib/cuboid.wgsl")),
    ("domain", include_str!("../../shaders/lib/domain.wgsl")),
    ("ellipsoid", include_str!("../../shaders/lib/ellipsoid.wgsl")),
    ("exchange_1", include_str!("../../shaders/lib/exchange_1.wgsl")),
    ("exchange_2", include_str!("../../shaders/lib/exchange_2.wgsl")),
    ("exchange_4", include_str!("../../shaders/lib/exchange_4.wgsl")),
    ("foam", include_str!("../../shaders/lib/foam.wgsl")),
    ("frame", include_str!("../../shaders/lib/frame.wgsl")),
    ("hash", include_str!("../../shaders/lib/hash.wgsl")),
    ("light", include_str!("../../shaders/lib/light.wgsl")),
    ("map", include_str!("../../shaders/lib/map.wgsl")),
    ("noise", include_str!("../../shaders/lib/noise.wgsl")),
    ("output", include_str!("../../shaders/lib/output.wgsl")),
    ("projected_grid", include_str!("../../shaders/lib/projected_grid.wgsl")),
    ("scattering", include_str!("../../shaders/lib/scattering.wgsl")),
    ("sky_coordinates", include_str!("../../shaders/lib/sky_coordinates.wgsl")),
    ("stockham", include_str!("../../shaders/lib/stockham.wgsl")),
    ("sunlight", include_str!("../../shaders/lib/sunlight.wgsl")),
    ("trigonometry", include_str!("../../shaders/lib/trigonometry.wgsl")),
    ("water", include_str!("../../shaders/lib/water.wgsl")),
    ("wave_tiles", include_str!("../../shaders/lib/wave_tiles.wgsl")),
    ("waves", include_str!("../../shaders/lib/waves.wgsl")),
    ("world", include_str!("../../shaders/lib/world.wgsl")),
];

/// The complete text of a shader: imports resolved, `definitions` put first.
///
/// # Panics
/// When a shader imports a library that does not exist: a fault of the program, caught by the shader tests.
pub fn composed(source: &str, definitions: &str) -> String {
    let mut text = String::from(definitions);
    text.push('\n');
    append(source, &mut HashSet::new(), &mut text);
    text
}

/// Count and statement of an `#unroll` line.
fn unrolled(line: &str) -> Option<(usize, &str)> {
    let (count, statement) = line.strip_prefix("#unroll ")?.split_once(' ')?;
    Some((count.parse().ok()?, statement))
}

/// The numbers and structs that Rust shares with the shaders.
fn frame_memory() -> String {
    [&uniform::shared_constants(), FoamLevel::WGSL, WaveAnchor::WGSL, WaveCell::WGSL, FrameUniform::WGSL].join("\n")
}

fn append(source: &str, seen: &mut HashSet<String>, text: &mut String) {
    for line in source.lines() {
        if let Some((count, statement)) = unrolled(line) {
            for i in 0..count {
                text.push_str(&statement.replace('$', &i.to_string()));
                text.push('\n');
            }
            continue;
        }
        let Some(name) = line.strip_prefix("#import ") else {
            text.push_str(line);
            text.push('\n');
            continue;
        };
        let name = name.trim();
        if seen.insert(name.to_owned()) {
            if name == "frame_memory" {
                text.push_str(&frame_memory());
                continue;
            }
            let found = LIBRARY.iter().find(|(known, _)| *known == name);
            append(found.unwrap_or_else(|| panic!("no shader library {name:?}")).1, seen, text);
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn imports_come_once_and_first() {
        let text = super::composed("#import map\n#import map\nfn own() {}", "const N = 4u;");
        assert_eq!(text.matches("struct Frame {").count(), 1);
        assert!(text.starts_with("const N = 4u;"));
        assert!(text.find("struct Frame").unwrap() < text.find("fn own").unwrap());
    }

    #[test]
    fn unrolled_statements_come_once_for_each_number() {
        let text = super::composed("#unroll 3 a[$] = $u;\nb", "");
        assert_eq!(text, "\na[0] = 0u;\na[1] = 1u;\na[2] = 2u;\nb\n");
    }
}
