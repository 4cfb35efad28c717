// Mean of four places around one, each of which the sampler's filter makes of four texels.

// `reach`: how far the four are off, each way, in parts of the picture.
fn four_taps(picture: texture_2d<f32>, filtering: sampler, at: vec2f, reach: vec2f) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < 4u; i++) {
        let way = 2.0 * vec2f(f32(i & 1u), f32(i >> 1u)) - 1.0;
        sum += textureSampleLevel(picture, filtering, at + way * reach, 0.0).rgb;
    }
    return 0.25 * sum;
}
