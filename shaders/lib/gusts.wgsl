// Gusts and lulls: patches of rougher and smoother water, longer along the wind than across it, which are all the relief that the sea
// shows from the air. They stay where they are on the map.
#import map
#import noise

const GUST_LENGTH = 3.0;          // along the wind, of the width across it
const GUST_DEVIATION = 0.35;      // of the logarithm of the slopes' variance
const GUST_LEVELS = 4u;           // of the noise: widths from GUST_WIDEST on, each a quarter of the one before
const GUST_WIDEST = 13u;          // map levels: a side over 2^13, 4.9 km at the equator
const NOISE_DEVIATION = 0.17;     // of map_noise
const SIDE: Metres = 40075016.7;  // of the Mercator square at the equator

// Factor of the variance of the slopes that a footprint hides at a point of the map: its mean over an area is one.
fn gusts(point: MapPoint, sin_lat: f32, footprint: Metres) -> f32 {
    // Beyond the Mercator square there are none.
    let there = 1.0 - smoothstep(0.98, 0.99, abs(sin_lat));
    let away = vec2f(bitcast<vec2i>(point.at - frame.mercator_fixed));
    let wind = frame.gust_axis;
    let turned = vec2f(dot(away, wind) / GUST_LENGTH, wind.x * away.y - wind.y * away.x);
    let at = frame.gust_origin + bitcast<vec2u>(vec2i(clamp(turned, vec2f(-2147483520.0), vec2f(2147483520.0))));
    let widest = SIDE / f32(1u << GUST_WIDEST) * sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    var sum = 0.0;
    var squares = 0.0;
    // As in lib/waves.wgsl, the loop ends at its foot.
    var i = 0u;
    loop {
        // Cells narrower than three footprints do not show.
        let shown = smoothstep(3.0, 8.0, widest / f32(1u << (2u * i)) / footprint);
        sum += shown * (map_noise(at, GUST_WIDEST + 2u * i, i) - 0.5) / NOISE_DEVIATION;
        squares += shown * shown;
        i++;
        if i == GUST_LEVELS || widest / f32(1u << (2u * i)) <= 3.0 * footprint { break; }
    }
    let deviation = there * GUST_DEVIATION / sqrt(f32(GUST_LEVELS));
    return exp(deviation * sum - 0.5 * deviation * deviation * squares);
}
