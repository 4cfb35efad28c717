// The foam map where it is drawn: share of the water covered by whitecaps, and by those that have just been made.
#import domain

@group(1) @binding(4) var foam_map: texture_2d<f32>;    // a channel per level; see src/scene/sea/foam.rs
const ALL_FOAM = vec2i(0);     // where in the map all foam lies, and the young
const YOUNG_FOAM = vec2i(0, FOAM_TEXELS);

const FOAM_FOLDS = 0u;         // rules of frame.foam_rule: the map; the water's height; the wind's share everywhere
const FOAM_HEIGHT = 1u;

// Rest coordinates about the eye in the foam map's plane, metres.
fn foam_coordinates(p: vec3f) -> vec2f {
    return in_plane(plane_of(0u), p);
}

// Texels of the lace, whose tile is unturned, from the one of the eye to a place of the foam map's plane: along the wind and across it.
fn lace_texels(at: vec2f) -> vec2f {
    let wind = wave_cells[0].wind;
    return frame.lace_fraction + vec2f(-wind.x * at.x - wind.y * at.y, wind.y * at.x - wind.x * at.y) / frame.foam_levels[0].side;
}

// How much of the waves' height the mesh still shows. Its triangles are four footprints wide: before they flatten the longest waves, a fifth of the patch,
// crests must not matter.
fn crests_kept(footprint: Metres) -> f32 { return 1.0 - smoothstep(0.1, 0.5, 4.0 * footprint / (0.2 * frame.perlin_patch)); }

// Beyond the map whitecaps lie on the crests: a log-normal share of the height, whose mean is what the wind asks for. The waves are `local`
// times as high as the open sea's.
fn share_beyond(height: Metres, local: f32, footprint: Metres) -> f32 {
    let contrast = 0.8 * crests_kept(footprint);
    let deviations = 4.0 * height / max(local * frame.wave_height, 1e-3);
    return min(frame.whitecaps * exp(contrast * deviations - 0.5 * contrast * contrast), 1.0);
}

// The share where no map is: on high water, or beyond the map.
fn share_from_afar(height: Metres, local: f32, footprint: Metres) -> f32 {
    let by_height = clamp((height - frame.foam_heights.x) / max(frame.foam_heights.y - frame.foam_heights.x, 1e-3), 0.0, 1.0);
    return select(share_beyond(height, local, footprint), by_height, frame.foam_rule == FOAM_HEIGHT);
}

// The map between four texels (x), and its slope per texel (yz), in full precision: samplers' weights have eight bits and differ from one driver to
// the next, which the edges of the lace would show. `texels`: from the corner of the eye's texel; `part`: ALL_FOAM or YOUNG_FOAM.
fn foam_between(origin: vec2i, texels: vec2f, level: u32, part: vec2i) -> vec3f {
    let v = texels - 0.5;
    let cell = origin + vec2i(floor(v));
    let f = v - floor(v);
    let mask = vec2i(FOAM_TEXELS - 1);
    let a = textureLoad(foam_map, (cell & mask) + part, 0)[level];
    let b = textureLoad(foam_map, ((cell + vec2i(1, 0)) & mask) + part, 0)[level];
    let c = textureLoad(foam_map, ((cell + vec2i(0, 1)) & mask) + part, 0)[level];
    let d = textureLoad(foam_map, ((cell + vec2i(1, 1)) & mask) + part, 0)[level];
    return vec3f(mix(mix(a, b, f.x), mix(c, d, f.x), f.y), mix(b - a, d - c, f.y), mix(c - a, d - b, f.x));
}

// Weight of a level whose texels are as wide as `side`: 1 for footprints under 0.35 of that, 0 over 2.5 times that. Even in the
// logarithm: neighbouring levels have whitecaps of their own, and whoever rises must not see the one give way to the other.
fn coarser_than(side: Metres, footprint: Metres) -> f32 {
    return clamp((1.32 - log2(footprint / side)) / 2.82, 0.0, 1.0);
}

// Young foam where its history is not known: as much of all foam as in the mean over a sea.
fn usual_young(share: f32) -> f32 { return 0.38 * share; }

// Shares covered, 0…1: by all foam, and by young foam, whose share rises by `slope` per metre in the map's plane.
struct FoamShare { all: f32, young: f32, slope: vec2f }

// Those of a rest point with the water at `height`; young foam is sought if `aged`. Each level serves as far as it reaches and while its texels are
// not much finer than the footprint; what no level serves has the share that the wind asks for.
fn foam_share(at: vec2f, height: Metres, local: f32, footprint: Metres, aged: bool) -> FoamShare {
    let afar = share_from_afar(height, local, footprint);
    let beyond = FoamShare(afar, usual_young(afar), vec2f(0.0));
    // The map leaves the picture by and by, though it would still be seen at FOAM_HIGHEST; other rules have none. No branch tells: vertices ask, too.
    let shown = select(0.0, smoothstep(0.0, 2.0, log2(FOAM_HIGHEST / max(frame.eye_altitude, 1.0))), frame.foam_rule == FOAM_FOLDS);
    var open = 1.0;
    var all = 0.0;
    var young = vec3f(0.0);
    var first = 0u;
    while first + 1u < FOAM_LEVELS && coarser_than(frame.foam_levels[first].side, footprint) <= 0.0 { first++; }
    var level = first;
    loop {
        let here = frame.foam_levels[level];
        let reach = max(abs(at.x), abs(at.y)) / (here.side * f32(FOAM_TEXELS / 2));
        let weight = open * (1.0 - smoothstep(0.75, 0.95, reach)) * coarser_than(here.side, footprint);
        if weight > 0.0 {
            let texels = here.fraction + at / here.side;
            all += weight * foam_between(here.texel, texels, level, ALL_FOAM).x;
            if aged { young += weight * foam_between(here.texel, texels, level, YOUNG_FOAM) * vec2f(1.0, 1.0 / here.side).xyy; }
        }
        open -= weight;
        level++;
        if level == FOAM_LEVELS || open <= 0.0 { break; }
    }
    return FoamShare(mix(beyond.all, all + open * beyond.all, shown), mix(beyond.young, young.x + open * beyond.young, shown), shown * young.yz);
}

// How thick the whitewater of a breaking crest is, of its length (J. Duncan 1981), and the variance of the slopes of the waves that it lies on.
const STANDS: f32 = 0.11;
const STANDS_ON: f32 = 0.01;

// Shares as of `foam_share` as they are seen at a sine over the water, of what they are from above: young foam stands up, and hides the more of the water
// behind it the lower the eye is.
fn standing(shares: vec2f, sine: f32) -> vec2f {
    let more = shares.y * STANDS * (inverseSqrt(sine * sine + STANDS_ON) - 1.0);
    return min(shares + max(more, 0.0), vec2f(1.0));
}
