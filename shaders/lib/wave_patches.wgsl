// The wave patches and the Perlin patch around a point of the sea: which of them a footprint still shows, from which mip level, and how one
// cell of the wave domain lays them there. lib/waves.wgsl adds up what they hold.
#import domain

// displacements: (Dx, Dy, height, 0); slopes: (hx, hy, hx hx, hy hy), hx = dh/dx; stretches: (dDx/dx, dDy/dy, dDx/dy, 0);
// one layer per cascade.
@group(1) @binding(0) var displacements: texture_2d_array<f32>;
@group(1) @binding(1) var slopes: texture_2d_array<f32>;
@group(1) @binding(2) var stretches: texture_2d_array<f32>;
@group(1) @binding(3) var perlin: texture_2d<f32>;      // (height, dh/dx, dh/dy, hx hx + hy hy)

// A cascade's patch as a vertex lays it: sample n of it stands at n / N of its length, a texel's centre at (n + 1/2) / N.
fn cascade_placement(plane: Plane, cascade: u32, triangle: LatticeTriangle, k: u32, texels: f32) -> Placement {
    var found = placement(plane, cascade, frame.spacings[cascade], frame.patches[cascade], triangle, k);
    found.at += 0.5 / texels;
    return found;
}

// Mip level at which a texel is as wide as `footprint`.
fn mip_for(footprint: Metres, patch_length: Metres, texels: f32) -> f32 {
    return log2(max(footprint * texels / patch_length, 1.0));
}

// Beyond a patch's coarsest useful mip nothing is left of it but its mean, zero.
fn resolvable(footprint: Metres, patch_length: Metres) -> f32 {
    return 1.0 - smoothstep(0.1, 0.4, footprint / patch_length);
}

// Patches of which something is left, the longest of all first: how many, and how many whose longest waves, a sixth of the patch, are two
// footprints or longer. Of the others neighbouring footprints share nothing: there one vertex of the lattice serves as well as three,
// with no seam to be seen, and their chop steepens no crest that shows.
struct Shown { all: u32, clear: u32 }

fn shown_cascades(footprint: Metres) -> Shown {
    // A patch that is not there is 0 m long.
    let all = select(vec4u(0u), vec4u(1u), vec4f(footprint) < 0.4 * frame.patches);
    let clear = select(vec4u(0u), vec4u(1u), vec4f(footprint) < frame.patches / 12.0);
    return Shown(all.x + all.y + all.z + all.w, clear.x + clear.y + clear.z + clear.w);
}

fn any_resolvable(footprint: Metres) -> bool {
    return resolvable(footprint, max(frame.patches.x, frame.perlin_patch)) > 0.0;
}

// A point as one of the cells that serve it has it: the cell's weight there, its plane, and the point in that.
struct InCell { share: f32, plane: Plane, q: vec2f }

fn in_cell(cell: u32, p: vec3f, cells: Serving) -> InCell {
    let plane = plane_of(cell);
    return InCell(cell_weight(cell, p, cells), plane, in_plane(plane, p));
}

// A patch around a point: the lattice's triangle, the mip level that a footprint takes, and how much of the patch is left there.
struct Around { triangle: LatticeTriangle, lod: f32, fade: f32 }

fn cascade_around(here: InCell, c: u32, footprint: Metres, texels: f32) -> Around {
    let length = frame.patches[c];
    let triangle = lattice_triangle(here.plane, c, frame.spacings[c], here.q);
    return Around(triangle, mip_for(footprint, length, texels), resolvable(footprint, length));
}

fn perlin_around(here: InCell, footprint: Metres) -> Around {
    let length = frame.perlin_patch;
    let triangle = lattice_triangle(here.plane, PERLIN_PATCH, frame.perlin_spacing, here.q);
    return Around(triangle, mip_for(footprint, length, f32(textureDimensions(perlin).x)), resolvable(footprint, length));
}

fn perlin_placement(plane: Plane, triangle: LatticeTriangle, k: u32) -> Placement {
    return placement(plane, PERLIN_PATCH, frame.perlin_spacing, frame.perlin_patch, triangle, k);
}

// The triangle, or its greatest vertex alone.
fn served(triangle: LatticeTriangle, whole: bool) -> LatticeTriangle {
    if whole { return triangle; }
    var one = triangle;
    one.weights = vec3f(1.0, 0.0, 0.0);
    return one;
}

// A symmetric tensor (xx, yy, xy) of a patch, turned to east and north; ax and ay are the patch's axes.
fn turned(t: vec3f, ax: vec2f, ay: vec2f) -> vec3f {
    return vec3f(
        t.x * ax.x * ax.x + t.y * ay.x * ay.x + 2.0 * t.z * ax.x * ay.x,
        t.x * ax.y * ax.y + t.y * ay.y * ay.y + 2.0 * t.z * ax.y * ay.y,
        t.x * ax.x * ax.y + t.y * ay.x * ay.y + t.z * (ax.x * ay.y + ax.y * ay.x));
}
