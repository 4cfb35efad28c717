// The net of lib/cloud_light.wgsl: what clouds take of the light at places that the picture shows, and of the sky that these mirror.
#import clouds
#import cloud_light

const FINE = true;
const CLOUDS = true;
const MIRRORS_CLOUDS = true;

@group(2) @binding(0) var<storage, read_write> made: array<vec2u>;

// What a node shows: a place on the ellipsoid, and how wide the way to the next one is there. An eye between waves, or in the sea, is taken to
// be at its level. Above the horizon stands what is at the horizon.
struct Node { at: vec3f, direction: vec3f, up: vec3f, sine: f32, cell: Metres, is_sky: bool }

const SPACE: Metres = 100000.0;      // from so high on nodes beside the earth need no look

fn node_of(index: u32, size: vec2u, is_eye: bool) -> Node {
    let device = vec2f(vec2u(index % size.x, index / size.x)) / vec2f(size - 1u) * 2.0 - 1.0;
    let direction = normalize(frame.ray_forward + device.x * frame.ray_right + device.y * frame.ray_up);
    let ray = ray_coefficients(direction, frame.quadric_gradient, max(frame.quadric_constant, 0.0));
    let hit = surface_hit(ray);
    let distance = select(select(hit, max(-ray.b / ray.a, 0.0), hit < 0.0), 0.0, is_eye);
    let at = direction * distance;
    let up = normal_delta(at) + vec3f(0.0, 0.0, 1.0);
    let cell = distance * frame.pixel_angle * frame.viewport.x / f32(size.x - 1u);
    let is_sky = (frame.eye_altitude > SPACE) & (hit < 0.0) & !is_eye & (height_along(ray, distance) > 3.0 * cell);
    return Node(at, direction, up, dot(direction, up), cell, is_sky);
}

@compute @workgroup_size(64)
fn shadows(@builtin(global_invocation_id) id: vec3u) {
    let size = cloud_net_size();
    let nodes = size.x * size.y;
    if id.x > nodes { return; }
    let node = node_of(id.x, size, id.x == nodes);
    if node.is_sky {
        made[id.x] = vec2u(pack2x16unorm(vec2f(1.0, 0.0)), pack2x16unorm(vec2f(1.0, 0.0)));
        return;
    }
    // Half as wide: what is between two nodes is interpolated.
    let shadow = cloud_shadow(node.at, node.up, 0.5 * node.cell / sqrt(max(abs(node.sine), 0.002)));
    made[id.x] = vec2u(pack2x16unorm(vec2f(shadow.left, shadow.cover)), pack2x16unorm(vec2f(shadow.disc, 0.0)));
}

@compute @workgroup_size(64)
fn mirrors(@builtin(global_invocation_id) id: vec3u) {
    let size = mirror_net_size();
    if id.x >= size.x * size.y { return; }
    let node = node_of(id.x, size, false);
    let net = cloud_net_size();
    let own = net.x * net.y + 1u + id.x;
    if node.is_sky {
        made[own] = vec2u(0u);
        return;
    }
    let level = node.direction - node.sine * node.up;
    let ahead = level / max(length(level), 1e-4);
    var hidden = vec4f(0.0);
    var i = 0u;
    loop {
        let root = f32(i + 1u) / f32(CLOUD_RISES);
        let rise = root * root;
        let mirrored = normalize(sqrt(1.0 - rise * rise) * ahead + rise * node.up);
        hidden = select(hidden, vec4f(mirrored_clouds(node.at, mirrored, node.up, 0.5 * node.cell)), vec4u(i) == vec4u(0u, 1u, 2u, 3u));
        i++;
        if i == CLOUD_RISES { break; }
    }
    made[own] = vec2u(pack2x16unorm(hidden.xy), pack2x16unorm(hidden.zw));
}
