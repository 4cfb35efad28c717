// The roller of a crest that breaks: whitewater that rides down its front (I. Svendsen 1984), as thick as the share of young foam says, steep before, where the
// crest has just come, and flat behind. It stands out of the mesh, before what lies behind it.
#import foam
#import lace_net

// Its thickness, metres: of the least, and per metre of the waves' height, of which it has no more than so much.
const ROLLER = vec3f(0.15, 0.08, 4.0);
// How uneven it is by the lace's level, of its thickness, and how wide its lumps are at least, metres: narrower ones would be spikes.
const ROLLER_LUMPS = vec2f(0.4, 1.5);
const ROLLER_STEEPER: f32 = 1.8;    // than its share is its front, which the map's texels blur; ours
const ROLLER_NEAR: f32 = 0.25;     // of its distance from the eye, at most, lest it swallow an eye that rides on the waves
const ROLLER_WIDTHS = vec2f(1.0, 3.0); // of what breaks as one: spacings of vertices over which they lose it

fn roller_height() -> Metres { return ROLLER.x + ROLLER.y * min(frame.wave_height, ROLLER.z); }

// Its slope, x east and y north, where the share of young foam has a slope in the foam map's plane.
fn roller_slope(share: vec2f) -> vec2f {
    return ROLLER_STEEPER * roller_height() * (share.x * wave_cells[0].axis_x.xy + share.y * wave_cells[0].axis_y.xy);
}

// How much higher a vertex is that a roller stands on, `away` from the eye. `kept`: what depth and lee leave of the open sea's waves.
fn roller_at(rest: vec3f, away: Metres, spacing: Metres, height: Metres, local: f32, kept: f32) -> Metres {
    let distance = length(rest);
    let shown = 1.0 - smoothstep(ROLLER_WIDTHS.x, ROLLER_WIDTHS.y, spacing / frame.foam_levels[1].breaking);
    if shown <= 0.0 { return 0.0; }
    let up = normal_delta(rest) + vec3f(0.0, 0.0, 1.0);
    let grazing = max(abs(dot(rest, up)) / max(distance, 1e-3), 0.002);
    let at = foam_coordinates(rest);
    // As pixels see it.
    let young = foam_share(at, height, local, distance * frame.pixel_angle / pow(grazing, 0.65), true).young;
    let lumps = net(vec2i(4, -1), vec2i(512, 256), lace_texels(at), max(spacing, ROLLER_LUMPS.y)).level;
    return min(shown * min(kept, 1.0) * young * roller_height() * (1.0 + ROLLER_LUMPS.x * clamp(lumps, -2.0, 2.0)), ROLLER_NEAR * away);
}
