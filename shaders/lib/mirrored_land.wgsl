// Land that water mirrors, as far as the picture shows it: what the surface sends up is followed over the scene until that is before it.
// Who imports this declares the textures `scene_colour` and `scene_depth`.
#import hash
#import water

const LAND_NEAREST = vec2f(2.0, 0.04);    // the first step of a sight, metres and of the water's distance
const LAND_STEP = 4.0;                    // each over the one before, until one is behind land: then halves of that last one
const LAND_STEPS = vec2u(7u, 12u);        // of a sight that looks whether there is land, and of the one that looks at it
const LAND_TRIES = 5u;                    // of halves of the mirrored sights for the skyline
const LAND_FARTHEST: Metres = 15000.0;    // of water that mirrors land
const LAND_RIM = 0.1;                     // of the picture's height: what is above it is not known, and goes by and by
const LAND_LOWEST = 0.0005;               // of sights, radians: lower ones meet water
const LAND_SHARP = 0.002;                 // radians over which skylines are seen at least
const SKY_SHARP = vec2f(0.006, 0.04);     // of sights, radians: over which spreads of them the sky's picture goes, and its blurred mean comes
const SUN_APART = 0.9995;                 // cosine of what is too near to the sun to be seen in the picture: its glitter has it already
const LAND_OVER_SHORE = 0.01;             // of the picture's height
const LAND_BEFORE = 1.25;                 // what is nearer than the water by this stands before it; its own shore's triangles slope up to it
const LAND_BEHIND = 1.003;                // of its distance a place is behind land, as lakes are no planes

// Share of a triangular distribution of deviation 1 that is below x.
fn below_in_triangle(x: f32) -> f32 {
    let rest = saturate(1.0 - abs(x) / sqrt(6.0));
    return select(1.0 - 0.5 * rest * rest, 0.5 * rest * rest, x < 0.0);
}

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
    let is_far = distance > LAND_FARTHEST;
    var low = max(rise - sqrt(6.0) * spread, LAND_LOWEST);
    var high = max(rise + sqrt(6.0) * spread, low);
    let part = (high - low) / f32(1u << LAND_TRIES);
    var land = vec3u(0u);    // its pixel, and whether there is any
    var known = 0.0;
    var attempt = 0u;
    loop {
        let is_last = attempt == LAND_TRIES;
        // The last one looks at the land where most of the sights that meet it do.
        let sight = select(0.5 * (low + high), max(min(rise, 0.7 * low), LAND_LOWEST), is_last);
        let way = frame.clip_from_local * vec4f(cos(sight) * ahead + sin(sight) * w.up, 0.0);
        let steps = select(LAND_STEPS.x, LAND_STEPS.y, is_last);
        land.z = 0u;
        known = 0.0;
        var before = 0.0;
        var behind = 0.0;
        var t = LAND_NEAREST.x + LAND_NEAREST.y * distance;
        var step = 0u;
        loop {
            let at = own + t * way;
            // What is beside the picture is taken to be like what is at its rim.
            let shown = vec2f(0.5, -0.5) * at.xy / max(at.w, NEAR) + 0.5;
            let seen = vec2u(clamp(shown, vec2f(0.0), vec2f(0.99999)) * frame.viewport);
            // Depth = NEAR / distance along the view.
            let nearness = textureLoad(scene_depth, seen, 0);
            let is_land = (shown.y > 0.0) & (nearness * at.w > LAND_BEHIND * NEAR) & (nearness * own.w < LAND_BEFORE * NEAR) & (at.w > NEAR);
            land = select(land, vec3u(seen, 1u), is_land);
            known = select(known, smoothstep(0.0, LAND_RIM, shown.y), is_land);
            behind = select(behind, t, is_land);
            before = select(t, before, is_land);
            t = select(LAND_STEP * t, sqrt(max(before, 1.0) * behind), land.z == 1u);
            step++;
            if (step == steps) | is_far { break; }
        }
        let is_met = land.z == 1u;
        low = select(low, sight, is_met & !is_last);
        high = select(high, sight, !is_met & !is_last);
        attempt++;
        if is_last | is_far { break; }
    }
    // Between the last two.
    let skyline = low + part * (spread_evenly(vec2f(pixel)) - 0.5);
    let least = below_in_triangle((LAND_LOWEST - rise) / spread);
    let share = saturate((below_in_triangle((skyline - rise) / spread) - least) / max(1.0 - least, 1e-3));
    let is_land = select(0.0, known * share, land.z == 1u);
    // Triangles that slope up to a shore show inland water, of an alpha of 0, before it: the land is above that.
    var colour = textureLoad(scene_colour, land.xy, 0);
    let above = vec2u(land.x, land.y - min(land.y, u32(LAND_OVER_SHORE * frame.viewport.y) + 1u));
    colour = select(textureLoad(scene_colour, above, 0), colour, colour.a > 0.5);
    let far = frame.clip_from_local * vec4f(mean.toward, 0.0);
    let shown = vec2f(0.5, -0.5) * far.xy / max(far.w, 1e-6) + 0.5;
    let seen = vec2u(clamp(shown, vec2f(0.0), vec2f(0.99999)) * frame.viewport);
    let inside = min(min(shown.x, 1.0 - shown.x), min(shown.y, 1.0 - shown.y));
    let shows_sky = (textureLoad(scene_depth, seen, 0) == 0.0) & (far.w > 1e-6) & (dot(mean.toward, frame.light) < SUN_APART) & !is_far;
    let sharp = select(0.0, smoothstep(0.0, LAND_RIM, inside) * (1.0 - smoothstep(SKY_SHARP.x, SKY_SHARP.y, spread)), shows_sky);
    let is_sky = sharp * (1.0 - is_land);
    let radiance = is_land * colour.rgb + is_sky * textureLoad(scene_colour, seen, 0).rgb;
    return vec4f(radiance / max((is_land + is_sky) * frame.exposure, 1e-9), is_land + is_sky);
}
