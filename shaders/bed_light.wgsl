// Light that waves gather on the bed, as an eye over the water sees it: laid over the scene before the sea is, by whose surface it is seen. How much
// brighter a pixel of the bed is than under a flat surface, which src/pass/bed_light.rs multiplies it by; alpha keeps it, for the sea to know the bed's
// reflectance. `FINE` and `CLOUDS` are of src/pass/kind.rs.
#import full_screen
#import under_water

@group(2) @binding(0) var scene_depth: texture_depth_2d;
@group(2) @binding(1) var caustics: texture_2d<f32>;

const MIRRORS_CLOUDS = FINE;
const LIT_DOWN_TO: Metres = 15.0;    // below which nothing is seen of it
const LIT_FROM: Metres = 0.05;

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let direction = normalize(frame.ray_forward + corner.device.x * frame.ray_right + corner.device.y * frame.ray_up);
    let depth_along_axis = NEAR / max(textureLoad(scene_depth, vec2u(corner.position.xy), 0), 1e-10);
    let place = direction * (depth_along_axis / max(dot(direction, frame.ray_forward), 1e-3));
    let below = -frame.eye_altitude - place.z;
    var light = vec3f(1.0);
    if below > 0.0 && length(place.xy) < caustic_reach() {
        let dn = normal_delta(place);
        let ground = ground_at(map_point(dn), frame.sin_lat + sin_lat_delta(dn), 1.0);
        let depth = -ground.elevation;
        if ground.is_ocean && depth > LIT_FROM && depth < LIT_DOWN_TO {
            var daylight = daylight_at(frame.light.z);
            if CLOUDS { daylight = clouded_daylight_at_eye(daylight); }
            let w = underwater(daylight);
            // What has been scattered on its way shows no wave.
            let sharp = exp(-w.haze * depth / w.to_sun.z) * smoothstep(LIT_FROM, 0.4, depth) * smoothstep(LIT_DOWN_TO, 0.6 * LIT_DOWN_TO, depth);
            let of_sun = daylight.disc * w.sun / max(w.sun + w.sky, vec3f(1e-9));
            light = mix(vec3f(1.0), vec3f(bed_caustic(w, caustics, place.xy, depth)), sharp * caustics_seen() * of_sun);
        }
    }
    return vec4f(light, dot(light, LUMINANCE));
}
