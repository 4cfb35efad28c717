// The scene where no sea has been drawn over it, texel for texel; where `SMOOTH`, without the stairs that ridges are in it, as sky and land have one
// sample a pixel. What lies behind the sea has no air before it: no eye may see it beside a ridge.
#import full_screen
#import scene
#import stairs

@group(0) @binding(0) var scene: texture_2d<f32>;
@group(0) @binding(1) var scene_depth: texture_depth_2d;

fn within(at: vec2i) -> vec2i { return clamp(at, vec2i(0), vec2i(textureDimensions(scene_depth)) - 1); }
fn depth_at(at: vec2i) -> f32 { return textureLoad(scene_depth, within(at), 0); }

fn scene_at(at: vec2i) -> vec4f { return textureLoad(scene, within(at), 0); }

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(position.xy);
    var own = scene_at(pixel);
    if !SMOOTH { return own; }
    // Where the sea leaves a part of such a pixel, that shows what stands over it, if that is for eyes.
    if is_behind_sea(own) {
        let above = scene_at(pixel - vec2i(0, 1));
        own = select(above, own, is_behind_sea(above));
    }
    let beside_it = beside(pixel);
    let other = scene_at(pixel + beside_it.out);
    return mix(own, other, select(beside_it.share, 0.0, is_behind_sea(other)));
}
