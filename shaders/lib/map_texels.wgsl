// Terrain, water and imagery tiles: an atlas of 256-texel layers each, found through a table of pages, one entry for all. The atlas of
// imagery is bound by lib/imagery.wgsl, for whom needs it.
// A page names the finest tile over a place that the frame wants and has; a missing tile is its parent, magnified.
#import map

const TILE_BITS = 8u;
const TILE_TEXELS = 256u;
const PAGE_LEVELS = 14u;
const PAGE_SLOT_BITS = 12u;
const PAGE_WINDOW = 64u;       // tiles per side that a level's table covers, around the eye
const EARTH_TURN: Metres = 40075016.686;

@group(0) @binding(4) var terrain_tiles: texture_2d_array<f32>;
@group(0) @binding(5) var water_tiles: texture_2d_array<f32>;
@group(0) @binding(6) var<storage, read> pages: array<vec2u>;     // 16 bits each: terrain, water, imagery, none

struct Page { layer: u32, level: u32 }
struct Pages { terrain: Page, water: Page, imagery: Page }

// Of the low 16 bits: the layer of the atlas, then the tile's level.
fn page_of(bits: u32) -> Page { return Page(bits & ((1u << PAGE_SLOT_BITS) - 1u), (bits & 0xffffu) >> PAGE_SLOT_BITS); }

fn page_slot(square: u32, level: u32, tile: vec2u) -> u32 {
    return ((square * PAGE_LEVELS + level) * PAGE_WINDOW + (tile.y & 63u)) * PAGE_WINDOW + (tile.x & 63u);
}

// The deepest level of which a map has tiles.
fn deepest_level(square: u32) -> u32 { return (frame.deepest_pages >> (8u * square)) & 0xffu; }

// The pages that serve for a point at a level, or at the deepest that has tiles.
fn pages_at(point: MapPoint, wanted: u32) -> Pages {
    let level = min(wanted, deepest_level(point.square));
    // A shift by 32 would be none.
    let tile = (point.at >> vec2u(32u - max(level, 1u))) >> vec2u(select(0u, 1u, level == 0u));
    let words = pages[page_slot(point.square, level, tile)];
    return Pages(page_of(words.x), page_of(words.x >> 16u), page_of(words.y));
}

fn reference_fixed(square: u32) -> vec2u {
    if square == MERCATOR { return frame.mercator_fixed; }
    return select(frame.south_fixed, frame.north_fixed, square == NORTH);
}

// The finest level whose texels are no smaller than `footprint`, that has tiles, and whose page table reaches the place.
fn level_for(point: MapPoint, footprint: Metres, cos_lat: f32) -> u32 {
    let whole = select(POLAR_EXTENT * 4.0 * 6378137.0, EARTH_TURN * cos_lat, point.square == MERCATOR) / f32(TILE_TEXELS);
    let level = u32(clamp(ceil(log2(whole / max(footprint, 0.01))), 0.0, f32(deepest_level(point.square))));
    let away = point.at - reference_fixed(point.square);
    let distance = vec2u(min(away.x, 0u - away.x), min(away.y, 0u - away.y));
    let reach = max(distance.x, distance.y) | 1u;
    // tiles away = reach >> (32 - level) must stay below 31
    let widest = 4u + countLeadingZeros(reach);
    return min(level, widest);
}

// Metres of elevation, or signed distances to the ocean's and inland waters' shores in texels of the page's own level and, third, whether the
// nearest inland water is a river.
fn page_texel(water: bool, page: Page, at: vec2u) -> vec3f {
    // Distances are stored in 32nds of a texel, as `packed` in src/data/water.rs says; the lowest bit of blue is a river's mark.
    if water {
        let bytes = round(textureLoad(water_tiles, at, page.layer, 0) * 255.0);
        return vec3f(bytes.x * 256.0 + bytes.w - 32768.0, bytes.y * 64.0 + floor(bytes.z / 4.0) - 8192.0, 32.0 * (bytes.z - 2.0 * floor(bytes.z / 2.0))) / 32.0;
    }
    return textureLoad(terrain_tiles, at, page.layer, 0).xyz;
}

