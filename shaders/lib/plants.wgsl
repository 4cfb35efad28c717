// What stands on the ground, seen from above: crowns of trees where it is green, shrubs and boulders here and there where it is bare. Round caps of
// their own sizes, at most one in a cell.
#import noise

// Of the caps: how high the highest is, about its mean over the plane, and its rise a cell right and down.
struct Caps { height: f32, rise: vec2f }

const CAP_ASIDE: f32 = 0.28;       // how far a cap stands off the middle of its cell at most, of a cell
const CAP_LEAST: f32 = 0.45;       // least of a cap's radius, of the greatest

// Caps of a share of a level's cells, `radius` of a cell wide. Those of four cells reach a place.
fn caps(at: vec2u, level: u32, share: f32, radius: f32) -> Caps {
    let shift = 32u - level;
    let half = 1u << (shift - 1u);
    let first = (at - half) >> vec2u(shift);
    let f = vec2f((at - half) & vec2u((1u << shift) - 1u)) / f32(1u << shift);
    var found = Caps(0.0, vec2f(0.0));
    for (var i = 0u; i < 4u; i++) {
        let step = vec2u(i & 1u, i >> 1u);
        let cell = (first + step) & vec2u((1u << level) - 1u);
        let word = hash(vec3u(cell, 60u + level));
        let aside = vec2f(f32(word & 0xffu), f32((word >> 8u) & 0xffu)) / 127.5 - 1.0;
        let size = radius * (CAP_LEAST + (1.0 - CAP_LEAST) * f32((word >> 16u) & 0xffu) / 255.0);
        let off = f - vec2f(step) - CAP_ASIDE * aside;
        let height = 1.0 - dot(off, off) / (size * size);
        let stands = f32(word >> 24u) < 256.0 * share && height > found.height;
        found.height = select(found.height, height, stands);
        found.rise = select(found.rise, -2.0 * off / (size * size), stands);
    }
    // The mean of independent caps, of their area a cell: within 2 % of a sum over a million places, for radii up to 0.68.
    let area = share * PI * radius * radius * (1.0 + CAP_LEAST + CAP_LEAST * CAP_LEAST) / 3.0;
    return Caps(found.height - area * (0.5 - 0.04 * area), found.rise);
}

const TREES = 22u;                 // level whose cells they have: 9.5 m at the equator
const SHRUBS = 24u;
const GROVES = 20u;                // of the noise of what grows together
const RAGGED = 24u;                // of the noise that bends their outlines
const TOO_NEAR = vec2f(0.02, 0.2); // widths of pixels, metres, between which caps go: from among them they would be discs on the ground

// Caps on ground that is so `green`, and has so much more on it than the ground around (`fertile`, about 0).
fn plants(at: vec2u, green: f32, fertile: f32, footprint: Metres) -> Caps {
    let share = clamp(mix(0.16, 0.85, green) + mix(0.30, 0.35, green) * fertile, 0.02, 0.98);
    let radius = mix(0.26, 0.68, green) * (1.0 + 0.25 * clamp(fertile, -1.0, 0.0));
    let seen = 1.0 - smoothstep(vec2f(0.25), vec2f(0.7), footprint * exp2(vec2f(f32(TREES), f32(SHRUBS))) / EARTH_TURN);
    let far = smoothstep(TOO_NEAR.x, TOO_NEAR.y, footprint);
    // No outline is round.
    let bend = map_noise_rise(at, RAGGED, RAGGED).yz;
    let bent = at + bitcast<vec2u>(vec2i(0.4 * bend * exp2(32.0 - f32(RAGGED))));
    let trees = caps(bent, TREES, share, radius);
    let shrubs = caps(bent, SHRUBS, share, radius);
    // Small ones fill what stands between trees; groves of one kind are brighter than others.
    let small = far * seen.y * mix(0.6, 0.35, green);
    let kind = 1.0 + 1.2 * (map_noise(at, GROVES, GROVES) - 0.5);
    let tall = far * seen.x;
    return Caps(kind * tall * trees.height + small * shrubs.height, tall * trees.rise + small * shrubs.rise);
}
