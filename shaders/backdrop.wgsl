// The scene where no sea has been drawn over it, texel for texel; where `SMOOTH`, without the stairs that ridges are in it, as sky and land have one
// sample a pixel.
#import full_screen
#import stairs

@group(0) @binding(0) var scene: texture_2d<f32>;
@group(0) @binding(1) var scene_depth: texture_depth_2d;

fn within(at: vec2i) -> vec2i { return clamp(at, vec2i(0), vec2i(textureDimensions(scene_depth)) - 1); }
fn depth_at(at: vec2i) -> f32 { return textureLoad(scene_depth, within(at), 0); }

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    let own = textureLoad(scene, pixel, 0);
    if !SMOOTH { return own; }
    let other = beside(pixel);
    return mix(own, textureLoad(scene, within(pixel + other.out), 0), other.share);
}
