// Two dispatches make the sea surface of every cascade: rows evolve the spectrum and transform it along x, columns finish
// along y and write eight real fields and the products whose means become roughness. Stockham, radix 4 with one radix-2 stage where log2 N is odd; N is prepended.
// Eight real fields ride in four complex ones: IFFT(A + iB) = a + ib for Hermitian A, B. Formulas: src/model/waves.rs.

struct Evolution {
    ticks: vec2u,              // low and high word of the time in 2^-20 s
    cascade_count: u32,
    unused: u32,
    patches: vec4f,            // metres
}

@group(0) @binding(0) var<uniform> evolution: Evolution;
@group(0) @binding(1) var<storage, read> amplitudes: array<vec2f>;      // h0(k)
@group(0) @binding(2) var<storage, read> frequencies: array<vec2u>;     // cycles per tick, 2^64 = one: low, high
@group(0) @binding(3) var<storage, read> twiddles: array<vec2f>;        // exp(2 pi i n / N), from f64
@group(0) @binding(4) var<storage, read_write> halfway: array<vec4f>;   // two per element
@group(0) @binding(5) var displacements: texture_storage_2d_array<FORMAT, write>;
@group(0) @binding(6) var gradients: texture_storage_2d_array<FORMAT, write>;
@group(0) @binding(7) var moments: texture_storage_2d_array<FORMAT, write>;

const TURN = 6.283185307179586;
const THREADS = N / 4u;

var<workgroup> shared_ab: array<vec4f, N>;
var<workgroup> shared_cd: array<vec4f, N>;

