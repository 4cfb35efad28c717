// Foam's lace: from the share of the water that is covered to what a pixel sees. The tile of its level, which is standard normal, lies on
// the water in several sizes, bent; their weighted sum g is normal, too. Where a share s is covered g lies above -quantile(s); what a pixel
// cannot show of g is a variance, so that means over the water do not depend on how wide pixels are. src/model/lace.rs has the reasons.
// Long, but one thing: each step takes what the one above it gives.
#import foam
#import foam_light
#import lace_net
#import normal

// Whether storms have drawn foam out along the wind.
#usually STORM = true;

// Where foam begins it is thin: with this opacity whitecaps reflect 0.22 where they cover little (P. Koepke 1984), thick ones FOAM_ALBEDO.
const THIN_FOAM: f32 = 0.4;
// of which so much comes about at the water's edge, and the rest by and by:
const FRINGE: f32 = 0.6;
const CORE_FROM: f32 = 0.45;
const CORE_RAMP: f32 = 0.3;
// Levels are deviations of g above the threshold. Widths of the edge of the water, of the passage to thick foam, and where that begins:
const EDGE_RAMP: f32 = 0.15;
const THICK_FROM: f32 = 1.45;
const THICK_RAMP: f32 = 0.25;
// Of young foam so much is dense: there are holes between its heaps.
const CLOSED: f32 = 0.7;
const FRESH_CLOSED: f32 = 0.88;   // and what has just broken has fewer
// Dense foam is whitest in its midst: from how much higher on, and how much of its opacity that is.
const MIDST_FROM: f32 = 0.8;
const MIDST: f32 = 0.2;
// The lip of dense foam shades the water before it: this wide, in deviations, and so much.
const SHADED: f32 = 0.35;
const SHADE: f32 = 0.6;
const OVERHANGS: f32 = 1.0;       // and by how much wider the front of what breaks shades it
// A crest that breaks is a front: where foam is so young, of all that is there, its share rises so many times as steeply from water to white, about
// a share that leaves its mean.
const FRESH = vec2f(0.38, 0.95);
const FRONT_STEEPER: f32 = 1.5;
const FRONT_AT: f32 = 0.42;
const FRONTS_IN = vec2f(0.8, 3.0);   // significant wave heights at which none are, and all: crests of small waves break over less than the map tells apart, metres
// Its face is darker than its top, which the sky lights from all sides: by how much, and deviations of its level over which.
const FRONT_FACE: f32 = 0.3;
const FRONT_FACE_RISES: f32 = 1.6;
// What tumbles has larger lumps than foam that lies, by so much, and its edge has lobes, of so much of its level's variance.
const TUMBLED: f32 = 1.6;
const LOBES: f32 = 0.5;
// The film begins where foam ends: the width of its edge, from how much higher it is thick, the width of the passage to that, and the part
// of its opacity that comes about at its edge: little, that there is dark water between streaks.
const FILM_EDGE: f32 = 0.08;
const FILM_THICK: f32 = 0.5;
const FILM_RAMP: f32 = 0.42;
const FILM_FAINT: f32 = 0.12;
// Parts of the variance of g: those that rows along the wind have, from grade 8 on, in foam and in the film; of the rest each of the nets, below storms and in
// them, where streaks count most.
const ROWS = vec2f(0.35, 0.3);
const NETS = vec3f(0.42, 0.2, 0.38);
const STORM_NETS = vec3f(0.62, 0.1, 0.28);
// Storms draw foam out along the wind: parts of the middle net that streaks have then, in foam and in the film, and shares of the water that break at which
// it begins and ends.
const STREAKED = vec2f(0.55, 0.9);
const STREAKED_IN = vec2f(0.05, 0.2);
// Gusts have whitened one stretch of a stormy sea more than the next: the part of the rows' variance that a net of hundreds of metres takes then, in foam and in
// the film. Rows that are everywhere as dense would be hair.
const GUSTED = vec2f(0.25, 0.5);
// Near the eye the nets take turns: by so much their parts differ, in exponents, from one stretch of the water to the next, and so far, in
// texels, they are bent over stretches of 32, 8 and 2 m. A sum of equals would be speckles of one size; bent any more they would fold.
const TURNS = vec3f(1.6, 1.8, 1.6);
const BENDS = vec3f(8.0, 4.0, 0.9);
// Rows wind: by so many texels across the wind, over stretches of 256 and 32 m; streaks over 256, 32, 8 and 2 m. Straight ones would be grain of wood.
const ROWS_WIND = vec2f(100.0, 20.0);
const STREAKS_WIND = vec4f(110.0, 22.0, 6.5, 1.6);
// They fork, join and end: along the wind streaks are drawn by so many texels over stretches of 32, 8 and 2 m, each beside the next.
const STREAKS_END = vec3f(90.0, 40.0, 6.0);
const WINDING: f32 = 0.45;        // deviation of `wander`
// Nor are they evenly spaced, as teeth of a comb: over rectangles of 128 by 32 m rows and streaks are drawn apart and together, by so many texels at most, and
// streaks take so much more or less of the middle net.
const UNEVEN = vec2u(9u, 7u);
const UNEVENLY = vec2f(22.0, 24.0);
const UNEVEN_STREAKS: f32 = 0.8;
// Young foam lies together in masses as wide as a crest breaks: parts of its variance that the widest net has in high waves, and the rows.
const MASSES: f32 = 0.45;
const MASSES_IN = vec2f(0.5, 5.0);   // significant wave heights at which it has none of that, and all, metres
const MASSES_IN_ROWS: f32 = 0.05;
// Thin foam and film are rafts of bubbles with water between, on a net of their own: rafts' share of thin foam, and what is white of a raft
// in the film.
const RAFTS: f32 = 0.5;
const FILM_RAFT: f32 = 0.7;
const RAFT_EDGE: f32 = 0.15;
// How plainly rafts show, of thin foam that covers little and much of the water, and of the film, in winds below storms and in these.
const RAFTS_SHOW = vec4f(0.8, 0.7, 0.9, 0.85);
// Dense foam is heaps with creases between them, along the walls of the nets: how much of these is whose, and how dark the deepest of them are: none is a crack.
const CREASES = vec4f(0.4, 0.6, 0.15, 0.7);
const CREASE: f32 = 0.3;
// What storms break is metres deep: heaps of the wider nets count more, which are seen from a ship's bridge, and their creases are deeper.
const STORM_CREASES = vec4f(0.7, 0.5, 0.6, 0.45);
const STORM_CREASE: f32 = 0.42;
const STORM_SKEW: f32 = 0.1;       // of a deviation: the wider nets have more of heaps than of creases, and are to leave the mean
const CREASE_ENDS: f32 = 0.3;      // of their depth squared, by which they end: the deepest are half as bright as foam without, in storms a fifth
// Of a deviation by which rafts of film, which gather along those walls, have more of them than the sea, below storms and in them.
const FILM_CREASED = vec2f(0.5, 0.4);
const BODY = vec2f(0.45, 0.9);     // opacities from which on foam of any kind has these, and at which it has all of their depth
// Height of dense foam over thin, metres: of the least, and per metre of the waves' height, of which it has no more than so much.
const FOAM_RISE = vec3f(0.08, 0.035, 8.0);
// Below foam and film there are bubbles in the water: so many times their opacity.
const BUBBLES_BELOW: f32 = 2.0;
// Storms stir them into all of the water under the film: so much of a plume's; ours.
const STIRRED: f32 = 0.75;
// Levels of the nets are hollows of dense foam, ridges of thin: metres, and thin foam's part of them.
const BUMPS = vec3f(0.12, 0.035, 0.012);
const STORM_BUMPS = vec3f(0.6, 0.1, 0.014);
const BUMPS_THIN: f32 = 0.15;

