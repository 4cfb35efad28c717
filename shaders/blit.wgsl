// Stretches the finished picture over the window. Where it has a texel for each pixel, this copies: the filter's weights are then 0 and 1
// but for the rounding of `at`, far less than half a grey level. src/app/blit.rs says TARGET_ENCODES: whether the target gamma-encodes
// what it is given.
#import full_screen

@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var smooth_sampler: sampler;

// IEC 61966-2-1 backwards.
fn linear_from_srgb(encoded: vec3f) -> vec3f {
    let low = encoded / 12.92;
    let high = pow((encoded + 0.055) / 1.055, vec3f(2.4));
    return select(high, low, encoded <= vec3f(0.04045));
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let at = corner.device * vec2f(0.5, -0.5) + 0.5;
    let encoded = textureSampleLevel(picture, smooth_sampler, at, 0.0).rgb;
    if TARGET_ENCODES { return vec4f(linear_from_srgb(encoded), 1.0); }
    return vec4f(encoded, 1.0);
}
