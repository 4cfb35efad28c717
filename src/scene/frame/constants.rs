//! Numbers that the CPU and the shaders must agree on, as WGSL constants: each stands once, in Rust, where it is explained.

use super::uniform::{MIRRORS_LAND, SHOWS_LAND, SHOWS_LIGHTS, SHOWS_SEA, SHOWS_SKY};
use crate::model::earth::WGS84;
use crate::model::{clouds, lakes, reefs, relief, rugged, sea_bed, sheltered_sea, spray, towers};
use crate::scene::sea::surface_sample::{HELD_BY_DEPTH, LEAST_JACOBIAN};
use crate::scene::sea::{foam, shelter, shores};
use crate::scene::view::map_tiles::RELIEF_M;

/// All of them but those of single passes.
pub fn shared_constants() -> String {
    let bits = [
        ("SHOWS_LAND", SHOWS_LAND),
        ("SHOWS_SEA", SHOWS_SEA),
        ("SHOWS_SKY", SHOWS_SKY),
        ("SHOWS_LIGHTS", SHOWS_LIGHTS),
        ("MIRRORS_LAND", MIRRORS_LAND),
        ("MIRROR_NODES", super::clouds::MIRROR_NODES),
        ("SHELTER_LEVELS", shelter::LEVELS as u32),
        ("SHELTER_SIDE", shelter::SIDE as u32),
    ];
    let numbers = [
        ("HELD_BY_DEPTH", HELD_BY_DEPTH),
        ("LEAST_JACOBIAN", LEAST_JACOBIAN),
        ("SHELTER_MOST_GAIN", sheltered_sea::MOST_GAIN),
        ("SHELTER_LEAST_KNOWN", shelter::LEAST_KNOWN),
        ("SHELTER_ON_LAND", shelter::ON_LAND),
        ("LAKE_SHORE", lakes::SHORE_M),
        ("LAKE_OF_MARGIN", lakes::OF_MARGIN),
        ("RIVER_MARGIN", lakes::RIVER_MARGIN_M),
        ("OWN_RIVER", lakes::OWN_RIVER_M),
        ("LAKE_BED", lakes::BED_SLOPE),
        ("LAKE_RISE", lakes::SHORE_RISES[0]),
        ("LAKE_LEAST_RISE", lakes::SHORE_RISES[1]),
        ("FOAM_HIGHEST", foam::HIGHEST_M),
        ("SPRAY_LEAST_HEIGHT", spray::LEAST_HEIGHT_M),
        ("TOP", super::rim::AIR_M),
        ("SEMI_MINOR", WGS84.b),
        ("CLOUD_BASE", clouds::BASE_M),
        ("ICE_HEIGHT", clouds::ICE_M),
        ("GLOBE_PIXEL", RELIEF_M),
        ("GLOBE_LOWEST", super::LOWEST_GLOBE_M),
        ("SURF_SEEN", super::SURF_SEEN_M),
        ("SURF_HIGHEST", super::SURF_HIGHEST_M),
        ("LAKE_MIRRORS", super::LAKE_MIRRORS_M),
        ("CAUSTICS_HIGHEST", super::CAUSTICS_HIGHEST_M),
        ("USUAL_DENSITY", crate::scene::settings::USUAL_WATER_DENSITY_PER_M),
    ];
    let bits = bits.map(|(name, bit)| format!("const {name} = {bit}u;\n"));
    let numbers = numbers.map(|(name, number)| format!("const {name}: f32 = {number:?};\n"));
    bits.concat()
        + &numbers.concat()
        + &clouds_field()
        + &relief_numbers()
        + &bed_numbers()
        + &reef_numbers()
        + &shores::shared_constants()
}

