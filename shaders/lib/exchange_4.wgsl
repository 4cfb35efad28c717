// All four fields change threads at once.

var<workgroup> slots: array<vec4f, 2 * LINES * N>;

fn exchange(ab: ptr<function, array<vec4f, 8>>, cd: ptr<function, array<vec4f, 8>>, line: u32, at: u32, start: u32, step: u32, jump: u32) {
#unroll 8    let to_$ = slot(start + $u * step + ($u / FIRST) * jump, line);
#unroll 8    slots[to_$] = (*ab)[$];
#unroll 8    slots[to_$ + LINES * N] = (*cd)[$];
    workgroupBarrier();
#unroll 8    let from_$ = slot(at + $u * SPAN, line);
#unroll 8    (*ab)[$] = slots[from_$];
#unroll 8    (*cd)[$] = slots[from_$ + LINES * N];
    workgroupBarrier();
}
