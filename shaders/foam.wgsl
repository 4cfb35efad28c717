// Foam in time, on the squares of the foam map: born where the chop folds, then fading; see src/model/foam.rs.
#import foam

struct FoamStep {
    previous: array<vec4i, FOAM_LEVELS>,   // texel of the eye at the last step; zw unused
    grow: vec4f,               // exp(-dt / growth time), by level; 1 where the level stays as it is
    keep: vec4f,               // exp(-dt / lifetime)
    empty: u32,                // 1: there is no history
    cells: u32,                // wave cells that serve the map, the first of all
    unused_a: u32,
    unused_b: u32,
}

@group(2) @binding(0) var<uniform> now: FoamStep;
@group(2) @binding(1) var next: texture_storage_2d<FORMAT, write>;

// A cascade's longest waves are a sixth of it: under two footprints, of which the filter leaves next to nothing.
const SHORTEST_TILE_TEXELS: f32 = 10.0;

// The texel of the world that is kept in a slot while the eye is in texel `eye`.
fn world_texel(slot: vec2i, eye: vec2i) -> vec2i {
    return eye + ((slot - eye + FOAM_TEXELS / 2) & vec2i(FOAM_TEXELS - 1)) - FOAM_TEXELS / 2;
}

// Smaller eigenvalue of the chop's gradient, summed over the cascades, at a rest point; waves below the footprint left out.
fn smaller_eigenvalue(p: vec3f, footprint: Metres) -> f32 {
    let cells = serving(p, now.cells);
    let texels = f32(textureDimensions(stretches).x);
    var sum = vec3f(0.0);
    for (var left = cells.cells; left != 0u; left &= left - 1u) {
        let node = firstTrailingBit(left);
        let share = cell_weight(node, p, cells);
        let q = in_plane(node, p);
        // The longest tile comes first.
        for (var c = 0u; c < frame.cascade_count && frame.patches[c] >= SHORTEST_TILE_TEXELS * footprint; c++) {
            let length = frame.patches[c];
            let lod = mip_for(footprint, length, texels);
            let triangle = triangle_around(node, c, frame.spacings[c], q);
            for (var k = 0u; k < 3u && triangle.weights[k] > 0.0; k++) {
                let w = share * triangle.weights[k];
                let here = cascade_placement(node, c, triangle, k, texels);
                let own = textureSampleLevel(stretches, repeated, here.at, c, lod).xyz;
                sum += turned(w * own, here.axis_x, here.axis_y);
            }
        }
    }
    return 0.5 * (sum.x + sum.y) - length(vec2f(0.5 * (sum.x - sum.y), sum.z));
}

@compute @workgroup_size(8, 8)
fn advance(@builtin(global_invocation_id) id: vec3u) {
    let slot = vec2i(id.xy);
    let before = textureLoad(foam_map, slot, 0);
    let axis_x = nodes[0].axis_x;
    let axis_y = nodes[0].axis_y;
    var after = vec4f(0.0);
    for (var level = 0u; level < FOAM_LEVELS; level++) {
        let square = frame.foam_levels[level];
        if square.threshold < -1e8 {
            // Nothing that this square can hold folds: it has its share everywhere.
            after[level] = frame.whitecaps;
            continue;
        }
        let world = world_texel(slot, square.texel);
        let was = world - now.previous[level].xy;
        var foam = before[level];
        if any(was < vec2i(-FOAM_TEXELS / 2)) || any(was >= vec2i(FOAM_TEXELS / 2)) {
            // New in this square: the next coarser one, whose texels are three times as wide, knows the place.
            let coarser = vec2i(floor((vec2f(world) + 0.5) / 3.0)) & vec2i(FOAM_TEXELS - 1);
            foam = select(0.0, textureLoad(foam_map, coarser, 0)[min(level + 1u, FOAM_LEVELS - 1u)], level + 1u < FOAM_LEVELS);
        }
        if now.empty == 1u { foam = 0.0; }
        if now.keep[level] == 1.0 && now.grow[level] == 1.0 {
            after[level] = foam;
            continue;
        }
        let offset = (vec2f(world - square.texel) + 0.5 - square.fraction) * square.side;
        let p = offset.x * axis_x + offset.y * axis_y - frame.eye_altitude * cross(axis_x, axis_y);
        let breaking = clamp((square.threshold - smaller_eigenvalue(p, square.side)) / square.softness, 0.0, 1.0);
        after[level] = breaking + (foam - breaking) * select(now.keep[level], now.grow[level], breaking > foam);
    }
    textureStore(next, slot, after);
}
