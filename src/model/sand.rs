//! What beaches are made of: the grains that a profile of the bed stands for, and how steeply waves pile them up.

/// Height (m) and period (s) of the breakers of a usual climate.
const CLIMATE: [f64; 2] = [1.0, 8.0];
/// A of Dean's profile (m^⅓) and the size of its grains, mm ([Dean](crate::bibliography::Dean1991), from B. Moore's measurements).
const GRAINS: [[f64; 2]; 5] = [[0.063, 0.1], [0.1, 0.2], [0.125, 0.3], [0.145, 0.4], [0.161, 0.5]];

/// Size of the grains of a beach by its A, mm: between the rows of the table by their logarithms, beyond them as between the last two.
pub fn grain_mm(a: f64) -> f64 {
    let row = GRAINS[1..GRAINS.len() - 1].iter().filter(|row| row[0] < a).count();
    let ([a0, d0], [a1, d1]) = (GRAINS[row], GRAINS[row + 1]);
    d0 * libm::pow(d1 / d0, libm::log(a / a0) / libm::log(a1 / a0))
}

/// Slope of a beach of grains of so many mm where waves run up it: 0.12 (H/(√(gD) T))^-½, [Sunamura's](crate::bibliography::Sunamura1984), in the
/// usual climate.
pub fn sunamura(grain_mm: f64) -> f64 {
    let [height, period] = CLIMATE;
    0.12 / libm::sqrt(height / (libm::sqrt(super::GRAVITY * 1e-3 * grain_mm) * period))
}
