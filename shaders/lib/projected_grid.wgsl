// A grid even on the screen, cast onto the ellipsoid from the eye, or, where crests may stand higher than the eye, from a projector
// raised above the highest. Who imports this declares UNDER_WATER (src/pass/kind.rs).
#import ellipsoid

const LOW_RIM = vec2f(0.02, 0.35);   // share of the grid below the lower edge, in calm water and among waves that reach into the screen
const EDGE: f32 = 1.02;              // the even part of the grid reaches this far, in device units
const EDGE_ABOVE: f32 = 0.03;        // and this much farther above

fn low_rim() -> f32 { return select(LOW_RIM.x, LOW_RIM.y, frame.rim_reach > 0.0); }

// Height of a strip of cells that stands on the horizon, and of the rows over it that lead back down, in cells.
const STRIP_ROWS = 6.0;

// The ellipsoid's point under a device coordinate, cast from the projector.
fn projected(device: vec2f) -> vec3f {
    var direction = normalize(frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up);
    // The surface over an eye under water lies where the mirrored eye above it looks.
    direction.z = select(direction.z, -abs(direction.z), UNDER_WATER);
    let ray = ray_coefficients(direction, frame.projector_gradient, frame.projector_constant);
    let rise = vec3f(0.0, 0.0, frame.projector_rise);
    var t = surface_hit(ray);
    if t >= 0.0 { return direction * t + rise; }
    // The ray misses. Far off, its closest approach: the fragments decide by their own rays where the limb is.
    t = max(-ray.b / ray.a, 0.0);
    if waves_are_pixels(t) {
        // A few cells beyond the limb are enough.
        let p = direction * t + rise;
        let beyond = height_along(ray, t) - 16.0 * t * frame.pixel_angle;
        return p - max(beyond, 0.0) * (normal_delta(p) + vec3f(0.0, 0.0, 1.0));
    }
    // Near, the point of the horizon below the ray, so that no triangle spans the sea.
    let tangent = sqrt(max(ray.c, 0.0) / ray.a);
    // Sine and cosine of the angle between the horizon and level.
    let dip = min(sqrt(max(ray.a * ray.c, 0.0)) / frame.projector_gradient.z, 1.0);
    let along = sqrt(1.0 - dip * dip);
    let level = max(length(direction.xy), 1e-6);
    // Where the horizon's waves are smaller than pixels a strip stands on it, a cell high: those fragments know their share of it. Rows
    // farther up lie on the horizon again: over the zenith a triangle spans the whole sea, and must do so below the eye.
    let cell = 1.05 * frame.cell_pixels * frame.pixel_angle / (1.0 - low_rim());
    let above = direction.z / level + dip;
    let strip = select(0.0, clamp(min(above - cell, STRIP_ROWS * cell - above), 0.0, cell), waves_are_pixels(tangent) && !UNDER_WATER);
    return tangent * vec3f(along * direction.xy / level, strip - dip) + rise;
}

// Rows stand closer by the horizon, where a wave is a few of them high, at the cost of those before it and of the sky's, which show no water: how many there are
// of what even ones would be, before that band and in it; and how far the band goes below the horizon and over it, device units.
const ROWS_BY_HORIZON = vec2f(0.85, 2.0);
const HORIZON_BAND = vec2f(0.25, 0.06);
const LEAST_ROWS = 0.02;                   // in the sky
const SEEN_FROM = vec2f(300.0, 3000.0);    // eyes between these heights lose the band: their horizon is round, and no wave stands out of it; metres

