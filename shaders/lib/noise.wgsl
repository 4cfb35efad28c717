// Cheap value noise for colours; nothing that is measured depends on it.

fn hash_word(p: vec3u) -> f32 {
    var v = p * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    return f32(v.x >> 8u) / 16777216.0;
}

// Smooth noise in [0, 1] over fixed-point map coordinates: cells of 2^(32 - level) units.
fn map_noise(at: vec2u, level: u32, salt: u32) -> f32 {
    let shift = 32u - level;
    let cell = at >> vec2u(shift);
    let f = vec2f(at & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    let u = f * f * (3.0 - 2.0 * f);
    let mask = (1u << level) - 1u;
    let next = (cell + 1u) & vec2u(mask);
    let a = hash_word(vec3u(cell, salt));
    let b = hash_word(vec3u(next.x, cell.y, salt));
    let c = hash_word(vec3u(cell.x, next.y, salt));
    let d = hash_word(vec3u(next, salt));
    return mix(mix(a, b, u.x), mix(c, d, u.x), u.y);
}
