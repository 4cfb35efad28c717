// The far sea: octaves of tileable gradient noise (K. Perlin 1985, 2002), stretched across the wind, drifting and
// changing with time, with slopes by central differences of four neighbours.
// Output (height, dh/dx, dh/dy, hx hx + hy hy), metres. Amplitudes: src/model/perlin.rs.
#import hash

struct PerlinSettings {
    // Per octave: drift downwind as a fraction of the patch, turn of the lattice gradients in radians, amplitude in metres, unused.
    octaves: array<vec4f, OCTAVES>,
    patch_length: f32,     // metres
    seed: u32,
    peak_cells: u32,       // lattice cells per patch of the first octave, along the wind
    unused: u32,
}

@group(0) @binding(0) var<uniform> settings: PerlinSettings;
@group(0) @binding(1) var output: texture_storage_2d<FORMAT, write>;

const OCTAVES = 4u;
const TURN = 6.283185307179586;

// Gradient noise whose lattice gradients turn slowly, so that the field lives; period `cells`.
fn noise(p: vec2f, cells: vec2u, octave: u32, turn: f32) -> f32 {
    let cell = vec2i(floor(p));
    let f = p - floor(p);
    let u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    var corner: array<f32, 4>;
    for (var c = 0u; c < 4u; c++) {
        let offset = vec2i(i32(c & 1u), i32(c >> 1u));
        let wrapped = vec2u((cell + offset + vec2i(cells) * 4) % vec2i(cells));
        let angle = TURN * f32(hash(vec3u(wrapped, octave + settings.seed * 16u)) >> 8u) / 16777216.0 + turn;
        corner[c] = dot(vec2f(cos(angle), sin(angle)), f - vec2f(offset));
    }
    return mix(mix(corner[0], corner[1], u.x), mix(corner[2], corner[3], u.x), u.y);
}

fn height(texel: vec2i, size: vec2f) -> f32 {
    var sum = 0.0;
    for (var o = 0u; o < OCTAVES; o++) {
        // Crests run across the wind (x): twice as many cells along it.
        let cells = vec2u(settings.peak_cells, settings.peak_cells / 2u) << vec2u(o);
        let octave = settings.octaves[o];
        let p = ((vec2f(texel) + 0.5) / size - vec2f(octave.x, 0.0)) * vec2f(cells);
        sum += octave.z * noise(p, cells, o, octave.y);
    }
    return sum;
}

const SIDE = 16u;              // texels per side of a workgroup; heights reach one texel beyond
const REACH = SIDE + 2u;

var<workgroup> heights: array<f32, REACH * REACH>;

@compute @workgroup_size(SIDE, SIDE)
fn octaves(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_id) local: vec3u, @builtin(local_invocation_index) index: u32) {
    let size = vec2f(textureDimensions(output));
    let corner = vec2i(group.xy * SIDE) - 1;
    for (var i = index; i < REACH * REACH; i += SIDE * SIDE) {
        heights[i] = height(corner + vec2i(vec2u(i % REACH, i / REACH)), size);
    }
    workgroupBarrier();
    let here = (local.y + 1u) * REACH + local.x + 1u;
    let step = 2.0 * settings.patch_length / size.x;
    let slope = vec2f(heights[here + 1u] - heights[here - 1u], heights[here + REACH] - heights[here - REACH]) / step;
    textureStore(output, group.xy * SIDE + local.xy, vec4f(heights[here], slope, dot(slope, slope)));
}
