// The earth from space, where no summit stands as high as a pixel is wide and no wave shows: ground and sea in one disc, whose pixels' own
// rays meet the ellipsoid. It shows what land.wgsl and ocean.wgsl would. `MEASURED` is of src/pass/kind.rs.
#import ground
#import held
#import lace
#import limb
#import output
#import sky
#import waves

const SHOWS_COVER = false;
const GROWTH = false;
const DETAIL = false;             // which is finer than a pixel of the earth from space
const TOWN = false;
const BED_ALONE = false;
const MIRRORS_CLOUDS = false;      // so far away only their mean shows
const WAVES = false;
const NOISE = false;

const RIM = 64u;               // triangles of the disc; as src/pass/globe.rs
// How far the limb may be off the nadir, beyond what a sphere's would be: the vertical leans by 0.0034 rad from the way to the middle.
const FLATTENING_REACH = 0.006;
const LIMB_PIXELS = 1.5;       // that pixels which the limb crosses reach beyond it

// A disc across the nadir that covers the ellipsoid and its limb.
@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    let to_middle = SEMI_MINOR + frame.eye_altitude;
    let tilt = asin(min(frame.semi_major / to_middle, 1.0)) + FLATTENING_REACH + LIMB_PIXELS * frame.pixel_angle;
    // Below the horizon in pictures of a few pixels, too.
    let reach = tan(min(tilt, 1.5)) / cos(PI / f32(RIM));
    let way = sine_cosine(f32(index / 3u + index % 3u) * TURN / f32(RIM));
    let out = select(reach, 0.0, index % 3u == 0u) * vec2f(way.cosine, way.sine);
    return frame.clip_from_local * vec4f(frame.eye_altitude * vec3f(out, -1.0), 1.0);
}

fn ray_through(device: vec2f) -> vec3f {
    return normalize(frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up);
}

@fragment
fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let device = position.xy * vec2f(2.0, -2.0) / frame.viewport + vec2f(-1.0, 1.0);
    let direction = ray_through(device);
    let ray = eye_ray(direction);
    let hit = surface_hit(ray);
    let misses = hit < 0.0;
    let limb = limb_of(ray, direction);
    // A measured layer says what lies under the middle of a pixel; a picture, what fills it.
    let is_sky = misses && (MEASURED || limb.share <= 0.0);
    if MEASURED && is_sky { return sky_output(); }
    // Beside the limb stands the sky of the next pixel outwards.
    let beyond = select(2.0 * limb.beyond * vec2f(1.0, -1.0) / frame.viewport, vec2f(0.0), misses);
    var sky = vec3f(0.0);
    if limb.share < 1.0 { sky = sky_light(ray_through(device + beyond)); }
    if is_sky { return vec4f(sky * frame.exposure, 1.0); }

    let distance = select(hit, limb.distance, misses);
    let rest = direction * distance;
    let dn = normal_delta(rest);
    let up = dn + vec3f(0.0, 0.0, 1.0);
    let sin_lat = frame.sin_lat + sin_lat_delta(dn);
    let point = map_point(dn);
    let across = distance * frame.pixel_angle;
    let ground = ground_from_afar(point, sin_lat, max(across, 1.0));
    let clear = daylight_at(dot(frame.light, up));
    var light = clear;
    if CLOUDS { light = clouded_daylight(clear, up, shadow_at_height(shadow_in(in_net(device, cloud_net_size())), ground.elevation)); }
    let ground_across = ground_footprint(across, direction, up);
    let width = width_to_shore(ground, sinking(point, direction, up, LEAST_SINKING), across);
    let lit = lit_ground(Place(distance, dn, point, vec2f(0.0), sin_lat, ground, SANDY_SHORE, 0.0), direction, up, up, ground_across, width, NO_RELIEF, light, 0.0);

    // Water that is seen, and how much of the pixel it fills.
    let ocean = ocean_share(ground, width);
    let depth = ocean_depth(ground, ground_across, ocean);
    let grazing = max(abs(dot(direction, up)), 0.002);
    // The waves of what the pixel shows, the ocean or a lake; in a coarse picture lakes have the ocean's, as nearer.
    var sea = local_water(point, select(OF_LAKE, OF_OCEAN, ocean > 0.0));
    if !FINE && ocean <= 0.0 { sea = OPEN_SEA; }
    let lake = on_river(sea, ground);
    let lake_height = min(lake.height, 1.0);
    let lake_share = lake_height * share_from_afar(0.0, 1.0, ground_across);
    let lake_foam = mean_foam(lake_share, mean_dense_from(lake_share, FINE), lake_height, FINE);
    var water = inland_water(rest, ground, direction, up, up, local_slopes(lake), lake_foam);
    var water_share = inland_share(ground, ground_across);
    if ocean > 0.0 {
        let whitened = held_share(depth, sea.height) * sea.height;
        let share = whitened * share_from_afar(0.0, 1.0, across / pow(grazing, 0.65));
        let foam = mean_foam(share, mean_dense_from(share, FINE), whitened, FINE);
        let footprint = across / sqrt(grazing);
        // No gust is as wide as its pixels.
        let rough = slopes_in(sea, rest, distance, footprint, 1.0).rough;
        water = WaterPoint(rest, -direction, up, up, along_wind(up), rough, water_alpha(depth),
            water_kind(point, sin_lat, depth), Bed(lit.radiance, 2.0 * depth, 1.0), foam, MEAN_FACETS, vec3f(0.0), NO_LAND);
        water_share = ocean;
    }
    let radiance = mix(lit.radiance, water_radiance(water, light, clear), water_share);
    // Land fills the pixels whose middles it meets, as its tiles do.
    let share = select(select(1.0, 0.0, misses), limb.share, ground.is_ocean);
    let before = select(distance - above_ellipsoid(ground.elevation, direction, up), distance, ground.is_ocean);
    let seen = mix(sky, through_air(radiance, light, up, direction, before), share);
    if !MEASURED { return vec4f(seen * frame.exposure, 1.0); }
    if ground.is_ocean { return measured_output(Measured(rest, distance, depth, water.alpha, 0.0, up, 1.0, mix_weights(distance).y, vec3f(0.0)), seen); }
    return measured_output(Measured(rest, distance, 0.0, 0.0, ground.elevation, lit.normal, water_class(ground), 0.0, lit.albedo), seen);
}
