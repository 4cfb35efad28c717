// Bind group 0: what every drawing pass shares. The structs are declared in src/scene/frame/uniform.rs.
//
// Local frame: metres, origin at the eye, x east, y north, z along the geodetic normal of the eye's foot point.
// Map squares: 0 Mercator, 1 north stereographic, 2 south stereographic; fixed point, 2^32 = one side, x right, y down.

alias Metres = f32;

const FOAM_LEVELS = 4u;
const FOAM_TEXELS: i32 = 256;     // along a side of a level of the foam map

const CASCADES = 4u;             // of wave patches, at most
const PATCHES = 5u;              // that have a lattice: the cascades, then the Perlin patch

const MAX_CELLS = 24u;
const NEAR: Metres = 0.1;      // reversed depth = NEAR / (distance along the view axis), no far plane

#import frame_memory

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<uniform> wave_cells: array<WaveCell, MAX_CELLS>;
@group(0) @binding(2) var clamped: sampler;
@group(0) @binding(3) var repeated: sampler;
