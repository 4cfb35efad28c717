// A level of the glow: its own picture, and the next coarser level's glow.
#import full_screen
#import four_taps

@group(0) @binding(0) var own: texture_2d<f32>;
@group(0) @binding(1) var coarser: texture_2d<f32>;
@group(0) @binding(2) var clamped: sampler;

const WIDER = 0.6;     // share of the coarser levels: light falls off with the cube of the angle, about as in an eye and a lens

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let at = corner.device * vec2f(0.5, -0.5) + 0.5;
    let around = four_taps(coarser, clamped, at, 0.5 / vec2f(textureDimensions(coarser)));
    return vec4f(mix(textureLoad(own, vec2u(corner.position.xy), 0).rgb, around, WIDER), 1.0);
}
