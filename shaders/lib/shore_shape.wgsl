// The shape of the ground near a coast: a coarse elevation made to agree with a sharp shoreline. As src/model/sea_bed.rs, in 32 bits: see there
// what and why.
#import frame

// What one value of the grid tells: elevation, depth where it is wet, whether it is. Interpolated: what the grid's cells around a place have.
fn grid_value(elevation: Metres) -> vec3f { return vec3f(elevation, max(-elevation, 0.0), select(0.0, 1.0, elevation < 0.0)); }

// Elevation of a place so far in the ocean around which the nearest texels have so much: there of the wet ones alone.
fn elevation_at(grid: vec3f, ocean_shore: Metres) -> Metres { return select(grid.x, -grid.y / max(grid.z, BED_LEAST_SHARE), ocean_shore > 0.0); }

// A of Dean's profile and slope at the waterline; 0 a beach, 1 a cliff or a front of ice; how deep the profile goes, and the water off the coast, and that at least; how far
// the grid's own values are trusted far from the shore.
struct Coast { a: f32, m: f32, cliff: f32, deepest: Metres, far: Metres, least: Metres, trust: f32 }

fn coast_of(grid: vec3f, sin_lat: f32) -> Coast {
    let cell = max(frame.terrain_resolution, 1.0);
    let sea = grid.y / max(grid.z, BED_LEAST_SHARE);
    let land = max(grid.x + grid.y, 0.0) / max(1.0 - grid.z, BED_LEAST_SHARE);
    let least = mix(BED_UNKNOWN, BED_LEAST, smoothstep(0.0, 0.5, grid.z));
    let off = sea + land;
    let sand = clamp(DEAN_A * pow(max(off, 1e-3) / DEAN_DEPTH, 1.0 / 3.0) * pow(DEAN_CELL / cell, 2.0 / 9.0), SAND_LEAST, SAND_MOST);
    let cliff = max(smoothstep(CLIFF_BEGINS, CLIFF_WHOLE, 2.0 * land / cell), smoothstep(ICE_BEGINS, ICE_WHOLE, -sin_lat));
    let steep = off / (ROCKY_SLOPE * cell);
    let a = min(sand * (1.0 + steep * steep + ROCK_ADDS * cliff), ROCK_MOST);
    return Coast(a, mix(FACE_LEAST + FACE_RISES * sand, CLIFF_SLOPE, cliff), cliff, max(off, least), sea, least, smoothstep(BED_WET, BED_ALL_WET, grid.z));
}

// Level of the terrain's tiles whose texels are about as wide as the grid's cells at the equator.
fn grid_level() -> u32 { return u32(max(log2(EQUATOR_TEXEL / max(frame.terrain_resolution, 1.0)), 0.0)); }

// How many times as steep as by nature the user wants the bed.
fn bed_steeper() -> f32 { return frame.shore.x / USUAL_SLOPE; }

// Depth of the profile at a distance from the shore: h/m + (h/A)^1.5 is that distance.
fn profile_depth(coast: Coast, d: Metres) -> Metres {
    let ratio = coast.m / coast.a;
    let q = max(d * ratio * ratio * ratio, 1e-12);
    var s = min(sqrt(q), pow(q, 1.0 / 3.0));
    s -= (s * s * (1.0 + s) - q) / (s * (2.0 + 3.0 * s));
    s -= (s * s * (1.0 + s) - q) / (s * (2.0 + 3.0 * s));
    s -= (s * s * (1.0 + s) - q) / (s * (2.0 + 3.0 * s));
    return coast.a / (ratio * ratio) * s * s;
}

// What becomes of the grid's elevation of a place at a signed distance from the ocean's shore, positive in the ocean. One root and one power, whatever is under the pixel: most
// shaders run both sides of a branch.
fn shaped_elevation(elevation: Metres, coast: Coast, ocean_shore: Metres) -> Metres {
    let d = abs(ocean_shore);
    let trusted = min(frame.terrain_resolution, BED_WIDEST);
    let w = smoothstep(0.1 * trusted, trusted, d);
    let near = min(bed_steeper() * profile_depth(coast, d), coast.deepest);
    let far = max(mix(coast.far, -elevation, w * (1.0 - w * w * w * (1.0 - coast.trust))), coast.least);
    let depth = select(far, near * pow(far / max(near, 0.1), w), w < 1.0);
    let scaled = elevation * smoothstep(0.0, frame.terrain_resolution / 3.0, d);
    let berm = min(bed_steeper() * coast.m * d, BERM * smoothstep(0.0, 1.0, elevation));
    return select(select(scaled, max(scaled, berm), elevation >= 0.0), -depth, ocean_shore > 0.0);
}
