// The water about an eye in it: what it scatters towards the eye and what it takes from what is seen through it. The daylight in it fades
// with depth by K_d, a beam with distance by c = K_d + b. A level sea of one kind of water, in which light is scattered once more towards
// the eye from where it comes down, has a closed form along any sight (R. Preisendorfer 1976, "Hydrologic Optics", the classical
// radiative-transfer equation): looking up it is bright, looking down dark, and far off it has the colour of the water.
#import water
#import translucence
#import caustic_map
#import hash
#import held

// What an image loses besides, per metre: light that is scattered off a beam. By kind of water, 0 gyre to 5 turbid; ours, after visibilities
// of 60, 50, 20, 12, 5 and 1.5 m.
fn scattering(kind: f32) -> f32 {
    let clear = mix(mix(0.03, 0.045, saturate(kind)), 0.13, saturate(kind - 1.0));
    return mix(mix(mix(clear, 0.24, saturate(kind - 2.0)), 0.6, saturate(kind - 3.0)), 2.0, saturate(kind - 4.0));
}

struct Underwater {
    fading: vec3f,         // of daylight with depth, K_d, per metre
    beam: vec3f,           // of a sight with distance, c
    sun: vec3f,            // irradiances of a level plane just below the surface, by the sun and by the sky
    sky: vec3f,
    to_sun: vec3f,         // as an eye in the water sees it through a flat surface
    body: vec3f,           // what water sends straight up of the light that falls into it, per metre of a sight
    haze: f32,             // what scatters, per metre
}

const ENTERED_SKY: f32 = 0.934;    // share of diffuse light that enters the water (D. Judd's 0.066 is mirrored)
// Radiance below the surface of what leaves it, n² / (1 - R), over pi: a reflectance is of light that has come through.
const BELOW: f32 = WATER_INDEX * WATER_INDEX / (0.98 * PI);

// The water at the eye's place in the daylight there.
fn underwater(light: Daylight) -> Underwater { return underwater_of(water_kind(map_point(vec3f(0.0)), frame.sin_lat, frame.eye_depth), light); }

fn underwater_of(kind: f32, light: Daylight) -> Underwater {
    let mu = max(frame.light.z, 0.0);
    let fading = attenuation(kind);
    let haze = scattering(kind);
    let beam = fading + haze;
    // Clear water is a purer blue than displays have, its red below 0, where the table has 0. As much white as that lacks keeps the hue: red
    // of pure spectral blues is -(0.1 blue + 1.07 green), water's about three fifths of it.
    let pure = deep_reflectance(kind);
    let white = max(0.6 * (0.1 * pure.b + 1.07 * pure.g) - pure.r, 0.0) * (1.0 - saturate(kind - 3.0));
    let body = (pure + vec3f(0.0, white, white)) * pure.b / (pure.b + white);
    return Underwater(fading, beam, light.sun * mu * (1.0 - fresnel_water(mu)), light.sky * ENTERED_SKY,
        -into_water(-frame.light, vec3f(0.0, 0.0, 1.0)), BELOW * body * (beam + fading), haze);
}

// Henyey and Greenstein's phase function over what it is straight back, for an asymmetry of 0.55: for skylight, which comes from everywhere
// within Snell's window.
fn sky_phase(c: f32) -> f32 { return pow(2.4025 / max(1.3025 - 1.1 * c, 0.01), 1.5); }

// Of the daylight at the surface what is left at an altitude below it.
fn left_at(w: Underwater, altitude: Metres) -> vec3f { return exp(w.fading * min(altitude, 0.0)); }

// Light that the water scatters into a sight over a distance from a place at an altitude below the surface; `rays`: how much of the sun's
// there is over its mean.
fn veil(w: Underwater, altitude: Metres, direction: vec3f, distance: Metres, rays: f32) -> vec3f {
    let left = left_at(w, altitude);
    let rate = w.beam - w.fading * direction.z;
    let inside = (vec3f(1.0) - exp(-rate * distance)) / rate;
    let sun = forward_phase(dot(w.to_sun, direction)) / forward_phase(-w.to_sun.z);
    let falling = rays * sun * w.sun + sky_phase(direction.z) * w.sky;
    // Light from the bed is scattered evenly.
    let risen = BED_ALBEDO * exp(-w.fading * 2.0 * frame.eye_depth) / left * (w.sun + w.sky);
    return left * w.body * falling * inside + w.haze / (4.0 * PI) * risen * (vec3f(1.0) - exp(-w.beam * distance)) / w.beam;
}

// What is seen of a radiance through a distance of the water.
fn seen_through(w: Underwater, radiance: vec3f, altitude: Metres, direction: vec3f, distance: Metres, rays: f32) -> vec3f {
    return radiance * exp(-w.beam * distance) + veil(w, altitude, direction, distance, rays);
}

const BED_ALBEDO = vec3f(0.55, 0.52, 0.44);    // of coral sand under water; in the mean, ours

const RAY_STEPS = 12u;
const RAYS_SHOWN = 0.5;            // of their contrast; ours

// The sun's light along a sight over its mean: what the caustics are where each piece of it has its light from, the less the higher over
// the bed they are, weighted by what each piece adds to the veil.
fn sun_rays(w: Underwater, map: texture_2d<f32>, pixel: vec2f, direction: vec3f, distance: Metres) -> f32 {
    if !FINE { return 1.0; }
    let reach = min(distance, 24.0);
    let rate = w.beam.g - w.fading.g * direction.z;
    let slant = w.to_sun.xy / max(w.to_sun.z, 0.3);
    let begins = spread_evenly(pixel);
    var sum = 0.0;
    var whole = 0.0;
    var i = 0u;
    loop {
        let x = (f32(i) + begins) / f32(RAY_STEPS);
        let t = reach * x * x;
        let weight = (x + 0.02) * exp(-rate * t);
        let p = direction * t;
        let below = max(-frame.eye_altitude - p.z, 0.0);
        let sharp = saturate(below / caustic_depth(frame.eye_depth)) * exp(-w.haze * below / w.to_sun.z);
        sum += weight * sharp * (caustic_near(map, p.xy + slant * (below - caustic_depth(frame.eye_depth))) - 1.0);
        whole += weight;
        i++;
        if i == RAY_STEPS { break; }
    }
    return max(1.0 + RAYS_SHOWN * sum / max(whole, 1e-6) * (1.0 - exp(-rate * reach)) / max(1.0 - exp(-rate * distance), 1e-4), 0.0);
}

// How a camera in the water shows it: for the eye's depth it makes up for a part of the light, and of the red, that has been lost on the way down.
fn shown_in_water(w: Underwater, radiance: vec3f) -> vec4f {
    let depth = max(-frame.eye_altitude, 0.0);
    let gain = min(exp(0.45 * w.fading * depth), vec3f(4.0, 8.0, 8.0)) * (1.0 + 0.3 * saturate(depth));
    return vec4f(radiance * gain * frame.exposure, 1.0);
}

// The sun's light over its mean at a place on the bed.
fn bed_caustic(w: Underwater, map: texture_2d<f32>, way: vec2f, depth: Metres) -> f32 {
    return caustic_at(map, way + w.to_sun.xy / max(w.to_sun.z, 0.3) * (depth - caustic_depth(depth)));
}
