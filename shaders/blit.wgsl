// Copies the finished picture, texel for pixel. The picture fills the window, so both count from the same corner.

@group(0) @binding(0) var picture: texture_2d<f32>;

// One triangle that covers the screen.
@vertex
fn whole_screen(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let corner = vec2f(vec2u((index << 1u) & 2u, index & 2u));
    return vec4f(corner * 2.0 - 1.0, 0.0, 1.0);
}

fn texel(position: vec4f) -> vec3f {
    // While the window changes its size, the picture can be a frame behind.
    let last = vec2i(textureDimensions(picture)) - 1;
    return textureLoad(picture, clamp(vec2i(position.xy), vec2i(0), last), 0).rgb;
}

@fragment
fn copy(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return vec4f(texel(position), 1.0);
}

// For a target that gamma-encodes what it is given: IEC 61966-2-1 backwards.
@fragment
fn copy_decoded(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let encoded = texel(position);
    let low = encoded / 12.92;
    let high = pow((encoded + 0.055) / 1.055, vec3f(2.4));
    return vec4f(select(high, low, encoded <= vec3f(0.04045)), 1.0);
}
