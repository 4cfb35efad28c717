// Surf: where waves break on a shore, and how much of the water is white. Near the eye the waves are those of the trains.
#import world
#import shore_trains
#import lace

// How far a front is ahead of its mean where the lobes' level is one, and how soon it is white, seconds; how much sooner crests break there.
const FRONT_LOBES: f32 = 0.3;
const FRONT_RISES: f32 = 0.1;
const FRONT_QUANTILES: f32 = 1.5;      // deviation of the share's quantile, from a hundredth and less to all, within a pixel in which a front rises
const ENDS_LOBES: f32 = 0.35;
const STRANDS = vec2f(6.0, 2.5);      // metres of the waterline within which foam thins, and how raggedly: `lobes`
const SURF_WIDEST: Metres = 1500.0;   // no shore is so far from its surf

// Height of the waves that come in to a shore at a place. For vertices: it changes slowly.
fn height_coming_in(sea: LocalSea, distance: Metres) -> Metres {
    // Far away it goes by and by: pictures whose shores are farther have none.
    let farthest = SURF_SEEN + 2.0 * max(frame.eye_altitude, 0.0);
    let seen = smoothstep(farthest, 0.6 * farthest, distance) * smoothstep(SURF_HIGHEST, 0.6 * SURF_HIGHEST, frame.eye_altitude);
    return seen * frame.wave_height * sea.height;
}

// Cosines of the angle between waves' way and that to the shore below which they do not break, and from which as shoals have it. Bottoms turn waves to the shore; those that
// run along it, past a headland, spread out over what bends away from them: there rows of crests would stand out from the land like a comb's teeth. Ours.
const ASHORE = vec2f(0.4, 0.8);

// How far waves break that go a way (east, north), where the distance to the shore grows so right and down on the map; by where a shore is far on two sides it tells nothing.
fn comes_ashore(way: vec2f, rise: vec2f) -> f32 {
    let slope = length(rise);
    let towards = dot(way, vec2f(-rise.x, rise.y)) / max(slope, 1e-3);
    return mix(1.0, smoothstep(ASHORE.x, ASHORE.y, towards), smoothstep(0.3, 0.7, slope));
}

// A front covers all of the water, what it leaves behind so much at first: else no water is seen between one crest and the next. Ours.
const LACE_LEFT: f32 = 0.4;

fn with_lace(shares: vec2f) -> vec2f { return vec2f(mix(shares.y, shares.x, LACE_LEFT), shares.y); }

// Shares of the water under white water of any age (x), of what is dense no longer `LACE_LEFT`, and under that of a crest that is just breaking (y): of the waves of the trains where
// these show, elsewhere and from afar the mean; and by how much the shares' quantiles differ within a pixel (z), where a front begins. `incoming`: `height_coming_in`.
// `width`: of the pixel across the crests. `lobes`: a normal level of the water, by which fronts run ahead here and stay behind there, and end raggedly along the crest.
fn surf_at(waves: ShoreWaves, shore: Metres, depth: Metres, incoming: Metres, width: Metres, lobes: f32) -> vec3f {
    let deep = max(depth, 0.05);
    let period = WHOLE_TURN / mean_omega();
    let celerity = sqrt(GRAVITY * deep);
    let lobe = clamp(lobes, -2.0, 2.0);
    // Wide pixels see a front rise before its instant and after it, and as much white as narrow ones do.
    let rises = clamp(3.0 * width / celerity, FRONT_RISES, 0.5 * period);
    let since = (waves.age + FRONT_LOBES * lobe + 0.5 * rises) / period;
    let risen = period * (since - floor(since));
    let front = smoothstep(0.0, rises, risen);
    let age = max(risen - 0.5 * rises, 0.0);
    let bore = saturate(waves.white * (1.0 + ENDS_LOBES * lobe));
    let lasts = frame.surf.wy;
    let over = frame.surf.z * deep / max(0.7071 * incoming, 1e-3);
    // The mean of all waves of a Rayleigh distribution (J. Battjes and J. Janssen 1978).
    let breaking = exp(-over * over) * smoothstep(SURF_WIDEST, 0.5 * SURF_WIDEST, shore) * smoothstep(0.02, 0.15, incoming);
    let mean = breaking * with_lace(lasts / frame.surf.x * (1.0 - exp(-frame.surf.x / lasts)));
    // The white water of this crest, and of those before it, which have broken as often as those of this height do.
    let often = exp(-pow(frame.surf.z * deep / max(0.7071 * waves.height, 1e-3), 2.0));
    let older = exp(-(age + period) / lasts);
    // A wave that has just begun to break is white along its crest alone. Wider surf is white from where it begins, narrower less all over.
    let torn = min(frame.shore.y, 1.0) * pow(bore, 2.0 / max(frame.shore.y, 1.0));
    let crests = 1.0 - (1.0 - front * torn * with_lace(exp(-age / (lasts * mix(0.15, 1.0, torn))))) * (1.0 - torn * often * with_lace(older));
    let near = min(waves.share, 1.0) * (1.0 - smoothstep(0.12, 0.4, width / (celerity * period)));
    let blurred = FRONT_QUANTILES * width / (celerity * rises) * torn * 4.0 * front * (1.0 - front);
    return vec3f(mix(mean, crests, near), near * blurred);
}

// How much of the white water comes so near to the shore, which at the waterline strands; the water between two waves is clear there.
fn at_waterline(shore: Metres, lobes: f32) -> f32 { return mix(0.15, 1.0, smoothstep(0.0, STRANDS.x, shore + STRANDS.y * clamp(lobes, -1.0, 2.0))); }

const OF_SURF: f32 = 0.8;             // part of the variance of surf's foam that its own nets have, which are finer; and of that, the wider one's: ours
const OF_WIDE: f32 = 0.6;

// The lace where a part of the foam is surf's: what rollers leave has not been drawn out by the wind. The sea's nets, as wide as crests are apart and long along the
// wind, would cut its lines into flecks.
fn in_surf(seen: Lace, at: vec2f, footprint: Metres, part: f32) -> Lace {
    let texels = lace_texels(at);
    // Of 17.6 m and 5.5 m.
    let froth = both(net(vec2i(5, -3), vec2i(128), texels, footprint), net(vec2i(7, 2), vec2i(512), texels, footprint), OF_WIDE);
    let own = OF_SURF * saturate(part);
    var found = seen;
    let level = sqrt(1.0 - own) * seen.level + sqrt(own) * froth.level;
    let hidden = mix(seen.hidden, vec3f(1.0 - froth.kept), own);
    found.level = vec3f(level.x, seen.level.y, level.z);
    found.hidden = vec3f(hidden.x, seen.hidden.y, hidden.z);
    return found;
}
