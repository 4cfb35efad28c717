// The tile of foam's lace on the water, turned and in any size, and what bends it; src/model/lace.rs has the reasons.
#import foam
#import hash

@group(1) @binding(11) var lace: texture_2d<f32>;    // level, its slopes per texel, variance that a mip level keeps; see src/model/lace.rs

const LACE_TEXELS: f32 = 512.0;
const LACE_GREATEST_LEVEL: f32 = 3.5;
const LACE_GREATEST_SLOPE: f32 = 1.0;

struct Net {
    level: f32,
    kept: f32,             // variance of the level; 1 where pixels are narrow
    slope: vec2f,          // per metre, along the wind and across it
}

// What the tile's bytes mean.
fn lace_level(found: vec4f) -> f32 { return LACE_GREATEST_LEVEL * (found.x * 255.0 - 128.0) / 127.0; }

// The tile, turned by a whole-numbered vector: `period` texels of the lace (0.25 m) over that vector's length are its sides. Powers of two
// wrap exactly, so that it stays in its place however far the eye goes. `texels`: the way from the corner of the eye's texel.
fn net(turn: vec2i, period: vec2i, texels: vec2f, footprint: Metres) -> Net {
    return net_along(turn, period, texels, vec2f(footprint));
}

// As `net`, of streaks: seen along the wind they stand although pixels are long there. `pixel`: metres along the wind and across it.
fn net_along(turn: vec2i, period: vec2i, texels: vec2f, pixel: vec2f) -> Net {
    return net_blown(turn, period, texels, pixel, vec2f(0.0));
}

// As `net_along`, of what has been blown down the wind by so much of the tile's sides.
fn net_blown(turn: vec2i, period: vec2i, texels: vec2f, pixel: vec2f, blown: vec2f) -> Net {
    let eye = frame.lace_texel;
    let whole = vec2i(turn.x * eye.x - turn.y * eye.y, turn.y * eye.x + turn.x * eye.y) & (period - 1);
    let t = vec2f(turn);
    let way = vec2f(t.x * texels.x - t.y * texels.y, t.y * texels.x + t.x * texels.y);
    // Texels of the tile per metre.
    let scale = LACE_TEXELS * length(t) / (frame.foam_levels[0].side * vec2f(period));
    let lod = max(log2(max(pixel.x * scale.x, pixel.y * scale.y)), 0.0);
    let found = textureSampleLevel(lace, repeated, (vec2f(whole) + way) / vec2f(period) - blown, lod);
    let slope = LACE_GREATEST_SLOPE * (found.yz * 255.0 - 128.0) / 127.0 * scale;
    // Between two mip levels, which are not the same, some more is lost; fitted.
    let between = fract(lod);
    let kept = found.w * (1.0 - 0.4 * between * (1.0 - between) * (1.0 - found.w));
    let unit = t / length(t);
    return Net(lace_level(found), kept, vec2f(unit.x * slope.x + unit.y * slope.y, unit.x * slope.y - unit.y * slope.x));
}

// Two numbers of a square of the water, -1…1.
fn wander_of_square(square: vec2i, size: u32) -> vec2f {
    let bits = hash(vec3u(bitcast<vec2u>(square), size));
    return vec2f(f32(bits & 0xffffu), f32(bits >> 16u)) / 32767.5 - 1.0;
}

// Two smooth numbers, -1…1, which change over squares of 2^size texels. Computed, not looked up: bytes would bend the lace in steps.
fn wander(texels: vec2f, size: u32) -> vec2f { return wander_along(texels, vec2u(size)); }

// As `wander`, over rectangles of 2^size texels along the wind and across it.
fn wander_along(texels: vec2f, size: vec2u) -> vec2f {
    let whole = frame.lace_texel + vec2i(floor(texels));
    let square = whole >> size;
    let side = vec2i(1) << size;
    let f = (vec2f(whole & (side - 1)) + texels - floor(texels)) / vec2f(side);
    let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    return mix(mix(wander_of_square(square, size.x), wander_of_square(square + vec2i(1, 0), size.x), u.x),
        mix(wander_of_square(square + vec2i(0, 1), size.x), wander_of_square(square + vec2i(1, 1), size.x), u.x), u.y);
}
