// Land that water mirrors, as far as the picture shows it: what the surface sends up is followed over the scene until that is before it.
// Who imports this declares the textures `scene_colour` and `scene_depth`, and `LAKE`.
#import hash
#import scene
#import water

const LAND_NEAREST = vec2f(2.0, 0.04);    // the first step of a sight, metres and of the water's distance
const LAND_STEP = 4.0;                    // each over the one before, until one is behind land: then halves of that last one
const LAND_STEPS = vec2u(7u, 12u);        // of a sight that looks whether there is land, and of the one that looks at it
const LAND_TAPS = 4u;                     // looks at land, beside the first one
const LAND_TRIES = 5u;                    // of halves of the mirrored sights for the skyline
const LAND_FADES = vec2f(9000.0, 15000.0);    // metres of water's distance over which what it mirrors goes,
const SEA_MIRRORS = vec2f(2000.0, 4000.0);    // and of the eye's height over the sea,
const LAKE_FADES = vec2f(0.625, 1.0);     // and over a lake, of that to which its mesh is drawn for what it mirrors
const LAND_LOWEST = 0.0005;               // of sights, radians: lower ones meet water
const LAND_SHARP = 0.002;                 // radians over which skylines are seen at least
const SKY_SHARP = vec2f(0.006, 0.04);     // of sights, radians: over which spreads of them the sky's picture goes, and its blurred mean comes
const SUN_APART = 0.9995;                 // cosine of what is too near to the sun to be seen in the picture: its glitter has it already
const LAND_OVER_SHORE = 0.01;             // of the picture's height
const LAND_RIM = 0.2;                     // of it too: so far above the picture what is mirrored goes by and by
const LAND_BEFORE = 1.25;                 // what is nearer than the water by this stands before it; its own shore's triangles slope up to it
const LAND_BEHIND = 1.003;                // of its distance a place is behind land, as lakes are no planes

// Share of a triangular distribution of deviation 1 that is below x.
fn below_in_triangle(x: f32) -> f32 {
    let rest = saturate(1.0 - abs(x) / sqrt(6.0));
    return select(1.0 - 0.5 * rest * rest, 0.5 * rest * rest, x < 0.0);
}

// Where in the picture a place is, given as clip coordinates: right and down, 0 to 1.
fn shown_at(at: vec4f) -> vec2f { return vec2f(0.5, -0.5) * at.xy / max(at.w, 1e-6) + 0.5; }

// Such a place in the picture. What is beside it and above it is taken to be what lies as far within its rim.
fn within(shown: vec2f) -> vec2f { return clamp(1.0 - abs(1.0 - abs(shown)), vec2f(0.0), vec2f(0.99999)); }

// Whether what is seen there may stand for what is not: that is above the picture, where ground below the eye would be ground before what is mirrored.
fn may_stand_for(shown: vec2f, inside: vec2f) -> bool {
    let device = vec2f(2.0, -2.0) * (inside - 0.5);
    return (shown.y >= 0.0) | (frame.ray_forward.z + device.x * frame.ray_right.z + device.y * frame.ray_up.z > 0.0);
}

// How much of that shows: the less the farther above the rim.
fn known_at(shown: vec2f) -> f32 { return smoothstep(-LAND_RIM, 0.0, shown.y); }

