// The colour of the land by the imagery tile that is at hand, and what is finer than it.
#import fields
#import ground_slope
#import noise

@group(2) @binding(0) var imagery_tiles: texture_2d_array<f32>;     // sRGB, read as linear

// From a picture's linear values to albedo. Blue Marble's land is stretched so that dense forest is all but black and fresh snow white; this
// curve brings surfaces to what satellites measure (MODIS, visible bands): rain forest of the Congo to 0.023, 0.041, 0.014 (of red, green, blue;
// the picture's values are 0.004, 0.010, 0.002), fields of Germany to 0.056, 0.089, 0.028 (0.027, 0.048, 0.010), the Sahara to 0.51, 0.38, 0.22
// (0.59, 0.39, 0.20), snow to 0.78 (1).
const IMAGERY_SCALE: f32 = 0.76;
const IMAGERY_POWER: f32 = 0.8;
const IMAGERY_DARK = vec3f(0.014, 0.022, 0.009);

// A texel of a level's whole map; see `texel` of lib/map_texels.wgsl.
fn imagery_texel(square: u32, level: u32, index: vec2u, tile: vec2u, page: Page) -> vec3f {
    let own_tile = index >> vec2u(TILE_BITS);
    var own = page;
    if any(own_tile != tile) { own = page_of(pages[page_slot(square, level, own_tile)].y); }
    let at = (index >> vec2u(level - min(own.level, level))) & vec2u(TILE_TEXELS - 1u);
    return textureLoad(imagery_tiles, at, own.layer, 0).rgb;
}

// Three texels of a row, weighted.
fn imagery_row(square: u32, level: u32, columns: vec3u, row: u32, tile: vec2u, page: Page, weights: vec3f) -> vec3f {
    return weights.x * imagery_texel(square, level, vec2u(columns.x, row), tile, page)
        + weights.y * imagery_texel(square, level, vec2u(columns.y, row), tile, page)
        + weights.z * imagery_texel(square, level, vec2u(columns.z, row), tile, page);
}

fn albedo_of(value: vec3f) -> vec3f { return IMAGERY_SCALE * pow(value, vec3f(IMAGERY_POWER)) + IMAGERY_DARK; }

// Albedo as the tiles have it: a quadratic B-spline over nine texels, which shows no squares where texels are many pixels wide.
fn imagery_albedo(point: MapPoint, sin_lat: f32, footprint: Metres) -> vec3f {
    let page = pages_at(point, level_for(point, footprint, sqrt(max(1.0 - sin_lat * sin_lat, 0.0)))).imagery;
    let nine = nine_texels(point, page);
    let along = spline(nine.t.x);
    let down = spline(nine.t.y);
    let value = down.x * imagery_row(point.square, page.level, nine.columns, nine.rows.x, nine.tile, page, along)
        + down.y * imagery_row(point.square, page.level, nine.columns, nine.rows.y, nine.tile, page, along)
        + down.z * imagery_row(point.square, page.level, nine.columns, nine.rows.z, nine.tile, page, along);
    return albedo_of(value);
}

// What is finer than any imagery here, from 5 km down to 0.3 m or what pixels hold: tones whose mean is none, of all and of what is wider than 10 m,
// the rise of small hills right and down on the map, as slopes of about one, how far the octaves of 305 and 76 m have bent the place, in units of the map, what
// chooses where farms lie, which knows nothing of the tones, and the fields. `stands`: as of canopy.wgsl: dark ground has woods; `tops`: how woods' tops rise and fall.
struct Detail { tone: f32, coarse: f32, rise: vec2f, bent: vec2f, clumps: vec4f, hue: f32, tillage: f32, stands: vec3f, tops: vec2f, fields: Fields }

// Where pixels are so wide that none of it shows.
const NO_DETAIL = Detail(0.0, 0.0, vec2f(0.0), vec2f(0.0), vec4f(0.0), 0.0, USUAL_TILLAGE, vec3f(0.0, STANDS_DEVIATION, 0.0), vec2f(0.0), Fields(0.0, 0.0, 0.0));
const NOISE_VARIANCE = 0.0298;      // of the values of `map_noise_rise`
const STANDS_DEVIATION = 0.2487;    // of all octaves of the noise that tells where woods stand
const WIDE_TONES: f32 = 0.54;      // of what is wider than 100 m: so much as its valleys' depths differ
const WIDEST_TONES: f32 = 0.2;     // of the widest, which from space are as wide as what imagery shows, and would lie over it like a fabric
const HEDGE_TREES = 2.0;           // how much less of a hedge there is where clumps are one, and more where they are minus one; ours
const WARP: f32 = 0.08;            // how far an octave moves the next one, of its own cells a rise

