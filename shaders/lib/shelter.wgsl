// Where land stands in the sea's way: how much higher the waves of each patch are than the open sea's, and the levels of lakes. The nodes,
// their windows and what they hold are src/scene/sea/shelter.rs's.
#import map

struct Sheltered {
    windows: array<vec4u, SHELTER_LEVELS>,      // of a level: the map's point in its middle, bits of its nodes, 0 or what is known
    nodes: array<vec4u>,                        // 16 bits each: gains of three patches, how much the node counts, odd in lakes; level, margin
}

@group(1) @binding(14) var<storage, read> sheltered: Sheltered;

const SHELTER_OPEN = 2u;         // state of a window all over which the sea is open
const OF_OCEAN = 0u;
const OF_LAKE = 1u;
const NO_LEVEL: Metres = -1e6;

// The sea at a place: its waves over the open sea's, by patch, and all together.
struct LocalSea { gains: vec4f, height: f32 }

const OPEN_SEA = LocalSea(vec4f(1.0), 1.0);

// What nodes around a place know: gains times how much they count, and that; a lake's level and margin times that, and that.
struct Nodes { gains: vec4f, lake: vec3f }

fn with_node(sum: Nodes, level: u32, node: vec2u, share: f32, water: u32) -> Nodes {
    let at = (level * SHELTER_SIDE + (node.y & (SHELTER_SIDE - 1u))) * SHELTER_SIDE + (node.x & (SHELTER_SIDE - 1u));
    let words = sheltered.nodes[at];
    let first = unpack2x16unorm(words.x);
    let second = unpack2x16unorm(words.y);
    let own = share * second.y;
    let is_lake = (words.y >> 16u) & 1u;
    let counts = own * select(SHELTER_ON_LAND, 1.0, is_lake == water);
    let metres = vec2f(bitcast<f32>(words.z), bitcast<f32>(words.w));
    let lake = own * vec3f(metres, 1.0);
    return Nodes(sum.gains + counts * vec4f(SHELTER_MOST_GAIN * vec3f(first, second.x), 1.0),
        sum.lake + select(vec3f(0.0), lake, (is_lake == OF_LAKE) & (metres.x > NO_LEVEL)));
}

// What a level's nodes know of a water around a place, and how far out in their window that is.
struct Surrounding { nodes: Nodes, reach: f32 }

fn nodes_around(point: MapPoint, level: u32, water: u32) -> Surrounding {
    let window = sheltered.windows[level];
    let shift = (32u - window.z) & 31u;
    let unit = f32(1u << shift);
    let away = abs(vec2f(bitcast<vec2i>(point.at - window.xy))) / unit;
    let corner = point.at >> vec2u(shift);
    let f = vec2f(point.at & vec2u((1u << shift) - 1u)) / unit;
    var nodes = Nodes(vec4f(0.0), vec3f(0.0));
    nodes = with_node(nodes, level, corner, (1.0 - f.x) * (1.0 - f.y), water);
    nodes = with_node(nodes, level, corner + vec2u(1u, 0u), f.x * (1.0 - f.y), water);
    nodes = with_node(nodes, level, corner + vec2u(0u, 1u), (1.0 - f.x) * f.y, water);
    nodes = with_node(nodes, level, corner + vec2u(1u, 1u), f.x * f.y, water);
    nodes.gains = select(nodes.gains, vec4f(1.0), window.w == SHELTER_OPEN);
    let known = select(0.0, 1.0, window.w != 0u);
    return Surrounding(Nodes(known * nodes.gains, known * select(nodes.lake, vec3f(0.0), window.w == SHELTER_OPEN)),
        max(away.x, away.y) / f32(SHELTER_SIDE / 2u));
}

// The first level of which anything is known: eyes in space see none of what is finer. Processors run a loop's body for nothing.
fn finest_known() -> u32 {
    var level = SHELTER_LEVELS - 1u;
    for (var finer = SHELTER_LEVELS - 1u; finer > 0u; finer--) { level = select(level, finer - 1u, sheltered.windows[finer - 1u].w != 0u); }
    return level;
}

