// How steep the ground is, by the terrain tile that is at hand.
#import world

// The terrain tiles' own elevation beside a point.
fn terrain_at(point: MapPoint, level: u32, step: vec2u) -> Metres {
    let beside = MapPoint(point.square, point.at + step);
    return bilinear(false, texels_around(beside, pages_at(beside, level).terrain)).x;
}

// Slope of the ground at a point, over one texel: metres per metre east and north. Flat on the beach, where the ground is shaped to the shore.
fn ground_slope(point: MapPoint, sin_lat: f32, ground: Ground, footprint: Metres) -> vec2f {
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    let resident = pages_at(point, level_for(point, footprint, cos_lat)).terrain.level;
    let east_step = vec2u(1u << (24u - resident), 0u);
    let south_step = east_step.yx;
    let metres = 2.0 * texel_metres(point, f32(resident), sin_lat);
    let dx = (terrain_at(point, resident, east_step) - terrain_at(point, resident, vec2u(0u) - east_step)) / metres;
    let dy = (terrain_at(point, resident, vec2u(0u) - south_step) - terrain_at(point, resident, south_step)) / metres;
    return vec2f(dx, dy) * select(1.0, smoothstep(0.0, frame.terrain_resolution / 3.0, abs(ground.ocean_shore)), !ground.is_ocean);
}
