// A beach that waves run up: what swash.wgsl says of it, as light.
#import ground
#import lace
#import swash
#import waves

const WRACK = vec3f(0.3, 0.27, 0.25);   // and of what lies on it in heaps
const SWASH_FINER = 4;           // how many times smaller than at sea the lace of foam on a beach is
const WANDERS: Metres = 6.0;     // sideways, on the way up
const BEACH_KIND = 2.5;          // of the water that runs up beaches

// Whether anything of it may show in a pixel so wide towards the shore.
fn beach_shows(at: Place, width: Metres) -> bool {
    return (at.point.square == MERCATOR) & !at.ground.is_lake & (-at.ground.ocean_shore < SWASH_WIDEST) & (out_of_beach(at.ground.ocean_shore, width) < 1.0);
}

// A beach that waves of a height run up: `dry` is its radiance without them, `as_sand` how much of a beach there may be, `width` that of the pixel towards the shore.
fn on_beach(dry: vec3f, at: Place, direction: vec3f, up: vec3f, footprint: Metres, width: Metres, height: Metres, as_sand: f32, light: Daylight, clear: Daylight) -> vec3f {
    let inland = max(-at.ground.ocean_shore, 0.0);
    // It ends softly where it is no longer looked for.
    let sandy = as_sand * (1.0 - smoothstep(0.7, 1.0, inland / SWASH_WIDEST));
    let x = select(inland, -1.0, at.ground.is_lake | (sandy <= 0.0) | (at.point.square != MERCATOR));
    // Downhill, on Mercator's map.
    let rise = at.ground.shore_rise * vec2f(1.0, -1.0);
    let down = rise / max(length(rise), 1e-3);
    let place = pattern_place(at.point, at.part);
    // Water does not run up straight: where waves next to each other differ it must not show as a ruled line.
    let aside = WANDERS * saturate(x / WANDERS) * (shown(footprint, 8.0) * bed_noise(place, 8.0, 90u).z + 0.3 * shown(footprint, 2.0) * bed_noise(place, 2.0, 91u).z);
    let line = beside(at.point, at.sin_lat, down * max(x, 0.0) + aside * vec2f(-down.y, down.x));
    let swash = swash_at(line, place, x, height, foreshore(at.ground.face), footprint, width);
    let rest = surface_from_normal_delta(at.dn);
    // Foam goes with the water that carries it.
    let moved = rest + vec3f(down * swash.run, 0.0);
    let wrinkles = bed_noise(place + 0.7 * down * swash.run, 1.0, 71u).xy * shown(footprint, 1.0) + 0.5 * bed_noise(place + down * swash.run, 0.25, 72u).xy * shown(footprint, 0.25);
    let normal = normalize(up - vec3f(0.012 * wrinkles, 0.0));
    let foam = foam_of(swash.foam, usually_dense_from(swash.foam), 0.0, lace_at(foam_coordinates(moved), footprint, SWASH_FINER, false), FINE);
    let sheen = saturate(swash.shines);
    // Water that runs has ripples; what it leaves is a mirror.
    let rough = vec2f(mix(0.02, 0.0006, sheen * (1.0 - 0.9 * swash.covered)));
    let moist = dry * mix(1.0, MOIST_SAND, sandy * (1.0 - swash.dry));
    // The sea's water, as the film, makes what is below it as dark as wet sand is without.
    let out = out_of_beach(at.ground.ocean_shore, width);
    let sand = moist * mix(1.0, WET_SAND, sandy * swash.damp * (1.0 - out * out)) * mix(vec3f(1.0), WRACK, sandy * swash.wrack);
    let film = water_radiance(WaterPoint(direction * at.distance, -direction, up, normal, along_wind(up), rough, 0.0, BEACH_KIND,
        Bed(moist, 2.0 * swash.film, 1.0), foam, MEAN_FACETS, vec3f(0.0), NO_LAND), light, clear);
    return mix(sand, film, sandy * max(sheen, swash.foam) * (1.0 - out));
}
