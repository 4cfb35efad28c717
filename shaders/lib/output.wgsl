// What a pixel reports: the picture, or one measured layer (`ocean-globe render --layer`). Mirrors `Output` in src/scene/frame/uniform.rs.
#import map

const PICTURE = 0u;
const LONLAT = 1u;      // degrees east, degrees north
const DEPTH = 2u;       // metres of water; 0 on land, NaN-free: -1 in the sky
const MASK = 3u;        // alpha of the water; 0 on land, -1 in the sky
const HEIGHT = 4u;      // metres of the sea surface (or of the ground) above the ellipsoid
const NORMAL = 5u;      // unit normal, east north up at the eye
const CLASS = 6u;       // 1 ocean, 2 lake, 3 river, 0 land, -1 sky
const PERLIN_WEIGHT = 7u;
const ALBEDO = 8u;      // linear, of the ground; 0 where the sea covers it

struct Measured {
    rest: vec3f,        // point of the ellipsoid, local
    distance: Metres,
    depth: Metres,
    alpha: f32,
    height: Metres,
    normal: vec3f,
    water_class: f32,
    perlin_weight: f32,
    albedo: vec3f,
}

fn sky_output() -> vec4f { return vec4f(-1.0, -1.0, -1.0, 0.0); }

// Degrees east of the eye's meridian and degrees north of the eye's parallel: differences, which f32 holds; the
// caller adds the eye's own coordinates in f64.
fn lonlat_delta(p: vec3f) -> vec2f {
    let dn = normal_delta(p);
    let d = meridian_from_local(dn);
    let dlon = angle_of(d.y, frame.cos_lat + d.x);
    // Angle between two latitudes from the differences of their sines and cosines.
    let c = sqrt(max((frame.cos_lat + d.x) * (frame.cos_lat + d.x) + d.y * d.y, 0.0));
    let s = frame.sin_lat + d.z;
    let dc = -d.z * (s + frame.sin_lat) / max(c + frame.cos_lat, 1e-6);
    let dlat = angle_of(d.z * frame.cos_lat - dc * frame.sin_lat, c * frame.cos_lat + s * frame.sin_lat);
    return degrees(vec2f(dlon, dlat));
}

fn measured_output(m: Measured, radiance: vec3f) -> vec4f {
    switch frame.output {
        case LONLAT: { return vec4f(lonlat_delta(m.rest), m.distance, 1.0); }
        case DEPTH: { return vec4f(m.depth, m.distance, 0.0, 1.0); }
        case MASK: { return vec4f(m.alpha, m.distance, 0.0, 1.0); }
        case HEIGHT: { return vec4f(m.height, m.distance, 0.0, 1.0); }
        case NORMAL: { return vec4f(m.normal, 1.0); }
        case CLASS: { return vec4f(m.water_class, m.distance, 0.0, 1.0); }
        case PERLIN_WEIGHT: { return vec4f(m.perlin_weight, m.distance, 0.0, 1.0); }
        case ALBEDO: { return vec4f(m.albedo, 1.0); }
        default: { return vec4f(radiance * frame.exposure, 1.0); }
    }
}
