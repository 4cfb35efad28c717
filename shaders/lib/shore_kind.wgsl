// What a shore is made of: sand, rock, or a bank of mud or stones, as the ground, the sea and the shore's own shape about it tell. Of 197 coasts that were looked at, from
// Holland's to Halong's, these say it rightly of six in seven; what a vertex looks up is smooth over kilometres. Who imports this declares IMAGERY.
#import imagery
#import rugged

const KIND_LEVEL: u32 = 5u;       // of water and imagery, texels 4.9 km wide at the equator; shores as waves smooth them are straight there,
const KIND_WIDE_LEVEL: u32 = 4u;  // and on this level: hard coasts of cool seas are not
const KIND_LAND_LEVEL: u32 = 1u;       // of terrain, 78 km: mountains behind, and the sea before
// All between what begins and what is. `BROKEN`: how far a shore is no straight line, 1 less the rise of its distance by that, and how much more sea there is about it than land, texels.
const BROKEN = vec2f(0.4, 0.6);    // where the land is high: capes
const BROKEN_COOL = vec2f(0.36, 0.55);     // where ice or frost has worked: skerries
const BROKEN_WIDELY = vec2f(0.25, 0.42);   // in a wide view, by seas that deep
const OPEN_SHELF = vec2f(24.0, 32.0);
const HIGH_LAND = vec2f(8.0, 40.0);        // the land, or how much it differs about, metres
const COOL = vec4f(0.707, 0.766, 0.719, 0.755);    // sines of 45° and 50°, of 46° and 49°
const WARM = vec2f(0.407, 0.469);  // and of 24° and 28°: towards the equator coral makes sand about islands, and mangroves grow
const BOLD_LAND = vec2f(130.0, 260.0);     // height of the land at the shore, metres,
const BOLD_COAST = vec2f(120.0, 170.0);    // with half of the depth before it, to 100 m, where mountains
const MOUNTAINS = vec2f(60.0, 110.0);      // differ by so much
const OUT_OF_DEEP = vec2f(300.0, 600.0);   // depth of the sea about it, where it is an island's
const VOLCANO = vec4f(700.0, 1000.0, 0.044, 0.034);      // the same, near the equator, where imagery is a dark forest's: of red's albedo
const DESERT = vec4f(0.17, 0.24, 0.06, 0.1);       // of red's, and of its over blue's, where sand is blown over all
const SHELTERED = vec2f(0.36, 0.28);       // how far the sea is open, texels: 0.6 along straight shores, none in narrow straits

// `scoured`: of `scoured_coast`; `rock`, that among them; `bank`: where no waves come that would make a beach.
struct ShoreKind { scoured: f32, rock: f32, bank: f32 }

const SANDY_SHORE = ShoreKind(0.0, 0.0, 0.0);

