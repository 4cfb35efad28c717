// What a pixel has of the sea's mesh, and how two texels of four words keep it: what is known of its place need not be kept, the way there by its
// distance, its height over the water at rest by both, the shadow of clouds by the place (in fine pictures, which alone are drawn so).
#import ellipsoid

// What a pixel has of the sea's mesh, as its vertices have it (sea_vertex.wgsl); `right` and `down`: the way over the water at rest to the next one.
struct Patch {
    rest: vec3f,
    moved: vec3f,
    height: Metres,
    incoming: Metres,
    shadow: vec3f,
    grid: vec4f,
    ahead: vec2f,
    right: Metres,
    down: Metres,
}

struct Places { @location(0) first: vec4u, @location(1) second: vec4u }

// Logarithms of ways in twelve bits each, and a share in eight: half a step is 0.005.
const WAYS_FROM = -13.5;
const WAYS_STEPS = 102.4;         // of a doubling

fn ways_and_share(ways: vec2f, share: f32) -> u32 {
    return dot(vec3u(round(clamp(vec3f((ways - WAYS_FROM) * WAYS_STEPS, 255.0 * share), vec3f(0.0), vec3f(4095.0, 4095.0, 255.0)))), vec3u(1u, 4096u, 16777216u));
}

fn ways_of(word: u32) -> vec2f { return vec2f(vec2u(word, word >> 12u) & vec2u(4095u)) / WAYS_STEPS + WAYS_FROM; }

fn packed(in: Patch) -> Places {
    let ways = log2(max(vec2f(in.right, in.down), vec2f(1e-4)));
    return Places(vec4u(bitcast<vec3u>(in.rest), bitcast<u32>(dot(in.moved, frame.ray_forward))),
        vec4u(ways_and_share(ways, in.grid.w), pack2x16float(in.ahead), pack2x16float(in.grid.xy), pack2x16float(vec2f(in.grid.z, in.incoming))));
}

fn unpacked(places: Places, pixel: vec2u) -> Patch {
    let rest = bitcast<vec3f>(places.first.xyz);
    let device = vec2f(2.0, -2.0) * ((vec2f(pixel) + 0.5) / frame.viewport - 0.5);
    let moved = bitcast<f32>(places.first.w) * (frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up);
    let ways = exp2(ways_of(places.second.x));
    let last = unpack2x16float(places.second.w);
    let up = normal_delta(rest) + vec3f(0.0, 0.0, 1.0);
    // Where waves are smaller than pixels the bisected mesh is lifted, by no wave.
    let height = select(dot(moved - rest, up), 0.0, waves_are_pixels(length(moved)));
    return Patch(rest, moved, height, last.y, vec3f(0.0), vec4f(unpack2x16float(places.second.z), last.x, f32(places.second.x >> 24u) / 255.0),
        unpack2x16float(places.second.y), ways.x, ways.y);
}
