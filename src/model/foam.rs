//! How whitecaps come and go in time.

/// Foam after `dt_s` seconds, drawn from `foam` towards `equilibrium` with the given lifetime: F ← Fₑ + (F − Fₑ) e^{−dt/τ}. One
/// step of two seconds is two steps of one, so that it does not depend on the frame rate. A lifetime of 0 or less leaves Fₑ.
pub fn relaxed(foam: f64, equilibrium: f64, dt_s: f64, lifetime_s: f64) -> f64 {
    if lifetime_s <= 0.0 {
        return equilibrium;
    }
    equilibrium + (foam - equilibrium) * libm::exp(-dt_s.max(0.0) / lifetime_s)
}
