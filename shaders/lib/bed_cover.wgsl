// What covers the sea's bed where it is not sand: seagrass in meadows of 30 to 250 m, torn at their edges, and rock. On a square of BED_SIDE
// metres of the map that repeats; seen from far above, no two squares are alike.
#import map
#import noise

const BED_SIDE: f32 = 4096.0;
const BED_TURN: f32 = 9784.0 * BED_SIDE;       // of a turn round the equator, which has a whole number of squares
const BARE_FROM: Metres = 45.0;                // no deeper bed is seen

fn bed_corner(cell: vec2i, cells: i32, salt: u32, offset: vec2f) -> vec3f {
    let word = hash(vec3u(bitcast<vec2u>(((cell % cells) + cells) % cells), salt));
    let slope = vec2f(f32(word & 0xffffu), f32(word >> 16u)) / 32767.5 - 1.0;
    return vec3f(slope, dot(slope, offset));
}

// Gradient noise about 0 with its slopes (x, y) and value (z), over cells of a number of metres that divides the square's side.
fn bed_noise(place: vec2f, cell: f32, salt: u32) -> vec3f {
    let p = place / cell;
    let low = floor(p);
    let f = p - low;
    let cells = i32(BED_SIDE / cell);
    let at = vec2i(low);
    let a = bed_corner(at, cells, salt, f);
    let b = bed_corner(at + vec2i(1, 0), cells, salt, f - vec2f(1.0, 0.0));
    let c = bed_corner(at + vec2i(0, 1), cells, salt, f - vec2f(0.0, 1.0));
    let d = bed_corner(at + vec2i(1, 1), cells, salt, f - vec2f(1.0, 1.0));
    let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    let k = a.z - b.z - c.z + d.z;
    let value = a.z + u.x * (b.z - a.z) + u.y * (c.z - a.z) + u.x * u.y * k;
    let slope = a.xy + u.x * (b.xy - a.xy) + u.y * (c.xy - a.xy) + u.x * u.y * (a.xy - b.xy - c.xy + d.xy)
        + du * (u.yx * k + vec2f(b.z - a.z, c.z - a.z));
    return vec3f(slope / cell, value);
}

// A place's part of the square, on Mercator's map; `part`: what its coordinate leaves out, of a unit.
fn pattern_place(point: MapPoint, part: vec2f) -> vec2f {
    let away = (vec2f(bitcast<vec2i>(point.at - frame.mercator_fixed)) + part) * (BED_TURN / 4294967296.0);
    return frame.bed_origin + vec2f(away.x, -away.y);
}

fn shown(footprint: Metres, width: Metres) -> f32 { return 1.0 - smoothstep(0.2, 0.6, footprint / width); }

const SEAGRASS = vec3f(0.035, 0.055, 0.022);
const REEF = vec3f(0.16, 0.125, 0.085);
const COVER_BEGINS = vec2f(0.33, 0.425);       // of the noise of meadows, and of reefs
const COVER_EDGE = vec2f(0.03, 0.025);         // half the width of an edge there

// `corals`: how far those of a reef cover it.
struct BedCover { grass: f32, rock: f32, corals: f32 }

// How deep seagrass grows where daylight fades so fast, per metre (C. Duarte 1991).
fn meadows_to(fading: f32) -> Metres { return 1.82 / pow(fading, 1.07); }

// Cover by the noises of meadows and of reefs, their edges `blurred` by what is not seen of them; meadows grow to `deepest`.
fn cover_of(meadow: f32, reef: f32, blurred: f32, depth: Metres, deepest: Metres) -> BedCover {
    let edge = COVER_EDGE + blurred;
    let begun = smoothstep(COVER_BEGINS - edge, COVER_BEGINS + edge, vec2f(meadow, reef));
    let grass = begun.x * smoothstep(0.7, 2.0, depth) * (1.0 - smoothstep(0.5, 1.0, depth / deepest));
    return BedCover(grass, begun.y * (1.0 - grass), 0.0);
}

const BED_NOISE_DEVIATION = 0.2;         // of `bed_noise`
const WIDE = vec4f(1.0, 1.0, 0.55, 0.6);       // parts of the noises over 256, 128, 64 and 32 m
const MEADOWS_FINE = vec3f(0.30, 0.22, 0.12);  // and, of meadows, of those over 16, 4 and 1 m

// How far a footprint shows either.
fn wide_shown(footprint: Metres) -> vec4f { return vec4f(shown(footprint, 256.0), shown(footprint, 128.0), shown(footprint, 64.0), shown(footprint, 32.0)); }
fn fine_shown(footprint: Metres) -> vec3f { return vec3f(shown(footprint, 16.0), shown(footprint, 4.0), shown(footprint, 1.0)); }

