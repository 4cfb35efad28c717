// What stands on built-up ground: lots side by side in blocks between streets, each with a house as high as its town is dense, or a garden; every house is made up.
// Long, but one thing: what a sight over a town meets, from the lot to its light by day and night.
#import built_up
#import cells

const LOT_LEVEL = 19u;                  // cells of 21 m at the equator, 15 m at 45°, of lattices turned
const LOT_TURNS = array<vec2i, 4>(vec2i(3, 2), vec2i(3, -1), vec2i(2, 3), vec2i(4, 1));  // so in districts of about a kilometre
const BLOCK = vec2u(7u, 3u);            // in bits: lots of a block and the street beside it, less one
const LOTS_CROSSED = 9u;                // that a sight crosses at most
const LOTS_AROUND = 8.0;                // farther away none is seen before a place, nor is its shadow
const LOT_CROSSED_MOST = 5.0;           // how far, in lots, a sight goes while it sinks by the highest house's height, at most
const HOUSES = vec2f(0.55, 0.97);       // share of the lots of villages and of cities' hearts that have one
const APART = vec2f(0.17, 0.03);        // and how far these stand from their lots' edges, of a lot
// Of sixteen blocks so many, in this order, are one building, are green, have houses side by side along a street, and along the other; others have houses by themselves.
const BLOCK_KINDS = vec4u(1u, 1u, 5u, 2u);
const ONE_BUILDING_TO = 0.8;            // how high such are, at most, in lots
const ROAD = 0.27;                      // half of a road's width, in lots, as its street is wide,
const MAIN_ROAD = 0.42;                 // and of every fourth road's
const ROADS = 0.64;                     // of streets, a mean
const PAVEMENT = vec3f(0.165, 0.16, 0.15);
const STREET_TREES = vec2f(0.75, 0.4);  // of squares of half a lot with nothing on them, those with a tree, in villages and in cities' hearts,
const CROWNS = vec2f(0.26, 0.45);       // their crowns' radii, of such a square,
const CROWNS_TAKE = 0.4;                // and how much of it a crown takes
const TREE_HEIGHT = 0.35;               // of a lot
const LEAVES = vec3f(0.035, 0.056, 0.022);
const UNDER_EYE = 0.6;                  // of the eye's height, that of the highest houses about it, at most
const ASPHALT = vec3f(0.085, 0.085, 0.088);
const TILES = vec3f(0.23, 0.115, 0.068);// red roofs,
const TILES_WEST_EAST = vec4f(0.47, 0.48, 0.60, 0.63);   // of the map, where most are of these: from Portugal to the Black Sea,
const TILES_LATITUDES = vec4f(0.53, 0.60, 0.78, 0.82);   // sines,
const CLAY_WEST_EAST = vec4f(0.18, 0.21, 0.405, 0.415);  // and where half of them are: in Latin America
const CLAY_LATITUDES = vec4f(-0.62, -0.57, 0.42, 0.47);
const STREETS = 0.34375;                // of the ground: 1 - 7/8 x 3/4, see BLOCK
const PAVED_YARDS = 0.75;               // of the ground between houses and roads, in cities' hearts
const WALLS = vec3f(0.31, 0.295, 0.265);
const LOTS_HIDDEN = vec2f(0.45, 1.1);   // widths of pixels, of a lot, between which no house shows any more
const WINDOWS = vec2f(5.0, 4.0);        // floors and windows of a wall to a lot,
const GLASS = vec2f(0.42, 0.5);         // how much of each they take, and what they reflect of what the wall does
const GLASS_BANDS = vec2f(0.80, 0.70);  // and in strips from floor to floor and in bands
const WINDOWS_SEEN = vec2f(0.1, 0.03);  // widths of pixels that show none and all of them, of a lot
const BOUNCES = 0.16;                   // of the sun's light, what houses throw into each other's shadow
const WALL_SKY = 0.8;                   // of the sky's light, that of walls,
const STREET_SKY = 0.85;                // and of streets and yards between houses
const DUSK = vec2f(-0.02, -0.12);       // sines of the sun's elevation between which lamps are lit; as src/pass/city_lights.rs
const STREET_LIGHT = 0.003;             // radiance of lit streets, and
const LAMP_LIGHT = 0.045;               // of their lamps, of the sun's irradiance beyond the air, as dense as cities' hearts are; pictures of nights are exposed for moonless land
const WINDOW_LIGHT = 0.012;             // and of lit windows
const LIT_TOWNS = vec2f(0.6, 1.5);             // how much of that towns have, and the midst of great cities
const LAMPS = 0.11;                     // radius of what a lamp lights brightest, of a lot
const MEAN_WALLS = 0.54;                // of what is seen of houses, a mean: as near pictures from above have them
const MEAN_SUN = 0.64;                  // of the sun's light on level ground, what houses, walls and streets have of it where they do not show
const MEAN_SKY = 0.88;                  // and of the sky's

