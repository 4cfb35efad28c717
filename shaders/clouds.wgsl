// Clouds before everything that has been drawn: water clouds step by step through their layer, ice clouds as a shell. `GLOBE`: the
// ellipsoid is all that may stand in front of them.
#import full_screen
#import clouds
#import light
#import air

@group(2) @binding(0) var scene_depth: texture_depth_2d;

const STEPS = 20u;
const CLOUD_CELL: Metres = 2500.0;     // as wide as clouds are: along so much of a ray they are one

// Light that a cloud sends on, of what falls on it: nearly all, in all directions, over the way that it has to go through it.
fn cloud_source(sun: vec3f, sky: vec3f, optical_depth: f32, height: f32, phase: f32) -> vec3f {
    let lit = 0.55 * exp(-optical_depth) * phase + 0.4 * exp(-0.2 * optical_depth) + 0.09;
    return (sun * lit * 0.95 + sky * (0.55 + 0.45 * height)) / PI;
}

// Light from the sun's side is stronger, of one that is isotropic.
fn cloud_phase(c: f32) -> f32 { return 0.75 + 0.9 * pow(0.5 + 0.5 * c, 12.0); }

struct Veil { radiance: vec3f, through: f32 }

// Where a ray is within the layer, as far as it is seen.
fn layer_stretch(ray: Ray, far: Metres) -> vec2f {
    let outer = shell_hits(ray, CLOUD_TOP);
    let inner = shell_hits(ray, CLOUD_BASE);
    let altitude = frame.eye_altitude;
    let missed = (outer.x > outer.y) | (outer.y < 0.0);
    var first = select(0.0, outer.x, altitude > CLOUD_TOP);
    first = select(first, inner.y, altitude < CLOUD_BASE);
    let goes_below = (altitude >= CLOUD_BASE) & (inner.x <= inner.y) & (inner.x > 0.0);
    let last = min(select(outer.y, inner.x, goes_below), far);
    return select(vec2f(first, last), vec2f(1.0, 0.0), missed);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let direction = normalize(frame.ray_forward + corner.device.x * frame.ray_right + corner.device.y * frame.ray_up);
    let ray = eye_ray(direction);
    let hit = surface_hit(ray);
    var far = select(hit, 1e9, hit < 0.0);
    if !GLOBE {
        let depth = textureLoad(scene_depth, vec2u(corner.position.xy), 0);
        far = min(far, NEAR / max(depth, 1e-10) / max(dot(direction, frame.ray_forward), 1e-3));
    }
    let phase = cloud_phase(dot(direction, frame.light));
    var veil = Veil(vec3f(0.0), 1.0);

    let stretch = layer_stretch(ray, far);
    let step = max(stretch.y - stretch.x, 0.0) / f32(STEPS);
    // Each pixel begins elsewhere in its first step: grain instead of bands.
    let grain = f32(hash(vec3u(vec2u(corner.position.xy), 0u)) >> 8u) / 16777216.0;
    var way = 0.0;
    for (var i = 0u; i < STEPS; i++) {
        let t = stretch.x + (f32(i) + 0.2 + 0.6 * grain) * step;
        let at = direction * t;
        let height = (height_along(ray, t) - CLOUD_BASE) / (CLOUD_TOP - CLOUD_BASE);
        let level = cloud_level(cloud_place(at), max(t * frame.pixel_angle, 0.25 * step));
        let cloud = in_cloud(level, CLOUD_TALL * height);
        // Of the way through as many clouds as it meets.
        let clouds = max(step / CLOUD_CELL, 1.0);
        let opaque = cloud.share * (1.0 - exp(-CLOUD_EXTINCTION * cloud.excess * step / clouds));
        let shade = 1.0 - pow(1.0 - opaque, clouds);
        let up = normalize(normal_delta(at) + vec3f(0.0, 0.0, 1.0));
        let mu = dot(frame.light, up);
        // What stands between here and the sun, looked at once.
        let ahead = 350.0;
        let near_sun = cloud_level(cloud_place(at + ahead * frame.light), max(t * frame.pixel_angle, 300.0));
        let over = min((1.0 - height) * (CLOUD_TOP - CLOUD_BASE) / max(mu, 0.1), 900.0);
        let shadow = in_cloud(near_sun, CLOUD_TALL * (height + ahead * mu / (CLOUD_TOP - CLOUD_BASE)));
        let optical_depth = 0.5 * CLOUD_EXTINCTION * over * shadow.share * shadow.excess;
        let daylight = daylight_at(mu);
        let sun = SUN_IRRADIANCE * sunlight(CLOUD_TOP, mu);
        veil.radiance += veil.through * shade * cloud_source(sun, daylight.sky, optical_depth, saturate(height), phase);
        way += veil.through * shade * t;
        veil.through *= 1.0 - shade;
        if veil.through < 0.01 { break; }
    }
    let hidden_low = 1.0 - veil.through;
    let air = haze(direction, way / max(hidden_low, 1e-4));
    veil.radiance = veil.radiance * air.transmittance + hidden_low * air.radiance;

    // Ice clouds, behind the others or before them.
    let shell = shell_hits(ray, ICE_HEIGHT);
    let is_below = frame.eye_altitude < ICE_HEIGHT;
    let t = select(shell.x, shell.y, is_below);
    if (shell.x <= shell.y) & (t > 0.0) & (t < far) {
        let at = direction * t;
        let up = normalize(normal_delta(at) + vec3f(0.0, 0.0, 1.0));
        let mu = dot(frame.light, up);
        let thickness = ice_optical_depth(cloud_place(at), t * frame.pixel_angle);
        let shade = 1.0 - exp(-thickness / max(abs(dot(direction, up)), 0.12));
        let before = haze(direction, t);
        let sun = SUN_IRRADIANCE * sunlight(ICE_HEIGHT, mu);
        let lit = (0.55 * sun * phase + 0.5 * daylight_at(mu).sky) / PI;
        let seen = shade * (lit * before.transmittance + before.radiance);
        veil.radiance = select(seen + (1.0 - shade) * veil.radiance, veil.radiance + veil.through * seen, is_below);
        veil.through *= 1.0 - shade;
    }
    let hidden = 1.0 - veil.through;
    return vec4f(veil.radiance * frame.exposure, hidden);
}
