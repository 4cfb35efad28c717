//! Every shader is valid WGSL for naga within the default limits, and what Rust and WGSL share is equal on both sides.

use std::collections::BTreeSet;
use std::path::Path;

use naga::valid::{Capabilities, ValidationFlags, Validator};
use ocean_globe::app::{blit, pane};
use ocean_globe::data::streaming;
use ocean_globe::gpu::{mips, shader};
use ocean_globe::model::{lace, optics, wave_domain};
use ocean_globe::panel;
use ocean_globe::pass::fft::{Precision, Wanted};
use ocean_globe::pass::kind::Kind;
use ocean_globe::pass::land::{Beach, Ground, Near};
use ocean_globe::pass::look::Look;
use ocean_globe::pass::{
    air_table, backdrop, bed_light, bisect, bloom, caustics, city_lights, cloud_light, cloud_map, clouds, deep, fft,
    foam, globe, land, ocean, perlin, sky, sky_table, sky_view, spindrift, stars, tonemap, waterline,
};
use ocean_globe::scene::frame::bisection::Bisection;
use ocean_globe::scene::frame::uniform;
use ocean_globe::scene::sea::{foam as scene_foam, foam_history};
use ocean_globe::scene::towns;
use ocean_globe::scene::view::map_tiles;

/// Every composed shader with the file that it comes from.
pub fn all() -> Vec<(&'static str, String)> {
    let kinds = [Precision::Half, Precision::Single].map(|p| [(p, Wanted::All), (p, Wanted::Stretches)]).concat();
    let transforms =
        (4..=11).flat_map(|log| kinds.iter().map(move |&(p, wanted)| ("fft.wgsl", fft::source(1 << log, p, wanted))));
    let [bloom_down, bloom_up] = bloom::sources();
    let mut all = vec![
        ("transmittance_table.wgsl", air_table::sources()[0].clone()),
        ("multiple_table.wgsl", air_table::sources()[1].clone()),
        ("backdrop.wgsl", backdrop::source(true)),
        ("bisect.wgsl", bisect::source()),
        ("blit.wgsl", blit::source(false)),
        ("blit.wgsl", blit::source(true)),
        ("pane.wgsl", pane::source(panel::ground_colour(), false)),
        ("waterline.wgsl", waterline::source()),
        ("city_lights.wgsl", city_lights::source(false)),
        ("city_lights.wgsl", city_lights::source(true)),
        ("cloud_map.wgsl", cloud_map::source()),
        ("cloud_light.wgsl", cloud_light::source()),
        ("foam.wgsl", foam::source()),
        ("mips.wgsl", mips::source("rgba16float")),
        ("perlin.wgsl", perlin::source()),
        ("sky_table.wgsl", sky_table::source()),
        ("sky_view.wgsl", sky_view::source()),
        ("spindrift.wgsl", spindrift::source()),
        ("stars.wgsl", stars::source()),
        ("milky_way.wgsl", stars::milky_way_source()),
        ("tonemap.wgsl", tonemap::source(false)),
        ("tonemap.wgsl", tonemap::source(true)),
        ("bloom_down.wgsl", bloom_down),
        ("bloom_up.wgsl", bloom_up),
    ];
    for look in clouds::Look::all() {
        all.push(("clouds.wgsl", clouds::source(look)));
    }
    all.extend(clouds::Look::all().map(|look| ("cloud_veil.wgsl", clouds::veil_source(look))));
    for kind in Kind::all() {
        for imagery in [true, false] {
            all.push(("globe.wgsl", globe::source(kind, imagery)));
            for bits in 0..4 {
                let [rugged, reefs] = [1, 2].map(|bit| bits & bit != 0);
                let bed = Ground { rugged, reefs, ..BED };
                all.push(("land.wgsl", land::source(kind, imagery, bed)));
            }
            let mut land = |near, rugged, beach| {
                // What may show all of it, and of fine pictures none; of one kind each by itself as well.
                let is_mixed = imagery && kind == Kind { fine: true, clouds: true, ..Kind::default() };
                let least = if is_mixed || (kind.fine && imagery && !kind.measured) { 0 } else { 7 };
                for bits in (least..8).filter(|bits| is_mixed || [0, 7].contains(bits)) {
                    let [town, inland, reefs] = [1, 2, 4].map(|bit| bits & bit != 0);
                    let ground = Ground { near, beach, rugged, town, inland, reefs, bed: false };
                    all.push(("land.wgsl", land::source(kind, imagery, ground)));
                }
            };
            [false, true].into_iter().for_each(|rugged| land(Near::Growth, rugged, Beach::Absent));
            if kind.shows_lakes() {
                Beach::ALL.into_iter().for_each(|beach| land(Near::Lakes, true, beach));
                land(Near::Growth, false, Beach::Beside);
                land(Near::Growth, false, Beach::Only);
                land(Near::Nothing, true, Beach::Absent);
            }
        }
        all.push(("sky.wgsl", sky::source(kind)));
    }
    all.extend(caustics::Rays::DRAWN.map(|rays| ("caustics.wgsl", caustics::source(rays))));
    all.extend(bed_light::kinds().map(|kind| ("bed_light.wgsl", bed_light::source(kind))));
    all.extend(deep::kinds().map(|kind| ("deep.wgsl", deep::source(kind))));
    all.extend(Look::all().map(|look| (if look.lake { "lake.wgsl" } else { "ocean.wgsl" }, ocean::source(look))));
    let placed = Look::all().filter(|look| ocean::Shading::of_places(*look));
    let files = ["sea_places.wgsl", "sea_of_places.wgsl"];
    all.extend(placed.flat_map(|look| files.into_iter().zip(ocean::sources_of_places(look))));
    all.extend(spindrift::looks().map(|look| ("plumes.wgsl", spindrift::plumes_source(look))));
    all.extend(transforms);
    all
}