// The inverse of the normal distribution function, within 4.5e-4 (M. Abramowitz and I. Stegun 1964, 26.2.23).
fn normal_quantile(share: f32) -> f32 {
    let p = clamp(share, 1e-5, 0.99999);
    let t = sqrt(-2.0 * log(min(p, 1.0 - p)));
    let tail = t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    return select(tail, -tail, p < 0.5);
}

// What a pixel sees of the lace: levels of foam (x), of the film (y) and of dense foam (z), and the variances that it hides of them.
struct Lace {
    level: vec3f,
    hidden: vec3f,
    slope: vec2f,          // of dense foam's level, per metre, along the wind and across it
    rafts: vec2f,          // how much more than their mean a pixel shows of the rafts of thin foam and of film
    bumps: vec2f,          // slope of dense foam's surface, along the wind and across it
    crease: f32,           // how deep dense foam's creases are, of mean 0 wherever it lies, about normal
    fresh: f32,            // how much of it has just broken, 0…1
}

// Share of the film that has bubbles.
fn film_rafts() -> f32 { return max(frame.film.y / FILM_RAFT, 0.2); }

// What a pixel shows of rafts that cover a share, over their mean.
fn rafts(bubbles: Net, share: f32) -> f32 {
    let above = bubbles.level + normal_quantile(share) * sqrt(1.0 + RAFT_EDGE * RAFT_EDGE);
    return normal_share(above * inverseSqrt(1.0 - bubbles.kept + RAFT_EDGE * RAFT_EDGE)) / share;
}

