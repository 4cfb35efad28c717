// The sea, each of its pixels shaded once: of the places that sea_places.wgsl found.
#import full_screen
#import sea_pixel

@group(2) @binding(2) var places: texture_2d_array<u32>;

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2u(position.xy);
    let found = sea_pixel(unpacked(Places(textureLoad(places, pixel, 0, 0), textureLoad(places, pixel, 1, 0)), pixel), pixel);
    // The backdrop is drawn where the mesh is not.
    return select(textureLoad(scene_colour, pixel, 0), found.colour, found.is_sea);
}
