// Stars over a dark sky.
#import light
#import spot

// Of a star of magnitude 0, as the display's tone takes it, whatever the exposure: those of magnitude 6 are just seen on black.
const BRIGHTNESS: f32 = 6.0;
// A sky so bright, as the display's tone takes it, hides e-fold of a star.
const HIDING: f32 = 0.08;

// Linear colour of a star by its colour index B-V: blue-white, white, orange.
fn star_colour(index: f32) -> vec3f {
    let warm = clamp(index, -0.4, 2.0);
    return vec3f(1.0 + 0.25 * warm, 1.0, 1.15 - 0.35 * warm);
}

// `star`: direction and magnitude.
@vertex
fn vertex(@builtin(vertex_index) index: u32, @location(0) star: vec4f, @location(1) colour_index: f32) -> Spot {
    let direction = star.xyz;
    let clip = frame.clip_from_local * vec4f(direction, 0.0);
    let sky = dot(sky_seen(direction) + night_sky(direction.z), vec3f(0.2126, 0.7152, 0.0722)) * frame.exposure / HIDING;
    // Beside a sunlit earth an eye is not used to the dark.
    let adapted = 1.0 - 0.7 * smoothstep(5e4, 3e5, frame.eye_altitude) * smoothstep(-0.45, -0.1, frame.light.z);
    let light = adapted * BRIGHTNESS * exp2(-1.3288 * star.w) * exp(-sky * sky) * star_colour(colour_index) * beam_seen(direction);
    // Behind the earth, behind the eye, or not to be seen.
    if surface_hit(eye_ray(direction)) >= 0.0 || clip.w <= 0.0 || light.g < 0.001 { return no_spot(); }
    return spot_at(clip, 0.0, light, index);
}
