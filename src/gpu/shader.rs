//! WGSL with three directives of its own, each at the start of a line. `#import name` inserts a library of `shaders/lib` once, before
//! its first user. `#unroll 8 statement` repeats the statement with 0…7 for every `$`: an array that stays in registers must be
//! indexed by constants, and not every driver unrolls a loop to get there. `#usually NAME = value;` declares a constant that whoever composes
//! the shader has not declared.

use std::collections::HashSet;

use crate::scene::frame::constants;
use crate::scene::frame::uniform::{FoamLevel, FrameUniform, WaveAnchor, WaveCell};

macro_rules! libraries {
    ($($name:literal),+ $(,)?) => { &[$(($name, include_str!(concat!("../../shaders/lib/", $name, ".wgsl")))),+] };
}

/// Every shader library by name; `frame_memory` is declared in Rust.
#[rustfmt::skip]
pub const LIBRARY: &[(&str, &str)] = libraries![
    "air", "air_coordinates", "atmosphere", "beach", "bed_cover", "bisected_mesh", "bisection_tree", "bisector_pieces", "bisectors", "brdf", "breakers", "built_up", "canopy", "caustic_map", "cells",
    "cloud_layer", "cloud_light", "cloud_noise", "clouds", "crest_pixels",
    "cuboid", "decks", "domain", "domes", "driven_spray", "ellipsoid", "exchange_1", "exchange_2", "exchange_4", "fields", "foam", "foam_light", "four_taps", "frame", "full_screen",
    "ground", "ground_colour", "ground_slope", "gusts", "hash", "held", "houses", "ice_clouds", "imagery", "inland", "lace", "lace_net", "lens", "light", "limb", "map", "map_texels", "mirrored_land", "no_lens", "noise", "normal",
    "output", "places", "plants", "plume", "projected_grid", "reefs", "relief", "rivers", "rollers", "rugged", "scattering", "scene", "sea_bed", "sea_mesh", "sea_pixel", "sea_vertex", "shelter", "shore_kind", "shore_pixels", "shore_shape", "shore_trains", "sky", "sky_coordinates", "sparkle", "spot", "spray", "stairs", "stockham",
    "sunlight", "surf", "swash", "towers", "translucence", "trigonometry", "under_water", "walls", "water", "water_types", "wave_patches", "waves", "window", "world",
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
    [&constants::shared_constants(), FoamLevel::WGSL, WaveAnchor::WGSL, WaveCell::WGSL, FrameUniform::WGSL].join("\n")
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
        if let Some(usual) = line.strip_prefix("#usually ") {
            let name = usual.split_once(' ').map_or(usual, |(name, _)| name);
            let declares = |line: &str| {
                let rest = line.strip_prefix("const ").and_then(|rest| rest.strip_prefix(name));
                rest.is_some_and(|rest| rest.trim_start().starts_with([':', '=']))
            };
            if !text.lines().any(declares) {
                text.push_str(&format!("const {usual}\n"));
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
    fn usual_constants_give_way_to_those_of_the_composer() {
        assert_eq!(super::composed("#usually N = 4u;", ""), "\nconst N = 4u;\n");
        assert_eq!(super::composed("#usually N = 4u;", "const N: u32 = 5u;"), "const N: u32 = 5u;\n");
        assert_eq!(super::composed("#usually N = 4u;", "const N = 5u;"), "const N = 5u;\n");
        assert_eq!(super::composed("#usually N = 4u;", "// const N = 5u;"), "// const N = 5u;\nconst N = 4u;\n");
    }

    #[test]
    fn unrolled_statements_come_once_for_each_number() {
        let text = super::composed("#unroll 3 a[$] = $u;\nb", "");
        assert_eq!(text, "\na[0] = 0u;\na[1] = 1u;\na[2] = 2u;\nb\n");
    }
}
