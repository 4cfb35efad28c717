// What a lens and an eye make of a picture's light: a little of it glows around where it came from.

@group(0) @binding(1) var glow: texture_2d<f32>;
@group(0) @binding(2) var clamped: sampler;

const GLOWING = 0.03;

// The light of a pixel whose middle is `at`, 0...1 right and down.
fn with_glow(radiance: vec3f, at: vec2f) -> vec3f {
    return mix(radiance, textureSampleLevel(glow, clamped, at, 0.0).rgb, GLOWING);
}
