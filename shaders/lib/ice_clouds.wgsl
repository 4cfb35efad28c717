// Clouds of ice at a place of the same field: cirrus, and the shields that deep clouds spread at their tops.
#import clouds

const ICE_TUFTS = vec2f(26000.0, 9000.0);       // metres: cells of the tufts
const ICE_TUFTED = vec2f(0.35, 0.27);           // deviations
const ICE_FLOCKS: Metres = 85000.0;             // and of the flocks that they come in,
const ICE_FLOCKED = 0.36;
const ICE_TRAILS = vec2f(1500.0, 350.0);        // metres by which each bends the fibres that fall from it
const ICE_FIBRES: Metres = 4000.0;              // as far apart are the widest
const ICE_FIBROUS = 0.22;                       // variance of the logarithm of the depth, of the widest
const ICE_WIND: Metres = 34000.0;               // by which the wind bends them
// Where there is much ice it is a veil: how far fibres show there, of all; and how much more in one stretch than in the next, in exponents, of cells so wide.
const ICE_VEILED = 0.3;
const ICE_COMBED = 0.5;
const ICE_STRETCH: Metres = 45000.0;
// Deep clouds spread out at their tops: levels of water clouds from which on they do, less in the tropics, where each stands alone; optical depth for a
// deviation above it, of what stands over them, but for the edges, and of what the wind takes from there, and how far that is.
const ANVIL_FROM = vec2f(0.9, 1.3);
const ANVIL_TUFTED = vec2f(0.35, 0.25);
const ANVIL_DEPTH = vec2f(3.0, 0.5);
const ANVIL_THIN = 0.4;              // deviations above it: what stands over them thins out towards its edges, and small ones are thin all over
const ANVIL_FRINGES: Metres = 3500.0; // how wide the fringes of their edges are,
const ANVIL_FRAYED = 0.2;            // and how far these reach, deviations
const ANVIL_WIND: Metres = 55000.0;   // by which the wind bends them
const ANVIL_BLOWN: Metres = 90000.0;
const ANVIL_LEFT = 0.35;
const ANVIL_TORN = vec3f(9000.0, -14000.0, 12000.0);

// How much of what goes on over a cell a footprint shows: fibres are lines, and lines that are not wider than the pixels of the sky's sketch are rows of dots.
fn ice_shown(footprint: Metres, cell: Metres) -> f32 { return 1.0 - smoothstep(0.05, 0.25, footprint / cell); }

// Optical depth of ice clouds straight up at a place: tufts, from which fibres trail, drawn out along the parallels but bent by the wind and by
// each tuft its own way, since ice falls from it into other winds. They are many times as dense as the gaps between them.
fn ice_optical_depth(place: vec3f, footprint: Metres) -> f32 {
    let winds = vec3f(cloud_noise(place / 300000.0, 11u), cloud_noise(place / 300000.0, 12u), cloud_noise(place / 250000.0, 13u));
    let wind = place + ICE_WIND * winds;
    let tufts = vec2f(ice_shown(footprint, ICE_TUFTS.x), ice_shown(footprint, ICE_TUFTS.y))
        * vec2f(cloud_noise(wind * vec3f(0.5, 0.5, 1.0) / ICE_TUFTS.x, 14u), cloud_noise(wind * vec3f(0.6, 0.6, 1.0) / ICE_TUFTS.y, 15u));
    let flock = ice_shown(footprint, ICE_FLOCKS) * cloud_noise(wind * vec3f(0.5, 0.5, 1.0) / ICE_FLOCKS, 31u);
    let trails = (wind + vec3f(0.0, 0.0, dot(ICE_TRAILS, tufts))) * vec3f(0.06, 0.06, 1.0);
    let above = max(cloud_weather(place).y + dot(ICE_TUFTED, tufts) + ICE_FLOCKED * flock, 0.0);
    let sin_lat = place.z / length(place);
    // What the wind draws out of their shields is longer.
    let shield = vec2f(tufts.x, ice_shown(footprint, ICE_TUFTS.y) * cloud_noise(wind * vec3f(0.3, 0.3, 1.0) / ICE_TUFTS.y, 16u));
    let frayed = ice_shown(footprint, ANVIL_FRINGES) * cloud_noise(wind * vec3f(0.4, 0.4, 1.0) / ANVIL_FRINGES, 17u);
    let from_level = dot(ANVIL_TUFTED, shield) + ANVIL_FRAYED * frayed - max(frame.cloud_shift, 0.0)
        - mix(ANVIL_FROM.x, ANVIL_FROM.y, smoothstep(0.2, 0.6, abs(sin_lat)));
    let west = normalize(vec3f(place.y, -place.x, 1.0));
    // Where all is overcast no more of them are deep.
    let torn = place + ANVIL_WIND * winds + ANVIL_TORN * tufts.x;
    let anvil = max(vec2f(cloud_weather(torn).x, cloud_weather(torn + ANVIL_BLOWN * west).x - ANVIL_LEFT) + from_level, vec2f(0.0));
    let combed = mix(1.0, ICE_VEILED, smoothstep(0.0, 1.2, above)) * exp(ICE_COMBED * cloud_noise(wind / ICE_STRETCH, 18u));
    var dense = 0.0;
    var cell = ICE_FIBRES;
    var part = ICE_FIBROUS;
    var i = 0u;
    loop {
        let shown = combed * ice_shown(footprint, cell);
        // The fibres' mean is 1, for every footprint.
        dense += sqrt(part) * shown * cloud_noise(trails / cell, 20u + i) - 0.5 * part * shown * shown;
        cell *= 0.4;
        part *= 0.95;
        i++;
        if i == 6u || footprint >= 0.25 * cell { break; }
    }
    let fibrous = exp(dense);
    return fibrous * (0.22 * above * above / (1.0 + 0.5 * above) + ANVIL_DEPTH.y * anvil.y) + ANVIL_DEPTH.x * anvil.x * anvil.x / (anvil.x + ANVIL_THIN) * mix(fibrous, 1.0, 0.7 * saturate(anvil.x));
}