fn times(a: vec2f, b: vec2f) -> vec2f {
    return vec2f(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

fn high_product(a: u32, b: u32) -> u32 {
    let al = a & 0xffffu;
    let ah = a >> 16u;
    let bl = b & 0xffffu;
    let bh = b >> 16u;
    let low = al * bl;
    let mid = ah * bl + (low >> 16u);
    let mid2 = al * bh + (mid & 0xffffu);
    return ah * bh + (mid >> 16u) + (mid2 >> 16u);
}

// Cosine and sine of omega t: the phase is exact to 2^-32 of a turn at any time, the polynomials to 3e-8.
fn rotation(index: u32) -> vec2f {
    let f = frequencies[index];
    let t = evolution.ticks;
    let phase = high_product(f.x, t.x) + f.y * t.x + f.x * t.y;
    // Nearest quarter turn, then |r| <= pi / 4.
    let quarter = (phase + 0x20000000u) >> 30u;
    let r = f32(bitcast<i32>(phase - (quarter << 30u))) * (TURN / 4294967296.0);
    let r2 = r * r;
    let s = r * (1.0 + r2 * (-0.16666667 + r2 * (0.0083333310 + r2 * -0.00019840874)));
    let c = 1.0 + r2 * (-0.5 + r2 * (0.041666666 + r2 * (-0.0013888397 + r2 * 0.0000247609)));
    switch quarter & 3u {
        case 1u: { return vec2f(-s, c); }
        case 2u: { return vec2f(-c, -s); }
        case 3u: { return vec2f(s, -c); }
        default: { return vec2f(c, s); }
    }
}

fn wavenumber(i: u32, patch_length: f32) -> f32 {
    return f32(select(i32(i), i32(i) - i32(N), i >= N / 2u)) * (TURN / patch_length);
}

// Height and dDx/dy ride together; this length brings the gradient to the height's size, so that neither is lost in the
// other's rounding. It stands for 1 / k of the tile's longer waves.
fn gradient_scale(patch_length: f32) -> f32 { return patch_length / (8.0 * TURN); }

// The four packed fields of wave (i, j): (Dx, Dy), (h, dDx/dy), (dh/dx, dh/dy), (dDx/dx, dDy/dy).
struct Packed { ab: vec4f, cd: vec4f }

fn evolved(i: u32, j: u32, cascade: u32) -> Packed {
    let base = cascade * N * N;
    let here = base + j * N + i;
    let mirrored = base + ((N - j) % N) * N + (N - i) % N;
    let turn = rotation(here);
    let forward = times(amplitudes[here], vec2f(turn.x, -turn.y));
    let mirror = amplitudes[mirrored];
    let h = forward + times(vec2f(mirror.x, -mirror.y), turn);
    let patch_length = evolution.patches[cascade];
    let kx = wavenumber(i, patch_length);
    let ky = wavenumber(j, patch_length);
    let k = max(length(vec2f(kx, ky)), 1e-9);
    return Packed(
        vec4f(times(vec2f(-ky, kx) / k, h), times(vec2f(1.0, -kx * ky / k * gradient_scale(patch_length)), h)),
        vec4f(times(vec2f(-ky, kx), h), times(vec2f(-kx * kx, -ky * ky) / k, h)));
}

fn twist(v: vec4f, w: vec2f) -> vec4f {
    return vec4f(times(v.xy, w), times(v.zw, w));
}

// i * v for two complex numbers.
fn quarter_turn(v: vec4f) -> vec4f { return vec4f(-v.y, v.x, -v.w, v.z); }

fn butterfly_4(a: array<vec4f, 4>) -> array<vec4f, 4> {
    let even = a[0] + a[2];
    let odd = a[1] + a[3];
    let even_difference = a[0] - a[2];
    let odd_difference = quarter_turn(a[1] - a[3]);
    return array<vec4f, 4>(even + odd, even_difference + odd_difference, even - odd, even_difference - odd_difference);
}

// Inverse transform of the N elements in workgroup memory, in place, unscaled.
fn transform(thread: u32) {
    var stride = 1u;
    if (countTrailingZeros(N) & 1u) == 1u {
        var ab: array<vec4f, 4>;
        var cd: array<vec4f, 4>;
        for (var r = 0u; r < 4u; r++) {
            ab[r] = shared_ab[thread + r * THREADS];
            cd[r] = shared_cd[thread + r * THREADS];
        }
        workgroupBarrier();
        for (var r = 0u; r < 2u; r++) {
            let to = 2u * (thread + r * THREADS);
            shared_ab[to] = ab[r] + ab[r + 2u];
            shared_ab[to + 1u] = ab[r] - ab[r + 2u];
            shared_cd[to] = cd[r] + cd[r + 2u];
            shared_cd[to + 1u] = cd[r] - cd[r + 2u];
        }
        workgroupBarrier();
        stride = 2u;
    }
    for (; stride < N; stride *= 4u) {
        let phase = thread % stride;
        let step = phase * (N / (stride * 4u));
        var ab: array<vec4f, 4>;
        var cd: array<vec4f, 4>;
        for (var r = 0u; r < 4u; r++) {
            let w = twiddles[r * step];
            ab[r] = twist(shared_ab[thread + r * THREADS], w);
            cd[r] = twist(shared_cd[thread + r * THREADS], w);
        }
        ab = butterfly_4(ab);
        cd = butterfly_4(cd);
        workgroupBarrier();
        let to = (thread / stride) * stride * 4u + phase;
        for (var r = 0u; r < 4u; r++) {
            shared_ab[to + r * stride] = ab[r];
            shared_cd[to + r * stride] = cd[r];
        }
        workgroupBarrier();
    }
}

@compute @workgroup_size(THREADS)
fn rows(@builtin(local_invocation_index) thread: u32, @builtin(workgroup_id) group: vec3u) {
    for (var i = thread; i < N; i += THREADS) {
        let p = evolved(i, group.x, group.y);
        shared_ab[i] = p.ab;
        shared_cd[i] = p.cd;
    }
    workgroupBarrier();
    transform(thread);
    let base = 2u * (group.y * N * N + group.x * N);
    for (var i = thread; i < N; i += THREADS) {
        halfway[base + 2u * i] = shared_ab[i];
        halfway[base + 2u * i + 1u] = shared_cd[i];
    }
}

@compute @workgroup_size(THREADS)
fn columns(@builtin(local_invocation_index) thread: u32, @builtin(workgroup_id) group: vec3u) {
    let base = 2u * (group.y * N * N + group.x);
    for (var j = thread; j < N; j += THREADS) {
        shared_ab[j] = halfway[base + 2u * j * N];
        shared_cd[j] = halfway[base + 2u * j * N + 1u];
    }
    workgroupBarrier();
    transform(thread);
    let unscaled = vec4f(1.0, 1.0, 1.0, 1.0 / gradient_scale(evolution.patches[group.y]));
    for (var j = thread; j < N; j += THREADS) {
        let at = vec2u(group.x, j);
        let displacement = shared_ab[j] * unscaled;
        let gradient = shared_cd[j];
        textureStore(displacements, at, group.y, displacement);
        textureStore(gradients, at, group.y, gradient);
        textureStore(moments, at, group.y, vec4f(gradient.xy * gradient.xy, gradient.x * gradient.y, displacement.w));
    }
}