// Radiance of the land that a place on the water mirrors in a pixel, and how much of what it mirrors is land: as many of its sights up as are lower than
// the skyline, which is between one that meets land and one that does not. Land is a height field: whatever is behind what its pixel shows is in it, if
// that is not before the water itself. Where the water is a mirror all but even, clouds are mirrored with it.
fn mirrored_land(w: WaterPoint, pixel: vec2u) -> vec4f {
    let mean = mirrored_sight(w);
    let flat = mean.toward - dot(mean.toward, w.up) * w.up;
    let ahead = flat / max(length(flat), 1e-4);
    let rise = atan2(dot(mean.toward, w.up), length(flat));
    let spread = max(2.0 * sqrt(mean.variance), LAND_SHARP);
    let distance = length(w.at);
    let own = frame.clip_from_local * vec4f(w.at, 1.0);
    let heights = select(SEA_MIRRORS, LAKE_MIRRORS * LAKE_FADES, LAKE);
    let near = (1.0 - smoothstep(LAND_FADES.x, LAND_FADES.y, distance)) * (1.0 - smoothstep(heights.x, heights.y, frame.eye_altitude))
        * select(0.0, 1.0, (frame.layers & MIRRORS_LAND) != 0u);
    let lowest = max(rise - sqrt(6.0) * spread, LAND_LOWEST);
    var low = lowest;
    var high = max(rise + sqrt(6.0) * spread, low);
    let part = (high - low) / f32(1u << LAND_TRIES);
    var land = vec3u(0u);    // its pixel, and whether there is any
    var looked = low;
    var upwards = -1.0;      // rows of the picture on its side of the rim
    var known = 0.0;
    var attempt = 0u;
    // As in lib/waves.wgsl, the loops end at their foot: where nothing is mirrored they are gone through once.
    loop {
        let is_last = attempt == LAND_TRIES;
        // The last one looks at the land where most of the sights that meet it do.
        let sight = select(0.5 * (low + high), min(rise, 0.5 * (lowest + low)), is_last);
        let way = frame.clip_from_local * vec4f(cos(sight) * ahead + sin(sight) * w.up, 0.0);
        let steps = select(LAND_STEPS.x, LAND_STEPS.y, is_last);
        land.z = 0u;
        looked = sight;
        known = 0.0;
        var before = 0.0;
        var behind = 0.0;
        var t = LAND_NEAREST.x + LAND_NEAREST.y * distance;
        var step = 0u;
        loop {
            let at = own + t * way;
            let shown = shown_at(at);
            let inside = within(shown);
            let seen = vec2u(inside * frame.viewport);
            // Depth = NEAR / distance along the view.
            let nearness = textureLoad(scene_depth, seen, 0);
            let is_land = (nearness * at.w > LAND_BEHIND * NEAR) & (nearness * own.w < LAND_BEFORE * NEAR) & (at.w > NEAR) & (shown.y > -LAND_RIM) & may_stand_for(shown, inside);
            land = select(land, vec3u(seen, 1u), is_land);
            known = select(known, known_at(shown), is_land);
            upwards = select(upwards, select(1.0, -1.0, shown.y >= 0.0), is_land);
            behind = select(behind, t, is_land);
            before = select(t, before, is_land);
            t = select(LAND_STEP * t, sqrt(max(before, 1.0) * behind), land.z == 1u);
            step++;
            if (step == steps) | (near <= 0.0) { break; }
        }
        let is_met = land.z == 1u;
        low = select(low, sight, is_met & !is_last);
        high = select(high, sight, !is_met & !is_last);
        attempt++;
        if is_last | (near <= 0.0) { break; }
    }
    // Between the last two.
    let skyline = low + part * spread_evenly(vec2f(pixel));
    let least = below_in_triangle((LAND_LOWEST - rise) / spread);
    let share = saturate((below_in_triangle((skyline - rise) / spread) - least) / max(1.0 - least, 1e-3));
    let is_land = near * known * share;
    // Triangles that slope up to a shore show inland water before it: the land is above that.
    var colour = textureLoad(scene_colour, land.xy, 0);
    let above = vec2u(land.x, land.y - min(land.y, u32(LAND_OVER_SHORE * frame.viewport.y) + 1u));
    if is_inland_water(colour) & (textureLoad(scene_depth, above, 0) > 0.0) { colour = textureLoad(scene_colour, above, 0); }
    // As far up and down as the sights go that meet land: a patch of snow or of a cloud before it is no more than its part.
    let reach = (low - lowest) / frame.pixel_angle;
    let lift = upwards * (0.5 * (lowest + low) - looked) / frame.pixel_angle;
    var sum = vec4f(colour.rgb, 1.0);
    var tap = 0u;
    loop {
        let row = f32(land.y) + lift + reach * (0.5 - (f32(tap) + 0.5) / f32(LAND_TAPS));
        let seen = vec2u(land.x, u32(clamp(row, 0.0, frame.viewport.y - 1.0)));
        let nearness = textureLoad(scene_depth, seen, 0);
        let beside = textureLoad(scene_colour, seen, 0);
        let is_seen = (nearness > 0.0) & (nearness * own.w < LAND_BEFORE * NEAR) & !is_behind_sea(beside) & !is_inland_water(beside);
        sum += select(vec4f(0.0), vec4f(beside.rgb, 1.0), is_seen);
        tap++;
        if (tap == LAND_TAPS) | (is_land <= 0.0) { break; }
    }
    let far = frame.clip_from_local * vec4f(mean.toward, 0.0);
    let shown = shown_at(far);
    let seen = vec2u(within(shown) * frame.viewport);
    let shows_sky = (textureLoad(scene_depth, seen, 0) == 0.0) & (far.w > 1e-6) & (dot(mean.toward, frame.light) < SUN_APART);
    let is_sky = near * known_at(shown) * select(0.0, 1.0 - smoothstep(SKY_SHARP.x, SKY_SHARP.y, spread), shows_sky) * (1.0 - is_land);
    let radiance = is_land * sum.rgb / sum.w + is_sky * textureLoad(scene_colour, seen, 0).rgb;
    return vec4f(radiance / max((is_land + is_sky) * frame.exposure, 1e-9), is_land + is_sky);
}
