// Points of light: each a small triangle with a round spot in it.

const SPOT: f32 = 0.75;        // standard deviation of a spot, pixels
const REACH: f32 = 4.0;        // of the spots, standard deviations, at most
const LEAST_REACH: f32 = 2.5;  // within it a triangle has 98 % of a spot: lamps that overlap add up
// What is added to a picture and not seen, as the display's tone takes it: faint spots, which are many, are smaller.
const UNSEEN: f32 = 3e-4;
// Beyond it a triangle lacks 0.4 % of a wide spot's light.
const WIDE_REACH: f32 = 3.0;

struct Spot {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) light: vec3f,  // in its middle, as the display's tone takes it
    @location(1) offset: vec2f,                    // from its middle, standard deviations
}

fn no_spot() -> Spot { return Spot(vec4f(2.0, 2.0, 0.0, 1.0), vec3f(0.0), vec2f(0.0)); }

// `deviation` in pixels, `reach` in deviations.
fn spot_of(clip: vec4f, depth: f32, deviation: f32, reach: f32, light: vec3f, index: u32) -> Spot {
    let offset = array(vec2f(0.0, 2.0), vec2f(-1.7321, -1.0), vec2f(1.7321, -1.0))[index % 3u] * reach;
    return Spot(vec4f(clip.xy / clip.w + 2.0 * deviation * offset / frame.viewport, depth, 1.0), light, offset);
}

// A point of light.
fn spot_at(clip: vec4f, depth: f32, light: vec3f, index: u32) -> Spot {
    let brightest = max(max(light.r, max(light.g, light.b)) / UNSEEN, 1.0);
    return spot_of(clip, depth, SPOT, clamp(sqrt(2.0 * log(brightest)), LEAST_REACH, REACH), light, index);
}

// A part of something wide at an endless distance; `deviation` in pixels.
fn wide_spot_at(clip: vec4f, deviation: f32, light: vec3f, index: u32) -> Spot { return spot_of(clip, 0.0, deviation, WIDE_REACH, light, index); }

@fragment
fn fragment(spot: Spot) -> @location(0) vec4f {
    return vec4f(spot.light * exp(-0.5 * dot(spot.offset, spot.offset)), 0.0);
}
