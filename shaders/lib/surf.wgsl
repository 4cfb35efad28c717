// Surf: where waves break on a shore, and how much of the water is white. Near the eye the waves are those of the trains.
#import world
#import shore_trains

// How far a front is ahead of its mean where the lobes' level is one, and how soon it is white, seconds; how much sooner crests break there.
const FRONT_LOBES: f32 = 0.3;
const FRONT_RISES: f32 = 0.1;
const FRONT_QUANTILES: f32 = 5.0;      // what the quantile of the share rises by where a front begins, from a hundredth and less to all
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

// Shares of the water under white water of any age (x), and under that of a crest that is just breaking (y): of the waves of the trains where
// these show, elsewhere and from afar the mean; and by how much the shares' quantiles differ within a pixel (z), where a front begins. `incoming`: `height_coming_in`. `lobes`: a normal level of the water, by which fronts run ahead here and
// stay behind there, and end raggedly along the crest.
fn surf_at(waves: ShoreWaves, shore: Metres, depth: Metres, incoming: Metres, footprint: Metres, lobes: f32) -> vec3f {
    let deep = max(depth, 0.05);
    let period = WHOLE_TURN / mean_omega();
    let celerity = sqrt(GRAVITY * deep);
    let lobe = clamp(lobes, -2.0, 2.0);
    // Wide pixels see a front rise before its instant and after it, and as much white as narrow ones do.
    let rises = clamp(6.0 * footprint / celerity, FRONT_RISES, 0.5 * period);
    let since = (waves.age + FRONT_LOBES * lobe + 0.5 * rises) / period;
    let risen = period * (since - floor(since));
    let front = smoothstep(0.0, rises, risen);
    let age = max(risen - 0.5 * rises, 0.0);
    let bore = saturate(waves.bore * (1.0 + ENDS_LOBES * lobe));
    let lasts = frame.surf.wy;
    let over = frame.surf.z * deep / max(0.7071 * incoming, 1e-3);
    // The mean of all waves of a Rayleigh distribution (J. Battjes and J. Janssen 1978).
    let breaking = exp(-over * over) * smoothstep(SURF_WIDEST, 0.5 * SURF_WIDEST, shore) * smoothstep(0.02, 0.15, incoming);
    let mean = breaking * lasts / frame.surf.x * (1.0 - exp(-frame.surf.x / lasts));
    // The white water of this crest, and of those before it, which have broken as often as those of this height do.
    let often = exp(-pow(frame.surf.z * deep / max(0.7071 * waves.height, 1e-3), 2.0));
    let older = exp(-(age + period) / lasts);
    // A wave that has just begun to break is white along its crest alone. Wider surf is white from where it begins, narrower less all over.
    let torn = min(frame.shore.y, 1.0) * pow(bore, 2.0 / max(frame.shore.y, 1.0));
    let crests = 1.0 - (1.0 - front * torn * exp(-age / (lasts * mix(0.15, 1.0, torn)))) * (1.0 - torn * often * older);
    let near = waves.share * (1.0 - smoothstep(0.06, 0.25, footprint / (celerity * period)));
    let blurred = FRONT_QUANTILES * footprint / (celerity * rises) * torn * 4.0 * front * (1.0 - front);
    return vec3f(mix(mean, crests, near), near * blurred);
}

// How much of the white water comes so near to the shore, which at the waterline strands; the water between two waves is clear there.
fn at_waterline(shore: Metres, lobes: f32) -> f32 { return mix(0.15, 1.0, smoothstep(0.0, STRANDS.x, shore + STRANDS.y * clamp(lobes, -1.0, 2.0))); }
