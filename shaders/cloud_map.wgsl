// The weather of clouds over the whole earth, in axes that drift with them: levels of a normal field (src/model/clouds.rs), by octahedral
// coordinates (lib/clouds.wgsl). x: water clouds; y: ice clouds. src/pass/cloud_map.rs puts STORMS, CLOUD_SIDE and CLOUD_VARIANCE first.
#import cloud_noise

const STORM_WIDTH = 0.17;      // radians over which a storm turns clouds

struct Weather {
    storms: array<vec4f, 2u * STORMS>,  // of either weather: towards its middle; angle
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
    let c = cos(angle);
    return c * v + sin(angle) * cross(axis, v) + (1.0 - c) * dot(axis, v) * axis;
}

// Octaves from `first` cells a radian on; normal.
fn octaves(p: vec3f, first: f32, count: u32, salt: u32) -> f32 {
    var sum = 0.0;
    var squares = 0.0;
    var frequency = first;
    var amplitude = 1.0;
    for (var i = 0u; i < count; i++) {
        sum += amplitude * cloud_noise(p * frequency, salt + i);
        squares += amplitude * amplitude;
        frequency *= 2.03;
        amplitude *= 0.78;
    }
    return sum * inverseSqrt(squares);
}

// Levels of one weather.
fn weathered(d: vec3f, which: u32) -> vec2f {
    var p = d;
    for (var i = 0u; i < STORMS; i++) {
        let storm = weather.storms[which * STORMS + i];
        let away = 2.0 * (1.0 - dot(p, storm.xyz)) / (STORM_WIDTH * STORM_WIDTH);
        p = turned_about(p, storm.xyz, storm.w * exp(-away));
    }
    let salt = 64u * (weather.numbers[which] & 0xffffu);
    let bent = p + 0.09 * vec3f(octaves(p, 3.0, 3u, salt + 10u), octaves(p, 3.0, 3u, salt + 20u), octaves(p, 3.0, 3u, salt + 30u));
    return vec2f(octaves(bent, 4.0, 6u, salt), octaves(bent * vec3f(1.0, 1.0, 1.8), 3.0, 6u, salt + 40u));
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
