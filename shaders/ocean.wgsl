// The sea: a grid even on the screen, cast onto the ellipsoid from above the highest crest, moved by the waves along the
// ellipsoid's normal, shaded over what the land pass left. The water class decides what is sea, never the depth buffer.
#import world
#import waves
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

// Grid coordinate in [-1, 1] to device coordinate: the inner part is even on the screen, the rim reaches out to the margin.
fn stretched(x: f32) -> f32 {
    let inner = 0.86;
    let reach = frame.projector_margin;
    if abs(x) <= inner { return x / inner * 1.02; }
    let rim = (abs(x) - inner) / (1.0 - inner);
    return sign(x) * 1.02 * pow(max(reach / 1.02, 1.0), rim);
}

// Whether the waves at a distance are smaller than a quarter of a pixel, so that the ellipsoid is the surface.
fn waves_are_pixels(distance: Metres) -> bool {
    return distance * frame.pixel_angle > 4.0 * frame.crest_height;
}

@vertex
fn vertex(@location(0) grid: vec2f) -> Vertex {
    let device = vec2f(stretched(grid.x), stretched(grid.y));
    let direction = normalize(frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up);
    let ray = ray_coefficients(direction, frame.projector_gradient, frame.projector_constant);
    var t = surface_hit(ray);
    let rise = vec3f(0.0, 0.0, frame.projector_rise);
    var rest = direction * t + rise;
    if t < 0.0 {
        // The ray misses. Far off, its closest approach: the fragments decide by their own rays where the limb is. Near,
        // the point of the ellipsoid under it, for the waves to rise from.
        t = max(-ray.b / ray.a, 0.0);
        rest = direction * t + rise;
        if !waves_are_pixels(t) { rest -= (normal_delta(rest) + vec3f(0.0, 0.0, 1.0)) * height_along(ray, t); }
    }
    let up = normal_delta(rest) + vec3f(0.0, 0.0, 1.0);
    let distance = length(rest);
    let spacing = distance * frame.pixel_angle * 4.0 / sqrt(max(abs(dot(rest, up)) / max(distance, 1e-3), 0.03));
    var moved = vec3f(0.0);
    if frame.wave_height > 0.0 {
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

// Bubbles and gaps in a whitecap: fine wave slopes of the shortest tile, as a pattern that moves with the water.
fn foam_texture(rest: vec3f, footprint: Metres) -> f32 {
    let c = frame.cascade_count - 1u;
    let local = vec2f(dot(rest, nodes[0].axis_x), dot(rest, nodes[0].axis_y)) + tile_start(0u, c);
    let length = frame.patches[c];
    let lod = mip_for(footprint, length, f32(textureDimensions(gradients).x));
    let fine = textureSampleLevel(gradients, repeated, local * 0.73 / length, c, lod).zw
        + textureSampleLevel(gradients, repeated, local.yx * 1.9 / length, c, lod + 1.0).wz;
    let spread = sqrt(max(mean_square_slope_above(6.2831853 / length), 1e-4));
    return 0.72 + 0.28 * clamp((fine.x + fine.y) / spread, -2.0, 1.0);
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
        if distance < 0.0 { discard; }
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
    if !ground.is_ocean { discard; }

    // Land in front of the water hides it; the bed just under it does not.
    let pixel = vec2u(in.position.xy);
    let land_depth = textureLoad(scene_depth, pixel, 0);
    let axis_distance = dot(moved, frame.ray_forward);
    let behind = textureLoad(scene_colour, pixel, 0).rgb;
    // 0.4 % of the distance and 2 m cover the chords of the land's triangles; depth = NEAR / distance.
    if land_depth * (axis_distance * 0.996 - 2.0) > NEAR { discard; }

    let depth = -ground.elevation;
    let alpha = water_alpha(depth);
    let slopes = slopes_at(rest, distance, footprint);
    let calmed = clamp(depth * 0.5 / max(frame.wave_height, 1e-3), 0.0, 1.0);
    let slope = slopes.slope * calmed;
    let normal = normalize(up + vec3f(-slope.x, -slope.y, 0.0));
    // Crests fold where the chop's divergence, which has the variance of the resolved slopes, passes the quantile that the
    // whitecap fraction asks for; beyond what pixels hold, the fraction itself.
    let resolved = sqrt(max(mean_square_slope_above(0.0) - slopes.unresolved, 1e-6)) * frame.chop;
    let threshold = 1.0 - frame.foam_quantile * resolved;
    let folded = smoothstep(threshold + 0.35 * resolved, threshold - 0.7 * resolved, slopes.fold);
    let near_foam = folded * foam_texture(rest, footprint);
    let foam = frame.foam * calmed * mix(near_foam, frame.whitecaps, smoothstep(1.5, 25.0, footprint));
    let water = water_radiance(WaterPoint(-direction, up, normal, max(slopes.unresolved, 1e-5), alpha, depth,
        behind / max(frame.exposure, 1e-9), foam));
    let air = scatter_to(direction, distance, 10u);
    let radiance = water * air.transmittance + air.radiance;
    return measured_output(Measured(rest, distance, depth, alpha, in.height, normal, 1.0, mix_weights(distance).y), radiance);
}
