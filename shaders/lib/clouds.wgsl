// Clouds: one field over the earth for eyes at any height. A place is in cloud where a normal level, the weather's of cloud_map.wgsl and
// octaves from 32 km down, lies above zero; the more, the higher the cloud stands on its base. What a footprint hides of the octaves is a
// variance, so that the share that clouds cover hardly depends on who looks from where.
#import cloud_noise
#import cloud_layer
#import light
#import ellipsoid
#import map
#import normal

@group(1) @binding(12) var<storage, read> cloud_levels: array<vec2f>;

const CLOUD_TALL = 1.1;             // deviations over which a low cloud is as high as that
const CLOUD_SQUASH = 0.8;           // how much less a high one rises for each more: none is cut off flat at the layer's top
const CLOUD_ROUNDED = vec2f(0.09, 0.12);    // height in the layer up to which bases' rims are round, and by how many deviations they lie further in at the base
const CLOUD_SPARE = 0.9;            // deviations of the weather's level from which on it makes clouds no higher
const CLOUD_SOFT = 0.035;           // deviations over which its edge goes
const CLOUD_WIDEST: Metres = 32000.0;   // cells of the octaves
const CLOUD_FINER = 2.5;            // each octave's cells than those before
// Share of the variance of all octaves before heaps, and of the first of heaps; of each octave of these, of the one before; and of what they are made of.
const CLOUD_FIRST = 0.49;
const HEAPS_FIRST = 0.2118;
const HEAPS_FADE = 0.9;
const BILLOW_FADE = 0.36;
// Of each octave before heaps, of the one before: of ragged masses, of scattered clouds. The weather's levels tell where which are, a turn for so many.
const CLOUD_FADES = vec2f(0.45, 1.3);
const CLOUD_KINDS = vec2f(0.85, 1.55);
// Octaves before heaps are drawn out across this way: so wide, of their length, are cells along it. Which way they lie depends on the place.
const CLOUD_ACROSS = vec3f(0.48, -0.36, 0.8);
const CLOUD_LONG = 0.4;
const CLOUD_BENT = vec3f(0.06, -0.03, 0.05);   // cells by which each octave before heaps bends those after it
// Cells of what heaps are made of are turned against those before: where all lie along the same axes, heaps are square.
const CLOUD_TURN = mat3x3f(0.0, 0.8, 0.6, -0.8, 0.36, -0.48, -0.6, -0.48, 0.64);
const CLOUD_OCTAVES = 9u;
const CLOUD_BILLOWS = 3u;        // from this octave on they are heaps of round lobes, creased where the noise is none

// From this octave on lobes stand on heaps: of one that the level before it leaves so far outside, in deviations, so much is there. All of it would be scraps
// that float on their own, as many as heaps, like confetti.
const CLOUD_LOBES = 5u;
const CLOUD_BESIDE = vec2f(-0.5, 0.1);
const CLOUD_SCRAPS = 0.2;

// A place of the local frame, in metres from the earth's middle along axes that drift with the clouds.
fn cloud_place(local: vec3f) -> vec3f { return frame.cloud_eye + cloud_way(local); }

// A way of the local frame along those axes.
fn cloud_way(local: vec3f) -> vec3f {
    let m = meridian_from_local(local);
    let turn = frame.cloud_meridian;
    return vec3f(turn.x * m.x - turn.y * m.y, turn.y * m.x + turn.x * m.y, m.z);
}

fn cloud_texel(at: vec2i) -> vec2f {
    let side = i32(CLOUD_SIDE);
    // Beyond an edge of the octahedron's map the same edge goes on the other way.
    let beside = (at.x < 0) | (at.x >= side);
    var p = vec2i(select(at.x, select(2 * side - 1 - at.x, -1 - at.x, at.x < 0), beside), select(at.y, side - 1 - at.y, beside));
    let above = (p.y < 0) | (p.y >= side);
    p = vec2i(select(p.x, side - 1 - p.x, above), select(p.y, select(2 * side - 1 - p.y, -1 - p.y, p.y < 0), above));
    return cloud_levels[u32(p.y * side + p.x)];
}

// Levels of the weather: of water clouds, of ice clouds.
fn cloud_weather(place: vec3f) -> vec2f {
    let d = place / (abs(place.x) + abs(place.y) + abs(place.z));
    let folded = (1.0 - abs(d.yx)) * select(vec2f(-1.0), vec2f(1.0), d.xy >= vec2f(0.0));
    let at = (select(d.xy, folded, vec2<bool>(d.z < 0.0)) * 0.5 + 0.5) * f32(CLOUD_SIDE) - 0.5;
    let cell = vec2i(floor(at));
    let f = at - floor(at);
    return frame.cloud_shift + mix(
        mix(cloud_texel(cell), cloud_texel(cell + vec2i(1, 0)), f.x),
        mix(cloud_texel(cell + vec2i(0, 1)), cloud_texel(cell + vec2i(1, 1)), f.x), f.y);
}

