// From scene radiance to display: AgX, which takes the colour out of what is too bright for a display instead of clipping it
// (T. Sobotka 2022; matrices as given by B. Wrensch 2023, "Minimal AgX implementation"), with a curve of his kind that has the contrast and
// the bright whites of cameras, and half a step of noise, so that no sky has bands.
#import full_screen
#import hash

@group(0) @binding(0) var scene: texture_2d<f32>;
// Elevations of the picture's middle and of its upward direction, where the filter before the sky begins, sines, and the part of light that comes through it.
@group(0) @binding(1) var<uniform> sky_filter: vec4f;

const INSET = mat3x3f(
    0.842479062253094, 0.0423282422610123, 0.0423756549057051,
    0.0784335999999992, 0.878468636469772, 0.0784336,
    0.0792237451477643, 0.0791661274605434, 0.879142973793104);
const OUTSET = mat3x3f(
    1.19687900512017, -0.0528968517574562, -0.0529716355144438,
    -0.0980208811401368, 1.15190312990417, -0.0980434501171241,
    -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
// What the curve tells apart, as powers of two.
const DARKEST = -12.47393;
const BRIGHTEST = 4.026069;
// The curve over the logarithm, 0...1 both: a line through the pivot that bends towards its ends, to 0 by a toe of the fourth power and to 1 by a
// long shoulder, a hyperbola. A grey card is where AgX has it; white clouds and foam are white in photographs.
const PIVOT = vec2f(0.7225, 0.78);
const SLOPE = 2.9;
const TOE = 0.783791;            // (0.78^-4 - (2.9 * 0.7225)^-4)^(-1/4)
const SHOULDER = 0.302770;       // 1 / (1 / 0.22 - 1 / (2.9 * 0.2775))

// Cameras' green sees blue light, too: so much of what blue is more than green. Deep water is no ultramarine in photographs, and the sky azure.
const BLUE_IN_GREEN = 0.13;
// Contrast colour by colour draws colours apart; by so much they come together again.
const SATURATION = 0.96;
const LUMA = vec3f(0.2126, 0.7152, 0.0722);

fn agx_curve(x: vec3f) -> vec3f {
    let rise = SLOPE * (x - PIVOT.x);
    let below = rise / TOE;
    let square = below * below;
    return PIVOT.y + rise * select(inverseSqrt(sqrt(1.0 + square * square)), 1.0 / (1.0 + rise / SHOULDER), rise > vec3f(0.0));
}

// Display values, 0...1, of exposed radiance.
fn displayed(radiance: vec3f) -> vec3f {
    var seen = BALANCE * radiance;
    seen.g += BLUE_IN_GREEN * max(seen.b - seen.g, 0.0);
    let x = (log2(max(INSET * seen, vec3f(1e-10))) - DARKEST) / (BRIGHTEST - DARKEST);
    let toned = OUTSET * max(agx_curve(clamp(x, vec3f(0.0), vec3f(1.0))), vec3f(0.0));
    return clamp(mix(vec3f(dot(toned, LUMA)), toned, SATURATION), vec3f(0.0), vec3f(1.0));
}

// The part of light that comes through the filter at a pixel: `SkyFilter::passed` of `src/scene/frame/sky_filter.rs`.
fn filtered(pixel: vec2f) -> f32 {
    let size = vec2f(textureDimensions(scene));
    let seen = HALF_HEIGHT * (2.0 * pixel - size) / size.y;
    let sine = (sky_filter.x - seen.y * sky_filter.y) * inverseSqrt(1.0 + dot(seen, seen));
    return mix(1.0, sky_filter.w, smoothstep(0.0, FILTER_EDGE, sine - sky_filter.z));
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2u(position.xy);
    let radiance = through_lens(scene, vec2i(pixel));
    let noise = f32(hash(vec3u(pixel, 0u)) >> 8u) / 16777216.0 - 0.5;
    return vec4f(displayed(filtered(position.xy) * radiance) + noise / 255.0, 1.0);
}