/// Those of the bed near shores.
fn bed_numbers() -> String {
    let numbers = [
        ("USUAL_SLOPE", sea_bed::USUAL_SLOPE),
        ("EQUATOR_TEXEL", sea_bed::EQUATOR_TEXEL_M),
        ("BED_WIDEST", sea_bed::WIDEST_M),
        ("BED_UNKNOWN", sea_bed::LEAST_M[0]),
        ("BED_LEAST", sea_bed::LEAST_M[1]),
        ("BED_LEAST_SHARE", sea_bed::LEAST_SHARE),
        ("BED_WET", sea_bed::WET[0]),
        ("BED_ALL_WET", sea_bed::WET[1]),
        ("BERM", sea_bed::BERM_M),
        ("DEAN_A", sea_bed::DEAN[0]),
        ("DEAN_DEPTH", sea_bed::DEAN[1]),
        ("DEAN_CELL", sea_bed::DEAN[2]),
        ("SAND_LEAST", sea_bed::SAND[0]),
        ("SAND_MOST", sea_bed::SAND[1]),
        ("ROCKY_SLOPE", sea_bed::ROCKY_SLOPE),
        ("ROCK_ADDS", sea_bed::ROCK[0]),
        ("ROCK_MOST", sea_bed::ROCK[1]),
        ("CLIFF_BEGINS", sea_bed::CLIFF[0]),
        ("CLIFF_WHOLE", sea_bed::CLIFF[1]),
        ("CLIFF_SLOPE", sea_bed::CLIFF_SLOPE),
        ("ICE_BEGINS", sea_bed::ICE[0]),
        ("ICE_WHOLE", sea_bed::ICE[1]),
        ("FACE_LEAST", sea_bed::FACE[0]),
        ("FACE_RISES", sea_bed::FACE[1]),
    ];
    numbers.map(|(name, number)| format!("const {name}: f32 = {number:?};\n")).concat()
}

/// Those of coral reefs.
fn reef_numbers() -> String {
    let numbers = [
        ("EARTH_ROUND", std::f64::consts::TAU * WGS84.a),
        ("REEFS_MEASURED", rugged::MEASURED_M),
        ("REEFS_COARSEST", reefs::COARSEST_M),
        ("REEFS_CREST", reefs::CREST_M),
        ("REEFS_FARTHEST", reefs::FARTHEST_M),
        ("REEFS_FLAT", reefs::FLAT_M),
        ("REEFS_FLAT_MOST", reefs::FLAT_MOST),
        ("REEFS_PASS_BENDS", reefs::PASS_BENDS),
        ("REEFS_PASS_UNEVEN", reefs::PASS_UNEVEN),
        ("REEFS_PASS_CURLS", reefs::PASS_CURLS),
        ("REEFS_FRINGE", reefs::FRINGE_M),
        ("REEFS_GOES_ON", reefs::GOES_ON),
        ("REEFS_COMES_OVER", reefs::COMES_OVER),
        ("REEFS_CALMED", reefs::CALMED),
        ("REEFS_OPEN", reefs::OPEN_M),
        ("REEFS_ASHORE", reefs::ASHORE_M),
    ];
    let ranges = [
        ("REEFS_WARM", reefs::WARM),
        ("REEFS_WITHOUT_ENDS", reefs::WITHOUT_ENDS),
        ("REEFS_CREST_ROUGH", reefs::CREST_ROUGH_M),
        ("REEFS_CREST_DEPTH", reefs::CREST_DEPTH_M),
        ("REEFS_PASS", reefs::PASS_M),
        ("REEFS_PASS_CREST", reefs::PASS_CREST_M),
        ("REEFS_CHANNEL", reefs::CHANNEL_M),
        ("REEFS_CHANNEL_WIDE", reefs::CHANNEL_WIDE_M),
        ("REEFS_LAGOON", reefs::LAGOON),
        ("REEFS_FORE", reefs::FORE),
        ("REEFS_BEACH", reefs::BEACH_M),
        ("REEFS_BEGINS", reefs::BEGINS),
        ("REEFS_BY_PASS", reefs::BY_PASS_M),
        ("REEFS_ENCLOSED", reefs::ENCLOSED_M),
        ("REEFS_ENCLOSED_TO", reefs::ENCLOSED_TO_M),
    ];
    let without = [
        ("REEFS_WITHOUT_FIRST", reefs::WITHOUT[0]),
        ("REEFS_WITHOUT_SECOND", reefs::WITHOUT[1]),
        ("REEFS_WITHOUT_THIRD", reefs::WITHOUT[2]),
    ];
    let numbers = numbers.map(|(name, number)| format!("const {name}: f32 = {number:?};\n"));
    let ranges = ranges.map(|(name, [from, to])| format!("const {name} = vec2f({from:?}, {to:?});\n"));
    let without =
        without.map(|(name, [x, y, wide, high])| format!("const {name} = vec4f({x:?}, {y:?}, {wide:?}, {high:?});\n"));
    let [wide, fine, pass, rough] = reefs::BITS;
    let varies = reefs::CREST_VARIES;
    numbers.concat()
        + &ranges.concat()
        + &without.concat()
        + &format!(
            "const REEFS_BITS = vec4u({wide}u, {fine}u, {pass}u, {rough}u);\nconst REEFS_CREST_VARIES = vec3f({:?}, {:?}, {:?});\nconst REEFS_WIDE_LEVEL = {}u;\n",
            varies[0],
            varies[1],
            varies[2],
            reefs::WIDE_LEVEL
        )
}

