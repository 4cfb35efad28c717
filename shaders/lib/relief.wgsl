// Ridges and valleys that the elevation data cannot hold, as src/model/relief.rs makes them: see there what they are and why.
#import hash
#import map

// Height over the data, and how it rises, metres a metre, along the earth's axes.
struct Relief { height: Metres, slope: vec3f }

fn relief_edge(octave: u32) -> Metres { return f32(1u << (RELIEF_BITS - octave)) / 256.0; }

// How much of an octave shows where one sees no smaller than a footprint.
fn relief_shown(octave: u32, footprint: Metres) -> f32 { return 1.0 - smoothstep(0.25, 0.5, footprint / relief_edge(octave)); }

// Sine of a number of turns, within 0.001.
fn turn_sine(turns: f32) -> f32 {
    let x = turns - floor(turns + 0.5);
    let s = x * (8.0 - 16.0 * abs(x));
    return s * (0.775 + 0.225 * abs(s));
}

// The simplex around a place in an octave's lattice: its first corner, the order of its axes, the way from the corner to the place in edges.
struct Simplex { corner: vec3u, rank: vec3u, way: vec3f }

fn simplex_at(at: vec3u, octave: u32) -> Simplex {
    let bits = RELIEF_BITS - octave;
    let whole = at >> vec3u(bits);
    let part = vec3f(at & vec3u((1u << bits) - 1u)) / f32(1u << bits);
    let sum = whole.x + whole.y + whole.z;
    let third = sum / 3u;
    let rest = f32(sum - 3u * third);
    let cell = floor(part + (rest + part.x + part.y + part.z) / 3.0);
    let v = part - cell + (rest + cell.x + cell.y + cell.z) / 6.0;
    let xy = select(0u, 1u, v.x >= v.y);
    let yz = select(0u, 1u, v.y >= v.z);
    let zx = select(0u, 1u, v.z > v.x);
    return Simplex(whole + third + vec3u(cell), vec3u(xy + 1u - zx, 1u - xy + yz, 1u - yz + zx), v);
}

struct Corner { word: u32, way: vec3f }

// A corner of a simplex, 0 to 3: its random word, and the way from it to the place.
fn simplex_corner(s: Simplex, octave: u32, corner: u32) -> Corner {
    let steps = select(vec3u(0u), vec3u(1u), s.rank + corner >= vec3u(3u));
    return Corner(hash((s.corner + steps) ^ vec3u(0u, 0u, octave << 24u)), s.way - vec3f(steps) + f32(corner) / 6.0);
}

// Gradient noise, about -1 to 1, and how it rises in an edge.
struct BroadNoise { height: f32, rise: vec3f }

fn broad_noise(at: vec3u, octave: u32) -> BroadNoise {
    let s = simplex_at(at, octave);
    var sum = 0.0;
    var rise = vec3f(0.0);
    for (var i = 0u; i < 4u; i++) {
        let c = simplex_corner(s, octave, i);
        let t = max(0.5 - dot(c.way, c.way), 0.0);
        let gradient = vec3f(vec3u(c.word, c.word >> 10u, c.word >> 20u) & vec3u(1023u)) / 511.5 - 1.0;
        let t2 = t * t;
        let along = dot(gradient, c.way);
        sum += t2 * t2 * along;
        rise += t2 * t2 * gradient - 8.0 * t2 * t * along * c.way;
    }
    return BroadNoise(RELIEF_NOISE_GAIN * sum, RELIEF_NOISE_GAIN * rise);
}

// A wave across a slope: cosine and sine of its phase, and how the phase rises in an edge, radians. `jitter`: as of src/model/relief.rs.
struct Gully { wave: vec2f, phase_rise: vec3f }

fn gully(at: vec3u, octave: u32, side: vec3f, jitter: f32) -> Gully {
    let s = simplex_at(at, octave);
    var sum = vec2f(0.0);
    var weights = 0.0;
    var rise_cosine = vec3f(0.0);
    var rise_sine = vec3f(0.0);
    for (var i = 0u; i < 4u; i++) {
        let c = simplex_corner(s, octave, i);
        let t = max(0.5 - dot(c.way, c.way), 0.0);
        let turns = RELIEF_WAVES * dot(side, c.way) + jitter * (f32(c.word >> 16u) / 65536.0 - 0.5);
        let wave = vec2f(turn_sine(turns + 0.25), turn_sine(turns));
        let t3 = t * t * t;
        sum += t3 * t * wave;
        weights += t3 * t;
        rise_cosine -= 8.0 * t3 * wave.x * c.way;
        rise_sine -= 8.0 * t3 * wave.y * c.way;
    }
    let power = dot(sum, sum) + 0.02 * weights * weights;
    return Gully(sum / sqrt(power), TURN * RELIEF_WAVES * side + (sum.x * rise_sine - sum.y * rise_cosine) / power);
}

