// Dry land, lakes and the sea bed, shaded by height, slope and latitude: one grid per map tile, placed exactly relative to the eye; or,
// `FROM_SPACE` (known when it is compiled), where no summit stands as high as a pixel is wide, the ellipsoid itself, which the pixels' own
// rays meet.
#import world
#import water
#import output
#import noise

struct Tile { @location(0) square_level: vec2u, @location(1) tile: vec2u, @location(2) grid: vec2f }

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) local: vec3f,
    @location(1) in_tile: vec2f,                       // 0…1 within the tile
    @location(2) @interpolate(flat) tile: vec4u,       // square, level, x, y
}

const GRID: f32 = 16.0;
const OPAQUE_ALPHA: f32 = 0.996; // of water from which on nothing of the bed can be seen
const FARTHEST: f32 = 1e-12;     // depth; reversed, the sky's is 0
const SKIRT: f32 = 2.0;          // rows whose grid coordinate lies outside 0…GRID hang down

// Fixed-point coordinate of a place in a tile; the last row of the square must not wrap round to its first.
fn tile_point(tile: vec4u, in_tile: vec2f) -> MapPoint {
    let shift = 32u - max(tile.y, 1u);
    let side = select(f32(1u << shift), 4294967040.0, tile.y == 0u);
    let base = select(tile.zw << vec2u(shift), vec2u(0u), tile.y == 0u);
    let step = vec2u(min(in_tile * side, vec2f(4294967040.0)));
    let at = base + step;
    return MapPoint(tile.x, vec2u(at.x, select(at.y, 0xffffffffu, at.y < base.y)));
}

@vertex
fn vertex_of_tile(in: Tile) -> Vertex {
    let tile = vec4u(in.square_level, in.tile);
    let inside = clamp(in.grid, vec2f(0.0), vec2f(GRID)) / GRID;
    let point = tile_point(tile, inside);
    let dn = normal_delta_at(point);
    let up = dn + vec3f(0.0, 0.0, 1.0);
    let spacing = texel_metres(point, f32(tile.y), frame.sin_lat + sin_lat_delta(dn)) * f32(TILE_TEXELS) / GRID;
    var height = 0.0;
    if abs(frame.sin_lat + sin_lat_delta(dn)) < 0.99999 {
        height = ground_at(point, frame.sin_lat + sin_lat_delta(dn), spacing).elevation;
    } else {
        height = ground_at(point, frame.sin_lat, spacing).elevation;
    }
    let skirt = select(0.0, 1.0, any(in.grid < vec2f(0.0)) || any(in.grid > vec2f(GRID)));
    height -= skirt * (SKIRT * spacing + 50.0);
    let local = surface_from_normal_delta(dn) + up * height;
    return Vertex(frame.clip_from_local * vec4f(local, 1.0), local, inside, tile);
}

// One triangle over the picture; its depth is behind everything but the sky.
@vertex
fn vertex_of_picture(@builtin(vertex_index) index: u32) -> Vertex {
    let device = vec2f(f32((index << 1u) & 2u), f32(index & 2u)) * 2.0 - 1.0;
    let local = frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up;
    return Vertex(vec4f(device, FARTHEST, 1.0), local, vec2f(0.0), vec4u(0u));
}

// Whether pixels are so wide that the ground's heights do not show, but the flatness of its triangles does.
fn chords_show(distance: Metres) -> bool { return distance * frame.pixel_angle > 200.0; }

// Whether the sea pass takes this ground for land in front of the sea, which the pixel's ray meets at `far_hit` (0.4 % of the distance and
// 2 m, as there). Ground of the sea that does so is a coarse triangle between a hill and the bed.
fn hides_sea(distance: Metres, far_hit: Metres) -> bool { return far_hit < 0.0 || distance < 0.996 * far_hit - 2.0; }

// Patchiness, about 0…1: octaves from 300 km down to what pixels hold. As in lib/waves.wgsl, the loop ends at its foot.
fn patchiness(at: vec2u, footprint: Metres) -> f32 {
    var sum = 0.5;
    var amplitude = 0.36;
    var level = 7u;
    loop {
        let shown = 1.0 - smoothstep(0.25, 0.7, footprint * exp2(f32(level)) / EARTH_TURN);
        sum += amplitude * shown * (map_noise(at, level, level) - 0.5);
        amplitude *= 0.72;
        level += 2u;
        if level > 21u || footprint * exp2(f32(level)) >= 0.7 * EARTH_TURN { break; }
    }
    return sum;
}

