// City lights over dark ground.
#import spot
#import spray
#import world

// Radiance of the brightest towns in units of the sun's irradiance beyond the air: a hundred times that of ground under the picture's full
// moon; ten times would be theirs, but pictures of them are exposed for moonless land.
const BRIGHTNESS: f32 = 0.05;
const SHORE: Metres = 300.0;   // how far from the shore all lamps of a town stand
const MOST: f32 = 2.5;         // of a spot, as the display's tone takes it: a near lamp stands for many
const POST: Metres = 15.0;     // how high lamps stand over the ground
const DISC_M: Metres = 5e5;    // above, the earth may be a disc whose depth is not its own; there is nothing to hide a lamp but the limb

// `lamp`: its normal less that of the eye's foot, and its light, 1 for a square metre of the brightest towns; `warm`: from white to orange.
@vertex
fn vertex(@builtin(vertex_index) corner: u32, @location(0) lamp: vec4f, @location(1) warm: f32) -> Spot {
    let dn = lamp.xyz;
    let up = dn + vec3f(0.0, 0.0, 1.0);
    let rest = surface_from_normal_delta(dn);
    let across = max(length(rest) * frame.pixel_angle, 100.0);
    let ground = ground_at(map_point(dn), frame.sin_lat + sin_lat_delta(dn), across);
    let local = rest + up * (max(ground.elevation, 0.0) + POST);
    let distance = max(length(local), 1.0);
    let direction = local / distance;
    let hit = surface_hit(eye_ray(direction));
    let clip = frame.clip_from_local * vec4f(local, 1.0);
    let dry = saturate(-ground.ocean_shore / max(across, SHORE));
    // Behind the horizon, behind the eye, or in the sea.
    if (hit >= 0.0 && hit < 0.98 * distance - 100.0) || clip.w <= 0.0 || dry <= 0.0 { return no_spot(); }
    let colour = mix(vec3f(1.0, 0.86, 0.66), vec3f(1.0, 0.62, 0.27), warm);
    let tilt = 0.25 + 0.75 * max(-dot(direction, up), 0.0);
    let air = haze(direction, distance).transmittance * exp(-spray_depth(direction.z, distance));
    let spread = SPOT * frame.pixel_angle * distance;
    let light = BRIGHTNESS * colour * air * (frame.night * frame.exposure * tilt * dry * lamp.w / (TURN * spread * spread));
    let most = min(MOST / max(max(light.r, max(light.g, light.b)), 1e-9), 1.0);
    return spot_at(clip, select(min(1.02 * clip.z / clip.w, 1.0), 1.0, frame.eye_altitude > DISC_M), most * light, corner);
}
