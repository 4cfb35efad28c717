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
