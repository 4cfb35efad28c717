//! Sums of waves written out from the textbook, for the tests of the model and of what is drawn.

use glam::{DVec2, DVec3};
use ocean_globe::model::modes::{Mode, frequency};
use ocean_globe::model::moved_water::Motion;

/// The motion that waves a cos(k·x − ωt + φ) make at patch coordinates `at`, m, and `t_s` seconds since 1970: written out from the textbook.
pub fn summed(modes: &[Mode], cascade: usize, at: DVec2, t_s: f64) -> Motion {
    let mut sum = Motion::default();
    for mode in modes.iter().filter(|mode| mode.cascade == cascade) {
        let (k, a) = (DVec2::from(mode.wave_vector), 2.0 * DVec2::from(mode.h0).length());
        let phase = k.dot(at) - frequency(mode) * t_s + mode.h0[1].atan2(mode.h0[0]);
        let (sin, cos) = phase.sin_cos();
        let along = k / k.length();
        sum += Motion {
            height: a * cos,
            shift: -a * sin * along,
            slope: -a * sin * k,
            stretch: -a * cos * DVec3::new(k.x * along.x, k.y * along.y, k.x * along.y),
        };
    }
    sum
}
