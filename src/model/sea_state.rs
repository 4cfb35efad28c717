//! The wind and the sea it makes: Beaufort grades, wave height by wind speed, wind components.

use super::GRAVITY;

/// The wind speed from which each Beaufort grade counts, m/s: grade B begins at `LOWER_BOUNDS[B]`
/// ([WMO](crate::bibliography::WmoBeaufort); half-open, so that no speed falls between two grades).
pub const LOWER_BOUNDS: [f64; 13] = [0.0, 0.3, 1.6, 3.4, 5.5, 8.0, 10.8, 13.9, 17.2, 20.8, 24.5, 28.5, 32.7];

/// Upper bound of each grade as tables print it, m/s; hurricane force has none.
pub const UPPER_BOUNDS: [f64; 13] = [0.2, 1.5, 3.3, 5.4, 7.9, 10.7, 13.8, 17.1, 20.7, 24.4, 28.4, 32.6, f64::INFINITY];

/// Significant wave height of each grade, m, as the WMO's table gives it for the open sea.
pub const HEIGHTS: [f64; 13] = [0.0, 0.1, 0.2, 0.6, 1.0, 2.0, 3.0, 4.0, 5.5, 7.0, 9.0, 11.5, 14.0];

/// The WMO's names of the thirteen grades.
pub const NAMES: [&str; 13] = [
    "calm",
    "light air",
    "light breeze",
    "gentle breeze",
    "moderate breeze",
    "fresh breeze",
    "strong breeze",
    "near gale",
    "gale",
    "strong gale",
    "storm",
    "violent storm",
    "hurricane",
];

/// The Beaufort grade 0…12 of a wind speed in m/s; a speed that is negative or not a number counts as calm.
pub fn beaufort_from_speed(speed_mps: f64) -> usize {
    LOWER_BOUNDS.iter().rposition(|&bound| speed_mps >= bound).unwrap_or(0)
}

/// The wind speed that stands for a Beaufort number, m/s: v = 0.836 B^1.5. Grades in between are allowed; negative give 0.
pub fn speed_from_beaufort(grade: f64) -> f64 {
    let grade = grade.max(0.0);
    0.836 * grade * libm::sqrt(grade)
}

/// The name of a grade; above 12 it is still a hurricane.
pub fn name(grade: usize) -> &'static str {
    NAMES[grade.min(12)]
}

/// Significant height of a fully grown sea at a wind speed in m/s, m.
///
/// The table's height stands at v = 0.836 B^1.5; in between a monotone cubic
/// ([Fritsch and Butland](crate::bibliography::FritschButland1984)) in the speed, capped at 14 m. Calm is exactly 0.
pub fn significant_height(speed_mps: f64) -> f64 {
    if speed_mps.is_nan() || speed_mps <= 0.0 {
        return 0.0;
    }
    let speeds: [f64; 13] = std::array::from_fn(|grade| speed_from_beaufort(grade as f64));
    let Some(cell) = speeds.windows(2).position(|pair| speed_mps < pair[1]) else {
        return HEIGHTS[12];
    };
    let width = speeds[cell + 1] - speeds[cell];
    let u = (speed_mps - speeds[cell]) / width;
    let (left, right) = (knot_slope(&speeds, cell) * width, knot_slope(&speeds, cell + 1) * width);
    let (u2, u3) = (u * u, u * u * u);
    HEIGHTS[cell] * (2.0 * u3 - 3.0 * u2 + 1.0)
        + left * (u3 - 2.0 * u2 + u)
        + HEIGHTS[cell + 1] * (3.0 * u2 - 2.0 * u3)
        + right * (u3 - u2)
}

/// The slope at a knot: the harmonic mean of its neighbours' secants, weighted by their widths, which keeps the curve monotone.
fn knot_slope(speeds: &[f64; 13], knot: usize) -> f64 {
    let width = |i: usize| speeds[i + 1] - speeds[i];
    let secant = |i: usize| (HEIGHTS[i + 1] - HEIGHTS[i]) / width(i);
    match knot {
        0 => secant(0),
        12 => secant(11),
        _ => {
            let (h0, h1, d0, d1) = (width(knot - 1), width(knot), secant(knot - 1), secant(knot));
            let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
            (w0 + w1) / (w0 / d0 + w1 / d1)
        }
    }
}

/// u*, m/s, of a wind speed in m/s at 10 m over the sea: √C_D U₁₀ with [Wu's](crate::bibliography::Wu1982) drag coefficient
/// C_D = (0.8 + 0.065 U₁₀)·10⁻³, which in a storm grows no further than [Donelan's](crate::bibliography::Donelan2004) 2.5·10⁻³.
pub fn friction_velocity(speed_mps: f64) -> f64 {
    let speed = speed_mps.max(0.0);
    libm::sqrt((0.8e-3 + 0.065e-3 * speed).min(2.5e-3)) * speed
}

/// Period of the peak, s, of a sea as high as `hs_m`, m, under a wind speed in m/s at 10 m; 0 without one of them.
///
/// [Toba's 3/2-power law](crate::bibliography::Toba1972) between height and significant period, Hs = 0.062 (g u*)^½ T^(3/2): whatever its
/// age, a wind sea is as steep as its wind makes it. Its peak is at 1.05 T ([Goda](crate::bibliography::Goda2010), after Mitsuyasu).
pub fn peak_period(speed_mps: f64, hs_m: f64) -> f64 {
    let steep = 0.062 * libm::sqrt(GRAVITY * friction_velocity(speed_mps));
    if hs_m > 0.0 && steep > 0.0 { 1.05 * libm::pow(hs_m / steep, 2.0 / 3.0) } else { 0.0 }
}

/// Wind components (u to the east, v to the north), m/s, of a wind that blows FROM a bearing (radians clockwise from north).
pub fn wind_components(speed_mps: f64, from: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(from);
    (-speed_mps * sin, -speed_mps * cos)
}

/// Share of the surface under active whitecaps at a wind speed in m/s at 10 m, [`breaking_fraction`] capped at a quarter, where the fit leaves its
/// data.
pub fn whitecap_fraction(speed_mps: f64) -> f64 {
    breaking_fraction(speed_mps).min(0.25)
}

/// How much of the sea breaks, 3.84e-6 U^3.41 ([Monahan and O'Muircheartaigh](crate::bibliography::Monahan1980)): beyond a quarter not a share, but how
/// often water is struck white again.
pub fn breaking_fraction(speed_mps: f64) -> f64 {
    3.84e-6 * libm::pow(speed_mps.max(0.0), 3.41)
}
