// Decks of clouds as wide pixels see them: cells of tens of kilometres, which tell how deep a deck is, and how its top leans.
#import clouds

// Numbers of decks are ours, but for the cells' width (E. Agee 1987: 10 to 40 km).
const DECK_CELLS: Metres = 26000.0;     // as wide are the cells of a deck, in the mean
const DECK_JITTER = 0.5;                // of a cell within which its middle lies
const DECK_REACH = 0.75;                // cells from its middle to where it ends: at most 1 - DECK_JITTER / 2, as only eight are looked at
const DECK_CREASE = 10.0;               // how narrow the creases between them are
const DECK_USUAL = vec2f(0.565, 0.21);  // mean and deviation of what they are at a place
const DECK_DETAIL = vec3f(13000.0, 5200.0, 2100.0);  // metres: cells of the noise on them
const DECK_BENT = vec3f(0.28, 0.07, 0.0);            // cells by which it bends them
const DECK_OPEN = vec2f(-0.2, 0.9);     // levels of the weather to which cells are open, thin within bright rims, and from which closed
const DECK_SMOOTH = vec3f(1.0, 2.2, 0.4);   // levels from which and at which decks are smoother, and how much of their cells these have
// Deviations of the logarithm of the depth, of the noise and of the cells: of sheets, of heaps, and how much of these open ones have.
const DECK_PARTS = vec4f(0.6, 0.4, 0.3, 0.75);
const DECK_PARTS_HEAPED = vec4f(0.4, 0.4, 0.25, 0.25);
const DECK_HEAPED = 0.3;
const DECK_CORES = vec2f(0.35, 1.0);    // by which it rises with the weather's level over the mean, and the less heaped they are
const DECK_MEAN = 1.2;

// How deep a deck is at a place, of its mean; and by how much its cells rise a metre, along the axes of `place`. Its cells are round about jittered
// middles, the deeper of two that meet. The loop ends at its foot.
fn deck_depth(weather: vec2f, place: vec3f, footprint: Metres) -> vec4f {
    let shown = 1.0 - smoothstep(vec4f(0.15), vec4f(0.6), footprint / vec4f(DECK_DETAIL, DECK_CELLS));
    let p = CLOUD_TURN * place;
    var finer = vec3f(cloud_noise(p / DECK_DETAIL.x, 31u), 0.0, 0.0);
    if shown.y > 0.0 { finer.y = cloud_noise(p / DECK_DETAIL.y, 32u); }
    if shown.z > 0.0 { finer.z = cloud_noise(p / DECK_DETAIL.z, 34u); }
    let at = p / DECK_CELLS + dot(DECK_BENT, finer) * vec3f(0.6, -0.64, 0.48) - 0.5;
    let low = floor(at);
    var sum = 0.0;
    var away = vec3f(0.0);
    var i = 0u;
    loop {
        let corner = vec3f(vec3u(i, i >> 1u, i >> 2u) & vec3u(1u));
        let word = hash(bitcast<vec3u>(vec3i(low + corner)) + vec3u(33u, 0u, 0x51edu));
        let middle = corner + DECK_JITTER * (vec3f(vec3u(word >> 22u, (word >> 12u) & 1023u, (word >> 2u) & 1023u)) / 1023.0 - 0.5);
        let apart = (at - low - middle) / DECK_REACH;
        let near = exp(DECK_CREASE * max(1.0 - dot(apart, apart), 0.0));
        away += (near - 1.0) * apart;
        sum += near;
        i++;
        if i == 8u { break; }
    }
    let heaps = heaped_share(weather);
    let closing = smoothstep(DECK_OPEN.x, DECK_OPEN.y, weather.x);
    let closed = 2.0 * closing - 1.0;
    let rough = mix(DECK_HEAPED, 1.0, closing) * mix(1.0, DECK_SMOOTH.z, smoothstep(DECK_SMOOTH.x, DECK_SMOOTH.y, weather.x));
    let parts = rough * mix(DECK_PARTS, DECK_PARTS_HEAPED, heaps) * shown;
    let cell = closed * (log(sum) / DECK_CREASE - DECK_USUAL.x) / DECK_USUAL.y;
    let core = closing * dot(DECK_CORES, vec2f(clamp(weather.x - DECK_MEAN, -1.2, 1.2), 0.5 - heaps));
    let depth = exp(core + dot(parts, vec4f(finer, cell)) - 0.5 * dot(parts, parts));
    let rise = -2.0 * closed * parts.w / (DECK_USUAL.y * DECK_REACH * DECK_CELLS) * away / sum;
    return vec4f(depth, transpose(CLOUD_TURN) * rise);
}
