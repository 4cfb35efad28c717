// Cheap gradient noise for colours; nothing that is measured depends on it.
#import hash

// Where the lattice point's plane rises: one of eight directions, an eighth of a turn apart.
fn plane_rise(cell: vec2u, salt: u32) -> vec2f {
    let eighth = hash(vec3u(cell, salt)) >> 29u;
    let way = select(1.0, -1.0, eighth >= 4u);
    let quarter = select(vec2f(way, 0.0), vec2f(0.0, way), (eighth & 2u) != 0u);
    let slanted = sqrt(0.5) * vec2f(quarter.x - quarter.y, quarter.x + quarter.y);
    return select(quarter, slanted, (eighth & 1u) != 0u);
}

// Height of the lattice point's plane at an offset.
fn plane(cell: vec2u, salt: u32, offset: vec2f) -> f32 { return dot(plane_rise(cell, salt), offset); }

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

// The same noise, its mean none: value, and rise a cell right and down.
fn map_noise_rise(at: vec2u, level: u32, salt: u32) -> vec3f {
    let shift = 32u - level;
    let cell = at >> vec2u(shift);
    let f = vec2f(at & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    let next = (cell + 1u) & vec2u((1u << level) - 1u);
    let a = plane_rise(cell, salt);
    let b = plane_rise(vec2u(next.x, cell.y), salt);
    let c = plane_rise(vec2u(cell.x, next.y), salt);
    let d = plane_rise(next, salt);
    let heights = vec4f(dot(a, f), dot(b, f - vec2f(1.0, 0.0)), dot(c, f - vec2f(0.0, 1.0)), dot(d, f - vec2f(1.0, 1.0)));
    let top = mix(heights.x, heights.y, u.x);
    let bottom = mix(heights.z, heights.w, u.x);
    let across = mix(heights.y - heights.x, heights.w - heights.z, u.y);
    let rise = mix(mix(a, b, u.x), mix(c, d, u.x), u.y) + du * vec2f(across, bottom - top);
    return 0.8 * vec3f(mix(top, bottom, u.y), rise);
}