// How a district's lots are turned.
fn lots_turn(at: vec2u) -> vec2i {
    let side = vec2f(map_noise_rise(at, 15u, 93u).x, map_noise_rise(at, 15u, 94u).x) > vec2f(0.0);
    return select(select(LOT_TURNS[0], LOT_TURNS[1], side.x), select(LOT_TURNS[2], LOT_TURNS[3], side.x), side.y);
}

// What stands on a lot: height in lots, none on streets and in gardens, its random word and its block's, how high it would be before a low eye, how far from the lot's edges
// it ends, and whether it is part of a building as large as the block, or of houses side by side, to the right and left or up and down.
struct Lot { height: f32, street: bool, word: u32, block: u32, full: f32, apart: vec2f, is_part: bool, is_row: vec2<bool> }

// `way`: how far, in lots, its middle lies from the place that `town` tells of, whose edges are the lattice's.
fn lot_of(at: vec2u, way: vec2f, town: BuiltUp) -> Lot {
    let cell = at & vec2u((1u << LOT_LEVEL) - 1u);
    let block = hash(vec3u(cell >> vec2u(3u, 2u), 99u));
    let is_part = is_kind(block, 0u, BLOCK_KINDS.x);
    let rows_from = BLOCK_KINDS.x + BLOCK_KINDS.y;
    let is_row = vec2<bool>(is_kind(block, rows_from, BLOCK_KINDS.z), is_kind(block, rows_from + BLOCK_KINDS.z, BLOCK_KINDS.w));
    let in_block = cell & BLOCK;
    let street = any(in_block == vec2u(0u));
    let word = select(hash(vec3u(cell, 98u)), block, is_part && !street);
    let u = f32((word >> 8u) & 255u) / 255.0;
    let edges = town.edges;
    // A large building is judged as a whole.
    let to_middle = way + select(vec2f(0.0), vec2f(4.0, 2.0) - vec2f(in_block), is_part);
    let reach = select(vec2f(0.0), vec2f(3.0, 1.0), is_part);
    let stays = all(edges.values + to_middle.x * edges.right + to_middle.y * edges.down > reach.x * abs(edges.right) + reach.y * abs(edges.down));
    let stands = is_part | ((f32(word & 255u) < 255.0 * mix(HOUSES.x, HOUSES.y, town.dense)) & !is_green(block));
    let few = u * u * u * u;
    let high = mix(HIGH.x * (0.5 + 0.5 * u), mix(HIGH.y, HIGH.z, town.tall) * (0.16 + 0.25 * u + 0.59 * few * u * u), town.dense * town.dense);
    let full = select(high, min(high, ONE_BUILDING_TO), is_part);
    let apart = select(vec2f(mix(APART.x, APART.y, town.dense)), vec2f(0.0), vec2<bool>(is_part) | is_row);
    return Lot(select(0.0, min(full, town.most), stands && stays && !street), street, word, block, full, apart, is_part, is_row);
}

// Whether a block is one of `count` kinds of the sixteen.
fn is_kind(block: u32, first: u32, count: u32) -> bool { return ((block & 15u) >= first) & ((block & 15u) < first + count); }

fn is_green(block: u32) -> bool { return is_kind(block, BLOCK_KINDS.x, BLOCK_KINDS.y); }

