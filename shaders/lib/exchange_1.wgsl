// One of the four fields changes threads at a time.

var<workgroup> slots: array<vec2f, LINES * N>;

// A complex number in a slot, to be read by the same thread.
fn keep(at: u32, h: vec2f) { slots[at] = h; }
fn kept(at: u32) -> vec2f { return slots[at]; }

fn exchange(ab: ptr<function, array<vec4f, 8>>, cd: ptr<function, array<vec4f, 8>>, line: u32, at: u32, to: Route) {
#unroll 8    let to_$ = slot(routed(to, $u), line);
#unroll 8    let from_$ = slot(at + $u * SPAN, line);
#unroll 8    slots[to_$] = (*ab)[$].xy;
    workgroupBarrier();
#unroll 8    let a_$ = slots[from_$];
    workgroupBarrier();
#unroll 8    slots[to_$] = (*ab)[$].zw;
    workgroupBarrier();
#unroll 8    (*ab)[$] = vec4f(a_$, slots[from_$]);
    workgroupBarrier();
#unroll 8    slots[to_$] = (*cd)[$].xy;
    workgroupBarrier();
#unroll 8    let c_$ = slots[from_$];
    workgroupBarrier();
#unroll 8    slots[to_$] = (*cd)[$].zw;
    workgroupBarrier();
#unroll 8    (*cd)[$] = vec4f(c_$, slots[from_$]);
    workgroupBarrier();
}
