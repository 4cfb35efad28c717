// Everything that an eye in the sea sees but the surface: the bed, and water without end. Each pixel's own ray finds the bed: near the eye
// it is a plane, which two looks at the ground itself make exact. `FINE` and `CLOUDS` are of src/pass/kind.rs.
#import sea_bed

@group(2) @binding(0) var caustics: texture_2d<f32>;

struct Pixel {
    @builtin(position) position: vec4f,
    @location(0) device: vec2f,
    @location(1) @interpolate(flat) bed: vec3f,        // below the eye: its altitude, its slopes east and north
}

const MIRRORS_CLOUDS = FINE;
const PLANE: Metres = 20.0;        // over which the slopes are taken
const FARTHEST: Metres = 400.0;    // that any water lets an eye see

fn ground_below(way: vec2f) -> Ground {
    let dn = normal_delta(vec3f(way, -frame.eye_altitude));
    return ground_at(map_point(dn), frame.sin_lat + sin_lat_delta(dn), 1.0);
}

fn bed_altitude(way: vec2f) -> Metres { return min(ground_below(way).elevation, 0.0); }

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Pixel {
    let device = vec2f(vec2u((index << 1u) & 2u, index & 2u)) * 2.0 - 1.0;
    // The same place for all vertices, as near as makes no difference: Mesa compiles anew what depends on the frame alone.
    let foot = device * 1e-6;
    let here = bed_altitude(foot);
    let slope = vec2f(bed_altitude(foot + vec2f(PLANE, 0.0)), bed_altitude(foot + vec2f(0.0, PLANE))) - here;
    return Pixel(vec4f(device, 0.0, 1.0), device, vec3f(here, slope / PLANE));
}

struct Seen { @location(0) colour: vec4f, @builtin(frag_depth) depth: f32 }

@fragment
fn fragment(in: Pixel) -> Seen {
    let ray = frame.ray_forward + in.device.x * frame.ray_right + in.device.y * frame.ray_up;
    let direction = normalize(ray);
    let over_bed = max(frame.eye_altitude - in.bed.x, 0.05);
    let sinking = dot(in.bed.yz, direction.xy) - direction.z;
    var distance = over_bed / max(sinking, 1e-4);
    let is_near = (sinking > 0.0) & (distance < FARTHEST);
    var depth = -in.bed.x;
    var corals = vec2f(0.0);
    for (var i = 0; i < 2; i++) {
        let place = direction * min(distance, FARTHEST);
        let ground = ground_below(place.xy);
        let bed = min(ground.elevation, 0.0);
        corals = ground.corals;
        depth = -bed;
        distance = clamp(distance + (frame.eye_altitude + place.z - bed) / max(sinking, 0.01), 0.02, 2.0 * FARTHEST);
    }
    let hits = is_near & (distance < FARTHEST) & ((frame.layers & SHOWS_LAND) != 0u);
    var light = daylight_at(frame.light.z);
    if CLOUDS { light = clouded_daylight_at_eye(light); }
    let w = underwater(light);
    let way = select(1e4, distance, hits);
    var radiance = vec3f(0.0);
    let rays = sun_rays(w, caustics, in.position.xy, direction, way);
    let place = direction * min(distance, FARTHEST);
    let footprint = footprint_on_bed(distance, direction, sinking, 0.0);
    if hits {
        var caustic = 1.0;
        if FINE { caustic = bed_caustic(w, caustics, place.xy, depth); }
        radiance = bed_light(w, place.xy, depth, corals, footprint, caustic);
    }
    let seen = seen_through(w, radiance, frame.eye_altitude, direction, way, rays);
    return Seen(shown_in_water(w, seen), select(1e-9, clamp(NEAR / (distance * dot(direction, frame.ray_forward)), 1e-9, 1.0), hits));
}
