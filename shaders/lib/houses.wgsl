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
const UNDER_EYE = 0.6;                  // of the eye's height, that of the highest houses about it, at most
const ASPHALT = vec3f(0.085, 0.085, 0.088);
const TILES = vec3f(0.23, 0.115, 0.068);// red roofs,
const TILES_WEST_EAST = vec4f(0.47, 0.48, 0.60, 0.63);   // of the map, where most are of these: from Portugal to the Black Sea,
const TILES_LATITUDES = vec4f(0.53, 0.60, 0.78, 0.82);   // sines
const STREETS = 0.34375;                // of the ground: 1 - 7/8 x 3/4, see BLOCK
const PAVED_YARDS = 0.75;               // of the lots without a house, in cities' hearts
const WALLS = vec3f(0.25, 0.235, 0.21);
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
const MEAN_WALLS = 0.25;                // of what is seen of towns, a mean
const MEAN_SUN = 0.66;                  // of the sun's light on level ground, what houses, walls and streets have of it where they do not show
const MEAN_SKY = 0.88;                  // and of the sky's

// How a district's lots are turned.
fn lots_turn(at: vec2u) -> vec2i {
    let side = vec2f(map_noise_rise(at, 15u, 93u).x, map_noise_rise(at, 15u, 94u).x) > vec2f(0.0);
    return select(select(LOT_TURNS[0], LOT_TURNS[1], side.x), select(LOT_TURNS[2], LOT_TURNS[3], side.x), side.y);
}

// What stands on a lot: height in lots, none on streets and in gardens, its random word, and how high it would be before a low eye.
struct Lot { height: f32, street: bool, word: u32, full: f32 }

// `way`: how far, in lots, its middle lies from the place that `town` tells of, whose edges are the lattice's.
fn lot_of(at: vec2u, way: vec2f, town: BuiltUp) -> Lot {
    let cell = at & vec2u((1u << LOT_LEVEL) - 1u);
    let word = hash(vec3u(cell, 98u));
    let street = any((cell & BLOCK) == vec2u(0u));
    let u = f32((word >> 8u) & 255u) / 255.0;
    let edges = town.edges;
    let stands = (f32(word & 255u) < 255.0 * mix(HOUSES.x, HOUSES.y, town.dense)) & all(edges.values + way.x * edges.right + way.y * edges.down > vec4f(0.0));
    let few = u * u * u * u;
    let high = mix(HIGH.x * (0.5 + 0.5 * u), mix(HIGH.y, HIGH.z, town.tall) * (0.16 + 0.25 * u + 0.59 * few * u * u), town.dense * town.dense);
    return Lot(select(0.0, min(high, town.most), stands && !street), street, word, high);
}

// Its roof's albedo; `tiled`: which share is red.
fn roof_of(word: u32, tiled: f32) -> vec3f {
    let u = f32((word >> 16u) & 255u) / 255.0;
    let grey = (0.07 + 0.25 * u * u) * mix(vec3f(1.05, 1.0, 0.94), vec3f(0.97, 1.0, 1.04), f32((word >> 4u) & 15u) / 15.0);
    return select(grey, TILES * (0.65 + 0.7 * u), f32(word >> 24u) < 255.0 * tiled);
}

// What walls reflect, of their mean: plaster, sandstone, brick and glass.
const WALL_KINDS = array<vec3f, 4>(vec3f(1.20, 1.20, 1.18), vec3f(1.10, 1.05, 0.97), vec3f(0.90, 0.83, 0.77), vec3f(0.80, 0.92, 1.08));
const TILED_TO = 1.3;                   // height of the highest houses with tiled roofs, in lots,
const ROOF_GABLE = 0.7;                 // and how steep these are
const ROOF_RIM = vec2f(0.05, 1.2);      // how wide flat roofs' rims are, of a lot, and how bright, of the roof;
const ON_ROOF = vec3f(0.3, 0.13, 0.5);  // what stands on half of them: how far their middle is from a lot's edge at least, half their width, and how bright

// Of built-up ground: its albedo; how much of it is no garden; how far a house stands there for certain; how much of the sun's and the sky's light on level ground it
// has; what it shines by night.
struct Houses { albedo: vec3f, cover: f32, stands: f32, sun: f32, sky: f32, shines: vec3f }

