// The trains of waves near shores: what stands for the long waves of the sea where these feel the bottom. A drawing and the reasons:
// src/model/shore_waves.rs; windows, layout and handover: src/scene/sea/shores.rs, which does the same in f64, but for how white a group is.
// Long, but one thing: from the words of the buffer to a train in one window, to all trains at a place, to the one wave that they are there.
#import world
#import hash
#import breakers
#import shelter

// Words: how the trains are; each one's frequency and amplitude, then its phase now; which share of the sea they take, and the frequency that they
// grow by; which window a tile has; then their nodes.
@group(1) @binding(15) var<storage, read> shore_words: array<vec2u>;

// The sum of the trains at a place, as far as a footprint shows them: Σ A e^{iθ}, and Σ k A cos θ and Σ k A sin θ along their ways, east and
// north; and the variance of the slopes that it hides. Amplitudes lack shoaling.
struct Trains { z: vec2f, cosines: vec2f, sines: vec2f, hidden: f32 }

const NO_TRAINS = Trains(vec2f(0.0), vec2f(0.0), vec2f(0.0), 0.0);

// Waves at a place: height over the mean level, its slope east and north, how far its group has broken (0 to 1), seconds since the last crest, how high
// the waves are, the share of the sea's energy that is theirs, the variance of their slopes that does not show, and which way they go.
struct ShoreWaves { rise: Metres, slope: vec2f, white: f32, age: f32, height: Metres, share: f32, hidden: f32, way: vec2f }

const NO_SHORE_WAVES = ShoreWaves(0.0, vec2f(0.0), 0.0, 0.0, 0.0, 0.0, 0.0, vec2f(0.0));

// Energy that the trains have of the sea's long waves: where these feel the bottom, by a shore, and near the eye.
fn trains_share(depth: Metres, shore: Metres, distance: Metres) -> f32 {
    let about = bitcast<vec2f>(shore_words[0]);
    let near = 1.0 - smoothstep(0.6 * about.y, about.y, distance);
    let u = about.x * about.x * max(depth, 0.0) / GRAVITY;
    return near * (1.0 - smoothstep(FEELS_BOTTOM, FREE_OF_BOTTOM, u)) * (1.0 - smoothstep(SHORES_END * 0.6, SHORES_END, shore)) * smoothstep(-0.5, 0.0, shore);
}

// The trains' frequency, or that of the wind's waves.
fn mean_omega() -> f32 {
    let about = bitcast<vec2f>(shore_words[0]);
    return select(WHOLE_TURN / frame.surf.x, about.x, about.y > 1.0);
}

fn node_value(base: u32, node: vec2u, train: u32) -> vec3f {
    let word = shore_words[base + (node.y * SHORE_SIDE + node.x) * SHORE_TRAINS + train];
    return vec3f(bitcast<f32>(word.x), 2.0 * unpack2x16snorm(word.y));
}

// A train as one window has it at a place: R and the way, and the window's energy there, 0 where there is no such window.
struct InWindow { rest: f32, way: vec2f, energy: f32, chance: f32 }

// Where a place lies among the windows: its tile, where in it, and by which shares of energy the neighbours' serve beside its edges.
struct Among { tile: vec2u, inside: vec2f, beyond: vec2f, step: vec2i }

