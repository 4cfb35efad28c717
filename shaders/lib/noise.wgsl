// Cheap gradient noise for colours; nothing that is measured depends on it.
#import hash

// Slope of the lattice point's plane along an offset: one of eight directions, an eighth of a turn apart.
fn plane(cell: vec2u, salt: u32, offset: vec2f) -> f32 {
    let eighth = hash(vec3u(cell, salt)) >> 29u;
    let way = select(1.0, -1.0, eighth >= 4u);
    let quarter = select(vec2f(way, 0.0), vec2f(0.0, way), (eighth & 2u) != 0u);
    let slanted = sqrt(0.5) * vec2f(quarter.x - quarter.y, quarter.x + quarter.y);
    return dot(select(quarter, slanted, (eighth & 1u) != 0u), offset);
}

// Smooth gradient noise, about 0…1, over fixed-point map coordinates: cells of 2^(32 - level) units.
fn map_noise(at: vec2u, level: u32, salt: u32) -> f32 {
    let shift = 32u - level;
    let cell = at >> vec2u(shift);
    let f = vec2f(at & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let mask = (1u << level) - 1u;
    let next = (cell + 1u) & vec2u(mask);
    let a = plane(cell, salt, f);
    let b = plane(vec2u(next.x, cell.y), salt, f - vec2f(1.0, 0.0));
    let c = plane(vec2u(cell.x, next.y), salt, f - vec2f(0.0, 1.0));
    let d = plane(next, salt, f - vec2f(1.0, 1.0));
    return clamp(0.5 + 0.8 * mix(mix(a, b, u.x), mix(c, d, u.x), u.y), 0.0, 1.0);
}
