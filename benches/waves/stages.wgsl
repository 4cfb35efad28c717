// A peer: the transform as one dispatch per butterfly stage and axis, one complex field at a time, from texture to texture,
// one output per thread. Radix 2, Stockham order. Prepended: N.

struct Stage { stride: u32, axis: u32, unused_a: u32, unused_b: u32 }

@group(0) @binding(0) var<uniform> stage: Stage;
@group(0) @binding(1) var<storage, read> twiddles: array<vec2f>;
@group(0) @binding(2) var source: texture_2d<f32>;
@group(0) @binding(3) var result: texture_storage_2d<rg32float, write>;

fn element(i: u32, across: u32) -> vec2f {
    return textureLoad(source, select(vec2u(i, across), vec2u(across, i), stage.axis == 1u), 0).xy;
}

@compute @workgroup_size(16, 16)
fn butterfly(@builtin(global_invocation_id) id: vec3u) {
    let output = select(id.x, id.y, stage.axis == 1u);
    let across = select(id.y, id.x, stage.axis == 1u);
    let phase = output % stage.stride;
    let upper = (output / stage.stride) % 2u;
    let i = (output / (2u * stage.stride)) * stage.stride + phase;
    let w = twiddles[phase * (N / (2u * stage.stride))];
    let a = element(i, across);
    let b = element(i + N / 2u, across);
    let turned = vec2f(b.x * w.x - b.y * w.y, b.x * w.y + b.y * w.x);
    textureStore(result, id.xy, vec4f(select(a + turned, a - turned, upper == 1u), 0.0, 1.0));
}
