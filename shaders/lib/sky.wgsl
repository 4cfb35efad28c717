// What an eye in the air or above it sees of the sky: the air, the sun's disc, the faint light of the night.
#import light
#import spray

const DISC_RADIANCE = 1.96e4;     // mean over the disc 14,700: a solid angle of 6.8e-5 sr
const MOST = 6.0e4;                // that half floats hold
const MOON_RADIUS = 0.00452;       // radians, in the mean

// The moon's disc, lit from where the sun stands. Its dust sends light back towards the sun: a full moon is as bright at its limb.
fn moon_disc(direction: vec3f) -> vec3f {
    let off = direction - dot(direction, frame.moon) * frame.moon;
    let r = length(off) / MOON_RADIUS;
    if r > 1.2 || dot(direction, frame.moon) < 0.0 { return vec3f(0.0); }
    let blur = max(frame.pixel_angle / MOON_RADIUS, 0.02);
    let normal = off / MOON_RADIUS - sqrt(max(1.0 - r * r, 0.0)) * frame.moon;
    let lit = sqrt(smoothstep(-0.5 * blur, 1.0, dot(normalize(normal), frame.sun)));
    return vec3f(1.06, 1.0, 0.9) * frame.moon_radiance * lit * smoothstep(1.0 + 0.5 * blur, 1.0 - 0.5 * blur, r) * beam_seen(direction);
}

fn sky_light(direction: vec3f) -> vec3f {
    // The disc, 0.267 degrees in radius, darkened towards its limb.
    let away = acos(clamp(dot(direction, frame.light), -1.0, 1.0)) / 0.00465;
    let disc = smoothstep(1.15, 0.85, away) * (1.0 - 0.5 * away * away * step(away, 1.0));
    let above = step(surface_hit(eye_ray(direction)), 0.0);
    var sun = vec3f(0.0);
    // There is no haze of a lens in space: a glare that wide would look like a lamp.
    let most = MOST * mix(1.0, 0.02, smoothstep(1e5, 1e6, frame.eye_altitude));
    if disc * above * frame.by_day > 0.0 { sun = min(disc * above * DISC_RADIANCE * beam_seen(direction), vec3f(most / frame.exposure)); }
    let night = night_sky(direction.z) * exp(-max(frame.eye_altitude, 0.0) / RAYLEIGH_HEIGHT);
    let moon = above * moon_disc(direction);
    let up = vec3f(0.0, 0.0, 1.0);
    let spray = spray_light(daylight_at(frame.light.z), up, direction);
    return mix(spray, sky_seen(direction) + sun + moon + night, exp(-spray_before_sky(direction.z)));
}
