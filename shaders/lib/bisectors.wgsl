// The pool of the bisected mesh: its buffers, and reading them. How they change: shaders/bisect.wgsl.
//
//        A             edges: BASE from L to R, LEFT from A to L, RIGHT from R to A; each starts and ends counter-clockwise.
//       / \            A split edge's half 0 is next to its start, half 1 next to its end.
//      /   \
//     L-----R
#import cuboid

@group(1) @binding(0) var<uniform> bisection: Bisection;
@group(1) @binding(1) var<storage, read_write> corners: array<u32>;                // A, L, R of each slot, three numbers each
@group(1) @binding(2) var<storage, read_write> links: array<atomic<u32>>;          // slots across the three edges, then the depth
@group(1) @binding(3) var<storage, read_write> commands: array<atomic<u32>>;       // what a slot does in this update; 0 outside one
@group(1) @binding(4) var<storage, read_write> pieces: array<vec4u>;               // slots that take its place
@group(1) @binding(5) var<storage, read_write> tree: array<atomic<u32>>;           // a bit per slot, then sums over them
@group(1) @binding(6) var<storage, read_write> state: State;
@group(1) @binding(7) var<storage, read_write> drawn: array<u32>;                  // slots to draw

struct State {
    vertices: atomic<u32>,     // with the next three: the arguments of the draw
    instances: u32,
    first_vertex: u32,
    first_instance: u32,
    live: u32,                 // triangles
    wanted_slots: atomic<u32>, // by the splits of this update
    growth: atomic<u32>,       // triangles that they add
    taken: atomic<u32>,        // slots given to splits
    merging: atomic<u32>,      // slots given to merges
    coarseness: f32,           // factor on the wished length that keeps the budget
    acceptance: f32,           // share of the wishes heard, below 1 while the pool is short
    updates: u32,
    last_growth: u32,          // of the last update
    last_merged: u32,
    resting: u32,              // AWAKE, LISTED or ASLEEP
    unused: u32,
}

// An update that has changed nothing sets the mesh at rest: the next ones would change nothing either, until the host wakes it. It still
// lists what is drawn.
const AWAKE = 0u;
const LISTED = 1u;
const ASLEEP = 2u;

const BASE = 0u;
const LEFT = 1u;
const RIGHT = 2u;
// Commands: bits 0 to 2 split an edge, always with the base; bit 3 merges.
const SPLIT_BASE = 1u;
const SPLITS = 7u;
const MERGE = 8u;

struct Triangle { apex: vec3u, left: vec3u, right: vec3u }

fn corner_at(index: u32) -> vec3u { return vec3u(corners[index], corners[index + 1u], corners[index + 2u]); }

fn triangle_of(slot: u32) -> Triangle {
    return Triangle(corner_at(9u * slot), corner_at(9u * slot + 3u), corner_at(9u * slot + 6u));
}

fn link(slot: u32, edge: u32) -> u32 { return atomicLoad(&links[4u * slot + edge]); }

fn depth_of(slot: u32) -> u32 { return atomicLoad(&links[4u * slot + 3u]); }

// Which edge of `slot` lies against `other`.
fn edge_against(slot: u32, other: u32) -> u32 {
    return select(select(RIGHT, LEFT, link(slot, LEFT) == other), BASE, link(slot, BASE) == other);
}

fn capacity() -> u32 { return arrayLength(&commands); }

fn is_live(slot: u32) -> bool { return ((atomicLoad(&tree[slot >> 5u]) >> (slot & 31u)) & 1u) == 1u; }

// Whether the splits that are asked for have no room: then none is made in this update.
fn is_short() -> bool {
    let room = max(bisection.budget, state.live) - state.live;
    return atomicLoad(&state.wanted_slots) > capacity() - state.live || atomicLoad(&state.growth) > room;
}

fn command_of(slot: u32) -> u32 {
    return atomicLoad(&commands[slot]) & select(SPLITS | MERGE, MERGE, is_short());
}
