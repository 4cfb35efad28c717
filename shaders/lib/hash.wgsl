// One random word per lattice point: PCG3D (M. Jarzynski and M. Olano 2020), one word of it.

fn hash(p: vec3u) -> u32 {
    var v = p * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    return v.x;
}

// A number from 0 to 1 for each pixel, even over neighbours (J. Jimenez 2014, "interleaved gradient noise"): for sums of few steps, which
// would show as bands if they were the same everywhere.
fn spread_evenly(pixel: vec2f) -> f32 { return fract(52.9829189 * fract(dot(pixel, vec2f(0.06711056, 0.00583715)))); }
