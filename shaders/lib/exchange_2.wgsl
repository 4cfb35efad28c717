// Two complex fields change threads at a time; two halves take the same slots.

var<workgroup> slots: array<vec4f, LINES * N>;

// A complex number in a slot, to be read by the same thread.
fn keep(at: u32, h: vec2f) { slots[at] = vec4f(h, 0.0, 0.0); }
fn kept(at: u32) -> vec2f { return slots[at].xy; }

fn exchange(v: ptr<function, array<vec4f, 8>>, half: u32, line: u32, at: u32, to: Route) {
#unroll 8    slots[slot(routed(to, $u), line)] = (*v)[$];
    workgroupBarrier();
#unroll 8    (*v)[$] = slots[slot(at + $u * SPAN, line)];
    workgroupBarrier();
}