fn natural_colour(elevation: Metres, slope: f32, sin_lat: f32, patchy: f32) -> vec3f {
    let latitude = degrees(asin(clamp(abs(sin_lat), 0.0, 1.0))) + (patchy - 0.5) * 9.0;
    let forest = vec3f(0.034, 0.060, 0.020);
    let grass = vec3f(0.105, 0.115, 0.045);
    let desert = mix(vec3f(0.30, 0.20, 0.105), vec3f(0.44, 0.31, 0.17), patchy);
    let tundra = vec3f(0.105, 0.095, 0.065);
    let rock = vec3f(0.13, 0.115, 0.10);
    let snow = vec3f(0.80, 0.83, 0.87);
    let dry = smoothstep(11.0, 19.0, latitude) * (1.0 - smoothstep(29.0, 37.0, latitude)) * smoothstep(0.2, 0.55, patchy + 0.15);
    var colour = mix(mix(forest, grass, patchy), desert, dry);
    colour = mix(colour, tundra, smoothstep(58.0, 68.0, latitude + elevation / 150.0));
    colour = mix(colour, rock, max(smoothstep(0.25, 0.7, slope), 0.8 * smoothstep(1500.0, 3500.0, elevation)));
    let snow_line = mix(5300.0, 0.0, smoothstep(20.0, 74.0, latitude));
    let snowy = smoothstep(snow_line - 250.0, snow_line + 350.0, elevation + (patchy - 0.5) * 500.0);
    return mix(colour, snow, snowy * (1.0 - 0.6 * smoothstep(0.6, 1.2, slope)));
}

fn bed_colour(depth: Metres) -> vec3f {
    return mix(vec3f(0.40, 0.35, 0.26), vec3f(0.13, 0.14, 0.12), smoothstep(2.0, 40.0, depth));
}

