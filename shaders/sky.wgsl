// The sky behind everything. `MEASURED` is of src/pass/kind.rs.
#import full_screen
#import sky
#import output

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let direction = normalize(frame.ray_forward + corner.device.x * frame.ray_right + corner.device.y * frame.ray_up);
    if MEASURED { return sky_output(); }
    // Land or sea covers the sky; should a pixel of theirs miss, the clear colour stands there.
    let both = SHOWS_LAND | SHOWS_SEA;
    if (frame.layers & both) == both && is_inside_limb(eye_ray(direction)) {
        discard;
        return vec4f(0.0);
    }
    return vec4f(sky_light(direction) * frame.exposure, 1.0);
}
