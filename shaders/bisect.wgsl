// One update of the bisected mesh: classify, plan, apply, then sum, top and list. Every change reads the old triangles and writes
// into free slots, so that splits and merges of the same update need no order among themselves; what was replaced is freed at once
// and used again from the next update on.
#import bisectors
#import hash

const DEEPEST = 4u;            // edges of so many whole numbers are not halved (2 cm)

fn asks(a: vec3u, b: vec3u) -> bool {
    let d = max(a, b) - min(a, b);
    if max(d.x, max(d.y, d.z)) <= DEEPEST { return false; }
    let reach = reach_of(a, b);
    return pixels_of(reach) > bisection.target_pixels * state.coarseness && in_view(reach, 0.5 * frame.crest_height);
}

// Adds split edges to a slot's command, counts the slots that it costs, and returns what the command was.
fn mark(slot: u32, edge: u32) -> u32 {
    let added = SPLIT_BASE | (1u << edge);
    let old = atomicOr(&commands[slot], added);
    let growth = countOneBits(old | added) - countOneBits(old);
    if growth > 0u {
        atomicAdd(&state.growth, growth);
        atomicAdd(&state.wanted_slots, growth + select(0u, 1u, old == 0u));
    }
    return old;
}

// The base of `slot` has just been marked: the triangle across it must split the same edge, and so on to ever coarser ones.
fn follow(slot: u32) {
    var b = slot;
    for (var i = 0u; i < 64u; i++) {
        let across = link(b, BASE);
        let edge = edge_against(across, b);
        let old = mark(across, edge);
        if edge == BASE || (old & SPLIT_BASE) != 0u { return; }
        b = across;
    }
}

fn split(slot: u32, edge: u32) {
    let old = mark(slot, edge);
    if (old & SPLIT_BASE) == 0u { follow(slot); }
    if edge == BASE || ((old >> edge) & 1u) == 1u { return; }
    let across = link(slot, edge);
    let theirs = edge_against(across, slot);
    if (mark(across, theirs) & SPLIT_BASE) == 0u && theirs != BASE { follow(across); }
}

// Which edges are too long.
@compute @workgroup_size(64)
fn classify(@builtin(global_invocation_id) id: vec3u) {
    let slot = id.x;
    if slot >= capacity() || !is_live(slot) { return; }
    if f32(hash(vec3u(slot, state.updates, 0u)) >> 8u) / 16777216.0 > state.acceptance { return; }
    let t = triangle_of(slot);
    if asks(t.left, t.right) { split(slot, BASE); }
    if asks(t.apex, t.left) { split(slot, LEFT); }
    if asks(t.right, t.apex) { split(slot, RIGHT); }
}

// Live slots under a node of the tree, whose leaves are the words.
fn live_under(node: u32) -> u32 {
    let words = capacity() >> 5u;
    if node < words { return atomicLoad(&tree[words + node]); }
    return countOneBits(atomicLoad(&tree[node - words]));
}

// The free slot of a rank: down the sums, then within the word.
fn free_slot(rank: u32) -> u32 {
    let words = capacity() >> 5u;
    var left = rank;
    var node = 1u;
    var bits = capacity();
    while node < words {
        node *= 2u;
        bits >>= 1u;
        let free = bits - live_under(node);
        if left >= free {
            left -= free;
            node += 1u;
        }
    }
    var word = ~atomicLoad(&tree[node - words]);
    for (; left > 0u; left--) { word &= word - 1u; }
    return 32u * (node - words) + firstTrailingBit(word);
}

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

