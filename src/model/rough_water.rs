//! What a rough sea mirrors: the mean over the facets that an eye sees, for what is too small for a pixel.
//!
//! Slopes are Gaussian ([Cox and Munk](crate::bibliography::CoxMunk1954)) about a mean plane; facets count by the area that they show
//! to the eye, and those that turn away from it not at all ([Ross, Dion and Potter](crate::bibliography::Ross2005)).

use super::optics::{WATER_INDEX, fresnel};

/// Columns of the table, by the cosine of the view.
pub const COSINES: usize = 64;
/// Rows of the table, by the deviation of the slopes.
pub const DEVIATIONS: usize = 24;
/// Root of the lowest cosine in the table, less than zero: a mean plane that faces away from the eye has facets that do not.
const LOWEST_ROOT: f64 = -0.5;
/// The largest deviation in it.
const ROUGHEST: f64 = 0.6;
/// Points of the quadrature along the view, and across half of it.
const STEPS: [usize; 2] = [48, 8];
/// How many deviations of the slopes the quadrature reaches.
const REACH: f64 = 6.0;

/// The mean of what facets mirror towards the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanReflection {
    /// Fresnel's reflectance, 0…1.
    pub reflectance: f64,
    /// Sine of the elevation over the mean plane of what is mirrored, weighted with the reflectance.
    pub sine: f64,
}

/// The mean reflection of unpolarised light by facets about a mean plane that is seen under the cosine `cos_view`, −1…1, with slopes of
/// the deviation `sigma`, alike along the view and across it. What a facet mirrors from below the plane counts as if it came from as far
/// above: it has been mirrored before.
pub fn mean_reflection(cos_view: f64, sigma: f64) -> MeanReflection {
    let sigma = sigma.max(1e-6);
    let view_z = cos_view.clamp(-REACH * sigma / libm::hypot(1.0, REACH * sigma), 1.0);
    let view_h = (1.0 - view_z * view_z).sqrt();
    // Slopes along the view in deviations, from the steepest that is seen downwards to where next to none is left.
    let steepest = (view_z / (view_h * sigma).max(1e-12)).min(REACH);
    let span = steepest + libm::hypot(steepest, REACH);
    let most = steepest.min(0.0);
    let [mut area, mut mirrored, mut out, mut up] = [0.0; 4];
    for i in 0..STEPS[0] {
        let along = steepest - span * (i as f64 + 0.5) / STEPS[0] as f64;
        let density = libm::exp(0.5 * (most * most - along * along));
        let along = sigma * along;
        for j in 0..STEPS[1] {
            let across = 0.75 * REACH * (j as f64 + 0.5) / STEPS[1] as f64;
            let weight = density * libm::exp(-0.5 * across * across) * (view_z - view_h * along);
            let across = sigma * across;
            let normal_z = 1.0 / (1.0 + along * along + across * across).sqrt();
            let cosine = (view_z - view_h * along) * normal_z;
            let reflected = weight * fresnel(cosine, 1.0, WATER_INDEX).unpolarised();
            area += weight;
            mirrored += reflected;
            out += reflected * (view_h + 2.0 * cosine * along * normal_z);
            up += reflected * (2.0 * cosine * normal_z - view_z).abs();
        }
    }
    MeanReflection { reflectance: mirrored / area, sine: up / libm::hypot(up, out) }
}

/// [`mean_reflection`] for [`DEVIATIONS`] rows of [`COSINES`] columns, first to last texel's middle: column x, 0…1, is the cosine r·|r|
/// with r from −0.5 to 1; row y the deviation 0.6 y². As `rough_mirror` in `shaders/lib/brdf.wgsl` reads it.
pub fn table() -> Vec<MeanReflection> {
    let part = |i: usize, count: usize| i as f64 / (count - 1) as f64;
    let rows = (0..DEVIATIONS).map(|row| ROUGHEST * part(row, DEVIATIONS).powi(2));
    rows.flat_map(|sigma| {
        (0..COSINES).map(move |column| {
            let root = LOWEST_ROOT + (1.0 - LOWEST_ROOT) * part(column, COSINES);
            mean_reflection(root * root.abs(), sigma)
        })
    })
    .collect()
}
