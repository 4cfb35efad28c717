// The sea surface at a point: FFT patches near, the Perlin patch far, laid out by the cells of the wave domain.
//
// Its nested loops run at least once (`serving` always finds a cell) and end at their foot, by a `break`: where many lanes share an instruction, as on any processor that stands in
// for a graphics card, a loop that is tested at its head runs its body once more with nobody in it, and nested ones do so each time.
//
// Who imports this declares `WAVES` and `NOISE`: whether the wave patches and the Perlin patch show at all.
#import wave_patches
#import shelter

// Weights of the FFT and the Perlin field; their squares sum to one, so that the variance stays.
fn mix_weights(distance: Metres) -> vec2f {
    let r = clamp((distance - frame.mix_near) / (frame.mix_far - frame.mix_near), 0.0, 1.0);
    let perlin_energy = r * r * (3.0 - 2.0 * r);
    return vec2f(sqrt(1.0 - perlin_energy), sqrt(perlin_energy));
}

// Displacement (east, north, up) of the rest point `p`. A patch's axes lie in the plane of its cell's centre; here the water moves level. Land may stand in the sea's way.
fn displacement_in(sea: LocalSea, p: vec3f, distance: Metres, footprint: Metres) -> vec3f {
    if !(WAVES || NOISE) || !any_resolvable(footprint) { return vec3f(0.0); }
    let weights = mix_weights(distance);
    let cells = serving(p, frame.wave_cell_count);
    let texels = f32(textureDimensions(displacements).x);
    var sum = vec3f(0.0);
    let shown = shown_cascades(footprint);
    var left = cells.cells;
    loop {
        let here = in_cell(firstTrailingBit(left), p, cells);
        var c = 0u;
        if WAVES && shown.all > 0u && weights.x > 0.0 { loop {
            let around = cascade_around(here, c, footprint, texels);
            let triangle = served(around.triangle, c < shown.clear);
            var k = 0u;
            loop {
                let w = here.share * triangle.weights[k] * weights.x * around.fade * sea.gains[c];
                let laid = cascade_placement(here.plane, c, triangle, k, texels);
                let own = w * textureSampleLevel(displacements, repeated, laid.at, c, around.lod).xyz;
                sum += vec3f(frame.chop * (own.x * laid.axis_x + own.y * laid.axis_y), own.z);
                k++;
                if k == 3u || triangle.weights[k] <= 0.0 { break; }
            }
            c++;
            if c == shown.all { break; }
        } }
        let fade = weights.y * sea.height * resolvable(footprint, frame.perlin_patch);
        if NOISE && fade > 0.0 {
            let around = perlin_around(here, footprint);
            var k = 0u;
            loop {
                let w = here.share * around.triangle.weights[k] * fade;
                let laid = perlin_placement(here.plane, around.triangle, k);
                sum.z += w * textureSampleLevel(perlin, repeated, laid.at, around.lod).x;
                k++;
                if k == 3u || around.triangle.weights[k] <= 0.0 { break; }
            }
        }
        left &= left - 1u;
        if left == 0u { break; }
    }
    // Energies, and so the mean level, go with the squares of the weights.
    sum.z -= weights.x * weights.x * dot(sea.gains * sea.gains, frame.cascade_levels) * frame.chop_level;
    return sum;
}

// Slopes of the surface in the local frame (x east, y north).
struct Slopes {
    slope: vec2f,          // true slope of the displaced surface
    rough: vec2f,          // slope variance that the footprint hides, along the wind and across it
    fold: f32,             // Jacobian determinant of the chop: below 0 the crest folds
    folds: vec2f,          // how much the chop draws the water together, a normal level, and its variance, 1 where a footprint hides nothing
}

const RIPPLES = 2u;       // the first of the patches whose waves are short: 6 m and less

