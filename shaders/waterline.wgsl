// The waterline: what the picture from below covers of the one from above, and the water that climbs up the glass. Each pixel looks through
// its own place of a lens `frame.lens` before the eye: what lies under the water there shows the picture from below.
#import waves
#import world
#import held
#import light

@group(2) @binding(0) var below: texture_2d<f32>;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) over: f32,            // metres of the lens above the water, straight up
}

const MENISCUS: f32 = 0.008;           // how high the water climbs, in heights of the picture; ours

@vertex
fn vertex(@location(0) grid: vec2f) -> Vertex {
    let place = frame.lens * (frame.ray_forward + grid.x * frame.ray_right + grid.y * frame.ray_up);
    let dn = normal_delta(vec3f(place.xy, -frame.eye_altitude));
    let held = held_share(-ground_at(map_point(dn), frame.sin_lat + sin_lat_delta(dn), 20.0).elevation);
    // The water that stands there has been moved there by the chop.
    var rest = place.xy;
    var height = 0.0;
    for (var i = 0; i < 4; i++) {
        let moved = held * displacement_at(vec3f(rest, -frame.eye_altitude), length(rest), 0.01);
        rest = place.xy - moved.xy;
        height = moved.z;
    }
    return Vertex(vec4f(grid, 0.5, 1.0), place.z + frame.eye_altitude - height);
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    let rise = vec2f(dpdx(in.over), dpdy(in.over));
    let pixels = in.over / max(length(rise), 1e-6);
    let climbed = pixels / max(MENISCUS * frame.viewport.y, 2.0);
    let wet = saturate(0.5 - pixels);
    let size = vec2f(textureDimensions(below));
    // Within the meniscus the water below is seen once more, upside down and dim.
    let down = -rise / max(length(rise), 1e-6);
    let inside = max(climbed, 0.0);
    let seen = in.position.xy + down * select(0.0, 2.0 * pixels + 4.0, pixels > 0.0);
    let water = textureLoad(below, vec2u(clamp(seen, vec2f(0.0), size - 1.0)), 0).rgb;
    let dark = (1.0 - wet) * (1.0 - smoothstep(0.55, 1.0, inside));
    let light = daylight_at(frame.light.z);
    let day = (light.sun * max(frame.light.z, 0.0) + light.sky) / PI * frame.exposure;
    let bright = 0.10 * (1.0 - wet) * smoothstep(0.45, 0.8, inside) * (1.0 - smoothstep(0.8, 1.15, inside));
    return vec4f(water * (wet + 0.45 * dark) + bright * day, wet + 0.85 * dark);
}