// Two nets as one, of which the second has a share of the variance.
fn both(a: Net, b: Net, share: f32) -> Net {
    let weights = sqrt(vec2f(1.0 - share, share));
    return Net(dot(weights, vec2f(a.level, b.level)), mix(a.kept, b.kept, share), weights.x * a.slope + weights.y * b.slope);
}

// How far storms have drawn foam out along the wind, 0…1.
fn storm() -> f32 {
    if !STORM { return 0.0; }
    return smoothstep(STREAKED_IN.x, STREAKED_IN.y, frame.whitecaps);
}

// Share of the water that storms have filled with bubbles where no foam is, by what depth and lee leave of the waves' height.
fn stirred(height: f32) -> f32 { return STIRRED * storm() * height * frame.film.x; }

// The lace at a place of the foam map's plane, `finer` times as small as on the open water, with relief of the same steepness.
fn lace_at(at: vec2f, footprint: Metres, finer: i32, fine: bool) -> Lace {
    return lace_in(at, footprint, vec2f(footprint), finer, fine);
}

// `pixel`: how long it is along the wind and across it, for streaks.
fn lace_in(at: vec2f, footprint: Metres, pixel: vec2f, finer: i32, fine: bool) -> Lace {
    let texels = lace_texels(at);
    var bent = texels;
    var in_rows = texels;
    var in_streaks = texels;
    var of_streaks = pixel;
    var nets = mix(NETS, STORM_NETS, storm());
    var streaked = STREAKED * storm();
    if fine {
        let far = wander(texels, 7u);
        let near = wander(texels, 5u);
        let next = wander(texels, 3u);
        bent += BENDS.x * far + BENDS.y * near + BENDS.z * next;
        let wide = wander(texels, 10u).y;
        let uneven = wander_along(texels, UNEVEN);
        in_rows.y += dot(ROWS_WIND, vec2f(wide, far.x)) + UNEVENLY.x * uneven.x;
        in_streaks += vec2f(dot(STREAKS_END, vec3f(far.y, near.y, next.y)), dot(STREAKS_WIND, vec4f(wide, far.x, near.x, next.x)) + UNEVENLY.y * uneven.x);
        // Long pixels span streaks that wind within them.
        of_streaks.y += WINDING * frame.foam_levels[0].side * dot(STREAKS_WIND, min(pixel.x / vec4f(256.0, 32.0, 8.0, 2.0), vec4f(1.0)));
        streaked = min(streaked * (1.0 + UNEVEN_STREAKS * uneven.y), vec2f(1.0));
        nets *= exp(TURNS * vec3f(near.x, far.x, near.y));
        nets /= nets.x + nets.y + nets.z;
    }
    // Nets of 31 by 15, 4.4 by 2.2 and 81 by 40 m along the wind and across it, none of them turned like another; rows of 128 m, 16 times as long along the
    // wind.
    let heaps = net(finer * vec2i(4, -1), vec2i(512, 256), bent, footprint);
    let small = net(finer * vec2i(7, 2), vec2i(128, 64), bent, footprint);
    let coarse = net(finer * vec2i(3, 1), vec2i(1024, 512), bent, footprint);
    let rows = net_along(finer * vec2i(2, 0), vec2i(16384, 1024), in_rows, pixel);
    // And one of 1.57 m, for bubbles.
    let bubbles = net(finer * vec2i(5, -1), vec2i(32), bent, footprint);
    // Storms draw out what is old; what breaks tumbles.
    var middle = heaps;
    var of_film_middle = heaps;
    var foam_rows = rows;
    var film_rows = rows;
    if storm() > 0.0 {
        // Of 1490 by 47 m.
        let streaks = net_along(finer * vec2i(11, 0), vec2i(65536, 2048), in_streaks, of_streaks);
        middle = both(heaps, streaks, streaked.x);
        of_film_middle = both(heaps, streaks, streaked.y);
        // Of 2.6 by 1.3 km, turned as no other is: levels of one tile that lie in step are not independent.
        let gusted = net_along(finer * vec2i(3, -1), vec2i(32768, 16384), in_rows, pixel);
        foam_rows = both(rows, gusted, GUSTED.x * storm());
        film_rows = both(rows, gusted, GUSTED.y * storm());
    }
    let levels = vec4f(middle.level, small.level, coarse.level, foam_rows.level);
    let kept = vec4f(middle.kept, small.kept, coarse.kept, foam_rows.kept);
    let film_levels = vec4f(of_film_middle.level, levels.yz, film_rows.level);
    let film_kept = vec4f(of_film_middle.kept, kept.yz, film_rows.kept);
    // Squares of the weights, which sum to one.
    let parts = ROWS * smoothstep(0.015, 0.1, frame.whitecaps);
    let of_foam = vec4f((1.0 - parts.x) * nets, parts.x);
    let of_film = vec4f((1.0 - parts.y) * nets, parts.y);
    var of_dense = of_foam;
    if fine {
        let masses = MASSES * smoothstep(MASSES_IN.x, MASSES_IN.y, frame.wave_height);
        let rest = 1.0 - MASSES_IN_ROWS - masses;
        of_dense = vec4f(0.8 * rest, 0.2 * rest, masses, MASSES_IN_ROWS);
    }
    let weights = sqrt(of_dense);
    let dense_levels = vec4f(heaps.level, levels.yzw);
    let dense = dot(weights, dense_levels);
    // What creases have in common with the level of dense foam, as a pixel sees both, would darken its midst.
    let creases = mix(CREASES, STORM_CREASES, storm());
    let dense_kept = vec4f(heaps.kept, kept.yzw);
    let in_dense = dot(weights.xyz, creases.xyz);
    let seen_in_dense = dot(weights.xyz * dense_kept.xyz, creases.xyz) / max(dot(of_dense, dense_kept), 1e-4);
    let crease = (dot(creases.xyz, dense_levels.xyz) + creases.w * bubbles.level - seen_in_dense * dense) * inverseSqrt(dot(creases, creases) - in_dense * in_dense);
    // Rows have no shape of their own.
    return Lace(vec3f(dot(sqrt(of_foam), levels), dot(sqrt(of_film), film_levels), dense),
        1.0 - vec3f(dot(of_foam, kept), dot(of_film, film_kept), dot(of_dense, dense_kept)),
        mat3x2f(heaps.slope, small.slope, coarse.slope) * weights.xyz / f32(finer), vec2f(rafts(bubbles, RAFTS), rafts(bubbles, film_rafts())),
        mat3x2f(heaps.slope, small.slope, bubbles.slope) * mix(BUMPS, STORM_BUMPS, storm()) / f32(finer), crease, 0.0);
}

