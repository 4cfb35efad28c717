// Walls of rock, too steep for soil: stained down from where water runs over them, with plants on their ledges.
#import bed_cover

const LIMESTONE = vec3f(0.26, 0.245, 0.215);
const OCHRE = vec3f(0.25, 0.19, 0.125);   // where it is overhung and dry
const STAIN = vec3f(0.075, 0.078, 0.075); // of what grows where water runs
const WALLS_FROM = 1.6;          // slope from which on no soil holds
const WALL_LEDGES = 1.6;          // how much steeper it has to be on a ledge, of the noise that makes these

// Noise over a wall that faces `w` more to the east or west than to the north or south, at a height: `flat` times as wide as high.
fn wall_noise(place: vec2f, w: f32, height: Metres, flat: f32, cell: Metres, salt: u32) -> f32 {
    return mix(bed_noise(vec2f(place.x / flat, height), cell, salt).z, bed_noise(vec2f(place.y / flat, height), cell, salt + 1u).z, w);
}

// How bare a slope is at a place, and the albedo of its rock.
struct Wall { bare: f32, albedo: vec3f }

fn wall_at(place: vec2f, slope: vec2f, height: Metres, footprint: Metres, none: bool) -> Wall {
    let steep = length(slope);
    let w = slope.x * slope.x / max(steep * steep, 1e-6);
    var ledges = 0.0;
    var hidden = 0.0;
    var stains = 0.0;
    var share = 1.0;
    var cell = 16.0;
    var salt = 101u;
    loop {
        let seen = shown(footprint, cell);
        hidden += 0.2 * share * (1.0 - seen);
        ledges += share * seen * wall_noise(place, w, height, 2.5, cell, salt);
        stains += share * seen * wall_noise(place, w, height, 0.2, cell, salt + 2u);
        share *= 0.6;
        cell *= 0.25;
        salt += 4u;
        if cell < 0.9 || footprint > 0.6 * cell || none { break; }
    }
    let bare = select(smoothstep(-0.15 - WALL_LEDGES * hidden, 0.15 + WALL_LEDGES * hidden, steep - WALLS_FROM - WALL_LEDGES * ledges), 0.0, none);
    let rock = mix(LIMESTONE, OCHRE, smoothstep(0.05, 0.3, ledges));
    return Wall(bare, mix(rock * (1.0 + 1.2 * ledges), STAIN, 0.75 * smoothstep(0.0, 0.4, stains)));
}
