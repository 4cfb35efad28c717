// The weather of clouds over the whole earth, in axes that drift with them: levels of a normal field (src/model/clouds.rs), by octahedral
// coordinates (lib/clouds.wgsl). x: water clouds; y: ice clouds. src/pass/cloud_map.rs puts STORMS, CLOUD_SIDE and CLOUD_VARIANCE first.
#import cloud_noise
#import trigonometry

const TAU = 6.283185307179586;

// Storms wind clouds up in logarithmic spirals, as their bands lie (`Senn1959` of src/bibliography.rs). Numbers of storms and fronts are ours.
const STORM_WINDS = 2.1;        // cotangent of the angle at which spirals cross circles about the storm's middle
const STORM_EYE = 0.12;         // of its size: within, all turns as one
const STORM_REACH = 1.5;        // of its size: as far as it winds
const STORM_LEFT = 0.72;        // by how much less it moves each octave than the one before: what is small is young
// A front is a ray from the middle that is wound up like all else. Behind it, it is clear; before it clouds thin out.
const FRONT_PART = 0.85;        // of the weather at the middle that is the front's
const FRONT_WIDE = 2.2;         // squares of the storm's size over which that part fades
const FRONT_TURN = 0.43;        // of the ray: turns from the east, clockwise in the north
const FRONT_WIDTH = 0.176;      // radians, on a circle about the middle, over which clouds thin out
const FRONT_NEAR = 0.12;        // radians from the middle within which it gets narrower
const FRONT_EDGE = 0.5;         // how wide its rear edge is, of that
const FRONT_UNEVEN = 0.04;      // turns by which noise moves it
const BENT = 0.045;             // radians by which noise bends all weather
const LONG = array(vec3f(1.0, 1.0, 1.3), vec3f(1.0, 1.0, 1.8));     // clouds of water, of ice are longer along parallels
// Near the equator clouds stand in clusters: their part of the weather there, cells a radian, and the sine of the latitude over which it fades.
const CLUSTERS = vec3f(0.75, 11.0, 0.25);
const ICE_FRONTS = 0.6;         // of the variance of ice clouds' level where water clouds' is all the front's: part that is so too

struct Weather {
    storms: array<vec4f, 2u * STORMS>,  // of either weather: towards its middle; size, less than zero in the south
    weights: vec2f,
    numbers: vec2u,
}

@group(0) @binding(0) var<uniform> weather: Weather;
@group(0) @binding(1) var<storage, read_write> levels: array<vec2f>;

// As `belts` of src/model/clouds.rs.
fn cloud_belts(sin_lat: f32) -> f32 {
    let degrees = degrees(asin(clamp(sin_lat, -1.0, 1.0)));
    let bumps = (vec3f(degrees) - vec3f(6.0, 57.0, -57.0)) / vec3f(8.0, 20.0, 20.0);
    return dot(vec3f(1.0, 1.25, 1.25), exp(-bumps * bumps)) - 0.7;
}

fn turned_about(v: vec3f, axis: vec3f, angle: f32) -> vec3f {
    let turn = sine_cosine(angle);
    return turn.cosine * v + turn.sine * cross(axis, v) + (1.0 - turn.cosine) * dot(axis, v) * axis;
}

// Octaves from `first` cells a radian on, of a place that storms have moved; normal.
fn octaves(at: vec3f, moved: vec3f, first: f32, count: u32, salt: u32) -> f32 {
    var sum = 0.0;
    var squares = 0.0;
    var frequency = first;
    var amplitude = 1.0;
    var left = moved;
    for (var i = 0u; i < count; i++) {
        sum += amplitude * cloud_noise((at + left) * frequency, salt + i);
        squares += amplitude * amplitude;
        frequency *= 2.03;
        amplitude *= 0.80;
        left *= STORM_LEFT;
    }
    return sum * inverseSqrt(squares);
}

fn still_octaves(at: vec3f, first: f32, salt: u32) -> f32 { return octaves(at, vec3f(0.0), first, 3u, salt); }

