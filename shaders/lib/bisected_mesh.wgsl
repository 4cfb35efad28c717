// The bisected mesh as the sea's vertices see it. How it comes about: shaders/bisect.wgsl.
#import cuboid

@group(3) @binding(0) var<uniform> bisection: Bisection;
@group(3) @binding(1) var<storage, read> corners: array<u32>;      // three of each slot, three numbers each
@group(3) @binding(2) var<storage, read> drawn: array<u32>;        // slots to draw
@group(3) @binding(3) var<storage, read> accounts: array<f32>;     // `State` of lib/bisectors.wgsl

const COARSENESS = 9u;         // member of `State`
const GROWN = 1.5;             // an edge this much longer than wished has its middle in its own place

fn drawn_corner(index: u32) -> vec3u {
    let at = 9u * drawn[index / 3u] + 3u * (index % 3u);
    return vec3u(corners[at], corners[at + 1u], corners[at + 2u]);
}

// Length that the edges around a place have, about.
fn wished_length(rest: vec3f) -> Metres {
    return bisection.target_pixels * accounts[COARSENESS] / pixels_of(Reach(rest, 1.0, 0.0));
}

// How far the middle of an edge has come from the edge to its own place.
fn grown_share(edge: Edge) -> f32 {
    let pixels = pixels_of(reach_of(edge.first, edge.second)) / (bisection.target_pixels * accounts[COARSENESS]);
    return clamp((pixels - 1.0) / (GROWN - 1.0), 0.0, 1.0);
}
