// Spray that strong winds tear off crests: white air near the water, thinner with height; src/model/spray.rs has the numbers. Beyond it
// is the air itself. Who imports this declares SPRAY (src/pass/kind.rs): whether there is any.
#import light

const SPRAY_LIGHT = 1.3;           // of thick spray over the sky's at the horizon behind it, which shows thick air, and its share of the
const SPRAY_WHITE = 0.8;           // colour of daylight, which drops have; both ours
const SPRAY_REFLECTS = 0.3;        // at least, of daylight: drops take none, and a high sun leaves the sky at the horizon dark

// Over which it thins out by a factor of e.
fn spray_height() -> Metres { return SPRAY_LEAST_HEIGHT + frame.wave_height; }

// Optical depth of the spray between the eye and `distance` along a ray that climbs by `rise` per metre.
fn spray_depth(rise: f32, distance: Metres) -> f32 {
    let from_height = max(frame.eye_altitude, 0.0) / spray_height();
    let to_height = max(from_height + rise * distance / spray_height(), 0.0);
    let climbed = to_height - from_height;
    let mean = select((exp(-from_height) - exp(-to_height)) / climbed, exp(-from_height), abs(climbed) < 1e-3);
    return frame.spray * distance * mean;
}

// Optical depth of the spray before the sky; along the horizon as much as an arc of the earth holds.
fn spray_before_sky(rise: f32) -> f32 {
    let height = spray_height();
    let least = sqrt(2.0 * height / (PI * frame.semi_major));
    return frame.spray * height * exp(-max(frame.eye_altitude, 0.0) / height) / max(rise, least);
}

// Radiance of spray so thick that nothing is seen through it, in the daylight of a place with a vertical `up`.
fn spray_light(light: Daylight, up: vec3f, direction: vec3f) -> vec3f {
    let level = direction - dot(direction, up) * up;
    let behind = sky_at_sea(normalize(level + 0.02 * length(level) * up + 1e-6 * up), up);
    // Its colour is that of the light there; clouds dim it as they do the air.
    let sine = max(dot(frame.light, up), 0.0);
    let down = light.sun * sine + light.sky;
    let clear = daylight_at(dot(frame.light, up));
    let lit = max(SPRAY_LIGHT * dot(behind, LUMINANCE), SPRAY_REFLECTS / PI * dot(clear.sun * sine + clear.sky, LUMINANCE));
    let white = lit / max(dot(down, LUMINANCE), 1e-9) * down;
    return under_clouds(mix(SPRAY_LIGHT * behind, white, SPRAY_WHITE), light.air);
}

// Radiance of a surface in that daylight, through spray and air.
fn through_air(radiance: vec3f, light: Daylight, up: vec3f, direction: vec3f, distance: Metres) -> vec3f {
    return through_spray(radiance, light, light, up, direction, distance, vec2f(1.0, 0.0));
}

// The same through spray that gusts drive: so many times as dense as usual (x), and a thin sheet on the water besides, of an optical depth (y). `near`: the daylight of thick spray's near side.
fn through_spray(radiance: vec3f, light: Daylight, near: Daylight, up: vec3f, direction: vec3f, distance: Metres, driven: vec2f) -> vec3f {
    if !SPRAY {
        let air = haze(direction, distance);
        return radiance * air.transmittance + lit_air(air, light);
    }
    let depth = driven.x * spray_depth(direction.z, distance);
    let left = exp(-depth);
    // What thick spray shows is its near side; from high above all of it is far away.
    let inside = depth / (driven.x * frame.spray);
    let air = haze(direction, distance - inside * select(1.0 - (1.0 - left) / depth, 0.0, depth < 1e-3));
    return mix(spray_light(near, up, direction), radiance, left * exp(-driven.y)) * air.transmittance + lit_air(air, light);
}
