// Where land stands in the sea's way: how much higher the waves of each patch are than the open sea's. The nodes, their windows and what they
// hold are src/scene/sea/shelter.rs's.
#import map

struct Sheltered {
    windows: array<vec4u, SHELTER_LEVELS>,      // of a level: the map's point in its middle, bits of its nodes, SHELTER_KNOWN or _OPEN
    nodes: array<vec2u>,                        // 16 bits each: gains of three patches, how much the node counts
}

@group(1) @binding(14) var<storage, read> sheltered: Sheltered;

const SHELTER_KNOWN = 1u;
const SHELTER_OPEN = 2u;

// The sea at a place: its waves over the open sea's, by patch, and all together.
struct LocalSea { gains: vec4f, height: f32 }

const OPEN_SEA = LocalSea(vec4f(1.0), 1.0);

// Gains of a node times how much it counts, and that.
fn shelter_node(level: u32, node: vec2u, share: f32) -> vec4f {
    let at = (level * SHELTER_SIDE + (node.y & (SHELTER_SIDE - 1u))) * SHELTER_SIDE + (node.x & (SHELTER_SIDE - 1u));
    let words = sheltered.nodes[at];
    let first = unpack2x16unorm(words.x);
    let second = unpack2x16unorm(words.y);
    return share * second.y * vec4f(SHELTER_MOST_GAIN * vec3f(first, second.x), 1.0);
}

fn local_sea(point: MapPoint) -> LocalSea {
    var gains = vec3f(0.0);
    var open = select(0.0, 1.0, point.square == MERCATOR);
    var level = 0u;
    loop {
        let window = sheltered.windows[level];
        let shift = 32u - (window.z & 31u);
        let unit = f32(1u << (shift & 31u));
        let away = abs(vec2f(bitcast<vec2i>(point.at - window.xy))) / unit;
        let reach = max(away.x, away.y) / f32(SHELTER_SIDE / 2u);
        let corner = point.at >> vec2u(shift & 31u);
        let f = vec2f(point.at & vec2u((1u << (shift & 31u)) - 1u)) / unit;
        var found = shelter_node(level, corner, (1.0 - f.x) * (1.0 - f.y)) + shelter_node(level, corner + vec2u(1u, 0u), f.x * (1.0 - f.y))
            + shelter_node(level, corner + vec2u(0u, 1u), (1.0 - f.x) * f.y) + shelter_node(level, corner + vec2u(1u, 1u), f.x * f.y);
        found = select(found, vec4f(1.0), window.w == SHELTER_OPEN);
        let known = select(0.0, 1.0, (window.w != 0u) & (found.w > SHELTER_LEAST_KNOWN));
        let weight = open * known * (1.0 - smoothstep(0.75, 0.93, reach));
        gains += weight * found.xyz / max(found.w, 1e-6);
        open -= weight;
        level++;
        if level == SHELTER_LEVELS || open <= 0.0 { break; }
    }
    // Where nothing is known it is the open sea.
    let left = select(1.0, open, point.square == MERCATOR);
    let all = vec4f(gains + left, 1.0);
    return LocalSea(all, select(1.0, sqrt(dot(all * all, frame.cascade_shares)), frame.wave_height > 0.0));
}
