//! One spectrum from the longest waves to the ripples.

use super::{DirectionalSpectrum, K_SHORTEST};
use crate::model::{GRAVITY, quadrature::simpson_log, spreading};

/// Inverse wave ages for which the spectrum was made: fully grown to very young.
pub const WAVE_AGES: (f64, f64) = (0.84, 5.0);
/// The wave number at which gravity-capillary waves are slowest, rad/m, and their speed there, m/s, as the source rounds them.
const K_M: f64 = 370.0;
const C_M: f64 = 0.23;
/// u* = sqrt(C_D) U₁₀ with this drag coefficient.
const DRAG: f64 = 0.00144;

/// [Elfouhaily's](crate::bibliography::Elfouhaily1997) unified spectrum. With c = sqrt((g/k)(1 + (k/k_m)²)), k_p = Ω² g/U₁₀², c_p = U₁₀/Ω:
///
/// ∫F k dθ = S(k) = k⁻³ (½ α_p (c_p/c) F_p + ½ α_m (c_m/c) F_m) exp(−5/4 (k_p/k)²) γ^Γ
///
/// * α_p = 0.006 Ω^0.55 (as [Mobley](crate::bibliography::MobleyWebBook) writes it), F_p = exp(−(Ω/√10)(√(k/k_p) − 1)); α_m = 0.01 (1 + ln(u*/c_m)) below u* = c_m and 0.01 (1 + 3 ln(u*/c_m))
///   above, at least 0 (U₁₀ < 2.2 m/s), F_m = exp(−¼ (k/k_m − 1)²).
/// * γ = 1.7 + 6 log₁₀ Ω (1.7 for Ω ≤ 1), Γ = exp(−(√(k/k_p) − 1)²/(2σ²)), σ = 0.08 (1 + 4 Ω⁻³).
/// * Spread (1 + Δ cos 2θ)/2π, Δ = tanh(¼ ln 2 + 4 (c/c_p)^2.5 + 0.13 (u*/c_m)(c_m/c)^2.5). It tells only the sum of k and −k,
///   as a picture of the sea does; [`spreading::downwind_share`] of that sum travels with the wind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elfouhaily {
    /// Wind at 10 m, m/s.
    pub u10: f64,
    /// Inverse wave age Ω = U₁₀/c_p.
    pub wave_age: f64,
    peak: f64,
    c_p: f64,
    alpha_p: f64,
    alpha_m: f64,
    ln_gamma: f64,
    sigma: f64,
    a_m: f64,
}

impl Elfouhaily {
    /// The sea of a wind in m/s, positive, at an inverse wave age (clamped to [`WAVE_AGES`]).
    pub fn new(u10: f64, wave_age: f64) -> Self {
        let wave_age = wave_age.clamp(WAVE_AGES.0, WAVE_AGES.1);
        let friction = libm::sqrt(DRAG) * u10;
        let ln = libm::log(friction / C_M);
        let alpha_m = 0.01 * if friction < C_M { 1.0 + ln } else { 1.0 + 3.0 * ln };
        let gamma = if wave_age <= 1.0 { 1.7 } else { 1.7 + 6.0 * libm::log10(wave_age) };
        let peak = wave_age * wave_age * GRAVITY / (u10 * u10);
        Self {
            u10,
            wave_age,
            peak,
            c_p: u10 / wave_age,
            alpha_p: 0.006 * libm::pow(wave_age, 0.55),
            alpha_m: alpha_m.max(0.0),
            ln_gamma: libm::log(gamma),
            sigma: 0.08 * (1.0 + 4.0 / (wave_age * wave_age * wave_age)),
            a_m: 0.13 * friction / C_M,
        }
    }

    /// The sea of a wind in m/s whose peak is at the angular frequency `omega_p`, rad/s, both positive: Ω = U₁₀ ω_p/g within
    /// [`WAVE_AGES`]; where even the oldest sea is too young, it is the sea of a stronger wind, and the other way round.
    pub fn from_peak(u10: f64, omega_p: f64) -> Self {
        let c_p = GRAVITY / omega_p;
        let wave_age = (u10 / c_p).clamp(WAVE_AGES.0, WAVE_AGES.1);
        Self::new(wave_age * c_p, wave_age)
    }

