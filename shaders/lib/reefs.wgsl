// Coral reefs about islands that rise out of a deep warm sea, as src/model/reefs.rs: see there what they are.
#import map_texels
#import noise
#import shore_shape

const REEFS_CORALS_TO: Metres = 90.0;      // out of the crest they cover all

// What a reef is like about a place; `pass_way`: to the middle of the nearest pass.
// `wide`: the mean distance to the shore about it.
struct Reef { share: f32, crest: Metres, shallow: Metres, pass_way: Metres, wide: Metres }

fn out_of(at: vec2f, ellipse: vec4f) -> f32 {
    let off = (at - ellipse.xy) / ellipse.zw;
    return smoothstep(REEFS_WITHOUT_ENDS.x, REEFS_WITHOUT_ENDS.y, dot(off, off));
}

// Whether the data leave reefs to be made up, and tell where.
fn has_reefs() -> bool { return (frame.terrain_resolution >= REEFS_MEASURED) & (frame.terrain_resolution < REEFS_COARSEST); }

// How far there is a reef about a place where the mean elevation of so wide texels is so high.
fn reef_share(point: MapPoint, sin_lat: f32, mean: Metres, width: Metres) -> f32 {
    let at = vec2f(point.at) / 4294967296.0;
    let warm = 1.0 - smoothstep(REEFS_WARM.x, REEFS_WARM.y, abs(sin_lat));
    let clear = warm * out_of(at, REEFS_WITHOUT_FIRST) * out_of(at, REEFS_WITHOUT_SECOND) * out_of(at, REEFS_WITHOUT_THIRD) * smoothstep(0.5, 0.95, -100.0 * mean / width);
    return select(0.0, clear, (point.square == MERCATOR) & has_reefs());
}

// Mean distance to the ocean's shore about a place, texels of the page. The loop ends at its foot.
fn wide_shore(point: MapPoint, page: Page, none: bool) -> f32 {
    let nine = nine_texels(point, page);
    var sum = 0.0;
    var k = 0u;
    loop {
        let at = vec2u(k % 3u, k / 3u);
        sum += spline(nine.t.x)[at.x] * spline(nine.t.y)[at.y] * texel(true, point.square, page.level, vec2u(nine.columns[at.x], nine.rows[at.y]), nine.tile, page).x;
        k++;
        if k == 9u || none { break; }
    }
    return sum;
}

// The loop ends at its foot: where there is none it is gone through once.
fn reef_at(share: f32, at: vec2u, cos_lat: f32, wide: Metres, none: bool) -> Reef {
    var noises = array<vec3f, 4>(vec3f(0.0), vec3f(0.0), vec3f(0.0), vec3f(0.0));
    var k = 0u;
    loop {
        noises[k] = map_noise_rise(at, 32u - REEFS_BITS[k], 111u + k);
        k++;
        if k == 4u || none { break; }
    }
    let values = vec3f(noises[0].x, noises[1].x, noises[3].x);
    let varied = exp2(dot(REEFS_CREST_VARIES, values));
    let cell = EARTH_ROUND * cos_lat / f32(1u << (32u - REEFS_BITS.z));
    // The finer one rises within so much shorter cells.
    let steeper = f32(1u << (REEFS_BITS.z - REEFS_BITS.y));
    let line = noises[2] + REEFS_PASS_BENDS * vec3f(1.0, steeper, steeper) * noises[1];
    let pass_way = cell * abs(line.x) / max(length(line.yz), 0.3) * exp2(REEFS_PASS_UNEVEN * values.z);
    let by_pass = smoothstep(REEFS_BY_PASS.y, REEFS_BY_PASS.x, pass_way);
    let crest = min(share * REEFS_CREST * varied, REEFS_FARTHEST);
    let curled = REEFS_PASS_CURLS * by_pass * by_pass * smoothstep(REEFS_PASS_CREST.x, REEFS_PASS_CREST.y, crest);
    return Reef(share, crest * (1.0 - curled), REEFS_CREST_DEPTH.x + dot(REEFS_CREST_ROUGH, values.yz), pass_way, wide);
}

