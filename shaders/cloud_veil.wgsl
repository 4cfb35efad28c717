// Clouds that clouds.wgsl has drawn into a smaller picture, laid over the whole one. What stands among them or before them, a mountain, is
// told by its depth: of the clouds of a sight it hides those behind it. From space nothing does near the limb,
// and of the whole globe (`GLOBE`) nothing at all: no depth has been drawn. `GLOBE` and `SCALE` are of src/pass/clouds.rs.
#import full_screen
#import cloud_layer
#import normal

@group(1) @binding(0) var scene_depth: texture_depth_2d;
@group(1) @binding(1) var small: texture_2d<f32>;
@group(1) @binding(2) var small_ways: texture_2d<f32>;

const FROM_SPACE = vec2f(6e4, 2.5e5); // heights of the eye, m, between which clouds come before all mountains,
const SLANTING = vec2f(0.8, 0.5);       // and sines of a sight's descent, between which they do; ours
const HORIZON_PIXELS = 2.0;  // of the smaller picture: as far as `sharpened` looks
const WAYS_KNOWN = 0.005;    // least deviation of the logarithm of these ways: 16 bits know them so well
const SHARPENED = 0.7;      // how much more than their mean the nearest four count, against a ring of four about them

// What the smaller picture shows at a pixel, and from where that hides what is behind it: mean and deviation of the distance's logarithm.
struct Small { seen: vec4f, ways: vec2f }

// Neighbours there have looked elsewhere in their steps: the mean of four has no grain, nor has that of the
// ring, in which each of the four counts as much. Their mean alone makes edges three of its pixels wide; nothing shows that none of the eight has.
fn sharpened(at: vec2f) -> Small {
    let size = vec2f(textureDimensions(small));
    let place = at / SCALE;
    var near = vec4f(0.0);
    var ways = vec3f(0.0);     // means, deviations, and squares of means
    var ring = vec4f(0.0);
    var least = vec4f(1e9);
    var most = vec4f(0.0);
    for (var i = 0u; i < 4u; i++) {
        let aside = vec2f(f32(i & 1u), f32(i >> 1u)) - 0.5;
        // A quarter turn on from one to the next.
        let about = aside + 2.0 * vec2f(aside.y, -aside.x);
        let one = textureSampleLevel(small, clamped, (place + aside) / size, 0.0);
        let other = textureSampleLevel(small, clamped, (place + about) / size, 0.0);
        near += 0.25 * one;
        let way = textureSampleLevel(small_ways, clamped, (place + aside) / size, 0.0).xy;
        ways += 0.25 * vec3f(way, way.x * way.x / max(one.a, 1e-4));
        ring += 0.25 * other;
        least = min(least, min(one, other));
        most = max(most, max(one, other));
    }
    ways /= max(near.a, 1e-4);
    let apart = max(ways.z - ways.x * ways.x, 0.0);
    return Small(clamp(near + SHARPENED * (near - ring), least, most), vec2f(ways.x, sqrt(ways.y * ways.y + apart)));
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let at = corner.position.xy;
    var direction = normalize(frame.ray_forward + corner.device.x * frame.ray_right + corner.device.y * frame.ray_up);
    let clouds = sharpened(at);
    if GLOBE { return clouds.seen; }
    var ray = eye_ray(direction);
    var hit = surface_hit(ray);
    // Pixels of the smaller picture beside one on the horizon pass over it, and have the clouds behind it.
    let over_it = normalize(direction + vec3f(0.0, 0.0, HORIZON_PIXELS * SCALE * frame.pixel_angle));
    let passes_over = (hit >= 0.0) & (surface_hit(eye_ray(over_it)) < 0.0) & (frame.eye_altitude >= CLOUD_BASE);
    if passes_over {
        direction = over_it;
        ray = eye_ray(direction);
        hit = -1.0;
    }
    let far = select(hit, 1e9, (hit < 0.0) | (frame.eye_altitude < CLOUD_BASE));
    let water = layer_stretch(ray, far);
    let in_water = select(vec2f(1e9, 0.0), vec2f(water.first, water.last), water.first < water.last);
    let shell = shell_hits(ray, ICE_HEIGHT);
    let ice = select(shell.x, shell.y, frame.eye_altitude < ICE_HEIGHT);
    let in_ice = select(vec2f(1e9, 0.0), vec2f(ice, ice + 1.0), (shell.x <= shell.y) & (ice > 0.0) & (ice < far));
    // From the first cloud to the last. A sight that meets neither kind, beside the limb, has only its neighbours'.
    let stretch = vec2f(min(in_water.x, in_ice.x), max(in_water.y, in_ice.y));
    let depth = textureLoad(scene_depth, vec2u(at), 0);
    let stands = NEAR / max(depth, 1e-10) / max(dot(direction, frame.ray_forward), 1e-3);
    // How much of what they hide they hide before it.
    let deviation = max(clouds.ways.y, WAYS_KNOWN);
    let ways = (vec3f(way_of(stands), way_of(stretch.x), way_of(stretch.y)) - clouds.ways.x) / deviation;
    let hidden = vec3f(normal_share(ways.x), normal_share(ways.y), normal_share(ways.z));
    let share = select(saturate((hidden.x - hidden.y) / max(hidden.z - hidden.y, 1e-4)), 1.0, stands >= stretch.y);
    // Clouds lie higher over mountains than this layer does: what stands out of it would be a ribbon towards the limb. Seen from where there is one, none does.
    let over = smoothstep(FROM_SPACE.x, FROM_SPACE.y, frame.eye_altitude) * smoothstep(SLANTING.x, SLANTING.y, -direction.z);
    return clouds.seen * mix(select(0.0, share, stretch.x < stretch.y), 1.0, over);
}
