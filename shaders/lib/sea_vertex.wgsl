// The vertices of the sea, of either mesh (sea_mesh.wgsl), with what its pixels interpolate.
#import sea_mesh
#import shore_pixels
#import surf
#import cloud_light

const ROLLERS = FOAM && WAVES && FINE && !MEASURED && !UNDER_WATER;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) rest: vec3f,          // on the ellipsoid
    @location(1) moved: vec3f,
    @location(2) height: f32,
    @location(4) incoming: f32,        // height of the waves that break on shores
    @location(5) shadow: vec3f,        // of clouds, `shadow_of_vertex`
    @location(6) grid: vec4f,          // `grid_at`
    @location(3) ahead: vec2f,         // the way to the water beyond, level, and how much higher that is; see `crest_light`
}

fn vertex_at(place: Place) -> Vertex {
    let dn = normal_delta(place.rest);
    let point = map_point(dn);
    var incoming = 0.0;
    if SURF { incoming = height_coming_in(local_sea(point), length(place.rest)); }
    let grid = grid_at(point, frame.sin_lat + sin_lat_delta(dn), max(length(place.rest) * frame.pixel_angle, 1.0));
    return Vertex(frame.clip_from_local * vec4f(place.moved, 1.0), place.rest, place.moved, place.height, incoming, shadow_of_vertex(place.rest, FINE),
        grid, beyond(place));
}

@vertex
fn vertex_of_grid(@location(0) grid: vec2f) -> Vertex { return vertex_at(place_on_grid(grid)); }

@vertex
fn vertex_of_bisection(@builtin(vertex_index) index: u32) -> Vertex { return vertex_at(place_of_bisection(index)); }
