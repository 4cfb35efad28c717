// Clouds over the ellipsoid: water clouds step by step through their layer, ice clouds as a shell. `GLOBE`: from
// space. `SCALE`: pixels of the picture along one that is drawn here; from 2 on cloud_veil.wgsl
// lays the result over the picture, by from where it hides what is behind it. `FINE`: each place in a cloud looks towards the sun.
// Long, but one thing: a sight from the eye through both layers, step by step, and what each step adds to it.
#import full_screen
#import clouds
#import ice_clouds
#import decks
#import cloud_layer
#import cloud_light
#import light
#import air
#import spray

const SPRAY = true;                     // where there is none its depth is none
const CLOUDS = true;
const MIRRORS_CLOUDS = FINE;

const MOST_STEPS = 24.0;                // through the whole layer from space
const MOST_LOOKS = 240u;
const LOOKS_UNTIRED = 90.0;             // an eye among clouds looks on for long: from then on its steps grow with the number of looks
const SHORTEST_STEP: Metres = 60.0;     // of an eye among clouds; from space steps are no shorter than the second
const SHORTEST_FROM_SPACE: Metres = 160.0;
const STEP_OF_WAY = 0.11;               // steps grow with the way
const FINER = vec2f(6.0, 9.0);          // steps in a cloud, of those between: at least, and as many as are wider than four pixels
const GOES_ON = 7.0 / 6.0;              // of a wide step, by fine ones, behind a cloud before steps are wide again
const SUNWARDS: Metres = 160.0;         // where a cloud looks whether it is in the shadow of others
const FAINT = 0.004;                    // shade that is not worth light
const SUSPECTED = 0.0004;               // and of a wide step, that is not worth fine ones
const WISPY = 0.06;                     // deviations over which clouds' edges go at their base
const CRISP_FROM = 0.25;                // height in the layer from which on they are crisp, and so many times as dense
const CRISP = 5.0;
const CLOUD_CELL: Metres = 2500.0;     // as wide as clouds are: along so much of a ray they are one
const CLOSED_CLOUD = 2.8;               // least optical depth of closed ones; a grazing sight from below meets the thin edges of others first
const CLOSED_FROM = 0.3;                // deviations of the weather's level from which clouds close, and where they are closed
const CLOSED_TO = 1.8;
const CLOUD_OPACITY = 0.05;            // per metre, a deviation above the edge: what hides, not what darkens
const CLOUD_SCATTERS = CLOUD_OPACITY * ASIDE; // per metre of a heap; closed layers are less dense
const MOTTLED = 1.3;                    // of closed ones: logarithm of the density, for each deviation above the weather's level
const TWO_STREAMS = 0.75;              // of the depth less what goes on ahead: Eddington's
// Of an optical depth towards the sun: what a heap loses through its sides of the light that goes up in it, and of that which goes down.
const SIDEWAYS = 0.15;
const SIDEWAYS_DOWN = 0.25;
const TURNED_LIGHT = vec2f(0.2, 1.35);   // of the light of a level surface: of one turned away from the sun, and of one turned to it
const CLOSED_TURNED = 1.03;             // and of closed clouds, turned to it: they are level nearly
const TURNED = vec2f(-0.35, 1.0);      // deviations over SUNWARDS by which the level falls on a side that is turned away from the sun, and to it
const FACING_MEAN = 0.75;               // where nothing is known of that
const HIGH_TOPS: Metres = 6000.0;       // of what wide pixels see: of a low sun's light the highest tops have the most, and the least red
const DEEPEST: Metres = 900.0;         // way of sunlight through a cloud: longer ones get as much from their sides
const OWN_DEPTH: Metres = 60.0;        // of what an eye sees of a cloud that it meets
const HIDDEN = 0.02;                    // what a cloud leaves of what is behind it, from where on a sight goes no further
const OVER_HORIZON = 0.0004;            // radians that are surely above it, by the sphere's
const WIDE_PIXEL: Metres = 300.0;      // from here on a pixel is as wide as shadows are long, and nothing in the layer has a shape
// Wide pixels hide gaps and thin parts: from so many metres on clouds are less dense in them, down to this share.
const CLOUD_GAPS: Metres = 120.0;
const CLOUD_LEAST = 0.05;
const CLOUD_THINNED = vec2f(0.8, 1.3);  // power of it: of heaps, of closed ones, through whose thin parts the sea shines
const DECK_FROM = vec2f(40.0, 120.0);    // metres of a pixel from which and at which decks show how deep they are
const DECK_WITHIN: Metres = 20000.0;    // of the way through the clouds, in whose middle decks are looked at
const DECK_RELIEF: Metres = 2000.0;     // how far a deck is turned to the sun for each of its slope, a metre

