// Up to four mip levels of an array of pictures in one dispatch: the means of two by two texels, all layers at once. A
// workgroup takes 16 by 16 texels down to one; the means stay 32-bit floats on the way. A level that is not wanted is 1 x 1.

@group(0) @binding(0) var finest: texture_2d_array<f32>;
@group(0) @binding(1) var level_1: texture_storage_2d_array<FORMAT, write>;
@group(0) @binding(2) var level_2: texture_storage_2d_array<FORMAT, write>;
@group(0) @binding(3) var level_3: texture_storage_2d_array<FORMAT, write>;
@group(0) @binding(4) var level_4: texture_storage_2d_array<FORMAT, write>;

const SIDE: u32 = 8u;

var<workgroup> means: array<vec4f, 64>;

fn texel(at: vec2u, layer: u32) -> vec4f {
    return textureLoad(finest, min(at, textureDimensions(finest) - 1u), layer, 0);
}

// The mean of four means, `apart` threads from each other. Only threads that nobody else will read write theirs again.
fn mean_of_four(index: u32, apart: u32) -> vec4f {
    return 0.25 * (means[index] + means[index + apart] + means[index + SIDE * apart] + means[index + (SIDE + 1u) * apart]);
}

@compute @workgroup_size(8, 8)
fn halve(
    @builtin(local_invocation_id) local: vec3u,
    @builtin(workgroup_id) group: vec3u,
    @builtin(local_invocation_index) index: u32,
) {
    let at = group.xy * SIDE + local.xy;
    let layer = group.z;
    var mean = 0.25 * (texel(2u * at, layer) + texel(2u * at + vec2u(1u, 0u), layer)
        + texel(2u * at + vec2u(0u, 1u), layer) + texel(2u * at + vec2u(1u, 1u), layer));
    if all(at < textureDimensions(level_1)) { textureStore(level_1, at, layer, mean); }
    means[index] = mean;
    workgroupBarrier();
    if all((local.xy & vec2u(1u)) == vec2u(0u)) {
        mean = mean_of_four(index, 1u);
        if all((at >> vec2u(1u)) < textureDimensions(level_2)) { textureStore(level_2, at >> vec2u(1u), layer, mean); }
        means[index] = mean;
    }
    workgroupBarrier();
    if all((local.xy & vec2u(3u)) == vec2u(0u)) {
        mean = mean_of_four(index, 2u);
        if all((at >> vec2u(2u)) < textureDimensions(level_3)) { textureStore(level_3, at >> vec2u(2u), layer, mean); }
        means[index] = mean;
    }
    workgroupBarrier();
    if index == 0u {
        mean = mean_of_four(index, 4u);
        if all((at >> vec2u(3u)) < textureDimensions(level_4)) { textureStore(level_4, at >> vec2u(3u), layer, mean); }
    }
}
