// The normal distribution.

// Distribution function of the normal distribution (M. Abramowitz and I. Stegun 1964, 7.1.26: within 1e-7).
fn normal_share(x: f32) -> f32 {
    let z = abs(x) * sqrt(0.5);
    let t = 1.0 / (1.0 + 0.3275911 * z);
    let tail = 0.5 * t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429)))) * exp(-z * z);
    return select(tail, 1.0 - tail, x >= 0.0);
}
