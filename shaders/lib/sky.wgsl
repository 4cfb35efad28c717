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
    let blur = max(frame.pixel_angle / MOON_RADIUS, 0.02);
    let normal = off / MOON_RADIUS - sqrt(max(1.0 - r * r, 0.0)) * frame.moon;
    let lit = sqrt(smoothstep(-0.5 * blur, 1.0, dot(normalize(normal), frame.sun)));
    let disc = lit * smoothstep(1.0 + 0.5 * blur, 1.0 - 0.5 * blur, r);
    return vec3f(1.06, 1.0, 0.9) * frame.moon_radiance * select(0.0, disc, (r <= 1.2) & (dot(direction, frame.moon) > 0.0));
}

fn sky_light(direction: vec3f) -> vec3f {
    let beam = step(surface_hit(eye_ray(direction)), 0.0) * beam_seen(direction);
    // The disc, 0.267 degrees in radius, darkened towards its limb.
    let away = acos(clamp(dot(direction, frame.light), -1.0, 1.0)) / 0.00465;
    let disc = smoothstep(1.15, 0.85, away) * (1.0 - 0.5 * away * away * step(away, 1.0));
    // There is no haze of a lens in space: a glare that wide would look like a lamp.
    let most = MOST * mix(1.0, 0.02, smoothstep(1e5, 1e6, frame.eye_altitude));
    let sun = min(frame.by_day * disc * DISC_RADIANCE * beam, vec3f(most / frame.exposure));
    let night = night_sky(direction.z) * exp(-max(frame.eye_altitude, 0.0) / RAYLEIGH_HEIGHT);
    let seen = sky_seen(direction) + sun + moon_disc(direction) * beam + night;
    if !SPRAY { return seen; }
    let up = vec3f(0.0, 0.0, 1.0);
    return mix(spray_light(daylight_at(frame.light.z), up, direction), seen, exp(-spray_before_sky(direction.z)));
}
