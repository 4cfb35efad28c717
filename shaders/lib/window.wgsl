// The surface from below: sky and sun within Snell's window, around it a mirror of the water and the bed.
#import sea_bed

const WINDOW_TAPS = 4u;
const SUN_VARIANCE = 5.4e-6;       // of directions within the sun's disc, on each axis: (0.267 degrees / 2)^2

// Radiance below the surface of what comes through it, or off it, for the sight `direction` that rises to facets with that normal.
struct Sides { sky: vec3f, mirrored: f32, out: vec3f }

fn surface_sides(direction: vec3f, normal: vec3f, at: vec3f, up: vec3f) -> Sides {
    let out = refract(direction, -normal, WATER_INDEX);
    let escapes = dot(out, out) > 0.5;
    // Exact, by the angle in the air.
    let mirrored = select(1.0, fresnel_water(dot(out, normal)), escapes);
    // Waves may send a sight below the horizon: the sea there mirrors the sky.
    var seen = normalize(vec3f(out.xy, max(abs(out.z), 1e-3)));
    if !escapes { seen = up; }
    var sky = sky_at_sea(seen, up);
    if CLOUDS { sky = clouded_sky(sky, daylight_at(dot(frame.light, up)), cover_at_eye(), at, dot(seen, up), up); }
    return Sides(sky * (1.0 - mirrored), mirrored, out);
}

// Radiance towards the eye of the surface at a place, through the water before it. `rough`: variance of the slopes that the pixel hides;
// `depth`: of the bed there.
fn surface_from_below(w: Underwater, pixel: vec2f, at: vec3f, direction: vec3f, normal: vec3f, up: vec3f, rough: vec2f, depth: Metres) -> vec3f {
    let variance = max(0.5 * (rough.x + rough.y), 1e-7);
    // Facets that lean towards the sight and away from it, one of each third of all.
    let level = direction - dot(direction, up) * up;
    let ahead = level / max(length(level), 1e-4);
    let begins = spread_evenly(pixel);
    var sky = vec3f(0.0);
    var mirrored = 0.0;
    var i = 0u;
    loop {
        let share = clamp((f32(i) + begins) / f32(WINDOW_TAPS), 0.02, 0.98);
        // A Gaussian's quantile, by the logistic one of the same variance.
        let lean = sqrt(variance) * 0.5513289 * log(share / (1.0 - share));
        let part = 1.0 / f32(WINDOW_TAPS);
        let sides = surface_sides(direction, normalize(normal + lean * ahead), at, up);
        sky += part * sides.sky;
        mirrored += part * sides.mirrored;
        i++;
        if i == WINDOW_TAPS { break; }
    }
    // The sun's image is as large as refraction at the hidden facets spreads it; both axes alike.
    let middle = surface_sides(direction, normal, at, up);
    let bent = WATER_INDEX * max(dot(direction, normal), 0.0) - max(dot(middle.out, normal), 0.0);
    let spread = SUN_VARIANCE + variance * bent * bent;
    let off = middle.out - frame.light;
    let image = exp(-0.5 * min(dot(off, off) / spread, 80.0)) / (TURN * spread) * (1.0 - middle.mirrored);
    let sun = min(w.sun / max(frame.light.z, 0.02) * image * step(0.5, dot(middle.out, middle.out)), vec3f(BRIGHTEST_SUN / max(frame.exposure, 1e-9)));
    // The mirror: the bed below, or water without end.
    var away = reflect(direction, -normal);
    away = normalize(vec3f(away.xy, -max(abs(away.z), 1e-3)));
    let way = (depth + at.z + frame.eye_altitude) / -away.z;
    let spot = at + away * min(way, FARTHEST_MIRRORED);
    // Within a pixel the drawn waves turn the mirror, too: by a part of all their slopes.
    let blur = length(at) * frame.pixel_angle + way * (frame.pixel_angle + sqrt(variance + TURNED_IN_PIXEL * all_slopes()));
    var caustic = 1.0;
    if FINE { caustic = mix(1.0, bed_caustic(w, scene_colour, spot.xy, depth), 1.0 - smoothstep(0.05, 0.4, blur)); }
    var bed = vec3f(0.0);
    if (frame.layers & SHOWS_LAND) != 0u { bed = bed_light(w, spot.xy, depth, footprint_on_bed(0.0, away, -away.z, blur), caustic); }
    let below = seen_through(w, bed, min(at.z + frame.eye_altitude, 0.0), away, way, 1.0);
    let surface = WATER_INDEX * WATER_INDEX * (sky + sun) + mirrored * below;
    let distance = length(at);
    return seen_through(w, surface, frame.eye_altitude, direction, distance, sun_rays(w, scene_colour, pixel, direction, distance));
}

const TURNED_IN_PIXEL = 0.02;

fn all_slopes() -> f32 {
    let all = frame.below_slopes + cascade_slopes(0u) + cascade_slopes(1u) + cascade_slopes(2u) + cascade_slopes(3u);
    return 0.5 * (all.x + all.y);
}

const BRIGHTEST_SUN = 2.0e4;
const FARTHEST_MIRRORED: Metres = 400.0;
