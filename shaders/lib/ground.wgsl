// Dry land, lakes and the sea bed. Who imports this declares IMAGERY and FINE (src/pass/kind.rs), and SHOWS_COVER: whether pixels may be so narrow
// that they show what covers the bed.
#import ground_colour
#import bed_cover
#import imagery
#import plants
#import rugged
#import shore_pixels
#import water

const BEACH: Metres = 50.0;     // how wide beaches are
const SAND = vec3f(0.36, 0.31, 0.22);
const ROCK = vec3f(0.13, 0.115, 0.10);

const STANDING = 0.3;            // slope of a crown whose cap rises by its whole height a cell
const HOLLOW = 0.6;              // of the sky's light, that the deepest valleys lack; ours

// How wide a pixel is on ground that is seen aslant.
fn ground_footprint(across: Metres, direction: vec3f, up: vec3f) -> Metres {
    return across / sqrt(max(abs(dot(direction, up)), 0.05));
}

fn east_at(up: vec3f) -> vec3f {
    return normalize(cross(vec3f(0.0, frame.cos_lat, frame.sin_lat), up) + vec3f(1e-9, 0.0, 0.0));
}

// `sandy`: how much of a beach there may be, between cliffs and snow.
struct LitGround { normal: vec3f, albedo: vec3f, radiance: vec3f, sandy: f32 }

// `washed`: how far waves run up the shore; nothing grows there.
fn lit_ground(point: MapPoint, sin_lat: f32, up: vec3f, ground: Ground, made: Made, footprint: Metres, light: Daylight, washed: Metres) -> LitGround {
    let east = east_at(up);
    let north = cross(up, east);
    let terrain = terrain_slope(point, sin_lat, footprint);
    let slope = slope_shown(ground) * terrain + made.slope;
    let normal = normalize(up - slope.x * east - slope.y * north);
    // Where the shore crosses a pixel its land is what shows of its ground.
    let is_bed = ocean_share(ground, footprint) >= 1.0;
    var albedo: vec3f;
    var shaded = normal;
    var sand = SAND;
    var beach = BEACH;
    var uneven = 1.0;
    var sandy = smoothstep(0.15, 0.09, length(terrain));
    if IMAGERY {
        albedo = imagery_albedo(point, sin_lat, footprint);
        let snowy = smoothstep(0.3, 0.6, albedo.b);
        sandy *= 1.0 - snowy;
        sand = mix(mix(SAND, ROCK, smoothstep(0.04, 0.12, length(terrain))), albedo, snowy);
        if FINE {
            let detail = ground_detail(point.at, footprint);
            let green = greenness(albedo);
            let standing = plants(point.at, green, detail.tone, footprint);
            albedo = detailed_albedo(albedo, green, detail, standing.height);
            // Hills are as rough as the ground about them is steep, and none stand where the relief has its own.
            let rough = select(0.22 * min(0.2 + 7.0 * length(terrain), 1.3), 0.0, is_bed) * (1.0 - made.whole);
            let hills = rough * east_north_of(point, detail.rise * vec2f(1.0, -1.0));
            let crowns = select(STANDING * green, 0.0, is_bed) * east_north_of(point, standing.rise * vec2f(1.0, -1.0));
            shaded = normalize(normal - (hills.x + crowns.x) * east - (hills.y + crowns.y) * north);
            // Rock stands out where it is steep, more of it on this slope than on that.
            let steep = smoothstep(0.2, 0.7, length(slope) + length(hills) + 0.1 * detail.tone);
            albedo = mix(albedo, ROCK, 0.7 * steep);
            // Beaches come and go along a shore.
            uneven = 1.0 + 0.5 * detail.tone;
            beach = max(beach * smoothstep(-0.3, 0.5, detail.coarse + 0.3 * detail.tone), 1.0);
        }
    } else {
        albedo = natural_colour(ground.elevation + made.height, length(slope), sin_lat, patchiness(point.at, footprint));
    }
    if is_bed {
        albedo = bed_colour(-ground.elevation);
        if FINE && SHOWS_COVER { albedo = covered_bed(point, albedo, -ground.elevation, footprint); }
    }
    let bare = select(sandy * smoothstep(-1.9 * washed - 0.1, -1.6 * washed, uneven * ground.ocean_shore), 0.0, is_bed | (washed <= 0.0));
    let strewn = smoothstep(-1.2 * beach, -0.2 * beach, ground.ocean_shore) * smoothstep(8.0, 1.0, ground.elevation)
        * select(saturate(beach / footprint), 0.0, is_bed);
    albedo = mix(albedo, sand, max(strewn, bare));
    shaded = normalize(mix(shaded, normal, bare));
    let sun = light.sun * max(dot(frame.light, shaded), 0.0) * smoothstep(-0.02, 0.03, dot(frame.light, up));
    // Valleys see less of the sky.
    let ambient = light.sky * (0.6 + 0.4 * dot(shaded, up)) * (1.0 + HOLLOW * min(made.hollow, 0.0));
    return LitGround(normal, albedo, albedo / PI * (sun + ambient), sandy);
}

const LAKE_KIND = 2.5;             // of the water of lakes

// A deep lake.
fn lake_water(at: vec3f, direction: vec3f, up: vec3f, normal: vec3f, rough: vec2f, foam: Foam) -> WaterPoint {
    return WaterPoint(at, -direction, up, normal, along_wind(up), rough, 1.0, LAKE_KIND, Bed(vec3f(0.0), 0.0), foam, MEAN_FACETS, vec3f(0.0));
}

// How much of a pixel of a lake is water.
fn lake_share(ground: Ground, footprint: Metres) -> f32 { return smoothstep(0.0, 60.0 + footprint, ground.lake_shore); }

// 1 ocean, 2 lake, 0 land.
fn water_class(ground: Ground) -> f32 { return select(select(0.0, 2.0, ground.is_lake), 1.0, ground.is_ocean); }
