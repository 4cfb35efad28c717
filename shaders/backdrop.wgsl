// The scene where no sea has been drawn over it, texel for texel.
#import full_screen

@group(0) @binding(0) var scene: texture_2d<f32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return textureLoad(scene, vec2u(position.xy), 0);
}
