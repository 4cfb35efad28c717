// Tables of the air that the eye sees, for every direction, made anew when the eye moves or the sun: the sky's radiance, and
// radiance and transmittance of the air before surfaces. Method: S. Hillaire 2020, "A scalable and production ready sky and
// atmosphere rendering technique", with coordinates that hold from a deck to space.
#import scattering

@group(1) @binding(0) var transmittances: texture_2d<f32>;
@group(1) @binding(1) var multiples: texture_2d<f32>;
@group(2) @binding(0) var sky_table: texture_storage_2d<rgba16float, write>;
@group(2) @binding(1) var haze_table: texture_storage_3d<rgba16float, write>;

const SKY_STEPS = 32u;

// The direction at an azimuth and a row, above the horizon up to the shell `lift`, or below it.
fn table_direction(azimuth: f32, row: f32, below: bool, lift: Metres) -> vec3f {
    let axes = air_axes();
    var direction = direction_of(Bearing(0.0, azimuth), axes);
    // The horizon depends on the direction by the ellipsoid's flattening: each turn brings it 300 times nearer.
    for (var i = 0; i < 3; i++) {
        let ray = eye_ray(direction);
        let mu = select(mu_above(row, ray, lift), mu_below(row, ray), below);
        direction = direction_of(Bearing(mu, azimuth), axes);
    }
    return direction;
}

fn sight_of(direction: vec3f) -> Sight {
    return sight_along(eye_ray(direction), direction, frame.quadric_gradient, quadric_times(direction), frame.light);
}

@compute @workgroup_size(8, 8)
fn skies(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(sky_table);
    if any(id.xy >= size) { return; }
    let x = vec2f(id.xy) / vec2f(size - 1u);
    let sight = sight_of(table_direction(x.x, x.y, false, TOP));
    let air = shell_hits(sight.ray, TOP);
    var radiance = vec3f(0.0);
    // From high up a ray's air lies in the middle of its way.
    if air.y > max(air.x, 0.0) { radiance = scatter(sight, max(air.x, 0.0), air.y, SKY_STEPS, 0.5 * frame.air_sink).radiance; }
    textureStore(sky_table, id.xy, vec4f(radiance, 1.0));
}

// One thread marches along a ray and leaves what it has met at every slice.
@compute @workgroup_size(8, 8)
fn hazes(@builtin(global_invocation_id) id: vec3u) {
    let size = textureDimensions(haze_table);
    let columns = size.x - 2u;
    if id.x >= columns || id.y >= size.y { return; }
    let first_above = haze_first_above(size.y);
    let below = id.y < first_above;
    let row = select(f32(id.y - first_above) / f32(size.y - first_above - 1u), f32(id.y) / f32(first_above - 1u), below);
    let sight = sight_of(table_direction(f32(id.x) / f32(columns - 1u), row, below, SUMMIT));
    let reach = haze_reach(sight.ray, below);
    var all = NOTHING_MET;
    var t = reach.x;
    for (var slice = 0u; slice < size.z; slice++) {
        let next = mix(reach.x, reach.y, warped(f32(slice) / f32(size.z - 1u), frame.air_sink));
        if slice > 0u && reach.x <= reach.y { all = stepped(sight, all, t, next); }
        t = next;
        textureStore(haze_table, vec3u(id.x, id.y, slice), vec4f(all.radiance, 1.0));
        // Transmittance is the same for all azimuths, but for the flattening: two equal columns beside, so that none is filtered.
        if id.x == columns / 2u {
            textureStore(haze_table, vec3u(columns, id.y, slice), vec4f(all.through, 1.0));
            textureStore(haze_table, vec3u(columns + 1u, id.y, slice), vec4f(all.through, 1.0));
        }
    }
}
