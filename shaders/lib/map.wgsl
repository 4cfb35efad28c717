// From places to map squares and back, in fixed point relative to the eye: 9 mm steps, no cancellation.
#import ellipsoid
#import trigonometry

const MERCATOR = 0u;
const NORTH = 1u;
const SOUTH = 2u;
const POLAR_EXTENT: f32 = 0.13165249758739585;   // tan(7.5 deg): the polar squares reach to 75 deg of latitude
const POLAR_SIN_LAT: f32 = 0.9945218953682733;   // sin(84 deg): beyond it the polar squares serve
const TURN = 6.283185307179586;

struct MapPoint { square: u32, at: vec2u }

// Fixed-point step from a difference of less than one side; halved first, since an i32 reaches only half a side.
fn fixed_step(difference: f32) -> u32 {
    if abs(difference) < 0.49 { return bitcast<u32>(i32(difference * 4294967296.0)); }
    return bitcast<u32>(i32(clamp(difference * 2147483648.0, -2147483520.0, 2147483520.0))) << 1u;
}

// Longitudes go round: the shorter way.
fn difference_around(from_at: u32, to: u32) -> f32 {
    return f32(bitcast<i32>(to - from_at)) / 4294967296.0;
}

fn difference(from_at: u32, to: u32) -> f32 {
    return select(-f32(from_at - to), f32(to - from_at), to >= from_at) / 4294967296.0;
}

// atanh for |x| < 1, exact for small x too.
fn inverse_tanh(x: f32) -> f32 {
    let x2 = x * x;
    if x2 < 0.0025 { return x * (1.0 + x2 * (0.33333333 + x2 * (0.2 + x2 * 0.14285714))); }
    return 0.5 * log((1.0 + x) / (1.0 - x));
}

fn hyperbolic_tangent(x: f32) -> f32 {
    let x2 = x * x;
    if x2 < 0.0025 { return x * (1.0 - x2 * (0.33333333 - x2 * (0.13333333 - x2 * 0.053968254))); }
    let e = exp(-2.0 * min(abs(x), 20.0));
    return sign(x) * (1.0 - e) / (1.0 + e);
}

// A normal's difference, from the eye's east-north-up to earth axes turned to the eye's meridian (x outwards, y east, z pole).
fn meridian_from_local(d: vec3f) -> vec3f {
    return vec3f(d.z * frame.cos_lat - d.y * frame.sin_lat, d.x, d.y * frame.cos_lat + d.z * frame.sin_lat);
}

fn local_from_meridian(d: vec3f) -> vec3f {
    return vec3f(d.y, d.z * frame.cos_lat - d.x * frame.sin_lat, d.x * frame.cos_lat + d.z * frame.sin_lat);
}

fn square_of(sin_lat: f32) -> u32 {
    return select(select(MERCATOR, SOUTH, sin_lat < -POLAR_SIN_LAT), NORTH, sin_lat > POLAR_SIN_LAT);
}

fn map_point(dn: vec3f) -> MapPoint {
    let d = meridian_from_local(dn);
    let square = square_of(frame.sin_lat + d.z);
    if square == MERCATOR {
        let dlon = angle_of(d.y, frame.cos_lat + d.x);
        let ds = d.z + frame.mercator_sin_delta;
        let dpsi = inverse_tanh(clamp(ds / (1.0 - frame.mercator_sin * (frame.mercator_sin + ds)), -0.9999999, 0.9999999));
        return MapPoint(square, frame.mercator_fixed + vec2u(fixed_step(dlon / TURN), fixed_step(-dpsi / TURN)));
    }
    let north = square == NORTH;
    let side = select(-1.0, 1.0, north);
    let reference = select(frame.south_point, frame.north_point, north);
    let dr = d + select(frame.south_delta, frame.north_delta, north);
    let dp = (dr.xy - reference * side * dr.z) / (1.0 + side * (frame.sin_lat + d.z));
    // The reference point lies in axes turned to the eye's meridian; the square does not.
    let m = frame.meridian;
    let turned = vec2f(dp.x * m.x - dp.y * m.y, dp.x * m.y + dp.y * m.x) / (2.0 * POLAR_EXTENT);
    let fixed = select(frame.south_fixed, frame.north_fixed, north);
    return MapPoint(square, fixed + vec2u(fixed_step(turned.x), fixed_step(-turned.y)));
}

// The inverse: the normal's difference at a point of a square.
fn normal_delta_at(point: MapPoint) -> vec3f {
    if point.square == MERCATOR {
        let dlon = difference_around(frame.mercator_fixed.x, point.at.x) * TURN;
        let t = hyperbolic_tangent(-difference(frame.mercator_fixed.y, point.at.y) * TURN);
        let s0 = frame.mercator_sin;
        let ds = t * (1.0 - s0 * s0) / (1.0 + s0 * t) - frame.mercator_sin_delta;
        let s = frame.sin_lat + ds;
        let c = sqrt(max(1.0 - s * s, 0.0));
        let half_sin = sine_cosine(0.5 * dlon).sine;
        let dc = -ds * (s + frame.sin_lat) / (c + frame.cos_lat);
        return local_from_meridian(vec3f(dc - 2.0 * c * half_sin * half_sin, c * sine_cosine(dlon).sine, ds));
    }
    let north = point.square == NORTH;
    let side = select(-1.0, 1.0, north);
    let fixed = select(frame.south_fixed, frame.north_fixed, north);
    let turned = vec2f(difference(fixed.x, point.at.x), -difference(fixed.y, point.at.y)) * (2.0 * POLAR_EXTENT);
    let m = frame.meridian;
    let dp = vec2f(turned.x * m.x + turned.y * m.y, turned.y * m.x - turned.x * m.y);
    let reference = select(frame.south_point, frame.north_point, north);
    let p = reference + dp;
    let d2 = 2.0 * dot(reference, dp) + dot(dp, dp);
    let one_plus = 1.0 + dot(p, p);
    let dz = -2.0 * d2 / (one_plus * (1.0 + dot(reference, reference)));
    let dr = vec3f(dp * (2.0 / one_plus) + reference * dz, side * dz);
    return local_from_meridian(dr - select(frame.south_delta, frame.north_delta, north));
}
