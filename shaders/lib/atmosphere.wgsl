// Single scattering in an exponential atmosphere over the ellipsoid, with a simple second order. Coefficients: E. Bruneton
// and F. Neyret 2008, S. Hillaire 2020. Air mass: C. Schueler 2012, "An approximation to the Chapman grazing-incidence function".
#import ellipsoid

const RAYLEIGH = vec3f(5.802e-6, 13.558e-6, 33.1e-6);    // per metre at sea level
const MIE = 2.7e-6;                                      // clear maritime air, visibility about 80 km
const MIE_EXTINCTION = 3.0e-6;
const OZONE = vec3f(0.65e-6, 1.881e-6, 0.085e-6);
const OZONE_THICKNESS: Metres = 15000.0;
const OZONE_HEIGHT: Metres = 25000.0;
const RAYLEIGH_HEIGHT: Metres = 8000.0;                  // scale heights
const MIE_HEIGHT: Metres = 1200.0;
const TOP: Metres = 100000.0;
const SUN_IRRADIANCE = vec3f(1.0, 0.98, 0.95);           // the unit of radiance; colour of the extraterrestrial sun
const PI = 3.141592653589793;

// Column seen towards zenith cosine mu from height h, in units of the vertical column at h.
fn air_mass(h: Metres, mu: f32, scale: Metres) -> f32 {
    let x = (frame.semi_major + h) / scale;
    let c = sqrt(0.5 * PI * x);
    if mu >= 0.0 { return c / ((c - 1.0) * mu + 1.0); }
    let sin2 = max(1.0 - mu * mu, 0.0);
    let x0 = sqrt(sin2) * x;                              // at the ray's lowest point
    let c0 = sqrt(0.5 * PI * x0);
    return min(2.0 * c0 * exp(min(x - x0, 60.0)) - c / ((c - 1.0) * -mu + 1.0), 1e6);
}

// Share of sunlight that reaches height h with the sun at zenith cosine mu; the earth's shadow has a soft edge.
fn sunlight(h: Metres, mu: f32) -> vec3f {
    let r = frame.semi_major + max(h, 0.0);
    let horizon = -sqrt(max(1.0 - (frame.semi_major / r) * (frame.semi_major / r), 0.0));
    let visible = smoothstep(-0.006, 0.006, mu - horizon);
    if visible <= 0.0 { return vec3f(0.0); }
    let safe_mu = max(mu, horizon + 1e-4);
    let rayleigh = RAYLEIGH_HEIGHT * exp(-h / RAYLEIGH_HEIGHT) * air_mass(h, safe_mu, RAYLEIGH_HEIGHT);
    let mie = MIE_HEIGHT * exp(-h / MIE_HEIGHT) * air_mass(h, safe_mu, MIE_HEIGHT);
    let ratio = min(r / (frame.semi_major + OZONE_HEIGHT), 1.0);
    let ozone = OZONE_THICKNESS / sqrt(max(1.0 - ratio * ratio * (1.0 - safe_mu * safe_mu), 0.002))
        * select(1.0, 0.0, h > OZONE_HEIGHT && mu > 0.0);
    return visible * exp(-(RAYLEIGH * rayleigh + vec3f(MIE_EXTINCTION) * mie + OZONE * ozone));
}

fn rayleigh_phase(c: f32) -> f32 { return 3.0 / (16.0 * PI) * (1.0 + c * c); }

// Cornette-Shanks, g = 0.8.
fn mie_phase(c: f32) -> f32 {
    let g = 0.8;
    let d = max(1.0 + g * g - 2.0 * g * c, 1e-4);
    return 3.0 / (8.0 * PI) * (1.0 - g * g) * (1.0 + c * c) / ((2.0 + g * g) * d * sqrt(d));
}

struct Scattered { radiance: vec3f, transmittance: vec3f }

// Where a ray starts and what lights it: the ray, its unit direction, the ellipsoid's gradient at its start, what is added to the
// gradient per metre along the ray, the sun.
struct Sight { ray: Ray, direction: vec3f, gradient: vec3f, gradient_turn: vec3f, sun: vec3f }

// Light scattered towards the start of a ray between two distances, and what of the far end's light comes through. Steps are
// short where the air is dense: at the near end for a `sink` of 0, at the far end for 1, even for ½.
fn scatter(sight: Sight, from_t: f32, to_t: f32, steps: u32, sink: f32) -> Scattered {
    var optical = vec3f(0.0);
    var sum = vec3f(0.0);
    let c = dot(sight.direction, sight.sun);
    let pr = rayleigh_phase(c);
    let pm = mie_phase(c);
    var previous = 0.0;
    for (var i = 0u; i < steps; i++) {
        let x = (f32(i) + 1.0) / f32(steps);
        let grown = mix(x * x, x * (2.0 - x), sink);
        let t = mix(from_t, to_t, 0.5 * (previous + grown));
        let dt = (to_t - from_t) * (grown - previous);
        previous = grown;
        let h = max(height_along(sight.ray, t), 0.0);
        let up = normalize(sight.gradient + t * sight.gradient_turn);
        let mu_sun = dot(up, sight.sun);
        let density_r = exp(-h / RAYLEIGH_HEIGHT);
        let density_m = exp(-h / MIE_HEIGHT);
        let density_o = max(1.0 - abs(h - OZONE_HEIGHT) / OZONE_THICKNESS, 0.0);
        let extinction = RAYLEIGH * density_r + vec3f(MIE_EXTINCTION * density_m) + OZONE * density_o;
        // Higher orders, roughly isotropic: a third of the first overhead, and most of the light at the end of long paths.
        let ambient = (vec3f(0.02) + 0.06 * (vec3f(1.0) - exp(-optical))) * smoothstep(-0.15, 0.4, mu_sun);
        let lit = sunlight(h, mu_sun);
        let source = RAYLEIGH * density_r * (pr * lit + ambient) + MIE * density_m * (pm * lit + ambient);
        let step_optical = extinction * dt;
        let inside = (vec3f(1.0) - exp(-step_optical)) / max(extinction, vec3f(1e-12));
        sum += exp(-optical) * source * inside;
        optical += step_optical;
    }
    return Scattered(sum * SUN_IRRADIANCE, exp(-optical));
}

// How much denser the air is at sea level than at the eye, 0…1: the more, the more of a ray's air lies at its far end.
fn eye_sink() -> f32 { return 1.0 - exp(-max(frame.eye_altitude, 0.0) / RAYLEIGH_HEIGHT); }

// The atmosphere's part of a ray from the eye that ends at distance `to_t` on a surface; few steps serve a short way.
fn scatter_to_surface(direction: vec3f, to_t: f32) -> Scattered {
    return scatter_to(direction, to_t, u32(clamp(2.0 + to_t / 8000.0, 2.0, 10.0)), eye_sink());
}

// The atmosphere's part of a ray from the eye into the sky: from high up its air lies in the middle of the way.
fn scatter_to_sky(direction: vec3f) -> Scattered { return scatter_to(direction, 1e9, 24u, 0.5 * eye_sink()); }

fn scatter_to(direction: vec3f, to_t: f32, steps: u32, sink: f32) -> Scattered {
    let ray = eye_ray(direction);
    let shell = shell_hits(ray, TOP);
    if shell.y <= max(shell.x, 0.0) { return Scattered(vec3f(0.0), vec3f(1.0)); }
    let sight = Sight(ray, direction, frame.quadric_gradient, quadric_times(direction), frame.sun);
    return scatter(sight, max(shell.x, 0.0), min(shell.y, to_t), steps, sink);
}