// Radians below which a pixel drawn here shows nothing. Four of a smaller picture are averaged.
fn cloud_pixel() -> f32 { return max(SCALE - 1.0, 1.0) * frame.pixel_angle; }

// Of that, what hides the field from space: with all of it clouds there are soft, as if out of focus. Where pictures of the whole globe begin it is all,
// as below, and from twice as high on so much.
const FIELD_SHOWN = 0.6;

fn field_shown() -> f32 {
    let begins = max(GLOBE_PIXEL / frame.pixel_angle, GLOBE_LOWEST);
    return select(1.0, mix(1.0, FIELD_SHOWN, smoothstep(1.0, 2.0, frame.eye_altitude / begins)), GLOBE);
}

// Where a place is in a cloud: how high over its base, of the layer; the optical depths from it towards the sun and to the base; how far its side is
// turned to the sun, 0 to 1; and how far clouds are closed there, 0 to 1.
struct InHeap { height: f32, above: f32, below: f32, facing: f32, closed: f32 }

// At a height, where the cloud is so high and scatters so much a metre; `met_excess`: how far the level lies above the edge where the eye has met
// the cloud; `closed`, `facing`: as there. A picture from space shows the tops, and others the more of
// them, the wider their pixels are: `wideness`, 0 to 1.
fn in_heap(height: f32, top: f32, scatters: f32, cloud: InCloud, met_excess: f32, mu: f32, wideness: f32, facing: f32, closed: f32) -> InHeap {
    let risen = mix(saturate(height), top, wideness);
    let straight = max(top - risen, 0.0) * (CLOUD_TOP - CLOUD_BASE);
    let over = mix(min(straight / max(mu, 0.1), DEEPEST), straight, closed);
    let above = scatters * (cloud.share * over + OWN_DEPTH * min(4.0 * met_excess, 1.0));
    return InHeap(risen, above, scatters * risen * (CLOUD_TOP - CLOUD_BASE), facing, closed);
}

// Light that a cloud sends on, of what falls on it: that of two streams that none of it is lost from (A. Schuster 1905), of which an eye sees the
// one that comes towards it, and what has met but one droplet. Heaps lose some of both through their sides, which closed clouds have none of, and
// what is turned away from the sun, a bulge's back or a furrow, has less of them than those streams, which are level, know.
fn cloud_source(sun: vec3f, sky: vec3f, at: InHeap, phase: f32, once: f32, rise: f32) -> vec3f {
    let through = 1.0 / (1.0 + TWO_STREAMS * (at.above + at.below));
    let turned = mix(TURNED_LIGHT.x, mix(TURNED_LIGHT.y, CLOSED_TURNED, at.closed), at.facing);
    let kept = mix(1.0 / (1.0 + vec2f(SIDEWAYS, SIDEWAYS_DOWN) * at.above), vec2f(1.0), at.closed);
    let sent_up = TWO_STREAMS * at.below * turned * kept.x;
    let let_down = saturate(0.5 + 3.0 * rise) * mix(turned, 1.0, saturate(0.4 * at.above)) * kept.y;
    let lit = (sent_up + let_down) * through + 0.1 * phase * exp(-at.above) + once / ((1.0 + at.above) * (1.0 + at.above));
    return (0.95 * sun * lit + sky * (0.4 + 0.5 * at.height)) / PI;
}

// Light from the sun's side is stronger, of one that is isotropic.
fn cloud_phase(c: f32) -> f32 { return 0.75 + 0.9 * pow(0.5 + 0.5 * c, 12.0); }

// And light that has met but one droplet, of a level white surface's: a quarter of its phase function (L. Henyey and J. Greenstein 1941, asymmetry
// 0.8), of which the disc's corona has half.
fn cloud_once(c: f32) -> f32 {
    let x = 1.64 - 1.6 * c;
    return 0.045 / (x * sqrt(x));
}

