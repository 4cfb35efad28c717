// Half of a picture: each texel the mean of four by four around it, so that no point flickers between two texels.
#import full_screen

@group(0) @binding(0) var whole: texture_2d<f32>;
@group(0) @binding(1) var clamped: sampler;

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let at = corner.device * vec2f(0.5, -0.5) + 0.5;
    let step = 1.0 / vec2f(textureDimensions(whole));
    var sum = vec3f(0.0);
    for (var i = 0u; i < 4u; i++) {
        let offset = 2.0 * vec2f(f32(i & 1u), f32(i >> 1u)) - 1.0;
        sum += textureSampleLevel(whole, clamped, at + offset * step, 0.0).rgb;
    }
    return vec4f(0.25 * sum, 1.0);
}
