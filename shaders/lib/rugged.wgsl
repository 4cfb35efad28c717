// How much relief the ground has that its elevation data do not hold, as src/model/rugged.rs: see there why; and that relief.
#import ground_slope
#import relief
#import towers

const CELL_PIXELS: f32 = 8.0;    // along a cell of the ground's mesh where it has relief, at most; as src/scene/view/map_tiles.rs

const LIFT_SEEN = vec2f(1000.0, 4000.0);   // widths of pixels between which raised islands are no longer seen, metres
const DROWNED_SEEN = vec2f(150.0, 600.0);  // and drowned hills, which are a few hundred metres wide

// Values of three by three texels as a quadratic B-spline weighs them at a place: mean, standard deviation, and how the mean rises to the
// right and down on the map, of a texel.
struct Weighed { mean: f32, deviation: f32, rise: vec2f }

fn weighed(n: Neighbours) -> Weighed {
    let middle = n.rows[1].y;
    let a = n.rows[0] - middle;
    let b = n.rows[1] - middle;
    let c = n.rows[2] - middle;
    let wx = spline(n.t.x);
    let wy = spline(n.t.y);
    let rows = vec3f(dot(wx, a), dot(wx, b), dot(wx, c));
    let mean = dot(wy, rows);
    let square = dot(wy, vec3f(dot(wx, a * a), dot(wx, b * b), dot(wx, c * c)));
    let rx = spline_rise(n.t.x);
    let rise = vec2f(dot(wy, vec3f(dot(rx, a), dot(rx, b), dot(rx, c))), dot(spline_rise(n.t.y), rows));
    return Weighed(middle + mean, sqrt(max(square - mean * mean, 0.0)), rise);
}

// What the data tell of a place, smooth over kilometres: vertices look it up, pixels interpolate it. `raw`: strength for the data's slope;
// `island`: how far the place is one of an island's that the data have lost; `inland`: how far the ocean's shore is, smoothly, as it counts there; `way`: slope of the
// data, east and north; `out`: the same of `inland`; `drowned`: how steep hills are that the sea has drowned.
struct Country { raw: Metres, mean: Metres, island: f32, inland: Metres, way: vec2f, out: vec2f, drowned: f32 }

const NO_COUNTRY = Country(0.0, 0.0, 0.0, 0.0, vec2f(0.0), vec2f(0.0), 0.0);

// Beds count as the sea's level: a deep sea beside a plain makes no mountains of it.
fn weighed_land(n: Neighbours) -> Weighed {
    let sea = vec3f(0.0);
    return weighed(Neighbours(mat3x3f(max(n.rows[0], sea), max(n.rows[1], sea), max(n.rows[2], sea)), n.t));
}

fn high_latitude(sin_lat: f32) -> f32 { return smoothstep(RUGGED_HIGH_LATITUDES.x, RUGGED_HIGH_LATITUDES.y, abs(sin_lat)); }

// How far the shelf about a place is so deep that ice has left rock on it.
fn deep_shelf(point: MapPoint) -> f32 {
    return smoothstep(RUGGED_SHELF_DEPTHS.x, RUGGED_SHELF_DEPTHS.y, -bilinear(false, point, pages_at(point, RUGGED_SHELF_LEVEL).terrain).x);
}

// How far ice has scoured the coasts about a place down to rock, 0 to 1: those of deep shelves and before mountains.
fn scoured_coast(point: MapPoint, sin_lat: f32) -> f32 {
    let high = high_latitude(sin_lat);
    if high <= 0.0 { return 0.0; }
    let bold = weighed_land(neighbours(false, point, pages_at(point, RUGGED_SHELF_LEVEL).terrain)).deviation;
    return high * max(deep_shelf(point), smoothstep(RUGGED_BOLD.x, RUGGED_BOLD.y, bold));
}

