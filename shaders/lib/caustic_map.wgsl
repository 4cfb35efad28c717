// Where the map of caustics lies: a square about the foot of the eye on the bed, whose texels are finest in the middle. Its ways are
// level, metres east and north of the eye. The map holds the irradiance by the sun over that under a flat surface: on the bed, or where that
// is deep, on a level plane some metres below the surface or an eye in the water, from where its pattern goes on along the sun's rays.
#import frame

const CAUSTIC_REACH: f32 = 36.0;       // metres from an eye in the water to the map's edge
const CAUSTIC_EVEN: f32 = 2.5;         // metres about it where texels are about alike; beyond they grow with the distance
const CAUSTIC_LOW: Metres = 6.0;       // from so high on both grow with the altitude
const CAUSTICS_FADE = vec2f(0.6, 1.0); // of the altitude from which an eye over the water sees none of it

fn caustic_scale() -> f32 { return max(frame.eye_altitude / CAUSTIC_LOW, 1.0); }
fn caustic_reach() -> Metres { return caustic_scale() * CAUSTIC_REACH; }

// How much of it an eye sees: from high up a pixel hides it.
fn caustics_seen() -> f32 { return smoothstep(CAUSTICS_FADE.y, CAUSTICS_FADE.x, frame.eye_altitude / CAUSTICS_HIGHEST); }

// Depth of the map's place where the bed is so deep.
fn caustic_depth(depth: Metres) -> Metres { return clamp(depth, 0.1, max(8.0, 4.0 - frame.eye_altitude)); }

fn inverse_sinh(x: vec2f) -> vec2f { return sign(x) * log(abs(x) + sqrt(x * x + 1.0)); }

fn caustic_ends() -> f32 { return log(CAUSTIC_REACH / CAUSTIC_EVEN + sqrt(CAUSTIC_REACH * CAUSTIC_REACH / (CAUSTIC_EVEN * CAUSTIC_EVEN) + 1.0)); }

// Coordinates in the map, -1 to 1, of a place on the bed; and back.
fn caustic_coordinates(place: vec2f) -> vec2f { return inverse_sinh(place / (caustic_scale() * CAUSTIC_EVEN)) / caustic_ends(); }

fn caustic_place(at: vec2f) -> vec2f {
    let e = exp(abs(at) * caustic_ends());
    return caustic_scale() * CAUSTIC_EVEN * sign(at) * 0.5 * (e - 1.0 / e);
}

// Metres of the bed by coordinates of the map, along each axis.
fn caustic_stretch(at: vec2f) -> vec2f {
    let e = exp(abs(at) * caustic_ends());
    return caustic_scale() * CAUSTIC_EVEN * caustic_ends() * 0.5 * (e + 1.0 / e);
}

// A place in the map of so many texels a side.
fn caustic_texel(at: vec2f, side: f32) -> vec2f { return clamp((vec2f(0.5, -0.5) * at + 0.5) * side, vec2f(1.5), vec2f(side - 1.5)); }

fn caustic_row(map: texture_2d<f32>, middle: vec2u, row: u32, weights: vec3f) -> f32 {
    return dot(weights, vec3f(textureLoad(map, vec2u(middle.x - 1u, row), 0).r, textureLoad(map, vec2u(middle.x, row), 0).r,
        textureLoad(map, vec2u(middle.x + 1u, row), 0).r));
}

// Irradiance by the sun at a place on the bed over that under a flat surface: 1 in the mean, and beyond the map. A quadratic B-spline over
// nine texels, about as wide near the eye as the sun's disc makes the finest lines in some metres of water. Texel by texel: the sea's bindings
// hold no texture that could be filtered.
fn caustic_at(map: texture_2d<f32>, place: vec2f) -> f32 {
    let at = caustic_coordinates(place);
    let p = caustic_texel(at, f32(textureDimensions(map).x));
    let middle = vec2u(p);
    let t = p - floor(p) - 0.5;
    let x = vec3f(0.5 * (0.5 - t.x) * (0.5 - t.x), 0.75 - t.x * t.x, 0.5 * (0.5 + t.x) * (0.5 + t.x));
    let y = vec3f(0.5 * (0.5 - t.y) * (0.5 - t.y), 0.75 - t.y * t.y, 0.5 * (0.5 + t.y) * (0.5 + t.y));
    let light = dot(y, vec3f(caustic_row(map, middle, middle.y - 1u, x), caustic_row(map, middle, middle.y, x), caustic_row(map, middle, middle.y + 1u, x)));
    let inside = 1.0 - smoothstep(0.7, 0.92, max(abs(at.x), abs(at.y)));
    return mix(1.0, light, inside);
}

const BRIGHTEST_NEAR = 5.0;            // single texels shine like sparks

// The same by the nearest texel alone: for sums over many places.
fn caustic_near(map: texture_2d<f32>, place: vec2f) -> f32 {
    let at = caustic_coordinates(place);
    let light = min(textureLoad(map, vec2u(caustic_texel(at, f32(textureDimensions(map).x))), 0).r, BRIGHTEST_NEAR);
    return mix(1.0, light, 1.0 - smoothstep(0.7, 0.92, max(abs(at.x), abs(at.y))));
}
