// Stretches the finished picture over the window. Where it has a texel for each pixel, this copies: the filter's weights are then 0 and 1
// but for the rounding of `at`, far less than half a grey level.

@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var smooth_sampler: sampler;

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,    // 0 to 1 from the upper left corner
}

// One triangle that covers the screen.
@vertex
fn whole_screen(@builtin(vertex_index) index: u32) -> Corner {
    let corner = vec2f(vec2u((index << 1u) & 2u, index & 2u));
    return Corner(vec4f(corner * 2.0 - 1.0, 0.0, 1.0), vec2f(corner.x, 1.0 - corner.y));
}

@fragment
fn copy(corner: Corner) -> @location(0) vec4f {
    return vec4f(textureSampleLevel(picture, smooth_sampler, corner.at, 0.0).rgb, 1.0);
}

// For a target that gamma-encodes what it is given: IEC 61966-2-1 backwards.
@fragment
fn copy_decoded(corner: Corner) -> @location(0) vec4f {
    let encoded = textureSampleLevel(picture, smooth_sampler, corner.at, 0.0).rgb;
    let low = encoded / 12.92;
    let high = pow((encoded + 0.055) / 1.055, vec3f(2.4));
    return vec4f(select(high, low, encoded <= vec3f(0.04045)), 1.0);
}