// A texel of a level's whole map. `page` serves for `tile`; in another tile another page does, perhaps a coarser one. Distances are in
// texels of the level.
fn texel(water: bool, square: u32, level: u32, index: vec2u, tile: vec2u, page: Page) -> vec3f {
    let own_tile = index >> vec2u(TILE_BITS);
    var own = page;
    if any(own_tile != tile) {
        own = page_of(pages[page_slot(square, level, own_tile)].x >> select(0u, 16u, water));
    }
    let at = (index >> vec2u(level - min(own.level, level))) & vec2u(TILE_TEXELS - 1u);
    let found = page_texel(water, own, at);
    return vec3f(found.xy * select(1.0, exp2(f32(level) - f32(own.level)), water), found.z);
}

// Four texels around a place, and where between them it is.
struct TexelsAround { a: vec3f, b: vec3f, c: vec3f, d: vec3f, f: vec2f }

// Across tile borders too, at the level of the page that serves for the point.
fn texels_around(water: bool, point: MapPoint, page: Page) -> TexelsAround {
    let level = page.level;
    let shift = 24u - level;
    let shifted = point.at - vec2u(1u << (shift - 1u));
    let f = vec2f(shifted & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    let tile = (point.at >> vec2u(shift)) >> vec2u(TILE_BITS);
    let mask = vec2u((TILE_TEXELS << level) - 1u);
    let a = (shifted >> vec2u(shift)) & mask;
    let b = (a + vec2u(1u)) & mask;
    return TexelsAround(texel(water, point.square, level, a, tile, page), texel(water, point.square, level, vec2u(b.x, a.y), tile, page),
        texel(water, point.square, level, vec2u(a.x, b.y), tile, page), texel(water, point.square, level, b, tile, page), f);
}

fn amid(c: TexelsAround) -> vec3f { return mix(mix(c.a, c.b, c.f.x), mix(c.c, c.d, c.f.x), c.f.y); }

fn bilinear(water: bool, point: MapPoint, page: Page) -> vec3f { return amid(texels_around(water, point, page)); }

// Weights of three neighbouring texels in a quadratic B-spline, `t` from -1/2 to 1/2 off the middle one, and their derivatives.
fn spline(t: f32) -> vec3f { return vec3f(0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t)); }
fn spline_rise(t: f32) -> vec3f { return vec3f(t - 0.5, -2.0 * t, t + 0.5); }

// Where the nine texels of a page around a place are, its tile, and where in the middle one it is, from -1/2 to 1/2.
struct NineTexels { columns: vec3u, rows: vec3u, tile: vec2u, t: vec2f }

fn nine_texels(point: MapPoint, page: Page) -> NineTexels {
    let shift = 24u - page.level;
    let mask = vec2u((TILE_TEXELS << page.level) - 1u);
    let middle = point.at >> vec2u(shift);
    let first = (middle - 1u) & mask;
    let last = (middle + 1u) & mask;
    let t = vec2f(point.at & vec2u((1u << shift) - 1u)) / f32(1u << shift) - 0.5;
    return NineTexels(vec3u(first.x, middle.x, last.x), vec3u(first.y, middle.y, last.y), middle >> vec2u(TILE_BITS), t);
}

// Signed distances to the ocean's and inland waters' shores, texels, whether the nearest inland water is a river, and how the first grows
// right and down on the map. Quadratic B-splines: between the four nearest texels alone shores would be polygons, with corners where texels meet.
struct Shores { told: vec3f, rise: vec2f }

fn shores_around(point: MapPoint, page: Page) -> Shores {
    let nine = nine_texels(point, page);
    let wx = spline(nine.t.x);
    let wy = spline(nine.t.y);
    let rx = spline_rise(nine.t.x);
    let ry = spline_rise(nine.t.y);
    var found = Shores(vec3f(0.0), vec2f(0.0));
    var k = 0u;
    loop {
        let at = vec2u(k % 3u, k / 3u);
        let value = texel(true, point.square, page.level, vec2u(nine.columns[at.x], nine.rows[at.y]), nine.tile, page);
        found.told += wx[at.x] * wy[at.y] * value;
        found.rise += vec2f(rx[at.x] * wy[at.y], wx[at.x] * ry[at.y]) * value.x;
        k++;
        if k == 9u { break; }
    }
    return found;
}