pub fn parsed(name: &str, source: &str) -> naga::Module {
    naga::front::wgsl::parse_str(source).unwrap_or_else(|e| panic!("{name}: {}", e.emit_to_string(source)))
}

fn files(folder: &str) -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let names = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name.ends_with(".wgsl")).collect()
}

#[test]
fn every_shader_is_valid_within_the_default_limits() {
    let all = all();
    // For the browser's compiler, which is stricter: tests/browser/suites/shaders.mjs.
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("shaders");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    for (number, (name, source)) in all.iter().enumerate() {
        std::fs::write(folder.join(format!("{number:02}-{name}")), source).unwrap();
        let module = parsed(name, source);
        // pack2x16float is in every WGSL; naga asks for it because OpenGL ES 2 has none.
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::SHADER_FLOAT16_IN_FLOAT32);
        validator.validate(&module).unwrap_or_else(|e| panic!("{name}: {}", e.emit_to_string(source)));
        assert!(!module.entry_points.is_empty(), "{name} has no entry point");
        let mut layouter = naga::proc::Layouter::default();
        layouter.update(module.to_ctx()).unwrap();
        let shared = module.global_variables.iter().filter(|(_, v)| v.space == naga::AddressSpace::WorkGroup);
        let bytes: u32 = shared.map(|(_, v)| layouter[v.ty].size).sum();
        assert!(bytes <= 16_384, "{name}: {bytes} bytes of workgroup memory");
        for entry in &module.entry_points {
            assert!(entry.workgroup_size.iter().product::<u32>() <= 256, "{name}: {}", entry.name);
        }
    }
    let covered: BTreeSet<String> = all.iter().map(|(name, _)| (*name).to_string()).collect();
    assert_eq!(covered, files("shaders"), "a shader file is not in the list above");
    let libraries: BTreeSet<String> = shader::LIBRARY.iter().map(|(name, _)| format!("{name}.wgsl")).collect();
    assert_eq!(libraries, files("shaders/lib"), "a library is not registered");
}

/// Names and offsets of a WGSL struct's members, and its size, bytes.
fn layout(source: &str, name: &str) -> (Vec<(String, usize)>, usize) {
    let module = parsed(name, source);
    let (_, found) = module.types.iter().find(|(_, t)| t.name.as_deref() == Some(name)).expect(name);
    let naga::TypeInner::Struct { members, span } = &found.inner else { panic!("{name} is no struct") };
    (members.iter().map(|m| (m.name.clone().unwrap(), m.offset as usize)).collect(), *span as usize)
}

/// Compares a Rust struct with a WGSL one: the same members, in order, at the same offsets, and the same size.
macro_rules! assert_mirror {
    ($source:expr, $wgsl:literal, $rust:ty, [$($field:ident),* $(,)?]) => {{
        let (wgsl, span) = layout(&$source, $wgsl);
        let rust = vec![$((stringify!($field).to_string(), std::mem::offset_of!($rust, $field))),*];
        assert_eq!(wgsl, rust, "{}", $wgsl);
        assert_eq!(span, size_of::<$rust>(), "size of {}", $wgsl);
    }};
}

