// From scene radiance to display: a filmic curve that keeps hue (K. Narkowicz 2015, ACES fit), then the sRGB transfer function.
#import full_screen

@group(0) @binding(0) var scene: texture_2d<f32>;

fn filmic(x: vec3f) -> vec3f {
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), vec3f(0.0), vec3f(1.0));
}

fn srgb_from_linear(c: vec3f) -> vec3f {
    return select(1.055 * pow(c, vec3f(1.0 / 2.4)) - 0.055, 12.92 * c, c <= vec3f(0.0031308));
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let radiance = min(textureLoad(scene, vec2u(position.xy), 0).rgb, vec3f(100.0));
    return vec4f(srgb_from_linear(filmic(radiance)), 1.0);
}
