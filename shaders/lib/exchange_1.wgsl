// One complex field changes threads at a time.

var<workgroup> slots: array<vec2f, LINES * N>;

// A complex number in a slot, to be read by the same thread.
fn keep(at: u32, h: vec2f) { slots[at] = h; }
fn kept(at: u32) -> vec2f { return slots[at]; }

fn exchange(v: ptr<function, array<vec4f, 8>>, half: u32, line: u32, at: u32, to: Route) {
#unroll 8    let to_$ = slot(routed(to, $u), line);
#unroll 8    let from_$ = slot(at + $u * SPAN, line);
#unroll 8    slots[to_$] = (*v)[$].xy;
    workgroupBarrier();
#unroll 8    let first_$ = slots[from_$];
    workgroupBarrier();
#unroll 8    slots[to_$] = (*v)[$].zw;
    workgroupBarrier();
#unroll 8    (*v)[$] = vec4f(first_$, slots[from_$]);
    workgroupBarrier();
}
