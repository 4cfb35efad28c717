//! The shape of the ground near a coast: a coarse elevation made to agree with a sharp shoreline.
//!
//! Elevation grids are minutes of arc wide, the shoreline is known to hundreds of metres. Near the shore the grid's cell mixes
//! land and sea, so its value is trusted only from one cell's width on; closer, the distance to the shore shapes the ground.

/// Hermite's smooth step: 0 below `a`, 1 above `b`.
pub fn smoothstep(a: f64, b: f64, x: f64) -> f64 {
    let t = if b > a { ((x - a) / (b - a)).clamp(0.0, 1.0) } else { f64::from(x >= a) };
    t * t * (3.0 - 2.0 * t)
}

/// Least depth of the ocean, metres: within a cell's width of the shore, and farther off.
const LEAST_M: [f64; 2] = [30.0, 4.0];

/// How far the bed falls from a shore at most, metres per metre, unless the user says otherwise.
pub const USUAL_SLOPE: f64 = 0.03;

/// As [`shaped_on`], on beaches of the [`USUAL_SLOPE`].
pub fn shaped_elevation(elevation_m: f64, ocean_shore_m: f64, resolution_m: f64) -> f64 {
    shaped_on(elevation_m, ocean_shore_m, resolution_m, USUAL_SLOPE)
}

/// Elevation in metres, shaped so that it is below zero in the ocean and meets zero at the shore.
///
/// * `elevation_m`: the grid's value.
/// * `ocean_shore_m`: signed distance to the ocean's shore, positive in the ocean.
/// * `resolution_m`: how wide a cell of the elevation's source is.
/// * `slope`: how far the bed falls from the shore at most, at least 0.01.
///
/// In the ocean the bed falls at most by the slope from the shore until the grid can be trusted, and at least by a third of that (1 %) down to 30 m, so that
/// water is never without depth, and narrow fjords, which the grid takes for land, are no shoals. Farther off than a cell the grid's banks are as shallow as
/// it has them, down to 4 m. Land rises likewise, from 1 % up to 2 m; ground below sea level (polders, the Dead Sea) stays
/// below, and meets zero at the ocean's shore.
pub fn shaped_on(elevation_m: f64, ocean_shore_m: f64, resolution_m: f64, slope: f64) -> f64 {
    let (r, d) = (resolution_m, ocean_shore_m.abs());
    if ocean_shore_m > 0.0 {
        let raw = (-elevation_m).max(0.0);
        let near = raw.min(slope * d);
        let depth = near + (raw - near) * smoothstep(0.0, r, d);
        let least = LEAST_M[0] + (LEAST_M[1] - LEAST_M[0]) * smoothstep(0.7 * r, 1.3 * r, d);
        return -depth.max((slope / 3.0 * d).min(least));
    }
    let scaled = elevation_m * smoothstep(0.0, r / 3.0, d);
    if elevation_m >= 0.0 { scaled.max((0.01 * d).min(2.0)) } else { scaled }
}
