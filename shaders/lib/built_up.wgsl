// How far ground is built up. Where towns are is known to a few hundred metres (src/pass/towns.rs); where they end and their parks are made up.
#import noise

// Each level's north-western texel, in units of the map; then how far its texels are in towns, rows from the north-west, four to a word.
struct Towns { corners: array<vec2u, 2>, texels: array<u32> }
@group(2) @binding(1) var<storage, read> towns: Towns;

const TOWN_SHIFTS = vec2u(15u, 18u);    // log2 of the units of a texel: 305 m and 2.4 km at the equator
const TOWN_SIDE = 512u;                 // texels; see src/pass/towns.rs
const TOWN_FADES: f32 = 32.0;           // texels before a window's edge over which a coarser one takes over, or none
const TOWN_EDGE = vec3f(0.16, 0.4, 0.3);  // where towns end, of what texels tell, and how far noises of 2.4 and .6 km move that
const PARKS = vec2f(0.2, 0.24);         // of a noise of 1.2 km, above which a town has a park,
const PARKS_BENT = -0.35;               // and how far the one of .6 km bends its edge, away from where a town is densest
const BUILT_SLOPES = vec2f(0.32, 0.16); // ground so steep has no houses, or as many as other ground
const TOWNS_SEEN = vec2f(500.0, 150.0);  // widths of pixels that show towns as imagery has them, and as they are drawn
const HIGH = vec3f(0.45, 3.0, 8.0);     // height of the highest houses there and of the towers in the midst of great cities, in lots: 7, 45 and 120 m
const DOWNTOWN = vec2f(0.75, 0.97);        // of what texels tell, where these begin and are highest

fn town_texel(level: u32, at: vec2u) -> f32 {
    let index = (level * TOWN_SIDE + at.y) * TOWN_SIDE + at.x;
    return f32((towns.texels[index >> 2u] >> (8u * (index & 3u))) & 255u) / 255.0;
}

// How far a place is in towns by a window, how that rises right and down on the map, of a texel, and how near the window's edge is, texels.
struct TownWindow { told: f32, rise: vec2f, edge: f32 }

fn town_window(level: u32, at: vec2u) -> TownWindow {
    let shift = select(TOWN_SHIFTS.x, TOWN_SHIFTS.y, level == 1u);
    let from_corner = at - towns.corners[level] - (1u << (shift - 1u));
    let cell = from_corner >> vec2u(shift);
    let inside = all(cell < vec2u(TOWN_SIDE - 1u));
    let a = min(cell, vec2u(TOWN_SIDE - 2u));
    let f = vec2f(from_corner & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    let top = vec2f(town_texel(level, a), town_texel(level, a + vec2u(1u, 0u)));
    let bottom = vec2f(town_texel(level, a + vec2u(0u, 1u)), town_texel(level, a + vec2u(1u)));
    let told = mix(mix(top.x, top.y, f.x), mix(bottom.x, bottom.y, f.x), f.y);
    let rise = vec2f(mix(top.y - top.x, bottom.y - bottom.x, f.y), mix(bottom.x - top.x, bottom.y - top.y, f.x));
    let edge = vec2f(min(a, TOWN_SIDE - 2u - a));
    if !inside { return TownWindow(0.0, vec2f(0.0), 0.0); }
    return TownWindow(told, rise, min(edge.x, edge.y));
}

// Where houses end: values that are positive at a place that may have one, of the town, of its parks, of the beach, metres, and of slopes; and how these rise right and
// down on the map, of a metre. A house stands whole or not at all, by the values at its lot's middle, as far as these rise evenly.
struct TownEdges { values: vec4f, right: vec4f, down: vec4f }

// How much of the ground is built up, how much lies in a town, parks too, and how densely and how high it is built, each from 0 to 1; the height that no
// house has more of, in lots.
struct BuiltUp { share: f32, within: f32, dense: f32, tall: f32, most: f32, edges: TownEdges }

const NO_EDGES = TownEdges(vec4f(-1.0), vec4f(0.0), vec4f(0.0));
const NOT_BUILT_UP = BuiltUp(0.0, 0.0, 0.0, 0.0, 0.0, NO_EDGES);

fn built_up(at: vec2u, slope: f32, footprint: Metres) -> BuiltUp {
    let fine = town_window(0u, at);
    let coarse = town_window(1u, at);
    let is_fine = saturate(fine.edge / TOWN_FADES);
    let told = mix(coarse.told * saturate(coarse.edge / TOWN_FADES), fine.told, is_fine);
    let wide = map_noise_rise(at, 14u, 95u);
    let narrow = map_noise_rise(at, 16u, 96u);
    let round_park = map_noise_rise(at, 15u, 97u);
    let park = round_park + PARKS_BENT * vec3f(1.0, 2.0, 2.0) * narrow;
    let inside = told - TOWN_EDGE.x + TOWN_EDGE.y * wide.x + TOWN_EDGE.z * narrow.x;
    let within = smoothstep(0.0, 0.05, inside) * smoothstep(0.0, 0.08, told) * smoothstep(TOWNS_SEEN.x, TOWNS_SEEN.y, footprint);
    let level = smoothstep(BUILT_SLOPES.x, BUILT_SLOPES.y, slope);
    let share = within * smoothstep(PARKS.y, PARKS.x, park.x) * level;
    // A unit of the map is so wide.
    let unit = EARTH_TURN * max(frame.cos_lat, 0.1) / 4294967296.0;
    // Noise alone makes no town.
    let is_told = told - 0.04 < inside - 0.025;
    let told_rise = is_fine * fine.rise / (exp2(f32(TOWN_SHIFTS.x)) * unit);
    // That of coarse texels is as good as none.
    let rise = told_rise + select((TOWN_EDGE.y * wide.yz / exp2(18.0) + TOWN_EDGE.z * narrow.yz / exp2(16.0)) / unit, vec2f(0.0), is_told);
    let park_rise = -park.yz / (exp2(17.0) * unit);
    let values = vec4f(min(inside - 0.025, told - 0.04), 0.5 * (PARKS.x + PARKS.y) - park.x, 0.0, level - 0.5);
    let edges = TownEdges(values, vec4f(rise.x, park_rise.x, 0.0, 0.0), vec4f(rise.y, park_rise.y, 0.0, 0.0));
    return BuiltUp(share, within, smoothstep(0.1, 0.75, inside), smoothstep(DOWNTOWN.x, DOWNTOWN.y, told + 0.3 * narrow.x), HIGH.z, edges);
}
