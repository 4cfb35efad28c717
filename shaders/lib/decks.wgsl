// Decks of clouds as wide pixels see them: cells of tens of kilometres, which tell how deep a deck is, and how its top leans.
#import clouds

// Numbers of decks are ours, but for the cells' width (E. Agee 1987: 10 to 40 km).
const DECK_CELLS: Metres = 26000.0;     // as wide are the cells of a deck, in the mean
const DECK_JITTER = 0.5;                // of a cell within which its middle lies
const DECK_REACH = 0.75;                // cells from its middle to where it ends: at most 1 - DECK_JITTER / 2, as only eight are looked at
const DECK_CREASE = 10.0;               // how narrow the creases between them are
const DECK_USUAL = vec2f(0.565, 0.21);  // mean and deviation of what they are at a place
const DECK_DETAIL = vec4f(70000.0, 16000.0, 5200.0, 2100.0);  // metres: cells of the noise on them
const DECK_BENT = vec2f(0.5, 0.28);     // cells by which the second bends those of a deck, and the first all others, of its own
const DECK_OPEN = vec2f(-0.2, 0.9);     // levels of the weather to which cells are open, thin within bright rims, and from which closed
const DECK_COLD = vec2f(0.5, 0.65);     // sines of the latitude from which cells may be open, and from which they are
const DECK_CELLED = vec2f(0.45, 0.9);   // kinds of clouds from which on there are cells, and from which there is nothing else
const DECK_SMOOTH = vec2f(0.4, 1.0);   // how much of all but the first of the noise sheets have that are smooth, and that are not
// Deviations of the logarithm of the depth, of the noise and of the cells.
const DECK_PARTS = vec4f(0.45, 0.4, 0.4, 0.4);
const DECK_CELL = 0.35;
const DECK_CORES = vec2f(0.7, 0.5);    // by which it rises with the weather's level over the mean, and the less heaped they are
const DECK_MEAN = 1.2;

// How deep a deck is at a place, of its mean; and by how much its cells rise a metre, along the axes of `place`. Its cells are round about jittered
// middles, the deeper of two that meet. The loop ends at its foot.
fn deck_depth(weather: vec2f, place: vec3f, footprint: Metres) -> vec4f {
    let shown = 1.0 - smoothstep(vec4f(0.15), vec4f(0.6), vec4f(footprint) / DECK_DETAIL);
    let celled = smoothstep(DECK_CELLED.x, DECK_CELLED.y, cloud_kind(weather, 1.6));
    let rough = mix(DECK_SMOOTH.x, DECK_SMOOTH.y, smoothstep(0.2, 0.8, cloud_kind(weather, 3.6)));
    let long = drawn_out(place);
    var noise = vec4f(cloud_noise(long / DECK_DETAIL.x, 30u), 0.0, 0.0, 0.0);
    let bent = DECK_BENT.x * DECK_DETAIL.x * noise.x * CLOUD_BENT;
    if shown.y > 0.0 { noise.y = cloud_noise((long + bent) / DECK_DETAIL.y, 31u); }
    if shown.z > 0.0 { noise.z = cloud_noise((place + DECK_BENT.x * DECK_DETAIL.y * noise.y * CLOUD_BENT) / DECK_DETAIL.z, 32u); }
    if shown.w > 0.0 { noise.w = cloud_noise(place / DECK_DETAIL.w, 34u); }
    let parts = DECK_PARTS * shown * vec4f(1.0, vec3f(rough));
    let closing = smoothstep(DECK_OPEN.x, DECK_OPEN.y, weather.x);
    let cold = smoothstep(DECK_COLD.x, DECK_COLD.y, abs(place.z) / length(place));
    let cells = DECK_CELL * celled * (1.0 - smoothstep(0.15, 0.6, footprint / DECK_CELLS)) * mix(-cold, 1.0, closing);
    var cell = 0.0;
    var rise = vec3f(0.0);
    if abs(cells) > 0.0 {
        let at = (CLOUD_TURN * (place + bent)) / DECK_CELLS + DECK_BENT.y * noise.y * vec3f(0.6, -0.64, 0.48);
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
        cell = (log(sum) / DECK_CREASE - DECK_USUAL.x) / DECK_USUAL.y;
        rise = transpose(CLOUD_TURN) * (-2.0 * cells / (DECK_USUAL.y * DECK_REACH * DECK_CELLS) * away / sum);
    }
    let core = closing * dot(DECK_CORES, vec2f(clamp(weather.x - DECK_MEAN, -1.2, 1.2), 0.5 - heaped_share(weather)));
    let depth = exp(core + dot(parts, noise) + cells * cell - 0.5 * (dot(parts, parts) + cells * cells));
    return vec4f(depth, rise);
}
