// Foam's lace: from the share of the water that is covered to what a pixel sees. The tile of its level, which is standard normal, lies on
// the water in several sizes; their weighted sum g is normal, too. Where a share s is covered g lies above -quantile(s); what a pixel
// cannot show of g is a variance, so that means over the water do not depend on how wide pixels are. src/model/lace.rs has the reasons.
// Long, but one thing: each step takes what the one above it gives.
#import foam
#import foam_light
#import normal

@group(1) @binding(11) var lace: texture_2d<f32>;    // level, its slopes per texel, variance that a mip level keeps; see src/model/lace.rs

const LACE_TEXELS: f32 = 512.0;
const LACE_GREATEST_LEVEL: f32 = 3.5;
const LACE_GREATEST_SLOPE: f32 = 1.0;

// Where foam begins it is thin: with this opacity whitecaps reflect 0.22 where they cover little (P. Koepke 1984), thick ones FOAM_ALBEDO.
const THIN_FOAM: f32 = 0.4;
// of which half comes about at the water's edge and the rest by and by:
const FRINGE: f32 = 0.3;
const CORE_FROM: f32 = 0.6;
const CORE_RAMP: f32 = 0.9;
// Levels are deviations of g above the threshold. Widths of the edge of the water, of the passage to thick foam, and where that begins:
const EDGE_RAMP: f32 = 0.15;
const THICK_FROM: f32 = 1.45;
const THICK_RAMP: f32 = 0.35;
// Of young foam so much is dense: there are holes between its heaps.
const CLOSED: f32 = 0.7;
// Dense foam is whitest where it lies in heaps: from how much higher on, and how much of its opacity these are.
const HEAPED_FROM: f32 = 0.8;
const HEAPS: f32 = 0.4;
// The lip of dense foam shades the water before it: this wide, in deviations, and so much.
const SHADED: f32 = 0.6;
const SHADE: f32 = 0.45;
// The film: how much lower than foam it lies about it, the width of its edge, where two fifths of its opacity come about, and of the rest.
const FILM_AROUND: f32 = 0.5;
const FILM_EDGE: f32 = 0.2;
const FILM_RAMP: f32 = 0.8;
// Parts of the variance of g: those that rows along the wind have, from grade 8 on, in foam and in the film; of the rest each of the nets.
const ROWS = vec2f(0.45, 0.5);
const NETS = vec3f(0.42, 0.2, 0.38);
// Thin foam and film are rafts of bubbles with water between, on a net of their own: rafts' share of thin foam, and what is white of a raft
// in the film.
const RAFTS: f32 = 0.5;
const FILM_RAFT: f32 = 0.55;
const RAFT_EDGE: f32 = 0.3;
const FOAM_RISE: Metres = 0.06;      // height of thick foam over thin
const BUMPS_THIN: f32 = 0.4;     // of thin foam's bumps, of those of dense foam
const BUMPS = vec3f(0.022, 0.008, 0.004);   // and what levels of the nets add to that, metres

// The inverse of the normal distribution function, within 4.5e-4 (M. Abramowitz and I. Stegun 1964, 26.2.23).
fn normal_quantile(share: f32) -> f32 {
    let p = clamp(share, 1e-5, 0.99999);
    let t = sqrt(-2.0 * log(min(p, 1.0 - p)));
    let tail = t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    return select(tail, -tail, p < 0.5);
}

struct Net {
    level: f32,
    kept: f32,             // variance of the level; 1 where pixels are narrow
    slope: vec2f,          // per metre, along the wind and across it
}

// The tile, turned by a whole-numbered vector: `period` texels of the lace (0.25 m) over that vector's length are its sides. Powers of two
// wrap exactly, so that it stays in its place however far the eye goes. `texels`: the way from the corner of the eye's texel.
fn net(turn: vec2i, period: vec2i, texels: vec2f, footprint: Metres) -> Net {
    let eye = frame.lace_texel;
    let whole = vec2i(turn.x * eye.x - turn.y * eye.y, turn.y * eye.x + turn.x * eye.y) & (period - 1);
    let t = vec2f(turn);
    let way = vec2f(t.x * texels.x - t.y * texels.y, t.y * texels.x + t.x * texels.y);
    // Texels of the tile per metre.
    let scale = LACE_TEXELS * length(t) / (frame.foam_levels[0].side * vec2f(period));
    let lod = max(log2(footprint * scale.y), 0.0);
    let found = textureSampleLevel(lace, repeated, (vec2f(whole) + way) / vec2f(period), lod);
    let signed = (found.xyz * 255.0 - 128.0) / 127.0;
    let slope = LACE_GREATEST_SLOPE * signed.yz * scale;
    // Between two mip levels, which are not the same, some more is lost; fitted.
    let between = fract(lod);
    let kept = found.w * (1.0 - 0.4 * between * (1.0 - between) * (1.0 - found.w));
    let unit = t / length(t);
    return Net(LACE_GREATEST_LEVEL * signed.x, kept, vec2f(unit.x * slope.x + unit.y * slope.y, unit.x * slope.y - unit.y * slope.x));
}

