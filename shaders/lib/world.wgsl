// What the maps say of a place: the ground there, shaped to its shores, and how far these are.
#import map_texels
#import reefs

// Whether places may be seen that have coral reefs.
#usually REEFS = true;

// The chords of the ground's triangles bring it nearer by up to 0.4 % of the distance and 2 m: what is nearer than this stands in front of
// a sea whose surface is at a distance, and what is not is its bed.
fn nearest_bed(surface: Metres) -> Metres { return 0.996 * surface - 2.0; }

// How much nearer along a sight ground so high is than the ellipsoid behind it.
fn above_ellipsoid(elevation: Metres, direction: vec3f, up: vec3f) -> Metres { return elevation / max(-dot(direction, up), 0.05); }

struct Ground {
    elevation: Metres,      // of the dry or submarine ground, shaped to agree with the shore
    ocean_shore: Metres,    // signed distance, positive in the ocean
    lake_shore: Metres,     // signed distance, positive in lakes and rivers
    shore_rise: vec2f,      // how the distance to the ocean's grows right and down on the map
    texel: Metres,          // of the tile that tells these
    face: f32,              // slope of the beach where waves run up, or of what is there in its place
    cliff: f32,             // 0 a beach, 1 a cliff or a front of ice
    is_ocean: bool,
    is_lake: bool,          // or a river
    by_river: bool,         // whether the nearest inland water is one
    plain: Metres,          // its elevation but for coral reefs
    corals: vec2f,          // how far they cover it, and how far it is of their sand
    waves: f32,             // what reefs leave of the waves' height
}

// Metres on the ground per metre of the level-0 texel grid, at a point of a square.
fn texel_metres(point: MapPoint, level: f32, sin_lat: f32) -> Metres {
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    let polar = 2.0 * POLAR_EXTENT * 6378137.0 * (1.0 + abs(sin_lat));
    return select(polar, EARTH_TURN * cos_lat, point.square == MERCATOR) / (f32(TILE_TEXELS) * exp2(level));
}

// A point so many metres east and north of another, which is not far from it.
fn beside(point: MapPoint, sin_lat: f32, way: vec2f) -> MapPoint {
    let units = way * vec2f(1.0, -1.0) / max(texel_metres(point, 0.0, sin_lat), 1e-3) * 16777216.0;
    return MapPoint(point.square, point.at + bitcast<vec2u>(vec2i(units)));
}

// What the grid has around a place of four of its texels.
fn grid_of(cells: TexelsAround) -> vec3f {
    return amid(TexelsAround(grid_value(cells.a.x), grid_value(cells.b.x), grid_value(cells.c.x), grid_value(cells.d.x), cells.f));
}

fn level_at(point: MapPoint, sin_lat: f32, footprint: Metres) -> u32 {
    return level_for(point, footprint, sqrt(max(1.0 - sin_lat * sin_lat, 0.0)));
}

const REEFS_SEEN = vec2f(200.0, 800.0);   // widths of pixels between which coral reefs are no longer seen, metres

// Widths of pixels, in cells of the grid, from which its own values are trusted again beside a coast that it has elsewhere, and wholly: what pixels have of the cells around
// them is their vertices', which are then farther apart than cells.
const COASTS_APART = vec2f(0.06, 0.25);

// What it has around a place, and how far there is a coral reef. It is smooth over kilometres: vertices look it up, pixels interpolate it.
fn grid_at(point: MapPoint, sin_lat: f32, footprint: Metres) -> vec4f {
    var reefs = 0.0;
    if REEFS & (abs(sin_lat) < REEFS_WARM.y) & has_reefs() {
        let wide = pages_at(point, RUGGED_ISLAND_LEVEL).terrain;
        reefs = reef_share(point, sin_lat, bilinear(false, point, wide).x, texel_metres(point, f32(wide.level), sin_lat));
    }
    return vec4f(grid_of(texels_around(false, point, pages_at(point, min(level_at(point, sin_lat, footprint), grid_level())).terrain)), reefs);
}

// The ground at a place, around which the grid has so much.
fn ground_amid(point: MapPoint, sin_lat: f32, footprint: Metres, grid: vec4f) -> Ground {
    let found = pages_at(point, level_at(point, sin_lat, footprint));
    return ground_of(point, sin_lat, found.water, grid_of(texels_around(false, point, found.terrain)), grid.xyz, footprint, grid.w * smoothstep(REEFS_SEEN.y, REEFS_SEEN.x, footprint));
}

fn ground_at(point: MapPoint, sin_lat: f32, footprint: Metres) -> Ground {
    return ground_amid(point, sin_lat, footprint, grid_at(point, sin_lat, footprint));
}

// Where pixels are as wide as the grid's cells, so that these are the terrain's texels.
fn ground_from_afar(point: MapPoint, sin_lat: f32, footprint: Metres) -> Ground {
    let found = pages_at(point, level_at(point, sin_lat, footprint));
    let cells = grid_of(texels_around(false, point, found.terrain));
    return ground_of(point, sin_lat, found.water, cells, cells, footprint, 0.0);
}

// `nearest`: what the nearest texels have; `grid`: what the grid's cells have.
fn ground_of(point: MapPoint, sin_lat: f32, water_page: Page, nearest: vec3f, grid: vec3f, footprint: Metres, reefs: f32) -> Ground {
    var coast = coast_of(grid, sin_lat);
    coast.trust = max(coast.trust, smoothstep(COASTS_APART.x, COASTS_APART.y, footprint / max(frame.terrain_resolution, 1.0)));
    let water = shores_around(point, water_page);
    let texel = texel_metres(point, f32(water_page.level), sin_lat);
    var shores = water.told.xy * texel;
    // Without any water tile the sign of the elevation tells sea from land.
    if water_page.layer == 0u {
        shores = vec2f(select(-1e6, 1e6, nearest.x <= 0.0), -1e6);
    }
    let plain = shaped_elevation(elevation_at(nearest, shores.x), coast, shores.x);
    let trusted = min(frame.terrain_resolution, BED_WIDEST);
    // Waves that run up a lagoon's beach are the lagoon's.
    let none = !REEFS | (reefs <= 0.0) | (shores.x < -REEFS_ASHORE) | (shores.x > trusted);
    var built = plain;
    var corals = vec2f(0.0);
    var waves = 1.0;
    // Few pixels of the earth have any.
    if !none {
        let wide_page = pages_at(point, REEFS_WIDE_LEVEL).water;
        let told = wide_shore(point, wide_page, none) * texel_metres(point, f32(wide_page.level), sin_lat);
        let wide = select(told, shores.x, wide_page.layer == 0u);
        let reef = reef_at(reefs, point.at, sqrt(max(1.0 - sin_lat * sin_lat, 0.0)), wide, none);
        let depth = reef_depth(reef, shores.x, -plain, smoothstep(0.1 * trusted, trusted, shores.x), coast.far);
        built = select(plain, -depth, shores.x > 0.0);
        corals = select(vec2f(0.0), reef_cover(reef, shores.x), shores.x > 0.0);
        waves = reef_waves(reef, max(shores.x, 0.0));
    }
    return Ground(built, shores.x, shores.y, water.rise, texel, bed_steeper() * coast.m, coast.cliff,
        shores.x > 0.0, shores.y > 0.0 && shores.x <= 0.0, water.told.z > 0.5, plain, corals, waves);
}