#[test]
fn structs_have_the_same_members_at_the_same_places() {
    for (name, members, size) in [
        ("Frame", uniform::FrameUniform::MEMBERS, size_of::<uniform::FrameUniform>()),
        ("WaveCell", uniform::WaveCell::MEMBERS, size_of::<uniform::WaveCell>()),
        ("WaveAnchor", uniform::WaveAnchor::MEMBERS, size_of::<uniform::WaveAnchor>()),
        ("FoamLevel", uniform::FoamLevel::MEMBERS, size_of::<uniform::FoamLevel>()),
    ] {
        let (found, span) = layout(&ocean::source(Look::default()), name);
        let declared: Vec<_> = members.iter().map(|&(member, offset)| (member.to_string(), offset)).collect();
        assert_eq!(found, declared, "{name}");
        assert_eq!(span, size, "size of {name}");
    }
    assert_mirror!(
        foam::source(),
        "FoamStep",
        foam_history::FoamStep,
        [previous, grow, keep, keep_young, empty, cells, due, unused]
    );
    let block = [ocean::source(Look::default()), bisect::source()];
    for source in block {
        assert_mirror!(
            source,
            "Bisection",
            Bisection,
            [
                foot,
                target_pixels,
                fraction,
                budget,
                point,
                inverse_length,
                local_from_x,
                unused_a,
                local_from_y,
                unused_b,
                local_from_z,
                unused_c,
            ]
        );
    }
    assert_mirror!(
        bisect::source(),
        "State",
        bisect::State,
        [
            vertices,
            instances,
            first_vertex,
            first_instance,
            live,
            wanted_slots,
            growth,
            taken,
            merging,
            coarseness,
            acceptance,
            updates,
            last_growth,
            last_merged,
            resting,
            unused,
        ]
    );
    // The sea reads the accounts as an array of floats.
    let coarseness = std::mem::offset_of!(bisect::State, coarseness) / 4;
    assert_eq!(constant(&ocean::source(Look::default()), "COARSENESS"), coarseness as f64);
    assert_mirror!(
        fft::source(64, Precision::Half, Wanted::All),
        "Evolution",
        fft::Evolution,
        [ticks, depth, sharpened, patches, scales]
    );
    assert_mirror!(spindrift::source(), "Plume", spindrift::Plume, [base, strength, light, seed, size, unused]);
    assert_mirror!(
        perlin::source(),
        "PerlinSettings",
        perlin::PerlinSettings,
        [octaves, patch_length, seed, peak_cells, unused,]
    );
}

/// The value of a module constant, which must be a literal.
fn constant(source: &str, name: &str) -> f64 {
    let values = constants(source, name);
    assert_eq!(values.len(), 1, "{name} is a vector");
    values[0]
}

/// The values of a module constant, which must be a literal or a vector of them.
fn constants(source: &str, name: &str) -> Vec<f64> {
    let module = parsed(name, source);
    let (_, found) = module.constants.iter().find(|(_, c)| c.name.as_deref() == Some(name)).expect(name);
    let literal = |init: &naga::Handle<naga::Expression>| match module.global_expressions[*init] {
        naga::Expression::Literal(naga::Literal::U32(x)) => f64::from(x),
        naga::Expression::Literal(naga::Literal::I32(x)) => f64::from(x),
        naga::Expression::Literal(naga::Literal::F32(x)) => f64::from(x),
        ref other => panic!("{name} is {other:?}"),
    };
    match &module.global_expressions[found.init] {
        naga::Expression::Compose { components, .. } => components.iter().map(literal).collect(),
        _ => vec![literal(&found.init)],
    }
}

const BED: Ground = Ground {
    near: Near::Nothing,
    beach: Beach::Absent,
    rugged: false,
    town: false,
    inland: false,
    reefs: false,
    bed: true,
};

