// Dry land, lakes and the sea bed: one grid per map tile, placed exactly relative to the eye. `MEASURED`, `UNDER_WATER` and
// `FINE` are of src/pass/kind.rs; `RUGGED`, whether the ground has relief that the data do not hold, `INLAND`, whether there may be lakes or rivers,
// `LAKES`, whether lakes may be so near that their waves show, `SWASH`, whether waves may run up it, `BESIDE`, whether that is drawn by itself, `GROWTH`, whether what grows may show,
// `TOWN`, whether houses may, `REEFS`, whether there may be any, and `BED_ALONE`, as in lib/ground.wgsl, of src/pass/land.rs.
// Long, but one thing: a place of the mesh, and the ground that a pixel of it shows, from what it is to its light through water and air.
#import ground
#import lace
#import waves
#import spray
#import surf
#import beach
#import scene
#import output

// `beaches`: a bit for each block that is drawn with its beach.
struct Tile { @location(0) square_level: vec2u, @location(1) tile: vec2u, @location(2) grid: vec2f, @location(3) beaches: u32 }

struct Vertex {
    @invariant @builtin(position) position: vec4f,     // pipelines draw blocks of one tile beside each other
    @location(0) local: vec3f,
    @location(1) in_tile: vec2f,                       // 0…1 within the tile
    @location(2) @interpolate(flat) tile: vec4u,       // square, level, x, y
    @location(3) country: vec4f,                       // `Country`, as it stands
    @location(4) ways: vec4f,
    @location(7) grid: vec4f,                          // `grid_at`
    @location(6) shadow: vec3f,                        // of clouds, `shadow_of_vertex`
    @location(5) shore: vec2f,                         // height of the waves that come in to it, and how far they run up
    @location(8) kind: vec4f,                          // `ShoreKind`, as it stands; and how steep drowned hills are
    @location(9) @interpolate(flat) beaches: u32,
}

const MIRRORS_CLOUDS = FINE;
const WAVES = LAKES;
const NOISE = false;
const SHOWS_COVER = true;
const DETAIL = true;
const GRID: f32 = 16.0;
const BLOCKS: f32 = 4.0;
const BLOCK_EDGE: f32 = 1e-4;    // of a tile, from an edge between two, to where a pixel is surely of one of them
const KIND_REACH: Metres = 500.0;
const SHORE_CELLS: f32 = 2.0;    // from a shore on which the relief of the mesh is whole
const OWN_SHADOWS = FINE || RUGGED;     // of pixels: the cells of hills change while one comes near
const SKIRT: f32 = 2.0;          // rows whose grid coordinate lies outside 0…GRID hang down

// What a place's fixed-point coordinate leaves out, of a unit.
fn unit_part(tile: vec4u, in_tile: vec2f) -> vec2f { return fract(in_tile * f32(1u << (32u - max(tile.y, 1u)))); }

// Fixed-point coordinate of a place in a tile; the last row of the square must not wrap round to its first.
fn tile_point(tile: vec4u, in_tile: vec2f) -> MapPoint {
    let shift = 32u - max(tile.y, 1u);
    let side = select(f32(1u << shift), 4294967040.0, tile.y == 0u);
    let base = select(tile.zw << vec2u(shift), vec2u(0u), tile.y == 0u);
    let step = vec2u(min(in_tile * side, vec2f(4294967040.0)));
    let at = base + step;
    return MapPoint(tile.x, vec2u(at.x, select(at.y, 0xffffffffu, at.y < base.y)));
}

// Elevation of the ground in a lake with a level or beside it. Rivers share that where they run into it.
fn beside_lake(ground: Ground, point: MapPoint) -> Metres {
    let lake = lake_at(point);
    return with_lake(ground.elevation, ground.lake_shore, vec2f(lake.x, margin_for(lake.y, ground.by_river)));
}

