// Where the mesh of the sea is in each pixel, for sea_of_places.wgsl: triangles are a few pixels wide, and hardware shades whole squares of pixels for each
// of them, so that a pixel would be shaded several times.
#import sea_vertex
#import places

@group(2) @binding(1) var scene_depth: texture_depth_2d;

const MIRRORS_CLOUDS = FINE;

@fragment
fn fragment(in: Vertex) -> Places {
    let found = packed(Patch(in.rest, in.moved, in.height, in.incoming, in.shadow, in.grid, in.ahead, length(dpdx(in.rest)), length(dpdy(in.rest))));
    let axis_distance = dot(in.moved, frame.ray_forward);
    // Triangles far away are chords, whose distance is not the water's: there the shading decides.
    let is_hidden = !waves_are_pixels(length(in.moved)) & (textureLoad(scene_depth, vec2u(in.position.xy), 0) * nearest_bed(axis_distance) > NEAR);
    if is_hidden | (axis_distance < frame.lens) { discard; }
    return found;
}
