// What an eye in the air or above it sees of the sky: the air, the sun's disc, the faint light of the night.
#import light
#import spray

const DISC_RADIANCE = 1.96e4;     // mean over the disc 14,700: a solid angle of 6.8e-5 sr
const MOST = 6.0e4;                // that half floats hold

fn sky_light(direction: vec3f) -> vec3f {
    // The disc, 0.267 degrees in radius, darkened towards its limb.
    let away = acos(clamp(dot(direction, frame.sun), -1.0, 1.0)) / 0.00465;
    let disc = smoothstep(1.15, 0.85, away) * (1.0 - 0.5 * away * away * step(away, 1.0));
    let above = step(surface_hit(eye_ray(direction)), 0.0);
    var sun = vec3f(0.0);
    if disc * above > 0.0 { sun = min(disc * above * DISC_RADIANCE * beam_seen(direction), vec3f(MOST / frame.exposure)); }
    let night = NIGHT * exp(-max(frame.eye_altitude, 0.0) / RAYLEIGH_HEIGHT);
    let up = vec3f(0.0, 0.0, 1.0);
    let spray = spray_light(daylight_at(frame.sun.z), up, direction);
    return mix(spray, sky_seen(direction) + sun + night, exp(-spray_before_sky(direction.z)));
}
