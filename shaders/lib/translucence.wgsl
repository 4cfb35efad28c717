// Light through crests: what the sun sends into the back of a wave and the water scatters on towards the eye. Between its face and its
// back a crest is taken for a parabola over the horizontal way from where it is seen, the sun's light on its way through it for as deep as
// the water is in the mean above the refracted sight. In flat water there is none: that the water's own reflectance holds.
#import atmosphere
#import brdf
#import water_types

const FORWARD: f32 = 0.75;         // asymmetry of what scatters in the water, as of Henyey and Greenstein
const SCATTERED: f32 = 0.06;       // by open water, per metre
const SCATTERED_BY_PLUMES: f32 = 0.3;
const ENTERING: f32 = 0.95;        // of sunlight into water, through the back of a crest
const LEAST_REFRACTED: f32 = 0.66; // sine of the elevation, in water, of a sun on the horizon

const CRESTS_GLOW = vec2f(100.0, 300.0);   // metres over which crests become too small to tell what shines through them

fn crests_shown(distance: Metres) -> f32 { return 1.0 - smoothstep(CRESTS_GLOW.x, CRESTS_GLOW.y, distance); }

fn forward_phase(c: f32) -> f32 {
    let d = 1.0 + FORWARD * FORWARD - 2.0 * FORWARD * c;
    return (1.0 - FORWARD * FORWARD) / (4.0 * PI * d * sqrt(d));
}

// A unit vector in air as it goes on in the water below `normal`, towards which the vector points.
fn into_water(direction: vec3f, normal: vec3f) -> vec3f {
    let c = min(dot(direction, normal), 0.0);
    let along = (direction - c * normal) / WATER_INDEX;
    return along - sqrt(max(1.0 - dot(along, along), 0.0)) * normal;
}

// Radiance just below the surface, towards the eye. `ahead`: how far and how much higher the surface is a way ahead. `sun`: irradiance of a plane
// that faces the sun.
fn crest_light(direction: vec3f, normal: vec3f, up: vec3f, ahead: vec2f, kind: f32, plume: f32, sun: vec3f) -> vec3f {
    let inside = into_water(direction, normal);
    let flat = max(length(inside - dot(inside, up) * up), 1e-3);
    let level = direction - dot(direction, up) * up;
    let rise = -dot(normal, level) / max(length(level) * dot(normal, up), 1e-3);
    // The surface over the sight, x metres ahead: begins x + bend x^2.
    let begins = max(rise - dot(inside, up) / flat, 0.0);
    let bend = min((ahead.y / max(ahead.x, 0.1) - rise) / max(ahead.x, 0.1), -1e-5);
    let way = -begins / (bend * flat);
    let over = -begins * begins / (6.0 * bend);

    let to_sun = -into_water(-frame.light, up);
    // A sun deep below the horizon, which has no light, would stand below it in the water, too.
    let mu = max(dot(to_sun, up), LEAST_REFRACTED);
    let lost = attenuation(kind);
    let crest = forward_phase(dot(to_sun, inside)) * exp(-lost * over / mu) * (vec3f(1.0) - exp(-lost * way)) / lost;
    // What the same sight of level water holds already.
    let below = into_water(direction, up);
    let even = forward_phase(dot(to_sun, below)) / (lost * (1.0 - dot(below, up) / mu)) * max(dot(frame.light, up), 0.0) / mu;
    let scattered = SCATTERED + SCATTERED_BY_PLUMES * plume;
    return sun * ENTERING * scattered / (WATER_INDEX * WATER_INDEX) * max(crest - even, vec3f(0.0));
}