// Where the foam map is asked for a place of the water: fronts run ahead in some places and fall back in others, over widths of 8 and 2 m, by so many widths of
// what breaks as one, as far as a footprint shows them.
const RAGGED_FRONTS = vec2f(0.8, 0.3);

fn ragged(at: vec2f, footprint: Metres) -> vec2f {
    let texels = lace_texels(at);
    let seen = RAGGED_FRONTS * vec2f(1.0 - smoothstep(1.6, 4.8, footprint), 1.0 - smoothstep(0.4, 1.2, footprint));
    return at + frame.foam_levels[1].breaking * (seen.x * wander(texels, 5u).x + seen.y * wander(texels, 3u).x) * wave_cells[0].wind;
}

// How far foam of which so much is young has just been made.
fn freshness(shares: vec2f) -> f32 {
    return smoothstep(FRESH.x, FRESH.y, shares.y / max(shares.x, 1e-3)) * smoothstep(FRONTS_IN.x, FRONTS_IN.y, frame.wave_height);
}

// A share as the front of what breaks has it.
fn fronted(share: f32, fresh: f32) -> f32 {
    return normal_share(mix(1.0, FRONT_STEEPER, fresh) * normal_quantile(share) - fresh * FRONT_STEEPER * normal_quantile(FRONT_AT));
}