// The terrain tiles' own elevation beside a point.
fn terrain_at(point: MapPoint, level: u32, step: vec2u) -> Metres {
    let beside = MapPoint(point.square, point.at + step);
    return bilinear(false, beside, pages_at(beside, level).terrain).x;
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    var point = tile_point(in.tile, in.in_tile);
    var dn = normal_delta_at(point);
    var distance = length(in.local);
    let to_eye = -in.local / max(distance, 1e-3);
    let far_hit = surface_hit(eye_ray(-to_eye));
    if FROM_SPACE && far_hit < 0.0 {
        discard;
        return vec4f(0.0);
    }
    // 0.4 %: what the sea pass takes for the same place. A ray over a ridge meets the ellipsoid much farther on; a coarse triangle
    // may lie far below it.
    if FROM_SPACE || (chords_show(distance) && far_hit >= 0.0 && far_hit < 1.004 * distance) {
        // The pixel's own ray tells the place, as it does for the sea, so that no pixel falls between the two.
        distance = far_hit;
        dn = normal_delta(-to_eye * distance);
        point = map_point(dn);
    } else if square_of(frame.sin_lat + sin_lat_delta(dn)) != in.tile.x {
        // Each place is drawn by one square alone.
        discard;
        return vec4f(0.0);
    }
    var sin_lat = frame.sin_lat + sin_lat_delta(dn);
    var ground = ground_at(point, sin_lat, max(distance * frame.pixel_angle, 1.0));
    if ground.is_ocean && frame.under_water == 0u && far_hit != distance && !hides_sea(distance, far_hit) {
        // The sea is seen where its surface is, not its bed: a strip of land there is one, though coarse triangles pass under it.
        let surface_dn = normal_delta(-to_eye * far_hit);
        let surface_sin_lat = frame.sin_lat + sin_lat_delta(surface_dn);
        let surface = ground_at(map_point(surface_dn), surface_sin_lat, max(far_hit * frame.pixel_angle, 1.0));
        if !surface.is_ocean {
            distance = far_hit;
            dn = surface_dn;
            point = map_point(dn);
            sin_lat = surface_sin_lat;
            ground = surface;
        }
    }
    let up = dn + vec3f(0.0, 0.0, 1.0);
    let across = distance * frame.pixel_angle;
    let footprint = across / sqrt(max(abs(dot(to_eye, up)), 0.05));

    let shows_sea = ground.is_ocean && (frame.layers & SHOWS_SEA) != 0u;
    let sea_covers = shows_sea && !hides_sea(distance, far_hit);
    if shows_sea && frame.under_water == 0u && water_alpha(-ground.elevation) > OPAQUE_ALPHA {
        if !sea_covers { discard; }
        // A bed that cannot be seen needs no light; should a pixel of the sea miss, it is blue.
        if frame.output == PICTURE {
            // On the limb the sea's own rays decide, and the sky is what they may miss.
            if FROM_SPACE && !is_inside_limb(eye_ray(-to_eye)) { discard; }
            return vec4f(0.25 * frame.exposure * DEEP_REFLECTANCE, 1.0);
        }
    }

    // Slopes over one texel of the terrain tile that is at hand, in metres per metre east and north.
    let cos_lat = sqrt(max(1.0 - sin_lat * sin_lat, 0.0));
    let level = level_for(point, footprint, cos_lat);
    let resident = pages_at(point, level).terrain.level;
    let east_step = vec2u(1u << (24u - resident), 0u);
    let south_step = east_step.yx;
    let metres = 2.0 * texel_metres(point, f32(resident), sin_lat);
    let dx = (terrain_at(point, resident, east_step) - terrain_at(point, resident, vec2u(0u) - east_step)) / metres;
    let dy = (terrain_at(point, resident, vec2u(0u) - south_step) - terrain_at(point, resident, south_step)) / metres;
    let slope = vec2f(dx, dy) * select(1.0, smoothstep(0.0, frame.terrain_resolution / 3.0, abs(ground.ocean_shore)), !ground.is_ocean);
    let east = normalize(cross(vec3f(0.0, frame.cos_lat, frame.sin_lat), up) + vec3f(1e-9, 0.0, 0.0));
    let north = cross(up, east);
    // Relief is drawn 1.5 times as steep, as on shaded maps: 5' data are smoother than the land.
    let normal = normalize(up - 1.5 * (slope.x * east + slope.y * north));

    let mu_sun = dot(frame.sun, up);
    let daylight = daylight_at(mu_sun);
    let sun = daylight.sun * max(dot(frame.sun, normal), 0.0) * smoothstep(-0.02, 0.03, mu_sun);
    let ambient = daylight.sky * (0.6 + 0.4 * dot(normal, up));
    var albedo = natural_colour(ground.elevation, length(slope), sin_lat, patchiness(point.at, footprint));
    if ground.is_ocean { albedo = bed_colour(-ground.elevation); }
    albedo = mix(albedo, vec3f(0.36, 0.31, 0.22), smoothstep(-60.0, -10.0, ground.ocean_shore) * smoothstep(8.0, 1.0, ground.elevation)
        * select(1.0, 0.0, ground.is_ocean));
    var radiance = albedo / PI * (sun + ambient);
    if ground.is_lake {
        let shore = smoothstep(0.0, 60.0 + footprint, ground.lake_shore);
        let lake = water_radiance(WaterPoint(to_eye, up, up, east, vec2f(0.002), 1.0, 20.0, vec3f(0.0), 0.0), daylight);
        radiance = mix(radiance, lake, shore);
    }
    if frame.under_water == 1u {
        // Less of the sun reaches the deep bed.
        let lit = radiance * exp(0.5 * BED_ABSORPTION * min(ground.elevation, 0.0));
        radiance = through_water(lit, distance);
    } else if !sea_covers {
        let air = haze(-to_eye, distance);
        radiance = radiance * air.transmittance + air.radiance;
    }
    let water_class = select(select(0.0, 2.0, ground.is_lake), 1.0, ground.is_ocean);
    let rest = surface_from_normal_delta(dn);
    return measured_output(Measured(rest, distance, 0.0, 0.0, ground.elevation, normal, water_class, 0.0), radiance);
}
