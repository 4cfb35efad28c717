// The sky behind everything. `MEASURED` is of src/pass/kind.rs.
#import full_screen
#import sky
#import cloud_layer
#import cloud_light
#import output

const MIRRORS_CLOUDS = FINE;

// The air of a sight of the sky as far as it is below the layer of clouds.
fn air_below_clouds(direction: vec3f) -> Air {
    let stretch = layer_stretch(eye_ray(direction), 1e9);
    let returns = haze(direction, stretch.returns).radiance - haze(direction, stretch.leaves).radiance;
    let first = haze(direction, stretch.first);
    let is_below = frame.eye_altitude < CLOUD_BASE;
    return Air(select(select(vec3f(0.0), returns, stretch.returns > stretch.leaves), first.radiance, is_below), select(vec3f(1.0), first.transmittance, is_below));
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let direction = normalize(frame.ray_forward + corner.device.x * frame.ray_right + corner.device.y * frame.ray_up);
    if MEASURED { return sky_output(); }
    // Land or sea covers the sky; should a pixel of theirs miss, the clear colour stands there.
    let both = SHOWS_LAND | SHOWS_SEA;
    if (frame.layers & both) == both && is_inside_limb(eye_ray(direction)) {
        discard;
        return vec4f(0.0);
    }
    var radiance = sky_light(direction);
    if CLOUDS {
        // Where a gap shows the sky the air on this side of the clouds is in their shadow, as it is before them.
        let near = air_below_clouds(direction);
        let light = clouded_daylight_at_eye(daylight_at(frame.light.z));
        radiance += (shaded_air(near, light) - near.radiance) * exp(-spray_before_sky(direction.z));
    }
    return vec4f(radiance * frame.exposure, 1.0);
}