fn reef_flat(reef: Reef) -> Metres { return min(REEFS_FLAT, REEFS_FLAT_MOST * reef.crest); }

// How far a place lies between two shores.
fn reef_enclosed(reef: Reef, d: Metres) -> f32 {
    return smoothstep(REEFS_ENCLOSED.x, REEFS_ENCLOSED.y, d - reef.wide) * smoothstep(REEFS_ENCLOSED_TO.y, REEFS_ENCLOSED_TO.x, d);
}

fn reef_begun(reef: Reef) -> f32 { return smoothstep(REEFS_BEGINS.x, REEFS_BEGINS.y, reef.share); }

fn in_pass(reef: Reef) -> f32 {
    return smoothstep(REEFS_PASS.y, REEFS_PASS.x, reef.pass_way) * smoothstep(REEFS_PASS_CREST.x, REEFS_PASS_CREST.y, reef.crest);
}

// Depth at a distance from the shore where without a reef it is `plain`.
fn reef_depth(reef: Reef, d: Metres, plain: Metres, trusted: f32, far: Metres) -> Metres {
    let out = d - reef.crest;
    let crest = mix(reef.shallow, REEFS_CREST_DEPTH.y, in_pass(reef));
    let steep = max(out, 0.0) / REEFS_FORE.y;
    let fore = crest + REEFS_FORE.x * out + steep * steep * steep;
    let outside = min(max(plain, min(max(crest, REEFS_GOES_ON * out), far * (1.0 - trusted))), fore);
    let across = d / max(reef.crest - reef_flat(reef), 1.0);
    let channel = mix(REEFS_CHANNEL.y, REEFS_CHANNEL.x, smoothstep(REEFS_CHANNEL_WIDE.x, REEFS_CHANNEL_WIDE.y, reef.crest));
    let bed = REEFS_FRINGE + max(channel - REEFS_FRINGE, 0.0) * smoothstep(REEFS_LAGOON.x, REEFS_LAGOON.y, across);
    let inside = mix(bed, crest, smoothstep(REEFS_LAGOON.y, 1.0, across));
    // Between two shores it goes on as a lagoon, in front of others as the open sea.
    let enclosed = reef_enclosed(reef, d);
    let lowest = max(channel, crest) + REEFS_OPEN * (1.0 - enclosed) / max(enclosed, 1e-3);
    let built = select(inside, min(outside, lowest), out > 0.0);
    return mix(plain, built, reef_begun(reef) * smoothstep(REEFS_BEACH.x, REEFS_BEACH.y, d));
}

// What is left of the waves' height.
fn reef_waves(reef: Reef, d: Metres) -> f32 {
    let behind = smoothstep(0.0, REEFS_CALMED * max(reef_flat(reef), 1.0), reef.crest - d);
    let by_pass = smoothstep(REEFS_BY_PASS.y, REEFS_BY_PASS.x, reef.pass_way);
    let passes = by_pass * by_pass * smoothstep(REEFS_PASS_CREST.x, REEFS_PASS_CREST.y, reef.crest);
    return 1.0 - (1.0 - REEFS_COMES_OVER) * behind * (1.0 - 0.5 * passes) * (1.0 - in_pass(reef)) * reef_begun(reef);
}

// How far a place is one of living corals, and how far one inside of the crest, of its sand.
fn reef_cover(reef: Reef, d: Metres) -> vec2f {
    let out = d - reef.crest;
    let flat = reef_flat(reef);
    let grown = smoothstep(-1.1 * flat, -0.5 * flat, out) * smoothstep(REEFS_CORALS_TO, 0.3 * REEFS_CORALS_TO, out) * (1.0 - in_pass(reef));
    let begun = reef_begun(reef);
    return begun * vec2f(grown * smoothstep(40.0, 120.0, reef.crest), max(smoothstep(REEFS_CORALS_TO, 0.0, out), reef_enclosed(reef, d)));
}