// Patches of what grows and lies there; as far as 100 m valleys, too, creased where the noise is none, between round hills. Their tones are not creased: on
// plains, whose hills do not show, they would be a tangle of worms. Each octave bends
// the next, so that none shows its lattice; it alone, for together they would draw the smallest out into hair.
// As in lib/waves.wgsl, the loop ends at its foot.
fn ground_detail(at: vec2u, footprint: Metres) -> Detail {
    var detail = NO_DETAIL;
    detail.tillage = 0.0;      // its mean stands for what does not show
    var bend = vec2f(0.0);
    var level = 13u;
    var place = at;
    loop {
        let shown = 1.0 - smoothstep(0.25, 0.7, footprint * exp2(f32(level)) / EARTH_TURN);
        let noise = map_noise_rise(place, level, level);
        let is_hill = level < 20u;
        let height = shown * select(select(1.0, WIDE_TONES, is_hill), WIDEST_TONES, level == 13u) * noise.x;
        detail.tone += height;
        detail.coarse += select(0.0, height, level < 20u);
        detail.clumps = select(detail.clumps, vec4f(height), vec4u(level) == vec4u(19u, 21u, 23u, 25u));
        let stands = max(1.0 - 0.17 * abs(f32(level) - 17.0), 0.0);
        detail.stands += vec3f(-shown * stands * noise.x, 0.0, shown * shown * stands * stands);
        detail.tops += select(vec2f(0.0), shown * noise.yz, level == 21u);
        detail.hue += select(0.0, shown * noise.y, level == 19u || level == 23u);
        detail.rise += shown * noise.yz * select(0.5, sign(noise.x), is_hill);
        // Unseen octaves bend as well as seen ones, so that nothing moves with the eye.
        let bends = WARP * noise.yz * f32(1u << (32u - level));
        place = at + bitcast<vec2u>(vec2i(bends));
        bend = select(bend, noise.yz, level == 13u);
        detail.tillage += select(0.0, 0.5 * noise.y, level <= 15u);
        detail.bent += select(vec2f(0.0), bends, level == 17u || level == 19u);
        level += 2u;
        if level > 27u || footprint * exp2(f32(level)) >= 0.7 * EARTH_TURN { break; }
    }
    detail.stands = vec3f(detail.stands.x, STANDS_DEVIATION, detail.stands.z * NOISE_VARIANCE);
    detail.fields = fields_at(at, bend, footprint);
    // Hedges have gaps and trees in them.
    detail.fields.hedge *= max(1.0 - HEDGE_TREES * dot(detail.clumps, vec4f(0.5, 1.0, 0.0, 0.0)), 0.0);
    return detail;
}

// How far the ground is green.
fn greenness(albedo: vec3f) -> f32 { return saturate(3.0 * (albedo.g - 0.5 * (albedo.r + albedo.b)) / albedo.g); }

// Of domes' tones, of what they change of the albedo where it is bare, and where it is green.
const SHRUB = vec3f(0.75, 0.6, 0.55);
const CANOPY = vec3f(0.95, 0.78, 0.85);

// How much of red, green and blue straw has more than what is green, where the hue is one.
const STRAW = vec3f(0.10, 0.03, -0.02);

// Albedo with detail, of the same mean: soil among plants, bare ground among snow, fields, and what stands on it.
fn detailed_albedo(albedo: vec3f, green: f32, farm: f32, detail: Detail, woods: f32, standing: f32, flat: f32) -> vec3f {
    let whiteness = smoothstep(0.15, 0.75, min(albedo.r, min(albedo.g, albedo.b)));
    let tones = mix(vec3f(0.40, 0.43, 0.47), vec3f(1.15, 0.95, 1.0), green) * (1.0 - 0.85 * whiteness);
    // Groves and clearings differ more than the ground in them does. Odd in the tone, so that the mean stays none.
    let of_all = flat * detail.tone + (1.35 - flat) * detail.coarse;
    let tone = (1.0 - 0.7 * farm) * of_all / sqrt(1.0 + 0.8 * of_all * of_all);
    let patches = 2.2 * whiteness * (1.0 - whiteness) * tone;
    let stands = standing * (1.0 - whiteness) * mix(SHRUB, CANOPY, green);
    let hue = 1.0 + green * clamp(detail.hue, -1.0, 1.0) * STRAW;
    let field = 1.0 + farm * field_tones(detail.fields);
    return max(albedo * hue * field * max((1.0 + tones * tone + woods) * (1.0 + stands), vec3f(0.15)) + patches, vec3f(0.01));
}