// Device coordinate of a row that is so far, of all, between the lowest edge and the uppermost. As `row_at` of src/pass/ocean.rs.
fn row_at(share: f32) -> f32 {
    let lowest = -EDGE;
    let uppermost = EDGE + EDGE_ABOVE;
    let height = max(frame.eye_altitude + frame.projector_rise, 0.0);
    let seen = 1.0 - smoothstep(log(SEEN_FROM.x), log(SEEN_FROM.y), log(height + 1.0));
    let below = -asin(clamp(frame.ray_forward.z, -1.0, 1.0)) - sqrt(2.0 * height / SEMI_MINOR);
    let horizon = tan(clamp(below, -1.5, 1.5)) / length(frame.ray_up);
    let first = clamp(horizon - HORIZON_BAND.x, lowest, uppermost);
    let last = clamp(horizon + HORIZON_BAND.y, lowest, uppermost);
    let rows = mix(vec2f(1.0), ROWS_BY_HORIZON, seen * (last - first) / (HORIZON_BAND.x + HORIZON_BAND.y));
    let before = rows.x * (first - lowest);
    let band = rows.y * (last - first);
    let sky = max(uppermost - lowest - before - band, LEAST_ROWS * (uppermost - last));
    let row = share * (before + band + sky);
    return lowest + min(row, before) / rows.x + clamp(row - before, 0.0, band) / rows.y + max(row - before - band, 0.0) / max(sky, 1e-6) * (uppermost - last);
}

const SIDE_RIM = 0.06;         // share of the grid beyond each side edge
const NEAREST: Metres = 0.7;
// And before a lens that the water cuts through: what the waterline leaves of its foot must be as true as the waterline.
const NEAREST_LENS = 0.6;      // in distances of the lens

const WITHIN_EDGES = 0.8;      // share of the grid within the screen's edges, under water

// Device coordinates of a grid vertex of a grid that goes on beyond the screen's edges, the farther the higher the waves stand over the eye:
// under water they may come into the screen from any side.
fn beyond_edges(grid: vec2f, farthest: f32) -> vec2f {
    let within = min(abs(grid), vec2f(WITHIN_EDGES)) / WITHIN_EDGES * EDGE;
    let beyond = max(abs(grid) - WITHIN_EDGES, vec2f(0.0)) / (1.0 - WITHIN_EDGES);
    return sign(grid) * (within + beyond * farthest);
}

// Rest position of a grid vertex. Among high waves the chop moves water into the screen from beside and behind the eye, so
// the grid's rims run on from the screen's edges: up and sideways, and below the eye to behind it, denser towards the eye.
fn rest_position(grid: vec2f) -> vec3f {
    let reach = frame.rim_reach;
    if UNDER_WATER { return projected(beyond_edges(grid, 1.0 + 4.0 * reach / (reach + abs(frame.eye_altitude)))); }
    let y = 0.5 * (grid.y + 1.0);
    let below = clamp(1.0 - y / low_rim(), 0.0, 1.0);
    let beside = sign(grid.x) * clamp((abs(grid.x) - 1.0 + SIDE_RIM) / SIDE_RIM, 0.0, 1.0);
    let device = vec2f(clamp(grid.x / (1.0 - SIDE_RIM), -1.0, 1.0) * EDGE, row_at(max(y - low_rim(), 0.0) / (1.0 - low_rim())));
    let rest = projected(device);
    let right = normalize(frame.ray_right.xy);
    let ahead = vec2f(-right.y, right.x);
    let above = clamp((y - 1.0 + SIDE_RIM) / SIDE_RIM, 0.0, 1.0);
    let moved = rest + vec3f((right * beside + ahead * above) * reach, 0.0);
    if below * reach == 0.0 { return moved; }
    let from_distance = dot(rest.xy, ahead);
    var distance = from_distance - below * reach;
    var width = 1.0;
    // Where the screen's lower edge lies before the eye, the rim runs in towards it; behind, it only runs on.
    let nearest = select(NEAREST, NEAREST_LENS * frame.lens, frame.lens > 0.0);
    if from_distance > nearest {
        let nearing = min(below / 0.8, 1.0);
        distance = from_distance * pow(nearest / from_distance, nearing) - max(below - 0.8, 0.0) / 0.2 * reach;
        width = clamp(distance / from_distance, 0.02, 1.0);
    }
    let aside = width * dot(rest.xy, right) + reach * (beside + grid.x * below);
    return vec3f(ahead * distance + right * aside, -frame.eye_altitude);
}
