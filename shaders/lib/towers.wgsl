// Towers of limestone that stand on drowned hills of the tropics, as src/model/towers.rs: see there what they are.
#import map
#import noise

// How high they stand at a place, 0 to 1 and a little more where two meet, and how that rises right and down on the map, a cell.
struct Towers { height: f32, rise: vec2f }

// The loop ends at its foot: where none are it is gone through once. The noise before it is not worth a branch.
fn towers_at(at: vec2u, footprint: Metres, none: bool) -> Towers {
    let cell = at >> vec2u(TOWERS_BITS);
    let f = vec2f(at & vec2u((1u << TOWERS_BITS) - 1u)) / f32(1u << TOWERS_BITS);
    let mask = (1u << (32u - TOWERS_BITS)) - 1u;
    let wide = map_noise_rise(at, 33u - TOWERS_BITS, 91u);
    let fine = (1.0 - smoothstep(TOWERS_ROUGH_SEEN.x, TOWERS_ROUGH_SEEN.y, footprint)) * map_noise_rise(at, 35u - TOWERS_BITS, 92u);
    let rough = TOWERS_ROUGH.x * wide.x + TOWERS_ROUGH.y * fine.x;
    let rough_rise = 2.0 * TOWERS_ROUGH.x * wide.yz + 8.0 * TOWERS_ROUGH.y * fine.yz;
    var sum = 0.0;
    var rise = vec2f(0.0);
    var k = 0u;
    loop {
        let step = vec2u(k % 3u, k / 3u) - 1u;
        let word = hash(vec3u((cell + step) & vec2u(mask), 93u));
        let bytes = vec4f((vec4u(word) >> vec4u(0u, 8u, 16u, 24u)) & vec4u(255u)) / 255.0;
        let rest = vec4f((vec4u(word) >> vec4u(0u, 8u, 16u, 24u)) & vec4u(15u)) / 16.0;
        let off = f - vec2f(bitcast<vec2i>(step)) - 0.5 - TOWERS_ASIDE * (bytes.xy - 0.5);
        let radius = mix(TOWERS_WIDE.x, TOWERS_WIDE.y, bytes.z);
        let long = mix(TOWERS_LONG.x, TOWERS_LONG.y, rest.z);
        let turned = rest.xy - vec2f(0.5, 0.499);
        let way = normalize(turned);
        let along = dot(off, way);
        let across = dot(off, vec2f(-way.y, way.x));
        let q = (along * along / long + across * across * long) / (radius * radius) + rough;
        let q_rise = 2.0 * (along / long * way + across * long * vec2f(-way.y, way.x)) / (radius * radius) + rough_rise;
        let tall = mix(TOWERS_TALL.x, TOWERS_TALL.y, bytes.w);
        let left = max(1.0 - q * abs(q), 0.0);
        let own = tall * left * sqrt(left);
        let own_rise = -3.0 * tall * sqrt(left) * abs(q) * q_rise;
        sum += own * own * own * own;
        rise += own * own * own * own_rise;
        k++;
        if k == 9u || none { break; }
    }
    let height = sqrt(sqrt(sum));
    return Towers(height, rise / max(height * height * height, 1e-12));
}