// The relief at a place where the data rise by `slope` and hold a relief of their own of `strength`, as one sees it who sees no smaller than
// `footprint`. `carved`: how far the place is one of a volcano's. Loops end at their foot: where nothing is made each costs one octave.
fn relief(at: vec3u, up: vec3f, slope: vec3f, strength: Metres, carved: f32, footprint: Metres) -> Relief {
    var found = Relief(0.0, vec3f(0.0));
    let none = strength <= 0.0;
    var octave = 0u;
    loop {
        let n = broad_noise(at, octave);
        let weight = select(strength * (1.0 - CARVED_BROAD * carved) * relief_shown(octave, footprint) * select(RELIEF_SECOND, RELIEF_FIRST, octave == 0u), 0.0, none);
        // Ridges where the noise crosses zero, rounded; wide floors of valleys where it is far from it.
        let fold = sqrt(n.height * n.height + RELIEF_FOLD * RELIEF_FOLD);
        found.height += weight * (RELIEF_FOLD_MEAN - fold / (1.0 + fold));
        let rise = -weight / relief_edge(octave) * n.height / (fold * (1.0 + fold) * (1.0 + fold)) * n.rise;
        found.slope += rise - dot(rise, up) * up;
        octave++;
        if octave >= RELIEF_BROAD || none || relief_shown(octave, footprint) <= 0.0 { break; }
    }
    // Valleys down the data's own slope, between sharp ridges.
    var downhill = slope;
    octave = CARVED_FIRST;
    let steepness = length(slope) / sqrt(1.0 + dot(slope, slope) / (CARVED_STEEPEST * CARVED_STEEPEST));
    loop {
        let edge = relief_edge(octave);
        let g = gully(at, octave, cross(up, downhill) / sqrt(dot(downhill, downhill) + RELIEF_LEVEL * RELIEF_LEVEL), CARVED_JITTER);
        let bow = sqrt(max(0.5 - 0.5 * g.wave.x, 0.0) + CARVED_CREST * CARVED_CREST);
        let room = select(CARVED_FINER, CARVED_DEEP, octave == CARVED_FIRST) * edge * steepness;
        let deep = carved * relief_shown(octave, footprint) * room / (1.0 + room / max(CARVED_MOST * strength, 1e-3));
        found.height += deep * (CARVED_MEAN - bow);
        let all = -deep / edge * 0.25 * g.wave.y / bow * g.phase_rise;
        let rise = all - dot(all, up) * up;
        found.slope += rise;
        octave++;
        if octave >= CARVED_LAST || carved <= 0.0 || relief_shown(octave, footprint) <= 0.0 { break; }
    }
    downhill += found.slope;
    // Where it is nearly level no gully shows; none begins abruptly.
    let gullied = smoothstep(RELIEF_GENTLE, RELIEF_SLOPING, length(downhill)) * smoothstep(0.25 * RELIEF_GULLIED, RELIEF_GULLIED, strength);
    octave = RELIEF_BROAD;
    loop {
        let edge = relief_edge(octave);
        let shown = gullied * relief_shown(octave, footprint);
        let steep = length(downhill);
        let g = gully(at, octave, cross(up, downhill) / sqrt(steep * steep + RELIEF_LEVEL * RELIEF_LEVEL), RELIEF_JITTER);
        let deep = select(1.0, 1.0 - carved, octave < CARVED_LAST) * shown * RELIEF_DEEP * edge * steep / sqrt(1.0 + steep * steep / (RELIEF_STEEPEST * RELIEF_STEEPEST));
        found.height += deep * g.wave.x;
        let all = -deep / edge * g.wave.y * g.phase_rise;
        let rise = all - dot(all, up) * up;
        found.slope += rise;
        downhill += RELIEF_FOLLOWS * rise;
        octave++;
        if octave >= RELIEF_OCTAVES || gullied <= 0.0 || relief_shown(octave, footprint) <= 0.0 { break; }
    }
    return found;
}
