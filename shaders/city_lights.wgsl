// City lights over dark ground. `FROM_SPACE` is of src/pass/city_lights.rs: ground and what stands on it need not be looked at.
#import spot
#import spray
#import rugged

const SPRAY = true;
const MOST: f32 = 2.5;         // of a spot, as the display's tone takes it: a near lamp stands for many
const POST: Metres = 15.0;     // how high lamps stand over the ground
const SHORE: Metres = 300.0;   // how far from the shore all lamps of a town stand

// `lamp`: its normal less that of the eye's foot, and its light, of the sun's irradiance beyond the air times a square metre; `warm`: from white to orange.
@vertex
fn vertex(@builtin(vertex_index) index: u32, @location(0) lamp: vec4f, @location(1) warm: f32) -> Spot {
    let dn = lamp.xyz;
    let up = dn + vec3f(0.0, 0.0, 1.0);
    let rest = surface_from_normal_delta(dn);
    var local = rest;
    var dry = 1.0;
    if !FROM_SPACE {
        let across = max(length(rest) * frame.pixel_angle, 100.0);
        let point = map_point(dn);
        let sin_lat = frame.sin_lat + sin_lat_delta(dn);
        let ground = ground_at(point, sin_lat, across);
        // As the ground's mesh holds it.
        let made = made_relief(country_at(point, sin_lat), point, dn, sin_lat, ground, max(CELL_PIXELS * across, RELIEF_MESH_FOOTPRINT));
        dry = saturate(-ground.ocean_shore / max(across, SHORE));
        local += up * (max(ground.elevation + made.height, 0.0) + POST);
    }
    let distance = max(length(local), 1.0);
    let direction = local / distance;
    let hit = surface_hit(eye_ray(direction));
    let clip = frame.clip_from_local * vec4f(local, 1.0);
    // Behind the horizon, behind the eye, or in the sea.
    if (hit >= 0.0 && hit < 0.98 * distance - 100.0) || clip.w <= 0.0 || dry <= 0.0 { return no_spot(); }
    let colour = mix(vec3f(1.0, 0.86, 0.66), vec3f(1.0, 0.62, 0.27), warm);
    let tilt = 0.25 + 0.75 * max(-dot(direction, up), 0.0);
    let air = haze(direction, distance).transmittance * exp(-spray_depth(direction.z, distance));
    let spread = SPOT * frame.pixel_angle * distance;
    let light = colour * air * (frame.night * frame.exposure * tilt * dry * lamp.w / (TURN * spread * spread));
    let most = min(MOST / max(max(light.r, max(light.g, light.b)), 1e-9), 1.0);
    // The earth from space is a disc whose depth is not its own; there is nothing to hide a lamp but the limb.
    return spot_at(clip, select(min(1.02 * clip.z / clip.w, 1.0), 1.0, FROM_SPACE), most * light, index);
}
