// The sea surface at a point: FFT tiles near, the Perlin tile far, laid out by the cells of the wave domain.
#import ellipsoid

// displacements: (Dx, Dy, height, 0); slopes: (hx, hy, hx hx, hy hy), hx = dh/dx; stretches: (dDx/dx, dDy/dy, dDx/dy, 0);
// one layer per cascade.
@group(1) @binding(0) var displacements: texture_2d_array<f32>;
@group(1) @binding(1) var slopes: texture_2d_array<f32>;
@group(1) @binding(2) var stretches: texture_2d_array<f32>;
@group(1) @binding(3) var perlin: texture_2d<f32>;      // (height, dh/dx, dh/dy, hx hx + hy hy)

const BLEND_WIDTH: Metres = 9000.0;

// Weights of the FFT and the Perlin field; their squares sum to one, so that the variance stays.
fn mix_weights(distance: Metres) -> vec2f {
    let r = clamp((distance - frame.mix_near) / (frame.mix_far - frame.mix_near), 0.0, 1.0);
    let perlin_energy = r * r * (3.0 - 2.0 * r);
    return vec2f(sqrt(1.0 - perlin_energy), sqrt(perlin_energy));
}

struct NodeWeights { nearest: f32, norm: f32 }

fn node_distance(index: u32, p: vec3f) -> f32 {
    return length(p - nodes[index].origin);
}

// A cell serves up to BLEND_WIDTH beyond the nearest one; squares of the normalised weights sum to one.
fn node_weight(distance: f32, nearest: f32) -> f32 {
    return smoothstep(0.0, 1.0, 1.0 - (distance - nearest) / BLEND_WIDTH);
}

fn node_weights(p: vec3f) -> NodeWeights { return weights_of_first(p, frame.node_count); }

// Of the first `count` cells, which are the nearest to the eye.
fn weights_of_first(p: vec3f, count: u32) -> NodeWeights {
    var nearest = 1e30;
    for (var i = 0u; i < count; i++) { nearest = min(nearest, node_distance(i, p)); }
    var sum = 0.0;
    for (var i = 0u; i < count; i++) {
        let w = node_weight(node_distance(i, p), nearest);
        sum += w * w;
    }
    return NodeWeights(nearest, inverseSqrt(max(sum, 1e-6)));
}

fn tile_start(index: u32, cascade: u32) -> vec2f {
    let pair = nodes[index].starts[cascade >> 1u];
    return select(pair.xy, pair.zw, (cascade & 1u) == 1u);
}

// Sample n of a tile stands at n / N of its length, a texel's centre at (n + 1/2) / N.
fn tile_uv(local: vec2f, index: u32, cascade: u32, texels: f32) -> vec2f {
    return (local + tile_start(index, cascade)) / frame.patches[cascade] + 0.5 / texels;
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

// Displacement (east, north, up) of the rest point `p`.
fn displacement_at(p: vec3f, distance: Metres, footprint: Metres) -> vec3f {
    if !any_resolvable(footprint) { return vec3f(0.0); }
    let weights = mix_weights(distance);
    let found = node_weights(p);
    let texels = f32(textureDimensions(displacements).x);
    var sum = vec3f(0.0);
    for (var i = 0u; i < frame.node_count; i++) {
        let w = node_weight(node_distance(i, p), found.nearest) * found.norm;
        if w <= 0.0 { continue; }
        let local = vec2f(dot(p, nodes[i].axis_x), dot(p, nodes[i].axis_y));
        var own = vec3f(0.0);
        if weights.x > 0.0 {
            for (var c = 0u; c < frame.cascade_count; c++) {
                let length = frame.patches[c];
                let fade = resolvable(footprint, length);
                if fade <= 0.0 { continue; }
                let uv = tile_uv(local, i, c, texels);
                own += fade * textureSampleLevel(displacements, repeated, uv, c, mip_for(footprint, length, texels)).xyz;
            }
            own *= weights.x * vec3f(frame.chop, frame.chop, 1.0);
        }
        if weights.y > 0.0 {
            let uv = (local + nodes[i].perlin_start.xy) / frame.perlin_patch;
            let lod = mip_for(footprint, frame.perlin_patch, f32(textureDimensions(perlin).x));
            own.z += weights.y * resolvable(footprint, frame.perlin_patch) * textureSampleLevel(perlin, repeated, uv, lod).x;
        }
        // The cell's axes lie in the plane of its centre; here the water moves level.
        sum += w * vec3f(own.x * nodes[i].axis_x.xy + own.y * nodes[i].axis_y.xy, own.z);
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
    let found = node_weights(p);
    let texels = f32(textureDimensions(slopes).x);
    var slope = vec2f(0.0);
    var gradient = vec3f(0.0);    // of the chop, in east-north axes
    var rough = vec2f(0.0);
    for (var i = 0u; i < frame.node_count; i++) {
        let w = node_weight(node_distance(i, p), found.nearest) * found.norm;
        if w <= 0.0 { continue; }
        let ax = nodes[i].axis_x.xy;
        let ay = nodes[i].axis_y.xy;
        let local = vec2f(dot(p, nodes[i].axis_x), dot(p, nodes[i].axis_y));
        var own = vec2f(0.0);
        if weights.x > 0.0 {
            var tilt = vec2f(0.0);
            var stretch = vec3f(0.0);
            var hidden = frame.below_slopes;
            for (var c = 0u; c < frame.cascade_count; c++) {
                let length = frame.patches[c];
                let fade = resolvable(footprint, length);
                if fade <= 0.0 {
                    hidden += cascade_slopes(c);
                    continue;
                }
                let uv = tile_uv(local, i, c, texels);
                let lod = mip_for(footprint, length, texels);
                let means = textureSampleLevel(slopes, repeated, uv, c, lod);
                let here = fade * means.xy;
                tilt += here;
                stretch += fade * textureSampleLevel(stretches, repeated, uv, c, lod).xyz;
                hidden += max(means.zw - here * here, vec2f(0.0));
            }
            own += weights.x * tilt;
            gradient += turned(w * weights.x * frame.chop * stretch, ax, ay);
            rough += w * w * weights.x * weights.x * hidden;
        }
        if weights.y > 0.0 {
            let uv = (local + nodes[i].perlin_start.xy) / frame.perlin_patch;
            let lod = mip_for(footprint, frame.perlin_patch, f32(textureDimensions(perlin).x));
            let fade = resolvable(footprint, frame.perlin_patch);
            let noise = textureSampleLevel(perlin, repeated, uv, lod);
            let here = fade * noise.yz;
            own += weights.y * here;
            // The tile holds the sum of both axes' squares; its own slopes say how they share it.
            let own_slopes = frame.perlin_slopes.zw;
            let total = mix(own_slopes.x + own_slopes.y, noise.w, fade);
            let hidden = max(total - dot(here, here), 0.0) * own_slopes / max(own_slopes.x + own_slopes.y, 1e-9);
            rough += w * w * weights.y * weights.y * (frame.perlin_slopes.xy + hidden);
        }
        slope += w * (own.x * ax + own.y * ay);
    }
    // slope = (I + grad D)^-T grad eta, so that the chop steepens the crests.
    let jxx = 1.0 + gradient.x;
    let jyy = 1.0 + gradient.y;
    let fold = jxx * jyy - gradient.z * gradient.z;
    let true_slope = vec2f(jyy * slope.x - gradient.z * slope.y, jxx * slope.y - gradient.z * slope.x) / max(fold, 0.25);
    return Slopes(true_slope, rough, fold);
}