// How far lamps are lit where it is day or night.
fn lamps_lit(up: vec3f) -> f32 {
    return select(0.0, frame.night * smoothstep(DUSK.x, DUSK.y, dot(frame.sun, up)), (frame.layers & SHOWS_LIGHTS) != 0u);
}

fn tiled_at(at: vec2u, sin_lat: f32) -> f32 {
    let x = f32(at.x >> 8u) / 16777216.0;
    let w = TILES_WEST_EAST;
    let l = TILES_LATITUDES;
    let here = smoothstep(w.x, w.y, x) * smoothstep(w.w, w.z, x) * smoothstep(l.x, l.y, sin_lat) * smoothstep(l.w, l.z, sin_lat);
    return mix(0.12, 0.75, here);
}

// `sight` and `sun`: how far these move right and down on the map while they sink by one; `eye`: how high it is above the ground, which is no more than a
// picture: no house is higher than most of that; `across`: of a pixel that faces the eye; `may_stand`: whether any may be there.
fn houses(p: FinePoint, built: BuiltUp, sin_lat: f32, sight_on_map: vec2f, sun_on_map: vec2f, eye: Metres, across: Metres, may_stand: bool) -> Houses {
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
    town.edges.values.z -= (0.5 - APART.y) * lot_width;
    let nothing = !may_stand | any(town.edges.values + LOTS_AROUND * (abs(town.edges.right) + abs(town.edges.down)) < vec4f(0.0));
    let sight = sight_in_lattice(sight_on_map, turn, top, LOT_CROSSED_MOST);
    let sun = in_lattice(sun_on_map, turn);
    let stands = celled(p, turn, LOT_LEVEL);
    let own = stands.own;
    let f = stands.f;
    let tiled = tiled_at(p.at, sin_lat);
    let sees = across / lot_width;
    let apart = mix(APART.x, APART.y, dense);
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
        let one = (f - walk.cell - apart) / safe;
        let two = (f - walk.cell - 1.0 + apart) / safe;
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
        let inside = abs(fract(place) - 0.5) < vec2f(0.5 - apart);
        let shades = (lot_of(own + bitcast<vec2u>(vec2i(floor(place))), floor(place) + middle, town).height > met + over) & all(inside);
        lit = select(lit, 0.0, shades);
    }
    let on_wall = any(wall != vec2f(0.0));
    let faces = clamp(-dot(sun, wall), 0.0, 1.5);
    let may_be_tiled = select(0.0, tiled, lot.full < TILED_TO);
    let roof = roof_of(lot.word, may_be_tiled);
    // Tiled roofs are gables along one way or the other; flat ones have rims, and something stands on them.
    let kind = hash(vec3u(lot.word, 97u, 0u));
    let closely = 1.0 - smoothstep(0.04, 0.16, sees);
    let in_lot = fract(here) - 0.5;
    let along_x = (kind & 4u) == 0u;
    let is_gable = f32(lot.word >> 24u) < 255.0 * may_be_tiled;
    let leans = select(sign(in_lot.x) * sun.x, sign(in_lot.y) * sun.y, along_x);
    let gable = clamp((1.0 - ROOF_GABLE * leans) / sqrt(1.0 + ROOF_GABLE * ROOF_GABLE), 0.0, 1.8);
    let is_rim = max(abs(in_lot.x), abs(in_lot.y)) > 0.5 - apart - ROOF_RIM.x;
    let box_at = (ON_ROOF.x - 0.5) + (1.0 - 2.0 * ON_ROOF.x) * vec2f(vec2u(kind >> 10u, kind >> 13u) & vec2u(7u)) / 7.0;
    let is_on_roof = all(abs(in_lot - box_at) < vec2f(ON_ROOF.y)) & ((kind & 8u) != 0u);
    let furnished = mix(1.0, select(select(1.0, ON_ROOF.z, is_on_roof), ROOF_RIM.y, is_rim), closely);
    let is_roof = is_house & !on_wall;
    let bits = ((vec4u(kind) >> vec4u(16u, 17u, 20u, 21u)) & vec4u(1u)) == vec4u(1u);
    let walls = WALLS * select(select(WALL_KINDS[0], WALL_KINDS[1], bits.x), select(WALL_KINDS[2], WALL_KINDS[3], bits.x), bits.y);
    var albedo = select(select(ASPHALT, roof * select(furnished, 1.0, is_gable), is_house), walls, on_wall);
    // Its windows: how high, how far along.
    let along = dot(fract(here), abs(wall.yx));
    let pane = vec2f(met, along) * WINDOWS;
    // Panes apart, bands of them, or strips.
    let of_panes = select(vec2f(sqrt(GLASS.x)), select(vec2f(GLASS.x, 1.0), vec2f(1.0, GLASS.x), bits.z), bits.w);
    let in_glass = all(abs(fract(pane) - 0.5) < 0.5 * of_panes);
    let reflects = select(GLASS.y, select(GLASS_BANDS.x, GLASS_BANDS.y, bits.z), bits.w);
    let glazed = mix(1.0 - GLASS.x * (1.0 - reflects), select(1.0, reflects, in_glass), smoothstep(WINDOWS_SEEN.x, WINDOWS_SEEN.y, sees));
    albedo *= select(1.0, glazed, on_wall);
    let sunlit = mix(BOUNCES, 1.0, lit * select(select(1.0, gable, is_roof & is_gable), faces, on_wall));
    let sky = select(select(STREET_SKY, 1.0, is_house), WALL_SKY, on_wall);
    // A garden, where neither house nor street is.
    let paved = select(select(PAVED_YARDS * dense, 1.0, lot.street), 1.0, is_house);
    // Of lots that do not show their mean is left, and of blocks that of blocks.
    let block = hash(vec3u((own & vec2u((1u << LOT_LEVEL) - 1u)) >> vec2u(3u, 2u), 99u));
    let toned = 1.0 + (1.0 - smoothstep(0.3, 1.0, sees / 5.0)) * 0.35 * (f32(block >> 24u) / 127.5 - 1.0);
    let covers = (1.0 - STREETS) * mix(HOUSES.x, HOUSES.y, dense);
    let mean_cover = covers + STREETS + (1.0 - STREETS - covers) * PAVED_YARDS * dense;
    let mean_roof = mix(vec3f(0.153), TILES, tiled);
    let mean_flat = (covers * mean_roof + (mean_cover - covers) * ASPHALT) / mean_cover;
    let mean_albedo = mix(mean_flat, WALLS, MEAN_WALLS);
    let whole = 1.0 - smoothstep(LOTS_HIDDEN.x, LOTS_HIDDEN.y, sees);
    // A lamp in the middle of every second lot of a street, yellow or white; behind some windows of walls there is light.
    let warmth = mix(vec3f(1.0, 0.62, 0.27), vec3f(1.0, 0.86, 0.66), f32(block & 255u) / 255.0);
    let lamp = LAMP_LIGHT * (1.0 - smoothstep(LAMPS, LAMPS + max(sees, 0.1), length(fract(here) - 0.5))) * min(LAMPS / max(sees, 0.1), 1.0);
    let on_street = select(0.0, STREET_LIGHT + select(0.0, lamp, (lot.word & 1u) == 0u), lot.street && !is_house);
    let window = hash(vec3u(lot.word, bitcast<vec2u>(vec2i(floor(pane)))));
    let shining = select(on_street * warmth, vec3f(1.0, 0.8, 0.55) * select(0.0, WINDOW_LIGHT, (window & 3u) == 0u), on_wall);
    let mean_shining = (STREETS * (STREET_LIGHT + 0.5 * LAMP_LIGHT * PI * LAMPS * LAMPS) + 0.02 * WINDOW_LIGHT) * warmth;
    let shines = toned * toned * toned * mix(0.25, 1.0, dense) * mix(LIT_TOWNS.x, LIT_TOWNS.y, town.tall) * mix(mean_shining, shining, whole);
    return Houses(toned * mix(mean_albedo, albedo, whole), mix(mean_cover, paved, whole), select(0.0, whole, is_house), mix(MEAN_SUN, sunlit, whole), mix(MEAN_SKY, sky, whole), shines);
}