// What clouds add to a sight, what they leave of what is behind them, and from where they hide it: the distance's logarithm and its square, times what they
// hide. Means of distances would be far ones, where a few far clouds are seen behind near ones.
struct Veil { radiance: vec3f, through: f32, ways: vec2f }

const NO_VEIL = Veil(vec3f(0.0), 1.0, vec2f(0.0));

// One before the other.
fn before(near: Veil, far: Veil) -> Veil {
    return Veil(near.radiance + near.through * far.radiance, near.through * far.through, near.ways + near.through * far.ways);
}

fn ways_of(distance: Metres) -> vec2f {
    let way = way_of(distance);
    return vec2f(way, way * way);
}

fn sun_cosine(at: vec3f) -> f32 { return dot(frame.light, normalize(normal_delta(at) + vec3f(0.0, 0.0, 1.0))); }

// Integrals of the normal density, once, twice and three times.
fn normal_integrals(x: f32) -> vec3f {
    let density = 0.3989423 * exp(-0.5 * x * x);
    let share = normal_share(x);
    let twice = x * share + density;
    return vec3f(share, twice, 0.5 * (x * twice + share));
}

// What a sight meets of a cloud between two looks, at which the level lies so many deviations above the edge: along a straight line between
// them the share of the way that is in cloud and its excess there are known in closed form, so that no look is an edge of its own.
fn between(from_x: f32, to_x: f32, deviation: f32) -> InCloud {
    let a = clamp(from_x, -6.0, 6.0);
    let b = clamp(to_x, -6.0, 6.0);
    let apart = select(b - a, select(-0.05, 0.05, b >= a), abs(b - a) < 0.05);
    let middle = 0.5 * (a + b);
    let more = (normal_integrals(middle + 0.5 * apart) - normal_integrals(middle - 0.5 * apart)) / apart;
    let share = max(more.y, 1e-7);
    return InCloud(share, min(deviation * max(more.z, 0.0) / share, 1.5));
}

// How much less colour the air takes from the light of clouds than of the way to them alone: it would leave far rows of them pink, which by day are
// white, lit by more blue than this light's sun and sky.
const GREY_AIR = 0.7;

fn grey_air(transmittance: vec3f) -> vec3f { return mix(transmittance, vec3f(dot(transmittance, LUMINANCE)), GREY_AIR); }

