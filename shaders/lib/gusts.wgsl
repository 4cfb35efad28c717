// Gusts and lulls: patches of rougher and smoother water, longer along the wind than across it, which are all the relief that the sea
// shows from the air, and near the eye are of steeper and flatter ripples. They stay where they are on the map.
#import map
#import noise

const GUST_LENGTH = 3.0;          // along the wind, of the width across it
const GUST_DEVIATION = 0.35;      // of the logarithm of the slopes' variance
const GUST_LEVELS = 4u;           // of the noise: widths from GUST_WIDEST on, each a quarter of the one before
const GUST_WIDEST = 13u;          // map levels: a side over 2^13, 4.9 km at the equator
const RIPPLES_VARY = 0.5;         // variance of the slopes of ripples that are seen one by one, a deviation over the usual: as peaked as slopes were measured
const RIPPLE_LEVELS = 3u;
const RIPPLE_WIDEST = 19u;        // 76 m, so that they differ within 5 m
const RIPPLES_ON_CRESTS = 0.4;    // share of that by the long waves, which draw ripples together on their crests
const NOISE_DEVIATION = 0.17;     // of map_noise
const SIDE: Metres = 40075016.7;  // of the Mercator square at the equator

// Octaves of the noise at a point of the map as far as a footprint shows them: their sum in deviations, and the sum of the squares of how far.
fn gust_noise(point: MapPoint, sin_lat: f32, footprint: Metres, widest_level: u32, levels: u32) -> vec2f {
    let away = vec2f(bitcast<vec2i>(point.at - frame.mercator_fixed));
    let wind = frame.gust_axis;
    let turned = vec2f(dot(away, wind) / GUST_LENGTH, wind.x * away.y - wind.y * away.x);
    let at = frame.gust_origin + bitcast<vec2u>(vec2i(clamp(turned, vec2f(-2147483520.0), vec2f(2147483520.0))));
    let widest = SIDE / f32(1u << widest_level) * sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    var found = vec2f(0.0);
    // As in lib/waves.wgsl, the loop ends at its foot.
    var i = 0u;
    loop {
        // Cells narrower than three footprints do not show.
        let shown = smoothstep(3.0, 8.0, widest / f32(1u << (2u * i)) / footprint);
        found += vec2f(shown * (map_noise(at, widest_level + 2u * i, i) - 0.5) / NOISE_DEVIATION, shown * shown);
        i++;
        if i == levels || widest / f32(1u << (2u * i)) <= 3.0 * footprint { break; }
    }
    return found;
}

// Beyond the Mercator square there are none.
fn gusts_there(sin_lat: f32) -> f32 { return 1.0 - smoothstep(0.98, 0.99, abs(sin_lat)); }

// Factor of the variance of the slopes that a footprint hides at a point of the map: its mean over an area is one.
fn gusts(point: MapPoint, sin_lat: f32, footprint: Metres) -> f32 {
    let noise = gust_noise(point, sin_lat, footprint, GUST_WIDEST, GUST_LEVELS);
    let deviation = gusts_there(sin_lat) * GUST_DEVIATION / sqrt(f32(GUST_LEVELS));
    return exp(deviation * noise.x - 0.5 * deviation * deviation * noise.y);
}

// Factor of the slopes of ripples, by gusts and by where they are on the long waves, `height` over those' significant height, a quarter of which is a
// deviation: the mean of its square is one.
fn ripples_at(point: MapPoint, sin_lat: f32, height: f32, footprint: Metres) -> f32 {
    let noise = gusts_there(sin_lat) * gust_noise(point, sin_lat, footprint, RIPPLE_WIDEST, RIPPLE_LEVELS).x / sqrt(f32(RIPPLE_LEVELS));
    let more = sqrt(1.0 - RIPPLES_ON_CRESTS) * noise + sqrt(RIPPLES_ON_CRESTS) * 4.0 * height;
    return sqrt(1.0 + RIPPLES_VARY * clamp(more, -1.8, 1.8));
}
