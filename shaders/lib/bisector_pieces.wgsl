// The triangles that take the place of others: halves, quarters, and the whole that a diamond becomes again.
#import bisectors

fn is_first_half(t: Triangle) -> bool {
    let base = parents(t.apex);
    return base.exists && (all(t.right == base.first) || all(t.right == base.second));
}

// A diamond is the four triangles around the middle M of an old base, when none of them is split: this one, its sibling, and theirs.
struct Diamond { slots: vec4u, exists: bool }

fn diamond_of(slot: u32, t: Triangle) -> Diamond {
    let depth = depth_of(slot);
    let sibling = link(slot, LEFT);
    let second = link(slot, RIGHT);
    let first = link(second, RIGHT);
    let slots = vec4u(slot, sibling, first, second);
    var exists = depth > 0u;
    for (var i = 1u; i < 4u; i++) { exists = exists && depth_of(slots[i]) == depth && all(corner_at(9u * slots[i]) == t.apex); }
    return Diamond(slots, exists && first != slot && link(first, RIGHT) == sibling);
}

// The slot that has an edge of `slot`, or a half of it, after this update.
fn owner(slot: u32, edge: u32, half: u32) -> u32 {
    let command = command_of(slot);
    let own = pieces[slot];
    if command == 0u { return slot; }
    if (command & MERGE) != 0u { return own.x; }
    let halved = ((command >> edge) & 1u) == 1u;
    if edge == LEFT { return select(own.x, own.y, halved && half == 1u); }
    if edge == RIGHT { return select(own.z, own.w, halved && half == 1u); }
    return select(select(own.x, own.y, ((command >> LEFT) & 1u) == 1u), own.z, half == 1u);
}

// What lies across an edge of a slot, or a half of it; a triangle there that stays learns of its new neighbour, `piece`.
fn outside(slot: u32, edge: u32, half: u32, piece: u32) -> u32 {
    let across = link(slot, edge);
    let theirs = edge_against(across, slot);
    if command_of(across) == 0u { atomicStore(&links[4u * across + theirs], piece); }
    return owner(across, theirs, 1u - half);
}

fn create(slot: u32, t: Triangle, neighbours: vec3u, depth: u32) {
    for (var i = 0u; i < 3u; i++) {
        corners[9u * slot + i] = t.apex[i];
        corners[9u * slot + 3u + i] = t.left[i];
        corners[9u * slot + 6u + i] = t.right[i];
        atomicStore(&links[4u * slot + i], neighbours[i]);
    }
    atomicStore(&links[4u * slot + 3u], depth);
    atomicOr(&tree[slot >> 5u], 1u << (slot & 31u));
}

fn middle(a: vec3u, b: vec3u) -> vec3u { return a / 2u + b / 2u; }

fn bisect(slot: u32, command: u32) {
    let t = triangle_of(slot);
    let depth = depth_of(slot) + 1u;
    let own = pieces[slot];
    let m = middle(t.left, t.right);
    // The pieces on either side of the line from the apex to the middle of the base.
    let left_inner = own.x;
    let right_inner = select(own.z, own.w, ((command >> RIGHT) & 1u) == 1u);
    if ((command >> LEFT) & 1u) == 0u {
        create(own.x, Triangle(m, t.apex, t.left),
            vec3u(outside(slot, LEFT, 0u, own.x), right_inner, outside(slot, BASE, 0u, own.x)), depth);
    } else {
        let n = middle(t.apex, t.left);
        create(own.x, Triangle(n, m, t.apex), vec3u(right_inner, own.y, outside(slot, LEFT, 0u, own.x)), depth + 1u);
        create(own.y, Triangle(n, t.left, m),
            vec3u(outside(slot, BASE, 0u, own.y), outside(slot, LEFT, 1u, own.y), own.x), depth + 1u);
    }
    if ((command >> RIGHT) & 1u) == 0u {
        create(own.z, Triangle(m, t.right, t.apex),
            vec3u(outside(slot, RIGHT, 0u, own.z), outside(slot, BASE, 1u, own.z), left_inner), depth);
    } else {
        let n = middle(t.right, t.apex);
        create(own.z, Triangle(n, m, t.right),
            vec3u(outside(slot, BASE, 1u, own.z), own.w, outside(slot, RIGHT, 0u, own.z)), depth + 1u);
        create(own.w, Triangle(n, t.apex, m), vec3u(left_inner, outside(slot, RIGHT, 1u, own.w), own.z), depth + 1u);
    }
}

fn merge(slot: u32, t: Triangle) {
    let slots = diamond_of(slot, t).slots;
    let own = pieces[slot];
    // The sibling's left corner is the other end of the old base.
    create(own.x, Triangle(t.left, t.right, corner_at(9u * slots.y + 3u)),
        vec3u(own.y, outside(slot, BASE, 0u, own.x), outside(slots.y, BASE, 0u, own.x)), depth_of(slot) - 1u);
}