fn country_at(point: MapPoint, sin_lat: f32) -> Country {
    let page = pages_at(point, RUGGED_LEVEL).terrain;
    let texel = texel_metres(point, f32(page.level), sin_lat);
    let data = weighed_land(neighbours(false, point, page));
    let slope = data.deviation / (0.5 * texel);
    let rounding = 0.5 * min(data.mean / 16.0, 32.0) / texel;
    let high = smoothstep(700.0, 1500.0, data.mean);
    let ice = max(smoothstep(0.866, 0.9, -sin_lat), high * smoothstep(0.85, 0.92, sin_lat));
    let least = RUGGED_LEAST_SLOPE + rounding + RUGGED_ICE_SLOPE * ice;

    let shore_page = pages_at(point, RUGGED_SHORE_LEVEL).water;
    let shore_texel = texel_metres(point, f32(shore_page.level), sin_lat);
    let shore = weighed(neighbours(true, point, shore_page));
    let coarse_page = pages_at(point, RUGGED_ISLAND_LEVEL).terrain;
    let coarse = bilinear(false, point, coarse_page).x;
    let deep = smoothstep(0.5, 0.95, -100.0 * coarse / texel_metres(point, f32(coarse_page.level), sin_lat));
    let rocky = RUGGED_SHELF * (1.0 - smoothstep(RUGGED_KNOWN.x, RUGGED_KNOWN.y, data.mean)) * high_latitude(sin_lat) * deep_shelf(point);
    // On these the way inland counts for short stretches alone.
    let x = -shore.mean * shore_texel;
    let flattening = 1.0 + x * x / (RUGGED_ROCKY_WIDE * RUGGED_ROCKY_WIDE);
    let root = sqrt(flattening);
    let share = rocky / max(rocky + deep, 1e-3);
    return Country(RUGGED_GAIN * slope * smoothstep(least, 2.5 * least, slope), data.mean, max(deep, rocky),
        mix(x, x / root, share), east_north_of(point, data.rise * vec2f(1.0, -1.0)) / texel,
        mix(1.0, 1.0 / (flattening * root), share) * east_north_of(point, shore.rise * vec2f(-1.0, 1.0)),
        drowned_at(point, sin_lat, coarse));
}

// How steep drowned hills are at a place about which the mean of land and sea is so high.
fn drowned_at(point: MapPoint, sin_lat: f32, mean: Metres) -> f32 {
    let hills = weighed_land(neighbours(false, point, pages_at(point, DROWNED_LEVEL).terrain));
    let broken = weighed(neighbours(true, point, pages_at(point, DROWNED_SHORE_LEVEL).water));
    return drowned_rise(broken, hills.deviation, mean, sin_lat);
}

// How far the tropics' towers are all that stands on drowned hills.
fn tropical_share(sin_lat: f32) -> f32 { return 1.0 - smoothstep(TOWERS_LATITUDES.x, TOWERS_LATITUDES.y, abs(sin_lat)); }

// How far a place is one of towers of limestone, its bed too.
fn towers_share(drowned: f32, sin_lat: f32) -> f32 { return tropical_share(sin_lat) * smoothstep(0.0, 0.5, drowned); }

// How steep hills are that the sea has drowned, by the distances to the shore, texels, by how much the land about deviates, and by the mean of land and sea.
fn drowned_rise(shore: Weighed, hills: Metres, mean: Metres, sin_lat: f32) -> f32 {
    let broken = 1.0 - smoothstep(DROWNED_BROKEN.x, DROWNED_BROKEN.y, shore.deviation);
    let near = 1.0 - smoothstep(DROWNED_INLAND.x, DROWNED_INLAND.y, -shore.mean);
    let towers = 1.0 - smoothstep(TOWERS.x, TOWERS.y, abs(sin_lat));
    return mix(DROWNED_RISE.x, DROWNED_RISE.y, towers) * broken * near * smoothstep(DROWNED_HILLS.x, DROWNED_HILLS.y, hills)
        * smoothstep(DROWNED_SEA.x, DROWNED_SEA.y, mean);
}

