// What clouds do to the light of sea and land. It changes over hundreds of metres, so it is worked out at the nodes of a net over the picture
// (cloud_light.wgsl), and pixels interpolate it.
#import light
#import cloud_layer

const CLOUD_RISES = 4u;     // of which a node knows how much of the sky is hidden there: sines (i / 4)^2, i from 1
const LET_THROUGH = 0.26;   // of the sun's light by closed clouds: a day under them has a quarter to a third of a clear one's light
// What the haze before clouds 1,500 m high leaves of them, over 40 km by a factor of e, at those rises, as rough water spreads them.
const CLOUDS_IN_HAZE = vec4f(0.794, 0.879, 0.938, 0.964);
// Shares of the sky from which on clouds are closed, and sines of the sun's elevation from which down its light comes from beyond them.
const SHUT = vec2f(0.6, 0.95);
const GLOW_BEYOND = vec2f(0.1, 0.0);
const SIDES_LIT = 0.75;     // of the light that meets a plane which faces the sun, what the sides and bases of heaps send down of one on the horizon's; ours
const LEAST_MET = 0.02;     // sine of the sun's elevation of a layer as uneven as clouds are: it is met by some light of a sun below its horizon
const LEVEL_LIT = 0.3;      // sine of the sun's elevation below which closed clouds, which are level, have less of it; what they have at least, as tops are
const LEAST_LIT = 0.03;     // uneven: both ours, as higher suns' light goes through such clouds the better the steeper it comes
const QUICK_HIDDEN = 0.8;   // of the sky that is mirrored, where clouds are everywhere

// Numbers 0...1 in 16 bits each: three at each node, `Shadow` of clouds.wgsl, the last node for the eye's foot; then four at each of those for what
// is mirrored, which coarse pictures and those of the whole globe have none of: what is hidden at each rise ahead.
@group(1) @binding(13) var<storage, read> cloud_net: array<vec2u>;

fn cloud_net_size() -> vec2u { return vec2u(frame.cloud_net & 0xffffu, frame.cloud_net >> 16u); }
fn mirror_net_size() -> vec2u { return (cloud_net_size() - 2u) / MIRROR_NODES + 2u; }

// Where a place on the ellipsoid is in a net: its node below and to the left, nodes in a row, and the way on to the next.
struct InNet { first: u32, row: u32, f: vec2f }

fn in_net(device: vec2f, size: vec2u) -> InNet {
    let at = (0.5 * clamp(device, vec2f(-1.0), vec2f(1.0)) + 0.5) * vec2f(size - 1u);
    let cell = min(vec2u(at), size - 2u);
    return InNet(cell.y * size.x + cell.x, size.x, at - vec2f(cell));
}

fn in_net_of(place: vec3f, size: vec2u) -> InNet {
    let clip = frame.clip_from_local * vec4f(place, 1.0);
    return in_net(clip.xy / max(clip.w, NEAR), size);
}

// Light of the sun that clouds send down to level ground where they are everywhere; `cover`: how closed they are. A sun that stands low, or has
// not risen for the sea, shines on their sides and bases, redder than it does above, but the less on these the more level they are.
fn sent_down(light: Daylight, mu_sun: f32, cover: f32) -> vec3f {
    let level = clamp(mu_sun / LEVEL_LIT, LEAST_LIT, 1.0);
    let sides = SIDES_LIT * (1.0 - saturate(mu_sun)) * mix(1.0, level, smoothstep(SHUT.x, SHUT.y, cover));
    return LET_THROUGH * max(light.sun * max(mu_sun, 0.0), sides * SUN_IRRADIANCE * sunlight(CLOUD_TOP, mu_sun));
}

// How much of that level ground has: sides that face a low sun stand before each other, and all of them have no more light than the layer meets.
fn sent_to_ground(light: Daylight, mu_sun: f32, cover: f32) -> vec3f {
    let met = max(mu_sun, LEAST_MET) * SUN_IRRADIANCE * sunlight(CLOUD_TOP, mu_sun);
    return min(sent_down(light, mu_sun, cover), 0.5 * met);
}

