// What the alpha of the scene tells of a pixel: 1 of land and sky. What lies behind the sea has no air before it yet.
const INLAND_WATER = 2.0;      // most of it; lake.wgsl may lay the lake's mesh over it
const BEHIND_SEA = 0.0;        // where it lets nothing through
const BED = -1.0;              // under the sea: how much more light the waves have gathered there than a flat surface, of bed_light.wgsl, below 0

fn is_inland_water(scene: vec4f) -> bool { return scene.a == INLAND_WATER; }
fn is_behind_sea(scene: vec4f) -> bool { return scene.a <= BEHIND_SEA; }
fn gathered_on(scene: vec4f) -> f32 { return select(1.0, scene.a / BED, scene.a < BEHIND_SEA); }