// The film of bubbles that outlives whitecaps: its share of the water, where it drifts together into rows, and its opacity. Neither has been
// measured: ours give the first film at grade 6, marked rows at 8, and the white sea of 12.
fn film_share() -> f32 { return 1.0 - exp(-3.0 * frame.whitecaps); }
fn film_opacity() -> f32 { return (0.13 + 0.4 * frame.whitecaps) * smoothstep(0.012, 0.08, frame.whitecaps); }

// What a pixel sees of the lace: levels of foam (x) and of the film (y), and the variances that it hides of them.
struct Lace {
    level: vec2f,
    hidden: vec2f,
    slope: vec2f,          // of the foam's level, per metre, along the wind and across it
    rafts: vec2f,          // how much more than their mean a pixel shows of the rafts of thin foam and of film
    bumps: vec2f,          // slope of dense foam's surface, along the wind and across it
}

// Share of the film that has bubbles.
fn film_rafts() -> f32 { return clamp(film_opacity() / FILM_RAFT, 0.2, 0.9); }

// What a pixel shows of rafts that cover a share, over their mean.
fn rafts(bubbles: Net, share: f32) -> f32 {
    let above = bubbles.level + normal_quantile(share) * sqrt(1.0 + RAFT_EDGE * RAFT_EDGE);
    return normal_share(above * inverseSqrt(1.0 - bubbles.kept + RAFT_EDGE * RAFT_EDGE)) / share;
}

// The lace at a place of the foam map's plane.
fn lace_at(at: vec2f, footprint: Metres) -> Lace {
    let wind = wave_cells[0].wind;
    let along = vec2f(-wind.x * at.x - wind.y * at.y, wind.y * at.x - wind.x * at.y);
    let texels = frame.lace_fraction + along / frame.foam_levels[0].side;
    // Nets of 31 by 15, 4.4 by 2.2 and 81 by 40 m along the wind and across it, none of them turned like another; rows of 256 m, eight times as long along the wind.
    let middle = net(vec2i(4, -1), vec2i(512, 256), texels, footprint);
    let fine = net(vec2i(7, 2), vec2i(128, 64), texels, footprint);
    let coarse = net(vec2i(3, 1), vec2i(1024, 512), texels, footprint);
    let rows = net(vec2i(1, 0), vec2i(8192, 1024), texels, footprint);
    // And one of 1.57 m, for bubbles.
    let bubbles = net(vec2i(5, -1), vec2i(32), texels, footprint);
    let levels = vec4f(middle.level, fine.level, coarse.level, rows.level);
    let kept = vec4f(middle.kept, fine.kept, coarse.kept, rows.kept);
    // Squares of the weights, which sum to one.
    let parts = ROWS * smoothstep(0.015, 0.1, frame.whitecaps);
    let of_foam = vec4f((1.0 - parts.x) * NETS, parts.x);
    let of_film = vec4f((1.0 - parts.y) * NETS, parts.y);
    // Rows have no shape of their own.
    return Lace(vec2f(dot(sqrt(of_foam), levels), dot(sqrt(of_film), levels)), 1.0 - vec2f(dot(of_foam, kept), dot(of_film, kept)),
        mat3x2f(middle.slope, fine.slope, coarse.slope) * sqrt(of_foam.xyz),
        vec2f(rafts(bubbles, RAFTS), rafts(bubbles, film_rafts())), mat3x2f(middle.slope, fine.slope, bubbles.slope) * BUMPS);
}

// The lace where foam is drawn together by the folds of short waves, whose own level is normal, too: a share of its variance is theirs.
fn on_folds(seen: Lace, folds: vec2f, share: f32) -> Lace {
    var found = seen;
    found.level.x = sqrt(1.0 - share) * seen.level.x + sqrt(share) * folds.x;
    found.hidden.x = mix(seen.hidden.x, 1.0 - folds.y, share);
    return found;
}