@vertex
fn vertex(in: Tile) -> Vertex {
    let tile = vec4u(in.square_level, in.tile);
    let inside = clamp(in.grid, vec2f(0.0), vec2f(GRID)) / GRID;
    let point = tile_point(tile, inside);
    let dn = normal_delta_at(point);
    let up = dn + vec3f(0.0, 0.0, 1.0);
    // At a pole itself the ground is that of the eye's latitude.
    let raw_sin_lat = frame.sin_lat + sin_lat_delta(dn);
    let sin_lat = select(frame.sin_lat, raw_sin_lat, abs(raw_sin_lat) < 0.99999);
    let spacing = texel_metres(point, f32(tile.y), raw_sin_lat) * f32(TILE_TEXELS) / GRID;
    let rest = surface_from_normal_delta(dn);
    let grid = grid_at(point, sin_lat, spacing);
    var ground = ground_amid(point, sin_lat, spacing, grid);
    if !ground.is_ocean { ground.elevation = beside_lake(ground, point); }
    // Pixels between vertices farther than this from a shore have none within its beaches' width.
    let kind = shore_kind(point, sin_lat, grid.xyz, ground.ocean_shore, KIND_REACH + 1.5 * spacing);
    var c = NO_COUNTRY;
    var made = NO_RELIEF;
    // Tiles with relief have cells of at most so many pixels: what they hold of it depends on the distance, not on the tile.
    if RUGGED {
        let held = max(spacing, select(2.0, 1.0, FINE) * CELL_PIXELS * frame.pixel_angle * length(rest + up * ground.elevation));
        c = country_at(point, sin_lat);
        made = made_relief(c, point, dn, sin_lat, ground, max(held, RELIEF_MESH_FOOTPRINT));
        // Triangles across a shore would carry the relief's heights out over the sea.
        made.height *= smoothstep(0.0, SHORE_CELLS * held, -ground.ocean_shore);
    } else if tropical_share(sin_lat) > 0.0 {
        // The bed before towers' walls is of one kind with that of the tiles where these stand.
        c.drowned = drowned_at(point, sin_lat, bilinear(false, point, pages_at(point, RUGGED_ISLAND_LEVEL).terrain).x);
    }
    var height = ground.elevation + made.height;
    let skirt = select(0.0, 1.0, any(in.grid < vec2f(0.0)) || any(in.grid > vec2f(GRID)));
    height -= skirt * (SKIRT * spacing + 50.0);
    let local = rest + up * height;
    var shore = vec2f(0.0);
    if SWASH || BESIDE {
        let height = ground.waves * height_coming_in(local_sea(point), length(rest));
        shore = vec2f(height, run_up_reach(height, foreshore(ground.face)));
    }
    return Vertex(frame.clip_from_local * vec4f(local, 1.0), local, inside, tile,
        vec4f(c.raw, c.mean, c.island, c.inland), vec4f(c.way, c.out), grid, shadow_of_vertex(rest, OWN_SHADOWS), shore, vec4f(kind.scoured, kind.rock, kind.bank, c.drowned), in.beaches);
}

fn is_in_beaches(beaches: u32, in_tile: vec2f) -> bool {
    let block = vec2u(clamp(in_tile, vec2f(0.0), vec2f(0.9999)) * BLOCKS);
    return ((beaches >> (block.y * u32(BLOCKS) + block.x)) & 1u) != 0u;
}

// Whether all blocks that a pixel may be of are drawn with their beach.
fn has_beach(beaches: u32, in_tile: vec2f) -> bool {
    let e = vec2f(BLOCK_EDGE, -BLOCK_EDGE);
    return is_in_beaches(beaches, in_tile + e.xx) & is_in_beaches(beaches, in_tile + e.xy)
        & is_in_beaches(beaches, in_tile + e.yx) & is_in_beaches(beaches, in_tile + e.yy);
}

// Whether pixels are so wide that the ground's heights do not show, but the flatness of its triangles does.
fn chords_show(distance: Metres) -> bool { return distance * frame.pixel_angle > 200.0; }

// Whether the ground stands in front of the sea, which the pixel's ray meets at `far_hit`, if it does.
fn hides_sea(distance: Metres, far_hit: Metres) -> bool { return far_hit < 0.0 || distance < nearest_bed(far_hit); }


