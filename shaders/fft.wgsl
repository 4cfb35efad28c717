// Two dispatches make the sea surface of every cascade: rows evolve the spectrum and transform it along x, columns finish
// along y and write eight real fields and the products whose means become roughness. Eight real fields ride in four complex
// ones: IFFT(A + iB) = a + ib for Hermitian A, B. Formulas: src/model/waves.rs; the transform: shaders/lib/stockham.wgsl.
// Foam's past needs the stretches alone: they ride in two complex ones, which are transformed without the others where it is made.
// Prepended: N, LINES (rows or columns of a workgroup), FIRST (radix of the first stage), HALF (16-bit floats in between), HALVES (of
// the fields that are transformed: 2, or 1 for the stretches).

struct Evolution {
    ticks: vec2u,              // low and high word of the time in 2^-20 s
    depth: f32,                // of the water, metres
    sharpened: u32,            // 1: heights and displacements make up for linear interpolation
    patches: vec4f,            // metres
    scales: array<vec4f, 8>,   // two per cascade, in the order of the textures: bring each field to about unit size halfway
}

@group(0) @binding(0) var<uniform> evolution: Evolution;
@group(0) @binding(1) var<storage, read> amplitudes: array<vec2f>;      // h0(k)
@group(0) @binding(2) var<storage, read> frequencies: array<vec2u>;     // cycles per tick, 2^64 = one: low, high
@group(0) @binding(3) var<storage, read> twiddles: array<vec2f>;        // exp(2 pi i n / N), from f64
@group(0) @binding(4) var<storage, read_write> halfway: array<vec4u>;   // one per element, two of 32-bit floats
@group(0) @binding(5) var displacements: texture_storage_2d_array<FORMAT, write>;
@group(0) @binding(6) var slopes: texture_storage_2d_array<FORMAT, write>;
@group(0) @binding(7) var stretches: texture_storage_2d_array<FORMAT, write>;

#import exchange_FIELDS
#import stockham

const TURN: f32 = 6.283185307179586;

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
fn rotation(f: vec2u) -> vec2f {
    let t = evolution.ticks;
    let phase = high_product(f.x, t.x) + f.y * t.x + f.x * t.y;
    // Nearest quarter turn, then |r| <= pi / 4.
    let quarter = (phase + 0x20000000u) >> 30u;
    let r = f32(bitcast<i32>(phase - (quarter << 30u))) * (TURN / 4294967296.0);
    let r2 = r * r;
    let s = r * (1.0 + r2 * (-0.16666667 + r2 * (0.0083333310 + r2 * -0.00019840874)));
    let c = 1.0 + r2 * (-0.5 + r2 * (0.041666666 + r2 * (-0.0013888397 + r2 * 0.0000247609)));
    let swapped = select(vec2f(c, s), vec2f(s, c), (quarter & 1u) == 1u);
    let negative = vec2<bool>(((quarter + 1u) & 2u) != 0u, (quarter & 2u) != 0u);
    return select(swapped, -swapped, negative);
}

// H(k, t) of wave (i, j).
fn evolved(i: u32, j: u32, base: u32) -> vec2f {
    let here = base + j * N + i;
    let mirrored = base + ((N - j) % N) * N + (N - i) % N;
    let turn = rotation(frequencies[here]);
    let mirror = amplitudes[mirrored];
    return times(amplitudes[here], vec2f(turn.x, -turn.y)) + times(vec2f(mirror.x, -mirror.y), turn);
}

fn wavenumber(i: u32) -> f32 {
    return f32(select(i32(i), i32(i) - i32(N), i >= N / 2u));
}

// What linear interpolation between samples takes from the mean square of a wave, as a factor; see src/model/surface.rs.
fn gain(i: u32) -> f32 {
    return select(1.0, inverseSqrt((2.0 + twiddles[i].x) / 3.0), evolution.sharpened == 1u);
}

// The way of a wave of wave vector k, as long as its orbit at the surface is over its height: coth kh.
fn along(k: vec2f) -> vec2f {
    let size = max(length(k), 1e-9);
    return k / (size * tanh(clamp(size * evolution.depth, 1e-6, 15.0)));
}