// Daylight on the ground or the sea: less of the sun in the shadow of a cloud; under many, less of the sky and more of what comes through them. The
// air is that of the eye's own sky, as it is before the clouds: with each place's own, the far sea would not end in the haze that the sky starts in.
fn shaded(light: Daylight, mu_sun: f32, shadow: vec3f) -> Daylight {
    let cover = shadow.y;
    let over_eye = cover_at_eye();
    let clouded = 0.5 * light.sky + sent_to_ground(light, mu_sun, cover);
    let clouded_eye = 0.5 * light.sky + sent_to_ground(light, mu_sun, over_eye);
    return Daylight(light.sun * shadow.x, mix(light.sky, clouded, cover), cover, air_under(over_eye), shadow.z, mix(light.sky, clouded_eye, over_eye));
}

fn net_shadow(node: u32) -> vec3f {
    let halves = cloud_net[node];
    return vec3f(unpack2x16unorm(halves.x), unpack2x16unorm(halves.y).x);
}

// `Shadow` of clouds.wgsl.
fn shadow_in(at: InNet) -> vec3f {
    return mix(
        mix(net_shadow(at.first), net_shadow(at.first + 1u), at.f.x),
        mix(net_shadow(at.first + at.row), net_shadow(at.first + at.row + 1u), at.f.x), at.f.y);
}

// That at a place on the ellipsoid, of a vertex whose pixels interpolate it: in coarse pictures cells are about as wide as the net's. `of_pixels`:
// each of these has its own.
fn shadow_of_vertex(place: vec3f, of_pixels: bool) -> vec3f {
    if !CLOUDS || of_pixels { return vec3f(0.0); }
    return shadow_in(in_net_of(place, cloud_net_size()));
}

// And of a pixel, given that of its vertices.
fn shadow_of_pixel(place: vec3f, of_vertices: vec3f, of_pixels: bool) -> vec3f {
    if !of_pixels { return of_vertices; }
    return shadow_in(in_net_of(place, cloud_net_size()));
}

// That of ground or water so high: summits stand among the clouds, or above them.
fn shadow_at_height(shadow: vec3f, height: Metres) -> vec3f { return mix(shadow, vec3f(1.0, 0.0, 1.0), smoothstep(CLOUD_BASE, CLOUD_TOP, height)); }

fn clouded_daylight(light: Daylight, up: vec3f, shadow: vec3f) -> Daylight { return shaded(light, dot(frame.light, up), shadow); }

// At the eye's foot.
fn clouded_daylight_at_eye(light: Daylight) -> Daylight {
    let size = cloud_net_size();
    return shaded(light, frame.light.z, net_shadow(size.x * size.y));
}

// How much of the sky clouds cover there.
fn cover_at_eye() -> f32 {
    let size = cloud_net_size();
    return net_shadow(size.x * size.y).y;
}

fn net_hidden(node: u32) -> vec4f {
    let halves = cloud_net[node];
    return vec4f(unpack2x16unorm(halves.x), unpack2x16unorm(halves.y));
}

// Radiance of the sky that rough water mirrors towards the sine `rise`, with the clouds that stand there; `clear`: daylight under no clouds;
// `cover`: the share of clouds overhead, by which pictures go alone that mirror no single clouds. Who imports this declares FINE and CLOUDS
// (src/pass/kind.rs), and MIRRORS_CLOUDS.
fn clouded_sky(sky: vec3f, clear: Daylight, cover: f32, place: vec3f, rise: f32, up: vec3f) -> vec3f {
    let cloudy = seen_from_below(rise, cover * cover) * (sent_down(clear, dot(frame.light, up), cover) + 0.5 * clear.sky) / PI;
    // The glow of a sun behind the horizon comes from beyond closed clouds: what haze and gaps let through of it would glint out of nowhere.
    let shut = smoothstep(SHUT.x, SHUT.y, cover) * smoothstep(GLOW_BEYOND.x, GLOW_BEYOND.y, dot(frame.light, up));
    if !MIRRORS_CLOUDS { return mix(sky, cloudy, mix(QUICK_HIDDEN * cover, 1.0, shut)); }
    let net = cloud_net_size();
    let at = in_net_of(place, mirror_net_size());
    let first = net.x * net.y + 1u + at.first;
    let hidden = mix(
        mix(net_hidden(first), net_hidden(first + 1u), at.f.x),
        mix(net_hidden(first + at.row), net_hidden(first + at.row + 1u), at.f.x), at.f.y);
    let x = f32(CLOUD_RISES) * sqrt(saturate(rise)) - vec4f(1.0, 2.0, 3.0, 4.0);
    let share = mix(dot(CLOUDS_IN_HAZE * hidden, max(1.0 - abs(x), vec4f(0.0))), 1.0, shut);
    return mix(sky, cloudy, share);
}