// Water clouds between the eye and `far`. One look at the field a turn: along the sight with wide steps; where these meet a cloud, with fine ones;
// and from where a fine one is in a cloud, towards the sun. As in lib/waves.wgsl, the loop ends at its foot. `grain`, 0…1: where in its steps a
// pixel looks.
fn water_clouds(ray: Ray, direction: vec3f, far: Metres, phase: f32, grain: f32) -> Veil {
    let sunny = daylight_at(frame.light.z);
    let light = clouded_daylight_at_eye(sunny);
    let clear = light.air;
    let once = cloud_once(dot(direction, frame.light));
    let closed_ahead = CLOSED_CLOUD * (1.0 - clear);
    let stretch = layer_stretch(ray, far);
    let length = max(stretch.last - stretch.first - (stretch.returns - stretch.leaves), 0.0);
    let is_wide = GLOBE | (stretch.first * cloud_pixel() > WIDE_PIXEL);
    let from_space = length / clamp(ceil(length / max(SHORTEST_FROM_SPACE, 0.3 * stretch.first * cloud_pixel())), 2.0, MOST_STEPS);
    var veil = NO_VEIL;
    var way = 0.0;
    var counted = 0.0;
    var t = stretch.first;
    var fine_left = 0u;
    var look = 0u;
    var met = 0.0;
    var met_excess = 0.0;
    var met_over = 0.0;
    var last_x = -6.0;
    var was_fine = false;
    // One deck a sight: where it comes into the clouds, or where its pixels have become wide enough to tell.
    let deck_at = max(stretch.first + 0.5 * min(length, DECK_WITHIN), DECK_FROM.y / cloud_pixel());
    var deck = vec4f(1.0, 0.0, 0.0, 0.0);
    if is_wide | (stretch.last * cloud_pixel() > DECK_FROM.x) {
        let place = cloud_place(direction * deck_at);
        deck = deck_depth(cloud_weather(place), place, field_shown() * deck_at * cloud_pixel());
    }
    let relief = dot(deck.yzw, cloud_way(frame.light));
    loop {
        let wide = select(clamp(STEP_OF_WAY * t, SHORTEST_STEP, max(0.25 * length, SHORTEST_STEP)), from_space, is_wide);
        let is_fine = fine_left > 0u;
        let finer = clamp(wide / (4.0 * max(t, 1.0) * cloud_pixel()), FINER.x, FINER.y);
        let tired = max(f32(look) / LOOKS_UNTIRED, 1.0);
        let step = min(tired * select(wide, wide / finer, is_fine), max(select(stretch.last, stretch.leaves, t < stretch.leaves) - t, 0.0));
        // Wide steps are the same for all pixels.
        let sight = t + select(0.5, 0.5 + grain, is_fine) * step;
        let at = direction * sight;
        let height = (height_along(ray, sight) - CLOUD_BASE) / (CLOUD_TOP - CLOUD_BASE);
        let mu = sun_cosine(at);
        let is_lit = met > 0.0;
        let place = cloud_place(select(at, at + SUNWARDS * frame.light, is_lit));
        let weather = cloud_weather(place);
        let edge = cloud_edge(select(height, height + SUNWARDS * mu / (CLOUD_TOP - CLOUD_BASE), is_lit), weather.x);
        // In clouds it is narrower than the steps: each of four neighbours takes others.
        let footprint = max(field_shown() * sight * cloud_pixel(), select(select(select(1.0, 0.5, is_wide), 0.15, is_fine) * step, max(0.15 * step, 40.0), is_lit));
        // A look towards the sun asks as well how high the cloud is there, by more octaves than tell whether it is one.
        let level = cloud_level_of(weather, place, footprint, edge, select(edge, max(edge, weather.x), is_lit));
        let soft = mix(WISPY, CLOUD_SOFT, smoothstep(0.0, CRISP_FROM, height));
        let deviation = sqrt(level.y + soft * soft);
        let x = (level.x - edge) / deviation;
        // A wide look, whose edge is as wide as what it hides, tells a fine one nothing of where the cloud ends: there would be rings of haze about it.
        let goes_on = is_fine & was_fine & !is_lit;
        let cloud = between(select(x, last_x, goes_on), x, deviation);
        // Of the way through as many clouds as it meets.
        let clouds = max(step / CLOUD_CELL, 1.0);
        let pixel = sight * cloud_pixel();
        let closed = smoothstep(CLOSED_FROM, CLOSED_TO, weather.x);
        let wideness = select(smoothstep(0.5, 1.0, pixel / WIDE_PIXEL), 1.0, is_wide);
        let deckness = max(wideness, smoothstep(DECK_FROM.x, DECK_FROM.y, pixel));
        let depth = mix(1.0, deck.x, deckness);
        let gaps = max(pow(min(CLOUD_GAPS / pixel, 1.0), mix(CLOUD_THINNED.x, CLOUD_THINNED.y, closed)), CLOUD_LEAST);
        let dense = CLOUD_OPACITY * depth * gaps;
        let crisp = mix(1.0, select(CRISP, 1.0, is_wide), smoothstep(0.0, CRISP_FROM, height));
        // Of a step that begins or ends in a cloud each ray of a pixel that meets it at all has as much before it as lies within.
        let covered = max(max(select(0.0, normal_share(clamp(last_x, -5.0, 5.0)), goes_on), normal_share(clamp(x, -5.0, 5.0))), cloud.share);
        let opaque = min(covered * (1.0 - exp(-crisp * dense * cloud.excess * cloud.share / covered * step / clouds)), 0.9999);
        let shade = select(1.0 - pow(1.0 - opaque, clouds), met, is_lit);
        let is_cloud = shade >= FAINT;
        let is_found = !is_wide & !is_fine & (shade >= SUSPECTED);
        if is_lit | (is_cloud & (is_wide | (!FINE & is_fine))) {
            let top = cloud_top(max(max(edge, 0.0) + cloud.excess, level.x), weather.x);
            let turned = smoothstep(TURNED.x, TURNED.y, met_over - (level.x - edge));
            let level_facing = clamp(FACING_MEAN - DECK_RELIEF * deckness * relief, 0.0, 1.0);
            let facing = select(level_facing, mix(turned, level_facing, wideness), is_lit);
            // Wide pixels hide what is thin in the tops as well.
            let mottled = exp(closed * clamp(MOTTLED * (level.x - weather.x) / (heaped(weather) + 0.5), -1.2, 0.7));
            // And what is low, more so in closed ones.
            let thick = depth * mix(1.0, 1.5 * top, wideness * mix(0.6, 1.0, closed));
            let scatters = CLOUD_SCATTERS * mix(1.0, 0.4, closed) * mottled * pow(gaps, 0.3) * thick;
            var heap = in_heap(height, top, scatters, cloud, met_excess, mu, wideness, facing, closed);
            heap.above = max(closed_ahead * mix(1.0 - saturate(direction.z), 1.0, closed), heap.above);
            // Closed clouds are level: they have the less of a low sun's light the lower it stands. So have wide pixels' clouds, of which all sides count.
            let level_lit = clamp(mu / LEVEL_LIT, LEAST_LIT, 1.0);
            let sun = SUN_IRRADIANCE * sunlight(mix(CLOUD_TOP, HIGH_TOPS, wideness), mu) * mix(1.0, level_lit, max(closed, wideness));
            veil.radiance += veil.through * shade * cloud_source(sun, daylight_at(mu).sky, heap, phase, once, direction.z);
            way += veil.through * shade * sight;
            // Near ones count the more: what stands between them and far ones hides these.
            let counts = veil.through * veil.through * shade;
            counted += counts;
            veil.ways += counts * ways_of(sight);
            veil.through *= 1.0 - shade;
        }
        let waits = FINE & !is_lit & is_fine & is_cloud;
        let stays = !FINE & is_fine & is_cloud;
        met = select(0.0, shade, waits);
        met_excess = cloud.excess;
        met_over = level.x - edge;
        last_x = select(x, last_x, is_lit);
        was_fine = is_fine;
        let left = select(max(fine_left, 1u) - 1u, u32(GOES_ON * finer), is_lit | is_found | stays);
        fine_left = select(left, fine_left, waits);
        // What the step before may have missed is looked at again.
        t = max(t + select(step, select(-0.5 * wide, 0.0, waits), waits | is_found), stretch.first);
        t = select(t, max(t, stretch.returns), t >= stretch.leaves);
        look++;
        if t >= stretch.last || veil.through < HIDDEN || step == 0.0 || look == MOST_LOOKS { break; }
    }
    // Sights that end in a cloud see nothing behind it: of the sun so much would be a disc in an overcast sky.
    veil.through *= smoothstep(HIDDEN, 4.0 * HIDDEN, veil.through);
    let hidden = 1.0 - veil.through;
    veil.ways *= hidden / max(counted, 1e-6);
    let air = haze(direction, way / max(hidden, 1e-4));
    veil.radiance *= seen_from_below(direction.z, 1.0 - clear);
    veil.radiance = veil.radiance * grey_air(air.transmittance) + hidden * lit_air(air, light);
    if GLOBE { return veil; }
    // Before all of them stands the spray, in the light that the sky's has.
    let left = exp(-spray_before_sky(direction.z));
    let spray = spray_light(Daylight(sunny.sun, sunny.sky, 0.0, clear, 1.0, light.air_sky), vec3f(0.0, 0.0, 1.0), direction);
    // It is where they are, for what stands among them.
    return before(Veil((1.0 - left) * spray, left, (1.0 - left) * veil.ways / max(hidden, 1e-4)), veil);
}

