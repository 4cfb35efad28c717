// Bind group 0: what every drawing pass shares. Mirrors `FrameUniform` and `WaveNode` in src/scene/frame.rs (tested).
//
// Local frame: metres, origin at the eye, x east, y north, z along the geodetic normal of the eye's foot point.
// Map squares: 0 Mercator, 1 north stereographic, 2 south stereographic; fixed point, 2^32 = one side, x right, y down.

alias Metres = f32;

const FOAM_LEVELS = 4u;
const FOAM_TEXELS: i32 = 256;     // along a side of a square of the foam map

// A square of the foam map; its texels are fixed in the plane of the first wave cell.
struct FoamLevel {
    texel: vec2i,              // that the eye is in
    fraction: vec2f,           // of a texel from its corner to the eye
    side: Metres,              // of a texel
    threshold: f32,            // smaller eigenvalue of the chop's gradient below which whitecaps begin
    softness: f32,             // how far below it a texel breaks as a whole
    unused: u32,
}

struct Frame {
    clip_from_local: mat4x4f,
    // A ray through normalised device coordinates (x, y): ray_forward + x * ray_right + y * ray_up (not unit).
    ray_right: vec3f,
    eye_altitude: Metres,
    ray_up: vec3f,
    semi_major: Metres,
    ray_forward: vec3f,
    semi_minor: Metres,
    // The ellipsoid as a quadric about the eye: F(P) = C + 2 g.P + P'QP in metres; F = 0 on it, F ~ height near it.
    quadric_diagonal: vec3f,
    quadric_constant: Metres,
    quadric_mixed: vec3f,      // xy, xz, yz
    projector_rise: Metres,    // the projected grid is cast from this far above the eye
    quadric_gradient: vec3f,
    projector_constant: Metres,
    projector_gradient: vec3f,
    rim_reach: Metres,         // how far the chop may bring water into the screen; 0 where that is less than pixels
    // Geodetic trigonometry of the eye's foot.
    sin_lat: f32,
    cos_lat: f32,
    foot_nu: Metres,           // sqrt(a^2 cos^2 + b^2 sin^2)
    mercator_sin: f32,         // sine of the latitude of the Mercator reference point
    north_point: vec2f,        // stereographic coordinates of the polar reference points
    south_point: vec2f,
    north_delta: vec3f,        // normal at the eye's foot minus normal at the reference point, earth axes turned to the eye's meridian
    mercator_sin_delta: f32,   // sin_lat - mercator_sin
    south_delta: vec3f,
    whitecaps: f32,            // share of the surface under whitecaps
    mercator_fixed: vec2u,
    north_fixed: vec2u,
    south_fixed: vec2u,
    meridian: vec2f,           // cosine and sine of the eye's longitude
    sun: vec3f,                // unit vector towards the sun
    exposure: f32,
    viewport: vec2f,           // pixels
    pixel_angle: f32,          // radians per pixel at the centre
    water_density: f32,        // rho of alpha = 1 - exp(-rho depth), per metre
    wind: vec2f,               // velocity of the wind, m/s, east and north at the eye
    wave_height: Metres,       // significant height Hs
    chop: f32,
    mix_near: Metres,          // the FFT's own distance, and the Perlin field's
    mix_far: Metres,
    foam_rule: u32,            // 0 where the chop folds, 1 on high water
    perlin_patch: Metres,
    patches: vec4f,            // patch lengths of the cascades, metres
    spacings: vec4f,           // spacings of their lattices
    lace_texel: vec2i,         // of the eye in the foam's lace, which is aligned with the wind, and the way into it
    lace_fraction: vec2f,
    perlin_spacing: Metres,
    cell_pixels: f32,          // along a cell of the projected grid
    unused_b: f32,
    unused_c: f32,
    node_count: u32,
    layers: u32,               // bit 0 land, 1 sea, 2 sky
    output: u32,               // 0 the picture, else a measured layer
    cascade_count: u32,
    terrain_resolution: Metres,
    crest_height: Metres,      // the highest crest to expect
    foam_heights: vec2f,       // water above the first carries foam, above the second nothing else (rule 1), metres
    // Slope variances along the wind and across it: of the waves that no cascade holds, of each cascade's (two in a row).
    below_slopes: vec2f,
    under_water: u32,          // 1 when the eye is in the sea
    chop_level: Metres,        // mean level of the choppy FFT tiles, at most 0; what is drawn has it subtracted
    cascade_slopes: array<vec4f, 2>,
    perlin_slopes: vec4f,      // what the Perlin tile does not hold, then its own
    foam_levels: array<FoamLevel, FOAM_LEVELS>,
}

// Where the lattice of a tile lies: a vertex near the eye, and the way from it to the eye in the cell's plane, metres.
struct WaveAnchor {
    vertex: vec2i,
    eye: vec2f,
}

const TILES = 5u;              // that have a lattice: the cascades, then the Perlin tile

// One cell of the wave domain: its plane about the eye, and the tiles' lattices in it. North at (x, y) metres from its centre is along
// (-x turn, cos_lat - y turn).
struct WaveNode {
    origin: vec3f,             // its centre, local
    cos_lat: f32,
    axis_x: vec3f,             // local; east at the centre
    turn: f32,
    axis_y: vec3f,             // north at the centre
    key: u32,                  // random bits
    wind: vec2f,               // sine and cosine of the bearing that the wind comes from
    polar_north: vec2f,        // direction that stands for north at a pole
    anchors: array<WaveAnchor, TILES>,
}

const MAX_NODES = 24u;
const NEAR: Metres = 0.1;      // reversed depth = NEAR / (distance along the view axis), no far plane

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<uniform> nodes: array<WaveNode, MAX_NODES>;
@group(0) @binding(2) var clamped: sampler;
@group(0) @binding(3) var repeated: sampler;