// How much of a place is road; `f`: where in its lot it is; `sees`: the width of a pixel on the ground, in lots.
fn road_at(at: vec2u, f: vec2f, sees: f32) -> f32 {
    let cell = at & vec2u((1u << LOT_LEVEL) - 1u);
    let wide = select(vec2f(ROAD), vec2f(MAIN_ROAD), ((cell >> vec2u(3u, 2u)) & vec2u(3u)) == vec2u(0u));
    let soft = max(0.5 * sees, 0.02);
    let found = smoothstep(wide + soft, wide - soft, abs(f - 0.5));
    return max(select(0.0, found.x, (cell.x & BLOCK.x) == 0u), select(0.0, found.y, (cell.y & BLOCK.y) == 0u));
}

// How much of a place is under a tree's crown, were nothing else there; `place`: lots from the corner of the lot `own`; `sees`: as above.
fn crown_at(own: vec2u, place: vec2f, share: f32, sees: f32) -> f32 {
    let square = floor(2.0 * place);
    let cell = (2u * own + bitcast<vec2u>(vec2i(square))) & vec2u((2u << LOT_LEVEL) - 1u);
    let word = hash(vec3u(cell, 101u));
    let bytes = vec4f((vec4u(word) >> vec4u(0u, 8u, 16u, 24u)) & vec4u(255u)) / 255.0;
    let radius = mix(CROWNS.x, CROWNS.y, bytes.x);
    let middle = 0.5 + (0.5 - radius) * (2.0 * bytes.yz - 1.0);
    let soft = max(sees, 0.06);
    let found = smoothstep(radius + soft, radius - soft, length(2.0 * place - square - middle));
    return select(0.0, mix(found, CROWNS_TAKE, smoothstep(0.2, 0.6, sees)), bytes.w < share);
}

// Its roof's albedo; `tiled`: which share is red.
fn roof_of(word: u32, tiled: f32) -> vec3f {
    let u = f32((word >> 16u) & 255u) / 255.0;
    let grey = (0.09 + 0.29 * u * u) * mix(vec3f(1.05, 1.0, 0.94), vec3f(0.97, 1.0, 1.04), f32((word >> 4u) & 15u) / 15.0);
    return select(grey, TILES * (0.65 + 0.7 * u), f32(word >> 24u) < 255.0 * tiled);
}

// What walls reflect, of their mean: plaster, sandstone, brick and glass.
const WALL_KINDS = array<vec3f, 4>(vec3f(1.20, 1.20, 1.18), vec3f(1.10, 1.05, 0.97), vec3f(0.90, 0.83, 0.77), vec3f(0.80, 0.92, 1.08));
const TILED_TO = 1.3;                   // height of the highest houses with tiled roofs, in lots,
const ROOF_GABLE = 0.7;                 // and how steep these are
const ROOF_RIM = vec2f(0.05, 1.2);      // how wide flat roofs' rims are, of a lot, and how bright, of the roof;
const ON_ROOF = vec3f(0.3, 0.13, 0.5);  // what stands on half of them: how far their middle is from a lot's edge at least, half their width, and how bright

// Of built-up ground: its albedo; how much of it is no garden; how far a house stands there for certain; how much of the sun's and the sky's light on level ground it
// and the gardens beside it have; what it shines by night.
struct Houses { albedo: vec3f, cover: f32, stands: f32, sun: f32, sky: f32, shines: vec3f }

// How far lamps are lit where it is day or night.
fn lamps_lit(up: vec3f) -> f32 {
    return select(0.0, frame.night * smoothstep(DUSK.x, DUSK.y, dot(frame.sun, up)), (frame.layers & SHOWS_LIGHTS) != 0u);
}

fn within(edges: vec4f, x: f32) -> f32 { return smoothstep(edges.x, edges.y, x) * smoothstep(edges.w, edges.z, x); }

fn tiled_at(at: vec2u, sin_lat: f32) -> f32 {
    let x = f32(at.x >> 8u) / 16777216.0;
    let tiles = within(TILES_WEST_EAST, x) * within(TILES_LATITUDES, sin_lat);
    let clay = within(CLAY_WEST_EAST, x) * within(CLAY_LATITUDES, sin_lat);
    return max(mix(0.12, 0.75, tiles), 0.5 * clay);
}

