// How steep the ground is, by the terrain tile that is at hand.
#import world

// A direction on the map, right and up, as east and north: the same on Mercator's square, on a polar one turned with the longitude.
fn east_north_of(point: MapPoint, way: vec2f) -> vec2f {
    if point.square == MERCATOR { return way; }
    let from_middle = vec2f(bitcast<vec2i>(point.at - vec2u(0x80000000u))) * vec2f(1.0, -1.0);
    let out = from_middle / max(length(from_middle), 1.0);
    return vec2f(dot(way, vec2f(-out.y, out.x)), dot(way, out) * select(1.0, -1.0, point.square == NORTH));
}

// Elevations of three texels of a row, or distances to the ocean's shore.
fn texel_row(water: bool, square: u32, level: u32, columns: vec3u, row: u32, tile: vec2u, page: Page) -> vec3f {
    return vec3f(texel(water, square, level, vec2u(columns.x, row), tile, page).x,
        texel(water, square, level, vec2u(columns.y, row), tile, page).x,
        texel(water, square, level, vec2u(columns.z, row), tile, page).x);
}

// What the nine texels around a place hold, by rows, and where it is.
struct Neighbours { rows: mat3x3f, t: vec2f }

fn neighbours(water: bool, point: MapPoint, page: Page) -> Neighbours {
    let nine = nine_texels(point, page);
    return Neighbours(mat3x3f(texel_row(water, point.square, page.level, nine.columns, nine.rows.x, nine.tile, page),
        texel_row(water, point.square, page.level, nine.columns, nine.rows.y, nine.tile, page),
        texel_row(water, point.square, page.level, nine.columns, nine.rows.z, nine.tile, page)), nine.t);
}

// Rise of the terrain tiles' elevation right and down on the map, metres a texel of the page: that of a quadratic B-spline over them, which
// has no creases.
fn terrain_rise(point: MapPoint, page: Page) -> vec2f {
    let n = neighbours(false, point, page);
    return vec2f(dot(spline_rise(n.t.x) * n.rows, spline(n.t.y)), dot(spline(n.t.x) * n.rows, spline_rise(n.t.y)));
}

// Slope of the terrain's tiles at a point: metres per metre east and north.
fn terrain_slope(point: MapPoint, sin_lat: f32, footprint: Metres) -> vec2f {
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    let page = pages_at(point, level_for(point, footprint, cos_lat)).terrain;
    let rise = terrain_rise(point, page) * vec2f(1.0, -1.0) / texel_metres(point, f32(page.level), sin_lat);
    return east_north_of(point, rise);
}

// How much of it the ground has: it is flat on the beach, where it is shaped to the shore.
fn slope_shown(ground: Ground) -> f32 {
    return select(1.0, smoothstep(0.0, frame.terrain_resolution / 3.0, abs(ground.ocean_shore)), !ground.is_ocean);
}
