// Tables of skylight at sea level, made once: radiance by view and sun, and the irradiance of level ground.
#import scattering

@group(1) @binding(0) var transmittances: texture_2d<f32>;
@group(1) @binding(1) var multiples: texture_2d<f32>;
@group(2) @binding(0) var radiance: texture_storage_3d<rgba16float, write>;
@group(2) @binding(1) var irradiance: texture_storage_2d<rgba16float, write>;

// Radiance from zenith cosine mu, `azimuth` from the sun at zenith cosine mu_sun, for an observer at sea level. On a sphere, so that
// the tables do not depend on where the eye was when they were made.
fn sky(mu: f32, azimuth: f32, mu_sun: f32) -> vec3f {
    let curvature = 0.5 / frame.semi_major;
    let flat = sqrt(max(1.0 - mu * mu, 0.0));
    let direction = vec3f(flat * cos(azimuth), flat * sin(azimuth), mu);
    let sun = vec3f(sqrt(max(1.0 - mu_sun * mu_sun, 0.0)), 0.0, mu_sun);
    let ray = Ray(curvature, 0.5 * mu, 0.0);
    let shell = shell_hits(ray, TOP);
    let sight = sight_along(ray, direction, vec3f(0.0, 0.0, 0.5), curvature * direction, sun);
    return scatter(sight, 0.0, shell.y, 32u, 0.0).radiance;
}

@compute @workgroup_size(4, 4, 4)
fn radiances(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(radiance);
    if any(id >= size) { return; }
    let x = vec3f(id) / vec3f(size - 1u);
    let value = sky(view_from_coordinate(x.x), x.y * PI, sun_from_coordinate(x.z));
    textureStore(radiance, id, vec4f(value, 1.0));
}

@compute @workgroup_size(64)
fn irradiances(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(irradiance).x;
    if id.x >= size { return; }
    let mu_sun = sun_from_coordinate(f32(id.x) / f32(size - 1u));
    // Midpoints of equal steps of mu^2 / 2 and of azimuth: each direction has the same share of the projected hemisphere.
    var sum = vec3f(0.0);
    for (var i = 0u; i < 8u; i++) {
        for (var j = 0u; j < 8u; j++) {
            sum += sky(sqrt((f32(i) + 0.5) / 8.0), (f32(j) + 0.5) / 8.0 * PI, mu_sun);
        }
    }
    textureStore(irradiance, vec2u(id.x, 0u), vec4f(sum * PI / 64.0, 1.0));
}
