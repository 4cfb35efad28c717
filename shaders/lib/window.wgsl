// The surface from below: sky and sun within Snell's window, around it a mirror of the water and the bed.
#import sea_bed

const WINDOW_TAPS = 8u;
const SUN_VARIANCE = 5.4e-6;       // of directions within the sun's disc, on each axis: (0.267 degrees / 2)^2

// What facets do with a sight from below: the share that they mirror, and unit vectors along the mean of what they let out, 0 if it is nothing, and
// of what they mirror.
struct FromBelow { mirrored: f32, out: vec3f, away: vec3f }

// The mean cosine under which facets are seen, of a mean plane seen under `cosine`, whose facets' cosines have the deviation `spread`: each counts by
// the area that it shows to the eye, those turned away not at all. The first two moments of the part over 0 of a normal distribution.
fn shown_cosine(cosine: f32, spread: f32) -> f32 {
    let least = max(spread, 1e-4);
    let x = clamp(cosine / least, -2.0, 1e4);
    let share = normal_share(x);
    let density = exp(-0.5 * x * x) * 0.3989422804014327;
    return least * (x + share / (x * share + density));
}

// The mean over facets whose slopes along the sight have a variance about those of `normal`. Each counts by the area that it shows to the eye.
// `begins`: a number of the pixel's, 0...1.
fn facets_from_below(direction: vec3f, normal: vec3f, up: vec3f, variance: f32, begins: f32) -> FromBelow {
    let level = direction - dot(direction, up) * up;
    let ahead = level / max(length(level), 1e-4);
    var area = 0.0;
    var mirrored = 0.0;
    var out = vec3f(0.0);
    var i = 0u;
    loop {
        let share = clamp((f32(i) + begins) / f32(WINDOW_TAPS), 0.01, 0.99);
        // A Gaussian's quantile, by the logistic one of the same variance.
        let lean = sqrt(variance) * 0.5513289 * log(share / (1.0 - share));
        let leaning = normal + lean * ahead;
        let seen = max(dot(direction, leaning), 1e-4);
        let facet = normalize(leaning);
        let cosine = clamp(dot(direction, facet), 0.0, 1.0);
        // Snell's law: the square of the cosine in the air, below 0 where all is mirrored.
        let square = 1.0 - WATER_INDEX * WATER_INDEX * (1.0 - cosine * cosine);
        let outside = sqrt(max(square, 0.0));
        let reflectance = select(1.0, fresnel_water(outside), square > 0.0);
        area += seen;
        mirrored += seen * reflectance;
        out += seen * (1.0 - reflectance) * (WATER_INDEX * direction + (outside - WATER_INDEX * cosine) * facet);
        i++;
        if i == WINDOW_TAPS { break; }
    }
    // The mirror needs no sum: over the mean facet that shows it changes little. A sum's few facets would be bands.
    let cosine = dot(direction, normal);
    let flat = max(length(level), 1e-4);
    let mean = normalize(normal + (shown_cosine(cosine, sqrt(variance) * flat) - cosine) / flat * ahead);
    let back = reflect(direction, -mean);
    // What would go on upwards is mirrored once more.
    return FromBelow(mirrored / area, out / max(length(out), 1e-9), back - 2.0 * max(dot(back, up), 0.0) * up);
}

// Sky above the surface.
fn sky_from_below(out: vec3f, at: vec3f, up: vec3f) -> vec3f {
    // Waves may send a sight below the horizon: the sea there mirrors the sky.
    let seen = normalize(out + (max(-2.0 * dot(out, up), 0.0) + 1e-3) * up);
    var sky = sky_at_sea(seen, up);
    if CLOUDS { sky = clouded_sky(sky, daylight_at(dot(frame.light, up)), cover_at_eye(), at, dot(seen, up), up); }
    return sky;
}

// Radiance towards the eye of the surface at a place, through the water before it. `rough`: variance of the slopes that the pixel hides, along the wind
// and across it; `depth`, `corals`: of the bed there.
fn surface_from_below(w: Underwater, pixel: vec2f, at: vec3f, direction: vec3f, normal: vec3f, up: vec3f, rough: vec2f, depth: Metres, corals: vec2f) -> vec3f {
    let variance = max(0.5 * (rough.x + rough.y), 1e-7);
    let facets = facets_from_below(direction, normal, up, max(variance_towards(direction, up, along_wind(up), rough), 1e-7), spread_evenly(pixel));
    let sky = (1.0 - facets.mirrored) * sky_from_below(facets.out, at, up);
    // The sun's image is as large as refraction at the hidden facets spreads it; both axes alike.
    let middle = refract(direction, -normal, WATER_INDEX);
    let inside = max(dot(direction, normal), 0.0);
    let outside = max(dot(middle, normal), 0.0);
    let bent = WATER_INDEX * inside - outside;
    let spread = SUN_VARIANCE + variance * bent * bent;
    let off = middle - frame.light;
    let image = exp(-0.5 * min(dot(off, off) / spread, 80.0)) / (TURN * spread) * (1.0 - fresnel_water(outside));
    let sun = min(w.sun / max(frame.light.z, 0.02) * image * step(0.5, dot(middle, middle)), vec3f(BRIGHTEST_SUN / max(frame.exposure, 1e-9)));
    // The mirror: the bed below, or water without end.
    let away = normalize(vec3f(facets.away.xy, min(facets.away.z, -1e-3)));
    let way = (depth + at.z + frame.eye_altitude) / -away.z;
    let spot = at + away * min(way, FARTHEST_MIRRORED);
    // Within a pixel the drawn waves turn the mirror, too: by a part of all their slopes.
    let blur = length(at) * frame.pixel_angle + way * (frame.pixel_angle + sqrt(variance + TURNED_IN_PIXEL * all_slopes()));
    var caustic = 1.0;
    if FINE { caustic = mix(1.0, bed_caustic(w, scene_colour, spot.xy, depth), 1.0 - smoothstep(0.05, 0.4, blur)); }
    var bed = vec3f(0.0);
    if (frame.layers & SHOWS_LAND) != 0u { bed = bed_light(w, spot.xy, depth, corals, footprint_on_bed(0.0, away, -away.z, blur), caustic); }
    let below = seen_through(w, bed, min(at.z + frame.eye_altitude, 0.0), away, way, 1.0);
    let surface = WATER_INDEX * WATER_INDEX * (sky + sun) + facets.mirrored * below;
    let distance = length(at);
    return seen_through(w, surface, frame.eye_altitude, direction, distance, sun_rays(w, scene_colour, pixel, direction, distance));
}

const TURNED_IN_PIXEL = 0.1;       // share of all slopes' variance; ours

fn all_slopes() -> f32 {
    let all = frame.below_slopes + cascade_slopes(0u) + cascade_slopes(1u) + cascade_slopes(2u) + cascade_slopes(3u);
    return 0.5 * (all.x + all.y);
}

const BRIGHTEST_SUN = 2.0e4;
const FARTHEST_MIRRORED: Metres = 400.0;
