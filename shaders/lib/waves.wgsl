// The sea surface at a point: FFT tiles near, the Perlin tile far, laid out by the cells of the wave domain.
#import domain

// displacements: (Dx, Dy, height, 0); slopes: (hx, hy, hx hx, hy hy), hx = dh/dx; stretches: (dDx/dx, dDy/dy, dDx/dy, 0);
// one layer per cascade.
@group(1) @binding(0) var displacements: texture_2d_array<f32>;
@group(1) @binding(1) var slopes: texture_2d_array<f32>;
@group(1) @binding(2) var stretches: texture_2d_array<f32>;
@group(1) @binding(3) var perlin: texture_2d<f32>;      // (height, dh/dx, dh/dy, hx hx + hy hy)

// Weights of the FFT and the Perlin field; their squares sum to one, so that the variance stays.
fn mix_weights(distance: Metres) -> vec2f {
    let r = clamp((distance - frame.mix_near) / (frame.mix_far - frame.mix_near), 0.0, 1.0);
    let perlin_energy = r * r * (3.0 - 2.0 * r);
    return vec2f(sqrt(1.0 - perlin_energy), sqrt(perlin_energy));
}

// A cascade's tile as a vertex lays it: sample n of it stands at n / N of its length, a texel's centre at (n + 1/2) / N.
fn cascade_placement(node: u32, cascade: u32, triangle: Triangle, k: u32, texels: f32) -> Placement {
    var found = placement(node, cascade, frame.spacings[cascade], frame.patches[cascade], triangle, k);
    found.at += 0.5 / texels;
    return found;
}

// Mip level at which a texel is as wide as `footprint`.
fn mip_for(footprint: Metres, patch_length: Metres, texels: f32) -> f32 {
    return log2(max(footprint * texels / patch_length, 1.0));
}

// Beyond a tile's coarsest useful mip nothing is left of it but its mean, zero.
fn resolvable(footprint: Metres, patch_length: Metres) -> f32 {
    return 1.0 - smoothstep(0.1, 0.4, footprint / patch_length);
}

fn any_resolvable(footprint: Metres) -> bool {
    return resolvable(footprint, max(frame.patches.x, frame.perlin_patch)) > 0.0;
}

// Displacement (east, north, up) of the rest point `p`. A tile's axes lie in the plane of its cell's centre; here the water moves level.
fn displacement_at(p: vec3f, distance: Metres, footprint: Metres) -> vec3f {
    if !any_resolvable(footprint) { return vec3f(0.0); }
    let weights = mix_weights(distance);
    let cells = serving(p, frame.node_count);
    let texels = f32(textureDimensions(displacements).x);
    var sum = vec3f(0.0);
    for (var node = 0u; node < frame.node_count; node++) {
        let share = cell_weight(node, p, cells);
        if share <= 0.0 { continue; }
        let q = in_plane(node, p);
        for (var c = 0u; c < frame.cascade_count && weights.x > 0.0; c++) {
            let length = frame.patches[c];
            let fade = resolvable(footprint, length);
            if fade <= 0.0 { continue; }
            let lod = mip_for(footprint, length, texels);
            let triangle = triangle_around(node, c, frame.spacings[c], q);
            for (var k = 0u; k < 3u && triangle.weights[k] > 0.0; k++) {
                let w = share * triangle.weights[k] * weights.x * fade;
                let here = cascade_placement(node, c, triangle, k, texels);
                let own = w * textureSampleLevel(displacements, repeated, here.at, c, lod).xyz;
                sum += vec3f(frame.chop * (own.x * here.axis_x + own.y * here.axis_y), own.z);
            }
        }
        let fade = weights.y * resolvable(footprint, frame.perlin_patch);
        if fade > 0.0 {
            let lod = mip_for(footprint, frame.perlin_patch, f32(textureDimensions(perlin).x));
            let triangle = triangle_around(node, PERLIN_TILE, frame.perlin_spacing, q);
            for (var k = 0u; k < 3u && triangle.weights[k] > 0.0; k++) {
                let w = share * triangle.weights[k] * fade;
                let here = placement(node, PERLIN_TILE, frame.perlin_spacing, frame.perlin_patch, triangle, k);
                sum.z += w * textureSampleLevel(perlin, repeated, here.at, lod).x;
            }
        }
    }
    // Energies, and so the mean level, go with the squares of the weights.
    sum.z -= weights.x * weights.x * frame.chop_level;
    return sum;
}