    /// The sea of a wind in m/s whose significant height comes nearest to `hs_m`, m, both positive: by its wave age within
    /// [`WAVE_AGES`]; where even the oldest sea is too low, it is the sea of a stronger wind.
    pub fn from_height(u10: f64, hs_m: f64) -> Self {
        let oldest = |u10: f64| Self::new(u10, WAVE_AGES.0);
        // Both heights are monotone; 30 halvings leave 1e-8 of the range.
        let halve = |mut low: f64, mut high: f64, too_low: &dyn Fn(f64) -> bool| {
            for _ in 0..30 {
                let middle = 0.5 * (low + high);
                if too_low(middle) { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        };
        if oldest(u10).height() < hs_m {
            // Hs of the oldest sea is 0.026 U² within 3 %.
            let above = libm::sqrt(hs_m / 0.02).max(u10);
            return oldest(halve(u10, above, &|u| oldest(u).height() < hs_m));
        }
        Self::new(u10, halve(-WAVE_AGES.1, -WAVE_AGES.0, &|age| Self::new(u10, -age).height() < hs_m).abs())
    }

    /// Δ of the spread at a wave number: 1 is cos², 0 the same in all directions.
    pub fn spread(&self, k: f64) -> f64 {
        let power = |ratio: f64| ratio * ratio * libm::sqrt(ratio);
        let c = phase_speed(k);
        libm::tanh(0.25 * std::f64::consts::LN_2 + 4.0 * power(c / self.c_p) + self.a_m * power(C_M / c))
    }

    /// Significant height, m; waves beyond 1000 k_p hold 1e-6 of the variance.
    fn height(&self) -> f64 {
        let (k0, k1) = (0.05 * self.peak, (1e3 * self.peak).min(K_SHORTEST));
        4.0 * libm::sqrt(simpson_log(k0, k1, 128, |k| self.omnidirectional(k)))
    }
}

/// The source's phase speed, m/s.
fn phase_speed(k: f64) -> f64 {
    let r = k / K_M;
    libm::sqrt(GRAVITY / k * (1.0 + r * r))
}

impl DirectionalSpectrum for Elfouhaily {
    fn density(&self, kx: f64, ky: f64) -> f64 {
        let k = libm::sqrt(kx * kx + ky * ky);
        let s = self.omnidirectional(k);
        if s <= f64::MIN_POSITIVE {
            return 0.0;
        }
        let (cos, sin) = (kx / k, ky / k);
        let both = (1.0 + self.spread(k) * (cos * cos - sin * sin)) / std::f64::consts::TAU;
        s / k * both * 2.0 * spreading::downwind_share(cos)
    }

    fn peak_wavenumber(&self) -> f64 {
        self.peak
    }

    fn omnidirectional(&self, k: f64) -> f64 {
        if !(k > 0.0 && k.is_finite()) {
            return 0.0;
        }
        let ratio = self.peak / k;
        let root = libm::sqrt(k / self.peak) - 1.0;
        let off = root / self.sigma;
        let peak = self.ln_gamma * libm::exp(-0.5 * off * off) - 1.25 * ratio * ratio;
        let c = phase_speed(k);
        let long = self.alpha_p * self.c_p * libm::exp(peak - self.wave_age * root / SQRT_10);
        let short = k / K_M - 1.0;
        let short = self.alpha_m * C_M * libm::exp(peak - 0.25 * short * short);
        let s = 0.5 * (long + short) / (c * k * k * k);
        // Near k = 0 the exponential underflows while k⁻³ overflows.
        if s.is_finite() { s } else { 0.0 }
    }
}

/// √10.
const SQRT_10: f64 = 3.162_277_660_168_379_5;
