// One update of the bisected mesh: classify, plan, apply, then sum, top and list. Every change reads the old triangles and writes
// into free slots, so that splits and merges of the same update need no order among themselves; what was replaced is freed at once
// and used again from the next update on.
#import bisectors
#import bisection_tree
#import bisector_pieces
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
    if state.resting != AWAKE || slot >= capacity() || !is_live(slot) { return; }
    if f32(hash(vec3u(slot, state.updates, 0u)) >> 8u) / 16777216.0 > state.acceptance { return; }
    let t = triangle_of(slot);
    if asks(t.left, t.right) { split(slot, BASE); }
    if asks(t.apex, t.left) { split(slot, LEFT); }
    if asks(t.right, t.apex) { split(slot, RIGHT); }
}

// Slots for the pieces of what splits; diamonds whose old base nobody asks to be halved become two triangles.
@compute @workgroup_size(64)
fn plan(@builtin(global_invocation_id) id: vec3u) {
    let slot = id.x;
    if state.resting != AWAKE || slot >= capacity() || !is_live(slot) { return; }
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

// Makes the pieces, and frees what they replace.
@compute @workgroup_size(64)
fn apply(@builtin(global_invocation_id) id: vec3u) {
    let slot = id.x;
    if state.resting != AWAKE || slot >= capacity() { return; }
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
    if state.resting != AWAKE {
        state.resting = ASLEEP;
        return;
    }
    let before = vec2f(state.coarseness, state.acceptance);
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
    let same = all(before == vec2f(state.coarseness, state.acceptance));
    state.resting = select(AWAKE, LISTED, same && !short && growth == 0u && state.last_merged == 0u);
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
    if state.resting == ASLEEP || slot >= capacity() { return; }
    if !is_live(slot) {
        atomicStore(&commands[slot], 0u);
        return;
    }
    let t = triangle_of(slot);
    if !in_view(reach_of(t.left, t.right), frame.rim_reach + 2.0 * frame.crest_height) { return; }
    drawn[atomicAdd(&state.vertices, 3u) / 3u] = slot;
}
