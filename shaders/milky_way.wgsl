// The Milky Way over a dark sky: soft spots, each as wide as they lie apart.
#import light
#import spot

// Of its brightest parts, as the display's tone takes it, whatever the exposure; between the stars of magnitude 6 it is just seen.
const BRIGHTNESS: f32 = 0.03;
const SPREAD = 0.024;          // standard deviation of a spot, radians
// In the middle of so many spots their sum is this of one.
const OVERLAP = 4.7;
// A sky so bright, as the display's tone takes it, hides e-fold of it: of a moonlit one nothing is left.
const HIDING: f32 = 0.02;

// `part`: direction and brightness.
@vertex
fn vertex(@builtin(vertex_index) index: u32, @location(0) part: vec4f, @location(1) unused: f32) -> Spot {
    let direction = part.xyz;
    let clip = frame.clip_from_local * vec4f(direction, 0.0);
    let sky = dot(sky_seen(direction) + night_sky(direction.z), vec3f(0.2126, 0.7152, 0.0722)) * frame.exposure / HIDING;
    // Beside a sunlit earth an eye is not used to the dark.
    let adapted = 1.0 - 0.6 * smoothstep(1e5, 1e6, frame.eye_altitude);
    let light = adapted * BRIGHTNESS / OVERLAP * part.w * exp(-sky * sky) * vec3f(0.92, 0.97, 1.1) * beam_seen(direction);
    if clip.w <= 0.05 || light.g < 1e-6 { return no_spot(); }
    // A picture's edges are farther from the eye than its middle, and so wider there.
    return wide_spot_at(clip, SPREAD / frame.pixel_angle / clip.w, light, index);
}
