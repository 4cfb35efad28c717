// Coordinates of the skylight tables: denser towards the horizon and towards low suns.
#import atmosphere

// Sun's zenith cosine below which the sea-level tables' sky is night: at 8 degrees of depression twilight is a thousandth of the light of a night
// without a moon as it is drawn. The air high up is lit for longer.
const SUN_COSINE_FROM = -0.14;
const LIT_COSINE_FROM = -0.3;
// A night without a moon: radiance of the sky, three times that at the horizon, where more of the air that glows is seen; irradiance of
// the ground, brighter than any moon's, so that the dark side can be made out from space (`night_ground`).
const NIGHT = vec3f(0.5e-4, 0.7e-4, 1.2e-4);
const NIGHT_IRRADIANCE = vec3f(0.006, 0.008, 0.012);

fn night_sky(mu: f32) -> vec3f {
    let low = 1.0 - saturate(mu);
    return frame.night * NIGHT * (0.7 + 1.4 * low * low * low);
}

fn coordinate_from(least: f32, mu: f32) -> f32 { return sqrt(clamp((mu - least) / (1.0 - least), 0.0, 1.0)); }

fn cosine_from(least: f32, x: f32) -> f32 { return least + x * x * (1.0 - least); }

fn sun_coordinate(mu_sun: f32) -> f32 { return coordinate_from(SUN_COSINE_FROM, mu_sun); }

fn sun_from_coordinate(x: f32) -> f32 { return cosine_from(SUN_COSINE_FROM, x); }

fn view_coordinate(mu: f32) -> f32 { return sqrt(clamp(mu, 0.0, 1.0)); }

fn view_from_coordinate(x: f32) -> f32 { return x * x; }

// Of the table of light that has been scattered before: the sun's zenith cosine at height h, and the height. And back.
fn multiple_coordinates(h: Metres, mu_sun: f32) -> vec2f { return vec2f(coordinate_from(LIT_COSINE_FROM, mu_sun), clamp(h / TOP, 0.0, 1.0)); }

fn multiple_view(x: vec2f) -> vec2f { return vec2f(x.y * TOP, cosine_from(LIT_COSINE_FROM, x.x)); }
