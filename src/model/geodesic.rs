//! Distance over the surface, for the scale bar and for measuring.

use super::earth::Ellipsoid;
use crate::error::{Error, Result};

/// Length of the shortest path over the ellipsoid between two places, m. Angles are radians, latitudes geodetic.
///
/// [Vincenty's inverse series](crate::bibliography::Vincenty1975): good to about 0.1 mm on the earth wherever it converges
/// ([Karney](crate::bibliography::Karney2013), section 1). It does not converge within about half a degree of the antipode,
/// farther than any scale bar reaches.
///
/// # Errors
/// [`Error::BadValue`] for angles that are not finite and for nearly antipodal places.
pub fn surface_distance(ellipsoid: Ellipsoid, from: (f64, f64), to: (f64, f64)) -> Result<f64> {
    let refuse = |remedy: &str| Err(Error::bad_value("places", format!("{from:?} to {to:?}"), remedy));
    let Ellipsoid { a, b } = ellipsoid;
    if ![from.0, from.1, to.0, to.1].iter().all(|angle| angle.is_finite()) {
        return refuse("give finite angles");
    }
    let f = (a - b) / a;
    let turn = std::f64::consts::TAU;
    let l = (to.1 - from.1 + turn / 2.0).rem_euclid(turn) - turn / 2.0;
    // Reduced latitudes by atan2, which stays exact at the poles.
    let reduced = |lat: f64| (b * lat.sin()).atan2(a * lat.cos());
    let ((sin_u1, cos_u1), (sin_u2, cos_u2)) = (reduced(from.0).sin_cos(), reduced(to.0).sin_cos());
    let mut lambda = l;
    for _ in 0..200 {
        let (sin_l, cos_l) = lambda.sin_cos();
        let sin_sigma = (cos_u2 * sin_l).hypot(cos_u1 * sin_u2 - sin_u1 * cos_u2 * cos_l);
        if sin_sigma == 0.0 && cos_l > 0.0 {
            return Ok(0.0);
        }
        let cos_sigma = sin_u1 * sin_u2 + cos_u1 * cos_u2 * cos_l;
        let sigma = sin_sigma.atan2(cos_sigma);
        let sin_alpha = if sin_sigma == 0.0 { 0.0 } else { cos_u1 * cos_u2 * sin_l / sin_sigma };
        let cos2_alpha = 1.0 - sin_alpha * sin_alpha;
        // On the equator cos²α is 0 and the term it divides has no effect.
        let cos_2sm = if cos2_alpha > 1e-15 { cos_sigma - 2.0 * sin_u1 * sin_u2 / cos2_alpha } else { 0.0 };
        let c = f / 16.0 * cos2_alpha * (4.0 + f * (4.0 - 3.0 * cos2_alpha));
        let bracket = cos_2sm + c * cos_sigma * (2.0 * cos_2sm * cos_2sm - 1.0);
        let next = l + (1.0 - c) * f * sin_alpha * (sigma + c * sin_sigma * bracket);
        if next.abs() > std::f64::consts::PI {
            break;
        }
        // 1e-13 rad is 0.6 µm on the earth.
        if (next - lambda).abs() < 1e-13 {
            let u2 = cos2_alpha * (a - b) * (a + b) / (b * b);
            let big_a = 1.0 + u2 / 16384.0 * (4096.0 + u2 * (-768.0 + u2 * (320.0 - 175.0 * u2)));
            let big_b = u2 / 1024.0 * (256.0 + u2 * (-128.0 + u2 * (74.0 - 47.0 * u2)));
            let q = 2.0 * cos_2sm * cos_2sm - 1.0;
            let r = big_b / 6.0 * cos_2sm * (4.0 * sin_sigma * sin_sigma - 3.0) * (4.0 * cos_2sm * cos_2sm - 3.0);
            let delta_sigma = big_b * sin_sigma * (cos_2sm + big_b / 4.0 * (cos_sigma * q - r));
            return Ok(b * big_a * (sigma - delta_sigma));
        }
        lambda = next;
    }
    refuse("the places are nearly antipodal; measure in two parts")
}
