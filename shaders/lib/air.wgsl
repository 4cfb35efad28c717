// The air that the eye sees, from the tables of sky_view.wgsl.
#import air_coordinates
#import sunlight

@group(1) @binding(7) var sky_view: texture_2d<f32>;
@group(1) @binding(8) var haze_view: texture_3d<f32>;

struct Air { radiance: vec3f, transmittance: vec3f }

// The ray as it meets the ellipsoid itself, whose air it is, whatever the level of the water.
fn air_ray(direction: vec3f) -> Ray {
    let lift = frame.water_level;
    let column = vec3f(frame.quadric_mixed.yz, frame.quadric_diagonal.z);
    let gradient = frame.quadric_gradient + lift * column;
    return ray_coefficients(direction, gradient, frame.quadric_constant + lift * (frame.quadric_gradient.z + gradient.z));
}

// The air before a surface at `distance` from the eye.
fn haze(direction: vec3f, distance: Metres) -> Air {
    let ray = air_ray(direction);
    let bearing = bearing_of(direction, air_axes());
    let below = bearing.mu < floor_cosine(ray);
    let reach = haze_reach(ray, below);
    if reach.x > reach.y { return Air(vec3f(0.0), vec3f(1.0)); }
    let size = vec3f(textureDimensions(haze_view));
    let slice = unwarped(clamp((distance - reach.x) / (reach.y - reach.x), 0.0, 1.0), frame.air_sink);
    let row = select(row_above(bearing.mu, ray, SUMMIT), row_below(bearing.mu, ray), below);
    let first_above = f32(haze_first_above(u32(size.y)));
    let y = (0.5 + select(first_above + row * (size.y - first_above - 1.0), row * (first_above - 1.0), below)) / size.y;
    let z = (0.5 + slice * (size.z - 1.0)) / size.z;
    // The last two columns hold the transmittance.
    let radiance = textureSampleLevel(haze_view, clamped, vec3f((0.5 + bearing.azimuth * (size.x - 3.0)) / size.x, y, z), 0.0).rgb;
    let transmittance = textureSampleLevel(haze_view, clamped, vec3f((size.x - 1.0) / size.x, y, z), 0.0).rgb;
    return Air(radiance, transmittance);
}

// The air of a ray from the eye past the earth; below the horizon the earth is black.
fn sky_seen(direction: vec3f) -> vec3f {
    let ray = eye_ray(direction);
    let bearing = bearing_of(direction, air_axes());
    if bearing.mu < floor_cosine(ray) { return haze(direction, 1e9).radiance; }
    let place = table_place(vec2f(bearing.azimuth, row_above(bearing.mu, ray, TOP)), textureDimensions(sky_view));
    return textureSampleLevel(sky_view, clamped, place, 0.0).rgb;
}

// What is left of a beam from beyond the air; the earth is not in its way.
fn beam_seen(direction: vec3f) -> vec3f {
    let ray = eye_ray(direction);
    let lowest = -ray.b / ray.a;
    let height = height_along(ray, lowest);
    let inside = frame.eye_altitude < TOP;
    if !inside & ((lowest < 0.0) | (height > TOP)) { return vec3f(1.0); }
    let mu = select(0.0, dot(direction, normalize(frame.quadric_gradient)), inside);
    let way = transmittance(max(select(height, frame.eye_altitude, inside), 0.0), mu);
    // From space as far again behind the lowest point.
    return way * select(way, vec3f(1.0), inside);
}