fn place(distance: Metres, dn: vec3f, point: MapPoint, part: vec2f, grid: vec4f, kind: vec3f) -> Place {
    let sin_lat = frame.sin_lat + sin_lat_delta(dn);
    var ground = ground_amid(point, sin_lat, max(distance * frame.pixel_angle, 1.0), grid);
    // A coarse picture sees lakes where their triangles are; of wide pixels, whose own ray tells the place, it takes the data's height for
    // the air before them.
    if (FINE || MEASURED) && !ground.is_ocean { ground.elevation = beside_lake(ground, point); }
    // Vertices farther out have not looked it up: it ends before, whatever their spacing is.
    let known = (1.0 - smoothstep(0.5 * KIND_REACH, KIND_REACH, ground.ocean_shore)) * kind;
    // The bed goes over to the sea's own, here sooner and there later, or rings would lie about islets.
    var bed = 0.0;
    if ground.is_ocean {
        let torn = 1.0 + 2.5 * map_noise(point.at, 16u, 85u) + map_noise(point.at, 18u, 86u);
        bed = 1.0 - smoothstep(0.0, KIND_REACH, torn * ground.ocean_shore);
    }
    return Place(distance, dn, point, part, sin_lat, ground, ShoreKind(known.x, known.y, known.z), bed);
}

