// Where the edge of what stands before something far behind it goes within a pixel, told by where the steps of its stair end (A. Reshetov 2009,
// "Morphological Antialiasing"). Who imports this declares `depth_at`, of a pixel, inside the picture or not: the reciprocal of the distance.

const LONGEST = 24;      // pixels to either side in which the end of a step is looked for
const BEHIND = 0.7;      // depth of what lies far behind, of that before it

// From a pixel along the edge that it has towards `out`: half a pixel, where the edge goes on farther out, or less a half, further in; and how many
// pixels on that is. As in lib/waves.wgsl, the loop ends at its foot.
fn step_end(from_pixel: vec2i, along: vec2i, out: vec2i, edge: f32) -> vec2f {
    var at = from_pixel;
    var end = 0.0;
    var way = 0;
    loop {
        at += along;
        way++;
        let is_in = depth_at(at) > edge;
        let is_out = depth_at(at + out) <= edge;
        end = select(select(0.0, 0.5, !is_out), -0.5, !is_in);
        if end != 0.0 || way == LONGEST { break; }
    }
    return vec2f(end, f32(way));
}

// How far, in pixels, what stands before its surroundings reaches beyond the edge that a pixel of it has towards `out`; less than nothing where it
// does not reach that edge.
fn reach(pixel: vec2i, out: vec2i, edge: f32) -> f32 {
    let along = vec2i(out.y, out.x);
    let here = step_end(pixel, along, out, edge);
    let there = step_end(pixel, -along, out, edge);
    let way = here.y + there.y - 1.0;
    // Each end stands for the half of the step that is next to it; one that is not found, for none.
    let before = max(0.5 * way - here.y + 0.5, 0.0) / (0.5 * way);
    let after = max(0.5 * way - there.y + 0.5, 0.0) / (0.5 * way);
    return here.x * before + there.x * after;
}

// Which neighbour a pixel shows besides itself, and how much of it.
struct Beside { out: vec2i, share: f32 }

// Of the two neighbours along an axis.
fn beside_along(pixel: vec2i, axis: vec2i) -> Beside {
    let depth = depth_at(pixel);
    let ends = vec2f(depth_at(pixel - axis), depth_at(pixel + axis));
    let changes = max(vec2f(depth), ends) - min(vec2f(depth), ends) / BEHIND;
    if max(changes.x, changes.y) <= 0.0 { return Beside(axis, 0.0); }
    let is_next = changes.y > changes.x;
    let out = select(-axis, axis, is_next);
    let other = select(ends.x, ends.y, is_next);
    let is_before = depth > other;
    let far = reach(select(pixel + out, pixel, is_before), select(-out, out, is_before), BEHIND * max(depth, other));
    return Beside(out, saturate(select(far, -far, is_before)));
}

fn beside(pixel: vec2i) -> Beside {
    let across = beside_along(pixel, vec2i(1, 0));
    let down = beside_along(pixel, vec2i(0, 1));
    if across.share > down.share { return across; }
    return down;
}