// An eye so near their shell sees less of them: it would be a line, edge on.
const ICE_THICK: Metres = 500.0;
// Sines of the angle to it between which a sight from above loses it in the haze: it would be a row of white dashes on the horizon.
const ICE_GRAZED = vec2f(0.005, 0.045);
const ICE_DEEP = 3.0;                   // optical depth over which ice clouds become so
const ICE_WHITE = 0.85;
const ICE_GREY = 0.35;

// Ice clouds between the eye and `far`.
fn ice_clouds(ray: Ray, direction: vec3f, far: Metres, phase: f32) -> Veil {
    let shell = shell_hits(ray, ICE_HEIGHT);
    let t = select(shell.x, shell.y, frame.eye_altitude < ICE_HEIGHT);
    if (shell.x > shell.y) | (t <= 0.0) | (t >= far) { return NO_VEIL; }
    let at = direction * t;
    let mu = sun_cosine(at);
    let rise = abs(dot(direction, normalize(normal_delta(at) + vec3f(0.0, 0.0, 1.0))));
    let grazed = select(smoothstep(ICE_GRAZED.x, ICE_GRAZED.y, rise), 1.0, frame.eye_altitude < ICE_HEIGHT);
    let apart = grazed * smoothstep(0.0, ICE_THICK, abs(frame.eye_altitude - ICE_HEIGHT));
    // A pixel is longer on the shell than wide.
    let footprint = t * cloud_pixel() * pow(max(rise, 0.05), -0.4);
    let depth = apart * ice_optical_depth(cloud_place(at), footprint);
    let shade = 1.0 - exp(-depth / max(rise, 0.12));
    let air = haze(direction, t);
    let sun = SUN_IRRADIANCE * sunlight(ICE_HEIGHT, mu);
    // Deep ones are as level white ground, from above, and let through less, from below.
    let deep = select(ICE_WHITE, ICE_GREY, frame.eye_altitude < ICE_HEIGHT) * max(mu, 0.0);
    let lit = (sun * mix(0.55 * phase, deep, 1.0 - exp(-depth / ICE_DEEP)) + 0.5 * daylight_at(mu).sky) / PI;
    return Veil(shade * (lit * grey_air(air.transmittance) + air.radiance), 1.0 - shade, shade * ways_of(t));
}