fn local_water(point: MapPoint, water: u32) -> LocalSea {
    var gains = vec3f(0.0);
    var open = select(0.0, 1.0, point.square == MERCATOR);
    var level = finest_known();
    loop {
        let found = nodes_around(point, level, water);
        let known = select(0.0, 1.0, found.nodes.gains.w > SHELTER_LEAST_KNOWN);
        let weight = open * known * (1.0 - smoothstep(0.75, 0.93, found.reach));
        gains += weight * found.nodes.gains.xyz / max(found.nodes.gains.w, 1e-6);
        open -= weight;
        level++;
        if level == SHELTER_LEVELS || open <= 0.0 { break; }
    }
    // Where nothing is known it is the open sea.
    let all = vec4f(gains + select(1.0, open, point.square == MERCATOR), 1.0);
    return LocalSea(all, select(1.0, sqrt(dot(all * all, frame.cascade_shares)), frame.wave_height > 0.0));
}

// Where reefs leave less of the waves.
fn behind_reefs(sea: LocalSea, left: f32) -> LocalSea { return LocalSea(sea.gains * vec4f(vec3f(left), 1.0), sea.height * left); }

fn local_sea(point: MapPoint) -> LocalSea { return local_water(point, OF_OCEAN); }

fn cascade_slopes(c: u32) -> vec2f {
    let pair = frame.cascade_slopes[c >> 1u];
    return select(pair.xy, pair.zw, (c & 1u) == 1u);
}

// Slope variance of a cascade's waves that are higher by a gain.
fn gained_slopes(sea: LocalSea, c: u32) -> vec2f { return sea.gains[c] * sea.gains[c] * cascade_slopes(c); }

// Slope variance of the whole sea.
fn local_slopes(sea: LocalSea) -> vec2f {
    return frame.below_slopes + gained_slopes(sea, 0u) + gained_slopes(sea, 1u) + gained_slopes(sea, 2u) + gained_slopes(sea, 3u);
}

// Level and margin of the lake or river around a place; NO_LEVEL where none is known.
fn lake_at(point: MapPoint) -> vec2f {
    var level = 0u;
    var found = vec3f(0.0);
    loop {
        let around = nodes_around(point, level, OF_LAKE);
        found = select(around.nodes.lake, vec3f(0.0), around.reach > 0.93);
        level++;
        if level == SHELTER_LEVELS || found.z > 0.0 { break; }
    }
    return select(vec2f(NO_LEVEL, 0.0), found.xy / max(found.z, 1e-9), (found.z > 0.0) & (point.square == MERCATOR));
}

// Of ground that is so much higher by the data other water is taken for this: as `margin_for` of src/model/lakes.rs.
fn margin_for(margin: Metres, by_river: bool) -> Metres {
    return select(margin, min(margin, RIVER_MARGIN), by_river & (margin < OWN_RIVER));
}

// An elevation at a distance from a lake's shore (positive in it), in the lake or beside it: as `shaped` of src/model/lakes.rs.
fn with_lake(elevation: Metres, lake_shore: Metres, lake: vec2f) -> Metres {
    let over = elevation - lake.x;
    let level = select(elevation, lake.x, over < lake.y);
    let out = smoothstep(0.0, LAKE_SHORE, -lake_shore);
    let others = smoothstep(LAKE_OF_MARGIN, 1.0, over / max(lake.y, 1.0));
    let least = min(-LAKE_RISE * lake_shore, LAKE_LEAST_RISE);
    let shore = max(out * over, least + out * min(over - least, 0.0));
    let shaped = select(mix(lake.x + shore, elevation, others), level, lake_shore > 0.0);
    return select(elevation, shaped, lake.x > NO_LEVEL);
}
