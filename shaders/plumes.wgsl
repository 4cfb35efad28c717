// Where spindrift stands: a plume for each cell of two squares about the eye, fixed to the water at rest, as strong as the crest there breaks.
#import sea_mesh
#import cloud_light
#import foam
#import hash
#import plume
#import spray

@group(2) @binding(0) var<storage, read_write> plumes: array<Plume>;

const ROLLERS = false;             // spindrift comes off the water's own crests

// Cells of the squares: so many texels of these levels of the foam map along a side.
const CELL_LEVELS = vec2u(1u, 3u);
const CELL_TEXELS = vec2i(4, 2);
// Where a square's plumes give way to those of the wider one, and these to none: shares of its half side.
const ENDS = vec2f(0.75, 0.95);
// Lengths and widths of plumes of the squares, at least, and for each metre of the waves' height, metres.
const LENGTHS = array(vec2f(4.0, 0.8), vec2f(8.0, 2.0));
const WIDTHS = array(vec2f(0.8, 0.19), vec2f(1.0, 0.3));
const SIZES = vec2f(0.7, 0.6);             // sizes differ: of the least plume, and how much more
// Between which shares of young foam the wind tears more and more off, and between which heights over the mean level, of the waves' height.
const TORN_IN = vec2f(0.1, 0.6);
const CRESTS_IN = vec2f(0.0, 0.25);
const STRONGEST: f32 = 0.9;                // opacity in a hurricane
const NEAREST_PLUME = vec2f(3.0, 9.0);     // metres of its axis from the eye in which it gives way, lest it fill the picture
// Thick spray in the sun: what it sends back of it, how much more it sends on ahead, and what it sends back of the sky's light.
const LIT = vec3f(0.28, 0.96, 0.96);

// The place on the ellipsoid of a point of the foam map's plane, near the eye.
fn rest_at(offset: vec2f) -> vec3f {
    let x = wave_cells[0].axis_x;
    let y = wave_cells[0].axis_y;
    let z = -frame.eye_altitude - 0.5 * dot(offset, offset) / frame.semi_major;
    let level = offset - z * vec2f(x.z, y.z);
    return vec3f(vec2f(y.y * level.x - x.y * level.y, x.x * level.y - y.x * level.x) / (x.x * y.y - x.y * y.x), z);
}

// How much of its plumes a square shows so far from the eye.
fn shown(square: u32, offset: vec2f) -> f32 {
    let way = max(abs(offset.x), abs(offset.y));
    let reach = 0.5 * f32(PLUME_SIDE) * vec2f(CELL_TEXELS) * vec2f(frame.foam_levels[CELL_LEVELS.x].side, frame.foam_levels[CELL_LEVELS.y].side);
    let near = 1.0 - smoothstep(ENDS.x, ENDS.y, way / reach.x);
    if square == 0u { return near; }
    return (1.0 - near) * (1.0 - smoothstep(ENDS.x, ENDS.y, way / reach.y));
}

@compute @workgroup_size(64)
fn tear(@builtin(global_invocation_id) id: vec3u) {
    let square = id.x / (PLUME_SIDE * PLUME_SIDE);
    let level = frame.foam_levels[CELL_LEVELS[square]];
    let texels = CELL_TEXELS[square];
    // The cell of the water that is kept in the slot.
    let slot = vec2i(vec2u(id.x % PLUME_SIDE, id.x / PLUME_SIDE % PLUME_SIDE));
    let half = i32(PLUME_SIDE) / 2;
    let eye = vec2i(floor(vec2f(level.texel) / f32(texels)));
    let cell = eye + ((slot - eye + half) & vec2i(i32(PLUME_SIDE) - 1)) - half;
    let bits = hash(vec3u(bitcast<vec2u>(cell), square));
    let random = unpack4x8unorm(bits);
    let offset = (vec2f(cell * texels - level.texel) + random.xy * f32(texels) - level.fraction) * level.side;

    let rest = rest_at(offset);
    let far = length(rest);
    let grazing = max(frame.eye_altitude / max(far, 1e-3), 0.03);
    let place = placed(rest, far * frame.pixel_angle * frame.cell_pixels * inverseSqrt(grazing));
    let height = place.allowed * place.sea.height;
    let young = height * foam_share(offset, place.height, place.sea.height, max(far * frame.pixel_angle, 0.3 * level.side), true).young;
    let crest = smoothstep(CRESTS_IN.x, CRESTS_IN.y, place.height / max(frame.wave_height, 0.1));
    let distance = length(place.moved);
    let size = (SIZES.x + SIZES.y * random.w) * vec2f(dot(LENGTHS[square], vec2f(1.0, frame.wave_height)), dot(WIDTHS[square], vec2f(1.0, frame.wave_height)));
    let nearest = length(place.moved + clamp(-dot(place.moved, downwind()), 0.0, size.x) * downwind());
    let strength = select(0.0, STRONGEST * frame.spindrift, place.is_ocean) * crest * smoothstep(TORN_IN.x, TORN_IN.y, young) * shown(square, offset)
        * smoothstep(NEAREST_PLUME.x, NEAREST_PLUME.y, nearest);

    let up = normal_delta(rest) + vec3f(0.0, 0.0, 1.0);
    let direction = place.moved / max(distance, 1e-3);
    var light = daylight_at(dot(frame.light, up));
    if CLOUDS { light = clouded_daylight(light, up, shadow_of_pixel(rest, vec3f(0.0), true)); }
    let ahead = max(dot(direction, frame.light), 0.0);
    let thick = (light.sun * (LIT.x + LIT.y * ahead * ahead * ahead * ahead) + light.sky * LIT.z) / PI;
    plumes[id.x] = Plume(place.moved, strength, through_air(thick, light, up, direction, distance), random.z, size, vec2f(0.0));
}
