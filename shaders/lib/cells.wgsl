// The square cells of lattices that are turned against the map, and the way of a sight through them from above: what plants, woods and houses stand in.
#import frame

// A place of the map with what is below its units, 9 mm at the equator.
struct FinePoint { at: vec2u, part: vec2f }

fn moved_by(p: FinePoint, units: vec2f) -> FinePoint {
    let sum = p.part + units;
    return FinePoint(p.at + bitcast<vec2u>(vec2i(floor(sum))), sum - floor(sum));
}

fn by_turn(turn: vec2f, way: vec2f) -> vec2f { return vec2f(turn.x * way.x - turn.y * way.y, turn.y * way.x + turn.x * way.y); }

// A place's cell, and where in it, from 0 to 1.
struct Celled { own: vec2u, f: vec2f }

// Of the lattice turned by a whole-numbered vector, so that rows of none lie along another's or to the north; cells have a side of the level's over the vector's length.
fn celled(p: FinePoint, turn: vec2i, level: u32) -> Celled {
    let shift = 32u - level;
    let t = bitcast<vec2u>(turn);
    let at = vec2u(t.x * p.at.x - t.y * p.at.y, t.y * p.at.x + t.x * p.at.y);
    return Celled(at >> vec2u(shift), (vec2f(at & vec2u((1u << shift) - 1u)) + by_turn(vec2f(turn), p.part)) / f32(1u << shift));
}

// How far what moves so on the map while it sinks by one moves in such a lattice,
fn in_lattice(on_map: vec2f, turn: vec2i) -> vec2f { return by_turn(vec2f(turn), on_map) / length(vec2f(turn)); }

// and a sight that goes no more than `most` cells while it sinks by `top`.
fn sight_in_lattice(on_map: vec2f, turn: vec2i, top: f32, most: f32) -> vec2f {
    let sinks = in_lattice(on_map, turn);
    return sinks * min(1.0, most / (top * max(length(sinks), 1e-3)));
}

// On the way: the cell, how far the sight has sunk where it leaves it right or left and down or up, the ways on, and how far it sinks in a cell.
struct Walk { cell: vec2f, next: vec2f, ways: vec2f, each: vec2f }

fn walk_from(first: vec2f, sight: vec2f) -> Walk {
    let each = 1.0 / max(abs(sight), vec2f(1e-4));
    let cell = floor(first);
    let next = select((first - cell) * each, (cell + 1.0 - first) * each, sight > vec2f(0.0));
    return Walk(cell, select(next, vec2f(1e9), abs(sight) < vec2f(1e-4)), sign(sight), each);
}

fn walked(walk: Walk) -> Walk {
    let goes_aside = walk.next.x < walk.next.y;
    let cell = walk.cell + select(vec2f(0.0, walk.ways.y), vec2f(walk.ways.x, 0.0), goes_aside);
    return Walk(cell, walk.next + select(vec2f(0.0, walk.each.y), vec2f(walk.each.x, 0.0), goes_aside), walk.ways, walk.each);
}
