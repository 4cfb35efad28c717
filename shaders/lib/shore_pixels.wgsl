// Pixels that the shore crosses. Who imports this declares MEASURED (src/pass/kind.rs).
#import world

// How much of a pixel is ocean, where the shore crosses it; a measured layer says what its middle is.
fn ocean_share(ground: Ground, footprint: Metres) -> f32 {
    if MEASURED { return select(0.0, 1.0, ground.is_ocean); }
    return saturate(0.5 + ground.ocean_shore / footprint);
}

// Depth of the ocean in a pixel, which its middle may miss: there as at a gentle shore.
fn ocean_depth(ground: Ground, footprint: Metres) -> Metres { return max(-ground.elevation, 0.01 * footprint * ocean_share(ground, footprint)); }
