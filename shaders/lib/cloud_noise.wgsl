// Gradient noise in space.
#import hash

const CLOUD_NOISE_DEVIATION = 0.191;

// What the gradient of a lattice point adds at an offset from it.
fn cloud_gradient(cell: vec3i, salt: u32, offset: vec3f) -> f32 {
    let word = hash(bitcast<vec3u>(cell) + vec3u(salt * 0x9e3779b9u, 0u, salt));
    let gradient = vec3f(vec3u(word >> 22u, (word >> 12u) & 1023u, (word >> 2u) & 1023u)) / 511.5 - 1.0;
    return dot(gradient, offset);
}

// Of mean 0 and, over space, of variance 1; cells of length 1.
fn cloud_noise(p: vec3f, salt: u32) -> f32 {
    let low = floor(p);
    let cell = vec3i(low);
    let f = p - low;
    let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let bottom = mix(
        mix(cloud_gradient(cell, salt, f), cloud_gradient(cell + vec3i(1, 0, 0), salt, f - vec3f(1.0, 0.0, 0.0)), u.x),
        mix(cloud_gradient(cell + vec3i(0, 1, 0), salt, f - vec3f(0.0, 1.0, 0.0)), cloud_gradient(cell + vec3i(1, 1, 0), salt, f - vec3f(1.0, 1.0, 0.0)), u.x),
        u.y);
    let top = mix(
        mix(cloud_gradient(cell + vec3i(0, 0, 1), salt, f - vec3f(0.0, 0.0, 1.0)), cloud_gradient(cell + vec3i(1, 0, 1), salt, f - vec3f(1.0, 0.0, 1.0)), u.x),
        mix(cloud_gradient(cell + vec3i(0, 1, 1), salt, f - vec3f(0.0, 1.0, 1.0)), cloud_gradient(cell + vec3i(1, 1, 1), salt, f - vec3f(1.0, 1.0, 1.0)), u.x),
        u.y);
    return mix(bottom, top, u.z) / CLOUD_NOISE_DEVIATION;
}