// Deviations of what is left of the field beyond which it is certain whether a place is in cloud.
const CLOUD_CERTAIN = 3.5;

// How much of the octaves there is, at least, and how much more, times a number that is evenly spread from 0 to 1: a mean square of about 1.
const HEAPED = vec2f(0.5, 0.92);
// The ice clouds' level about its mean, by which that number goes: by its usual value and deviation.
const HEAPED_BY = vec2f(-0.6, 0.77);

// How much of the octaves there is at a place: fields of small heaps here, sheets and wide gaps there.
fn heaped(weather: vec2f) -> f32 { return HEAPED.x + HEAPED.y * heaped_share(weather); }

// Which kind clouds at a place are, 0 to 1: it goes to and fro as the weather's levels rise, a turn for so many, `on` radians ahead.
fn cloud_kind(weather: vec2f, on: f32) -> f32 { return 0.5 + 0.5 * sin(dot(CLOUD_KINDS, weather - frame.cloud_shift) + on); }

// Drawn out across CLOUD_ACROSS.
fn drawn_out(place: vec3f) -> vec3f { return CLOUD_LONG * place + (1.0 - CLOUD_LONG) * dot(CLOUD_ACROSS, place) * CLOUD_ACROSS; }

fn heaped_share(weather: vec2f) -> f32 { return normal_share((weather.y - frame.cloud_shift - HEAPED_BY.x) / HEAPED_BY.y); }

// The level of water clouds at a place, and the variance that a footprint hides of it, or that cannot bring it to the other side of `asked`;
// `weather`: the levels of it there; `edge`: that above which the place is in cloud. As in lib/waves.wgsl, the loop ends at its foot.
fn cloud_level_of(weather: vec2f, place: vec3f, footprint: Metres, edge: f32, asked: f32) -> vec2f {
    var sum = weather.x;
    var turned = drawn_out(place);
    var cell = CLOUD_WIDEST;
    let heaps = heaped(weather);
    let variance = CLOUD_VARIANCE * heaps * heaps;
    let fade = mix(CLOUD_FADES.x, CLOUD_FADES.y, cloud_kind(weather, 0.0));
    var part = variance * CLOUD_FIRST / (1.0 + fade + fade * fade);
    var hidden = variance;
    var i = 0u;
    loop {
        let shown = 1.0 - smoothstep(0.2, 0.7, footprint / cell);
        let noise = cloud_noise(turned / cell, i);
        let bulge = select(1.0, mix(CLOUD_SCRAPS, 1.0, smoothstep(CLOUD_BESIDE.x, CLOUD_BESIDE.y, sum - edge)), i >= CLOUD_LOBES);
        sum += sqrt(part) * bulge * shown * select(noise, (abs(noise) - 0.798) / 0.603, i >= CLOUD_BILLOWS);
        hidden -= part * shown * shown;
        turned += select(vec3f(0.0), noise * cell * CLOUD_BENT, i < CLOUD_BILLOWS);
        if i >= CLOUD_BILLOWS { turned = CLOUD_TURN * turned; }
        if i + 1u == CLOUD_BILLOWS { turned = place; }
        cell /= CLOUD_FINER;
        part = select(part * select(select(fade, HEAPS_FADE, i == CLOUD_BILLOWS), BILLOW_FADE, i > CLOUD_BILLOWS), variance * HEAPS_FIRST, i + 1u == CLOUD_BILLOWS);
        i++;
        let is_certain = abs(sum - asked) > CLOUD_CERTAIN * sqrt(max(hidden, 0.0) + CLOUD_SOFT * CLOUD_SOFT);
        if i == CLOUD_OCTAVES || footprint >= 0.7 * cell || is_certain { break; }
    }
    return vec2f(sum, max(hidden, 0.0));
}

fn cloud_level(place: vec3f, footprint: Metres, edge: f32) -> vec2f {
    return cloud_level_of(cloud_weather(place), place, footprint, edge, edge);
}

// What a footprint sees of clouds: the share that is in one, and how far, in the mean of these, the level lies above the edge there.
struct InCloud { share: f32, excess: f32 }

fn in_cloud(level: vec2f, edge: f32) -> InCloud {
    let deviation = sqrt(level.y + CLOUD_SOFT * CLOUD_SOFT);
    let x = clamp((level.x - edge) / deviation, -5.0, 5.0);
    let share = max(normal_share(x), 1e-7);
    return InCloud(share, min(deviation * (x + 0.3989423 * exp(-0.5 * x * x) / share), 1.5));
}

// How much more than heaps need the weather has where they close. It makes them no higher, so that closed clouds' tops are as uneven as others'.
fn spare(weather: f32) -> f32 { return max(weather - CLOUD_SPARE, 0.0); }

