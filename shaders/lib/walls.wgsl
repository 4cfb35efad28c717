// Walls of rock, too steep for soil: stained down from where water runs over them, with plants on their ledges.
#import bed_cover

const LIMESTONE = vec3f(0.26, 0.245, 0.215);
const OCHRE = vec3f(0.25, 0.19, 0.125);   // where it is overhung and dry
const STAIN = vec3f(0.075, 0.078, 0.075); // of what grows where water runs
const WALLS_FROM = 1.6;          // slope from which on no soil holds
const WALL_LEDGES = 1.6;          // how much steeper it has to be on a ledge, of the noise that makes these

// Noise over a wall that faces `w` more to the east or west than to the north or south, at a height, in cells so wide along it and so high. Ways along it are not
// stretched but by whole numbers, as the pattern's square repeats.
fn wall_noise(place: vec2f, w: f32, height: Metres, stretched: vec2f, cell: Metres, salt: u32) -> f32 {
    return mix(bed_noise(vec2f(place.x, height) * stretched, cell, salt).z, bed_noise(vec2f(place.y, height) * stretched, cell, salt + 1u).z, w);
}

const WALL_CELLS = vec4f(64.0, 16.0, 4.0, 1.0);  // heights of its ledges
const WALL_PARTS = vec4f(0.0, 1.0, 0.6, 0.36);
const ROCK_PARTS = vec4f(0.9, 0.8, 0.6, 0.36);     // of other rock, whose layers are thicker than towers are

// How bare a slope is at a place, and the albedo of its rock, were it of a tower; ledges and what has run down of any other rock, whose means are none.
struct Wall { bare: f32, albedo: vec3f, layers: f32, streaks: f32 }

const NO_WALL = Wall(0.0, LIMESTONE, 0.0, 0.0);

fn wall_at(place: vec2f, slope: vec2f, height: Metres, footprint: Metres, none: bool) -> Wall {
    let steep = length(slope);
    let w = slope.x * slope.x / max(steep * steep, 1e-6);
    let seen = vec4f(shown(footprint, WALL_CELLS.x), shown(footprint, WALL_CELLS.y), shown(footprint, WALL_CELLS.z), shown(footprint, WALL_CELLS.w));
    let hidden = 0.2 * dot(WALL_PARTS, 1.0 - seen);
    var ledges = 0.0;
    var stains = 0.0;
    var layers = 0.0;
    var streaks = 0.0;
    var k = 0u;
    loop {
        let cell = WALL_CELLS[k];
        // Ledges are twice as wide as high, stains five times as high as wide.
        let ledge = seen[k] * wall_noise(place, w, height, vec2f(1.0, 2.0), 2.0 * cell, 97u + 4u * k);
        let stain = shown(footprint, 0.2 * cell) * wall_noise(place, w, height, vec2f(5.0, 1.0), cell, 99u + 4u * k);
        ledges += WALL_PARTS[k] * ledge;
        stains += WALL_PARTS[k] * stain;
        layers += ROCK_PARTS[k] * ledge;
        streaks += ROCK_PARTS[k] * stain;
        k++;
        if k == 4u || footprint > 0.6 * cell || none { break; }
    }
    let bare = select(smoothstep(-0.15 - WALL_LEDGES * hidden, 0.15 + WALL_LEDGES * hidden, steep - WALLS_FROM - WALL_LEDGES * ledges), 0.0, none);
    let rock = mix(LIMESTONE, OCHRE, smoothstep(0.05, 0.3, ledges));
    return Wall(bare, mix(rock * (1.0 + 1.2 * ledges), STAIN, 0.75 * smoothstep(0.0, 0.4, stains)), layers, streaks);
}
