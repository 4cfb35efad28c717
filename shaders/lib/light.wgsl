// Light at sea level from the tables of sky_table.wgsl: radiance of the sky and irradiance of the ground.
#import air
#import sky_coordinates

@group(1) @binding(5) var sky_radiance: texture_3d<f32>;    // view zenith cosine, azimuth from the sun, sun zenith cosine
@group(1) @binding(6) var sky_irradiance: texture_2d<f32>;  // x: sun zenith cosine
@group(1) @binding(9) var transmittances: texture_2d<f32>;  // towards the top of the air

// Sky radiance at sea level towards `direction`, where `up` is the local vertical.
fn sky_at_sea(direction: vec3f, up: vec3f) -> vec3f {
    let mu = dot(direction, up);
    let mu_sun = dot(frame.light, up);
    let flat_view = direction - mu * up;
    let flat_sun = frame.light - mu_sun * up;
    let c = dot(flat_view, flat_sun) / max(length(flat_view) * length(flat_sun), 1e-6);
    let azimuth = acos(clamp(c, -1.0, 1.0)) / PI;
    let size = vec3f(textureDimensions(sky_radiance));
    let x = vec3f(view_coordinate(mu), azimuth, sun_coordinate(mu_sun));
    return textureSampleLevel(sky_radiance, clamped, (x * (size - 1.0) + 0.5) / size, 0.0).rgb + night_sky(mu);
}

// Irradiance at sea level: of a plane that faces the sun, by the sun alone; of level ground, by the sky. `cover`: the share of the sky
// there that clouds cover. `air`: how far the air before the eye is lit as under a clear sky, 1, or under clouds alone, 0. `disc`: the part of the
// sun's irradiance that comes from its disc, the rest being what clouds before it have spread: that glints of nothing.
// `air_sky`: the sky's, under the clouds over the eye, which lights the air before it.
struct Daylight { sun: vec3f, sky: vec3f, cover: f32, air: f32, disc: f32, air_sky: vec3f }

fn daylight_at(mu_sun: f32) -> Daylight {
    let size = f32(textureDimensions(sky_irradiance).x);
    let x = (sun_coordinate(mu_sun) * (size - 1.0) + 0.5) / size;
    let sky = textureSampleLevel(sky_irradiance, clamped, vec2f(x, 0.5), 0.0).rgb + frame.night * frame.night_ground * NIGHT_IRRADIANCE;
    return Daylight(sun_irradiance_at(mu_sun), sky, 0.0, 1.0, 1.0, sky);
}

const LUMINANCE = vec3f(0.2126, 0.7152, 0.0722);
const CLOUDED_AIR = 0.65;          // how much less colour the air has under clouds; ours
const LIT_THROUGH = 0.5;           // light that clouds let through to the air below them, as they do to the ground (`shaded`)

// Light of air or spray, of what it is under a clear sky: closed clouds light it with less light, which is white.
fn under_clouds(radiance: vec3f, clear: f32) -> vec3f {
    let white = mix(radiance, vec3f(dot(radiance, LUMINANCE)), CLOUDED_AIR);
    return mix(LIT_THROUGH * white, radiance, clear);
}

// Light of the air before something. Tables know that of sun or moon alone: under clouds it has the light of these as well, which outlasts the sun's
// at sea level in twilight, and at night the sky's own. Else what is far would be black against both.
fn lit_air(air: Air, light: Daylight) -> vec3f {
    let of_night = light.air * exp(-max(frame.eye_altitude, 0.0) / RAYLEIGH_HEIGHT) * night_sky(0.0);
    return shaded_air(air, light) + (1.0 - air.transmittance) * of_night;
}

// The same without the night's, before a sky that has it.
fn shaded_air(air: Air, light: Daylight) -> vec3f {
    let of_clouds = (1.0 - light.air) * seen_from_below(0.0, 1.0) / PI * light.air_sky;
    return max(under_clouds(air.radiance, light.air), (1.0 - air.transmittance) * of_clouds);
}

// Radiance of closed clouds from below towards the sine `rise`, of the mean that lights level ground: light leaves a thick layer the less the more
// askew, 2 + 3 sine in Eddington's approximation and less of a sine where it is heaped, so that an overcast sky is darkest at the horizon. `closed`: how far
// clouds are, 0...1.
fn seen_from_below(rise: f32, closed: f32) -> f32 { return mix(1.0, 0.56 + 0.66 * saturate(rise), closed); }

fn sun_irradiance_at(mu_sun: f32) -> vec3f { return SUN_IRRADIANCE * sunlight(0.0, mu_sun); }