// How far the ground of such hills is raised so far from the shore itself, and how that rises by metres inland and by what there is of towers, of `share`.
fn drowned_lift(rise: f32, inland: Metres, elevation: Metres, towers: f32, share: f32) -> vec3f {
    let x = max(inland, 0.0);
    let flattening = 1.0 + x * x / (DROWNED_WIDE * DROWNED_WIDE);
    let root = sqrt(flattening);
    let foot = min(x / DROWNED_FOOT, 1.0);
    let begun = foot * foot * (3.0 - 2.0 * foot);
    let begins = 6.0 * foot * (1.0 - foot) / DROWNED_FOOT;
    let walls = 1.0 + x * x / (TOWERS_WALL * TOWERS_WALL);
    let wall_root = sqrt(walls);
    let beach = min(x / TOWERS_FOOT, 1.0);
    let stands = beach * beach * (3.0 - 2.0 * beach) * x / (wall_root * TOWERS_WALL);
    let stands_rise = (beach * beach * (3.0 - 2.0 * beach) / (walls * wall_root) + 6.0 * beach * (1.0 - beach) / TOWERS_FOOT * x / wall_root) / TOWERS_WALL;
    let high = share * TOWERS_HIGH / DROWNED_RISE.y;
    let tall = mix(TOWERS_FLOOR, 1.0, towers);
    let lack = max(rise * ((1.0 - share) * begun * x / root + high * stands * tall) - max(elevation, 0.0), 0.0);
    let raised = lack / (lack + DROWNED_SOFT);
    return vec3f(raised * lack, raised * (2.0 - raised) * rise * vec2f((1.0 - share) * (begun / (flattening * root) + begins * x / root) + high * stands_rise * tall,
        high * stands * (1.0 - TOWERS_FLOOR)));
}

// Strength of the relief of ground at an elevation, `lift` of it raised.
fn strength_of(country: Country, elevation: Metres, lift: Metres) -> Metres {
    let raw = country.raw + RUGGED_LIFT_GAIN * lift;
    let bounded = raw / (1.0 + raw / RUGGED_MOST);
    let most = RUGGED_OF_HEIGHT * max(elevation, RUGGED_OF_MEAN * country.mean);
    return smoothstep(0.0, RUGGED_LOW, elevation) * bounded * most / max(bounded + most, 1.0);
}

fn far_from_seam(sin_lat: f32) -> f32 { return smoothstep(0.0, RUGGED_SEAM_FADE, abs(abs(sin_lat) - POLAR_SIN_LAT)); }

// What there is of all but drowned hills that is made this near to shores and to the border of the maps.
fn made_share(sin_lat: f32, ground: Ground) -> f32 {
    return smoothstep(0.0, RUGGED_OCEAN_FADE, -ground.ocean_shore) * smoothstep(0.0, RUGGED_LAKE_FADE, -ground.lake_shore) * far_from_seam(sin_lat);
}

// How far the ground of such an island is raised, and how that rises by metres inland.
fn island_lift(island: f32, inland: Metres, elevation: Metres) -> vec2f {
    let x = max(inland, 0.0);
    let flattening = 1.0 + x * x / (RUGGED_ISLAND_WIDE * RUGGED_ISLAND_WIDE);
    let root = sqrt(flattening);
    let lack = max(island * RUGGED_ISLAND_RISE * x / root - max(elevation, 0.0), 0.0);
    let raised = lack / (lack + RUGGED_ISLAND_SOFT);
    return vec2f(raised * lack, raised * (2.0 - raised) * island * RUGGED_ISLAND_RISE / (flattening * root));
}

fn earth_from_local(d: vec3f) -> vec3f {
    let m = meridian_from_local(d);
    return vec3f(m.x * frame.meridian.x - m.y * frame.meridian.y, m.x * frame.meridian.y + m.y * frame.meridian.x, m.z);
}

// Where a normal that differs by `dn` from that of the eye's foot lies in the relief's lattices.
fn relief_place(dn: vec3f) -> vec3u {
    return frame.relief_eye + bitcast<vec3u>(vec3i(round(clamp(earth_from_local(dn) * RELIEF_UNITS, vec3f(-2.1e9), vec3f(2.1e9)))));
}

