// How steep the ground is, by the terrain tile that is at hand.
#import world

// The terrain tiles' own elevation beside a point.
fn terrain_at(point: MapPoint, level: u32, step: vec2u) -> Metres {
    let beside = MapPoint(point.square, point.at + step);
    return bilinear(false, beside, pages_at(beside, level).terrain).x;
}

// A direction on the map, right and up, as east and north: the same on Mercator's square, on a polar one turned with the longitude.
fn east_north_of(point: MapPoint, way: vec2f) -> vec2f {
    if point.square == MERCATOR { return way; }
    let from_middle = vec2f(bitcast<vec2i>(point.at - vec2u(0x80000000u))) * vec2f(1.0, -1.0);
    let out = from_middle / max(length(from_middle), 1.0);
    return vec2f(dot(way, vec2f(-out.y, out.x)), dot(way, out) * select(1.0, -1.0, point.square == NORTH));
}

// Slope of the ground at a point, over one texel: metres per metre east and north. Flat on the beach, where the ground is shaped to the shore.
fn ground_slope(point: MapPoint, sin_lat: f32, ground: Ground, footprint: Metres) -> vec2f {
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    let resident = pages_at(point, level_for(point, footprint, cos_lat)).terrain.level;
    let right_step = vec2u(1u << (24u - resident), 0u);
    let down_step = right_step.yx;
    let metres = 2.0 * texel_metres(point, f32(resident), sin_lat);
    let right = (terrain_at(point, resident, right_step) - terrain_at(point, resident, vec2u(0u) - right_step)) / metres;
    let up = (terrain_at(point, resident, vec2u(0u) - down_step) - terrain_at(point, resident, down_step)) / metres;
    let shown = select(1.0, smoothstep(0.0, frame.terrain_resolution / 3.0, abs(ground.ocean_shore)), !ground.is_ocean);
    return shown * east_north_of(point, vec2f(right, up));
}
