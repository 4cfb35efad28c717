// How steep the ground is, by the terrain tile that is at hand.
#import world

// How much the terrain rises eastwards and southwards at a point, over two texels: the bilinear mean of the central differences at the four
// texels around it.
fn terrain_rises(here: TexelsAround) -> vec2f {
    let a = terrain_texel(here, 0, 0);
    let b = terrain_texel(here, 1, 0);
    let c = terrain_texel(here, 0, 1);
    let d = terrain_texel(here, 1, 1);
    let f = here.between;
    let east = mix(
        mix(b - terrain_texel(here, -1, 0), terrain_texel(here, 2, 0) - a, f.x),
        mix(d - terrain_texel(here, -1, 1), terrain_texel(here, 2, 1) - c, f.x), f.y);
    let south = mix(
        mix(c - terrain_texel(here, 0, -1), d - terrain_texel(here, 1, -1), f.x),
        mix(terrain_texel(here, 0, 2) - a, terrain_texel(here, 1, 2) - b, f.x), f.y);
    return vec2f(east, south);
}

fn terrain_texel(here: TexelsAround, x: i32, y: i32) -> Metres { return texel_around(false, here, vec2i(x, y)).x; }

// Slope of the ground at a point: metres per metre east and north. Flat on the beach, where the ground is shaped to the shore.
fn ground_slope(point: MapPoint, sin_lat: f32, ground: Ground, footprint: Metres) -> vec2f {
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    let page = pages_at(point, level_for(point, footprint, cos_lat)).terrain;
    let rises = terrain_rises(texels_around(point, page)) / (2.0 * texel_metres(point, f32(page.level), sin_lat));
    let shown = select(1.0, smoothstep(0.0, frame.terrain_resolution / 3.0, abs(ground.ocean_shore)), !ground.is_ocean);
    return vec2f(rises.x, -rises.y) * shown;
}
