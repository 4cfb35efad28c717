// Foam in time, on the levels of the foam map: born where the chop folds, then fading; see src/model/foam.rs.
#import foam
#import wave_patches

struct FoamStep {
    previous: array<vec4i, FOAM_LEVELS>,   // texel of the eye at the last step; z: 1 where the level was not kept up; w unused
    grow: vec4f,               // exp(-dt / growth time), by level
    keep: vec4f,               // exp(-dt / lifetime)
    keep_young: vec4f,         // exp(-dt / lifetime of young foam)
    empty: u32,                // 1: there is no history
    cells: u32,                // wave cells that serve the map, the first of all
    due: u32,                  // a bit for each level that time passes on, and whose waves ever fold; one at least where time passes
    unused: u32,
}

@group(2) @binding(0) var<uniform> now: FoamStep;
@group(2) @binding(1) var next: texture_storage_2d<FORMAT, write>;

// A cascade's longest waves are a sixth of it: under two footprints, of which the filter leaves next to nothing.
const SHORTEST_PATCH_TEXELS: f32 = 10.0;

// How far before the fold its foam comes to lie, of the width that breaks as one; ours.
const FALLS: f32 = 1.2;

// The texel of the world that is kept in a slot while the eye is in texel `eye`.
fn world_texel(slot: vec2i, eye: vec2i) -> vec2i {
    return eye + ((slot - eye + FOAM_TEXELS / 2) & vec2i(FOAM_TEXELS - 1)) - FOAM_TEXELS / 2;
}

// Smaller eigenvalue of the chop's gradient, summed over the cascades, at a rest point; waves below the footprint left out.
fn smaller_eigenvalue(p: vec3f, footprint: Metres) -> f32 {
    let cells = serving(p, now.cells);
    let texels = f32(textureDimensions(stretches).x);
    var sum = vec3f(0.0);
    var left = cells.cells;
    loop {
        let here = in_cell(firstTrailingBit(left), p, cells);
        // The longest patch comes first, and is always long enough.
        var c = 0u;
        loop {
            let around = cascade_around(here, c, footprint, texels);
            var k = 0u;
            loop {
                let w = here.share * around.triangle.weights[k];
                let laid = cascade_placement(here.plane, c, around.triangle, k, texels);
                let own = textureSampleLevel(stretches, repeated, laid.at, c, around.lod).xyz;
                sum += turned(w * own, laid.axis_x, laid.axis_y);
                k++;
                if k == 3u || around.triangle.weights[k] <= 0.0 { break; }
            }
            c++;
            if c == CASCADES || frame.patches[c] < SHORTEST_PATCH_TEXELS * footprint { break; }
        }
        left &= left - 1u;
        if left == 0u { break; }
    }
    return 0.5 * (sum.x + sum.y) - length(vec2f(0.5 * (sum.x - sum.y), sum.z));
}

// Whether the last step has left a texel of the world in a level.
fn is_known(world: vec2i, level: u32) -> bool {
    let was = world - now.previous[level].xy;
    return now.previous[level].z == 0 && all(was >= vec2i(-FOAM_TEXELS / 2)) && all(was < vec2i(FOAM_TEXELS / 2));
}

// What the map knows of the texel of the world in a slot of a level: all foam, and the young.
fn known(slot: vec2i, before: vec4f, young: vec4f, level: u32) -> vec2f {
    let here = frame.foam_levels[level];
    // Nothing that this level can hold folds: it has its share everywhere.
    if here.threshold < -1e8 { return vec2f(frame.whitecaps, usual_young(frame.whitecaps)); }
    if now.empty == 1u { return vec2f(0.0); }
    let world = world_texel(slot, here.texel);
    if is_known(world, level) { return vec2f(before[level], young[level]); }
    // New in this level: a coarser one knows the place.
    for (var coarser = level + 1u; coarser < FOAM_LEVELS; coarser++) {
        let at = (vec2f(world - here.texel) + 0.5 - here.fraction) * here.side / frame.foam_levels[coarser].side;
        let texels = frame.foam_levels[coarser].fraction + at;
        if is_known(frame.foam_levels[coarser].texel + vec2i(floor(texels)), coarser) {
            let origin = frame.foam_levels[coarser].texel;
            return vec2f(foam_between(origin, texels, coarser, ALL_FOAM).x, foam_between(origin, texels, coarser, YOUNG_FOAM).x);
        }
    }
    return vec2f(0.0);
}

struct Known { all: vec4f, young: vec4f }

fn all_known(slot: vec2i) -> Known {
    let all = textureLoad(foam_map, slot, 0);
    let young = textureLoad(foam_map, slot + YOUNG_FOAM, 0);
    let first = known(slot, all, young, 0u);
    let second = known(slot, all, young, 1u);
    let third = known(slot, all, young, 2u);
    let fourth = known(slot, all, young, 3u);
    return Known(vec4f(first.x, second.x, third.x, fourth.x), vec4f(first.y, second.y, third.y, fourth.y));
}

fn store(slot: vec2i, found: Known) {
    textureStore(next, slot, found.all);
    textureStore(next, slot + YOUNG_FOAM, found.young);
}

// The levels follow the eye; no time passes.
@compute @workgroup_size(8, 8)
fn follow(@builtin(global_invocation_id) id: vec3u) {
    let slot = vec2i(id.xy);
    store(slot, all_known(slot));
}

@compute @workgroup_size(8, 8)
fn advance(@builtin(global_invocation_id) id: vec3u) {
    let slot = vec2i(id.xy);
    let axis_x = wave_cells[0].axis_x;
    let axis_y = wave_cells[0].axis_y;
    var after = all_known(slot);
    var left = now.due;
    loop {
        let level = firstTrailingBit(left);
        let here = frame.foam_levels[level];
        let foam = after.all[level];
        let young = after.young[level];
        let world = world_texel(slot, here.texel);
        let offset = (vec2f(world - here.texel) + 0.5 - here.fraction) * here.side;
        // What breaks falls down the wave's lee: foam lies before the fold.
        let fallen = offset + FALLS * here.breaking * wave_cells[0].wind;
        let p = fallen.x * axis_x + fallen.y * axis_y - frame.eye_altitude * cross(axis_x, axis_y);
        let breaking = clamp((here.threshold - smaller_eigenvalue(p, here.breaking)) / here.softness, 0.0, 1.0);
        after.all[level] = breaking + (foam - breaking) * select(now.keep[level], now.grow[level], breaking > foam);
        after.young[level] = breaking + (young - breaking) * select(now.keep_young[level], now.grow[level], breaking > young);
        left &= left - 1u;
        if left == 0u { break; }
    }
    store(slot, after);
}
