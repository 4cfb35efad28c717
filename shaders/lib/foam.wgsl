// The foam map where it is drawn: share of the water covered by whitecaps, and their lace.
#import waves
#import hash

@group(1) @binding(4) var foam_map: texture_2d<f32>;    // a channel per square; see src/scene/foam.rs

const FOAM_FOLDS = 0u;         // rules of frame.foam_rule: the map; the water's height; the wind's share everywhere
const FOAM_HEIGHT = 1u;

// Rest coordinates about the eye in the foam map's plane, metres.
fn foam_coordinates(p: vec3f) -> vec2f {
    return in_plane(0u, p);
}

// Beyond the map whitecaps lie on the crests: a log-normal share of the height, whose mean is what the wind asks for.
fn share_beyond(height: Metres, footprint: Metres) -> f32 {
    let contrast = 0.8 * (1.0 - smoothstep(0.05, 0.4, footprint / frame.perlin_patch * 5.0));
    let deviations = 4.0 * height / max(frame.wave_height, 1e-3);
    return min(frame.whitecaps * exp(contrast * deviations - 0.5 * contrast * contrast), 1.0);
}

// The map between four texels, in full precision: samplers' weights have eight bits and differ from one driver to the next, which the
// edges of the lace would show. `texels`: from the corner of the eye's texel.
fn foam_between(origin: vec2i, texels: vec2f, level: u32) -> f32 {
    let v = texels - 0.5;
    let cell = origin + vec2i(floor(v));
    let f = v - floor(v);
    let mask = vec2i(FOAM_TEXELS - 1);
    return mix(
        mix(textureLoad(foam_map, cell & mask, 0)[level], textureLoad(foam_map, (cell + vec2i(1, 0)) & mask, 0)[level], f.x),
        mix(textureLoad(foam_map, (cell + vec2i(0, 1)) & mask, 0)[level], textureLoad(foam_map, (cell + vec2i(1, 1)) & mask, 0)[level], f.x), f.y);
}

// Share covered, 0…1, of a rest point with the water at `height`. Each square serves as far as it reaches and while its texels are
// not finer than the footprint; what no square serves has the share that the wind asks for.
fn foam_share(at: vec2f, height: Metres, footprint: Metres) -> f32 {
    if frame.foam_rule == FOAM_HEIGHT {
        return clamp((height - frame.foam_heights.x) / max(frame.foam_heights.y - frame.foam_heights.x, 1e-3), 0.0, 1.0);
    }
    let beyond = share_beyond(height, footprint);
    if frame.foam_rule != FOAM_FOLDS { return beyond; }
    var open = 1.0;
    var share = 0.0;
    for (var level = 0u; level < FOAM_LEVELS; level++) {
        let square = frame.foam_levels[level];
        let reach = max(abs(at.x), abs(at.y)) / (square.side * f32(FOAM_TEXELS / 2));
        let weight = open * (1.0 - smoothstep(0.75, 0.95, reach)) * (1.0 - smoothstep(1.0, 2.5, footprint / square.side));
        if weight <= 0.0 { continue; }
        share += weight * foam_between(square.texel, square.fraction + at / square.side, level);
        open -= weight;
    }
    return share + open * beyond;
}

fn lattice_value(cell: vec2i, salt: u32) -> f32 {
    return f32(hash(vec3u(bitcast<vec2u>(cell), salt)) >> 8u) / 16777216.0;
}

// Value noise, 0…1, fixed to the water, in cells of 2^octave texels of the lace; `texels` from the corner of the eye's.
fn foam_noise(texels: vec2f, octave: i32) -> f32 {
    let origin = frame.lace_texel;
    var corner = origin * (1 << u32(max(-octave, 0)));
    var v = texels * exp2(f32(-octave));
    if octave > 0 {
        let shift = vec2u(u32(octave));
        corner = origin >> shift;
        v += vec2f(origin - (corner << shift)) * exp2(f32(-octave));
    }
    let cell = corner + vec2i(floor(v));
    let f = v - floor(v);
    let u = f * f * (3.0 - 2.0 * f);
    let salt = u32(octave + 8);
    return mix(
        mix(lattice_value(cell, salt), lattice_value(cell + vec2i(1, 0), salt), u.x),
        mix(lattice_value(cell + vec2i(0, 1), salt), lattice_value(cell + vec2i(1, 1), salt), u.x), u.y);
}

// Foam tears into lace and flecks: a share covers the points where a noise lies above it, so that the mean stays the share. The
// noise's cells are a few pixels wide, or as wide as whitecaps are.
fn foam_lace(share: f32, at: vec2f, footprint: Metres) -> f32 {
    let blurred = smoothstep(5.0, 25.0, footprint);
    if share < 0.003 || blurred >= 1.0 { return share; }
    let side = frame.foam_levels[0].side;
    // Flecks are longer across the wind, as crests are.
    let wind = nodes[0].wind;
    let along = vec2f(-wind.x * at.x - wind.y * at.y, 0.5 * (wind.y * at.x - wind.x * at.y));
    let texels = frame.lace_fraction + along / side;
    let scale = clamp(log2(5.0 * footprint / side), 0.0, 6.0);
    let octave = i32(floor(scale));
    let fine = foam_noise(texels, octave - 1);
    let middle = foam_noise(texels, octave);
    let coarse = foam_noise(texels, octave + 1);
    let noise = mix(0.45 * fine + 0.55 * middle, 0.45 * middle + 0.55 * coarse, scale - f32(octave));
    // The sum of two such noises, spread to about uniform again.
    let level = smoothstep(0.15, 0.85, noise);
    // No softer than the share itself: the mean of this over a uniform level is the share.
    let soft = min(0.4, min(share, 1.001 - share));
    return mix(smoothstep(1.0 - share - soft, 1.0 - share + soft, level), share, blurred);
}
