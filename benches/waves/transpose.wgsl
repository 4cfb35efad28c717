// A peer: radix 2 in workgroup memory, inputs in bit-reversed order, then an explicit transpose; twice. Prepended: N, BITS.

@group(0) @binding(0) var<storage, read> twiddles: array<vec2f>;
@group(0) @binding(1) var<storage, read> source: array<vec2f>;
@group(0) @binding(2) var<storage, read_write> result: array<vec2f>;

const TILE: u32 = 16u;

var<workgroup> line: array<vec2f, N>;
var<workgroup> tile: array<vec2f, 272>;

fn butterfly(thread: u32, half: u32) {
    let phase = thread % half;
    let i = (thread / half) * half * 2u + phase;
    let w = twiddles[phase * (N / (2u * half))];
    let a = line[i];
    let b = line[i + half];
    let turned = vec2f(b.x * w.x - b.y * w.y, b.x * w.y + b.y * w.x);
    line[i] = a + turned;
    line[i + half] = a - turned;
}

@compute @workgroup_size(N / 2u)
fn rows(@builtin(local_invocation_index) thread: u32, @builtin(workgroup_id) group: vec3u) {
    let base = (group.y * N + group.x) * N;
    for (var i = thread; i < N; i += N / 2u) {
        line[reverseBits(i) >> (32u - BITS)] = source[base + i];
    }
    workgroupBarrier();
    for (var half = 1u; half < N; half *= 2u) {
        butterfly(thread, half);
        workgroupBarrier();
    }
    for (var i = thread; i < N; i += N / 2u) { result[base + i] = line[i]; }
}

@compute @workgroup_size(TILE, TILE)
fn transpose(@builtin(local_invocation_id) local: vec3u, @builtin(workgroup_id) group: vec3u) {
    let base = group.z * N * N;
    let corner = group.xy * TILE;
    tile[local.y * (TILE + 1u) + local.x] = source[base + (corner.y + local.y) * N + corner.x + local.x];
    workgroupBarrier();
    result[base + (corner.x + local.y) * N + corner.y + local.x] = tile[local.x * (TILE + 1u) + local.y];
}