// Of a place around which the grid has so much (`grid_at`), and no farther from the shore than `reach`. As in lib/waves.wgsl the loop ends at its foot: elsewhere it is gone through
// once.
fn shore_kind(point: MapPoint, sin_lat: f32, grid: vec3f, ocean_shore: Metres, reach: Metres) -> ShoreKind {
    let is_far = abs(ocean_shore) > reach || point.square != MERCATOR;
    let here = pages_at(point, KIND_LEVEL);
    let wide_page = pages_at(point, KIND_WIDE_LEVEL).water;
    let land_page = pages_at(point, KIND_LAND_LEVEL).terrain;
    let near = nine_texels(point, here.water);
    let wide = nine_texels(point, wide_page);
    let land = nine_texels(point, land_page);
    let colour = nine_texels(point, here.imagery);
    var near_sum = vec4f(0.0);     // mean, mean square, rise
    var wide_sum = vec3f(0.0);     // mean, rise
    var land_sum = vec4f(0.0);     // mean and mean square of the land's height, depth, share that is wet
    var value = vec3f(0.0);
    var k = 0u;
    loop {
        let i = vec2u(k % 3u, k / 3u);
        // As far as three texels: on a rock in the midst of an ocean it tells no more.
        let d = clamp(texel(true, point.square, here.water.level, vec2u(near.columns[i.x], near.rows[i.y]), near.tile, here.water).x, -3.0, 3.0);
        let dx = spline(near.t.x)[i.x];
        let dy = spline(near.t.y)[i.y];
        near_sum += d * vec4f(dx * dy, d * dx * dy, spline_rise(near.t.x)[i.x] * dy, dx * spline_rise(near.t.y)[i.y]);
        let e = clamp(texel(true, point.square, wide_page.level, vec2u(wide.columns[i.x], wide.rows[i.y]), wide.tile, wide_page).x, -3.0, 3.0);
        let ex = spline(wide.t.x)[i.x];
        let ey = spline(wide.t.y)[i.y];
        wide_sum += e * vec3f(ex * ey, spline_rise(wide.t.x)[i.x] * ey, ex * spline_rise(wide.t.y)[i.y]);
        let h = texel(false, point.square, land_page.level, vec2u(land.columns[i.x], land.rows[i.y]), land.tile, land_page).x;
        let high = max(h, 0.0);
        land_sum += spline(land.t.x)[i.x] * spline(land.t.y)[i.y] * vec4f(high, high * high, high - h, select(0.0, 1.0, h < 0.0));
        if IMAGERY {
            value += spline(colour.t.x)[i.x] * spline(colour.t.y)[i.y]
                * imagery_texel(point.square, here.imagery.level, vec2u(colour.columns[i.x], colour.rows[i.y]), colour.tile, here.imagery);
        }
        k++;
        if k == 9u || is_far { break; }
    }
    if is_far { return SANDY_SHORE; }
    let latitude = abs(sin_lat);
    // How much more sea than land there is, as from the shore itself.
    let more = near_sum.x - ocean_shore / texel_metres(point, f32(here.water.level), sin_lat);
    let straight = min(length(near_sum.zw), 1.0);
    let broken = 1.0 - straight + max(more, 0.0);
    let broken_widely = 1.0 - min(length(wide_sum.yz), 1.0) + max(wide_sum.x - ocean_shore / texel_metres(point, f32(wide_page.level), sin_lat), 0.0);
    let open = more + sqrt(max(near_sum.y - near_sum.x * near_sum.x, 0.0)) + 0.1 * straight;
    let differs = sqrt(max(land_sum.y - land_sum.x * land_sum.x, 0.0));
    let height = max(grid.x + grid.y, 0.0) / max(1.0 - grid.z, BED_LEAST_SHARE);
    let depth = grid.y / max(grid.z, BED_LEAST_SHARE);
    let about = land_sum.z - land_sum.x;
    let shelf = land_sum.z / max(land_sum.w, BED_LEAST_SHARE);

    let cape = smoothstep(HIGH_LAND.x, HIGH_LAND.y, max(differs, height)) * smoothstep(BROKEN.x, BROKEN.y, broken);
    let skerries = smoothstep(COOL.x, COOL.y, latitude) * smoothstep(BROKEN_COOL.x, BROKEN_COOL.y, broken);
    let hard = smoothstep(COOL.z, COOL.w, latitude) * smoothstep(BROKEN_WIDELY.x, BROKEN_WIDELY.y, broken_widely) * smoothstep(OPEN_SHELF.x, OPEN_SHELF.y, shelf);
    let bold = smoothstep(BOLD_COAST.x, BOLD_COAST.y, height + 0.5 * min(depth, 100.0)) * smoothstep(MOUNTAINS.x, MOUNTAINS.y, differs);
    let island = smoothstep(WARM.x, WARM.y, latitude) * smoothstep(OUT_OF_DEEP.x, OUT_OF_DEEP.y, about);
    var rock = max(max(max(cape, skerries), max(hard, bold)), max(island, smoothstep(BOLD_LAND.x, BOLD_LAND.y, height)));
    if IMAGERY {
        let albedo = albedo_of(value);
        rock = max(rock, smoothstep(VOLCANO.x, VOLCANO.y, about) * smoothstep(VOLCANO.z, VOLCANO.w, albedo.r));
        rock *= 1.0 - smoothstep(DESERT.x, DESERT.y, albedo.r) * smoothstep(DESERT.z, DESERT.w, albedo.r - albedo.b);
    }
    let scoured = scoured_coast(point, sin_lat);
    return ShoreKind(scoured, max(rock, scoured), smoothstep(SHELTERED.x, SHELTERED.y, open));
}
