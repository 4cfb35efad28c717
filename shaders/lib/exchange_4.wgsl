// Two of four complex fields change threads at a time, the two halves in slots of their own: when one half's barrier is passed, the
// other's slots have been read. One half alone would overwrite what is still to be read.

const_assert HALVES == 2u;

var<workgroup> slots: array<vec4f, 2 * LINES * N>;

// A complex number in a slot, to be read by the same thread.
fn keep(at: u32, h: vec2f) { slots[at] = vec4f(h, 0.0, 0.0); }
fn kept(at: u32) -> vec2f { return slots[at].xy; }

fn exchange(v: ptr<function, array<vec4f, 8>>, half: u32, line: u32, at: u32, to: Route) {
    let base = half * LINES * N;
#unroll 8    slots[base + slot(routed(to, $u), line)] = (*v)[$];
    workgroupBarrier();
#unroll 8    (*v)[$] = slots[base + slot(at + $u * SPAN, line)];
}