// Drops send half of what they scatter on, within a degree or two of its way, by diffraction: what thin clouds take from the disc stands about it.
const CORONA = 0.02;                    // radians
const DIFFRACTED = 0.5;

// That of the sun or the moon, before what clouds leave so much of.
fn corona(direction: vec3f, through: f32) -> vec3f {
    let away = frame.light - direction;
    let spread = 1.0 + dot(away, away) / (CORONA * CORONA);
    let once = -log(max(through, 1e-4)) * through;
    return SUN_IRRADIANCE * beam_seen(direction) * (DIFFRACTED * once / (PI * CORONA * CORONA * spread * spread));
}

// Radiance and opacity; and the mean of its distance's logarithm and the deviation of that, times it: for the smaller picture alone.
struct Seen { @location(0) veil: vec4f, @location(1) ways: vec2f }

@fragment
fn fragment(corner: Corner) -> Seen {
    let device = corner.position.xy * SCALE * vec2f(2.0, -2.0) / frame.viewport + vec2f(-1.0, 1.0);
    var direction = normalize(frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up);
    // From below them clouds go on below the horizon as they are on it, for the pixels of the whole picture that are just above it.
    let is_open_below = (SCALE > 1.0) & (frame.eye_altitude < CLOUD_BASE);
    let horizon = OVER_HORIZON - sqrt(2.0 * max(frame.eye_altitude, 0.0) / SEMI_MINOR);
    direction = select(direction, normalize(vec3f(direction.xy, max(direction.z, horizon))), is_open_below);
    let ray = eye_ray(direction);
    let hit = surface_hit(ray);
    let is_open = (hit < 0.0) | is_open_below;
    let far = select(hit, 1e9, is_open);
    let phase = cloud_phase(dot(direction, frame.light));
    // Each of four neighbours looks elsewhere in its steps: cloud_veil.wgsl, whose weights add up to the same for all of them, takes a mean without their grain.
    let pixel = vec2u(corner.position.xy) & vec2u(1u);
    let spread = (0.5 + f32(pixel.x ^ pixel.y) * 2.0 + f32(pixel.y)) / 4.0;
    let water = water_clouds(ray, direction, far, phase, select(0.25 + 0.5 * spread, 0.5, GLOBE));
    let ice = ice_clouds(ray, direction, far, phase);
    var all = before(ice, water);
    if frame.eye_altitude < ICE_HEIGHT { all = before(water, ice); }
    if !GLOBE { all.radiance += corona(direction, all.through); }
    let opacity = 1.0 - all.through;
    let variance = all.ways.y * opacity - all.ways.x * all.ways.x;
    return Seen(vec4f(all.radiance * frame.exposure, opacity), vec2f(all.ways.x, sqrt(max(variance, 0.0))));
}
