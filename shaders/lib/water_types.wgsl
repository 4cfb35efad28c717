// Kinds of sea water, in a row from the clearest to the most turbid: 0 gyre, 1 open ocean, 2 temperate, 3 shelf, 4 coastal, 5 turbid, 6 a river's with silt; what
// lies between is mixed. Who imports this declares FINE (src/pass/kind.rs): whether blooms and coasts show.
#import world
#import rivers
#import noise

// The light that deep water sends back over what falls on it, as seen from above straight down: pi times the remote-sensing reflectance
// with 0.03, 0.1, 0.5, 2 and 3 mg of chlorophyll per cubic metre, the last with dissolved matter besides, and of a muddy estuary,
// and of a river in which silt outshines all else, which is ours (H. Gordon et al. 1988, over R. Pope and E. Fry's 1997 water and A. Bricaud et al.'s 1998 particles, as linear sRGB). It holds the
// surface's transmission both ways.
fn deep_reflectance(kind: f32) -> vec3f {
    let clear = mix(mix(vec3f(0.0, 0.0028, 0.0322), OPEN_REFLECTANCE, saturate(kind)), vec3f(0.0, 0.0078, 0.0194), saturate(kind - 1.0));
    let green = mix(mix(clear, vec3f(0.0003, 0.0119, 0.0149), saturate(kind - 2.0)), vec3f(0.006, 0.024, 0.015), saturate(kind - 3.0));
    return mix(mix(green, vec3f(0.049, 0.083, 0.036), saturate(kind - 4.0)), SILTY_REFLECTANCE, saturate(kind - 5.0));
}

const SILTY_REFLECTANCE = vec3f(0.062, 0.056, 0.026);
const OPEN_REFLECTANCE = vec3f(0.0, 0.0043, 0.0265);

// How fast daylight fades with depth, per metre: Jerlov's types I, IB, II, III and coastal 3 (R. Austin and T. Petzold 1984); of an estuary
// ours.
fn attenuation(kind: f32) -> vec3f {
    let clear = mix(mix(vec3f(0.42, 0.060, 0.012), vec3f(0.42, 0.068, 0.030), saturate(kind)), vec3f(0.42, 0.084, 0.066), saturate(kind - 1.0));
    let green = mix(mix(clear, vec3f(0.42, 0.113, 0.133), saturate(kind - 2.0)), vec3f(0.43, 0.19, 0.40), saturate(kind - 3.0));
    return mix(green, vec3f(0.7, 0.5, 1.0), saturate(kind - 4.0));
}

// Light that the bubbles below dense foam scatter back, per metre: half as much as those of a fresh plume.
const BUBBLES_SCATTER: f32 = 0.015;
const PLUME_SHARE: f32 = 0.27;    // of that light, what leaves the water: 0.54 for its surface, 0.5 for the directions, which is ours

// Reflectance that such bubbles add to the water's, which takes light away on the way by its `attenuation`: blue in a gyre, turquoise in the open
// ocean, next to none in a muddy estuary.
fn plume_reflectance(kind: f32) -> vec3f { return PLUME_SHARE * BUBBLES_SCATTER / (attenuation(kind) + BUBBLES_SCATTER); }

// Level of the water tiles that tell coasts from the open sea: their distances reach 80 km at the equator.
const COAST_LEVEL = 4u;

// How much a place belongs to a coast: 1 at the shore, 0 from 50 km on.
fn coastal(point: MapPoint, sin_lat: f32) -> f32 {
    let page = pages_at(point, COAST_LEVEL).water;
    if page.layer == 0u { return 0.0; }
    let shore = bilinear(true, point, page).x * texel_metres(point, f32(page.level), sin_lat);
    return 1.0 - smoothstep(0.0, 50000.0, shore);
}

// The Mediterranean, as clear as the ocean's gyres at twice their latitude (N. Jerlov 1976: types I to IB): the middle and half axes of an ellipse
// on the Mercator square, 36.5 N and 17 E, 20 and 6.8 degrees, which leans, a degree south every five to the east: the Black Sea lies beside it.
const MEDITERRANEAN = vec4f(0.5472, 0.39096, 0.0556, 0.0235);
const MEDITERRANEAN_LEANS = 0.249;
const MEDITERRANEAN_KIND = 0.4;    // share of the kind that its latitude alone would give

fn in_mediterranean(point: MapPoint) -> f32 {
    let way = vec2f(point.at) / 4294967296.0 - MEDITERRANEAN.xy;
    let off = (way - vec2f(0.0, MEDITERRANEAN_LEANS * way.x)) / MEDITERRANEAN.zw;
    return select(0.0, smoothstep(1.5, 1.0, dot(off, off)), point.square == MERCATOR);
}

// By how many kinds rivers make a coast more turbid, where it is warm: elsewhere shelves are so green already;
const RUNOFF_KINDS = 3.2;
const SILT_KINDS = 4.5;        // and by how many the silt of great rivers does,
const SILT_AT_SEA = 0.5;       // of that, off the coast

// The kind of water at a place, within what the link allows. Without a map of chlorophyll: gyres are about 22 degrees from the equator;
// beyond 33 water is greener, on shelves more so, and by the shore of shelves where rivers reach; warm shelves stay clear but before land that drains to them; blooms and eddies are
// 80 to 300 km wide, and weaker over deep water. All ours.
fn water_kind(point: MapPoint, sin_lat: f32, depth: Metres) -> f32 {
    let s = abs(sin_lat);
    let off_gyre = (s - 0.37) / 0.15;
    let cool = smoothstep(0.54, 0.82, s);
    let shelf = smoothstep(300.0, 30.0, depth);
    let temperate = smoothstep(0.42, 0.75, s);
    var blooms = 0.0;
    var coast = 0.0;
    var rivers = 0.0;
    var silted = 0.0;
    if FINE {
        blooms = map_noise(point.at, 7u, 21u) + map_noise(point.at, 9u, 22u) - 1.0;
        coast = coastal(point, sin_lat);
        rivers = runoff(point);
        silted = silt(point);
    }
    let found = 1.0 - 0.8 * exp(-off_gyre * off_gyre) + 1.2 * cool + shelf * mix(0.3, 1.6, temperate)
        + coast * (mix(0.4, 1.0, shelf) * mix(0.2, 0.8, temperate) + RUNOFF_KINDS * rivers * shelf * (1.0 - temperate)) + mix(1.2, 2.0, shelf) * blooms
        + SILT_KINDS * silted * mix(SILT_AT_SEA, 1.0, coast);
    return clamp(found * mix(1.0, MEDITERRANEAN_KIND, in_mediterranean(point)), frame.water_kinds.x, frame.water_kinds.y);
}
