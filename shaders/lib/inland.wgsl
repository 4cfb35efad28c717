// Lakes and rivers. Who imports this declares MEASURED (src/pass/kind.rs).
#import shelter
#import shore_pixels
#import water

const LAKE_KIND = 2.5;             // of the water of lakes
const RIVER_KIND = 6.0;            // of rivers, which carry silt; ours
// What the wind raises over a few hundred metres: ripples, and a little of waves of 30 m.
const RIVER_SEA = LocalSea(vec4f(0.0, 0.0, 0.1, 1.0), 0.03);

const COURSE_LEVEL = 11u;          // of the water tiles that tell a river's course: texels of 76 m at the equator, wider than its banks are ragged
const COURSE_AROUND = 0.25;        // square of the distance in texels over which it is taken
// Ripples of a river: streaks that its water draws out along its course. Octaves of noise, the finest first, each so many times wider, their slope,
// and how far they are drawn out, cells each way; ours.
const STREAK_LEVEL = 24u;          // of the noise: 2.4 m at the equator
const STREAK_LEVELS = 2u;
const STREAK_OCTAVES = 2u;
const STREAK_SLOPE = 0.1;
const STREAK_LENGTH = 1.6;
const STREAK_STEPS = 5u;

// Right and down on the map across the course of the river around a place. Where its middle is the distance to its banks has no slope, so the square of the
// slope is averaged around.
fn across_course(point: MapPoint) -> vec2f {
    let page = pages_at(point, COURSE_LEVEL).water;
    let nine = nine_texels(point, page);
    let wx = spline(nine.t.x);
    let wy = spline(nine.t.y);
    let rx = spline_rise(nine.t.x);
    let ry = spline_rise(nine.t.y);
    let bend = vec3f(1.0, -2.0, 1.0);
    var rise = vec2f(0.0);
    var bent = vec3f(0.0);
    var k = 0u;
    loop {
        let at = vec2u(k % 3u, k / 3u);
        let away = texel(true, point.square, page.level, vec2u(nine.columns[at.x], nine.rows[at.y]), nine.tile, page).y;
        rise += away * vec2f(rx[at.x] * wy[at.y], wx[at.x] * ry[at.y]);
        bent += away * vec3f(bend[at.x] * wy[at.y], rx[at.x] * ry[at.y], wx[at.x] * bend[at.y]);
        k++;
        if k == 9u { break; }
    }
    let squares = vec3f(rise * rise, rise.x * rise.y)
        + COURSE_AROUND * vec3f(bent.x * bent.x + bent.y * bent.y, bent.y * bent.y + bent.z * bent.z, bent.y * (bent.x + bent.z));
    let twice = vec2f(squares.x - squares.y, 2.0 * squares.z);
    let turned = twice / max(length(twice), 1e-9);
    return normalize(select(vec2f(turned.y, 1.0 - turned.x), vec2f(1.0 + turned.x, turned.y), turned.x >= 0.0) + vec2f(1e-6, 0.0));
}

// Slope, east and north, of a river's ripples at a place whose course runs so, as far as a footprint shows them.
fn river_ripples(point: MapPoint, sin_lat: f32, along: vec2f, footprint: Metres) -> vec2f {
    let unit = texel_metres(point, 24.0, sin_lat);
    var sum = vec2f(0.0);
    var octave = 0u;
    loop {
        let level = STREAK_LEVEL - STREAK_LEVELS * octave;
        let cell = unit * f32(1u << (24u - level)) * 256.0;
        let seen = 1.0 - smoothstep(0.2, 0.6, footprint / cell);
        var k = 0u;
        loop {
            let off = STREAK_LENGTH * cell * (2.0 * f32(k) / f32(STREAK_STEPS - 1u) - 1.0);
            let rise = map_noise_rise(beside(point, sin_lat, off * along).at, level, 41u + octave).yz;
            sum += seen * STREAK_SLOPE / f32(STREAK_STEPS) * east_north_of(point, rise * vec2f(1.0, -1.0));
            k++;
            if k == STREAK_STEPS { break; }
        }
        octave++;
        if octave == STREAK_OCTAVES { break; }
    }
    return sum;
}

// The waves of an inland water, given those of a lake there.
fn on_river(lake: LocalSea, ground: Ground) -> LocalSea {
    var sea = lake;
    if ground.by_river { sea = RIVER_SEA; }
    return sea;
}

// A deep lake, or a river.
fn inland_water(at: vec3f, ground: Ground, direction: vec3f, up: vec3f, normal: vec3f, rough: vec2f, foam: Foam) -> WaterPoint {
    let kind = select(LAKE_KIND, RIVER_KIND, ground.by_river);
    return WaterPoint(at, -direction, up, normal, along_wind(up), rough, 1.0, kind, Bed(vec3f(0.0), 0.0, 1.0), foam, MEAN_FACETS, vec3f(0.0), NO_LAND);
}

// 1 ocean, 2 lake, 3 river, 0 land.
fn water_class(ground: Ground) -> f32 {
    return select(select(0.0, select(2.0, 3.0, ground.by_river), ground.is_lake), 1.0, ground.is_ocean);
}
