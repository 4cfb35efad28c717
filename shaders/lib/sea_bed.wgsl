// What the sea's bed looks like: sand with ripples, and where it is not sand, seagrass and rock. All is fixed to the map: ways on it are
// those of `frame.bed_origin`, a square of BED_SIDE metres that repeats.
#import bed_cover
#import world
#import under_water

// A way from the eye's foot, east and north, to a place of the bed's square.
fn bed_place(way: vec2f) -> vec2f {
    if abs(frame.sin_lat) > POLAR_SIN_LAT {
        let side = sign(frame.sin_lat);
        let out = vec2f(-side * way.y, way.x);
        return frame.bed_origin + vec2f(frame.meridian.x * out.x - frame.meridian.y * out.y, frame.meridian.y * out.x + frame.meridian.x * out.y);
    }
    return frame.bed_origin + way / frame.cos_lat;
}

// Slopes and height of ripples that lie across `way`, `wide` metres from crest to crest: their crests bend with the noise and are sharper
// than their troughs. `bend`: slopes and value of that noise, in metres of the crests' way.
fn ripples(place: vec2f, way: vec2f, wide: f32, bend: vec3f) -> vec3f {
    let turn = TURN / wide;
    let along = fract((dot(place, way) + bend.z) / wide) * TURN;
    let rise = turn * (way + bend.xy);
    // Height in units of amplitude: cosine with its first overtone.
    return vec3f((-sin(along) - 0.5 * sin(2.0 * along)) * rise, cos(along) + 0.25 * cos(2.0 * along));
}

// What a pixel covers of the bed: so many metres across the sight, and so much more along it, east and north.
struct Footprint { across: Metres, along: vec2f }

fn footprint_on_bed(distance: Metres, direction: vec3f, sinking: f32, blur: Metres) -> Footprint {
    let across = distance * frame.pixel_angle + blur;
    let longer = across * sqrt(max(1.0 / max(sinking * sinking, 1e-4) - 1.0, 0.0));
    return Footprint(across, longer * direction.xy / max(length(direction.xy), 1e-4));
}

// How wide it is along a way.
fn width_along(footprint: Footprint, way: vec2f) -> Metres {
    let along = dot(way, footprint.along);
    return sqrt(footprint.across * footprint.across + along * along);
}

struct BedLook { slope: vec2f, albedo: vec3f }

const RIPPLES_FIRST = vec2f(0.934, 0.358);      // ways that they lie across
const RIPPLES_SECOND = vec2f(0.788, 0.616);
const RIPPLES_THIRD = vec2f(0.31, 0.95);

// `corals` as in world.wgsl.
fn bed_look(place: vec2f, depth: Metres, deepest: Metres, corals: vec2f, pixel: Footprint) -> BedLook {
    // As good as square, for what has no direction.
    let footprint = sqrt(pixel.across * length(vec2f(pixel.across, length(pixel.along))));
    // Broad heaps, and the bends of ripples.
    let broad = bed_noise(place, 16.0, 31u);
    let heaps = bed_noise(place, 4.0, 32u);
    let small = bed_noise(place, 1.0, 33u);
    let tiny = bed_noise(place, 0.25, 34u);
    var slope = 0.5 * broad.xy + 0.16 * shown(footprint, 4.0) * heaps.xy + 0.035 * shown(footprint, 1.0) * small.xy
        + 0.008 * shown(footprint, 0.25) * tiny.xy;
    // Two trains that meet at an angle: where one takes over from the other crests fork.
    let bend = 0.55 * heaps + 0.07 * small;
    let share = smoothstep(-0.12, 0.12, broad.z + 0.5 * heaps.z);
    let calm = smoothstep(-0.35, 0.1, heaps.z + 0.3 * broad.z) * mix(1.0, 0.35, smoothstep(6.0, 25.0, depth));
    let first = shown(width_along(pixel, RIPPLES_FIRST), 0.27) * ripples(place, RIPPLES_FIRST, 0.27, bend);
    let second = shown(width_along(pixel, RIPPLES_SECOND), 0.23) * ripples(place, RIPPLES_SECOND, 0.23, bend);
    let third = shown(width_along(pixel, RIPPLES_THIRD), 0.09) * ripples(place, RIPPLES_THIRD, 0.09, 0.3 * bend);
    let ripple = mix(first, second, share);
    let amplitude = 0.0125 * (0.35 + 0.65 * calm);
    slope += amplitude * ripple.xy + 0.0016 * (1.0 - calm) * third.xy;
    // Dark grains gather in troughs, pale shell on crests; no two places are alike.
    let grains = bed_noise(place, 0.03125, 35u).z * shown(footprint, 0.03125) + bed_noise(place, 0.0078125, 36u).z * shown(footprint, 0.0078125);
    let tone = 1.0 + 0.10 * ripple.z * calm + 0.22 * broad.z + 0.16 * small.z * shown(footprint, 1.0) + 0.22 * grains
        + 0.12 * tiny.z * shown(footprint, 0.25);
    let sand_tone = clamp(tone, 0.35, 1.5);
    var albedo = with_coral_sand(BED_ALBEDO, depth, corals.y) * sand_tone;
    let cover = bed_cover(place, depth, deepest, corals, vec3f(broad.z, heaps.z, small.z), length(vec2f(pixel.across, length(pixel.along))));
    let grass = cover.grass;
    let rock = cover.rock;
    let blades = 0.5 + 1.1 * tiny.z * shown(footprint, 0.25) + 0.9 * small.z;
    albedo = mix(albedo, SEAGRASS * clamp(0.6 + blades, 0.3, 1.8), grass);
    slope = mix(slope, slope + 0.10 * tiny.xy * shown(footprint, 0.25) + 0.10 * small.xy, grass);
    albedo = mix(albedo, REEF * clamp(0.9 + 1.2 * small.z + 0.9 * tiny.z, 0.3, 1.8), rock);
    albedo = mix(albedo, RUBBLE * sand_tone, RUBBLED * corals.x);
    albedo = mix(albedo, CORALS * clamp(1.0 + 1.2 * small.z + 0.9 * tiny.z, 0.3, 1.8), cover.corals);
    slope += max(rock, cover.corals) * (0.35 * small.xy * shown(footprint, 1.0) + 0.09 * tiny.xy * shown(footprint, 0.25));
    return BedLook(slope, albedo);
}

// Radiance of the bed at a way from the eye's foot, where the water is `depth` deep. `caustic`: the sun's light there over its mean.
fn bed_light(w: Underwater, way: vec2f, depth: Metres, corals: vec2f, pixel: Footprint, caustic: f32) -> vec3f {
    let look = bed_look(bed_place(way), depth, meadows_to(w.fading.g), corals, pixel);
    let normal = normalize(vec3f(-look.slope, 1.0));
    let left = exp(-w.fading * depth);
    // What has been scattered on its way shows no wave.
    let sharp = exp(-w.haze * depth / w.to_sun.z);
    let direct = mix(1.0, caustic, sharp) * mix(1.0, max(dot(normal, w.to_sun), 0.0) / w.to_sun.z, 0.25 + 0.75 * sharp);
    let down = left * (w.sun * direct + w.sky * (0.6 + 0.4 * normal.z));
    return look.albedo / PI * down / (1.0 - MIRRORED_BACK * look.albedo * left * left);
}