@compute @workgroup_size(THREADS)
fn rows(@builtin(local_invocation_index) thread: u32, @builtin(workgroup_id) group: vec3u) {
    let line = thread / SPAN;
    let at = thread % SPAN;
    let row = group.x * LINES + line;
    let base = group.y * N * N;
    let dk = TURN / evolution.patches[group.y];
    let ky = wavenumber(row) * dk;
    let row_gain = gain(row);
    let d = evolution.scales[2u * group.y];
    let g = evolution.scales[2u * group.y + 1u];
    var a: array<vec4f, 8>;    // (h, dDx/dy), (dDx/dx, dDy/dy)
    var b: array<vec4f, 8>;    // (Dx, Dy), (dh/dx, dh/dy)
    // Rolled up, since it is most of the code: drivers that take seconds for long shaders see two of eight. Two, so that the
    // loads of one hide behind those of the other. Each thread reads back the slots that it has written itself.
    for (var i = at; i < N; i += 2u * SPAN) {
        let near = evolved(i, row, base);
        let far = evolved(i + SPAN, row, base);
        keep(slot(i, line), near);
        keep(slot(i + SPAN, line), far);
    }
#unroll 8    let h_$ = kept(slot(at + $u * SPAN, line));
    workgroupBarrier();
#unroll 8    let kx_$ = wavenumber(at + $u * SPAN) * dk;
#unroll 8    let u_$ = along(vec2f(kx_$, ky));
    // The second of a pair is multiplied by i.
#unroll 8    let s_$ = row_gain * gain(at + $u * SPAN);
#unroll 8    a[$] = vec4f(times(vec2f(d.z * s_$, -d.w * kx_$ * u_$.y), h_$), times(vec2f(-g.z * kx_$ * u_$.x, -g.w * ky * u_$.y), h_$));
    if HALVES == 2u {
#unroll 8        b[$] = vec4f(times(vec2f(-d.y * u_$.y, d.x * u_$.x) * s_$, h_$), times(vec2f(-g.y * ky, g.x * kx_$), h_$));
    }
    inverse(&a, &b, line, at);
    let to = base + row * N + at;
    if HALF {
#unroll 8        halfway[to + $u * SPAN] = packed(a[$], b[$]);
    } else {
#unroll 8        halfway[2u * (to + $u * SPAN)] = bitcast<vec4u>(a[$]);
#unroll 8        halfway[2u * (to + $u * SPAN) + 1u] = bitcast<vec4u>(b[$]);
    }
}

fn packed(a: vec4f, b: vec4f) -> vec4u {
    return vec4u(pack2x16float(a.xy), pack2x16float(a.zw), pack2x16float(b.xy), pack2x16float(b.zw));
}

fn unpacked(a: u32, b: u32) -> vec4f { return vec4f(unpack2x16float(a), unpack2x16float(b)); }

fn put(at: vec2u, cascade: u32, a: vec4f, b: vec4f) {
    textureStore(stretches, at, cascade, vec4f(a.zw, a.y, 0.0));
    if HALVES == 2u {
        textureStore(displacements, at, cascade, vec4f(b.xy, a.x, 0.0));
        textureStore(slopes, at, cascade, vec4f(b.zw, b.zw * b.zw));
    }
}

@compute @workgroup_size(THREADS)
fn columns(@builtin(local_invocation_index) thread: u32, @builtin(workgroup_id) group: vec3u) {
    // Neighbouring threads take neighbouring columns: their elements lie side by side.
    let line = thread % LINES;
    let at = thread / LINES;
    let column = group.x * LINES + line;
    let start = group.y * N * N + column;
    var a: array<vec4f, 8>;
    var b: array<vec4f, 8>;
    if HALF {
#unroll 8        let e_$ = halfway[start + (at + $u * SPAN) * N];
#unroll 8        a[$] = unpacked(e_$.x, e_$.y);
#unroll 8        b[$] = unpacked(e_$.z, e_$.w);
    } else {
#unroll 8        a[$] = bitcast<vec4f>(halfway[2u * (start + (at + $u * SPAN) * N)]);
#unroll 8        b[$] = bitcast<vec4f>(halfway[2u * (start + (at + $u * SPAN) * N) + 1u]);
    }
    inverse(&a, &b, line, at);
    let d = 1.0 / evolution.scales[2u * group.y];
    let g = 1.0 / evolution.scales[2u * group.y + 1u];
#unroll 8    put(vec2u(column, at + $u * SPAN), group.y, a[$] * vec4f(d.zw, g.zw), b[$] * vec4f(d.xy, g.xy));
}