// The level `ahead` turns from a front's rear edge, at a distance from the storm's middle: over all turns, of mean 0 and variance 1.
fn front(ahead: f32, away: f32) -> f32 {
    let width = FRONT_WIDTH / (TAU * length(vec2f(away, FRONT_NEAR)));
    let edge = FRONT_EDGE * width;
    // What is left of it after a turn is what its edge begins with.
    let last = exp((edge - 1.0) / width);
    let clouds = mix(last, 1.0, smoothstep(0.0, edge, ahead)) * exp(min(edge - ahead, 0.0) / width);
    // Means of a smooth step and of its square are 1/2 and 13/35, those of what falls exponentially 1 and 1/2 of its width.
    let mean = 0.5 * edge + width;
    return (clouds - mean) * inverseSqrt(13.0 / 35.0 * edge + 0.5 * width - mean * mean);
}

// What fronts add at a latitude in the mean over weathers, since their clouds are nearer the equator than the storms: fitted.
fn fronts_mean(sin_lat: f32) -> f32 {
    let degrees = degrees(asin(clamp(abs(sin_lat), 0.0, 1.0)));
    let bumps = (vec2f(degrees) - vec2f(26.0, 70.0)) / vec2f(12.0, 20.0);
    return dot(vec2f(0.18, -0.31), exp(-bumps * bumps));
}

// Levels of one weather. Each storm leaves some of what those after it make, so that the variance stays what it is.
fn weathered(d: vec3f, which: u32) -> vec2f {
    let salt = 64u * (weather.numbers[which] & 0xffffu);
    let uneven = FRONT_UNEVEN * still_octaves(d, 5.0, salt + 50u);
    var p = d;
    var fronts = -fronts_mean(d.z);
    var left = 1.0;
    for (var i = 0u; i < STORMS; i++) {
        let storm = weather.storms[which * STORMS + i];
        let side = sign(storm.w);
        // The square of the distance from its middle, in its sizes.
        let away = max(2.0 * (1.0 - dot(p, storm.xyz)), 0.0) / (storm.w * storm.w);
        let wound = 0.5 * STORM_WINDS * log((away + STORM_EYE * STORM_EYE) / (away + STORM_REACH * STORM_REACH)) * exp(-away / 8.0);
        p = turned_about(p, storm.xyz, side * wound);
        let east = normalize(vec3f(-storm.y, storm.x, 0.0));
        let turn = angle_of(side * dot(p, cross(storm.xyz, east)), dot(p, east)) / TAU;
        let part = FRONT_PART * exp(-away / FRONT_WIDE);
        fronts += left * part * front(fract(turn + FRONT_TURN + uneven), abs(storm.w) * sqrt(away));
        left *= sqrt(1.0 - part * part);
    }
    p += BENT * vec3f(still_octaves(p, 3.0, salt + 10u), still_octaves(p, 3.0, salt + 20u), still_octaves(p, 3.0, salt + 30u));
    let clustered = CLUSTERS.x * exp(-d.z * d.z / (CLUSTERS.z * CLUSTERS.z));
    let water = sqrt(1.0 - clustered * clustered) * octaves(LONG[0] * d, LONG[0] * (p - d), 4.0, 6u, salt)
        + clustered * octaves(d, p - d, CLUSTERS.y, 5u, salt + 8u);
    let ice = octaves(LONG[1] * d, LONG[1] * (p - d), 3.0, 6u, salt + 40u);
    return vec2f(fronts + left * water, sqrt(ICE_FRONTS) * fronts + sqrt(1.0 - ICE_FRONTS * (1.0 - left * left)) * ice);
}

@compute @workgroup_size(8, 8)
fn make(@builtin(global_invocation_id) id: vec3u) {
    let flat = (vec2f(id.xy) + 0.5) / f32(CLOUD_SIDE) * 2.0 - 1.0;
    var d = vec3f(flat, 1.0 - abs(flat.x) - abs(flat.y));
    let folded = (1.0 - abs(flat.yx)) * select(vec2f(-1.0), vec2f(1.0), flat >= vec2f(0.0));
    d = normalize(vec3f(select(d.xy, folded, vec2<bool>(d.z < 0.0)), d.z));
    var level = weather.weights.x * weathered(d, 0u);
    if weather.weights.y > 0.0 { level += weather.weights.y * weathered(d, 1u); }
    levels[id.y * CLOUD_SIDE + id.x] = sqrt(1.0 - CLOUD_VARIANCE) * level + vec2f(cloud_belts(d.z), 0.5 * cloud_belts(d.z) - 0.4);
}
