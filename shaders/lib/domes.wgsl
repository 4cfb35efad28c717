// Domes on square lattices, at most one in a cell: what each plant of plants.wgsl is. A sight goes through the cells from above, so that domes stand
// upright however one looks at them.
#import bed_cover
#import cells

// Of what stands: `tone`, about its mean over the plane from above; `cover`, the share of the pixel that shows it; `rise`, of the surface
// right and down on the map; `shade`, the share of the light that it takes from the ground beside it; `leaf`: a place on
// it, and the width of a pixel there, in cells.
struct Standing { tone: f32, cover: f32, rise: vec2f, shade: f32, leaf: vec3f }

const NOTHING_STANDS = Standing(0.0, 0.0, vec2f(0.0), 0.0, vec3f(0.0));

// The lattice of a size. `fringed`: how deep the gaps of outlines are, of the radius; `dome`: height of a dome over its radius; `tones`: of a dome on green ground at its foot,
// and how much brighter its top is.
struct Lattice { level: u32, turn: vec2i, fringed: f32, dome: f32, tones: vec2f, grouped: bool }

const DOME_WIDEST = 0.48;          // radius, of a cell
const MARGIN = 0.15;               // of a share: above it domes are whole
const DOME_CELLS = 10u;             // that a sight crosses at most
const STEEPEST_SIDE = 0.6;         // height, of a dome's, below which its sides are not steeper; ours
const CROSSED_MOST = 6.0;          // how far, in cells, a sight goes while it sinks by the height of the highest dome, at most

// Height of the highest dome, in cells.
fn dome_top(lattice: Lattice) -> f32 { return lattice.dome * DOME_WIDEST; }

// The radius of a dome by a random number of 0 to 1, over that of the widest: many are small and few are large.
fn dome_size(u: f32, green: f32) -> f32 { return mix(0.22 + 0.78 * u * u * u, 0.3 + 0.7 * u * u, green); }
// The mean of its square.
fn dome_area(green: f32) -> f32 { return dot(vec3f(0.2211, 0.5337, 0.3280), vec3f((1.0 - green) * (1.0 - green), green * (1.0 - green), green * green)); }

// A wave of straight flanks from 0 to 1.
fn tooth(turns: f32) -> f32 { return abs(2.0 * fract(turns) - 1.0); }

// What a share of domes, some of which are smaller, would be of whole ones: 1 - 22/35 of those within the margin, the mean square of a smooth step.
fn whole_share(share: f32) -> f32 { return max(share - MARGIN * 22.0 / 35.0, share * 13.0 / 35.0); }

// How far a dome reaches in from its radius at a place on it, of `fringed`: between boughs and, at a third of their width, leaves. Each is a product of
// two even numbers of 0 to 1; `leafy`: how far leaves show, which else are their mean.
fn gaps(at: vec2f, phase: vec2f, leafy: f32) -> f32 {
    let boughs = tooth(dot(at, vec2f(1.13, 0.61)) + phase.x) * tooth(dot(at, vec2f(-0.57, 1.21)) + phase.y);
    let leaves = tooth(dot(at, vec2f(3.1, -2.3)) + 3.0 * phase.y) * tooth(dot(at, vec2f(2.6, 3.7)) - 5.0 * phase.x);
    return 0.6 * boughs + 0.4 * mix(0.25, leaves, leafy);
}
const MEAN_GAP = 0.2;              // of what is left of domes
// What such gaps leave of a dome's disc: the mean of (1 - fringed gaps)².
fn fringe_area(fringed: f32) -> f32 { return 1.0 - 0.5 * fringed + 0.0878 * fringed * fringed; }
// Mean height of that, of the dome's: 2/3 of the whole dome, more where the low rim is torn.
fn fringe_height(fringed: f32) -> f32 { return 2.0 / 3.0 + 0.12 * fringed; }

// The share of the ground that domes cover, from above.
fn dome_cover(lattice: Lattice, share: f32, green: f32) -> f32 {
    return 0.5 * TURN * whole_share(share) * DOME_WIDEST * DOME_WIDEST * dome_area(green) * fringe_area(lattice.fringed);
}

// Tones of a dome as of `Lattice`: on bare ground all of it is darker than that.
fn dome_tones(lattice: Lattice, green: f32) -> vec2f { return mix(vec2f(-0.85, 0.5), lattice.tones, green); }

fn mean_tone(lattice: Lattice, share: f32, green: f32) -> f32 {
    return dome_cover(lattice, share, green) * dot(dome_tones(lattice, green), vec2f(1.0, fringe_height(lattice.fringed)));
}

// The dome of a cell: its radius, none where nothing stands, how far it stands from the cell's middle, of what it can, and its random word.
struct Dome { radius: f32, aside: vec2f, word: u32 }

fn dome_of(cell: vec2u, lattice: Lattice, share: f32, green: f32) -> Dome {
    let at = cell & vec2u((1u << lattice.level) - 1u);
    let word = hash(vec3u(at, 60u + lattice.level));
    // In some groups of four cells many stand and in others few.
    let group = select(1.0, f32(hash(vec3u(at >> vec2u(1u), 70u)) >> 16u) / 32767.5, lattice.grouped);
    // Where there are fewer they are smaller, so that none is cut off.
    let margin = share * group - f32(word >> 24u) / 256.0;
    let radius = smoothstep(0.0, MARGIN, margin) * DOME_WIDEST * dome_size(f32((word >> 16u) & 0xffu) / 255.0, green);
    return Dome(select(0.0, radius, margin > 0.01), vec2f(f32(word & 0xffu), f32((word >> 8u) & 0xffu)) / 127.5 - 1.0, word);
}

