// Surf, as white water on a flat sea: where waves break on a shore, how much of the water is white, and in which crests that come in one
// after another. Waves keep their period and run at the speed of shallow water, so that the time a crest still has to the shore is its phase;
// waves of a group are as high as Rayleigh has it, each along its own reach of the shore.
#import world
#import noise

const SURF_FRONT: f32 = 0.9;          // seconds for which it is dense
const SURF_WIDEST: Metres = 1500.0;   // no shore is so far from its surf
const SHELTER_FROM: Metres = 400.0;   // up wind the shore's distance is looked up from here on, each time as far as it allows
const SHELTER_TAPS = 5;
const OPEN_FETCH: Metres = 6000.0;    // of water up wind from which on the sea is as high as in the open; ours
const LEAST_SURF: f32 = 0.06;         // share of the waves' height that reaches the lee

// Height of the waves that come in at a place: the sea's, less where the shore stands in the wind's way. For vertices: it changes slowly.
fn height_coming_in(point: MapPoint, sin_lat: f32, distance: Metres) -> Metres {
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0025));
    let speed = max(length(frame.wind), 1e-3);
    let up_wind = -frame.wind / speed;
    var reach = SHELTER_FROM;
    var open = 1.0;
    for (var i = 0; i < SHELTER_TAPS; i++) {
        let units = reach / (EARTH_TURN * cos_lat) * 4294967296.0;
        let at = point.at + bitcast<vec2u>(vec2i(clamp(units * up_wind * vec2f(1.0, -1.0), vec2f(-2.0e9), vec2f(2.0e9))));
        let page = pages_at(MapPoint(point.square, at), level_for(point, max(0.125 * reach, 40.0), cos_lat)).water;
        let shore = bilinear(true, MapPoint(point.square, at), page).x * texel_metres(point, f32(page.level), sin_lat);
        open *= smoothstep(0.0, 0.3 * reach, shore);
        reach += max(0.9 * shore, 0.0);
    }
    // Far away it goes by and by: pictures whose shores are farther have none.
    let farthest = SURF_SEEN + 2.0 * max(frame.eye_altitude, 0.0);
    let seen = smoothstep(farthest, 0.6 * farthest, distance) * smoothstep(SURF_HIGHEST, 0.6 * SURF_HIGHEST, frame.eye_altitude);
    let found = seen * frame.wave_height * max(open * sqrt(saturate(reach / OPEN_FETCH)), LEAST_SURF);
    // Towards the poles the map's north is not the wind's.
    return select(0.0, found, point.square == MERCATOR);
}

// Shares of the water under white water of any age, and under that of a crest that is just breaking. `incoming`: `height_coming_in`.
fn surf_at(point: MapPoint, shore: Metres, depth: Metres, incoming: Metres, footprint: Metres) -> vec2f {
    let deep = max(depth, 0.05);
    let period = frame.surf.x;
    let lasts = vec2f(frame.surf.w, SURF_FRONT);
    let over = frame.surf.z * deep / max(0.7071 * incoming, 1e-3);
    // The mean of all waves of a Rayleigh distribution (J. Battjes and J. Janssen 1978).
    let breaking = exp(-over * over) * smoothstep(SURF_WIDEST, 0.5 * SURF_WIDEST, shore) * smoothstep(0.02, 0.15, incoming);
    let speed = sqrt(9.81 * deep);
    let mean = breaking * lasts / period * (1.0 - exp(-period / lasts));
    // A crest is no straight line.
    let broad = map_noise(point.at, 18u, 61u);
    let phase = frame.surf.y + 2.0 * shore / (speed * period) + 1.4 * broad + 0.5 * map_noise(point.at, 20u, 62u) + 0.12 * map_noise(point.at, 22u, 63u);
    let wave = floor(phase);
    var bare = vec2f(1.0);
    for (var i = 0; i < 3; i++) {
        let salt = (u32(i32(wave) - i) & 4095u) + 70u;
        let height = incoming * (0.30 + 1.25 * map_noise(point.at, 17u, salt));
        let broken = smoothstep(0.85, 1.15, height / (1.4142 * frame.surf.z * deep));
        let age = (phase - wave + f32(i)) * period;
        bare *= 1.0 - broken * exp(-age / lasts);
    }
    let near = 1.0 - smoothstep(0.06, 0.25, footprint / (speed * period));
    let crests = (1.0 - bare) * min(4.0 * breaking, 1.0);
    return mix(mean, crests, near);
}