// The lace where so much foam is fresh, whose young share has a slope in the foam map's plane: that steepens the edge of dense foam.
fn on_front(seen: Lace, young: f32, slope: vec2f, fresh: f32) -> Lace {
    var found = seen;
    let wind = wave_cells[0].wind;
    let quantile = normal_quantile(young);
    // Of the share's quantile, whose slope is the share's over the normal density.
    let steep = fresh * FRONT_STEEPER * 2.5066 * exp(0.5 * min(quantile * quantile, 6.0)) * slope;
    found.slope += vec2f(-wind.x * steep.x - wind.y * steep.y, wind.y * steep.x - wind.x * steep.y);
    let lobes = LOBES * fresh * (1.0 - seen.hidden.z);
    found.level.z = sqrt(1.0 - lobes) * seen.level.z + sqrt(lobes) * seen.crease;
    found.fresh = fresh;
    return found;
}

// How much the height of the water decides where the film lies, and shares of the water under it at which that begins and ends: a thin one is grey all over.
const ON_CRESTS = 0.22;
const CRESTED_IN = vec2f(0.35, 0.6);
const FOLDED = 0.15;           // how much the folds of short waves decide where foam lies

// The lace where foam is drawn together by the folds of short waves, whose own level is normal, too: a share of its variance is theirs.
fn on_folds(seen: Lace, folds: vec2f, share: f32) -> Lace {
    var found = seen;
    found.level.x = sqrt(1.0 - share) * seen.level.x + sqrt(share) * folds.x;
    found.hidden.x = mix(seen.hidden.x, 1.0 - folds.y, share);
    return found;
}

// The film where crests gather it: a share of the variance of its level is that of the water's height, here in deviations, of which pixels show
// `kept`.
fn on_crests(seen: Lace, deviations: f32, kept: f32) -> Lace {
    let share = ON_CRESTS * smoothstep(CRESTED_IN.x, CRESTED_IN.y, frame.film.x);
    var found = seen;
    found.level.y = sqrt(1.0 - share) * seen.level.y + sqrt(share) * kept * clamp(deviations, -3.0, 3.0);
    found.hidden.y = mix(seen.hidden.y, 1.0 - kept * kept, share);
    return found;
}

