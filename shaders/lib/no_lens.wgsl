// The light of a pixel as it is: see lens.wgsl.
fn through_lens(picture: texture_2d<f32>, pixel: vec2i) -> vec3f { return textureLoad(picture, pixel, 0).rgb; }
