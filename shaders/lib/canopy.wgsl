// Woods: where they stand, and their crowns, which close over the ground, unlike what stands apart (plants.wgsl). A crown is the upper half of an ellipsoid on a base of its own
// height, in a cell of a turned lattice and wider than that; a sight is followed from above to the first that it meets.
#import domes

const WOODS_GREEN = vec2f(0.3, 0.6);         // how green imagery is where woods are none and all, and its albedo of green: rain forests have 0.045, the
const WOODS_DARK = vec2f(0.088, 0.050);      // Black Forest 0.059, Holland 0.095
const WOODS_TONE = 0.58;                     // how much darker woods are than the grass between them, of the mean
const LOGISTIC = 0.593;                       // deviation of a normal distribution over the logistic one's scale, that is nearest to it from 0.1 to 0.9
const LEAST_EDGE = 0.02;                     // of the noise, in which a wood begins

// How much of the ground are woods.
fn wooded(albedo: vec3f, green: f32) -> f32 {
    return smoothstep(WOODS_GREEN.x, WOODS_GREEN.y, green) * smoothstep(WOODS_DARK.x, WOODS_DARK.y, albedo.g);
}

// Whether a place is in the woods that cover a `share` of the ground, of 0 to 1. `stands`: a noise with the deviation that all of it has, and the variance that shows.
// What does not show of it widens the edges by as much as its variance lacks, so that the mean is the share for pixels of any width.
fn woods_at(share: f32, stands: vec3f) -> f32 {
    // Of the normal distribution by the logistic one.
    let c = clamp(share, 0.004, 0.996);
    let threshold = LOGISTIC * stands.y * log((1.0 - c) / c);
    let edge = LOGISTIC * max(sqrt(max(stands.y * stands.y - stands.z, 0.0)), LEAST_EDGE);
    return mix(smoothstep(0.0, 0.02, share) / (1.0 + exp(min((threshold - stands.x) / edge, 60.0))), 1.0, smoothstep(0.98, 1.0, share));
}

const CROWN_LEVEL = 22u;           // cells of 6.8 m at the equator, 4.5 m at 48°
const CROWN_TURN = vec2i(1, 1);
const CROWN_RADII = vec2f(0.40, 0.72);       // of a cell, the larger ones seldom; with CROWN_ASIDE no more than one cell
const CROWN_ASIDE = 0.28;          // how far a crown is from its cell's middle, at most
const CROWN_BASES = 0.5;           // height of the highest base, in cells
const CROWN_BLOCKS = 7u;           // of four cells, that a sight crosses at most
const CROWN_CROSSED = 4.0;         // cells that it goes while it sinks by the height of the highest, at most
const CROWN_TALL = vec2f(0.8, 1.5);          // height of a crown over its radius: broad ones, and pointed ones of cold places
const CROWN_LIGHT = vec3f(0.12, 0.36, 1.15);  // of what is seen down to the ground, of crowns' feet and of their tops
const CROWN_MEAN = vec2f(0.597, 0.511);       // of that, seen from above, of broad crowns and of pointed ones
const CROWN_SLIM = 0.12;           // by how much pointed ones are narrower

struct Crown { radius: f32, middle: vec2f, base: f32, word: u32 }

// Of a cell, `from_own` cells from one; none where its own chance is above the woods' share.
fn crown_of(own: vec2u, from_own: vec2f, woods: f32, pointed: f32) -> Crown {
    let at = (own + bitcast<vec2u>(vec2i(from_own))) & vec2u((1u << CROWN_LEVEL) - 1u);
    let word = hash(vec3u(at, 57u));
    let part = vec4f(vec4u(word, word >> 8u, word >> 16u, word >> 24u) & vec4u(255u)) / 255.0;
    let stands = smoothstep(0.0, 0.15, 1.12 * woods - part.w);
    let radius = stands * mix(CROWN_RADII.x, CROWN_RADII.y, part.z * part.z) * (1.0 - CROWN_SLIM * pointed);
    return Crown(radius, from_own + 0.5 + CROWN_ASIDE * (2.0 * part.xy - 1.0), CROWN_BASES * fract(7.31 * part.w + part.x), word);
}