// Above which level foam is dense: of young foam that covers a share, and where only the share of all foam is sought.
fn dense_from(young: f32) -> f32 { return -normal_quantile(CLOSED * young) * sqrt(1.0 + THICK_RAMP * THICK_RAMP); }
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
        dense = mix(thick, normal_share(rise - HEAPED_FROM * deviation), HEAPS);
    }
    // Where it is thick it is closed.
    return THIN_FOAM * thin * mix(rafts, 1.0, thick) + (1.0 - THIN_FOAM - film) * dense;
}

// Light that dense foam takes from the water beside it.
fn shade_of(rise: f32, thick: f32, deviation: f32, fine: bool) -> f32 {
    if !fine { return 0.0; }
    return SHADE * (normal_share(rise + SHADED * deviation) - thick);
}

// Foam that the lace makes of a share, dense from a level on; `calmed` is the part of the open sea's waves that the depth leaves.
fn foam_of(share: f32, dense_from: f32, calmed: f32, seen: Lace, fine: bool) -> Foam {
    let above = excess(share, seen.level.x);
    let film = film_opacity();
    let deviation = inverseSqrt(seen.hidden.x + THICK_RAMP * THICK_RAMP);
    let rise = (seen.level.x - dense_from) * deviation;
    let thick = normal_share(rise);
    let inside = covered(above, seen.hidden.x);
    let white = opacity(above, inside, seen.hidden.x, rise, thick, deviation, seen.rafts.x, film, fine);
    let threshold = max(normal_quantile(calmed * film_share()), normal_quantile(share) + FILM_AROUND);
    let filmed = threshold + seen.level.y;
    // Within thin foam the film lies between the rafts.
    let between = mix((1.0 - RAFTS * seen.rafts.x) / (1.0 - RAFTS), 1.0, thick);
    let faint = film * mix(seen.rafts.y, between, inside) * (0.4 * normal_share(filmed * inverseSqrt(seen.hidden.y + FILM_EDGE * FILM_EDGE))
        + 0.6 * normal_share((filmed - FILM_RAMP) * inverseSqrt(seen.hidden.y + FILM_RAMP * FILM_RAMP)));
    let plume = normal_share((above - 0.5 * seen.level.x - 1.0) * inverseSqrt(0.25 * seen.hidden.x + 1.0));
    // The foam rises where it becomes thick.
    let wind = wave_cells[0].wind;
    let axis_x = wave_cells[0].axis_x.xy;
    let axis_y = wave_cells[0].axis_y.xy;
    var tilt = FOAM_RISE * 0.4 * deviation * exp(-0.5 * min(rise * rise, 60.0)) * seen.slope;
    if fine { tilt += mix(BUMPS_THIN, 1.0, thick) * (1.0 - 0.6 * smoothstep(0.05, 0.25, frame.whitecaps)) * seen.bumps; }
    return Foam(white + faint, max(plume, 2.5 * min(faint, film)), shade_of(rise, thick, deviation, fine),
        tilt.x * (-wind.x * axis_x - wind.y * axis_y) + tilt.y * (wind.y * axis_x - wind.x * axis_y));
}

// Foam in pixels that hide all of the lace.
// It is foam_of where levels are hidden whole, with what is then known put in.
fn mean_foam(share: f32, dense_from: f32, calmed: f32, fine: bool) -> Foam {
    let quantile = normal_quantile(share);
    let above = quantile * sqrt(1.0 + EDGE_RAMP * EDGE_RAMP);
    let deviation = inverseSqrt(1.0 + THICK_RAMP * THICK_RAMP);
    let rise = -dense_from * deviation;
    let thick = normal_share(rise);
    let film = film_opacity();
    let white = opacity(above, share, 1.0, rise, thick, deviation, 1.0, film, fine);
    let threshold = max(normal_quantile(calmed * film_share()), quantile + FILM_AROUND);
    let faint = film * (0.4 * normal_share(threshold * inverseSqrt(1.0 + FILM_EDGE * FILM_EDGE))
        + 0.6 * normal_share((threshold - FILM_RAMP) * inverseSqrt(1.0 + FILM_RAMP * FILM_RAMP)));
    return Foam(white + faint, max(normal_share((above - 1.0) * inverseSqrt(1.25)), 2.5 * min(faint, film)), shade_of(rise, thick, deviation, fine),
        vec2f(0.0));
}
