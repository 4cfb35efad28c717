// What a lens, a sensor and an eye make of a picture's light: a point is no pixel, and a little of its light glows around where it came from.

@group(0) @binding(2) var glow: texture_2d<f32>;
@group(0) @binding(3) var clamped: sampler;

const GLOWING = 0.03;
// On either side of a pixel, right and left as well as up and down, so much of its light is found. The sun on the water is hundreds of times
// as bright as what is beside it, and edges sharper than any photograph's look cut out.
const SPREAD = 0.1;

// The light that is seen in a pixel.
fn through_lens(picture: texture_2d<f32>, pixel: vec2i) -> vec3f {
    let size = vec2i(textureDimensions(picture));
    let parts = array(SPREAD, 1.0 - 2.0 * SPREAD, SPREAD);
    var sharp = vec3f(0.0);
    for (var y = 0; y < 3; y++) {
        for (var x = 0; x < 3; x++) {
            let beside = clamp(pixel + vec2i(x, y) - 1, vec2i(0), size - 1);
            sharp += parts[x] * parts[y] * textureLoad(picture, beside, 0).rgb;
        }
    }
    return mix(sharp, textureSampleLevel(glow, clamped, (vec2f(pixel) + 0.5) / vec2f(size), 0.0).rgb, GLOWING);
}