/// Those of the relief.
fn relief_numbers() -> String {
    let whole = [
        ("RELIEF_BITS", relief::BROADEST_BITS),
        ("RELIEF_BROAD", relief::BROAD),
        ("RELIEF_OCTAVES", relief::OCTAVES),
        ("RUGGED_LEVEL", rugged::LEVEL.into()),
        ("RUGGED_SHORE_LEVEL", rugged::SHORE_LEVEL.into()),
        ("RUGGED_ISLAND_LEVEL", rugged::ISLAND_LEVEL.into()),
        ("RUGGED_SHELF_LEVEL", rugged::SHELF_LEVEL.into()),
        ("DROWNED_LEVEL", rugged::DROWNED_LEVEL.into()),
        ("DROWNED_SHORE_LEVEL", rugged::DROWNED_SHORE_LEVEL.into()),
        ("CARVED_FIRST", relief::CARVED_OCTAVES[0]),
        ("CARVED_LAST", relief::CARVED_OCTAVES[1]),
        ("TOWERS_BITS", towers::CELL_BITS),
    ];
    let numbers = [
        ("RELIEF_UNITS", relief::UNITS_PER_M * relief::RADIUS_M),
        ("RELIEF_MESH_FOOTPRINT", relief::MESH_FOOTPRINT_M),
        ("RELIEF_FIRST", relief::BROAD_HEIGHTS[0]),
        ("RELIEF_SECOND", relief::BROAD_HEIGHTS[1]),
        ("RELIEF_FOLD", relief::FOLD),
        ("RELIEF_FOLD_MEAN", relief::FOLD_MEAN),
        ("RELIEF_NOISE_GAIN", relief::NOISE_GAIN),
        ("RELIEF_WAVES", relief::WAVES),
        ("RELIEF_JITTER", relief::JITTER),
        ("RELIEF_LEVEL", relief::LEVEL),
        ("RELIEF_GENTLE", relief::GENTLE[0]),
        ("RELIEF_SLOPING", relief::GENTLE[1]),
        ("RELIEF_GULLIED", relief::GULLIED_M),
        ("RELIEF_DEEP", relief::DEEP),
        ("RELIEF_STEEPEST", relief::STEEPEST),
        ("RELIEF_FOLLOWS", relief::FOLLOWS),
        ("CARVED_BROAD", relief::CARVED_BROAD),
        ("CARVED_CREST", relief::CARVED_CREST),
        ("CARVED_MEAN", relief::CARVED_MEAN),
        ("CARVED_DEEP", relief::CARVED_DEEP[0]),
        ("CARVED_FINER", relief::CARVED_DEEP[1]),
        ("CARVED_MOST", relief::CARVED_MOST),
        ("CARVED_STEEPEST", relief::CARVED_STEEPEST),
        ("CARVED_DRY", rugged::CARVED_DRY),
        ("CARVED_JITTER", relief::CARVED_JITTER),
        ("TOWERS_ASIDE", towers::ASIDE),
        ("TOWERS_FLOOR", towers::FLOOR),
        ("TOWERS_HIGH", towers::HIGH_M),
        ("TOWERS_WALL", towers::WALL_M),
        ("TOWERS_FOOT", towers::FOOT_M),
        ("RUGGED_GAIN", rugged::GAIN_M),
        ("RUGGED_LIFT_GAIN", rugged::LIFT_GAIN),
        ("RUGGED_SHELF", rugged::SHELF),
        ("RUGGED_ROCKY_WIDE", rugged::ROCKY_WIDE_M),
        ("RUGGED_ISLAND_RISE", rugged::ISLAND_RISE),
        ("RUGGED_ISLAND_WIDE", rugged::ISLAND_WIDE_M),
        ("RUGGED_ISLAND_SOFT", rugged::ISLAND_SOFT_M),
        ("DROWNED_WIDE", rugged::DROWNED_WIDE_M),
        ("DROWNED_FOOT", rugged::DROWNED_FOOT_M),
        ("DROWNED_LAKE_FADE", rugged::DROWNED_LAKE_FADE_M),
        ("DROWNED_ROUGH", rugged::DROWNED_ROUGH),
        ("DROWNED_SOFT", rugged::DROWNED_SOFT_M),
        ("RUGGED_MOST", rugged::MOST_M),
        ("RUGGED_LEAST_SLOPE", rugged::LEAST_SLOPE),
        ("RUGGED_LOW", rugged::LOW_M),
        ("RUGGED_OF_HEIGHT", rugged::OF_HEIGHT),
        ("RUGGED_OF_MEAN", rugged::OF_MEAN),
        ("RUGGED_ICE_SLOPE", rugged::ICE_SLOPE),
        ("RUGGED_OCEAN_FADE", rugged::OCEAN_FADE_M),
        ("RUGGED_LAKE_FADE", rugged::LAKE_FADE_M),
        ("RUGGED_SEAM_FADE", rugged::SEAM_FADE),
        ("RUGGED_HIGHEST", rugged::HIGHEST_M),
    ];
    let ranges = [
        ("RUGGED_HIGH_LATITUDES", rugged::HIGH_LATITUDES),
        ("RUGGED_SHELF_DEPTHS", rugged::SHELF_M),
        ("RUGGED_BOLD", rugged::BOLD_M),
        ("RUGGED_KNOWN", rugged::KNOWN_M),
        ("DROWNED_BROKEN", rugged::DROWNED_BROKEN),
        ("DROWNED_INLAND", rugged::DROWNED_INLAND),
        ("DROWNED_HILLS", rugged::DROWNED_HILLS_M),
        ("DROWNED_SEA", rugged::DROWNED_SEA_M),
        ("DROWNED_RISE", rugged::DROWNED_RISE),
        ("TOWERS", rugged::TOWERS),
        ("TOWERS_WIDE", towers::WIDE),
        ("TOWERS_LONG", towers::LONG),
        ("TOWERS_TALL", towers::TALL),
        ("TOWERS_ROUGH", towers::ROUGH),
        ("TOWERS_ROUGH_SEEN", towers::ROUGH_SEEN_M),
        ("TOWERS_LATITUDES", towers::LATITUDES),
    ];
    let whole = whole.map(|(name, number)| format!("const {name} = {number}u;\n"));
    let numbers = numbers.map(|(name, number)| format!("const {name}: f32 = {number:?};\n"));
    let ranges = ranges.map(|(name, [from, to])| format!("const {name} = vec2f({from:?}, {to:?});\n"));
    whole.concat() + &numbers.concat() + &ranges.concat()
}

/// Those of the clouds' field, which the map of their weather needs alone.
pub fn clouds_field() -> String {
    let (side, variance) = (clouds::MAP_TEXELS, clouds::FINE_VARIANCE);
    format!("const CLOUD_SIDE = {side}u;\nconst CLOUD_VARIANCE: f32 = {variance:?};\n")
}
