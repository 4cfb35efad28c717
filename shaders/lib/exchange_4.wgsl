// All four fields change threads at once.

var<workgroup> slots: array<vec4f, 2 * LINES * N>;

// A complex number in a slot, to be read by the same thread.
fn keep(at: u32, h: vec2f) { slots[at] = vec4f(h, 0.0, 0.0); }
fn kept(at: u32) -> vec2f { return slots[at].xy; }

fn exchange(ab: ptr<function, array<vec4f, 8>>, cd: ptr<function, array<vec4f, 8>>, line: u32, at: u32, to: Route) {
#unroll 8    let to_$ = slot(routed(to, $u), line);
#unroll 8    slots[to_$] = (*ab)[$];
#unroll 8    slots[to_$ + LINES * N] = (*cd)[$];
    workgroupBarrier();
#unroll 8    let from_$ = slot(at + $u * SPAN, line);
#unroll 8    (*ab)[$] = slots[from_$];
#unroll 8    (*cd)[$] = slots[from_$ + LINES * N];
    workgroupBarrier();
}
