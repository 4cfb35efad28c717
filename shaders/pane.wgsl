// One colour over all of the viewport; see src/app/pane.rs, which says COLOUR: as the target takes it, multiplied by its alpha.

@vertex
fn whole_viewport(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(vec2u((index << 1u) & 2u, index & 2u)) * 2.0 - 1.0, 0.0, 1.0);
}

@fragment
fn fill() -> @location(0) vec4f { return COLOUR; }
