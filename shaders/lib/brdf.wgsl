// Reflection at the rough sea: Fresnel, the sun's glitter, and what facets mirror that a pixel cannot resolve.
#import normal

const WATER_INDEX = 1.333;

// Unpolarised Fresnel reflectance from air into water, exact (Born and Wolf).
fn fresnel_water(cos_incident: f32) -> f32 {
    let c = clamp(cos_incident, 0.0, 1.0);
    let g = sqrt(WATER_INDEX * WATER_INDEX - 1.0 + c * c);
    let a = (g - c) / (g + c);
    let b = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return 0.5 * a * a * (1.0 + b * b);
}

// Share of diffuse light from below that the surface sends back down: what does not leave it, (1 - 0.066) / n² (J. Saunderson 1942, with
// D. Judd's reflectance of 0.066 for diffuse light from above).
const MIRRORED_BACK = 1.0 - (1.0 - 0.066) / (WATER_INDEX * WATER_INDEX);

@group(1) @binding(10) var rough_mirrors: texture_2d<f32>;   // reflectance, sine of the elevation; of src/model/rough_water.rs

struct Mirrored { reflectance: f32, sine: f32 }

// What facets about a mean plane mirror, which is seen under the cosine `cos_view`, with slopes of variance sigma2 along the view.
fn rough_mirror(cos_view: f32, sigma2: f32) -> Mirrored {
    let root = sign(cos_view) * sqrt(abs(cos_view));
    let place = vec2f((root + 0.5) / 1.5, sqrt(sqrt(sigma2) / 0.6));
    let size = vec2f(textureDimensions(rough_mirrors));
    let mean = textureSampleLevel(rough_mirrors, clamped, (clamp(place, vec2f(0.0), vec2f(1.0)) * (size - 1.0) + 0.5) / size, 0.0).xy;
    return Mirrored(mean.x, mean.y);
}

// Variance of the slopes towards `direction`, of rough.x along the unit vector `along` and rough.y across it.
fn variance_towards(direction: vec3f, up: vec3f, along: vec3f, rough: vec2f) -> f32 {
    let flat = direction - dot(direction, up) * up;
    let ahead = dot(flat, along);
    return mix(rough.y, rough.x, ahead * ahead / max(dot(flat, flat), 1e-9));
}

// Area that facets show to a direction, of level ground's: `cosine` is what their mean plane shows, `spread` the deviation of that.
fn shown_area(cosine: f32, spread: f32) -> f32 {
    // As good as even: then the plane is all that shows.
    let least = max(spread, 1e-4);
    let x = clamp(cosine / least, -6.0, 1e5);
    return max(least * (x * normal_share(x) + exp(-0.5 * x * x) * 0.3989422804014327), 1e-7);
}

struct Glitter {
    radiance: f32,         // per unit solar irradiance
    chance: f32,           // how usual the slopes that mirror the sun are, of the most usual ones
}

// The sun's glitter, for Gaussian slopes about `normal` of variance rough.x along the
// unit vector `along` and rough.y across it (C. Cox and W. Munk 1954), of facets that neither hides from eye or sun, by Smith's
// shadowing for correlated heights (V. Ross, D. Dion and G. Potter 2005).
fn glitter(view: vec3f, sun: vec3f, normal: vec3f, up: vec3f, along: vec3f, rough: vec2f) -> Glitter {
    let sum = view + sun;
    let half_vector = sum / max(length(sum), 1e-6);
    let hz = max(dot(half_vector, up), 1e-3);
    let slope_h = (half_vector - hz * up) / hz;
    let nz = max(dot(normal, up), 1e-3);
    let slope_n = (normal - nz * up) / nz;
    let d = slope_h - slope_n;
    let variance = max(rough, vec2f(1e-5));        // the sun's own disc: (0.27 deg / 2)^2 on each axis
    let d_along = dot(d, along);
    let d_across = max(dot(d, d) - d_along * d_along, 0.0);
    let chance = exp(-0.5 * (d_along * d_along / variance.x + d_across / variance.y));
    let density = chance / (6.283185307179586 * sqrt(variance.x * variance.y));
    let seen = shown_part(view, normal, nz, up, along, variance);
    let lit = shown_part(sun, normal, nz, up, along, variance);
    let unhidden = max(seen.y + max(seen.x, 0.0) * (lit.y / max(lit.x, 1e-4) - 1.0), 1e-6);
    return Glitter(fresnel_water(dot(half_vector, view)) * density / (4.0 * hz * hz * hz * hz * unhidden), chance);
}

// What a patch with the mean plane of `normal` shows to a direction, of level ground's area: the plane, and its facets.
fn shown_part(direction: vec3f, normal: vec3f, normal_z: f32, up: vec3f, along: vec3f, variance: vec2f) -> vec2f {
    let plane = dot(direction, normal) / normal_z;
    let z = dot(direction, up);
    let spread = sqrt(max(1.0 - z * z, 0.0) * variance_towards(direction, up, along, variance));
    return vec2f(plane, shown_area(plane, spread));
}
