// One triangle over the whole target.

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) device: vec2f,    // -1 to 1, right and up
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let device = vec2f(vec2u((index << 1u) & 2u, index & 2u)) * 2.0 - 1.0;
    return Corner(vec4f(device, 0.0, 1.0), device);
}
