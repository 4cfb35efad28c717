// Sparkle: near the eye a pixel shows so few facets that those light it which happen to mirror the sun, not their mean. Their number is
// binomial (T. Deliot and L. Belcour 2023); its mean over the water and over time is the glitter's. Facets are not alike: their brightness
// is distributed exponentially, as speckle's is, and on half of the water they are larger and rarer.
#import foam
#import hash

const FACET: Metres = 0.015;
const MIRRORING: f32 = 0.5;        // of facets whose slopes are the most usual ones: they are curved, more so in rough water; ours
const FEWEST: f32 = 0.5;           // of facets that mirror the sun in a pixel: rarer ones would be single dots far off the sun's path
const MANY = vec2f(3e3, 1e4);      // from so many facets on their mean is seen
const LARGE: f32 = 0.5;            // share of the water with large facets, each two squares wide
const RARER: f32 = 0.25;           // and how many there are of them
const BY_NIGHT: f32 = 12.0;         // times as many are seen by moonlight: whoever sees so little light gathers it for longer
const TWINKLE = 16u;               // facets turn away after 2^16 ticks of the clock, 1/16 s

struct Facets {
    number: f32,
    chance: f32,           // evenly from 0 to 1: which part of such pixels this one belongs to
    luck: f32,             // of mean 0 and variance 1
    rare: f32,             // how many there are, of the usual number
    bright: f32,           // how bright a single one is, of mean 1
    turned: f32,           // how far its facets are turned to the eye just now, of mean 1 over time
}

// Facets of a pixel that shows their mean.
const MEAN_FACETS = Facets(1e9, 0.0, 0.0, 1.0, 1.0, 1.0);

// Facets of a pixel `across` wide whose middle lies at a place of the foam map's plane and sees the water under a sine of `grazing`.
fn facets_at(at: vec2f, across: Metres, grazing: f32) -> Facets {
    // Squares of the water at rest, as wide as the pixel or half as wide: a power of two of texels of the lace.
    let texels = lace_texels(at);
    let size = clamp(i32(floor(log2(across / frame.foam_levels[0].side))), -8, 8);
    let coarser = vec2u(u32(max(size, 0)));
    let finer = u32(max(-size, 0));
    let fine = texels * f32(1u << finer);
    let whole = (frame.lace_texel << vec2u(finer)) + vec2i(floor(fine));
    var square = whole >> coarser;
    // Four of them may be one, which is brightest in the middle.
    let four = hash(vec3u(bitcast<vec2u>(square >> vec2u(1u)), bitcast<u32>(size) ^ 0x1a46eu));
    let is_large = f32(four >> 8u) < LARGE * 16777216.0;
    let side = vec2i(2) << coarser;
    let inside = (vec2f(whole & (side - 1)) + fine - floor(fine)) / vec2f(side);
    let round = 6.0 * inside * (1.0 - inside);
    if is_large { square = (square >> vec2u(1u)) ^ vec2i(0x55555); }
    // Each square has a clock of its own.
    let own = hash(vec3u(bitcast<vec2u>(square), bitcast<u32>(size)));
    let clock = frame.clock + (own & 0xffffu);
    let found = hash(vec3u(own, clock >> TWINKLE, 0x5eau));
    let turned = 1.0 - cos(6.283185307179586 * f32(clock & 0xffffu) / 65536.0);
    // Distributed exponentially.
    let length = -log((f32(hash(vec3u(found, own, 0xb17u)) >> 8u) + 0.5) / 16777216.0);
    let bright = length * select(1.0, round.x * round.y, is_large);
    let luck = 2.0 * sqrt(3.0) * (f32(found & 0xfffu) / 4095.0 - 0.5);
    let number = across * across / (grazing * FACET * FACET) * mix(BY_NIGHT, 1.0, frame.by_day);
    return Facets(max(number, 1.0), f32(found >> 12u) / 1048576.0, luck, select(1.0, RARER, is_large), bright, turned);
}

// What the facets mirror, of the mean of facets of which slopes that mirror the sun have this chance.
fn sparkle(facets: Facets, chance: f32) -> f32 {
    let lit = max(facets.rare * facets.number * chance * MIRRORING, FEWEST);
    // Pixels with a facet that mirrors the sun, and how different these are.
    let some = 1.0 - exp(-lit);
    let spread = sqrt(max(some * (1.0 + 1.0 / lit) - 1.0, 0.0));
    let found = select(0.0, (1.0 + spread * facets.luck) / some, facets.chance < some);
    // Many do not turn away all at once.
    let own = mix(1.0, facets.bright * facets.turned, 1.0 / (1.0 + lit));
    return mix(found * own, 1.0, smoothstep(log(MANY.x), log(MANY.y), log(facets.number)));
}
