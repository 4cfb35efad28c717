// What colour the ground has by itself: land by height, slope and latitude, the bed by its depth. Linear albedo of red, green and blue.
#import world
#import noise

// Patchiness, about 0…1: octaves from 300 km down to what pixels hold. As in lib/waves.wgsl, the loop ends at its foot.
fn patchiness(at: vec2u, footprint: Metres) -> f32 {
    var sum = 0.5;
    var amplitude = 0.36;
    var level = 7u;
    loop {
        let shown = 1.0 - smoothstep(0.25, 0.7, footprint * exp2(f32(level)) / EARTH_TURN);
        sum += amplitude * shown * (map_noise(at, level, level) - 0.5);
        amplitude *= 0.72;
        level += 2u;
        if level > 21u || footprint * exp2(f32(level)) >= 0.7 * EARTH_TURN { break; }
    }
    return sum;
}

fn natural_colour(elevation: Metres, slope: f32, sin_lat: f32, patchy: f32) -> vec3f {
    let latitude = degrees(asin(clamp(abs(sin_lat), 0.0, 1.0))) + (patchy - 0.5) * 9.0;
    let forest = vec3f(0.034, 0.060, 0.020);
    let grass = vec3f(0.105, 0.115, 0.045);
    let desert = mix(vec3f(0.30, 0.20, 0.105), vec3f(0.44, 0.31, 0.17), patchy);
    let tundra = vec3f(0.105, 0.095, 0.065);
    let rock = vec3f(0.13, 0.115, 0.10);
    let snow = vec3f(0.80, 0.83, 0.87);
    let dry = smoothstep(11.0, 19.0, latitude) * (1.0 - smoothstep(29.0, 37.0, latitude)) * smoothstep(0.2, 0.55, patchy + 0.15);
    var colour = mix(mix(forest, grass, patchy), desert, dry);
    colour = mix(colour, tundra, smoothstep(58.0, 68.0, latitude + elevation / 150.0));
    colour = mix(colour, rock, max(smoothstep(0.25, 0.7, slope), 0.8 * smoothstep(1500.0, 3500.0, elevation)));
    let snow_line = mix(5300.0, 0.0, smoothstep(20.0, 74.0, latitude));
    let snowy = smoothstep(snow_line - 250.0, snow_line + 350.0, elevation + (patchy - 0.5) * 500.0);
    return mix(colour, snow, snowy * (1.0 - 0.6 * smoothstep(0.6, 1.2, slope)));
}

fn bed_colour(depth: Metres) -> vec3f {
    return mix(vec3f(0.40, 0.35, 0.26), vec3f(0.13, 0.14, 0.12), smoothstep(2.0, 40.0, depth));
}