// How much of the sun's light the dome of a cell takes from a place on the ground that lies at `f` in the lattice; `sun`: how far its light moves while it sinks by one.
fn shadow_of(f: vec2f, cell: vec2f, own: vec2u, lattice: Lattice, share: f32, green: f32, sun: vec2f) -> f32 {
    let dome = dome_of(own + bitcast<vec2u>(vec2i(cell)), lattice, share, green);
    let off = f - cell - 0.5 - (0.5 - dome.radius) * dome.aside;
    let b = dot(off, sun);
    let nearest = max(dot(off, off) - b * b / (dot(sun, sun) + 1.0 / (lattice.dome * lattice.dome)), 0.0);
    let ragged = 1.0 - 0.3 * lattice.fringed - 0.5 * lattice.fringed * tooth(2.3 * (off.x + off.y) / max(dome.radius, 0.01)) * tooth(2.7 * (off.x - off.y) / max(dome.radius, 0.01));
    let lies = saturate(0.6 + (dome.radius * ragged - sqrt(nearest)) / max(0.4 * dome.radius, 0.01));
    return select(0.0, lies, dome.radius > 0.0 && (b > 0.0 || dot(off, off) < dome.radius * dome.radius));
}

// Domes in a share of a lattice's cells. `sight` and `sun`: how far these move right and down while they sink by one; `sees`: width of a pixel, in cells.
fn domes(p: FinePoint, lattice: Lattice, share: f32, green: f32, sight_on_map: vec2f, sun_on_map: vec2f, sees: f32, nothing: bool) -> Standing {
    let turn = vec2f(lattice.turn);
    let top = dome_top(lattice);
    let sight = sight_in_lattice(sight_on_map, lattice.turn, top, CROSSED_MOST);
    let sun = in_lattice(sun_on_map, lattice.turn);
    let place = celled(p, lattice.turn, lattice.level);
    let own = place.own;
    let f = place.f;
    // From the cell where the sight comes in at the height of the highest to that of the place.
    var walk = walk_from(f - sight * top, sight);
    let a = dot(sight, sight) + 1.0 / (lattice.dome * lattice.dome);
    let tones = dome_tones(lattice, green);
    let leafy = 1.0 - smoothstep(0.03, 0.1, sees);
    var found = NOTHING_STANDS;
    var left = 1.0;
    var i = 0u;
    loop {
        let dome = dome_of(own + bitcast<vec2u>(vec2i(walk.cell)), lattice, share, green);
        let radius = dome.radius;
        let off = f - walk.cell - 0.5 - (0.5 - radius) * dome.aside;
        // Where the sight is h over the ground it is at off - sight h; the dome is where |off - sight h|² + (h / dome)² = radius².
        let b = dot(off, sight);
        let nearest = max(dot(off, off) - b * b / a, 0.0);
        let height = max((b + sqrt(max(radius * radius - nearest, 0.0) * a)) / a, 0.0);
        let meets = select(0.0, 1.0, radius > 0.0 && (dot(off, off) < radius * radius || b > 0.0));
        let side = off - sight * height;
        let high = height / (lattice.dome * max(radius, 0.01));
        // A place on it, stereographic from its top, in radii: what lies there is as wide as it is high all over, and half as large at the foot.
        let on_it = side * (2.0 / ((1.0 + high) * max(radius, 0.01)));
        let gap = gaps(on_it, dome.aside, leafy);
        let seen = left * meets * saturate(0.5 + (radius * (1.0 - lattice.fringed * gap) - sqrt(nearest)) / max(sees, 0.02))
            * saturate(1.0 + (height - 0.5 * lattice.fringed * gap * radius) / max(sees, 0.02));
        let kind = 0.6 + 0.8 * f32((dome.word >> 5u) & 0xffu) / 255.0;
        found.tone += seen * kind * (tones.x + tones.y * high + 0.5 * (MEAN_GAP - gap));
        found.cover += seen;
        found.rise -= lattice.dome * seen * side / max(radius * max(high, STEEPEST_SIDE), 0.01);
        found.leaf = select(found.leaf, vec3f(dome.aside + radius * on_it, sees), seen > 0.5);
        left -= seen;
        let is_last = min(walk.next.x, walk.next.y) >= top;
        walk = walked(walk);
        i++;
        if nothing || is_last || i >= DOME_CELLS || left < 0.02 { break; }
    }
    // The ground lies in the shadow of its own cell's dome and of the one before the sun.
    if !nothing && left > 0.02 {
        let here = floor(f);
        let sunward = floor(f - 0.6 * top * sun);
        found.shade = left * max(shadow_of(f, here, own, lattice, share, green, sun), shadow_of(f, sunward, own, lattice, share, green, sun));
    }
    found.rise = by_turn(vec2f(turn.x, -turn.y), found.rise) / length(turn);
    return found;
}
