// Surf: where waves break on a shore, and how much of the water is white. Near the eye the waves are those of the trains.
#import world
#import shore_trains

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

// Shares of the water under white water of any age, and under that of a crest that is just breaking: of the waves of the trains where these
// show, elsewhere and from afar the mean. `incoming`: `height_coming_in`.
fn surf_at(waves: ShoreWaves, shore: Metres, depth: Metres, incoming: Metres, footprint: Metres) -> vec2f {
    let deep = max(depth, 0.05);
    let period = frame.surf.x;
    let lasts = frame.surf.wy;
    let over = frame.surf.z * deep / max(0.7071 * incoming, 1e-3);
    // The mean of all waves of a Rayleigh distribution (J. Battjes and J. Janssen 1978).
    let breaking = exp(-over * over) * smoothstep(SURF_WIDEST, 0.5 * SURF_WIDEST, shore) * smoothstep(0.02, 0.15, incoming);
    let mean = breaking * lasts / period * (1.0 - exp(-period / lasts));
    // The white water of this crest, and of those before it, which have broken as often as those of this height do.
    let often = exp(-pow(frame.surf.z * deep / max(0.7071 * waves.height, 1e-3), 2.0));
    let older = exp(-(waves.age + period) / lasts);
    // A wave that has just begun to break is white along its crest alone.
    let torn = waves.bore * waves.bore;
    let crests = 1.0 - (1.0 - torn * exp(-waves.age / (lasts * mix(0.15, 1.0, torn)))) * (1.0 - torn * often * older);
    let near = waves.share * (1.0 - smoothstep(0.06, 0.25, footprint / (sqrt(9.81 * deep) * period)));
    return mix(mean, crests, near);
}
