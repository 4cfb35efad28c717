// Pixels among waves, which show more or less of the water at rest than on a level one. `area`: of it in the pixel, square metres, by the mesh.
#import frame

const FLATTEST = 50.0;         // how much more water a pixel may show on the back of a crest than on level water

// Footprint of a pixel on the back of a crest, which is seen flatter than level water: all that it adds to the area is along it.
fn behind_crest(footprint: Metres, area: f32) -> Metres { return footprint * pow(clamp(area / (footprint * footprint), 1.0, FLATTEST), 0.75); }

// How much less of the water than its footprint a pixel shows of a face that a wave turns to the eye.
fn faced_by_wave(footprint: Metres, area: f32) -> f32 { return clamp(sqrt(area) / footprint, 0.1, 1.0); }