// Above which level foam is dense: of young foam that covers a share, and where only the share of all foam is sought.
fn dense_from(young: f32) -> f32 { return fresh_dense_from(young, 0.0); }
fn fresh_dense_from(young: f32, fresh: f32) -> f32 { return -normal_quantile(mix(CLOSED, FRESH_CLOSED, fresh) * young) * sqrt(1.0 + THICK_RAMP * THICK_RAMP); }
fn usually_dense_from(share: f32) -> f32 { return THICK_FROM - excess(share, 0.0); }
fn mean_dense_from(share: f32, fine: bool) -> f32 {
    if fine { return dense_from(usual_young(share)); }
    return usually_dense_from(share);
}

// How far levels lie above those of the water's edge where a share is covered; its edges spread by EDGE_RAMP.
fn excess(share: f32, level: f32) -> f32 {
    return level + normal_quantile(share) * sqrt(1.0 + EDGE_RAMP * EDGE_RAMP);
}

// Share of a pixel under foam of any kind but the film.
fn covered(excess: f32, hidden: f32) -> f32 {
    return normal_share(excess * inverseSqrt(hidden + EDGE_RAMP * EDGE_RAMP));
}

// Opacity of foam by itself. `rise` is how far it lies above the level from which it is dense, in parts that `deviation` makes of levels. Only in
// `fine` pictures it comes about by and by, and in heaps.
fn opacity(excess: f32, inside: f32, hidden: f32, rise: f32, thick: f32, deviation: f32, rafts: f32, film: f32, fine: bool) -> f32 {
    var thin = inside;
    var dense = thick;
    if fine {
        thin = mix(normal_share((excess - CORE_FROM) * inverseSqrt(hidden + CORE_RAMP * CORE_RAMP)), inside, FRINGE);
        dense = mix(thick, normal_share(rise - MIDST_FROM * deviation), MIDST);
    }
    // Where it is thick it is closed.
    return THIN_FOAM * thin * mix(rafts, 1.0, thick) + (1.0 - THIN_FOAM - film) * dense;
}

// Light that dense foam takes from the water beside it.
fn shade_of(rise: f32, thick: f32, deviation: f32, fresh: f32, fine: bool) -> f32 {
    if !fine { return 0.0; }
    return SHADE * (normal_share(rise + SHADED * (1.0 + OVERHANGS * fresh) * deviation) - thick);
}

// What is seen of rafts where foam covers a share, and of the film's.
fn shown_rafts(share: f32, rafts: vec2f, fine: bool) -> vec2f {
    if !fine { return rafts; }
    return mix(vec2f(1.0), rafts, vec2f(mix(RAFTS_SHOW.x, RAFTS_SHOW.y, smoothstep(0.03, 0.3, share)), mix(RAFTS_SHOW.z, RAFTS_SHOW.w, storm())));
}

