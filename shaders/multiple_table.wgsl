// The light that has been scattered in the air before, for any eye and sun: S. Hillaire 2020, section 5.5.
#import air_coordinates
#import sunlight
#import sky_coordinates

@group(1) @binding(0) var transmittances: texture_2d<f32>;
@group(1) @binding(1) var multiple_table: texture_storage_2d<rgba16float, write>;

const GROUND_ALBEDO = 0.06;          // of the sea
const ELEVATIONS = 16u;               // directions around a point: even shares of the sphere
const AZIMUTHS = 6u;
const STEPS = 20u;

// What comes to a point from a direction: light that has been scattered once or reflected by the ground, and the share of the
// direction's light that would be scattered on its way if every place shone with radiance one.
struct Arriving { light: vec3f, share: vec3f }

fn arriving(h: Metres, mu: f32, azimuth: f32, mu_sun: f32) -> Arriving {
    let flat = sqrt(max(1.0 - mu * mu, 0.0));
    let cosine = mu * mu_sun + flat * sqrt(max(1.0 - mu_sun * mu_sun, 0.0)) * cos(azimuth);   // of the angle from the sun
    let curvature = 0.5 / frame.semi_major;
    let ray = Ray(curvature, 0.5 * mu * (1.0 + h / frame.semi_major), h * (1.0 + h * curvature));
    let ground = shell_hits(ray, 0.0);
    let meets = mu < 0.0 && ground.y >= ground.x;
    let reach = select(shell_hits(ray, TOP).y, max(ground.x, 0.0), meets);
    var found = Arriving(vec3f(0.0), vec3f(0.0));
    var through = vec3f(1.0);
    var t = 0.0;
    for (var i = 1u; i <= STEPS; i++) {
        let next = reach * warped(f32(i) / f32(STEPS), select(0.0, 1.0, mu < 0.0));
        let middle = 0.5 * (t + next);
        let height = clamp(height_along(ray, middle), 0.0, TOP);
        let mu_here = clamp(((frame.semi_major + h) * mu_sun + middle * cosine) / (frame.semi_major + height), -1.0, 1.0);
        let air = medium_at(height);
        let passed = exp(air.extinction * (t - next));
        let far = through * seen_length(air.extinction, passed);
        found.light += (air.rayleigh * rayleigh_phase(cosine) + air.mie / (4.0 * PI)) * far * sunlight(height, mu_here);
        found.share += (air.rayleigh + air.mie) * far;
        through *= passed;
        t = next;
    }
    if meets {
        let mu_ground = ((frame.semi_major + h) * mu_sun + reach * cosine) / frame.semi_major;
        found.light += through * GROUND_ALBEDO / PI * max(mu_ground, 0.0) * sunlight(0.0, clamp(mu_ground, -1.0, 1.0));
    }
    return found;
}

// Radiance that comes from all around after two scatterings and more, per unit of solar irradiance. Molecules scatter the first by their phase, or
// twilight would end too early; otherwise light is taken as the same from everywhere: every further scattering passes on the same share.
@compute @workgroup_size(8, 8)
fn multiples(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(multiple_table);
    if any(id.xy >= size) { return; }
    let view = multiple_view(vec2f(id.xy) / vec2f(size - 1u));
    var light = vec3f(0.0);
    var share = vec3f(0.0);
    for (var i = 0u; i < ELEVATIONS; i++) {
        for (var j = 0u; j < AZIMUTHS; j++) {
            let mu = 2.0 * (f32(i) + 0.5) / f32(ELEVATIONS) - 1.0;
            let one = arriving(view.x, mu, PI * (f32(j) + 0.5) / f32(AZIMUTHS), view.y);
            light += one.light;
            share += one.share;
        }
    }
    let directions = f32(ELEVATIONS * AZIMUTHS);
    textureStore(multiple_table, id.xy, vec4f(light / directions / (vec3f(1.0) - share / directions), 1.0));
}
