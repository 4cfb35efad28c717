// Points of the cuboid around the ellipsoid (src/model/cuboid.rs) and where they lie about the eye, free of cancellation.
// Its user declares the uniform block `bisection`.
#import ellipsoid

struct Bisection {
    foot: vec3u,               // the eye's foot on the cuboid, in whole numbers
    target_pixels: f32,        // wished length of a triangle's base on the screen
    fraction: vec3f,           // what the foot has beyond the whole numbers
    budget: u32,               // triangles at most
    point: vec3f,              // the foot on the cube [-1, 1]^3
    inverse_length: f32,       // 1 / |point|
    local_from_x: vec3f,       // columns of the map from semi-axes to local metres
    unused_a: u32,
    local_from_y: vec3f,
    unused_b: u32,
    local_from_z: vec3f,
    unused_c: u32,
}

const UNIT_INVERSE = 9.313225746154785e-10;    // 2^-30

// The rest surface under a point of the cuboid, local metres. With m = m0 + d: m/|m| - m0/|m0| without subtracting near equals.
fn rest_of(point: vec3u) -> vec3f {
    let whole = vec3f(bitcast<vec3i>(point - bisection.foot));
    // From face to opposite face it is 2^31, which reads as -2^31.
    let d = (select(whole, -whole, (whole == vec3f(-2147483648.0)) & (point > bisection.foot)) - bisection.fraction) * UNIT_INVERSE;
    let m = bisection.point + d;
    let i0 = bisection.inverse_length;
    let i = inverseSqrt(dot(m, m));
    let q = d * i - bisection.point * (dot(d, m + bisection.point) * (i * i0) * (i * i0) / (i + i0));
    return q.x * bisection.local_from_x + q.y * bisection.local_from_y + q.z * bisection.local_from_z
        - vec3f(0.0, 0.0, frame.eye_altitude);
}

struct Edge { first: vec3u, second: vec3u, exists: bool }

// The edge that a point was made the middle of; corners and centres of the cuboid have none.
fn parents(point: vec3u) -> Edge {
    let lowest = countTrailingZeros(point);
    let k = min(lowest.x, min(lowest.y, lowest.z));
    let along = lowest == vec3u(k);
    let diagonal = dot(vec3u(along), vec3u(1u)) == 2u;
    if k > 30u || (diagonal && k == 30u) { return Edge(point, point, false); }
    let below = point - vec3u(1u << k);
    let above = point + vec3u(1u << k);
    let turned = vec3<bool>(diagonal) & (((below >> vec3u(k + 1u)) & vec3u(1u)) == vec3u(0u));
    return Edge(select(point, select(below, above, turned), along), select(point, select(above, below, turned), along), true);
}

// A sphere that holds an edge and the edges of everything that can come of its triangles: what a part asks for, the whole does.
struct Reach { centre: vec3f, length: Metres, radius: Metres }

fn reach_of(a: vec3u, b: vec3u) -> Reach {
    let p = rest_of(a);
    let q = rest_of(b);
    let length = distance(p, q);
    return Reach(0.5 * (p + q), length, 2.0 * length);
}

// Length of an edge on the screen, pixels, were its triangles as large seen from the side as they are seen in truth. Waves that are
// seen are seen from the side too: there a grazing look saves no more than the square root of a tenth.
fn pixels_of(reach: Reach) -> f32 {
    let distance = max(length(reach.centre) - reach.radius, 1e-3 * reach.length);
    let pixel = distance * frame.pixel_angle;
    let waves = 0.1 * clamp(4.0 * frame.crest_height / pixel, 0.01, 1.0);
    let seen = clamp((abs(frame.eye_altitude) + 0.3 * frame.crest_height) / distance, waves, 1.0);
    return reach.length * sqrt(seen) / pixel;
}

// Whether anything near the edge can be on the screen, were it moved by up to `shift`.
fn in_view(reach: Reach, shift: Metres) -> bool {
    let radius = reach.radius + shift;
    let ahead = dot(reach.centre, frame.ray_forward);
    let right = vec2f(dot(reach.centre, frame.ray_right), dot(reach.centre, frame.ray_up));
    let half = vec2f(length(frame.ray_right), length(frame.ray_up));
    // Distance to the planes through the eye and the screen's edges.
    let outside = (abs(right) / half - ahead * half) * inverseSqrt(1.0 + half * half);
    if ahead < -radius || any(outside > vec2f(radius)) { return false; }
    if frame.quadric_constant <= 0.0 { return true; }
    // Beyond the eye's polar plane lies what the earth hides; crests stand over it.
    let crests = 0.5 * frame.crest_height + sqrt(frame.crest_height * frame.quadric_constant);
    let over = frame.quadric_constant + dot(frame.quadric_gradient, reach.centre);
    // A sphere on the surface is as deep as it is wide, but what it holds leans against the plane by its distance alone.
    let lean = min((length(reach.centre) + radius) / SEMI_MINOR, 1.0);
    return over > -(length(frame.quadric_gradient) * radius * lean + crests);
}