// The noises of meadows and of reefs, as far as they are shown.
fn meadow_and_reef(place: vec2f, wide: vec4f, fine: vec3f) -> vec2f {
    return vec2f(wide.x * bed_noise(place, 256.0, 41u).z + WIDE.z * wide.z * bed_noise(place, 64.0, 42u).z + dot(fine, MEADOWS_FINE),
        wide.y * bed_noise(place, 128.0, 43u).z + WIDE.w * wide.w * bed_noise(place, 32.0, 44u).z + dot(fine.yz, vec2f(0.35, 0.20)));
}

// As an eye in the water has it that sees so much of the bed in a pixel. `fine`: noises over 16, 4 and 1 m; `corals` as in world.wgsl.
fn bed_cover(place: vec2f, depth: Metres, deepest: Metres, corals: vec2f, fine: vec3f, footprint: Metres) -> BedCover {
    let wide = wide_shown(footprint);
    let near = fine_shown(footprint);
    let noise = meadow_and_reef(place, wide, fine * near);
    let hidden = length(vec2f(length(WIDE * (1.0 - wide)), length(MEADOWS_FINE * (1.0 - near))));
    var cover = cover_of(noise.x, noise.y + HEADS * corals.y, 1.5 * BED_NOISE_DEVIATION * hidden, depth, deepest);
    cover.grass *= 1.0 - SPARED * corals.y;
    cover.corals = corals.x * on_flat(noise.y, hidden);
    return cover;
}

const CORAL_SAND = vec3f(0.50, 0.47, 0.37);
const MOIST_SAND = 0.9;              // reflectance of sand that spray and the last tide have left moist over that of dry sand
const CORAL_SAND_TO: Metres = 60.0;  // depth to which the waves carry a reef's sand
const RUBBLE = vec3f(0.30, 0.265, 0.19);       // between corals
const RUBBLED = 0.7;                 // how far it covers what is there
const CORALS = vec3f(0.115, 0.100, 0.058);     // on a reef's crest and flat, with algae
const HEADS = 0.11;                  // how many more heads of coral stand in a lagoon than on other sand, of the noise
const SPARED = 0.6;                  // share of the meadows that a lagoon has not
const FLATS = vec2f(-0.45, 0.10);    // of the noise, between which corals cover more and more of a flat

// Sand where so much of it is a reef's.
fn with_coral_sand(sand: vec3f, depth: Metres, share: f32) -> vec3f {
    return mix(sand, MOIST_SAND * CORAL_SAND, share * smoothstep(CORAL_SAND_TO, 0.0, depth));
}

// How far corals cover a flat where the noise of reefs, of which so much is `hidden`, has this value.
fn on_flat(noise: f32, hidden: f32) -> f32 {
    let edge = vec2f(-1.0, 1.0) * BED_NOISE_DEVIATION * hidden;
    return smoothstep(FLATS.x + edge.x, FLATS.y + edge.y, noise);
}

const ALIKE_TO: Metres = 2.0;        // widths of pixels from which on meadows are many here and few there
const APART_FROM: Metres = 12.0;
const SPARSE = 0.09;                 // how wide the edges are between which meadows thin out, seen from above; of the noise

// Albedo of the bed from above the water, of sand that has that of `sand`: the same meadows and reefs, as far as pixels so wide show them; `corals` as in world.wgsl.
fn covered_bed(point: MapPoint, sand: vec3f, depth: Metres, deepest: Metres, corals: vec2f, footprint: Metres) -> vec3f {
    // Beyond the polar circles nothing grows there.
    if point.square != MERCATOR || depth > BARE_FROM { return sand; }
    let place = pattern_place(point, vec2f(0.0));
    let wide = wide_shown(footprint);
    let fine = vec3f(bed_noise(place, 16.0, 31u).z, bed_noise(place, 4.0, 32u).z, bed_noise(place, 1.0, 33u).z) * fine_shown(footprint);
    let regional = 0.9 * smoothstep(ALIKE_TO, APART_FROM, footprint) * vec2f(map_noise(point.at, 13u, 51u) - 0.5, map_noise(point.at, 15u, 52u) - 0.5);
    let noise = meadow_and_reef(place, wide, fine);
    let hidden = WIDE * (1.0 - wide);
    let cover = cover_of(noise.x + regional.x + regional.y, noise.y - regional.x + HEADS * corals.y, SPARSE + 1.5 * BED_NOISE_DEVIATION * length(hidden), depth, deepest);
    let tone = 1.0 + 0.22 * fine.x + 0.3 * wide.z * bed_noise(place, 64.0, 45u).z;
    let usual = mix(mix(sand * tone, SEAGRASS, cover.grass * (1.0 - SPARED * corals.y)), REEF, cover.rock);
    return mix(mix(usual, RUBBLE * tone, RUBBLED * corals.x), CORALS * (1.0 + 0.5 * fine.x), corals.x * on_flat(noise.y, length(hidden)));
}
