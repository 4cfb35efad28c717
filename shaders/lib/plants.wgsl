// What stands on the ground: trees, shrubs, herbs and tufts of grass, domes of four sizes of cells, at most one in a cell. A sight goes through the cells
// from above, so that they stand upright however one looks at them.
#import bed_cover

// Of what stands: `tone`, about its mean over the plane from above; `cover`, the share of the pixel that shows it; `rise`, of the surface
// right and down on the map; `shade`, the share of the light that it takes from the ground beside it; `leaf`: a place on
// it, and the width of a pixel there, in cells.
struct Standing { tone: f32, cover: f32, rise: vec2f, shade: f32, leaf: vec3f }

const NOTHING_STANDS = Standing(0.0, 0.0, vec2f(0.0), 0.0, vec3f(0.0));

// A place of the map with what is below its units, 9 mm at the equator.
struct FinePoint { at: vec2u, part: vec2f }

fn moved_by(p: FinePoint, units: vec2f) -> FinePoint {
    let sum = p.part + units;
    return FinePoint(p.at + bitcast<vec2u>(vec2i(floor(sum))), sum - floor(sum));
}

// The square lattice of a size turned by a whole-numbered vector, so that rows of none lie along another's or to the north; cells have a side of
// the level's over the vector's length.
// `fringed`: how deep the teeth of outlines are, of the radius.
struct Lattice { level: u32, turn: vec2i, fringed: f32 }

fn by_turn(turn: vec2f, way: vec2f) -> vec2f { return vec2f(turn.x * way.x - turn.y * way.y, turn.y * way.x + turn.x * way.y); }

const DOME = 0.75;                 // height of a dome over its radius
const DOME_WIDEST = 0.5;           // radius, of a cell
const DOME_TOP = DOME * DOME_WIDEST;
const MARGIN = 0.15;               // of a share: above it domes are whole
const DOME_CELLS = 8u;             // that a sight crosses at most
const FLATTEST_SIGHT = 12.0;       // how far a sight goes over how far it sinks, at most

// The radius of a dome by a random number of 0 to 1, over that of the widest: where it is green many are large, where it is bare most are small.
fn dome_size(u: f32, green: f32) -> f32 { return mix(0.25 + 0.75 * u * u * u, 0.55 + 0.45 * u, green); }
// The mean of its square.
fn dome_area(green: f32) -> f32 { return dot(vec3f(0.2366, 0.7288, 0.6175), vec3f((1.0 - green) * (1.0 - green), green * (1.0 - green), green * green)); }

// A wave of straight flanks from 0 to 1.
fn tooth(turns: f32) -> f32 { return abs(2.0 * fract(turns) - 1.0); }

// What a share of domes, some of which are smaller, would be of whole ones: 1 - 22/35 of those within the margin, the mean square of a smooth step.
fn whole_share(share: f32) -> f32 { return max(share - MARGIN * 22.0 / 35.0, share * 13.0 / 35.0); }

// The share of the ground that domes cover, from above.
fn dome_cover(share: f32, green: f32) -> f32 { return 0.5 * TURN * whole_share(share) * DOME_WIDEST * DOME_WIDEST * dome_area(green); }

// Tone of a dome at its foot, and how much brighter its top is: on bare ground all of it is darker than that.
fn dome_tones(green: f32) -> vec2f { return mix(vec2f(-1.1, 0.5), vec2f(-0.75, 1.0), green); }

