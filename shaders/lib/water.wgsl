// Radiance of a water surface towards the eye: reflected sky and sun, the water body's own light, the bed seen through it.
#import cloud_light
#import light
#import brdf
#import foam_light
#import sparkle
#import water_types

const OPAQUE_ALPHA: f32 = 0.996; // of water from which on nothing of the bed can be seen
const STANDS_OUT = vec2f(0.4, 2.5);   // glitter over the water's other light from where on, and where all of it sparkles

fn water_alpha(depth: Metres) -> f32 {
    return clamp(1.0 - exp(-frame.water_density * max(depth, 0.0)), 0.0, 1.0);
}

// Unit vector along the wind, which blows from the same bearing everywhere.
fn along_wind(up: vec3f) -> vec3f {
    let east = cross(vec3f(0.0, frame.cos_lat, frame.sin_lat), up);
    let wind = frame.wind.x * east + frame.wind.y * cross(up, east);
    return normalize(wind + 1e-6 * vec3f(1.0, 0.0, 0.0));
}

// What lies under the water.
struct Bed {
    radiance: vec3f,       // of the dry bed in the same light
    way: Metres,           // of the light: straight down to it, and up along the sight
    gathered: f32,         // how much more light waves have sent there than a flat surface
}

// The way of a sight below the surface to a bed at a depth.
fn sight_to_bed(direction: vec3f, normal: vec3f, up: vec3f, depth: Metres) -> vec3f {
    let below = refract(direction, normal, 1.0 / WATER_INDEX);
    // Where waves turn it up it ends somewhere all the same.
    return below * depth / max(-dot(below, up), 0.3);
}

const BED_FADES: f32 = 0.9;      // alpha from which on the bed goes, before none of it is drawn

// What a way through water of a kind leaves of light.
fn left_of_way(way: Metres, kind: f32) -> vec3f { return exp(-attenuation(kind) * way); }

// Radiance below the surface of a bed, over what the water's index of refraction takes: wet, with the light that has been sent back to it.
fn bed_radiance(bed: Bed, kind: f32, down: vec3f) -> vec3f {
    let lit = bed.radiance * left_of_way(bed.way, kind);
    return lit * (1.0 - MIRRORED_BACK) / (1.0 - MIRRORED_BACK * saturate(PI * lit / (max(bed.gathered, 0.01) * max(down, vec3f(1e-12)))));
}

struct WaterPoint {
    at: vec3f,             // where, metres of the local frame
    to_eye: vec3f,
    up: vec3f,
    normal: vec3f,
    along: vec3f,          // unit vector along the wind
    rough: vec2f,          // unresolved slope variance along the wind and across it
    alpha: f32,
    kind: f32,             // of the water
    bed: Bed,
    foam: Foam,
    facets: Facets,
    glow: vec3f,           // radiance through crests, below the surface
    land: vec4f,           // radiance of land that it mirrors, and how much of what it mirrors that is
}

const NO_LAND = vec4f(0.0);

// What the facets of a place mirror to the eye, in the mean: how much, from where, and the variance of their slopes along the view.
struct MirroredSight { reflectance: f32, toward: vec3f, variance: f32 }

fn mirrored_sight(w: WaterPoint) -> MirroredSight {
    let cos_view = dot(w.normal, w.to_eye);
    let variance = variance_towards(w.to_eye, w.up, w.along, w.rough);
    let mean = rough_mirror(cos_view, variance);
    let away = cos_view * w.normal - w.to_eye;
    let toward = mean.sine * w.normal + sqrt(max(1.0 - mean.sine * mean.sine, 0.0)) * away / max(length(away), 1e-6);
    // What would come from under the horizon has been mirrored before, by other water.
    return MirroredSight(mean.reflectance, toward + 2.0 * max(-dot(toward, w.up), 0.0) * w.up, variance);
}

// `light`: the daylight at the point; `clear`: what it would be without clouds.
fn water_radiance(w: WaterPoint, light: Daylight, clear: Daylight) -> vec3f {
    let mu_sun = dot(frame.light, w.up);
    let sun = light.sun;
    let ambient = light.sky;
    let sight = mirrored_sight(w);
    let reflectance = sight.reflectance;
    var sky = sky_at_sea(sight.toward, w.up);
    if CLOUDS { sky = clouded_sky(sky, clear, light.cover, w.at, dot(sight.toward, w.up), w.up); }
    let reflected = mix(sky, w.land.rgb, w.land.a) * reflectance;
    let mean_glitter = glitter(w.to_eye, frame.light, w.normal, w.up, w.along, w.rough);
    let glints = light.disc * sun * mean_glitter.radiance;
    let down = sun * max(mu_sun, 0.0) + ambient;
    let body = (deep_reflectance(w.kind) + w.foam.plume * plume_reflectance(w.kind)) / (PI * (1.0 - fresnel_water(1.0))) * down;
    let way = w.bed.way * frame.water_density / USUAL_DENSITY;
    let shallow = bed_radiance(Bed(w.bed.radiance, way, w.bed.gathered), w.kind, down) + body * (1.0 - left_of_way(way, w.kind));
    let through = (mix(shallow, body, smoothstep(BED_FADES, OPAQUE_ALPHA, w.alpha)) + w.glow) * (1.0 - reflectance);
    // Where all else outshines the mean of the facets single ones do not stand out.
    let standing_out = smoothstep(STANDS_OUT.x, STANDS_OUT.y, glints.g / max(reflected.g + through.g, 1e-9));
    let sparkling = mix(1.0, sparkle(w.facets, mean_glitter.chance), standing_out);
    let sunny = clear.sun.g / max(clear.sun.g + clear.sky.g, 1e-9);
    let foam = foam_radiance(w.foam, w.normal, w.up, frame.light, sun, ambient, sunny);
    return mix((1.0 - w.foam.shade) * (reflected + sparkling * glints + through), foam, w.foam.white);
}