// What a footprint hides is the mean of the squared slopes less the square of their mean, from the same mip levels, so that
// nothing is lost in between: what the texture filter takes from the slopes becomes roughness too.
//
// `ripples`: how much steeper than usual the short waves are that stand out in a pixel, those of the patches from RIPPLES on.
fn slopes_in(sea: LocalSea, p: vec3f, distance: Metres, footprint: Metres, ripples: f32) -> Slopes {
    let weights = mix_weights(distance);
    let all = local_slopes(sea);
    if !(WAVES || NOISE) || !any_resolvable(footprint) { return Slopes(vec2f(0.0), all, 1.0, vec2f(0.0)); }
    let cells = serving(p, frame.wave_cell_count);
    let texels = f32(textureDimensions(slopes).x);
    var slope = vec2f(0.0);
    var gradient = vec3f(0.0);    // of the chop, in east-north axes
    // Squares of all weights sum to one: what no patch shows counts once.
    let near = weights.x * weights.x;
    let far = weights.y * weights.y;
    // What the Perlin patch lacks of the slopes where it is lower, too.
    let own = frame.perlin_slopes.zw;
    let lost = all - local_slopes(OPEN_SEA) + own * (1.0 - sea.height * sea.height);
    var rough = near * frame.below_slopes + far * max(frame.perlin_slopes.xy + lost, vec2f(0.0));
    let shown = shown_cascades(footprint);
    for (var c = shown.all; c < CASCADES; c++) { rough += near * gained_slopes(sea, c); }
    var left = cells.cells;
    loop {
        let here = in_cell(firstTrailingBit(left), p, cells);
        var c = 0u;
        if WAVES && shown.all > 0u && weights.x > 0.0 { loop {
            let around = cascade_around(here, c, footprint, texels);
            let triangle = served(around.triangle, c < shown.clear);
            let steeper = select(1.0, ripples, c >= RIPPLES);
            var k = 0u;
            loop {
                let w = here.share * triangle.weights[k] * weights.x * sea.gains[c];
                let laid = cascade_placement(here.plane, c, triangle, k, texels);
                let means = textureSampleLevel(slopes, repeated, laid.at, c, around.lod);
                let seen = around.fade * means.xy;
                slope += w * steeper * (seen.x * laid.axis_x + seen.y * laid.axis_y);
                rough += w * w * max(means.zw - seen * seen, vec2f(0.0));
                if (c < shown.clear) & (frame.chop > 0.0) {
                    let stretch = textureSampleLevel(stretches, repeated, laid.at, c, around.lod).xyz;
                    gradient += turned(w * frame.chop * stretch, laid.axis_x, laid.axis_y);
                }
                k++;
                if k == 3u || triangle.weights[k] <= 0.0 { break; }
            }
            c++;
            if c == shown.all { break; }
        } }
        if NOISE && weights.y > 0.0 {
            let around = perlin_around(here, footprint);
            var k = 0u;
            loop {
                let w = here.share * around.triangle.weights[k] * weights.y * sea.height;
                let laid = perlin_placement(here.plane, around.triangle, k);
                let noise = textureSampleLevel(perlin, repeated, laid.at, around.lod);
                let seen = around.fade * noise.yz;
                slope += w * (seen.x * laid.axis_x + seen.y * laid.axis_y);
                // The patch holds the sum of both axes' squares; its own slopes say how they share it.
                let total = mix(own.x + own.y, noise.w, around.fade);
                rough += w * w * max(total - dot(seen, seen), 0.0) * own / max(own.x + own.y, 1e-9);
                k++;
                if k == 3u || around.triangle.weights[k] <= 0.0 { break; }
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
    // The chop's divergence has the variance of the slopes.
    let total = all.x + all.y;
    let folds = vec2f(-(gradient.x + gradient.y) / max(frame.chop * sqrt(total), 1e-3), saturate(1.0 - (rough.x + rough.y) / max(total, 1e-6)));
    return Slopes(true_slope, rough, fold, folds);
}
