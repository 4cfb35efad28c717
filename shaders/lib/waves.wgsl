// The sea surface at a point: FFT tiles near, the Perlin tile far, laid out by the cells of the wave domain.
//
// Its loops run at least once and end at their foot, by a `break`: where many lanes share an instruction, as on any processor that stands in
// for a graphics card, a loop that is tested at its head runs its body once more with nobody in it, and nested ones do so each time.
//
// Who imports this declares `WAVES` and `NOISE`: whether the wave tiles and the Perlin tile show at all.
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
fn cascade_placement(plane: Plane, cascade: u32, triangle: Triangle, k: u32, texels: f32) -> Placement {
    var found = placement(plane, cascade, frame.spacings[cascade], frame.patches[cascade], triangle, k);
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

// Tiles of which something is left, the longest of all first: how many, and how many whose longest waves, a sixth of the tile, are two
// footprints or longer. Of the others neighbouring footprints share nothing: there one vertex of the lattice serves as well as three,
// with no seam to be seen, and their chop steepens no crest that shows.
struct Shown { all: u32, clear: u32 }

fn shown_cascades(footprint: Metres) -> Shown {
    var shown = Shown(0u, 0u);
    for (var c = 0u; c < frame.cascade_count; c++) {
        let tiles = footprint / frame.patches[c];
        shown.all += u32(tiles < 0.4);
        shown.clear += u32(tiles < 1.0 / 12.0);
    }
    return shown;
}

fn any_resolvable(footprint: Metres) -> bool {
    return resolvable(footprint, max(frame.patches.x, frame.perlin_patch)) > 0.0;
}

// The triangle, or its greatest vertex alone.
fn served(triangle: Triangle, whole: bool) -> Triangle {
    if whole { return triangle; }
    var one = triangle;
    one.weights = vec3f(1.0, 0.0, 0.0);
    return one;
}

// Displacement (east, north, up) of the rest point `p`. A tile's axes lie in the plane of its cell's centre; here the water moves level.
fn displacement_at(p: vec3f, distance: Metres, footprint: Metres) -> vec3f {
    if !(WAVES || NOISE) || !any_resolvable(footprint) { return vec3f(0.0); }
    let weights = mix_weights(distance);
    let cells = serving(p, frame.wave_cell_count);
    let texels = f32(textureDimensions(displacements).x);
    var sum = vec3f(0.0);
    let shown = shown_cascades(footprint);
    var left = cells.cells;
    loop {
        let cell = firstTrailingBit(left);
        let share = cell_weight(cell, p, cells);
        let plane = plane_of(cell);
        let q = in_plane(plane, p);
        var c = 0u;
        if WAVES && shown.all > 0u && weights.x > 0.0 { loop {
            let length = frame.patches[c];
            let fade = resolvable(footprint, length);
            let lod = mip_for(footprint, length, texels);
            let triangle = served(triangle_around(plane, c, frame.spacings[c], q), c < shown.clear);
            var k = 0u;
            loop {
                let w = share * triangle.weights[k] * weights.x * fade;
                let here = cascade_placement(plane, c, triangle, k, texels);
                let own = w * textureSampleLevel(displacements, repeated, here.at, c, lod).xyz;
                sum += vec3f(frame.chop * (own.x * here.axis_x + own.y * here.axis_y), own.z);
                k++;
                if k == 3u || triangle.weights[k] <= 0.0 { break; }
            }
            c++;
            if c == shown.all { break; }
        } }
        let fade = weights.y * resolvable(footprint, frame.perlin_patch);
        if NOISE && fade > 0.0 {
            let lod = mip_for(footprint, frame.perlin_patch, f32(textureDimensions(perlin).x));
            let triangle = triangle_around(plane, PERLIN_TILE, frame.perlin_spacing, q);
            var k = 0u;
            loop {
                let w = share * triangle.weights[k] * fade;
                let here = placement(plane, PERLIN_TILE, frame.perlin_spacing, frame.perlin_patch, triangle, k);
                sum.z += w * textureSampleLevel(perlin, repeated, here.at, lod).x;
                k++;
                if k == 3u || triangle.weights[k] <= 0.0 { break; }
            }
        }
        left &= left - 1u;
        if left == 0u { break; }
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
    if !(WAVES || NOISE) || !any_resolvable(footprint) { return Slopes(vec2f(0.0), all, 1.0); }
    let cells = serving(p, frame.wave_cell_count);
    let texels = f32(textureDimensions(slopes).x);
    var slope = vec2f(0.0);
    var gradient = vec3f(0.0);    // of the chop, in east-north axes
    // Squares of all weights sum to one: what no tile shows counts once.
    let near = weights.x * weights.x;
    let far = weights.y * weights.y;
    var rough = near * frame.below_slopes + far * frame.perlin_slopes.xy;
    let shown = shown_cascades(footprint);
    for (var c = shown.all; c < frame.cascade_count; c++) { rough += near * cascade_slopes(c); }
    var left = cells.cells;
    loop {
        let cell = firstTrailingBit(left);
        let share = cell_weight(cell, p, cells);
        let plane = plane_of(cell);
        let q = in_plane(plane, p);
        var c = 0u;
        if WAVES && shown.all > 0u && weights.x > 0.0 { loop {
            let length = frame.patches[c];
            let fade = resolvable(footprint, length);
            let lod = mip_for(footprint, length, texels);
            let triangle = served(triangle_around(plane, c, frame.spacings[c], q), c < shown.clear);
            var k = 0u;
            loop {
                let w = share * triangle.weights[k] * weights.x;
                let here = cascade_placement(plane, c, triangle, k, texels);
                let means = textureSampleLevel(slopes, repeated, here.at, c, lod);
                let seen = fade * means.xy;
                slope += w * (seen.x * here.axis_x + seen.y * here.axis_y);
                rough += w * w * max(means.zw - seen * seen, vec2f(0.0));
                if c < shown.clear && frame.chop > 0.0 {
                    let stretch = textureSampleLevel(stretches, repeated, here.at, c, lod).xyz;
                    gradient += turned(w * frame.chop * stretch, here.axis_x, here.axis_y);
                }
                k++;
                if k == 3u || triangle.weights[k] <= 0.0 { break; }
            }
            c++;
            if c == shown.all { break; }
        } }
        if NOISE && weights.y > 0.0 {
            let lod = mip_for(footprint, frame.perlin_patch, f32(textureDimensions(perlin).x));
            let fade = resolvable(footprint, frame.perlin_patch);
            let own = frame.perlin_slopes.zw;
            let triangle = triangle_around(plane, PERLIN_TILE, frame.perlin_spacing, q);
            var k = 0u;
            loop {
                let w = share * triangle.weights[k] * weights.y;
                let here = placement(plane, PERLIN_TILE, frame.perlin_spacing, frame.perlin_patch, triangle, k);
                let noise = textureSampleLevel(perlin, repeated, here.at, lod);
                let seen = fade * noise.yz;
                slope += w * (seen.x * here.axis_x + seen.y * here.axis_y);
                // The tile holds the sum of both axes' squares; its own slopes say how they share it.
                let total = mix(own.x + own.y, noise.w, fade);
                rough += w * w * max(total - dot(seen, seen), 0.0) * own / max(own.x + own.y, 1e-9);
                k++;
                if k == 3u || triangle.weights[k] <= 0.0 { break; }
            }
        }
        left &= left - 1u;
        if left == 0u { break; }
    }
    // slope = (I + grad D)^-T grad eta, so that the chop steepens the crests.
    let jxx = 1.0 + gradient.x;
    let jyy = 1.0 + gradient.y;
    let fold = jxx * jyy - gradient.z * gradient.z;
    let true_slope = vec2f(jyy * slope.x - gradient.z * slope.y, jxx * slope.y - gradient.z * slope.x) / max(fold, LEAST_JACOBIAN);
    return Slopes(true_slope, rough, fold);
}