// `sight` and `sun`: how far these move right and down on the map while they sink by one; `eye`: how high it is above the ground, which is no more than a
// picture: no house is higher than most of that; `across`: of a pixel that faces the eye; `may_stand`: whether any may be there; `green`: how green the country is.
fn houses(p: FinePoint, built: BuiltUp, sin_lat: f32, green: f32, sight_on_map: vec2f, sun_on_map: vec2f, eye: Metres, across: Metres, may_stand: bool) -> Houses {
    var town = built;
    let turn = lots_turn(p.at);
    let dense = town.dense;
    let lot_width = EARTH_TURN * max(frame.cos_lat, 0.1) / (exp2(f32(LOT_LEVEL)) * length(vec2f(turn)));
    town.most = UNDER_EYE * max(eye, 0.0) / lot_width;
    let top = max(min(mix(HIGH.x, mix(HIGH.y, HIGH.z, town.tall), dense * dense), town.most), 0.01);
    let to_right = in_lattice(vec2f(1.0, 0.0), turn) * lot_width;
    let down = in_lattice(vec2f(0.0, 1.0), turn) * lot_width;
    town.edges.right = built.edges.right * to_right.x + built.edges.down * down.x;
    town.edges.down = built.edges.right * to_right.y + built.edges.down * down.y;
    // All of a house is behind the beach.
    town.edges.values.z -= 0.5 * lot_width;
    let nothing = !may_stand | any(town.edges.values + LOTS_AROUND * (abs(town.edges.right) + abs(town.edges.down)) < vec4f(0.0));
    let sight = sight_in_lattice(sight_on_map, turn, top, LOT_CROSSED_MOST);
    let sun = in_lattice(sun_on_map, turn);
    let stands = celled(p, turn, LOT_LEVEL);
    let own = stands.own;
    let f = stands.f;
    let tiled = tiled_at(p.at, sin_lat);
    let sees = across / lot_width;
    // From the lot where the sight comes in at the height of the highest to that of the place.
    var walk = walk_from(f - sight * top, sight);
    let middle = 0.5 - f;
    var lot = lot_of(own, middle, town);
    var met = 0.0;
    var wall = vec2f(0.0);
    var i = 0u;
    loop {
        let other = lot_of(own + bitcast<vec2u>(vec2i(walk.cell)), walk.cell + middle, town);
        // The sight is at f - sight h where it is h high: over the house from the lower to the higher of these.
        let safe = select(sight, vec2f(1e-4), abs(sight) < vec2f(1e-4));
        let one = (f - walk.cell - other.apart) / safe;
        let two = (f - walk.cell - 1.0 + other.apart) / safe;
        let leaves = max(max(min(one.x, two.x), min(one.y, two.y)), 0.0);
        let comes = min(max(one.x, two.x), max(one.y, two.y));
        let is_met = (comes > leaves) & (other.height > leaves) & (other.height > 0.0);
        if is_met {
            lot = other;
            met = min(other.height, comes);
            let by_x = max(one.x, two.x) < max(one.y, two.y);
            wall = select(vec2f(0.0), select(vec2f(0.0, -walk.ways.y), vec2f(-walk.ways.x, 0.0), by_x), comes < other.height);
        }
        let is_last = min(walk.next.x, walk.next.y) >= top;
        walk = walked(walk);
        i++;
        if nothing || sees > LOTS_HIDDEN.y || is_met || is_last || i >= LOTS_CROSSED { break; }
    }
    let is_house = (met > 0.0) & !nothing;
    let here = f - sight * met;
    // A house before the sun.
    var lit = 1.0;
    for (var k = 1u; k <= 3u; k++) {
        let over = f32(k * k) * 0.09 * top;
        let place = here - sun * over;
        let other = lot_of(own + bitcast<vec2u>(vec2i(floor(place))), floor(place) + middle, town);
        let shades = (other.height > met + over) & all(abs(fract(place) - 0.5) < 0.5 - other.apart);
        lit = select(lit, 0.0, shades);
    }
    let on_wall = any(wall != vec2f(0.0));
    let faces = clamp(-dot(sun, wall), 0.0, 1.5);
    let may_be_tiled = select(0.0, tiled, (lot.full < TILED_TO) & !lot.is_part);
    let roof = roof_of(lot.word, may_be_tiled);
    // Tiled roofs are gables along one way or the other; flat ones have rims, but where the next roof begins, and something stands on them.
    let kind = hash(vec3u(lot.word, 97u, 0u));
    let closely = 1.0 - smoothstep(0.04, 0.16, sees);
    let in_lot = fract(here) - 0.5;
    let along_x = (((kind & 4u) == 0u) | lot.is_row.x) & !lot.is_row.y;
    let is_gable = f32(lot.word >> 24u) < 255.0 * may_be_tiled;
    let leans = select(sign(in_lot.x) * sun.x, sign(in_lot.y) * sun.y, along_x);
    let gable = clamp((1.0 - ROOF_GABLE * leans) / sqrt(1.0 + ROOF_GABLE * ROOF_GABLE), 0.0, 1.8);
    let is_rim = any((abs(in_lot) > 0.5 - lot.apart - ROOF_RIM.x) & (lot.apart > vec2f(0.0)));
    let box_at = (ON_ROOF.x - 0.5) + (1.0 - 2.0 * ON_ROOF.x) * vec2f(vec2u(kind >> 10u, kind >> 13u) & vec2u(7u)) / 7.0;
    let is_on_roof = all(abs(in_lot - box_at) < vec2f(ON_ROOF.y)) & ((kind & 8u) != 0u) & !lot.is_part;
    let furnished = mix(1.0, select(select(1.0, ON_ROOF.z, is_on_roof), ROOF_RIM.y, is_rim), closely);
    let is_roof = is_house & !on_wall;
    let bits = ((vec4u(kind) >> vec4u(16u, 17u, 20u, 21u)) & vec4u(1u)) == vec4u(1u);
    let walls = WALLS * select(select(WALL_KINDS[0], WALL_KINDS[1], bits.x), select(WALL_KINDS[2], WALL_KINDS[3], bits.x), bits.y);
    // Between houses there are roads, paved yards, gardens and trees, all flat; trees cast shadows where they stand.
    let lies = sees * sqrt(sqrt(1.0 + dot(sight, sight)));
    let tree_share = mix(STREET_TREES.x, STREET_TREES.y, dense) * smoothstep(0.0, 0.4, green);
    let road = road_at(own, f, lies);
    let crown = crown_at(own, f, tree_share, lies) * (1.0 - road);
    let stem = f - TREE_HEIGHT * sun;
    let lot_of_tree = own + bitcast<vec2u>(vec2i(floor(stem)));
    let has_tree = lot_of(lot_of_tree, floor(stem) + middle, town).height <= 0.0;
    let tree_shade = crown_at(own, stem, select(0.0, tree_share, has_tree & !is_house), lies) * (1.0 - road_at(lot_of_tree, fract(stem), lies)) * (1.0 - crown);
    let yard = (1.0 - road - crown) * select(PAVED_YARDS * dense, 0.0, is_green(lot.block) && !lot.street);
    let open = (road * ASPHALT + crown * LEAVES + yard * PAVEMENT) / max(road + crown + yard, 1e-3);
    var albedo = select(select(open, roof * select(furnished, 1.0, is_gable), is_house), walls, on_wall);
    // Its windows: how high, how far along.
    let along = dot(fract(here), abs(wall.yx));
    let pane = vec2f(met, along) * WINDOWS;
    // Panes apart, bands of them, or strips.
    let of_panes = select(vec2f(sqrt(GLASS.x)), select(vec2f(GLASS.x, 1.0), vec2f(1.0, GLASS.x), bits.z), bits.w);
    let in_glass = all(abs(fract(pane) - 0.5) < 0.5 * of_panes);
    let reflects = select(GLASS.y, select(GLASS_BANDS.x, GLASS_BANDS.y, bits.z), bits.w);
    let glazed = mix(1.0 - GLASS.x * (1.0 - reflects), select(1.0, reflects, in_glass), smoothstep(WINDOWS_SEEN.x, WINDOWS_SEEN.y, sees));
    albedo *= select(1.0, glazed, on_wall);
    let sunlit = mix(BOUNCES, 1.0, lit * select(select(1.0 - tree_shade, gable, is_roof & is_gable), faces, on_wall));
    let sky = select(select(STREET_SKY, 1.0, is_house), WALL_SKY, on_wall);
    let paved = select(road + crown + yard, 1.0, is_house);
    // Of lots that do not show their mean is left, and of blocks that of blocks.
    let toned = 1.0 + (1.0 - smoothstep(0.3, 1.0, sees / 5.0)) * 0.35 * (f32(lot.block >> 24u) / 127.5 - 1.0);
    let narrowed = 1.0 - 2.0 * mix(APART.x, APART.y, dense);
    let greens = (1.0 - STREETS) * f32(BLOCK_KINDS.y) / 16.0;
    let of_blocks = vec3f(vec3u(BLOCK_KINDS.x, BLOCK_KINDS.z + BLOCK_KINDS.w, 16u - BLOCK_KINDS.x - BLOCK_KINDS.y - BLOCK_KINDS.z - BLOCK_KINDS.w)) / 16.0;
    let covers = (1.0 - STREETS) * (of_blocks.x + mix(HOUSES.x, HOUSES.y, dense) * dot(of_blocks.yz, vec2f(narrowed, narrowed * narrowed)));
    let roads = STREETS * ROADS;
    let crowns = (1.0 - covers - roads) * tree_share * CROWNS_TAKE;
    let yards = (1.0 - covers - roads - crowns - greens) * PAVED_YARDS * dense;
    let mean_cover = covers + roads + crowns + yards;
    let mean_roof = mix(vec3f(0.187), TILES, tiled * (1.0 - (1.0 - STREETS) * of_blocks.x / covers));
    let mean_flat = (covers * mean_roof + roads * ASPHALT + crowns * LEAVES + yards * PAVEMENT) / mean_cover;
    let mean_albedo = mix(mean_flat, WALLS, MEAN_WALLS * covers / mean_cover);
    let whole = 1.0 - smoothstep(LOTS_HIDDEN.x, LOTS_HIDDEN.y, sees);
    // A lamp in the middle of every second lot of a street, yellow or white; behind some windows of walls there is light.
    let warmth = mix(vec3f(1.0, 0.62, 0.27), vec3f(1.0, 0.86, 0.66), f32(lot.block & 255u) / 255.0);
    let lamp = LAMP_LIGHT * (1.0 - smoothstep(LAMPS, LAMPS + max(sees, 0.1), length(fract(here) - 0.5))) * min(LAMPS / max(sees, 0.1), 1.0);
    let on_street = select(0.0, (1.0 - crown) * STREET_LIGHT + select(0.0, lamp, (lot.word & 1u) == 0u), lot.street && !is_house);
    let window = hash(vec3u(lot.word, bitcast<vec2u>(vec2i(floor(pane)))));
    let shining = select(on_street * warmth, vec3f(1.0, 0.8, 0.55) * select(0.0, WINDOW_LIGHT, (window & 3u) == 0u), on_wall);
    let mean_shining = (STREETS * (STREET_LIGHT + 0.5 * LAMP_LIGHT * PI * LAMPS * LAMPS) + 0.02 * WINDOW_LIGHT) * warmth;
    let shines = toned * toned * toned * mix(0.25, 1.0, dense) * mix(LIT_TOWNS.x, LIT_TOWNS.y, town.tall) * mix(mean_shining, shining, whole);
    return Houses(toned * mix(mean_albedo, albedo, whole), mix(mean_cover, paved, whole), select(0.0, whole, is_house), mix(mix(1.0, MEAN_SUN, mean_cover), sunlit, whole), mix(mix(1.0, MEAN_SKY, mean_cover), sky, whole), shines);
}