// Height over the data's, and slope east and north, metres a metre. `hollow`: from -1 in valleys to 1 on summits. `whole`: 1 where the relief is
// that of hills or more, 0 on plains. `towers`: how far it is of towers of limestone; `carved`: of a volcano's valleys; `about`: `whole` of the country about it, down to its shores.
struct Made { height: Metres, slope: vec2f, hollow: f32, whole: f32, towers: f32, carved: f32, about: f32 }

const NO_RELIEF = Made(0.0, vec2f(0.0), 0.0, 0.0, 0.0, 0.0, 0.0);

// The relief of the ground at a place as one sees it who sees no smaller than `footprint`.
fn made_relief(country: Country, point: MapPoint, dn: vec3f, sin_lat: f32, ground: Ground, footprint: Metres) -> Made {
    let share = made_share(sin_lat, ground);
    // Pixels so wide show no islands' heights; nor need the texels that tell of them be at hand there.
    let seen = 1.0 - smoothstep(LIFT_SEEN.x, LIFT_SEEN.y, footprint);
    let lift = seen * share * island_lift(country.island, country.inland, ground.elevation);
    let island = ground.elevation + lift.x;
    let stands = (1.0 - smoothstep(DROWNED_SEEN.x, DROWNED_SEEN.y, footprint)) * smoothstep(0.0, DROWNED_LAKE_FADE, -ground.lake_shore) * far_from_seam(sin_lat);
    let tropical = tropical_share(sin_lat);
    let towers = towers_at(point.at, footprint, tropical * country.drowned <= 0.0);
    let drowned = stands * drowned_lift(country.drowned, -ground.ocean_shore, island, towers.height, tropical);
    let elevation = island + drowned.x;
    let strong = share * strength_of(country, island, lift.x) + DROWNED_ROUGH * drowned.x * smoothstep(0.0, RUGGED_LOW, elevation);
    let rains = mix(1.0, CARVED_DRY, smoothstep(TOWERS.x, TOWERS.y, abs(sin_lat)));
    let carved = rains * share * country.island * (1.0 - high_latitude(sin_lat)) * smoothstep(0.25 * RELIEF_GULLIED, RELIEF_GULLIED, strong);
    let up = earth_from_local(dn + vec3f(0.0, 0.0, 1.0));
    let east = normalize(vec3f(-up.y, up.x, 0.0) + vec3f(0.0, 1e-9, 0.0));
    let north = cross(up, east);
    let lifted = lift.y * country.out;
    let way = country.way + lifted;
    let found = relief(relief_place(dn), up, way.x * east + way.y * north, strong, carved, footprint);
    let room = max(select(RUGGED_HIGHEST - elevation, elevation, found.height < 0.0), 0.01);
    let part = 1.0 / (1.0 + abs(found.height) / room);
    // What relief there is on drowned hills rises with them, and valleys have the less room the lower these are.
    let rises = 1.0 + part * part * DROWNED_ROUGH * found.height / max(strong, 1.0) - select(0.0, (1.0 - part) * (1.0 - part), found.height < 0.0);
    let by_towers = drowned.z * towers.rise * vec2f(1.0, -1.0) / texel_metres(point, f32(24u - TOWERS_BITS), sin_lat);
    let up_drowned = rises * (drowned.y * east_north_of(point, ground.shore_rise * vec2f(-1.0, 1.0)) + by_towers);
    let slope = part * part * vec2f(dot(found.slope, east), dot(found.slope, north)) + lifted + up_drowned;
    return Made(lift.x + drowned.x + found.height * part, slope, clamp(found.height / (strong + 1.0), -1.0, 1.0),
        smoothstep(0.0, RELIEF_GULLIED, strong), towers_share(country.drowned, sin_lat), carved, far_from_seam(sin_lat) * smoothstep(0.0, RELIEF_GULLIED, country.raw));
}
