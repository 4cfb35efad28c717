// Coordinates of the tables of the air that the eye sees (sky_view.wgsl), of directions about the eye, wherever it looks:
//
// - azimuth: angle from the sun's, on one side, to the power of 2/3, so that the glow about the sun has no creases; the other side is its
//   mirror image, but for the ellipsoid's flattening;
// - elevation: from the horizon up, or down to the nadir; the square root makes rows densest at the horizon, which is the
//   limb from space. Halves of angles take sines, which f32 holds where cosines are near -1;
// - distance: between the ray's entry into the air and where the deepest trough or the highest summit may be met.
//
// The horizon is that of the ray itself, over the true ellipsoid.
#import atmosphere

const SUMMIT: Metres = 9500.0;       // above all land and sea

// The steps along a ray, and the slices of the haze: t = warped(x), both 0…1. Steps are short where the air is dense: at the
// near end for a `sink` of 0, at the far end for 1, even for ½.
fn warped(x: f32, sink: f32) -> f32 { return mix(x * x, x * (2.0 - x), sink); }

fn unwarped(t: f32, sink: f32) -> f32 { return t / max(sink + sqrt(max(sink * sink + (1.0 - 2.0 * sink) * t, 0.0)), 1e-9); }

// Vertical at the eye, horizontal towards the sun, horizontal across.
fn air_axes() -> mat3x3f {
    let up = normalize(frame.quadric_gradient);
    let flat = frame.light - dot(frame.light, up) * up;
    // A sun in the zenith lights all azimuths alike.
    let sunward = normalize(flat + select(vec3f(0.0), cross(up, vec3f(0.0, 1.0, 0.0)), dot(flat, flat) < 1e-12));
    return mat3x3f(up, sunward, cross(up, sunward));
}

// A direction in those axes: zenith cosine and azimuth.
struct Bearing { mu: f32, azimuth: f32 }

fn bearing_of(direction: vec3f, axes: mat3x3f) -> Bearing {
    let p = direction * axes;
    let away = acos(clamp(p.y / max(length(p.yz), 1e-9), -1.0, 1.0)) / PI;
    return Bearing(p.x, pow(away, 2.0 / 3.0));
}

fn direction_of(bearing: Bearing, axes: mat3x3f) -> vec3f {
    let away = PI * bearing.azimuth * sqrt(bearing.azimuth);
    let flat = sqrt(max(1.0 - bearing.mu * bearing.mu, 0.0));
    return normalize(axes * vec3f(bearing.mu, flat * cos(away), flat * sin(away)));
}

// Zenith cosine at which a ray of this direction would touch the shell `lift` metres above the ellipsoid; 1 from inside it.
fn tangent_cosine(ray: Ray, lift: Metres) -> f32 {
    let c = ray.c - lift * (1.0 + 0.5 * lift / frame.semi_major);
    return select(1.0, -sqrt(max(ray.a * c, 0.0)) / length(frame.quadric_gradient), c > 0.0);
}

// The lowest surface: no trough is deeper. An eye below it sees half a sphere of it.
fn floor_cosine(ray: Ray) -> f32 {
    return min(tangent_cosine(ray, -frame.crest_height), 0.0);
}

fn half_sine(mu: f32) -> f32 { return sqrt(max(0.5 - 0.5 * mu, 0.0)); }       // of the angle from the zenith
fn half_cosine(mu: f32) -> f32 { return sqrt(max(0.5 + 0.5 * mu, 0.0)); }

// Elevation above the horizon, 0…1 up to the zenith or, from outside, up to the shell `lift`.
fn row_above(mu: f32, ray: Ray, lift: Metres) -> f32 {
    let low = half_sine(floor_cosine(ray));
    return sqrt(clamp((low - half_sine(mu)) / max(low - half_sine(tangent_cosine(ray, lift)), 1e-9), 0.0, 1.0));
}

fn mu_above(row: f32, ray: Ray, lift: Metres) -> f32 {
    let low = half_sine(floor_cosine(ray));
    let sine = mix(low, half_sine(tangent_cosine(ray, lift)), row * row);
    return 1.0 - 2.0 * sine * sine;
}

// And below it, 0…1 down to the nadir.
fn row_below(mu: f32, ray: Ray) -> f32 {
    let low = half_cosine(floor_cosine(ray));
    return sqrt(clamp((low - half_cosine(mu)) / max(low, 1e-9), 0.0, 1.0));
}

fn mu_below(row: f32, ray: Ray) -> f32 {
    let cosine = half_cosine(floor_cosine(ray)) * (1.0 - row * row);
    return 2.0 * cosine * cosine - 1.0;
}

// The haze's rows from this on are above the horizon, where only waves and mountains are.
fn haze_first_above(rows: u32) -> u32 { return rows * 3u / 5u; }

// From where to where a ray has air before a surface: x > y where it has none.
fn haze_reach(ray: Ray, below: bool) -> vec2f {
    let air = shell_hits(ray, TOP);
    if air.y <= max(air.x, 0.0) { return vec2f(1.0, 0.0); }
    let near = max(air.x, 0.0);
    let hits = shell_hits(ray, select(SUMMIT, -frame.crest_height, below));
    // Past all summits, as far as those that it just touches.
    var far = select(-ray.b / ray.a, hits.y, hits.y >= hits.x);
    if below && hits.y >= hits.x { far = select(hits.y, hits.x, hits.x > 0.0); }
    return vec2f(near, max(far, near + 1.0));
}
