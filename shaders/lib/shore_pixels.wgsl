// Pixels that the shore crosses. Who imports this declares MEASURED (src/pass/kind.rs).
#import ground_slope

fn east_at(up: vec3f) -> vec3f {
    return normalize(cross(vec3f(0.0, frame.cos_lat, frame.sin_lat), up) + vec3f(1e-9, 0.0, 0.0));
}

const LEAST_SINKING: f32 = 0.02;  // of a sight over the ground: none is seen flatter

// How far a sight moves right and down on the map while it sinks by one, `least` of its length or more.
fn sinking(point: MapPoint, direction: vec3f, up: vec3f, least: f32) -> vec2f {
    let east = east_at(up);
    let north = cross(up, east);
    let level = vec2f(dot(direction, east), dot(direction, north));
    let along = vec2f(dot(level, east_north_of(point, vec2f(1.0, 0.0))), dot(level, east_north_of(point, vec2f(0.0, -1.0))));
    return along / max(-dot(direction, up), least);
}

// How wide a pixel is towards the shore: one that is `across` wide is longer along its sight.
fn width_to_shore(ground: Ground, sight: vec2f, across: Metres) -> Metres {
    return across * length(vec2f(max(length(ground.shore_rise), 0.5), dot(ground.shore_rise, sight)));
}

// How much of a pixel so wide is ocean, where the shore crosses it; a measured layer says what its middle is.
fn ocean_share(ground: Ground, width: Metres) -> f32 {
    if MEASURED { return select(0.0, 1.0, ground.is_ocean); }
    return saturate(0.5 + ground.ocean_shore / width);
}

const EDGE_FADES = vec2f(0.4, 2.0);   // from the waterline, over which water that runs up a beach becomes the sea: metres at least, and pixels
const EDGE_SEEN = vec2f(1.0, 3.0);    // widths of pixels between which that is no longer seen, metres

fn edge_seen(width: Metres) -> f32 { return smoothstep(EDGE_SEEN.y, EDGE_SEEN.x, width); }

// Over how much of the sea beside a beach its water and that which runs up the beach go over into each other: neither begins at a line.
fn edge_of_sea(width: Metres) -> Metres { return edge_seen(width) * max(EDGE_FADES.x, EDGE_FADES.y * width); }

// How much of the sea there is, a signed distance from its shore, positive in it.
fn out_of_swash(ocean_shore: Metres, width: Metres) -> f32 { return smoothstep(0.0, max(edge_of_sea(width), 1e-3), ocean_shore); }

// Over so many times that the beach's own water goes on below the sea's, from a part of it on: where both were let off over the same way dry sand would be a
// line between them, and where one lay whole below the other a dark one.
const BEACH_BELOW = vec2f(0.3, 1.5);

fn edge_of_beach(width: Metres) -> Metres { return BEACH_BELOW.y * edge_of_sea(width); }

fn out_of_beach(ocean_shore: Metres, width: Metres) -> f32 { return smoothstep(BEACH_BELOW.x * edge_of_sea(width), max(edge_of_beach(width), 1e-3), ocean_shore); }

// Depth of the ocean in a pixel, which its middle may miss: there as at a gentle shore.
fn ocean_depth(ground: Ground, footprint: Metres, share: f32) -> Metres { return max(-ground.elevation, 0.01 * footprint * share); }

// How much of a pixel is a lake or a river. Texels are half as wide as a pixel to as wide (`level_for`), so that of a river the share of a texel
// serves: it is what tells of rivers narrower than that (`signed` of src/data/coast/river.rs). Of ground that is seen aslant, whose pixels are
// longer, narrow waters cover less.
fn inland_share(ground: Ground, footprint: Metres) -> f32 {
    if MEASURED { return select(0.0, 1.0, ground.is_lake); }
    let share = saturate(0.5 + ground.lake_shore / select(footprint, min(ground.texel, footprint), ground.by_river));
    let aslant = 1.0 - pow(max(1.0 - share, 1e-6), min(2.0 * ground.texel / footprint, 1.0));
    return select(select(share, aslant, ground.by_river & (share < 1.0)), 0.0, ground.is_ocean);
}
