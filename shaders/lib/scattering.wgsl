// Light scattered along a ray through the air over the ellipsoid, step by step: what the tables are made with. Who imports this
// declares `multiples` too, the table of light that has been scattered before, by sky_coordinates.wgsl's coordinates.
#import air_coordinates
#import sunlight
#import sky_coordinates

// `through`: the share of the far end's light that comes through.
struct Scattered { radiance: vec3f, through: vec3f }

const NOTHING_MET = Scattered(vec3f(0.0), vec3f(1.0));

// Where a ray starts and what lights it: the ray, the gradient of the height at its start and how it changes per metre, the sun, and
// the air's phase functions, Rayleigh's and Mie's.
struct Sight { ray: Ray, gradient: vec3f, turning: vec3f, sun: vec3f, phases: vec2f }

fn sight_along(ray: Ray, direction: vec3f, gradient: vec3f, turning: vec3f, sun: vec3f) -> Sight {
    let c = dot(direction, sun);
    return Sight(ray, gradient, turning, sun, vec2f(rayleigh_phase(c), mie_phase(c)));
}

// What lies between the start of a ray and `to_t`, when it is known up to `from_t`, in a single step.
fn stepped(sight: Sight, before: Scattered, from_t: f32, to_t: f32) -> Scattered {
    let t = 0.5 * (from_t + to_t);
    let h = clamp(height_along(sight.ray, t), 0.0, TOP);
    let up = normalize(sight.gradient + t * sight.turning);
    let mu_sun = dot(up, sight.sun);
    let air = medium_at(h);
    let place = table_place(multiple_coordinates(h, mu_sun), textureDimensions(multiples));
    let ambient = textureSampleLevel(multiples, clamped, place, 0.0).rgb;
    let lit = sunlight(h, mu_sun);
    let source = air.rayleigh * (sight.phases.x * lit + ambient) + air.mie * (sight.phases.y * lit + ambient);
    let passed = exp(air.extinction * (from_t - to_t));
    let inside = seen_length(air.extinction, passed);
    return Scattered(before.radiance + SUN_IRRADIANCE * before.through * source * inside, before.through * passed);
}

// Light scattered towards the start of a ray between two distances, in steps that grow by `warped`.
fn scatter(sight: Sight, from_t: f32, to_t: f32, steps: u32, sink: f32) -> Scattered {
    var all = NOTHING_MET;
    var t = from_t;
    for (var i = 1u; i <= steps; i++) {
        let next = mix(from_t, to_t, warped(f32(i) / f32(steps), sink));
        all = stepped(sight, all, t, next);
        t = next;
    }
    return all;
}
