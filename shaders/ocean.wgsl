// The sea: a grid even on the screen, cast onto the ellipsoid from the eye, or, where crests may stand higher than the eye,
// from a projector raised above the highest; moved by the waves along the
// ellipsoid's normal, shaded over what the land pass left. The water class decides what is sea, never the depth buffer.
#import world
#import foam
#import water
#import output

@group(2) @binding(0) var scene_colour: texture_2d<f32>;
@group(2) @binding(1) var scene_depth: texture_depth_2d;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) rest: vec3f,          // on the ellipsoid
    @location(1) moved: vec3f,
    @location(2) height: f32,
}

// Whether the waves at a distance are smaller than a quarter of a pixel, so that the ellipsoid is the surface.
fn waves_are_pixels(distance: Metres) -> bool {
    return distance * frame.pixel_angle > 4.0 * frame.crest_height;
}

// The ellipsoid's point under a device coordinate, cast from the projector; see the head of this file.
fn projected(device: vec2f) -> vec3f {
    var direction = normalize(frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up);
    // The surface over an eye under water lies where the mirrored eye above it looks.
    if frame.under_water == 1u { direction.z = -abs(direction.z); }
    let ray = ray_coefficients(direction, frame.projector_gradient, frame.projector_constant);
    let rise = vec3f(0.0, 0.0, frame.projector_rise);
    var t = surface_hit(ray);
    if t >= 0.0 { return direction * t + rise; }
    // The ray misses. Far off, its closest approach: the fragments decide by their own rays where the limb is.
    t = max(-ray.b / ray.a, 0.0);
    if waves_are_pixels(t) {
        // A few cells beyond the limb are enough.
        let p = direction * t + rise;
        let beyond = height_along(ray, t) - 16.0 * t * frame.pixel_angle;
        return p - max(beyond, 0.0) * (normal_delta(p) + vec3f(0.0, 0.0, 1.0));
    }
    // Near, the point of the horizon below the ray, so that no triangle spans the sea.
    let tangent = sqrt(max(ray.c, 0.0) / ray.a);
    let dip = sqrt(max(ray.a * ray.c, 0.0)) / frame.projector_gradient.z;
    return tangent * vec3f(direction.xy / max(length(direction.xy), 1e-6), -dip) + rise;
}

const EDGE = 1.02;             // the even part of the grid reaches this far, in device units
const SIDE_RIM = 0.06;         // share of the grid beyond each side edge
const NEAREST: Metres = 0.7;

// Rest position of a grid vertex. Among high waves the chop moves water into the screen from beside and behind the eye, so
// the grid's rims run on from the screen's edges: up and sideways, and below the eye to behind it, denser towards the eye.
fn rest_position(grid: vec2f) -> vec3f {
    let reach = frame.rim_reach;
    let low_rim = select(0.02, 0.35, reach > 0.0);
    let y = 0.5 * (grid.y + 1.0);
    let below = clamp(1.0 - y / low_rim, 0.0, 1.0);
    let beside = sign(grid.x) * clamp((abs(grid.x) - 1.0 + SIDE_RIM) / SIDE_RIM, 0.0, 1.0);
    let device = vec2f(clamp(grid.x / (1.0 - SIDE_RIM), -1.0, 1.0) * EDGE, mix(-EDGE, EDGE + 0.03, max(y - low_rim, 0.0) / (1.0 - low_rim)));
    let rest = projected(device);
    if reach == 0.0 { return rest; }
    let right = normalize(frame.ray_right.xy);
    let ahead = vec2f(-right.y, right.x);
    let above = clamp((y - 1.0 + SIDE_RIM) / SIDE_RIM, 0.0, 1.0);
    let moved = rest + vec3f((right * beside + ahead * above) * reach, 0.0);
    if below == 0.0 { return moved; }
    let from_distance = dot(rest.xy, ahead);
    var distance = from_distance - below * reach;
    if from_distance > NEAREST {
        let nearing = min(below / 0.8, 1.0);
        distance = from_distance * pow(NEAREST / from_distance, nearing) - max(below - 0.8, 0.0) / 0.2 * reach;
    }
    let aside = dot(rest.xy, right) * clamp(distance / max(from_distance, NEAREST), 0.02, 1.0) + reach * (beside + grid.x * below);
    return vec3f(ahead * distance + right * aside, -frame.eye_altitude);
}

