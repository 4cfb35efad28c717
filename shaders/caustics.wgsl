// Caustics on the bed about the eye: a net of sun rays through the drawn waves' slopes, refracted to the bed at each ray's depth. A triangle
// of the net has so much more light on the bed as it is smaller there than it was on the surface; where several lie on each other their
// light adds up. So no light is lost, however the rays cross. `ABOVE`: for an eye over the water, whose bed has
// its own light by its slopes; `SURF`: with the trains of waves that it sees near shores. Who is drawn with declares FINE, WAVES and NOISE.
#import waves
#import surf
#import world
#import translucence
#import caustic_map
#import held

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) from_place: vec2f,    // where the ray passes through the surface, or if `ABOVE` where it would meet the bed under a flat one
    @location(1) bed: vec2f,           // and where it meets the bed: level, metres from the eye
}

const BRIGHTEST: f32 = 1000.0;          // that a texel may be; the sun's disc has an end

@vertex
fn vertex(@location(0) grid: vec2f) -> Vertex {
    let reach = caustic_place(grid);
    let dn = normal_delta(vec3f(reach, -frame.eye_altitude));
    let point = map_point(dn);
    let ground = ground_at(point, frame.sin_lat + sin_lat_delta(dn), 1.0);
    let depth = caustic_depth(-ground.elevation);
    let down = into_water(-frame.light, vec3f(0.0, 0.0, 1.0));
    // Under a flat surface the ray ends where the net asks for it.
    let surface = vec3f(reach + down.xy / down.z * depth, -frame.eye_altitude);
    let cell = caustic_stretch(grid) / (0.5 * CAUSTIC_CELLS);
    var sea = behind_reefs(local_sea(point), ground.waves);
    var trains = vec2f(0.0);
    let footprint = max(cell.x, cell.y);
    if SURF {
        let waves = shore_waves_at(point, -ground.elevation, -ground.plain, ground.waves, ground.ocean_shore, ground.face, length(surface), footprint, 0.0);
        sea = left_by_trains(sea, waves.share);
        trains = waves.slope;
    }
    let slope = held_share(depth, sea.height) * slopes_in(sea, surface, length(surface), footprint, 1.0).slope + trains;
    let ray = into_water(-frame.light, normalize(vec3f(-slope, 1.0)));
    let bed = surface.xy - ray.xy / min(ray.z, -0.2) * depth;
    return Vertex(vec4f(caustic_coordinates(bed), 0.5, 1.0), select(surface.xy, reach, ABOVE), bed);
}

fn area(right: vec2f, down: vec2f) -> f32 { return abs(right.x * down.y - right.y * down.x); }

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    let light = area(dpdx(in.from_place), dpdy(in.from_place)) / max(area(dpdx(in.bed), dpdy(in.bed)), 1e-9);
    return vec4f(min(light, BRIGHTEST));
}