// The level above which a place at a height, 0 at the base and 1 at the top of the layer, is in cloud, where the weather's is as given: clouds are
// domes on a level base, whose rim is round.
fn cloud_edge(height: f32, weather: f32) -> f32 {
    let square = height * max(height, 0.0);
    let rounded = max(1.0 - abs(height) / CLOUD_ROUNDED.x, 0.0);
    return CLOUD_TALL * square / max(1.0 - CLOUD_SQUASH * square, 0.1) + CLOUD_ROUNDED.y * rounded * rounded + spare(weather) * smoothstep(0.1, 0.6, height);
}

// And about the height of the top that a place's level makes: where clouds close, it is right from over the middle of the layer on.
fn cloud_top(level: f32, weather: f32) -> f32 {
    let heap = max(level - spare(weather), 0.0);
    return min(sqrt(heap / (CLOUD_TALL + CLOUD_SQUASH * heap)), 1.0);
}

const CLOUD_SHADOW: Metres = 1500.0;    // height of what casts it
const SHADOW_BLUR: Metres = 150.0;      // clouds spread what they let through over so much
const ASIDE = 0.15;                     // what droplets scatter otherwise than ahead; the disc loses the rest as well
// Per metre of a heap, a deviation of the level above the edge: of the light that clouds.wgsl's droplets, 0.05 a metre in the thin base and five times that
// over it, scatter aside. They thin out towards edges, so that of the 0.0075 to 0.0375 it has this; fitted.
const HEAP_EXTINCTION = 0.02;
const OVERHEAD: Metres = 6000.0;        // as wide as the sky is that most of its light comes from

// Share of the sky over a place that is in cloud, given the weather and the place in clouds.
fn cloud_cover(weather: vec2f, place: vec3f, footprint: Metres) -> f32 {
    return in_cloud(cloud_level_of(weather, place, max(footprint, OVERHEAD), 0.0, 0.0), 0.0).share;
}

const LOWEST_LIGHT = -0.01;     // sine of the elevation of light over the sea: lower, it lights no cloud from where it is

// What clouds leave at a place of the sun's light; the share of them overhead; what of the light that is left comes from the sun's disc.
struct Shadow { left: f32, cover: f32, disc: f32 }

fn cloud_shadow(at: vec3f, up: vec3f, footprint: Metres) -> Shadow {
    // Up there light comes in more steeply, as the earth bends away: where a low sun's meets the clouds an eye sees it among them.
    let low = max(dot(frame.light, up), LOWEST_LIGHT);
    let mu = sqrt(low * low + 2.0 * CLOUD_SHADOW / frame.semi_major);
    let overhead = cloud_place(at + frame.light * (2.0 * CLOUD_SHADOW / (low + mu)));
    let weather = cloud_weather(overhead);
    let cloud = in_cloud(cloud_level_of(weather, overhead, max(footprint, SHADOW_BLUR), 0.0, 0.0), 0.0);
    // Where clouds close they are dense below what makes heaps high: as if they were as high as heaps of that level.
    let tall = cloud_top(cloud.excess, 0.0) * (CLOUD_TOP - CLOUD_BASE);
    let through = exp(-HEAP_EXTINCTION * cloud.excess * tall / mu);
    let cover = cloud_cover(weather, overhead, footprint);
    let left = 1.0 - cloud.share * (1.0 - through);
    let disc = (1.0 - cloud.share + cloud.share * pow(through, 1.0 / ASIDE)) / max(left, 1e-6);
    return Shadow(left, cover, disc);
}

const MIRRORED_HIDES = 0.0045;       // per metre of a cloud, a deviation above the edge; fitted to what blurred ones hide of the sky
const MIRRORED_SPREAD: f32 = 0.15;   // of the rise of what rough water mirrors

// Share of the sky that clouds hide towards `direction` from a place, as rough water mirrors it.
fn mirrored_clouds(at: vec3f, direction: vec3f, up: vec3f, footprint: Metres) -> f32 {
    // Facets spread what they mirror over some 12 degrees: what lies at the horizon is mirrored with what stands over it. Cloud by cloud, each pixel
    // would find another, as the way to them changes there with the least slope.
    let level = max(dot(direction, up), 0.0);
    let rise = sqrt(level * level + MIRRORED_SPREAD * MIRRORED_SPREAD);
    let way = CLOUD_SHADOW / rise;
    let cloud = in_cloud(cloud_level(cloud_place(at + direction * min(way, 60000.0)), max(max(0.2 * way, 1500.0), footprint), 0.1), 0.1);
    return 1.0 - pow(1.0 - cloud.share * (1.0 - exp(-MIRRORED_HIDES * cloud.excess * 1200.0)), 1.0 / rise);
}