// A lake or a river with the waves that the wind raises over its own fetch: near ones bend its normal. That of the lake around the eye is mostly
// hidden by its own mesh (lake.wgsl).
fn inland_surface(at: Place, direction: vec3f, up: vec3f, footprint: Metres) -> WaterPoint {
    var sea = OPEN_SEA;
    if FINE { sea = local_water(at.point, OF_LAKE); }
    sea = on_river(sea, at.ground);
    let height = min(sea.height, 1.0);
    let share = height * share_from_afar(0.0, 1.0, footprint);
    var normal = up;
    var along = vec2f(0.0);
    var rough = local_slopes(sea);
    var foam = mean_foam(share, mean_dense_from(share, FINE), height, FINE);
    if LAKES {
        let rest = surface_from_normal_delta(at.dn);
        // By the patches alone, however far the eye is.
        let seen = slopes_in(sea, rest, 0.0, footprint, 1.0);
        normal = normalize(up - vec3f(seen.slope, 0.0));
        rough = seen.rough;
        if at.ground.by_river {
            along = east_north_of(at.point, -across_course(at.point).yx);
            normal = normalize(up - vec3f(river_ripples(at.point, at.sin_lat, along, footprint), 0.0));
            rough = local_slopes(sea);
        }
        foam = foam_of(share, usually_dense_from(share), height, lace_at(foam_coordinates(rest), footprint, 1, false), FINE);
    }
    var ground = at.ground;
    // Wide rivers are lakes' polygons.
    if FINE { ground.by_river |= lake_at(at.point).y > OWN_RIVER; }
    var water = inland_water(direction * at.distance, ground, direction, up, normal, rough, foam);
    if LAKES && at.ground.by_river {
        let east = east_at(up);
        water.along = normalize(along.x * east + along.y * cross(up, east) + vec3f(1e-6, 0.0, 0.0));
    }
    return water;
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    let triangle_distance = length(in.local);
    let facet = cross(dpdx(in.local), dpdy(in.local));
    let direction = in.local / max(triangle_distance, 1e-3);
    let ray = eye_ray(direction);
    let far_hit = surface_hit(ray);
    // Of wide pixels their own ray tells the place, as it does for the sea, so that none falls between the two. A ray over a ridge meets the
    // ellipsoid much farther on; a coarse triangle may lie far below it.
    let by_ray = chords_show(triangle_distance) && far_hit >= 0.0 && nearest_bed(far_hit) < triangle_distance;
    let shows_sea = (frame.layers & SHOWS_SEA) != 0u;
    // The sea is seen where its surface is, not its bed: a strip of land there is one, though coarse triangles pass under it. So a bed is looked at
    // twice. As in lib/waves.wgsl, the loop ends at its foot.
    var at: Place;
    var is_own = true;
    var on_ellipsoid = by_ray;
    var is_second = false;
    loop {
        var distance = triangle_distance;
        var point = tile_point(in.tile, in.in_tile);
        var part = unit_part(in.tile, in.in_tile);
        var dn = normal_delta_at(point);
        if on_ellipsoid {
            distance = far_hit;
            dn = normal_delta(direction * far_hit);
            point = map_point(dn);
            part = vec2f(0.0);
        }
        let found = place(distance, dn, point, part, in.grid, in.kind.xyz);
        // Each place is drawn by one square alone.
        is_own &= on_ellipsoid || square_of(found.sin_lat) == in.tile.x;
        if !is_second || !found.ground.is_ocean { at = found; }
        // A triangle that passes a hand's width under the waterline is seen metres from it: water that runs up the beach ends where the sea's surface begins.
        at.ground.ocean_shore = min(at.ground.ocean_shore, found.ground.ocean_shore);
        // Where the shore is farther away than either place is from the other, none stands there; it is known to a texel.
        let apart = abs(found.distance - far_hit) + found.ground.texel;
        let is_bed = found.ground.is_ocean && found.ground.ocean_shore <= apart && shows_sea && !UNDER_WATER && !on_ellipsoid
            && !hides_sea(found.distance, far_hit);
        on_ellipsoid = true;
        is_second = true;
        if !is_bed { break; }
    }
    if !is_own {
        discard;
        return vec4f(0.0);
    }
    // Ground and lakes have less air before them the higher they lie: as where their triangles tell the distance.
    if by_ray && !at.ground.is_ocean { at.distance -= above_ellipsoid(at.ground.elevation, direction, at.dn + vec3f(0.0, 0.0, 1.0)); }
    let distance = at.distance;
    let ground = at.ground;
    let up = at.dn + vec3f(0.0, 0.0, 1.0);
    let footprint = ground_footprint(distance * frame.pixel_angle, direction, up);

    let sea_covers = ground.is_ocean && shows_sea && !hides_sea(distance, far_hit);
    let width = width_to_shore(ground, sinking(at.point, direction, up, LEAST_SINKING), distance * frame.pixel_angle);
    if ocean_share(ground, width) >= 1.0 && shows_sea && !UNDER_WATER && water_alpha(-ground.elevation) > OPAQUE_ALPHA {
        // Coarse triangles slope down from a hill to the bed in front of the sea: what stands there is water.
        if !sea_covers { discard; }
        // A bed that cannot be seen needs no light; should a pixel of the sea miss, it is blue.
        if !MEASURED {
            return vec4f(0.25 * frame.exposure * OPEN_REFLECTANCE, BEHIND_SEA);
        }
    }

    if BESIDE && beach_shows(at, width) && has_beach(in.beaches, in.in_tile) { discard; }

    let clear = daylight_at(dot(frame.light, up));
    var light = clear;
    if CLOUDS {
        let below = shadow_of_pixel(direction * distance - max(ground.elevation, 0.0) * up, in.shadow, OWN_SHADOWS);
        light = clouded_daylight(clear, up, shadow_at_height(below, ground.elevation));
    }
    var made = NO_RELIEF;
    made.towers = towers_share(in.kind.w, at.sin_lat);
    if RUGGED {
        let country = Country(in.country.x, in.country.y, in.country.z, in.country.w, in.ways.xy, in.ways.zw, in.kind.w);
        made = made_relief(country, at.point, at.dn, at.sin_lat, ground, select(2.0, 1.0, FINE) * footprint);
    }
    // Where its own ray tells a pixel's place, that is not the triangle's.
    let rises = dot(facet, up);
    let lies = select(facet * sign(rises) / max(length(facet), 1e-20), up, by_ray || rises == 0.0);
    let lit = lit_ground(at, direction, up, lies, footprint, width, made, light, in.shore.y);
    var radiance = lit.radiance;
    var inland = 0.0;
    if INLAND { inland = inland_share(ground, footprint); }
    if INLAND && inland > 0.0 { radiance = mix(radiance, water_radiance(inland_surface(at, direction, up, footprint), light, clear), inland); }
    if SWASH { radiance = on_beach(radiance, at, direction, up, footprint, width, in.shore.x, lit.sandy, light, clear); }
    if !sea_covers {
        radiance = through_air(radiance, light, up, direction, distance);
    }
    if !MEASURED { return vec4f(radiance * frame.exposure, select(select(1.0, INLAND_WATER, inland >= 0.5), BED, sea_covers)); }
    let rest = surface_from_normal_delta(at.dn);
    return measured_output(Measured(rest, distance, 0.0, 0.0, ground.elevation + made.height, lit.normal, water_class(ground), 0.0, lit.albedo), radiance);
}
