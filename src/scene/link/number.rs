//! Numbers in links: read with care, written short.

use std::ops::RangeInclusive;

/// Reads a finite number and clamps it into a range; `None` for anything else, NaN and infinity included.
pub fn clamped(text: &str, range: RangeInclusive<f64>) -> Option<f64> {
    finite(text).map(|number| number.clamp(*range.start(), *range.end()))
}

/// Reads a finite number.
pub fn finite(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

/// Reads a whole number and clamps it.
pub fn whole(text: &str, range: RangeInclusive<f64>) -> Option<f64> {
    clamped(text, range).filter(|_| finite(text).is_some_and(|number| number.fract() == 0.0))
}

/// Reads an angle in degrees and wraps it into `[0, 360)`.
pub fn wrapped_deg(text: &str) -> Option<f64> {
    finite(text).map(|angle| angle.rem_euclid(360.0)).map(|angle| if angle < 360.0 { angle } else { 0.0 })
}

/// Writes a number with at most so many decimals and no trailing zeros.
///
/// Negative decimals round to tens, hundreds, and so on.
pub fn decimal(number: f64, decimals: i32) -> String {
    let mut text = if decimals < 0 {
        let step = 10f64.powi(-decimals);
        format!("{:.0}", (number / step).round() * step)
    } else {
        format!("{:.*}", decimals as usize, number)
    };
    if text.contains('.') {
        text.truncate(text.trim_end_matches('0').trim_end_matches('.').len());
    }
    if text == "-0" { "0".into() } else { text }
}

/// Writes an angle in degrees so that it reads back inside `[low, low + 360)`, also where rounding reaches the end.
pub fn decimal_deg(angle_deg: f64, low: f64, decimals: i32) -> String {
    let text = decimal(angle_deg, decimals);
    if text.parse::<f64>().is_ok_and(|rounded| rounded >= low + 360.0) { decimal(low, 0) } else { text }
}
