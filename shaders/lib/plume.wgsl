// Spindrift is made of plumes of drops, each torn off a breaking crest; src/pass/spindrift.rs has the reasons. `PLUME_SIDE` is declared there.
#import frame

struct Plume {
    base: vec3f,           // where it leaves the crest
    strength: f32,         // its opacity where it is densest; 0: there is none
    light: vec3f,          // radiance of drops so dense that nothing is seen through them, through the air before them
    seed: f32,             // of its shape, 0…1
    size: vec2f,           // its length along the wind and its width, metres
    unused: vec2f,
}

// Unit vector that the wind blows to, as in all of the nearest wave cell.
fn downwind() -> vec3f {
    let wind = wave_cells[0].wind;
    return normalize(-wind.x * wave_cells[0].axis_x - wind.y * wave_cells[0].axis_y);
}
