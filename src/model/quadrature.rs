//! Numerical integration, for what has no closed form. Uses `libm`: its results feed the waves.

/// ∫ f dx over [a, b] by Simpson's rule with `intervals` (made even, at least 2) parts.
pub fn simpson(a: f64, b: f64, intervals: usize, mut f: impl FnMut(f64) -> f64) -> f64 {
    let n = (intervals.max(2) + 1) & !1;
    let h = (b - a) / n as f64;
    let inner: f64 = (1..n).map(|i| f(a + h * i as f64) * if i % 2 == 1 { 4.0 } else { 2.0 }).sum();
    (f(a) + inner + f(b)) * h / 3.0
}

/// ∫ f dk over [k0, k1], 0 < k0, with steps even in ln k: for spectra that span decades. 0 if the interval is empty.
pub fn simpson_log(k0: f64, k1: f64, intervals: usize, mut f: impl FnMut(f64) -> f64) -> f64 {
    if !(k0 > 0.0 && k1 > k0) {
        return 0.0;
    }
    simpson(libm::log(k0), libm::log(k1), intervals, |x| {
        let k = libm::exp(x);
        k * f(k)
    })
}
