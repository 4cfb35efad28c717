// Spindrift over the sea: each plume is a sheet along the wind, turned to the eye, on which drops fly downwind.
#import plume
#import lace_net

@group(2) @binding(0) var<storage, read> plumes: array<Plume>;
@group(2) @binding(1) var scene_depth: texture_depth_2d;

const LEAST_STRENGTH = 0.004;      // that is drawn
const AHEAD = 0.4;                 // of its length and its width that a plume's middle lies downwind of its base, and above it
const ABOVE = 0.25;
const END_ON = 0.2;                // of its strength that a plume has left which is seen along the wind
// The tile of the lace that gives it its shape, so long and wide, metres; parts of the tile, of one a third as wide, and of a ninth.
const TILE = vec2f(36.0, 14.0);
const PARTS = vec3f(0.75, 0.58, 0.32);
// Turns of the wave clock's 32 bits in a turn of the drops along the tile: 18 m/s; those of finer tiles fly faster.
const FLIGHT = 2048u;
const BEGINS: f32 = 0.22;          // of its length in which it becomes dense
const NARROW: f32 = 0.3;           // its width where it begins, of that where it ends
const DENSE: f32 = 2.2;            // how far along it it stays dense
const WHIRLED: f32 = 0.22;         // of its width
const RAGGED: f32 = 0.85;          // how far its edge is torn, and over which levels it goes
const EDGE: f32 = 1.5;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,                            // along it and across, -1…1
    @location(1) metres: vec2f,
    @location(2) @interpolate(flat) light: vec3f,
    @location(3) @interpolate(flat) strength: f32,
    @location(4) @interpolate(flat) seed: f32,
    @location(5) @interpolate(flat) lod: f32,          // of the tile
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Vertex {
    let plume = plumes[index / 6u];
    if plume.strength < LEAST_STRENGTH { return Vertex(vec4f(2.0, 2.0, 0.0, 1.0), vec2f(0.0), vec2f(0.0), vec3f(0.0), 0.0, 0.0, 0.0); }
    let triangles = array(vec2f(-1.0, -1.0), vec2f(1.0, -1.0), vec2f(1.0, 1.0), vec2f(-1.0, -1.0), vec2f(1.0, 1.0), vec2f(-1.0, 1.0));
    let corner = triangles[index % 6u];
    let wind = downwind();
    let middle = plume.base + AHEAD * plume.size.x * wind + vec3f(0.0, 0.0, ABOVE * plume.size.y);
    let sight = normalize(middle);
    let along = wind - dot(wind, sight) * sight;
    let seen = length(along);
    let axis = along / max(seen, 1e-4);
    let half = 0.5 * vec2f(seen * plume.size.x + plume.size.y, plume.size.y);
    let metres = corner * half;
    let lod = log2(length(middle) * frame.pixel_angle * LACE_TEXELS / TILE.y);
    return Vertex(frame.clip_from_local * vec4f(middle + metres.x * axis + metres.y * cross(sight, axis), 1.0), corner, metres, plume.light,
        plume.strength * mix(END_ON, 1.0, seen), plume.seed, lod);
}

// Level of a tile `finer` times as small as TILE.
fn shape(at: vec2f, finer: f32, flown: f32, in: Vertex) -> f32 {
    let place = finer * at + vec2f(finer * in.seed - flown, in.seed);
    return lace_level(textureSampleLevel(lace, repeated, place, max(in.lod + log2(finer), 0.0)));
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    // Land before it.
    if textureLoad(scene_depth, vec2u(in.position.xy), 0) > in.position.z { discard; }
    let along = 0.5 * (in.at.x + 1.0);
    let at = in.metres / TILE;
    let flown = f32(frame.clock * FLIGHT) / 4294967296.0;
    let levels = vec3f(shape(at, 1.0, flown, in), shape(at, 3.0, 4.0 * flown, in), shape(at, 9.0, 14.0 * flown, in));
    // It spreads and is whirled about, the more, the farther it has flown.
    let across = (in.at.y + WHIRLED * along * (levels.x + levels.y)) / mix(NARROW, 1.0, along);
    let profile = smoothstep(0.0, BEGINS, along) * (1.0 - along) * max(1.0 - across * across, 0.0) * (1.0 - in.at.y * in.at.y);
    let level = dot(PARTS, levels);
    let opacity = in.strength * min(DENSE * profile, 1.0) * smoothstep(0.0, EDGE, level + 3.0 * profile - RAGGED);
    return opacity * vec4f(frame.exposure * in.light, 1.0);
}