@vertex
fn vertex(@location(0) grid: vec2f) -> Vertex {
    let rest = rest_position(grid);
    let up = normal_delta(rest) + vec3f(0.0, 0.0, 1.0);
    let distance = length(rest);
    let spacing = distance * frame.pixel_angle * 4.0 / sqrt(max(abs(dot(rest, up)) / max(distance, 1e-3), 0.03));
    var moved = vec3f(0.0);
    if frame.wave_height > 0.0 && !waves_are_pixels(distance) {
        let displacement = displacement_at(rest, distance, spacing);
        let point = map_point(up - vec3f(0.0, 0.0, 1.0));
        let ground = ground_at(point, frame.sin_lat + sin_lat_delta(up - vec3f(0.0, 0.0, 1.0)), max(spacing, 20.0));
        // Shallow water holds no higher waves: Hs <= 0.5 h (surface of random waves, see physics notes in ARCHITECTURE.md).
        let allowed = clamp(-ground.elevation * 0.5 / frame.wave_height, 0.0, 1.0);
        moved = allowed * displacement;
    }
    let local = rest + moved.x * vec3f(1.0, 0.0, 0.0) + moved.y * vec3f(0.0, 1.0, 0.0) + moved.z * up;
    return Vertex(frame.clip_from_local * vec4f(local, 1.0), rest, local, moved.z);
}

// Unit vector along the wind, which blows from the same bearing everywhere.
fn along_wind(up: vec3f) -> vec3f {
    let east = cross(vec3f(0.0, frame.cos_lat, frame.sin_lat), up);
    let wind = frame.wind.x * east + frame.wind.y * cross(up, east);
    return normalize(wind + 1e-6 * vec3f(1.0, 0.0, 0.0));
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    var distance = length(in.moved);
    let direction = in.moved / max(distance, 1e-3);
    // Far away the exact hit of the pixel's own ray replaces the chord of its triangle.
    var rest = in.rest;
    var moved = in.moved;
    if waves_are_pixels(distance) {
        distance = surface_hit(eye_ray(direction));
        if distance < 0.0 {
            discard;
            return vec4f(0.0);
        }
        rest = direction * distance;
        moved = rest;
    }
    let dn = normal_delta(rest);
    let up = dn + vec3f(0.0, 0.0, 1.0);
    let sin_lat = frame.sin_lat + sin_lat_delta(dn);
    let grazing = max(abs(dot(direction, up)), 0.002);
    let across = distance * frame.pixel_angle;
    let footprint = across / sqrt(grazing);
    let ground = ground_at(map_point(dn), sin_lat, max(across, 1.0));
    if !ground.is_ocean {
        discard;
        return vec4f(0.0);
    }

    // Land in front of the water hides it; the bed just under it does not.
    let pixel = vec2u(in.position.xy);
    let land_depth = textureLoad(scene_depth, pixel, 0);
    let axis_distance = dot(moved, frame.ray_forward);
    let behind = textureLoad(scene_colour, pixel, 0).rgb;
    // 0.4 % of the distance and 2 m cover the chords of the land's triangles; depth = NEAR / distance.
    if land_depth * (axis_distance * 0.996 - 2.0) > NEAR {
        discard;
        return vec4f(0.0);
    }

    let depth = -ground.elevation;
    let alpha = water_alpha(depth);
    let slopes = slopes_at(rest, distance, footprint);
    let calmed = clamp(depth * 0.5 / max(frame.wave_height, 1e-3), 0.0, 1.0);
    let slope = slopes.slope * calmed;
    let normal = normalize(up + vec3f(-slope.x, -slope.y, 0.0));
    if frame.under_water == 1u {
        let seen = through_water(window_radiance(direction, normal, up), distance);
        return measured_output(Measured(rest, distance, depth, alpha, in.height, normal, 1.0, mix_weights(distance).y), seen);
    }
    let foam_at = foam_coordinates(rest);
    let foam = calmed * foam_lace(foam_share(foam_at, in.height, footprint), foam_at, footprint);
    let water = water_radiance(WaterPoint(-direction, up, normal, along_wind(up), slopes.rough, alpha, depth,
        behind / max(frame.exposure, 1e-9), foam));
    let air = scatter_to_surface(direction, distance);
    let radiance = water * air.transmittance + air.radiance;
    return measured_output(Measured(rest, distance, depth, alpha, in.height, normal, 1.0, mix_weights(distance).y), radiance);
}