fn among_windows(point: MapPoint) -> Among {
    let shift = 32u - SHORE_LEVEL;
    let inside = vec2f(point.at & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    let beyond = smoothstep(vec2f(0.4), vec2f(0.6), abs(inside - 0.5));
    return Among(point.at >> vec2u(shift), inside, beyond, select(vec2i(-1), vec2i(1), inside > vec2f(0.5)));
}

// The k-th window: 0 the tile's own, then that beside, that above or below, and that across the corner.
fn in_window(place: Among, k: u32, train: u32) -> InWindow {
    let side = vec2u(k & 1u, k >> 1u);
    let step = vec2i(side) * place.step;
    let tile = bitcast<vec2u>(bitcast<vec2i>(place.tile) + step) & vec2u((1u << SHORE_LEVEL) - 1u);
    let entry = shore_words[SHORE_TABLE + (tile.y & 7u) * 8u + (tile.x & 7u)];
    // Its slot, counted from 1, and in the upper half by which share it is there.
    let slot = entry.y & 0xffffu;
    let there = select(0.0, f32(entry.y >> 16u) / 65535.0, (entry.x == (tile.x | (tile.y << 16u))) & (slot > 0u));
    let shares = select(1.0 - place.beyond, place.beyond, side == vec2u(1u));
    let at = clamp((place.inside - vec2f(step) + 0.5) * f32(SHORE_SIDE / 2u), vec2f(0.0), vec2f(f32(SHORE_SIDE) - 1.001));
    let low = vec2u(at);
    let f = at - vec2f(low);
    let base = SHORE_NODES + (max(slot, 1u) - 1u) * SHORE_SIDE * SHORE_SIDE * SHORE_TRAINS;
    let top = mix(node_value(base, low, train), node_value(base, low + vec2u(1u, 0u), train), f.x);
    let bottom = mix(node_value(base, low + vec2u(0u, 1u), train), node_value(base, low + vec2u(1u), train), f.x);
    let found = mix(top, bottom, f.y);
    let chance = f32(hash(vec3u(tile, train)) >> 8u) / 16777216.0;
    return InWindow(found.x, found.yz, there * shares.x * shares.y, chance);
}

// All trains at a place, and how much of the windows' energy has been found. Each train is as high as its windows say; where two have it, its
// phase goes from the one's to the other's, like that of phasor noise: their sum would be as high as chance has it, for good.
// Where the sea is not theirs, `unwanted`, the first stands for all. As in lib/waves.wgsl, the loop ends at its foot. `group`: `group_of` them.
struct AllTrains { sum: Trains, found: f32, group: Metres, way: vec2f }

// Σ A e^{iθ} of each train, and its wave vector.
alias SingleTrains = array<vec4f, SHORE_TRAINS>;

// Waves break along crests that are longer than those of a sum of sines: a steep one draws what is beside it along, and bores overtake each other.
const LONG_CRESTED: f32 = 5.0;   // over which groups are the same along the crest, of the waves' 1/k in deep water: ours
const MOST_FREEDOM: f32 = 3.0;   // by which of what is left of groups their spread is made up for

// Amplitude of the trains' group at a place, whose crest runs `along` a unit vector: the square of their sum's, smoothed along the crest, with as many low and
// high ones as before: a sum of squares with so many degrees of freedom is made one with two (E. Wilson and M. Hilferty 1931).
fn group_of(single: ptr<function, SingleTrains>, along: vec2f, unwanted: bool) -> Metres {
    let omega = bitcast<f32>(shore_words[0].x);
    let longer = LONG_CRESTED * GRAVITY / (omega * omega);
    var energy = 0.0;
    var smoothed = 0.0;
    var spread = 0.0;
    var t = 0u;
    loop {
        let one = (*single)[t];
        let square = dot(one.xy, one.xy);
        energy += square;
        smoothed += square;
        spread += square * square;
        var before = 0u;
        loop {
            let other = (*single)[before];
            let apart = longer * dot(one.zw - other.zw, along);
            let same = select(0.0, 2.0 * exp(-0.5 * min(apart * apart, 60.0)), before < t);
            smoothed += same * dot(one.xy, other.xy);
            spread += 0.5 * same * same * square * dot(other.xy, other.xy);
            before++;
            if (before >= t) | unwanted { break; }
        }
        t++;
        if (t == SHORE_TRAINS) | unwanted { break; }
    }
    let freedom = clamp(energy * energy / max(spread, 1e-12), 1.0, MOST_FREEDOM);
    let root = pow(max(smoothed / max(energy, 1e-9), 0.0), 1.0 / 3.0);
    let exponential = max(8.0 / 9.0 + sqrt(freedom) * (root - 1.0) + inverseSqrt(freedom) / 9.0, 0.0);
    return sqrt(energy * exponential * exponential * exponential);
}

// `plain`: the depth that there is but for coral reefs, of which the windows hold what these add to the phase.
fn trains_at(point: MapPoint, depth: Metres, plain: Metres, shore: Metres, face: f32, footprint: Metres, unwanted: bool) -> AllTrains {
    let place = among_windows(point);
    let is_alone = !any(place.beyond > vec2f(0.0));
    let h = max(depth, SHALLOWEST);
    let usual = max(plain, SHALLOWEST);
    // Of the way to the shore, a plane beach's part and that of Dean's profile.
    let plane = min(usual / face, max(shore, 0.0));
    let curved = max(shore, 0.0) - plane;
    var all = AllTrains(NO_TRAINS, 0.0, 0.0, vec2f(0.0));
    var single: SingleTrains;
    var mean_way = vec2f(1e-9, 0.0);
    var t = 0u;
    loop {
        let about = bitcast<vec2f>(shore_words[1u + 2u * t]);
        let now = bitcast<f32>(shore_words[2u + 2u * t].x);
        let u = about.x * about.x * h / GRAVITY;
        let v = about.x * about.x * usual / GRAVITY;
        let regular = -(plane * PHASE_ADDED * hyperbolic(2.0 * sqrt(v) / PHASE_ADDED)
            + curved * 1.5 * PHASE_ADDED_BY_DEAN * (1.0 - exp(-v / PHASE_ADDED_BY_DEAN)) * inverseSqrt(v)) / usual;
        var wave = vec2f(0.0);
        var way = vec2f(0.0);
        var energy = 0.0;
        var found = 0.0;
        var k = 0u;
        loop {
            let own = in_window(place, k, t);
            let turns = (now - own.rest - regular) / WHOLE_TURN + own.chance;
            let turn = sine_cosine(WHOLE_TURN * (turns - floor(turns) - 0.5));
            let size = length(own.way);
            wave -= sqrt(own.energy) * size * vec2f(turn.cosine, turn.sine);
            way += own.energy * size * own.way;
            energy += own.energy * size * size;
            found += own.energy;
            k++;
            if (k == 4u) | is_alone { break; }
        }
        let k_here = u / (h * sqrt(hyperbolic(u)));
        let seen = 1.0 - smoothstep(0.12, 0.4, footprint * k_here / WHOLE_TURN);
        let height = about.y * sqrt(energy);
        let whole = height / max(length(wave), 1e-6) * wave;
        let drawn = seen * whole;
        let steep = k_here / max(length(way), 1e-9) * way * vec2f(1.0, -1.0);
        single[t] = vec4f(whole, steep);
        mean_way += height * height / k_here * steep;
        all.sum.z += drawn;
        all.sum.cosines += steep * drawn.x;
        all.sum.sines += steep * drawn.y;
        all.sum.hidden += 0.5 * height * height * k_here * k_here * (1.0 - seen * seen);
        all.found = found;
        t++;
        if (t == SHORE_TRAINS) | unwanted { break; }
    }
    all.way = normalize(mean_way);
    all.group = group_of(&single, vec2f(-all.way.y, all.way.x), unwanted);
    return all;
}

// Depth in which waves `deep` high break, which grow as those of the frequency `growing` do, of a shore that falls by `falls`, where it is h deep, with
// so much of Dean's profile in it: whose slope goes with the inverse root of the depth; their height over that depth, the slope there, and how far they are bores.
struct Breaking { depth: Metres, index: f32, slope: f32, bore: f32 }

fn breaking_of(deep: Metres, omega: f32, growing: f32, h: Metres, falls: f32, dean: f32) -> Breaking {
    let begun = min(h / (USUALLY_BREAKS * max(deep, 1e-6)), 1.0);
    let steep = max(falls * pow(begun, 0.5 * dean), 0.01);
    let slope = min(steep, 0.1);
    let index = breaker_index(slope, deep, omega);
    let depth = breaking_depth(deep, growing * growing / GRAVITY, index);
    return Breaking(depth, index, slope, bore_in(h / max(depth, 1e-3), similarity(steep, index * depth, omega)));
}

const FRONT_PARTS = 1.47;        // 4 ln 10 / 2π: of a shape's parts the one that is four fronts long has a tenth
const TOP_AHEAD = 0.4;           // of the sum's crest, radians: where white water begins
const FACE_AHEAD = 1.7;          // the surface of a bore (`wave_surface`) is up to its mean at 1.57, and highest at 1.02
const USUALLY_BREAKS = 1.4;      // depths in which waves break over their heights in deep water; as src/model/surf.rs

// The waves of the trains where a footprint shows them.
// `face`: the slope of the beach; `plain`: the depth but for coral reefs; `left`: what these leave of the waves' height; `front`: the width of
// the narrowest front that shows.
fn shore_waves_at(point: MapPoint, depth: Metres, plain: Metres, left: f32, shore: Metres, face: f32, distance: Metres, footprint: Metres, front: Metres) -> ShoreWaves {
    let wanted = trains_share(depth, shore, distance) * select(0.0, 1.0, point.square == MERCATOR);
    let all = trains_at(point, depth, plain, shore, face, footprint, wanted <= 0.0);
    let omega = bitcast<f32>(shore_words[0].x);
    let growing = bitcast<f32>(shore_words[SHORE_TABLE - 1u].y);
    let h = max(depth, SHALLOWEST);
    let k_deep = omega * omega / GRAVITY;
    let y = depth_number(k_deep * h);
    let size = length(all.sum.z);
    let share = wanted * all.found;
    let deep = 2.0 * size * left * sqrt(wanted);
    let plane = min(h / face, max(shore, 0.0));
    let curved = max(shore, 0.0) - plane;
    let falls = h / max(plane + 1.5 * curved, 1.0);
    let dean = curved / max(plane + curved, 1e-9);
    let own = breaking_of(deep, omega, growing, h, falls, dean);
    let grown = deep * shoaling(depth_number(growing * growing / GRAVITY * h));
    let height = select(grown, min(grown, own.index * own.depth * broken_height(h / own.depth, own.slope, own.index)), h < own.depth);
    let bore = own.bore;
    let white = breaking_of(2.0 * all.group * left * sqrt(wanted), omega, growing, h, falls, dean).bore;
    let turn = all.sum.z / max(size, 1e-6);
    var shape = wave_shape(height, y, h, bore, frame.chop);
    // Its n-th part has r to the n-th of the first's height. Narrower fronts than pixels would be rows of dots along a crest.
    shape.x = min(shape.x, exp(-FRONT_PARTS * front * y / h));
    // The shape begins with a rise, the sum with a crest.
    let surface = wave_surface(shape, vec2f(-turn.y, turn.x));
    let local = (turn.x * all.sum.cosines + turn.y * all.sum.sines) / max(size, 0.2 * deep + 1e-4);
    let steepest = 2.0 * y / h;
    let k = local * min(steepest / max(length(local), 1e-6), 1.0);
    let growth = (turn.x * all.sum.sines - turn.y * all.sum.cosines) / max(size, 1e-4);
    let half = 0.5 * height;
    let tilt = half * (-surface.y * k + (1.0 - bore) * surface.x * growth);
    let theta = angle_of(turn.y, turn.x);
    // A crest that begins to break is white from its top on, a bore from a quarter up its face, which is steep and comes before the sum's crest.
    let ahead = mix(TOP_AHEAD, FACE_AHEAD, white);
    let since = theta + ahead + select(0.0, WHOLE_TURN, theta < -ahead);
    return ShoreWaves(half * surface.x, tilt, white * smoothstep(0.02, 0.1, share), since / omega, height, share, wanted * left * left * all.sum.hidden, all.way);
}

// What the trains leave of the sea at a place: of the first and the second patch, and of the height of all.
fn left_by_trains(sea: LocalSea, share: f32) -> LocalSea {
    let taken = bitcast<f32>(shore_words[SHORE_TABLE - 1u].x);
    let left = sqrt(max(1.0 - vec3f(TRAINS_TAKE_FIRST, TRAINS_TAKE_SECOND, taken) * share, vec3f(0.0)));
    return LocalSea(sea.gains * vec4f(left.xy, 1.0, 1.0), sea.height * left.z);
}