// A symmetric tensor (xx, yy, xy) of a tile, turned to east and north; ax and ay are the tile's axes.
fn turned(t: vec3f, ax: vec2f, ay: vec2f) -> vec3f {
    return vec3f(
        t.x * ax.x * ax.x + t.y * ay.x * ay.x + 2.0 * t.z * ax.x * ay.x,
        t.x * ax.y * ax.y + t.y * ay.y * ay.y + 2.0 * t.z * ax.y * ay.y,
        t.x * ax.x * ax.y + t.y * ay.x * ay.y + t.z * (ax.x * ay.y + ax.y * ay.x));
}

// Slopes of the surface in the local frame (x east, y north).
struct Slopes {
    slope: vec2f,          // true slope of the displaced surface
    rough: vec2f,          // slope variance that the footprint hides, along the wind and across it
    fold: f32,             // Jacobian determinant of the chop: below 0 the crest folds
}

fn cascade_slopes(c: u32) -> vec2f {
    let pair = frame.cascade_slopes[c >> 1u];
    return select(pair.xy, pair.zw, (c & 1u) == 1u);
}

// What a footprint hides is the mean of the squared slopes less the square of their mean, from the same mip levels, so that
// nothing is lost in between: what the texture filter takes from the slopes becomes roughness too.
fn slopes_at(p: vec3f, distance: Metres, footprint: Metres) -> Slopes {
    let weights = mix_weights(distance);
    let all = frame.below_slopes + cascade_slopes(0u) + cascade_slopes(1u) + cascade_slopes(2u) + cascade_slopes(3u);
    if !any_resolvable(footprint) { return Slopes(vec2f(0.0), all, 1.0); }
    let cells = serving(p, frame.node_count);
    let texels = f32(textureDimensions(slopes).x);
    var slope = vec2f(0.0);
    var gradient = vec3f(0.0);    // of the chop, in east-north axes
    // Squares of all weights sum to one: what no tile shows counts once.
    let near = weights.x * weights.x;
    let far = weights.y * weights.y;
    var rough = near * frame.below_slopes + far * frame.perlin_slopes.xy;
    for (var node = 0u; node < frame.node_count; node++) {
        let share = cell_weight(node, p, cells);
        if share <= 0.0 { continue; }
        let q = in_plane(node, p);
        for (var c = 0u; c < frame.cascade_count && weights.x > 0.0; c++) {
            let length = frame.patches[c];
            let fade = resolvable(footprint, length);
            if fade <= 0.0 {
                rough += near * share * share * cascade_slopes(c);
                continue;
            }
            let lod = mip_for(footprint, length, texels);
            let triangle = triangle_around(node, c, frame.spacings[c], q);
            for (var k = 0u; k < 3u && triangle.weights[k] > 0.0; k++) {
                let w = share * triangle.weights[k] * weights.x;
                let here = cascade_placement(node, c, triangle, k, texels);
                let means = textureSampleLevel(slopes, repeated, here.at, c, lod);
                let shown = fade * means.xy;
                slope += w * (shown.x * here.axis_x + shown.y * here.axis_y);
                rough += w * w * max(means.zw - shown * shown, vec2f(0.0));
                let stretch = textureSampleLevel(stretches, repeated, here.at, c, lod).xyz;
                gradient += turned(w * fade * frame.chop * stretch, here.axis_x, here.axis_y);
            }
        }
        if weights.y > 0.0 {
            let lod = mip_for(footprint, frame.perlin_patch, f32(textureDimensions(perlin).x));
            let fade = resolvable(footprint, frame.perlin_patch);
            let own = frame.perlin_slopes.zw;
            let triangle = triangle_around(node, PERLIN_TILE, frame.perlin_spacing, q);
            for (var k = 0u; k < 3u && triangle.weights[k] > 0.0; k++) {
                let w = share * triangle.weights[k] * weights.y;
                let here = placement(node, PERLIN_TILE, frame.perlin_spacing, frame.perlin_patch, triangle, k);
                let noise = textureSampleLevel(perlin, repeated, here.at, lod);
                let shown = fade * noise.yz;
                slope += w * (shown.x * here.axis_x + shown.y * here.axis_y);
                // The tile holds the sum of both axes' squares; its own slopes say how they share it.
                let total = mix(own.x + own.y, noise.w, fade);
                rough += w * w * max(total - dot(shown, shown), 0.0) * own / max(own.x + own.y, 1e-9);
            }
        }
    }
    // slope = (I + grad D)^-T grad eta, so that the chop steepens the crests.
    let jxx = 1.0 + gradient.x;
    let jyy = 1.0 + gradient.y;
    let fold = jxx * jyy - gradient.z * gradient.z;
    let true_slope = vec2f(jyy * slope.x - gradient.z * slope.y, jxx * slope.y - gradient.z * slope.x) / max(fold, LEAST_JACOBIAN);
    return Slopes(true_slope, rough, fold);
}
