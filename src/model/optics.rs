//! Light at and under the water's surface, and how rough that surface is to light.

/// Refractive index of sea water for visible light.
pub const WATER_INDEX: f64 = 1.333;

/// Reflectances of a plane boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reflectance {
    /// Perpendicular to the plane of incidence.
    pub s: f64,
    /// Parallel to it.
    pub p: f64,
}

impl Reflectance {
    /// For unpolarised light: the mean.
    pub fn unpolarised(self) -> f64 {
        0.5 * (self.s + self.p)
    }
}

/// [Fresnel's](crate::bibliography::BornWolf1999) reflectances for light in index `n1` meeting index `n2` at an angle of
/// incidence with cosine `cos_i` (clamped to 0…1). Past the critical angle both are 1.
pub fn fresnel(cos_i: f64, n1: f64, n2: f64) -> Reflectance {
    let ci = cos_i.clamp(0.0, 1.0);
    let sin_t_2 = (n1 / n2).powi(2) * (1.0 - ci * ci);
    if sin_t_2 >= 1.0 {
        return Reflectance { s: 1.0, p: 1.0 };
    }
    let ct = (1.0 - sin_t_2).sqrt();
    let s = (n1 * ci - n2 * ct) / (n1 * ci + n2 * ct);
    let p = (n1 * ct - n2 * ci) / (n1 * ct + n2 * ci);
    Reflectance { s: s * s, p: p * p }
}

/// Reflectance at normal incidence, ((n1 − n2)/(n1 + n2))²; 0.02037 for water.
pub fn r0(n1: f64, n2: f64) -> f64 {
    ((n1 - n2) / (n1 + n2)).powi(2)
}

/// [Schlick's](crate::bibliography::Schlick1994) approximation from the thinner side; within 0.04 of [`fresnel`] for water.
pub fn schlick(cos_i: f64, r0: f64) -> f64 {
    r0 + (1.0 - r0) * (1.0 - cos_i.clamp(0.0, 1.0)).powi(5)
}

/// Schlick's approximation from the denser side (index `n1` > `n2`): it takes the cosine of the *refracted* angle, and 1 past
/// the critical angle.
pub fn schlick_from_below(cos_i: f64, n1: f64, n2: f64) -> f64 {
    let ci = cos_i.clamp(0.0, 1.0);
    let sin_t_2 = (n1 / n2).powi(2) * (1.0 - ci * ci);
    if sin_t_2 >= 1.0 { 1.0 } else { schlick((1.0 - sin_t_2).sqrt(), r0(n1, n2)) }
}

/// The cosine of the angle in water for light that meets a level surface from air with cosine `cos_air`.
pub fn cos_in_water(cos_air: f64, index: f64) -> f64 {
    let c = cos_air.clamp(0.0, 1.0);
    (1.0 - (1.0 - c * c) / (index * index)).max(0.0).sqrt()
}

/// Opacity of water of a depth in metres: clamp(1 − exp(−ρ depth), 0, 1), ρ per metre.
pub fn water_alpha(rho_per_m: f64, depth_m: f64) -> f64 {
    (1.0 - (-rho_per_m * depth_m).exp()).clamp(0.0, 1.0)
}

/// Reflectance of deep water in red, green and blue, as seen from above straight down: the open ocean with 0.1 mg of chlorophyll per
/// cubic metre. Equals `OPEN_REFLECTANCE` in `shaders/lib/water_types.wgsl`, which tells its source.
pub const DEEP_REFLECTANCE: [f64; 3] = [0.0, 0.0043, 0.0265];

/// Opacity from which on nothing of the bed can be seen: less than 1/250 of its light comes through. Equals `OPAQUE_ALPHA` in
/// `shaders/lib/water.wgsl`.
pub const OPAQUE_ALPHA: f64 = 0.996;

/// Depth in metres from which water is as opaque as [`OPAQUE_ALPHA`], ρ per metre.
pub fn opaque_depth_m(rho_per_m: f64) -> f64 {
    -(1.0 - OPAQUE_ALPHA).ln() / rho_per_m
}

/// Mean square slopes of a wind-blown sea.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanSquareSlope {
    /// Along the wind.
    pub up: f64,
    /// Across the wind.
    pub cross: f64,
    /// Both together, by the source's own regression: not exactly the sum of the two.
    pub total: f64,
}

/// [Cox and Munk's](crate::bibliography::CoxMunk1954) clean-surface slopes at wind speed `speed_mps` (12.5 m above the sea);
/// measured from 1 to 14 m/s, beyond that extrapolated.
pub fn cox_munk_mss(speed_mps: f64) -> MeanSquareSlope {
    let w = speed_mps.max(0.0);
    MeanSquareSlope { up: 3.16e-3 * w, cross: 0.003 + 1.92e-3 * w, total: 0.003 + 5.12e-3 * w }
}

/// Cox and Munk's slopes under a slick of oil, which takes out the waves shorter than a hand: what the longer ones hold.
pub fn cox_munk_slick_mss(speed_mps: f64) -> MeanSquareSlope {
    let w = speed_mps.max(0.0);
    MeanSquareSlope { up: 0.005 + 0.78e-3 * w, cross: 0.003 + 0.84e-3 * w, total: 0.008 + 1.56e-3 * w }
}

/// Weights of near FFT waves and far Perlin waves at a distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MixWeights {
    /// Amplitude weight of the FFT waves.
    pub fft: f64,
    /// Amplitude weight of the Perlin waves.
    pub perlin: f64,
}

/// The mix by distance: w_perlin² = r²(3 − 2r), w_fft² = 1 − w_perlin², r from 0 at `d_min` to 1 at `d_max` (metres).
///
/// Hermite's cubic weighs the *squares*: the two are independent, so their variances add, and the sea keeps its height midway.
/// With `d_max` ≤ `d_min` the change is a step at `d_min`.
pub fn mix_weights(distance_m: f64, d_min: f64, d_max: f64) -> MixWeights {
    let r = if d_max > d_min { (distance_m - d_min) / (d_max - d_min) } else { f64::from(distance_m >= d_min) };
    let r = r.clamp(0.0, 1.0);
    let perlin_2 = r * r * (3.0 - 2.0 * r);
    MixWeights { fft: (1.0 - perlin_2).max(0.0).sqrt(), perlin: perlin_2.sqrt() }
}