#[test]
fn constants_are_equal_on_both_sides() {
    let ocean = ocean::source(Look::default());
    let ground = Ground {
        near: Near::Lakes,
        beach: Beach::Only,
        rugged: true,
        town: true,
        inland: true,
        reefs: true,
        bed: false,
    };
    let land = land::source(Kind::default(), true, ground);
    assert_eq!(constants(&land, "SHORE_SAND")[1], map_tiles::SHORE_SAND_M);
    assert_eq!(constant(&land, "LEAST_SINKING"), f64::from(map_tiles::LEAST_SINKING as f32));
    assert_eq!(constant(&land, "TOWN_SIDE"), towns::SIDE as f64);
    assert_eq!(constants(&land, "TOWN_SHIFTS"), towns::SHIFTS.map(f64::from));
    assert_eq!(constant(&ocean, "MAX_CELLS"), wave_domain::MAX_CELLS as f64);
    assert_eq!(constant(&ocean, "BLEND_WIDTH"), wave_domain::BLEND_WIDTH_M);
    assert_eq!(constant(&ocean, "PATCHES"), wave_domain::PATCHES as f64);
    assert_eq!(constant(&ocean, "PERLIN_PATCH"), wave_domain::PERLIN_PATCH as f64);
    assert_eq!(constant(&ocean, "ROW"), wave_domain::ROW);
    assert_eq!(constant(&ocean, "LEAST_SHARE"), f64::from(wave_domain::LEAST_SHARE as f32));
    assert_eq!(constant(&ocean, "POLAR_REACH"), f64::from(wave_domain::POLAR_REACH as f32));
    assert_eq!(constant(&ocean, "LACE_TEXELS") as f32, lace::TEXELS as f32);
    assert_eq!(constant(&ocean, "LACE_GREATEST_LEVEL") as f32, lace::GREATEST_LEVEL);
    assert_eq!(constant(&ocean, "LACE_GREATEST_SLOPE") as f32, lace::GREATEST_SLOPE);
    assert_eq!(constants(&ocean, "LOW_RIM"), ocean::LOW_RIM.map(f64::from));
    assert_eq!(constant(&ocean, "EDGE") as f32, ocean::EDGE);
    assert_eq!(constant(&ocean, "EDGE_ABOVE") as f32, ocean::EDGE_ABOVE);
    assert_eq!(constant(&ocean, "PAGE_LEVELS"), streaming::PAGE_LEVELS as f64);
    assert_eq!(constant(&ocean, "PAGE_WINDOW"), streaming::PAGE_WINDOW as f64);
    let bed = deep::source(deep::kinds().next().unwrap());
    assert_eq!(constant(&bed, "BED_SIDE"), ocean_globe::scene::frame::BED_SIDE_M);
    assert_eq!(constant(&ocean, "PAGE_SLOT_BITS"), f64::from(streaming::PAGE_SLOT_BITS));
    assert_eq!(constant(&land, "GRID"), f64::from(land::GRID));
    assert_eq!(constant(&globe::source(Kind::default(), true), "RIM"), f64::from(globe::RIM));
    let reflectance = optics::DEEP_REFLECTANCE.map(|share| f64::from(share as f32));
    assert_eq!(constants(&land, "OPEN_REFLECTANCE"), reflectance);
    assert_eq!(constant(&land, "OPAQUE_ALPHA"), f64::from(optics::OPAQUE_ALPHA as f32));
    assert_eq!(constant(&perlin::source(), "SIDE"), f64::from(perlin::SIDE));
    assert_eq!(constant(&perlin::source(), "OCTAVES"), ocean_globe::model::perlin::OCTAVES as f64);
    assert_eq!(constant(&ocean, "FOAM_LEVELS"), scene_foam::LEVELS as f64);
    assert_eq!(constant(&ocean, "FOAM_TEXELS"), f64::from(scene_foam::TEXELS));
    let shortest = ocean_globe::model::foam::SHORTEST_PATCH_TEXELS;
    assert_eq!(constant(&foam::source(), "SHORTEST_PATCH_TEXELS"), shortest);
    assert_eq!(constant(&ocean, "NEAR"), f64::from(uniform::NEAR_M as f32));
    let polar = ocean_globe::data::tile::POLAR_HALF_SIDE;
    assert_eq!(constant(&ocean, "POLAR_EXTENT"), f64::from(polar as f32));
    let sine = ocean_globe::data::tile::POLAR_LATITUDE_DEG.to_radians().sin();
    assert_eq!(constant(&ocean, "POLAR_SIN_LAT"), f64::from(sine as f32));
    for (name, output) in [
        ("PICTURE", uniform::Output::Picture),
        ("LONLAT", uniform::Output::LonLat),
        ("DEPTH", uniform::Output::Depth),
        ("MASK", uniform::Output::Mask),
        ("HEIGHT", uniform::Output::Height),
        ("NORMAL", uniform::Output::Normal),
        ("CLASS", uniform::Output::Class),
        ("PERLIN_WEIGHT", uniform::Output::PerlinWeight),
        ("ALBEDO", uniform::Output::Albedo),
    ] {
        assert_eq!(constant(&ocean, name), f64::from(output as u32), "{name}");
    }
}