// Domes in a share of a lattice's cells. `sight` and `sun`: how far these move right and down while they sink by one; `sees`: width of a pixel, in cells.
fn domes(p: FinePoint, lattice: Lattice, share: f32, green: f32, sight_on_map: vec2f, sun_on_map: vec2f, sees: f32, nothing: bool) -> Standing {
    let turn = vec2f(lattice.turn);
    let sight = by_turn(turn, sight_on_map) / length(turn);
    let sun = by_turn(turn, sun_on_map) / length(turn);
    let shift = 32u - lattice.level;
    let t = bitcast<vec2u>(lattice.turn);
    let at = vec2u(t.x * p.at.x - t.y * p.at.y, t.y * p.at.x + t.x * p.at.y);
    let own = at >> vec2u(shift);
    let mask = vec2u((1u << lattice.level) - 1u);
    let f = (vec2f(at & vec2u((1u << shift) - 1u)) + by_turn(turn, p.part)) / f32(1u << shift);
    // From the cell where the sight comes in at the height of the highest to that of the place.
    let first = f - sight * DOME_TOP;
    let ways = sign(sight);
    let each = 1.0 / max(abs(sight), vec2f(1e-4));
    var cell = floor(first);
    var next = select((first - cell) * each, (cell + 1.0 - first) * each, sight > vec2f(0.0));
    next = select(next, vec2f(1e9), abs(sight) < vec2f(1e-4));
    let a = dot(sight, sight) + 1.0 / (DOME * DOME);
    let tones = dome_tones(green);
    let is_grass = lattice.fringed > 0.3;
    var found = NOTHING_STANDS;
    var left = 1.0;
    var i = 0u;
    loop {
        let word = hash(vec3u((own + bitcast<vec2u>(vec2i(cell))) & mask, 60u + lattice.level));
        // Where there are fewer they are smaller, so that none is cut off.
        let margin = share - f32(word >> 24u) / 256.0;
        let radius = smoothstep(0.0, MARGIN, margin) * DOME_WIDEST * dome_size(f32((word >> 16u) & 0xffu) / 255.0, green);
        let aside = vec2f(f32(word & 0xffu), f32((word >> 8u) & 0xffu)) / 127.5 - 1.0;
        let off = f - cell - 0.5 - (0.5 - radius) * aside;
        let stands = margin > 0.01;
        // Where the sight is h over the ground it is at off - sight h; the dome is where |off - sight h|² + (h / DOME)² = radius².
        let b = dot(off, sight);
        let nearest = max(dot(off, off) - b * b / a, 0.0);
        let height = max((b + sqrt(max(radius * radius - nearest, 0.0) * a)) / a, 0.0);
        let meets = select(0.0, 1.0, stands && (dot(off, off) < radius * radius || b > 0.0));
        // Outlines are teeth of leaves and blades.
        let across = dot(off, vec2f(sight.y, -sight.x)) / max(length(sight), 1e-3) / max(radius, 0.01);
        let teeth = min(length(sight), 1.0) * (0.5 * tooth(6.0 * across + aside.x) + 0.5 * tooth(17.0 * across + aside.y + across * across));
        let seen = left * meets * saturate(0.5 + (radius * (1.0 - lattice.fringed * teeth) - sqrt(nearest)) / max(sees, 0.02));
        let kind = 0.6 + 0.8 * f32((word >> 5u) & 0xffu) / 255.0;
        let side = off - sight * height;
        found.tone += seen * kind * (tones.x + tones.y * height / (DOME * max(radius, 0.01)));
        found.cover += seen;
        found.rise -= seen * side / max(DOME * radius, 0.01);
        // Leaves' place on the dome; blades stand.
        let place = aside + select(side + vec2f(0.7, -0.9) * height, vec2f(across * radius, 0.2 * height), is_grass);
        found.leaf = select(found.leaf, vec3f(place, sees), seen > 0.5);
        left -= seen;
        let is_last = min(next.x, next.y) >= DOME_TOP;
        // Its shadow on the ground of its own cell, which does not reach its border.
        let rim = min(min(f.x, 1.0 - f.x), min(f.y, 1.0 - f.y));
        let shaded = (1.0 - smoothstep(0.6, 1.3, length(off - 0.5 * DOME * radius * sun) / max(radius, 0.01))) * smoothstep(0.0, 0.12, rim);
        found.shade = select(found.shade, left * shaded, stands && all(cell == vec2f(0.0)));
        let goes_aside = next.x < next.y;
        cell += select(vec2f(0.0, ways.y), vec2f(ways.x, 0.0), goes_aside);
        next += select(vec2f(0.0, each.y), vec2f(each.x, 0.0), goes_aside);
        i++;
        if nothing || is_last || i >= DOME_CELLS || left < 0.02 { break; }
    }
    found.rise = by_turn(vec2f(turn.x, -turn.y), found.rise) / length(turn);
    return found;
}

// That of a size: trees with cells of 8.5 m at the equator, shrubs of 3.0 m, herbs of 1.2 m, tufts of 0.38 m.
fn lattice_of(size: u32) -> Lattice {
    let large = select(vec3i(22, 3, -1), vec3i(21, 2, 1), size == 0u);
    let small = select(vec3i(25, 1, 3), vec3i(23, 4, 1), size == 2u);
    let own = select(small, large, size < 2u);
    return Lattice(u32(own.x), own.yz, 0.25 + 0.25 * f32(max(size, 1u) - 1u));
}

const SIZES = 4u;

// What stands on ground that is so `green`, and has so much more on it than the ground around (`fertile`, about 0; it changes
// little over a tree). `open`: from 0 to 1 from a beach to where trees can grow; `sight` and `sun`: as of `domes`; `eye`: how high it is above the ground,
// which is no more than a picture: there are no trees about an eye below their tops.
fn plants(p: FinePoint, green: f32, fertile: f32, open: f32, sight: vec2f, sun: vec2f, eye: Metres, footprint: Metres) -> Standing {
    let flat = sight * min(1.0, FLATTEST_SIGHT / max(length(sight), 1e-3));
    var found = NOTHING_STANDS;
    var size = 0u;
    loop {
        let lattice = lattice_of(size);
        let small = f32(size) / 3.0;
        let cell = EARTH_TURN * max(frame.cos_lat, 0.1) / exp2(f32(lattice.level)) / length(vec2f(lattice.turn));
        let grows = smoothstep(0.55 - 0.5 * small, 1.0 - 0.3 * small, open) * smoothstep(1.2 * DOME_TOP, 3.0 * DOME_TOP, eye / cell);
        let share = grows * clamp(mix(0.2, 0.6, green) + mix(0.5, 0.9, green) * fertile + 0.5 * (small - 0.4), 0.02, 0.98);
        let mean_tone = dome_cover(share, green) * dot(dome_tones(green), vec2f(1.0, 2.0 / 3.0));
        let whole = 1.0 - smoothstep(0.25, 0.7, footprint / cell);
        let own = domes(p, lattice, share, green, flat, sun, footprint / cell, whole * share <= 0.0);
        let left = (1.0 - found.cover) * whole;
        found.tone += left * (own.tone - mean_tone);
        found.rise += left * own.rise;
        found.shade += (1.0 - found.shade) * left * own.shade;
        found.cover += left * own.cover;
        found.leaf = select(found.leaf, own.leaf, left * own.cover > 0.5);
        size++;
        if size >= SIZES || whole <= 0.0 { break; }
    }
    let branches = shown(found.leaf.z, 0.25) * bed_noise(found.leaf.xy, 0.25, 83u).z;
    let leaves = shown(found.leaf.z, 0.03125) * bed_noise(found.leaf.xy, 0.03125, 84u).z;
    found.tone += found.cover * (0.6 * branches + 1.1 * leaves);
    return found;
}
