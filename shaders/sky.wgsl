// The sky behind everything: the atmosphere seen from any height, the sun's disc, the faint light of the night. `MEASURED` and `UNDER_WATER` are of
// src/pass/kind.rs.
#import full_screen
#import water
#import output

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let direction = normalize(frame.ray_forward + corner.device.x * frame.ray_right + corner.device.y * frame.ray_up);
    if MEASURED { return sky_output(); }
    if UNDER_WATER { return vec4f(water_veil() * frame.exposure, 1.0); }
    // Land or sea covers the sky; should a pixel of theirs miss, the clear colour stands there.
    let both = SHOWS_LAND | SHOWS_SEA;
    if (frame.layers & both) == both && is_inside_limb(eye_ray(direction)) {
        discard;
        return vec4f(0.0);
    }
    // The disc, 0.267 degrees in radius, darkened towards its limb.
    let away = acos(clamp(dot(direction, frame.sun), -1.0, 1.0)) / 0.00465;
    let disc = smoothstep(1.15, 0.85, away) * (1.0 - 0.5 * away * away * step(away, 1.0));
    let above = step(surface_hit(eye_ray(direction)), 0.0);
    var sun = vec3f(0.0);
    if disc * above > 0.0 { sun = min(disc * above * 6.0e4, 6.0e4) * beam_seen(direction) * 0.005; }
    let night = NIGHT * exp(-max(frame.eye_altitude, 0.0) / RAYLEIGH_HEIGHT);
    return vec4f((sky_seen(direction) + sun + night) * frame.exposure, 1.0);
}
