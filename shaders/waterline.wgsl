// The waterline: what the picture from below covers of the one from above, and the water that climbs up the glass. Each pixel looks through
// its own place of a lens `frame.lens` before the eye: what lies under the water there shows the picture from below.
#import waves
#import world
#import held

@group(2) @binding(0) var below: texture_2d<f32>;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) over: f32,            // metres of the lens above the water, straight up
}

const MENISCUS: f32 = 0.011;           // how high the water climbs, in heights of the picture; ours

@vertex
fn vertex(@location(0) grid: vec2f) -> Vertex {
    let place = frame.lens * (frame.ray_forward + grid.x * frame.ray_right + grid.y * frame.ray_up);
    let dn = normal_delta(vec3f(place.xy, -frame.eye_altitude));
    let sea = local_sea(map_point(dn));
    let held = held_share(-ground_at(map_point(dn), frame.sin_lat + sin_lat_delta(dn), 20.0).elevation, sea.height);
    // The water that stands there has been moved there by the chop.
    var rest = place.xy;
    var height = 0.0;
    for (var i = 0; i < 4; i++) {
        let moved = held * displacement_in(sea, vec3f(rest, -frame.eye_altitude), length(rest), 0.01);
        rest = place.xy - moved.xy;
        height = moved.z;
    }
    return Vertex(vec4f(grid, 0.5, 1.0), place.z + frame.eye_altitude - height);
}

// How high the water stands on the glass here, of its usual height: it wets it in places and runs off in others.
fn standing(x: f32) -> f32 {
    let slow = sin(5.3 * x + 1.1) + sin(11.9 * x - 0.7);
    let quick = sin(29.0 * x + 2.0 * slow) + sin(67.0 * x - 3.0 * slow);
    return max(0.75 + 0.22 * slow + 0.10 * quick, 0.2);
}

// The picture from below, as blurred as by the drop that it is seen through.
fn through_drop(at: vec2f, along: vec2f) -> vec3f {
    let last = vec2f(textureDimensions(below)) - 1.0;
    var sum = vec3f(0.0);
    for (var i = 0; i < 4; i++) {
        sum += textureLoad(below, vec2u(clamp(at + (f32(i) - 1.5) * along, vec2f(0.0), last)), 0).rgb;
    }
    return 0.25 * sum;
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    let rise = vec2f(dpdx(in.over), dpdy(in.over));
    let pixels = in.over / max(length(rise), 1e-6);
    let tall = max(MENISCUS * frame.viewport.y, 2.0) * standing(in.position.x / frame.viewport.y);
    let climbed = pixels / tall;
    let wet = saturate(0.5 - pixels);
    // Within the meniscus the water below is seen once more, upside down, drawn out and dim.
    let down = -rise / max(length(rise), 1e-6);
    let inside = max(climbed, 0.0);
    let seen = in.position.xy + down * select(0.0, 5.0 * pixels + 4.0, pixels > 0.0);
    let water = through_drop(seen, down * select(0.0, 2.0, pixels > 0.0));
    let film = (1.0 - wet) * (1.0 - smoothstep(0.3, 1.0, inside));
    // Just below the line the glass is wet by a wedge of water that turns the sight: the surface's own dark side is seen in it.
    let wedge = 1.0 - 0.45 * exp(-2.5 * max(-climbed, 0.0));
    return vec4f(water * (wet * wedge + 0.42 * film), wet + 0.9 * film);
}
