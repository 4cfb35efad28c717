// Coordinates of the skylight tables: denser towards the horizon and towards low suns.

const SUN_COSINE_FROM = -0.3;      // below it the table's sky is night
const NIGHT = vec3f(2.0e-4, 2.6e-4, 4.0e-4);                // brighter than any moon, so that the dark side can be made out

fn sun_coordinate(mu_sun: f32) -> f32 {
    let x = clamp((mu_sun - SUN_COSINE_FROM) / (1.0 - SUN_COSINE_FROM), 0.0, 1.0);
    return sqrt(x);
}

fn sun_from_coordinate(x: f32) -> f32 { return SUN_COSINE_FROM + x * x * (1.0 - SUN_COSINE_FROM); }

fn view_coordinate(mu: f32) -> f32 { return sqrt(clamp(mu, 0.0, 1.0)); }

fn view_from_coordinate(x: f32) -> f32 { return x * x; }

