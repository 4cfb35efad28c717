// Where a point of the sea lies in the wave patches: which cells serve it, which vertices of a patch's lattice in a cell's plane, and where
// each of them lays the patch. A drawing and the reasons: src/model/wave_domain.rs, which does the same in f64.
#import ellipsoid
#import hash

const BLEND_WIDTH: Metres = 9000.0;
const LEAST_SHARE: f32 = 0.2;
const ROW: f32 = 0.875;
const POLAR_REACH: f32 = 0.0133;
const PERLIN_PATCH = 4u;

// What the weights of the cells that serve a point depend on: the distance to the nearest one, and their norm. A bit of `cells` for each
// that serves: nearly everywhere one alone does, and loops over the bits meet no other.
struct Serving { nearest: f32, norm: f32, cells: u32 }

// A cell serves up to BLEND_WIDTH beyond the nearest one.
fn reach_weight(cell: u32, p: vec3f, nearest: f32) -> f32 {
    return smoothstep(0.0, 1.0, 1.0 - (distance(p, wave_cells[cell].origin) - nearest) / BLEND_WIDTH);
}

// Of the first `count` cells, which are the nearest to the eye, the nearest first: none from `end` on can reach the point.
fn serving(p: vec3f, count: u32) -> Serving {
    let way = length(p);
    var nearest = 1e30;
    var end = 0u;
    loop {
        nearest = min(nearest, distance(p, wave_cells[end].origin));
        end++;
        // Cells are sorted by their distance from the eye's foot; 0.99 allows for the ellipsoid's flattening.
        let none_nearer = 0.99 * length(wave_cells[min(end, MAX_CELLS - 1u)].origin) - way > nearest + BLEND_WIDTH;
        if (end >= count) | none_nearer { break; }
    }
    var squares = 0.0;
    var cells = 0u;
    var i = 0u;
    loop {
        let w = reach_weight(i, p, nearest);
        squares += w * w;
        cells |= select(0u, 1u << i, w > 0.0);
        i++;
        if i == end { break; }
    }
    return Serving(nearest, inverseSqrt(max(squares, 1e-6)), cells);
}

// A cell's weight at a point; squares sum to one.
fn cell_weight(cell: u32, p: vec3f, cells: Serving) -> f32 {
    return reach_weight(cell, p, cells.nearest) * cells.norm;
}

// What all patches of a cell have in common, fetched once: see WaveCell.
struct Plane { cell: u32, axis_x: vec3f, axis_y: vec3f, cos_lat: f32, turn: f32, polar_north: vec2f, wind: vec2f, key: u32 }

fn plane_of(cell: u32) -> Plane {
    return Plane(cell, wave_cells[cell].axis_x, wave_cells[cell].axis_y, wave_cells[cell].cos_lat, wave_cells[cell].turn,
        wave_cells[cell].polar_north, wave_cells[cell].wind, wave_cells[cell].key);
}

// A point in a cell's plane, metres about the eye.
fn in_plane(plane: Plane, p: vec3f) -> vec2f {
    return vec2f(dot(p, plane.axis_x), dot(p, plane.axis_y));
}

// The triangle of a lattice around a point.
struct LatticeTriangle {
    corner: vec2i,             // vertex at the lattice cell's origin
    arm: vec2f,                // from it to the point, metres
    down: bool,                // which half of the lattice cell
    weights: vec3f,            // of the vertices, the greatest first, so that a loop can end early; squares sum to one
    order: vec3u,              // which vertices those are
}

// `q` in the cell's plane, metres about the eye.
fn lattice_triangle(plane: Plane, patch_index: u32, spacing: Metres, q: vec2f) -> LatticeTriangle {
    let anchor = wave_cells[plane.cell].anchors[patch_index];
    let r = anchor.eye + q;
    let v = r.y / (ROW * spacing);
    let u = r.x / spacing - 0.5 * v;
    let low = floor(vec2f(u, v));
    let f = vec2f(u, v) - low;
    let down = f.x + f.y >= 1.0;
    let shares = select(vec3f(1.0 - f.x - f.y, f), vec3f(f.x + f.y - 1.0, 1.0 - f), down);
    var weights = max(shares - LEAST_SHARE, vec3f(0.0));
    var order = vec3u(0u, 1u, 2u);
    if weights.y < weights.z { weights = weights.xzy; order = order.xzy; }
    if weights.x < weights.y { weights = weights.yxz; order = order.yxz; }
    if weights.y < weights.z { weights = weights.xzy; order = order.xzy; }
    // Spacings have six significant bits: these multiples are exact.
    let corner = vec2f((low.x + 0.5 * low.y) * spacing, low.y * ROW * spacing);
    return LatticeTriangle(anchor.vertex + vec2i(low), r - corner, down, weights * inverseSqrt(dot(weights, weights)), order);
}

// North at a place of a cell's plane, metres from its centre; a unit vector.
fn north_at(plane: Plane, place: vec2f) -> vec2f {
    let v = vec2f(-place.x * plane.turn, plane.cos_lat - place.y * plane.turn);
    let from_pole = length(v);
    var north = v / max(from_pole, 1e-9);
    if from_pole < POLAR_REACH {
        let polar = plane.polar_north;
        north = mix(polar, north, smoothstep(0.0, POLAR_REACH, from_pole));
        let size = length(north);
        if size < 1e-3 { return polar; }
        north /= size;
    }
    // Division and square root may err by some 3e-7; a step of Newton's leaves rounding.
    return north * (1.5 - 0.5 * dot(north, north));
}

// A patch as one vertex lays it under a point.
struct Placement {
    at: vec2f,                 // in the patch, patch lengths
    axis_x: vec2f,             // its axes, level, east and north at the eye; x where the waves travel to
    axis_y: vec2f,
}

// The k-th of the triangle's vertices by weight.
fn placement(plane: Plane, patch_index: u32, spacing: Metres, patch_length: Metres, triangle: LatticeTriangle, k: u32) -> Placement {
    let which = triangle.order[k];
    let one = vec2i(i32(which == 1u), i32(which == 2u));
    let step = select(one, vec2i(1) - one, triangle.down);
    let vertex = triangle.corner + step;
    let arm = triangle.arm - spacing * vec2f(f32(step.x) + 0.5 * f32(step.y), ROW * f32(step.y));
    let at = vec2f(vertex);
    let north = north_at(plane, spacing * vec2f(at.x + 0.5 * at.y, ROW * at.y));
    // Turned so that north is y. The difference from the arm itself is small but near a pole, and so is its error.
    let less = select(north.y - 1.0, -north.x * north.x / (1.0 + north.y), north.y > 0.0);
    let level = arm + vec2f(less * arm.x - north.x * arm.y, north.x * arm.x + less * arm.y);
    let wind = plane.wind;
    let along = vec2f(-wind.x * level.x - wind.y * level.y, wind.y * level.x - wind.x * level.y);
    let bits = hash(vec3u(bitcast<vec2u>(vertex), plane.key + patch_index * 0x9E3779B9u));
    // About zero, so that the sum is rounded least.
    let offset = vec2f(f32(bits >> 16u), f32(bits & 0xFFFFu)) / 65536.0 - 0.5;
    let axes = mat2x2f(plane.axis_x.xy, plane.axis_y.xy);
    let east = vec2f(north.y, -north.x);
    return Placement(along / patch_length + offset, axes * (-wind.x * east - wind.y * north), axes * (wind.y * east - wind.x * north));
}