// Foam that the lace makes of a share, dense from a level on; `height` is what depth and lee leave of the open sea's.
fn foam_of(share: f32, dense_from: f32, height: f32, seen: Lace, fine: bool) -> Foam {
    let above = excess(share, seen.level.x);
    let film = frame.film.y;
    let deviation = inverseSqrt(seen.hidden.z + THICK_RAMP * THICK_RAMP);
    let rise = (seen.level.z - dense_from) * deviation;
    let thick = normal_share(rise);
    let inside = covered(above, seen.hidden.x);
    let rafts = shown_rafts(share, seen.rafts, fine);
    let white = opacity(above, inside, seen.hidden.x, rise, thick, deviation, rafts.x, film, fine);
    let threshold = max(normal_quantile(height * frame.film.x), normal_quantile(share));
    let filmed = threshold + seen.level.y;
    // Within foam it has no rafts of its own. Were it only between those of thin foam, both together would be a flat sheet.
    let faint = film * mix(rafts.y, 1.0, inside) * (FILM_FAINT * normal_share(filmed * inverseSqrt(seen.hidden.y + FILM_EDGE * FILM_EDGE))
        + (1.0 - FILM_FAINT) * normal_share((filmed - FILM_THICK) * inverseSqrt(seen.hidden.y + FILM_RAMP * FILM_RAMP)));
    let plume = normal_share((above - 0.5 * seen.level.x - 1.0) * inverseSqrt(0.25 * seen.hidden.x + 1.0));
    // The foam rises where it becomes thick.
    let wind = wave_cells[0].wind;
    let axis_x = wave_cells[0].axis_x.xy;
    let axis_y = wave_cells[0].axis_y.xy;
    let thickness = FOAM_RISE.x + FOAM_RISE.y * min(frame.wave_height, FOAM_RISE.z);
    var tilt = thickness * 0.4 * deviation * exp(-0.5 * min(rise * rise, 60.0)) * seen.slope;
    var open = 1.0;
    // Rafts among film may be as thick as dense foam, and are no whiter.
    let opaque = min(white + faint, 1.0);
    if fine {
        // They have its shape, too.
        let body = max(thick, smoothstep(BODY.x, BODY.y, white + faint));
        tilt += mix(BUMPS_THIN, -1.0 - TUMBLED * seen.fresh * thick, body) * seen.bumps;
        let deep = seen.crease * inverseSqrt(1.0 + CREASE_ENDS * seen.crease * seen.crease);
        let skew = STORM_SKEW * storm() * (1.0 - seen.hidden.z);
        open -= mix(CREASE, STORM_CREASE, storm()) * (body * deep + thick * skew - (body - thick) * mix(FILM_CREASED.x, FILM_CREASED.y, storm()) * (1.0 - seen.hidden.y));
        open *= 1.0 + FRONT_FACE * seen.fresh * (saturate(rise / (deviation * FRONT_FACE_RISES)) - 0.75);
    }
    return Foam(opaque, open, max(max(plume, stirred(height)), saturate(BUBBLES_BELOW * opaque)), shade_of(rise, thick, deviation, seen.fresh, fine),
        tilt.x * (-wind.x * axis_x - wind.y * axis_y) + tilt.y * (wind.y * axis_x - wind.x * axis_y));
}

// Foam in pixels that hide all of the lace.
// It is foam_of where levels are hidden whole, with what is then known put in.
fn mean_foam(share: f32, dense_from: f32, height: f32, fine: bool) -> Foam {
    let quantile = normal_quantile(share);
    let above = quantile * sqrt(1.0 + EDGE_RAMP * EDGE_RAMP);
    let deviation = inverseSqrt(1.0 + THICK_RAMP * THICK_RAMP);
    let rise = -dense_from * deviation;
    let thick = normal_share(rise);
    let film = frame.film.y;
    let white = opacity(above, share, 1.0, rise, thick, deviation, 1.0, film, fine);
    let threshold = max(normal_quantile(height * frame.film.x), quantile);
    let faint = film * (FILM_FAINT * normal_share(threshold * inverseSqrt(1.0 + FILM_EDGE * FILM_EDGE))
        + (1.0 - FILM_FAINT) * normal_share((threshold - FILM_THICK) * inverseSqrt(1.0 + FILM_RAMP * FILM_RAMP)));
    // Bubbles are hidden where foam is dense.
    let bubbles = saturate(0.5 * share + BUBBLES_BELOW * faint);
    return Foam(white + faint, 1.0, max(max(normal_share((above - 1.0) * inverseSqrt(1.25)), stirred(height)), bubbles), shade_of(rise, thick, deviation, 0.0, fine),
        vec2f(0.0));
}
