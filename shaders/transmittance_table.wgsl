// The transmittance of the air towards its top, for any eye and sun: what stands along the ray, summed. The table is drawn anew when the haze
// changes, not with every picture.
#import atmosphere

@group(1) @binding(0) var transmittance_table: texture_storage_2d<rgba16float, write>;

// Steps on either side of a ray's lowest point. They grow away from it, as there the air is densest; against eighty times as many the
// columns of air, aerosol and ozone are within 0.6 %.
const STEPS = 48;

// What a beam loses over `length` along a ray from a point at `low`, which rises there by `slope` (the sine of its angle above the horizontal, 0 or
// more): the optical depth.
fn depth_upward(low: Metres, slope: f32, length: Metres) -> vec3f {
    let r = frame.semi_major + low;
    var depth = vec3f(0.0);
    for (var i = 0; i < STEPS; i++) {
        let u = (f32(i) + 0.5) / f32(STEPS);
        let x = length * u * u;
        let rise = x * (2.0 * r * slope + x);
        let h = low + rise / (sqrt(r * r + rise) + r);
        depth += medium_at(max(h, 0.0)).extinction * (2.0 * u);
    }
    return depth * length / f32(STEPS);
}

@compute @workgroup_size(8, 8)
fn transmittances(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(transmittance_table);
    if any(id.xy >= size) { return; }
    let view = transmittance_view(vec2f(id.xy) / vec2f(size - 1u));
    let r = frame.semi_major + view.x;
    let level = TOP * (2.0 * frame.semi_major + TOP);
    let horizon2 = view.x * (2.0 * frame.semi_major + view.x);
    let along = r * view.y;                                // from the ray's lowest point to the eye; below zero if it is still ahead
    let whole = sqrt(max(along * along + level - horizon2, 0.0));
    var depth = vec3f(0.0);
    if along >= 0.0 {
        depth = depth_upward(view.x, view.y, whole - along);
    } else {
        let low = view.x - along * along / (r + sqrt(max(r * r - along * along, 0.0)));
        depth = depth_upward(low, 0.0, whole) + depth_upward(low, 0.0, -along);
    }
    textureStore(transmittance_table, id.xy, vec4f(exp(-depth), 1.0));
}
