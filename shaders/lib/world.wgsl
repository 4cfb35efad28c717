// Terrain and water tiles: two atlases of 256-texel layers, each found through a table of pages.
// A page names the finest resident tile over a place; a missing tile is its parent, magnified.
#import map

const TILE_BITS = 8u;
const TILE_TEXELS = 256u;
const PAGE_LEVELS = 12u;
const PAGE_WINDOW = 64u;       // tiles per side that a level's table covers, around the eye
const EARTH_TURN: Metres = 40075016.686;

@group(0) @binding(4) var terrain_tiles: texture_2d_array<f32>;
@group(0) @binding(5) var water_tiles: texture_2d_array<f32>;
@group(0) @binding(6) var<storage, read> terrain_pages: array<u32>;
@group(0) @binding(7) var<storage, read> water_pages: array<u32>;

struct Page { layer: u32, level: u32 }

fn page_at(water: bool, square: u32, level: u32, tile: vec2u) -> Page {
    let slot = ((square * PAGE_LEVELS + level) * PAGE_WINDOW + (tile.y & 63u)) * PAGE_WINDOW + (tile.x & 63u);
    var word: u32;
    if water { word = water_pages[slot]; } else { word = terrain_pages[slot]; }
    return Page(word & 0xffffu, word >> 16u);
}

fn reference_fixed(square: u32) -> vec2u {
    if square == MERCATOR { return frame.mercator_fixed; }
    return select(frame.south_fixed, frame.north_fixed, square == NORTH);
}

// The finest level whose texels are no smaller than `footprint`, and whose page table reaches the place.
fn level_for(point: MapPoint, footprint: Metres, cos_lat: f32) -> u32 {
    let whole = select(POLAR_EXTENT * 4.0 * 6378137.0, EARTH_TURN * cos_lat, point.square == MERCATOR) / f32(TILE_TEXELS);
    var level = u32(clamp(ceil(log2(whole / max(footprint, 0.01))), 0.0, f32(PAGE_LEVELS - 1u)));
    let away = point.at - reference_fixed(point.square);
    let distance = vec2u(min(away.x, 0u - away.x), min(away.y, 0u - away.y));
    let reach = max(distance.x, distance.y) | 1u;
    // tiles away = reach >> (32 - level) must stay below 31
    let widest = 4u + countLeadingZeros(reach);
    return min(level, widest);
}

// Metres of elevation, or signed distances to the ocean's and the lakes' shores in texels of `level`.
fn texel(water: bool, square: u32, level: u32, index: vec2u) -> vec3f {
    let page = page_at(water, square, level, index >> vec2u(TILE_BITS));
    let at = (index >> vec2u(level - min(page.level, level))) & vec2u(TILE_TEXELS - 1u);
    if water {
        // Stored in sixteenths of a texel of the tile's own level.
        let sixteenths = textureLoad(water_tiles, at, page.layer, 0).xyz * 255.0 - 128.0;
        return sixteenths * (exp2(f32(level) - f32(page.level)) / 16.0);
    }
    return textureLoad(terrain_tiles, at, page.layer, 0).xyz;
}

// Bilinear, across tile borders too, at the level that is resident under the point.
fn bilinear(water: bool, point: MapPoint, wanted: u32) -> vec4f {
    var level = min(wanted, PAGE_LEVELS - 1u);
    level = min(page_at(water, point.square, level, (point.at >> vec2u(32u - max(level, 1u))) >> vec2u(select(0u, 1u, level == 0u))).level, level);
    let shift = 24u - level;
    let shifted = point.at - vec2u(1u << (shift - 1u));
    let f = vec2f(shifted & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    let mask = (TILE_TEXELS << level) - 1u;
    let i0 = (shifted >> vec2u(shift)) & vec2u(mask);
    let i1 = (i0 + vec2u(1u)) & vec2u(mask);
    let top = mix(texel(water, point.square, level, i0), texel(water, point.square, level, vec2u(i1.x, i0.y)), f.x);
    let bottom = mix(texel(water, point.square, level, vec2u(i0.x, i1.y)), texel(water, point.square, level, i1), f.x);
    return vec4f(mix(top, bottom, f.y), f32(level));
}

struct Ground {
    elevation: Metres,      // of the dry or submarine ground, shaped to agree with the shore
    ocean_shore: Metres,    // signed distance, positive in the ocean
    lake_shore: Metres,     // signed distance, positive in lakes
    is_ocean: bool,
    is_lake: bool,
}

// Agrees with `shaped_elevation` in src/model/sea_bed.rs: a coarse elevation made to agree with a sharp coast.
fn shaped_elevation(elevation: Metres, ocean_shore: Metres, resolution: Metres) -> Metres {
    let d = abs(ocean_shore);
    if ocean_shore > 0.0 {
        let raw = max(-elevation, 0.0);
        let depth = mix(min(raw, 0.03 * d), raw, smoothstep(0.0, resolution, d));
        return -max(depth, min(0.01 * d, 30.0));
    }
    let risen = elevation * smoothstep(0.0, resolution / 3.0, d);
    return select(risen, max(risen, min(0.01 * d, 2.0)), elevation >= 0.0);
}

// Metres on the ground per metre of the level-0 texel grid, at a point of a square.
fn texel_metres(point: MapPoint, level: f32, sin_lat: f32) -> Metres {
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    let polar = 2.0 * POLAR_EXTENT * 6378137.0 * (1.0 + abs(sin_lat));
    return select(polar, EARTH_TURN * cos_lat, point.square == MERCATOR) / (f32(TILE_TEXELS) * exp2(level));
}

fn ground_at(point: MapPoint, sin_lat: f32, footprint: Metres) -> Ground {
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    let level = level_for(point, footprint, cos_lat);
    let terrain = bilinear(false, point, level);
    let water = bilinear(true, point, level);
    var shores = water.xy * texel_metres(point, water.w, sin_lat);
    // Without any water tile the sign of the elevation tells sea from land.
    if page_at(true, point.square, 0u, vec2u(0u)).layer == 0u {
        shores = vec2f(select(-1e6, 1e6, terrain.x <= 0.0), -1e6);
    }
    return Ground(shaped_elevation(terrain.x, shores.x, frame.terrain_resolution), shores.x, shores.y,
        shores.x > 0.0, shores.y > 0.0 && shores.x <= 0.0);
}
