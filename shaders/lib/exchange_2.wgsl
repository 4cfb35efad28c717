// Two of the four fields change threads at a time.

var<workgroup> slots: array<vec4f, LINES * N>;

fn exchange(ab: ptr<function, array<vec4f, 8>>, cd: ptr<function, array<vec4f, 8>>, line: u32, at: u32, start: u32, step: u32, jump: u32) {
#unroll 8    let to_$ = slot(start + $u * step + ($u / FIRST) * jump, line);
#unroll 8    let from_$ = slot(at + $u * SPAN, line);
#unroll 8    slots[to_$] = (*ab)[$];
    workgroupBarrier();
#unroll 8    (*ab)[$] = slots[from_$];
    workgroupBarrier();
#unroll 8    slots[to_$] = (*cd)[$];
    workgroupBarrier();
#unroll 8    (*cd)[$] = slots[from_$];
    workgroupBarrier();
}
