// One mip level of an array of pictures: the mean of two by two texels, all layers at once.

@group(0) @binding(0) var finer: texture_2d_array<f32>;
@group(0) @binding(1) var coarser: texture_storage_2d_array<FORMAT, write>;

@compute @workgroup_size(8, 8)
fn halve(@builtin(global_invocation_id) id: vec3u) {
    if any(id.xy >= textureDimensions(coarser)) { return; }
    let at = id.xy * 2u;
    let sum = textureLoad(finer, at, id.z, 0) + textureLoad(finer, at + vec2u(1u, 0u), id.z, 0)
        + textureLoad(finer, at + vec2u(0u, 1u), id.z, 0) + textureLoad(finer, at + vec2u(1u, 1u), id.z, 0);
    textureStore(coarser, id.xy, id.z, 0.25 * sum);
}
