// Clouds that clouds.wgsl has drawn into a smaller picture, laid over the whole one. What stands among them or before them, a mountain, is
// told by its depth: of the clouds of a sight it hides as much as it has of the way through their layer behind it. From space nothing does near the limb,
// and of the whole globe (`GLOBE`) nothing at all: no depth has been drawn. `GLOBE` and `SCALE` are of src/pass/clouds.rs.
#import full_screen
#import cloud_layer

@group(1) @binding(0) var scene_depth: texture_depth_2d;
@group(1) @binding(1) var small: texture_2d<f32>;

const FROM_SPACE = vec2f(6e4, 2.5e5); // heights of the eye, m, between which clouds come before all mountains,
const SLANTING = vec2f(0.8, 0.5);       // and sines of a sight's descent, between which they do; ours
const HORIZON_PIXELS = 2.0;  // of the smaller picture: as far as `sharpened` looks
const SHARPENED = 0.7;      // how much more than their mean the nearest four count, against a ring of four about them

// What the smaller picture shows at a pixel. Neighbours there have looked elsewhere in their steps: the mean of four has no grain, nor has that of the
// ring, in which each of the four counts as much. Their mean alone makes edges three of its pixels wide; nothing shows that none of the eight has.
fn sharpened(at: vec2f) -> vec4f {
    let size = vec2f(textureDimensions(small));
    let place = at / SCALE;
    var near = vec4f(0.0);
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
        ring += 0.25 * other;
        least = min(least, min(one, other));
        most = max(most, max(one, other));
    }
    return clamp(near + SHARPENED * (near - ring), least, most);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let at = corner.position.xy;
    var direction = normalize(frame.ray_forward + corner.device.x * frame.ray_right + corner.device.y * frame.ray_up);
    let seen = sharpened(at);
    if GLOBE { return seen; }
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
    let water = layer_stretch(ray, select(hit, 1e9, (hit < 0.0) | (frame.eye_altitude < CLOUD_BASE)));
    let shell = shell_hits(ray, ICE_HEIGHT);
    let ice = select(shell.x, shell.y, frame.eye_altitude < ICE_HEIGHT);
    let has_ice = (shell.x <= shell.y) & (ice > 0.0);
    // A sight that meets neither, beside the limb, has only its neighbours' clouds.
    let stretch = select(select(vec2f(1.0, 0.0), vec2f(ice, ice + 1.0), has_ice), vec2f(water.first, water.last), water.first < water.last);
    let depth = textureLoad(scene_depth, vec2u(at), 0);
    let stands = NEAR / max(depth, 1e-10) / max(dot(direction, frame.ray_forward), 1e-3);
    // What lies below the layer of a sight that comes back to it counts as none of the way.
    let gap = water.returns - water.leaves;
    let way = stands - stretch.x - clamp(stands - water.leaves, 0.0, gap);
    let before = saturate(way / max(stretch.y - stretch.x - gap, 1.0));
    // Half-way through closed clouds nothing is seen any more. Land that stands farther into their layer than where a sight is lowest or leaves it hides no
    // more of them than that, or it would be a line across near ones; of what stands nearer it is not known which are behind.
    let lowest = select(1e9, -direction.z * SEMI_MINOR, direction.z < 0.0);
    let closed = (1.0 - pow(max(1.0 - seen.a, 1e-6), before)) / max(seen.a, 1e-4);
    let share = mix(before, min(closed, 1.0), smoothstep(0.5, 1.0, (stands - stretch.x) / max(min(water.leaves, lowest) - stretch.x, 1.0)));
    // Clouds lie higher over mountains than this layer does: what stands out of it would be a ribbon towards the limb. Seen from where there is one, none does.
    let over = smoothstep(FROM_SPACE.x, FROM_SPACE.y, frame.eye_altitude) * smoothstep(SLANTING.x, SLANTING.y, -direction.z);
    return seen * mix(select(0.0, share, stretch.x < stretch.y), 1.0, over);
}
