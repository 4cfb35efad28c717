// What stands on the ground: groves, trees, shrubs, herbs and tufts of grass, domes of five sizes of cells.
#import canopy
#import domes

// That of a size: groves with cells of 37 m at the equator, trees of 8.5 m, shrubs of 3.0 m, herbs of 1.2 m, tufts of 0.38 m.
fn lattice_of(size: u32) -> Lattice {
    if size == 0u { return Lattice(18u, vec2i(4, -1), 0.6, 0.4, vec2f(-0.7, 0.3), true); }
    if size == 1u { return Lattice(21u, vec2i(2, 1), 0.6, 1.0, vec2f(-0.9, 0.6), true); }
    if size == 2u { return Lattice(22u, vec2i(3, -1), 0.6, 0.9, vec2f(-0.8, 0.75), true); }
    if size == 3u { return Lattice(23u, vec2i(4, 1), 0.6, 0.85, vec2f(-0.7, 1.15), false); }
    return Lattice(25u, vec2i(1, 3), 0.7, 1.1, vec2f(-0.85, 1.6), false);
}

const SIZES = 5u;

// How many of a size stand, of cells. `clumps`: how much more grows here than around in patches some 76, 19, 5 and 1 m wide; those that are a few cells wide
// make groups of a size.
fn share_of(size: u32, green: f32, clumps: vec4f) -> f32 {
    let bare = array(0.05, 0.05, 0.10, 0.15, 0.30);
    let lush = array(0.34, 0.40, 0.55, 0.60, 0.95);
    let groups = select(select(clumps.x + 0.7 * clumps.y, 0.6 * clumps.x + 1.2 * clumps.y, size == 2u), select(0.7 * clumps.y + clumps.z, 0.7 * clumps.z + clumps.w, size == 4u), size > 2u);
    return clamp(mix(bare[size], lush[size], green) + mix(1.2, 2.0, green) * select(1.0, 1.8, size > 2u) * groups, 0.0, select(0.6, 0.95, size > 2u));
}

// Crowns of woods, as far as pixels so wide show them: of upright ones a flat sight sees fewer, but no narrower.
fn in_woods(p: FinePoint, woods: f32, pointed: f32, sight: vec2f, sun: vec2f, eye: Metres, footprint: Metres, across: Metres) -> Standing {
    let cell = EARTH_TURN * max(frame.cos_lat, 0.1) / exp2(f32(CROWN_LEVEL)) / length(vec2f(CROWN_TURN));
    let whole = woods * smoothstep(1.3, 2.2, eye / cell) * (1.0 - smoothstep(0.4, 1.2, min(footprint, 1.5 * across) / cell));
    let own = canopy(p, woods, pointed, sight, sun, across / cell, whole <= 0.0);
    return Standing(whole * own.tone, whole, whole * own.rise, whole * own.shade, own.leaf);
}

// What stands on ground that is so `green`; `clumps`: as of `share_of`. `farm`: how far it is farmed, where few trees and shrubs are left. `open`: from 0 to 1 from a beach to where trees can grow; `sight` and `sun`: as of `domes`; `eye`: how high it is above the ground,
// which is no more than a picture: there are no trees about an eye below their tops. `across`: of a pixel that faces the eye, as the sides of plants do.
fn plants(p: FinePoint, woods: f32, pointed: f32, green: f32, clumps: vec4f, farm: f32, open: f32, sight: vec2f, sun: vec2f, eye: Metres, footprint: Metres, across: Metres) -> Standing {
    var found = in_woods(p, woods, pointed, sight, sun, eye, footprint, across);
    let apart = 1.0 - woods;
    var size = 0u;
    loop {
        let lattice = lattice_of(size);
        let top = dome_top(lattice);
        let small = max(f32(size) - 1.0, 0.0) / 3.0;
        let cell = EARTH_TURN * max(frame.cos_lat, 0.1) / exp2(f32(lattice.level)) / length(vec2f(lattice.turn));
        // Towards the beach groups become smaller and fewer.
        let grows = smoothstep(0.55 - 0.55 * small, 1.0 - 0.1 * small, open);
        let share = smoothstep(1.2 * top, 3.0 * top, eye / cell) * select(1.0, apart * (1.0 - 0.85 * farm), size < 3u) * max(share_of(size, green, clumps) + grows - 1.0, 0.0);
        // Groves take the place of trees that do not show.
        let near = select(1.0, smoothstep(0.06, 0.17, footprint / cell), size == 0u);
        let whole = near * (1.0 - smoothstep(0.25, 0.7, footprint / cell));
        let own = domes(p, lattice, share, green, sight, sun, across / cell, whole * share <= 0.0);
        let left = (1.0 - found.cover) * whole;
        found.tone += left * (own.tone - mean_tone(lattice, share, green));
        found.rise += left * own.rise;
        found.shade += (1.0 - found.shade) * left * own.shade;
        found.cover += left * own.cover;
        found.leaf = select(found.leaf, own.leaf, left * own.cover > 0.5);
        size++;
        if size >= SIZES || (whole <= 0.0 && size > 1u) { break; }
    }
    // Boughs bend the light, leaves are many dark and few bright: n + n²/2 - 1/2 of a noise n whose deviation is one.
    let branches = shown(found.leaf.z, 0.125) * bed_noise(found.leaf.xy, 0.125, 83u);
    let leaves = shown(found.leaf.z, 0.03125) * bed_noise(found.leaf.xy, 0.03125, 84u);
    let n = leaves.z / BED_NOISE_DEVIATION;
    found.tone += found.cover * (1.2 * branches.z + 0.25 * (n + 0.5 * (n * n - shown(found.leaf.z, 0.03125))));
    found.rise += found.cover * (0.17 * branches.xy + 0.02 * leaves.xy);
    return found;
}
