// Unscaled inverse transforms of LINES times N elements by one workgroup: Stockham, eight elements per thread in registers,
// radix 8 after one first stage of radix 8, 4 or 2, so that inputs and outputs of thread `at` are at + r * SPAN.
// a and b hold two complex numbers in each vec4f: four transforms run side by side, or the two of a alone where HALVES is 1.

const SPAN: u32 = N / 8u;               // threads of a line
const THREADS: u32 = SPAN * LINES;

fn times(a: vec2f, b: vec2f) -> vec2f {
    return vec2f(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

fn twist(v: vec4f, w: vec2f) -> vec4f {
    return vec4f(times(v.xy, w), times(v.zw, w));
}

// i * v for two complex numbers.
fn quarter_turn(v: vec4f) -> vec4f { return vec4f(-v.y, v.x, -v.w, v.z); }

struct Four { a: vec4f, b: vec4f, c: vec4f, d: vec4f }

fn butterfly_4(a: vec4f, b: vec4f, c: vec4f, d: vec4f) -> Four {
    let even = a + c;
    let odd = b + d;
    let even_difference = a - c;
    let odd_difference = quarter_turn(b - d);
    return Four(even + odd, even_difference + odd_difference, even - odd, even_difference - odd_difference);
}

fn butterfly_8(v: array<vec4f, 8>) -> array<vec4f, 8> {
    let even = butterfly_4(v[0], v[2], v[4], v[6]);
    let odd = butterfly_4(v[1], v[3], v[5], v[7]);
    let b = twist(odd.b, vec2f(0.70710678118, 0.70710678118));
    let c = quarter_turn(odd.c);
    let d = twist(odd.d, vec2f(-0.70710678118, 0.70710678118));
    return array<vec4f, 8>(
        even.a + odd.a, even.b + b, even.c + c, even.d + d, even.a - odd.a, even.b - b, even.c - c, even.d - d);
}

// Stage of stride 1, without twiddles: the outputs of a butterfly stand side by side.
fn first_stage(v: array<vec4f, 8>) -> array<vec4f, 8> {
    if FIRST == 8u { return butterfly_8(v); }
    if FIRST == 4u {
        let p = butterfly_4(v[0], v[2], v[4], v[6]);
        let q = butterfly_4(v[1], v[3], v[5], v[7]);
        return array<vec4f, 8>(p.a, p.b, p.c, p.d, q.a, q.b, q.c, q.d);
    }
    return array<vec4f, 8>(
        v[0] + v[4], v[0] - v[4], v[1] + v[5], v[1] - v[5], v[2] + v[6], v[2] - v[6], v[3] + v[7], v[3] - v[7]);
}

fn stage(v: array<vec4f, 8>, w: array<vec2f, 8>) -> array<vec4f, 8> {
    return butterfly_8(array<vec4f, 8>(
        v[0], twist(v[1], w[1]), twist(v[2], w[2]), twist(v[3], w[3]),
        twist(v[4], w[4]), twist(v[5], w[5]), twist(v[6], w[6]), twist(v[7], w[7])));
}

// Where outputs go: output r of the last stage to start + r * step + (r / FIRST) * jump. A first stage of radix 4 or 2 has
// several butterflies per thread, and theirs stand FIRST * SPAN elements apart.
struct Route { start: u32, step: u32, jump: u32 }

fn routed(to: Route, r: u32) -> u32 { return to.start + r * to.step + (r / FIRST) * to.jump; }

// What has been done gives way to the other half, if there is one.
fn take_turns(a: ptr<function, array<vec4f, 8>>, b: ptr<function, array<vec4f, 8>>, done: array<vec4f, 8>) {
    if HALVES == 2u {
        *a = *b;
        *b = done;
    } else {
        *a = done;
    }
}

// The two halves take turns in the same code, which is long enough for slow compilers.
fn inverse(a: ptr<function, array<vec4f, 8>>, b: ptr<function, array<vec4f, 8>>, line: u32, at: u32) {
    for (var half = 0u; half < HALVES; half++) {
        take_turns(a, b, first_stage(*a));
    }
    var to = Route(FIRST * at, 1u, FIRST * (SPAN - 1u));
    for (var stride = FIRST; stride < N; stride *= 8u) {
        let phase = at % stride;
        let turn = phase * (SPAN / stride);
        let w1 = twiddles[turn];
        let w2 = twiddles[2u * turn];
        let w4 = twiddles[4u * turn];
        let w3 = times(w1, w2);
        let w = array<vec2f, 8>(vec2f(1.0, 0.0), w1, w2, w3, w4, times(w1, w4), times(w2, w4), times(w3, w4));
        for (var half = 0u; half < HALVES; half++) {
            exchange(a, half, line, at, to);
            take_turns(a, b, stage(*a, w));
        }
        to = Route((at / stride) * stride * 8u + phase, stride, 0u);
    }
}

// The slot of element i. Plain order would send the eighth outputs of neighbouring threads to the same bank.
fn slot(i: u32, line: u32) -> u32 {
    return line * N + (i ^ ((i >> 3u) & 15u) ^ ((6u * line) & 7u));
}