// Slots for the pieces of what splits; diamonds whose old base nobody asks to be halved become two triangles.
@compute @workgroup_size(64)
fn plan(@builtin(global_invocation_id) id: vec3u) {
    let slot = id.x;
    if slot >= capacity() || !is_live(slot) { return; }
    let command = command_of(slot) & SPLITS;
    if command != 0u {
        let n = countOneBits(command) + 1u;
        var rank = atomicAdd(&state.taken, n);
        var own = vec4u(0u);
        own.x = free_slot(rank);
        own.z = free_slot(rank + 1u);
        rank += 2u;
        if ((command >> LEFT) & 1u) == 1u {
            own.y = free_slot(rank);
            rank += 1u;
        }
        if ((command >> RIGHT) & 1u) == 1u { own.w = free_slot(rank); }
        pieces[slot] = own;
        return;
    }
    // Splits that found no room.
    atomicAnd(&commands[slot], MERGE);
    let t = triangle_of(slot);
    if !is_first_half(t) { return; }
    let diamond = diamond_of(slot, t);
    if !diamond.exists || slot > diamond.slots.z { return; }
    for (var i = 1u; i < 4u; i++) { if (command_of(diamond.slots[i]) & SPLITS) != 0u { return; } }
    let base = parents(t.apex);
    if asks(base.first, base.second) { return; }
    let splitting = select(atomicLoad(&state.wanted_slots), 0u, is_short());
    let rank = splitting + atomicAdd(&state.merging, 2u);
    if rank + 2u > capacity() - state.live { return; }
    let own = free_slot(rank);
    let theirs = free_slot(rank + 1u);
    for (var i = 0u; i < 4u; i++) {
        pieces[diamond.slots[i]] = select(vec4u(theirs, own, 0u, 0u), vec4u(own, theirs, 0u, 0u), i < 2u);
        atomicOr(&commands[diamond.slots[i]], MERGE);
    }
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

// Makes the pieces, and frees what they replace.
@compute @workgroup_size(64)
fn apply(@builtin(global_invocation_id) id: vec3u) {
    let slot = id.x;
    if slot >= capacity() { return; }
    let command = command_of(slot);
    if command == 0u { return; }
    if (command & MERGE) == 0u {
        bisect(slot, command);
    } else {
        let t = triangle_of(slot);
        if is_first_half(t) { merge(slot, t); }
    }
    atomicAnd(&tree[slot >> 5u], ~(1u << (slot & 31u)));
}

var<workgroup> sums: array<u32, 256>;

// Halves the 256 sums in the workgroup's memory again and again; level by level they become the nodes above `first`.
fn sum_up(lane: u32, first: u32, count: u32) {
    let words = capacity() >> 5u;
    var node = first;
    for (var n = count / 2u; n > 0u; n /= 2u) {
        workgroupBarrier();
        var pair = 0u;
        if lane < n { pair = sums[2u * lane] + sums[2u * lane + 1u]; }
        workgroupBarrier();
        node /= 2u;
        if lane < n {
            sums[lane] = pair;
            atomicStore(&tree[words + node + lane], pair);
        }
    }
}

// Counts the live slots of 256 words, and up the tree to one sum for each workgroup. Node i has the children 2 i and 2 i + 1, the
// words are the nodes from `words` on.
@compute @workgroup_size(256)
fn count(@builtin(local_invocation_index) lane: u32, @builtin(workgroup_id) group: vec3u) {
    let words = capacity() >> 5u;
    sums[lane] = countOneBits(atomicLoad(&tree[256u * group.x + lane]));
    sum_up(lane, words + 256u * group.x, 256u);
}

// Sums up to the root, and settles the accounts of the update.
@compute @workgroup_size(256)
fn account(@builtin(local_invocation_index) lane: u32) {
    let words = capacity() >> 5u;
    let groups = words / 256u;
    sums[lane] = 0u;
    if lane < groups { sums[lane] = atomicLoad(&tree[words + groups + lane]); }
    sum_up(lane, groups, groups);
    workgroupBarrier();
    if lane > 0u { return; }
    let short = is_short();
    let growth = atomicLoad(&state.growth);
    let budget = f32(bisection.budget);
    if short {
        let over = sqrt((f32(state.live) + f32(growth) / state.acceptance) / budget);
        state.coarseness *= clamp(over, 1.005, 1.2);
        state.acceptance = max(0.5 * state.acceptance, 1.0 / 64.0);
    } else {
        state.acceptance = min(2.0 * state.acceptance, 1.0);
    }
    state.live = sums[0];
    if !short && f32(state.live) < 0.95 * budget { state.coarseness = max(0.99 * state.coarseness, 1.0); }
    state.last_growth = select(growth, 0u, short);
    state.last_merged = atomicLoad(&state.merging);
    state.updates += 1u;
    atomicStore(&state.wanted_slots, 0u);
    atomicStore(&state.growth, 0u);
    atomicStore(&state.taken, 0u);
    atomicStore(&state.merging, 0u);
    atomicStore(&state.vertices, 0u);
}

// What is drawn: all that is in view. Free slots forget what they were told.
@compute @workgroup_size(64)
fn list(@builtin(global_invocation_id) id: vec3u) {
    let slot = id.x;
    if slot >= capacity() { return; }
    if !is_live(slot) {
        atomicStore(&commands[slot], 0u);
        return;
    }
    let t = triangle_of(slot);
    if !in_view(reach_of(t.left, t.right), frame.rim_reach + 2.0 * frame.crest_height) { return; }
    drawn[atomicAdd(&state.vertices, 3u) / 3u] = slot;
}