// Height at which a ray that passes a plan's place at height 0 and moves so far while it sinks by one meets a crown first, -1 where it does not; `tall`: of the crown.
fn crown_met(f: vec2f, moves: vec2f, crown: Crown, tall: f32) -> f32 {
    let off = f - moves * crown.base - crown.middle;
    let a = dot(moves, moves) + 1.0 / (tall * tall);
    let b = dot(off, moves);
    let within = b * b + a * (crown.radius * crown.radius - dot(off, off));
    let height = (b + sqrt(max(within, 0.0))) / a;
    return select(-1.0, crown.base + height, (within > 0.0) & (height > 0.0));
}

// What a pixel shows of woods. `height`: in cells, of what is met, 0 on the ground; the rest as `Standing` has it.
struct Canopy { tone: f32, rise: vec2f, shade: f32, leaf: vec3f, height: f32 }

// `pointed`: how far trees are firs; `sight`, `sun` and `sees` as of `domes`.
fn canopy(p: FinePoint, woods: f32, pointed: f32, sight_on_map: vec2f, sun_on_map: vec2f, sees: f32, nothing: bool) -> Canopy {
    let turn = vec2f(CROWN_TURN);
    let tall = mix(CROWN_TALL.x, CROWN_TALL.y, pointed);
    let top = CROWN_BASES + CROWN_RADII.y * (1.0 - CROWN_SLIM * pointed) * tall;
    let sight = sight_in_lattice(sight_on_map, CROWN_TURN, top, CROWN_CROSSED);
    let sun = in_lattice(sun_on_map, CROWN_TURN);
    let stands = celled(p, CROWN_TURN, CROWN_LEVEL);
    let own = stands.own;
    let f = stands.f;
    // Through blocks between the middles of four cells, whose crowns alone reach into it.
    var walk = walk_from(f - 0.5 - sight * top, sight);
    var met = 0.0;
    var crown = Crown(0.0, vec2f(0.0), 0.0, 0u);
    var i = 0u;
    loop {
        for (var k = 0u; k < 4u; k++) {
            let other = crown_of(own, walk.cell + vec2f(vec2u(k & 1u, k >> 1u)), woods, pointed);
            let height = crown_met(f, sight, other, tall);
            if height > met {
                met = height;
                crown = other;
            }
        }
        let way = min(walk.next.x, walk.next.y);
        walk = walked(walk);
        i++;
        // What is met farther on is lower than where the sight leaves the block.
        if nothing || way >= top - met || i >= CROWN_BLOCKS { break; }
    }
    let here = f - sight * met;
    let side = here - crown.middle;
    let radius = max(crown.radius, 0.01);
    let high = select(0.0, saturate((met - crown.base) / (tall * radius)), met > 0.0);
    let place = side * (2.0 / ((1.0 + high) * radius));
    let tree = f32((crown.word >> 3u) & 0xffu) / 127.5 - 1.0;
    // A crown before the sun.
    var shade = 0.0;
    let ahead = min(0.7, 0.9 / max(length(sun), 0.05));
    for (var k = 0u; k < 2u; k++) {
        let other = crown_of(own, floor(here - ahead * select(0.5, 1.0, k == 1u) * sun), woods, pointed);
        let over = crown_met(here + sun * met, sun, other, tall) - met;
        shade = max(shade, select(0.0, smoothstep(0.0, 0.15, over), other.word != crown.word));
    }
    let light = select(CROWN_LIGHT.x, mix(CROWN_LIGHT.y, CROWN_LIGHT.z, saturate(met / (0.85 * top)) * (0.5 + 0.5 * high)) * (1.0 + 0.3 * tree), met > 0.0);
    var found = Canopy(light / mix(CROWN_MEAN.x, CROWN_MEAN.y, pointed) - 1.0, vec2f(0.0), shade, vec3f(f32(crown.word & 63u) + radius * place, sees), met);
    let rise = -tall * select(0.0, 1.0, met > 0.0) * side / (radius * max(high, STEEPEST_SIDE));
    found.rise = by_turn(vec2f(turn.x, -turn.y), rise) / length(turn);
    return found;
}
