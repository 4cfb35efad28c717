// Lakes and rivers. Who imports this declares MEASURED (src/pass/kind.rs).
#import shelter
#import shore_pixels
#import water

const LAKE_KIND = 2.5;             // of the water of lakes
const RIVER_KIND = 4.3;            // of rivers, which carry silt; ours
// What the wind raises over a few hundred metres: ripples, and a little of waves of 30 m.
const RIVER_SEA = LocalSea(vec4f(0.0, 0.0, 0.1, 1.0), 0.03);

// The waves of an inland water, given those of a lake there.
fn on_river(lake: LocalSea, ground: Ground) -> LocalSea {
    var sea = lake;
    if ground.by_river { sea = RIVER_SEA; }
    return sea;
}

// A deep lake, or a river.
fn inland_water(at: vec3f, ground: Ground, direction: vec3f, up: vec3f, normal: vec3f, rough: vec2f, foam: Foam) -> WaterPoint {
    let kind = select(LAKE_KIND, RIVER_KIND, ground.by_river);
    return WaterPoint(at, -direction, up, normal, along_wind(up), rough, 1.0, kind, Bed(vec3f(0.0), 0.0, 1.0), foam, MEAN_FACETS, vec3f(0.0));
}

// 1 ocean, 2 lake, 3 river, 0 land.
fn water_class(ground: Ground) -> f32 {
    return select(select(0.0, select(2.0, 3.0, ground.by_river), ground.is_lake), 1.0, ground.is_ocean);
}
