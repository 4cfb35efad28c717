// The foam map where it is drawn: share of the water covered by whitecaps, and their lace.
#import waves
#import hash

@group(1) @binding(4) var foam_map: texture_2d<f32>;    // a channel per square; see src/scene/foam.rs

const FOAM_FOLDS = 0u;         // rules of frame.foam_rule: the map; the water's height; the wind's share everywhere
const FOAM_HEIGHT = 1u;

// Rest coordinates about the eye in the foam map's frame, metres.
fn foam_coordinates(p: vec3f) -> vec2f {
    return vec2f(dot(p, nodes[0].axis_x), dot(p, nodes[0].axis_y));
}

// Share covered, 0…1, of a rest point with the water at `height`. Each square serves as far as it reaches and while its texels are
// not finer than the footprint; what no square serves has the share that the wind asks for.
fn foam_share(at: vec2f, height: Metres, footprint: Metres) -> f32 {
    if frame.foam_rule == FOAM_HEIGHT {
        return clamp((height - frame.foam_heights.x) / max(frame.foam_heights.y - frame.foam_heights.x, 1e-3), 0.0, 1.0);
    }
    if frame.foam_rule != FOAM_FOLDS { return frame.whitecaps; }
    var open = 1.0;
    var share = 0.0;
    for (var level = 0u; level < FOAM_LEVELS; level++) {
        let square = frame.foam_levels[level];
        let reach = max(abs(at.x), abs(at.y)) / (square.side * f32(FOAM_TEXELS / 2));
        let weight = open * (1.0 - smoothstep(0.75, 0.95, reach)) * (1.0 - smoothstep(1.0, 2.5, footprint / square.side));
        if weight <= 0.0 { continue; }
        let texel = vec2f(square.texel & vec2i(FOAM_TEXELS - 1)) + square.fraction + at / square.side;
        share += weight * textureSampleLevel(foam_map, repeated, texel / f32(FOAM_TEXELS), 0.0)[level];
        open -= weight;
    }
    return share + open * frame.whitecaps;
}

fn lattice_value(cell: vec2i, salt: u32) -> f32 {
    return f32(hash(vec3u(bitcast<vec2u>(cell), salt)) >> 8u) / 16777216.0;
}

// Value noise, 0…1, fixed to the water: `texels` about the eye of the finest square, in cells of 1 / `fine` texels.
fn foam_noise(texels: vec2f, fine: f32, salt: u32) -> f32 {
    let v = texels * fine;
    let cell = vec2i(floor(v)) + frame.foam_levels[0].texel * i32(fine);
    let f = v - floor(v);
    let u = f * f * (3.0 - 2.0 * f);
    return mix(
        mix(lattice_value(cell, salt), lattice_value(cell + vec2i(1, 0), salt), u.x),
        mix(lattice_value(cell + vec2i(0, 1), salt), lattice_value(cell + vec2i(1, 1), salt), u.x), u.y);
}

// Fading foam tears into lace: a share covers the points where a noise lies above it, so that the mean stays the share.
fn foam_lace(share: f32, at: vec2f, footprint: Metres) -> f32 {
    let blurred = smoothstep(0.05, 0.5, footprint);
    if share < 0.004 || blurred >= 1.0 { return share; }
    let square = frame.foam_levels[0];
    let texels = square.fraction + at / square.side;
    let noise = 0.45 * foam_noise(texels, 1.0, 1u) + 0.35 * foam_noise(texels, 3.0, 2u) + 0.2 * foam_noise(texels, 9.0, 3u);
    // The sum of three uniform variables, spread to about uniform again.
    let level = smoothstep(0.2, 0.8, noise);
    return mix(smoothstep(1.0 - share - 0.2, 1.0 - share + 0.2, level), share, blurred);
}
