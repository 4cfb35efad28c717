// The waterline: what the picture from below covers of the one from above, and the water that climbs up the glass. Each pixel looks through
// its own place of a lens `frame.lens` before the eye: what lies under the water there shows the picture from below.
#import waves
#import world
#import held
#import light

@group(2) @binding(0) var below: texture_2d<f32>;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) over: f32,            // metres of the lens above the water, straight up
}

// How high water climbs up a wall: where z metres are over the level its surface stands at the angle t from the wall, z^2 / 2 = a^2 (1 - sin t)
// (L. Landau and E. Lifshitz 1987, "Fluid Mechanics", section 61). On glass that is not quite clean t ends at 30 degrees, at a height of a.
const CAPILLARY: Metres = 0.0027;      // a: the square root of surface tension over weight, (0.073 N/m / (1025 kg/m3 g))^(1/2)

@vertex
fn vertex(@location(0) grid: vec2f) -> Vertex {
    let place = frame.lens * (frame.ray_forward + grid.x * frame.ray_right + grid.y * frame.ray_up);
    let dn = normal_delta(vec3f(place.xy, -frame.eye_altitude));
    let point = map_point(dn);
    let ground = ground_at(point, frame.sin_lat + sin_lat_delta(dn), 20.0);
    let sea = behind_reefs(local_sea(point), ground.waves);
    let held = held_share(-ground.elevation, sea.height);
    // The water that stands there has been moved there by the chop.
    var rest = place.xy;
    var height = 0.0;
    for (var i = 0; i < 4; i++) {
        let moved = held * displacement_in(sea, vec3f(rest, -frame.eye_altitude), length(rest), 0.01);
        rest = place.xy - moved.xy;
        height = moved.z;
    }
    return Vertex(vec4f(grid, 0.5, 1.0), place.z + frame.eye_altitude - height);
}

// How high the water stands on the glass here, of its usual height: it wets it in places and runs off in others.
fn standing(x: f32) -> f32 {
    let slow = sin(5.3 * x + 1.1) + sin(11.9 * x - 0.7);
    let quick = sin(29.0 * x + 2.0 * slow) + sin(67.0 * x - 3.0 * slow);
    return 1.0 + 0.14 * slow + 0.04 * quick;
}

const LOOKS = 8u;                      // at the picture from below, for what the meniscus mirrors
const BLURRED = 0.02;                  // heights of the picture, across: so near the lens nothing is sharp; ours
const ALL_MIRRORED = 0.707;            // of a: up to there, where 1 - sin t is 1/4, surfaces are beyond the critical angle
const DARK_RIM = 0.4;                  // share of the light that is missing along the line, as in photographs; ours
const BRIGHT_RIM = vec2f(0.86, 0.12);  // where along the upper edge the sky shines in, and how wide that is; ours
const RIM_LIGHT = 0.35;                // of the sky's mean radiance

// The picture from below as the meniscus mirrors it, 0...1 of the way up: what meets the surface at the angle t is turned down by twice what t lacks
// of a right angle. So from the line up there is all, upside down, from what stands at the line to what lies under the lens, which the picture's lower edge
// stands for. `line`: row of the line.
fn mirrored(column: f32, line: f32, up: f32) -> vec3f {
    let last = vec2f(textureDimensions(below)) - 1.0;
    var sum = vec4f(0.0);
    for (var i = 0u; i < LOOKS; i++) {
        let from_line = (f32(i) + 0.5) / f32(LOOKS);
        let off = (from_line - up) * 4.0;
        let aside = BLURRED * frame.viewport.y * (f32((i * 3u) % LOOKS) / f32(LOOKS - 1u) - 0.5);
        let seen = clamp(vec2f(column + aside, mix(line, last.y, from_line)), vec2f(0.0), last);
        sum += exp(-off * off) * vec4f(textureLoad(below, vec2u(seen), 0).rgb, 1.0);
    }
    return sum.rgb / sum.a;
}

@fragment
fn fragment(in: Vertex) -> @location(0) vec4f {
    let rise = vec2f(dpdx(in.over), dpdy(in.over));
    let pixels = in.over / max(length(rise), 1e-6);
    let tall = max(CAPILLARY / (frame.lens * frame.pixel_angle) * standing(in.position.x / frame.viewport.y), 2.0);
    let climbed = pixels / tall;
    let wet = saturate(0.5 - pixels);
    let own = textureLoad(below, vec2u(in.position.xy), 0).rgb;
    let film = (1.0 - wet) * (1.0 - smoothstep(ALL_MIRRORED, 1.0, climbed));
    let dark = 1.0 - DARK_RIM * exp(-4.0 * climbed * climbed * select(1.0, 4.0, climbed < 0.0));
    let water = mirrored(in.position.x, in.position.y + pixels, saturate(climbed / ALL_MIRRORED));
    let off = (climbed - BRIGHT_RIM.x) / BRIGHT_RIM.y;
    let sky = RIM_LIGHT * exp(-off * off) * daylight_at(frame.light.z).sky / PI * frame.exposure;
    return vec4f((own * wet + water * film) * dark + sky * (1.0 - wet), wet + film);
}
