// Half of a picture: each texel the mean of four by four around it, so that no point flickers between two texels.
#import full_screen
#import four_taps

@group(0) @binding(0) var whole: texture_2d<f32>;
@group(0) @binding(1) var clamped: sampler;

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let at = corner.device * vec2f(0.5, -0.5) + 0.5;
    return vec4f(four_taps(whole, clamped, at, 1.0 / vec2f(textureDimensions(whole))), 1.0);
}
